//! [`Report`]: a solution by name.

use super::{ReportRow, State, Statistics};
use crate::error::ModelError;
use crate::model::{BoundKind, Shape};
use crate::ncp::mid;
use crate::problem::{Derived, Problem};
use crate::solver::{Certificate, Solution, Status};
use std::sync::Arc;

#[cfg(feature = "serde")]
use super::export::{number, reads};

/// How a solve ended, by name: status and advice, residuals, costs, [`Statistics`], solution table.
///
/// `Display` and [`write_text`](Self::write_text) give text, `write_csv` all rows and `write_json`
/// everything (feature `serde`), and [`write_matrix`](Self::write_matrix) one family with row and
/// column labels.
///
/// ```
/// use mcp_core::{AdProblem, Options, Report, Solver};
/// # use mcp_core::{Equation, Model, Reader, Real, Scalar, Shape, Variable};
/// # struct Line(Shape);
/// # impl Model for Line {
/// #     fn shape(&self) -> &Shape { &self.0 }
/// #     fn row<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
/// #         2.0 * read.var(0) - 4.0
/// #     }
/// # }
/// # let shape = Shape::builder().variable(Variable::new("x").lower(0.0))
/// #     .equation(Equation::new("f").complements("x")).build()?;
/// let mut problem = AdProblem::new(Line(shape))?; // 2x − 4 ⟂ x >= 0
/// let solution = Solver::new(Options::default())?.solve(&mut problem)?.clone();
/// let report = Report::new(&mut problem, &solution)?.named("line");
/// assert!((report.row(0).level - 2.0).abs() < 1e-9);
/// assert!(report.to_string().contains("status             solved: "));
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Report {
    pub(super) name: String,
    pub(super) shape: Arc<Shape>,
    pub(super) solution: Solution,
    pub(super) statistics: Statistics,
    pub(super) derived: Derived,
    pub(super) fault: Option<Fault>,
}

/// What was not finite when a solve ended in [`Status::DomainError`], by name.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Fault {
    /// The equation.
    pub equation: String,
    /// For a derivative: the variable it is by.
    pub derivative_by: Option<String>,
    /// The value of `F` or of the derivative: NaN or infinite.
    #[cfg_attr(feature = "serde", serde(serialize_with = "number"))]
    pub value: f64,
    /// The variables the equation reads, directly or through definitions, and their values at the
    /// point; the one of the derivative first.
    #[cfg_attr(feature = "serde", serde(serialize_with = "reads"))]
    pub reads: Vec<(String, f64)>,
}

impl Report {
    /// A report on a solution of this problem. Evaluates `F` and `J` at the point, once or twice,
    /// for the [`Statistics`]; parameters and bounds should be those of the solve.
    ///
    /// # Errors
    /// [`ModelError::Length`], [`ModelError::OtherModel`] if the solution is one of another problem.
    pub fn new(problem: &mut dyn Problem, solution: &Solution) -> Result<Self, ModelError> {
        problem.shape().check_solution(solution)?;
        let statistics = Statistics::at(problem, &solution.z);
        Ok(Report {
            name: String::new(),
            shape: Arc::clone(problem.shape()),
            solution: solution.clone(),
            statistics,
            derived: problem.derived(&solution.z),
            fault: Fault::of(problem, solution),
        })
    }

    /// Gives the model a name for the headline.
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = name.into();
        self
    }

    /// The solution reported on.
    pub fn solution(&self) -> &Solution {
        &self.solution
    }

    /// Definitions and reports at the point, in the order of declaration.
    pub fn derived_values(&self) -> &Derived {
        &self.derived
    }

    /// How far the point is from a solution, by six measures.
    pub fn statistics(&self) -> &Statistics {
        &self.statistics
    }

    /// What was not finite, for [`Status::DomainError`].
    pub fn fault(&self) -> Option<&Fault> {
        self.fault.as_ref()
    }

    /// Number of rows of the solution table: of variables.
    pub fn row_count(&self) -> usize {
        self.shape.n()
    }

    /// Row `i` of the solution table: variable number `i`.
    ///
    /// # Panics
    /// If there is no variable `i`.
    pub fn row(&self, i: usize) -> ReportRow {
        let bounds = self.shape.bounds();
        // Adding zero turns −0 into 0.
        let (lower, upper) = (bounds.lower()[i] + 0.0, bounds.upper()[i] + 0.0);
        let marginal = self.marginal(i);
        let has_rent = matches!(bounds.kind(i), BoundKind::Upper | BoundKind::Boxed);
        let state = self.state(i);
        let rent = marginal.filter(|_| has_rent).map(|f| match state {
            State::AtUpper if f < 0.0 => -f,
            _ => 0.0,
        });
        ReportRow {
            variable: self.shape.variable_name(i),
            lower,
            level: self.solution.z[i] + 0.0,
            upper,
            marginal,
            rent,
            state,
            unit: self.shape.variable_family(i).unit().to_owned(),
            equation: self.shape.row_of_variable(i).map(|_| self.shape.equation_name(i)),
        }
    }

    /// Level of the variable with this name, such as `x[seattle, topeka]`.
    ///
    /// # Errors
    /// As [`Shape::variable_index`](crate::Shape::variable_index).
    pub fn level(&self, name: &str) -> Result<f64, ModelError> {
        Ok(self.solution.z[self.shape.variable_index(name)?])
    }

    /// All rows of the solution table, in the order of the variables.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = ReportRow> + '_ {
        (0..self.row_count()).map(|i| self.row(i))
    }

    /// `F_i`, if variable `i` has an equation.
    pub(super) fn marginal(&self, i: usize) -> Option<f64> {
        self.shape.row_of_variable(i).map(|_| self.solution.f[i] + 0.0)
    }

    pub(super) fn state(&self, i: usize) -> State {
        State::new(self.shape.bounds(), i, self.solution.z[i], self.solution.f[i])
    }

    /// Whether a long table leaves this row out: at its lower bound, fixed, or zero and not at its
    /// upper bound.
    pub(super) fn is_default(&self, i: usize) -> bool {
        match self.state(i) {
            State::AtLower | State::Fixed => true,
            State::AtUpper | State::Outside => false,
            State::Interior | State::Free => self.solution.z[i] == 0.0,
        }
    }

    /// The equations farthest from holding, at most `count`: variable and natural residual, the
    /// largest first.
    pub(super) fn worst(&self, count: usize) -> Vec<(usize, f64)> {
        let (bounds, solution) = (self.shape.bounds(), &self.solution);
        let residual = |i: usize| {
            mid(solution.z[i], solution.f[i], bounds.lower()[i], bounds.upper()[i]).0.abs()
        };
        let mut worst: Vec<(usize, f64)> =
            (0..self.row_count()).map(|i| (i, residual(i))).collect();
        worst.retain(|(_, residual)| *residual != 0.0);
        // NaN counts as the largest; ties in the order of the variables.
        worst.sort_by(|a, b| b.1.total_cmp(&a.1));
        worst.truncate(count);
        worst
    }

    pub(super) fn certificate(&self) -> &Certificate {
        &self.solution.certificate
    }

    /// Name of the equation of the largest residual; `None` where all residuals are zero.
    pub(super) fn worst_equation(&self, residual: f64, i: usize) -> Option<String> {
        let has_worst = residual != 0.0 && i < self.row_count();
        has_worst.then(|| self.shape.equation_name(i))
    }
}

impl Fault {
    fn of(problem: &dyn Problem, solution: &Solution) -> Option<Self> {
        let fault = solution.fault.as_ref().filter(|_| solution.status == Status::DomainError)?;
        let (shape, pattern) = (problem.shape(), problem.pattern());
        let row = fault.equation;
        let mut read: Vec<usize> =
            (0..shape.n()).filter(|&j| pattern.position(row, j).is_some()).collect();
        read.sort_by_key(|&j| fault.variable != Some(j));
        let value = |j: usize| fault.z.get(j).copied().unwrap_or(f64::NAN) + 0.0;
        Some(Fault {
            equation: shape.equation_name(row),
            derivative_by: fault.variable.map(|j| shape.variable_name(j)),
            value: fault.value,
            reads: read.into_iter().map(|j| (shape.variable_name(j), value(j))).collect(),
        })
    }
}
