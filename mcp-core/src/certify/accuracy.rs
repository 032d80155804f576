//! [`Accuracy`]: what [`certify`](fn@crate::certify) found.

use crate::scalar::Interval;
use std::fmt;

/// How accurate a solution is, with a proof where there is one.
///
/// Its text is the verdict and a line of numbers; that of [`proof`](Self::proof) is the verdict alone:
/// `a unique solution lies within 3.1e-14 (relative) of the point`, or `not proved: …`.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Accuracy {
    /// The verdict.
    pub proof: Proof,
    /// The box that holds exactly one solution, one interval for each variable, in the units of the
    /// model; empty unless proved.
    pub enclosure: Vec<Interval>,
    /// The pair nearest to being degenerate; `None` without bounds.
    pub weakest: Option<Weakest>,
    /// Condition number in the 1-norm of the Jacobian of the pairs off their bounds, between relative
    /// quantities `z/w` and `F/s`; at least 1, infinite if singular.
    pub condition: f64,
    /// Length of the Newton step on the active system from the point, `max_j |Δz_j| / w_j`, rounding
    /// errors of `F` included. An estimate of the error where there is no proof.
    pub newton_step: f64,
}

/// The pair that decides the margin of strict complementarity.
#[derive(Clone, Debug, PartialEq)]
pub struct Weakest {
    /// Its variable.
    pub variable: String,
    /// How clearly it is on one side: the relative distance `|z − bound| / w` of a variable off its
    /// bounds, the relative `|F| / s` of one at a bound. 0 is degenerate.
    pub margin: f64,
}

/// Whether a solution was proved to be near.
#[derive(Clone, Debug, PartialEq)]
pub enum Proof {
    /// A box that reaches no further than `radius · w_j` from `z_j` holds exactly one solution;
    /// `w_j = |z_j| + τ_j` as in [`Certificate`](crate::Certificate).
    Proved {
        /// Relative, rounded upwards.
        radius: f64,
    },
    /// Not proved. There may be a solution all the same.
    Refused(Refusal),
}

/// Why nothing was proved.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Refusal {
    /// More pairs off their bounds than a proof is tried for: its cost grows with their cube.
    TooLarge {
        /// Their number.
        off: usize,
        /// The largest number that is tried.
        limit: usize,
    },
    /// `F` or a derivative is not finite at the point.
    NotFinite {
        /// The equation.
        equation: String,
    },
    /// A function that is known at points only.
    External {
        /// The first equation that calls one.
        equation: String,
    },
    /// `F` is not defined, or not bounded, in all of the box.
    NotDefined {
        /// The equation.
        equation: String,
    },
    /// `F` jumps or has an infinite slope in the box.
    NoSlope {
        /// The equation.
        equation: String,
        /// The variable.
        variable: String,
    },
    /// The Jacobian of the pairs off their bounds is singular, to working precision.
    Singular {
        /// Variables that can move together while the equations hold, to first order; empty if the
        /// Jacobian overflows.
        movable: Vec<String>,
    },
    /// Pairs that may be on either side.
    Degenerate {
        /// Their variables.
        pairs: Vec<String>,
        /// What determinants say about the solution, if it is one.
        regularity: Degeneracy,
    },
    /// Boxes up to this radius are not mapped into themselves.
    NoContraction {
        /// The largest relative radius that was tried.
        radius: f64,
        /// The factor by which the operator of Krawczyk shrinks relative distances there, apart from
        /// the Newton step; below 1, the point is too far from a solution.
        contraction: f64,
    },
}

/// Regularity at a degenerate point, in ordinary arithmetic.
#[derive(Clone, Debug, PartialEq)]
pub enum Degeneracy {
    /// The determinants of all choices of active pairs have one sign: strongly regular.
    Regular,
    /// This choice has another sign, or none.
    Irregular {
        /// The degenerate pairs that are off their bounds in it.
        pairs: Vec<String>,
    },
    /// The pairs that are not degenerate have a singular Jacobian.
    Singular,
    /// More than ten degenerate pairs: not looked at.
    TooMany,
}

impl Accuracy {
    /// A refusal before anything was computed.
    pub(super) fn unknown(refusal: Refusal) -> Self {
        Accuracy {
            proof: Proof::Refused(refusal),
            enclosure: Vec::new(),
            weakest: None,
            condition: f64::NAN,
            newton_step: f64::NAN,
        }
    }

    /// Whether a solution was proved to be near.
    pub fn is_proved(&self) -> bool {
        matches!(self.proof, Proof::Proved { .. })
    }
}

impl fmt::Display for Accuracy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.proof)?;
        if let Some(Weakest { variable, margin }) = &self.weakest {
            write!(f, "strict complementarity {margin:.1e} at {variable}; ")?;
        }
        write!(f, "condition {:.1e}, Newton step {:.1e}", self.condition, self.newton_step)
    }
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Proof::Proved { radius } => {
                let radius = upwards(*radius);
                write!(f, "a unique solution lies within {radius} (relative) of the point")
            }
            Proof::Refused(refusal) => write!(f, "not proved: {refusal}"),
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::TooLarge { off, limit } => {
                write!(f, "{off} variables are off their bounds, and at most {limit} are tried")
            }
            Refusal::NotFinite { equation } => {
                write!(f, "{equation} or its derivatives are not finite at the point")
            }
            Refusal::External { equation } => {
                write!(f, "{equation} calls an external function, which is known at points only")
            }
            Refusal::NotDefined { equation } => {
                write!(f, "{equation} is not defined everywhere near the point")
            }
            Refusal::NoSlope { equation, variable } => {
                write!(f, "{equation} jumps or has an infinite slope by {variable} near the point")
            }
            Refusal::Singular { movable } if movable.is_empty() => {
                f.write_str("the active equations are singular")
            }
            Refusal::Singular { movable } => write!(
                f,
                "the active equations are singular: {} can move while they hold",
                list(movable)
            ),
            Refusal::Degenerate { pairs, regularity } => {
                let one = pairs.len() == 1;
                let verb = if one { "is" } else { "are" };
                write!(
                    f,
                    "{} {verb} degenerate, at a bound with F near 0; {regularity}",
                    list(pairs)
                )
            }
            Refusal::NoContraction { radius, contraction } if *contraction < 1.0 => {
                write!(
                    f,
                    "too far from a solution: no box up to {radius:.1e} (relative) is mapped into itself"
                )
            }
            Refusal::NoContraction { radius, .. } => write!(
                f,
                "the derivatives change too much within {radius:.1e} (relative) of the point"
            ),
        }
    }
}

impl fmt::Display for Degeneracy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Degeneracy::Regular => {
                f.write_str("all choices of sides have determinants of one sign: strongly regular")
            }
            Degeneracy::Irregular { pairs } => {
                write!(f, "not strongly regular, with {} off the bound", list(pairs))
            }
            Degeneracy::Singular => f.write_str("the other active equations are singular"),
            Degeneracy::TooMany => f.write_str("too many for a look at all choices of sides"),
        }
    }
}

/// At most five names.
fn list(names: &[String]) -> String {
    let shown = names[..names.len().min(5)].join(", ");
    match names.len() {
        0..=5 => shown,
        more => format!("{shown} and {} more", more - 5),
    }
}

/// Two digits, not below `x`.
fn upwards(x: f64) -> String {
    let text = format!("{x:.1e}");
    match text.parse::<f64>() {
        Ok(shown) if shown < x => {
            format!("{:.1e}", x + 0.05 * 10_f64.powf(x.log10().floor()))
        }
        _ => text,
    }
}
