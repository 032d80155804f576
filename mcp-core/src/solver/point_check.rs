//! Is a point a solution, and if not, which equation says so? For benchmarks and data whose
//! solution is known.

use super::certificate::{Certificate, Certifier, Verdict, middle};
use super::options::Options;
use crate::error::ModelError;
use crate::model::{BoundKind, Model, Shape};
use crate::problem::{AdProblem, Problem};
use std::cmp::Ordering;
use std::sync::Arc;

#[path = "point_check_text.rs"]
mod text;

/// What a point violates in one equation, or in the bounds of its variable.
///
/// | at | holds if | violated |
/// | --- | --- | --- |
/// | `z_i = l_i < u_i` | `F_i >= 0` | `NegativeAtLower` |
/// | `z_i = u_i > l_i` | `F_i <= 0` | `PositiveAtUpper` |
/// | `l_i < z_i < u_i` | `F_i = 0` | `NotZeroBetween`, `NotZeroFree` |
/// | `z_i = l_i = u_i` | always | |
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Violation {
    /// `F_i` or `z_i` is NaN or infinite.
    NotFinite,
    /// `z_i < l_i`, whatever `F_i` is.
    BelowLower,
    /// `z_i > u_i`, whatever `F_i` is.
    AboveUpper,
    /// `F_i < 0` at the lower bound.
    NegativeAtLower,
    /// `F_i > 0` at the upper bound.
    PositiveAtUpper,
    /// `F_i != 0` between two bounds, of which one may be infinite.
    NotZeroBetween,
    /// `F_i != 0` of a free variable.
    NotZeroFree,
}

impl Violation {
    /// What `z_i = z` and `F_i = f` violate. The point is judged as it is, without tolerance.
    fn of(z: f64, f: f64, (lower, upper): (f64, f64), kind: BoundKind) -> Option<Self> {
        if !z.is_finite() || !f.is_finite() {
            Some(Violation::NotFinite)
        } else if z < lower {
            Some(Violation::BelowLower)
        } else if z > upper {
            Some(Violation::AboveUpper)
        } else if kind == BoundKind::Fixed || f == 0.0 {
            None
        } else if kind == BoundKind::Free {
            Some(Violation::NotZeroFree)
        } else if z == lower {
            (f < 0.0).then_some(Violation::NegativeAtLower)
        } else if z == upper {
            (f > 0.0).then_some(Violation::PositiveAtUpper)
        } else {
            Some(Violation::NotZeroBetween)
        }
    }
}

/// One equation at a point. `Display` is a sentence.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PointRow {
    /// Name of the equation; `None` for a fixed variable without one.
    pub equation: Option<String>,
    /// Name of the variable it is paired with.
    pub variable: String,
    /// `F_i`; `None` without equation.
    pub f: Option<f64>,
    /// `z_i`.
    pub level: f64,
    /// `l_i`; `-inf` for none.
    pub lower: f64,
    /// `u_i`; `inf` for none.
    pub upper: f64,
    /// What is violated, by however little; `None` where the equation holds exactly.
    pub violation: Option<Violation>,
    /// `|z_i − mid(l_i, z_i − F_i, u_i)|`, in the units of the model; NaN if `F_i` is.
    pub residual: f64,
}

/// What [`check_point`] found. `Display` says whether the point is a solution, and otherwise which
/// ten equations violate what, the worst first.
#[derive(Clone, Debug, PartialEq)]
pub struct PointCheck {
    shape: Arc<Shape>,
    z: Vec<f64>,
    f: Vec<f64>,
    /// Variables and natural residuals, the worst first.
    order: Vec<(usize, f64)>,
    certificate: Certificate,
    /// Equation and variable of the first derivative that is not finite.
    singular: Option<(usize, usize)>,
}

/// Why a point is no solution.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WrongPoint {
    /// An equation or a bound is violated.
    #[error("the point is not a solution: {row}")]
    Violated {
        /// The worst equation: by residual, or by the relative residual where that alone is too
        /// large.
        row: Box<PointRow>,
    },
    /// A derivative is not finite, so nothing tells how well the equations hold.
    #[error(
        "the point is not a solution: its residual is {residual:.1e}, but the derivative of \
         `{equation}` by `{variable}` is not finite"
    )]
    NotDifferentiable {
        /// The largest natural residual.
        residual: f64,
        /// The equation.
        equation: String,
        /// The variable.
        variable: String,
    },
    /// A problem without variables is refused only by a tolerance that is no number >= 0.
    #[error("nothing is within the relative tolerance {tol_relative}")]
    Tolerances {
        /// The relative tolerance.
        tol_relative: f64,
    },
    /// The residual is small, but the point looks like a solution at infinity.
    #[error(
        "the residual of the point is {residual:.1e}, but it looks like a solution at infinity: \
         equation `{equation}` has lost all its derivatives or variable `{variable}` has run away"
    )]
    Asymptotic {
        /// The largest natural residual.
        residual: f64,
        /// The equation without derivatives, or the one paired with the variable.
        equation: String,
        /// The variable beyond all bounds, or the one paired with the equation.
        variable: String,
    },
}

/// Is this point, say the published solution of a benchmark, a solution of the model?
///
/// Evaluates `F` and `J` once. The point is judged as it is: outside the bounds it is not moved
/// into them.
///
/// As a test of a model, in one line:
///
/// ```
/// use mcp_core::{Real, Scalar, check_point, mcp_fn};
/// /// 2x − 4 ⟂ x >= 0 and 1 − y ⟂ y >= 0.
/// #[mcp_fn(lower = 0.0)]
/// fn lines<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
///     [2.0 * x - 4.0, 1.0 - y]
/// }
/// check_point(&Lines::new()?, &[2.0, 1.0])?.verdict()?;
///
/// let wrong = check_point(&Lines::new()?, &[0.0, 1.0])?;
/// assert_eq!(
///     wrong.verdict().unwrap_err().to_string(),
///     "the point is not a solution: `f[x]` ⟂ `x`: F = -4 is negative although `x` is at its lower \
///      bound 0 (residual 4)"
/// );
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`AdProblem::new`], and [`ModelError::Length`] if `z` does not have one entry for each
/// variable.
pub fn check_point<M: Model>(model: &M, z: &[f64]) -> Result<PointCheck, ModelError> {
    PointCheck::new(&mut AdProblem::new(model)?, z)
}

impl PointCheck {
    /// [`check_point`] for a problem, with its own bounds and parameters.
    ///
    /// # Errors
    /// [`ModelError::Length`] if `z` does not have one entry for each variable.
    pub fn new(problem: &mut dyn Problem, z: &[f64]) -> Result<Self, ModelError> {
        let expected = problem.shape().n();
        if z.len() != expected {
            return Err(ModelError::Length { what: "z".to_owned(), expected, found: z.len() });
        }
        let mut certifier = Certifier::default();
        certifier.resize(expected, problem.pattern().nnz());
        let certificate = certifier.judge(problem, z);
        let (shape, f) = (Arc::clone(problem.shape()), certifier.f().to_vec());
        let (lower, upper) = (shape.bounds().lower(), shape.bounds().upper());
        // |z − mid(l, z − F, u)| without the cancellation.
        let residual = |i: usize| middle(z[i] - lower[i], f[i], z[i] - upper[i]).abs();
        let mut order: Vec<(usize, f64)> = (0..expected).map(|i| (i, residual(i))).collect();
        let is_finite = |i: usize| z[i].is_finite() && f[i].is_finite();
        order.sort_by(|a, b| worst_first((is_finite(a.0), a.1), (is_finite(b.0), b.1)));
        let singular = problem.pattern().first_not_finite(certifier.jac());
        let singular = singular.map(|(_, i, j)| (i, j));
        Ok(PointCheck { shape, z: z.to_vec(), f, order, certificate, singular })
    }

    /// Every equation, the worst first: what is not finite, then by residual, then in the order of
    /// the variables. Names are made on demand.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = PointRow> + '_ {
        self.order.iter().map(|&(i, residual)| self.row(i, residual))
    }

    /// Equations that are violated, by however little.
    pub fn violated(&self) -> impl Iterator<Item = PointRow> + '_ {
        let violated = self.order.iter().filter(|(i, _)| self.violation(*i).is_some());
        violated.map(|&(i, residual)| self.row(i, residual))
    }

    /// The largest natural residual, in the units of the model; NaN if some `F_i` is.
    pub fn residual(&self) -> f64 {
        self.certificate.natural_residual
    }

    /// What the certificate found, for a verdict with other tolerances.
    pub fn certificate(&self) -> &Certificate {
        &self.certificate
    }

    /// Whether the certificate accepts the point by its relative residual, which does not depend
    /// on units, with the default tolerance of [`Options`].
    pub fn is_solution(&self) -> bool {
        self.default_fault().is_none()
    }

    /// The check if the point [is a solution](Self::is_solution).
    ///
    /// # Errors
    /// [`WrongPoint`] names the worst equation.
    pub fn verdict(self) -> Result<Self, WrongPoint> {
        self.verdict_within(None, Options::default().tol_relative)
    }

    /// The check if the point is a solution with these tolerances, as in
    /// [`Certificate::verdict`]: for benchmarks published with few digits.
    ///
    /// # Errors
    /// [`WrongPoint`] names the worst equation.
    pub fn verdict_within(self, tol: Option<f64>, tol_relative: f64) -> Result<Self, WrongPoint> {
        match self.fault(tol, tol_relative) {
            None => Ok(self),
            Some(fault) => Err(fault),
        }
    }

    fn default_fault(&self) -> Option<WrongPoint> {
        self.fault(None, Options::default().tol_relative)
    }

    /// Why the certificate does not accept the point, if so.
    fn fault(&self, tol: Option<f64>, tol_relative: f64) -> Option<WrongPoint> {
        match self.certificate.verdict(tol, tol_relative) {
            Verdict::Accepted => None,
            Verdict::Asymptotic => Some(self.asymptotic()),
            Verdict::Refused => Some(self.refused(tol, tol_relative)),
        }
    }

    fn violation(&self, i: usize) -> Option<Violation> {
        let bounds = self.shape.bounds();
        let limits = (bounds.lower()[i], bounds.upper()[i]);
        Violation::of(self.z[i], self.f[i], limits, bounds.kind(i))
    }

    fn row(&self, i: usize, residual: f64) -> PointRow {
        let (bounds, has_equation) = (self.shape.bounds(), self.shape.row_of_variable(i).is_some());
        PointRow {
            equation: has_equation.then(|| self.shape.equation_name(i)),
            variable: self.shape.variable_name(i),
            f: has_equation.then_some(self.f[i]),
            level: self.z[i],
            lower: bounds.lower()[i],
            upper: bounds.upper()[i],
            violation: self.violation(i),
            residual,
        }
    }

    fn asymptotic(&self) -> WrongPoint {
        let place = self.certificate.vanishing_row.or(self.certificate.runaway());
        let i = place.unwrap_or(self.certificate.worst);
        WrongPoint::Asymptotic {
            residual: self.residual(),
            equation: self.shape.equation_name(i),
            variable: self.shape.variable_name(i),
        }
    }

    /// Names what made the certificate refuse the point.
    fn refused(&self, tol: Option<f64>, tol_relative: f64) -> WrongPoint {
        let residual = self.residual();
        let is_large = tol.is_some_and(|tol| !(residual <= tol));
        let is_outside = |row: &PointRow| {
            matches!(row.violation, Some(Violation::BelowLower | Violation::AboveUpper))
        };
        let first = self.rows().next();
        let not_finite = |row: &PointRow| row.violation == Some(Violation::NotFinite);
        let row = if first.as_ref().is_some_and(not_finite) {
            first
        } else if let Some((equation, variable)) = self.singular {
            return WrongPoint::NotDifferentiable {
                residual,
                equation: self.shape.equation_name(equation),
                variable: self.shape.variable_name(variable),
            };
        } else if is_large {
            first
        } else if self.certificate.relative_residual <= tol_relative {
            self.rows().find(is_outside).or(first)
        } else {
            let worst = self.certificate.worst_relative;
            let found = self.order.iter().find(|(i, _)| *i == worst);
            found.map(|&(i, residual)| self.row(i, residual))
        };
        match row {
            Some(row) => WrongPoint::Violated { row: Box::new(row) },
            None => WrongPoint::Tolerances { tol_relative },
        }
    }
}

/// What is not finite first, then the largest residual.
fn worst_first(a: (bool, f64), b: (bool, f64)) -> Ordering {
    a.0.cmp(&b.0).then_with(|| b.1.total_cmp(&a.1))
}

#[cfg(test)]
#[path = "point_check_tests.rs"]
mod tests;
