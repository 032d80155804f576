//! [`Diagnosis`]: what is behind a failure, by variable and equation.

use crate::model::Shape;
use std::fmt::Write as _;

/// What [`Method::Robust`](crate::Method::Robust) or [`Method::Lemke`](crate::Method::Lemke) found
/// at a point that is no solution. Variables and equations are indices;
/// [`describe`](Self::describe) gives their names.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Diagnosis {
    /// The merit function is not zero and does not fall: it is stationary here, or, where `gradient` is
    /// not small, steps on it stopped making progress.
    Stationary {
        /// Equations that hold least, the worst first.
        worst: Vec<usize>,
        /// `‖∇θ‖∞`, relative to the terms it is summed from.
        gradient: f64,
    },
    /// A limit was reached before anything else could be told.
    Unfinished {
        /// Equations that hold least at the best point, relative to their terms, the worst first.
        worst: Vec<usize>,
    },
    /// The Newton system is singular: these variables can move together without changing `F` to
    /// first order.
    Singular {
        /// Variables of the largest entries of the null vector, with the entries in the units of the
        /// model, largest first.
        null_vector: Vec<(usize, f64)>,
        /// Whether all entries have one sign and are proportional to the levels: such as prices that
        /// can all be multiplied by a number.
        is_homogeneous: bool,
    },
    /// Variables grow without bound.
    Diverged {
        /// The variables that grew most, and the direction in which they go.
        growing: Vec<(usize, f64)>,
    },
    /// Pivoting ended on a ray.
    Ray {
        /// Variables that can grow together, and the direction.
        direction: Vec<(usize, f64)>,
    },
}

impl Diagnosis {
    /// In words, with names from the shape of the problem.
    pub fn describe(&self, shape: &Shape) -> String {
        let mut text = String::new();
        let list = |entries: &[(usize, f64)]| {
            let mut list = String::new();
            for (k, &(j, value)) in entries.iter().enumerate() {
                let comma = if k == 0 { "" } else { ", " };
                let _ = write!(list, "{comma}`{}` {value:.3e}", shape.variable_name(j));
            }
            list
        };
        let names = |equations: &[usize]| {
            let names = equations.iter().map(|&i| format!("`{}`", shape.equation_name(i)));
            names.collect::<Vec<String>>().join(", ")
        };
        let _ = match self {
            Diagnosis::Unfinished { worst } => {
                write!(text, "furthest from holding: {}", names(worst))
            }
            Diagnosis::Stationary { worst, gradient } => {
                let names = names(worst);
                if *gradient <= STATIONARY {
                    write!(
                        text,
                        "no direction reduces the residual of {names} (relative gradient {gradient:.1e})"
                    )
                } else {
                    write!(text, "steps no longer reduce the residual of {names}")
                }
            }
            Diagnosis::Singular { null_vector, is_homogeneous } => {
                let hint = if *is_homogeneous {
                    "; they can all be multiplied by a number, as prices can: fix one"
                } else {
                    ""
                };
                write!(text, "moving together without effect: {}{hint}", list(null_vector))
            }
            Diagnosis::Diverged { growing } => write!(text, "growing: {}", list(growing)),
            Diagnosis::Ray { direction } => {
                write!(text, "can grow together: {}", list(direction))
            }
        };
        text
    }
}

/// Relative gradient of a stationary point.
pub(super) const STATIONARY: f64 = 1e-5;
/// Entries shown of a vector.
pub(super) const SHOWN: usize = 6;
/// Entries smaller than this, relative to the largest, are not shown.
const SMALL: f64 = 1e-3;

/// The largest entries of a vector with their places, largest first.
pub(super) fn largest_entries(vector: &[f64]) -> Vec<(usize, f64)> {
    let mut entries = entries_by_size(vector);
    entries.truncate(SHOWN);
    entries
}

/// All entries of a vector that are not small, with their places, largest first.
pub(super) fn entries_by_size(vector: &[f64]) -> Vec<(usize, f64)> {
    let largest = vector.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let mut entries: Vec<(usize, f64)> = vector
        .iter()
        .copied()
        .enumerate()
        .filter(|(_, v)| *v != 0.0 && v.abs() >= SMALL * largest)
        .collect();
    entries.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    entries
}
