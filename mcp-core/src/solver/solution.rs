//! [`Solution`]: where a solve ended and what it cost.

use super::certificate::Certificate;
use super::diagnosis::Diagnosis;
use super::options::Method;
use super::stage::StageRecord;
use super::status::Status;
use crate::error::ModelError;
use crate::model::Shape;
use std::fmt;
use std::sync::Arc;

/// Where a solve ended.
///
/// ```
/// use mcp_core::{Options, Real, Scalar, mcp_fn, solve};
/// /// 2x − 4 ⟂ x >= 0 and 1 ⟂ y >= 0.
/// #[mcp_fn(lower = 0.0)]
/// fn lines<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
///     [2.0 * x - 4.0, 1.0 + 0.0 * y]
/// }
/// let solution = solve(&Lines::new()?, &Options::default())?;
/// assert!((solution.level("x")? - 2.0).abs() < 1e-9);
/// assert_eq!(solution.marginal("y")?, 1.0);
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub struct Solution {
    /// Names, bounds, start and parameters the solve had, shared with its problem.
    pub shape: Arc<Shape>,
    /// The point, inside the bounds; `n` numbers.
    pub z: Vec<f64>,
    /// `F(z)`, computed by the certificate; `f[i]` belongs to the equation paired with `z[i]`.
    pub f: Vec<f64>,
    /// How the solve ended.
    pub status: Status,
    /// What the independent judge found at `z`.
    pub certificate: Certificate,
    /// What it cost.
    pub stats: Stats,
    /// How much the Newton matrices fill when they are factored.
    pub fill: Fill,
    /// The method that ran.
    pub method: Method,
    /// For [`Status::DomainError`]: what was not finite, and where.
    pub fault: Option<DomainFault>,
    /// Whether `F` or `J` was not finite at the start, which was then moved inside the bounds.
    pub start_was_moved: bool,
    /// The stages [`Method::Robust`](crate::Method::Robust) went through, the last one that which
    /// ended it; empty for other methods.
    pub stages: Vec<StageRecord>,
    /// For failures of [`Method::Robust`](crate::Method::Robust) and
    /// [`Method::Lemke`](crate::Method::Lemke): what was found at the point.
    pub diagnosis: Option<Diagnosis>,
}

impl Solution {
    /// Before anything was solved.
    pub(crate) fn nothing() -> Self {
        Solution {
            shape: Arc::default(),
            z: Vec::new(),
            f: Vec::new(),
            status: Status::IterationLimit,
            certificate: Certificate::nothing(),
            stats: Stats::default(),
            fill: Fill::default(),
            method: Method::default(),
            fault: None,
            start_was_moved: false,
            stages: Vec::new(),
            diagnosis: None,
        }
    }

    /// Level of the variable with this name, such as `x[seattle, topeka]`.
    ///
    /// # Errors
    /// As [`Shape::variable_index`]: a name that nothing has is answered with the nearest one.
    pub fn level(&self, name: &str) -> Result<f64, ModelError> {
        self.value(&self.z, "levels", self.shape.variable_index(name)?)
    }

    /// Marginal of the variable with this name: `F` of the equation paired with it.
    ///
    /// # Errors
    /// As [`Shape::variable_index`], and [`ModelError::NoEquation`] for a fixed variable without
    /// equation.
    pub fn marginal(&self, name: &str) -> Result<f64, ModelError> {
        let i = self.shape.variable_index(name)?;
        if self.shape.row_of_variable(i).is_none() {
            return Err(ModelError::NoEquation { variable: self.shape.variable_name(i) });
        }
        self.value(&self.f, "values of F", i)
    }

    /// Number `i` of a list that may have been cut short.
    fn value(&self, list: &[f64], what: &str, i: usize) -> Result<f64, ModelError> {
        list.get(i).copied().ok_or_else(|| ModelError::Length {
            what: format!("{what} of the solution"),
            expected: self.shape.n(),
            found: list.len(),
        })
    }

    /// Whether the certificate accepts the point.
    pub fn is_solved(&self) -> bool {
        self.status == Status::Solved
    }

    /// The solution if it is one, everything about the failure otherwise.
    ///
    /// # Errors
    /// [`NotSolved`] carries the whole result.
    pub fn solved(self) -> Result<Self, NotSolved> {
        if self.is_solved() { Ok(self) } else { Err(NotSolved { solution: Box::new(self) }) }
    }
}

/// Without the shape, which has many lines and no news.
impl fmt::Debug for Solution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Solution")
            .field("z", &self.z)
            .field("f", &self.f)
            .field("status", &self.status)
            .field("certificate", &self.certificate)
            .field("stats", &self.stats)
            .field("fill", &self.fill)
            .field("method", &self.method)
            .field("fault", &self.fault)
            .field("start_was_moved", &self.start_was_moved)
            .field("stages", &self.stages)
            .field("diagnosis", &self.diagnosis)
            .finish_non_exhaustive()
    }
}

/// A solve that did not end in a solution.
///
/// Its `Debug` is its `Display`, because that is what `main` prints of an error it returns.
#[derive(Clone, PartialEq, thiserror::Error)]
#[error(
    "{} (iterations: {}, natural residual: {:.1e})",
    .solution.status,
    .solution.stats.iterations,
    .solution.certificate.natural_residual
)]
pub struct NotSolved {
    /// Where it ended.
    pub solution: Box<Solution>,
}

impl fmt::Debug for NotSolved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// What a solve cost, in counts. The certificate's own passes are counted apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Stats {
    /// Iterations: accepted steps.
    pub iterations: usize,
    /// Evaluations of `F` alone: the start and every trial point.
    pub residual_evaluations: usize,
    /// Evaluations of `J`: one at every point a step was taken from.
    pub jacobian_evaluations: usize,
    /// Factorisations tried.
    pub factorisations: usize,
    /// Steps along the negative gradient of the merit.
    pub gradient_steps: usize,
    /// Points judged by the certificate: one evaluation of `F` and `J` each, seldom a second `F` and two
    /// more `J`.
    pub certificate_evaluations: usize,
}

/// Entries of a Newton matrix and of its factors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Fill {
    /// Entries of the matrix: those of `J` and its diagonal.
    pub matrix: usize,
    /// Entries of the factors of the last matrix; `None` where nothing was factored and where the linear
    /// solver does not tell ([`LinearSolver::fill`](crate::LinearSolver::fill)).
    pub factors: Option<usize>,
}

/// A non-finite value of `F` or `J` that stopped a solve.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DomainFault {
    /// The equation, by the variable it is paired with.
    pub equation: usize,
    /// For an entry of `J`: the variable of the derivative.
    pub variable: Option<usize>,
    /// The value: NaN or infinite.
    pub value: f64,
    /// The point.
    pub z: Vec<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Equation, Set, Variable};

    fn transport() -> Solution {
        let plants = Set::new("plants", ["seattle", "san-diego"]).unwrap();
        let shape = Shape::builder()
            .variable(Variable::new("money").fixed(1.0))
            .variable(Variable::new("x").over(&[&plants]).lower(0.0))
            .equation(Equation::new("profit").over(&[&plants]).complements("x"))
            .build()
            .unwrap();
        Solution {
            shape: Arc::new(shape),
            z: vec![1.0, 50.0, 0.0],
            f: vec![0.0, 0.0, 0.25],
            ..Solution::nothing()
        }
    }

    #[test]
    fn levels_and_marginals_are_read_by_name() {
        let solution = transport();
        assert_eq!(solution.level("money"), Ok(1.0));
        assert_eq!(solution.level("x[seattle]"), Ok(50.0));
        assert_eq!(solution.marginal("x[san-diego]"), Ok(0.25));
    }

    #[test]
    fn names_that_nothing_has_are_answered() {
        let solution = transport();
        let level = |name| solution.level(name).unwrap_err().to_string();
        assert_eq!(level("mony"), "there is no variable `mony`; did you mean `money`?");
        assert_eq!(level("x[seatle]"), "there is no label `seatle`; did you mean `seattle`?");
        assert_eq!(
            solution.marginal("money").unwrap_err().to_string(),
            "variable `money` is fixed and has no equation, so it has no marginal"
        );
    }

    #[test]
    fn a_list_that_was_cut_short_is_named() {
        let mut solution = transport();
        solution.f.pop();
        assert_eq!(
            solution.marginal("x[san-diego]").unwrap_err().to_string(),
            "the length of `values of F of the solution` is 2, expected 3"
        );
    }
}
