//! Solving: methods, their options, and what comes out.
//!
//! | method | direction | merit | reference |
//! | --- | --- | --- | --- |
//! | [`Method::Robust`]: [page](robust), the default | projected Newton, linearised problem, Newton on `Φ`, and a cascade | natural map, `½‖Φ‖²` | see the page |
//! | [`Method::NewtonFb`]: [page](newton_fb) | Newton on `Φ` | `½‖Φ‖²` | [FP03](crate#references) VFBLSA, Siconos 700 |
//! | [`Method::NewtonMinFb`]: [page](newton_min_fb) | Newton on the min map | `½‖Φ‖²` | [FP03](crate#references) minFBLSA, Siconos 701 |
//! | [`Method::OldFb`]: [page](old_fb) | Newton on `Φ` | `½‖Φ‖²` | [KK98](crate#references) Alg. 4.1, Siconos 710 |
//! | [`Method::Lemke`]: [page](pivot), affine problems only | pivoting | none | [CPS92](crate#references) |
//!
//! `Robust` scales the problem by powers of two and does not depend on units of that kind. The
//! three between are the solvers of the Siconos page on mixed complementarity problems, with its
//! documented defaults, extended to free, lower, upper, boxed and fixed variables in any order.
//! None of the three is scale-free: multiplying an equation or changing a unit changes their
//! iterates.
//!
//! # Deliberate deviations from Siconos
//!
//! - A point is a solution if the independent [`Certificate`] says so; a criterion only ends the
//!   loop, and if the certificate refuses, the iteration goes on.
//! - NaN or infinite values are never accepted; at the start they are
//!   [`Status::DomainError`], or variables at a bound are moved inside once.
//! - A start that is a solution costs no iteration.
//! - `φ` is evaluated without cancellation; the kink element uses `J ζ`, not `Jᵀ ζ`.
//! - A singular system falls back to the gradient in all three methods.
//! - The slope of the line search always belongs to the direction taken.
//! - A failed line search ends the solve; so do 100 iterations without progress
//!   ([`Options::stall`]).
//! - A step must reduce the merit: one whose decrease rounding swallows is not accepted.
//! - The first step of a search is 1 ([`Armijo::first_step`](crate::Armijo)), as in the books, not
//!   2, and the full step is not evaluated twice.
//! - At a kink `OldFb` takes the same element as the others, not `(1, 1)`.
//! - Non-monotone reference values are fed by every accepted step, never below the current merit.
//! - The returned point lies inside the bounds, exactly.

#[cfg(feature = "rayon")]
mod batch;
mod certificate;
mod diagnosis;
mod monitor;
pub mod newton_fb;
pub mod newton_min_fb;
mod newton_system;
pub mod old_fb;
mod options;
pub mod pivot;
mod point_check;
pub mod robust;
mod run;
mod sequence;
mod solution;
mod stage;
mod status;
mod workspace;

#[cfg(feature = "rayon")]
pub use batch::{batch, solve_batch};
pub(crate) use certificate::Certifier;
pub use certificate::{Certificate, Verdict, examine};
pub use diagnosis::Diagnosis;
pub use monitor::{Direction, Iteration, Monitor};
pub use options::{Criterion, Descent, Method, Options, UnknownMethod};
pub use point_check::{PointCheck, PointRow, Violation, WrongPoint, check_point};
pub use robust::Robust;
pub use sequence::{solve_sequence, solve_sequence_with};
pub use solution::{DomainFault, Fill, NotSolved, Solution, Stats};
pub use stage::{Stage, StageEnd, StageRecord};
pub use status::Status;

use crate::error::ModelError;
use crate::linalg::LinearSolver;
use crate::model::Model;
use crate::problem::{AdProblem, Problem};
use run::Run;
use std::ops::ControlFlow;
use workspace::{Workspace, resize};

/// Solves a model from its own start.
///
/// # Errors
/// [`ModelError`] for input that is wrong before iteration 0. Not converging is a
/// [`Status`] in the solution.
#[inline]
pub fn solve<M: Model>(model: &M, options: &Options) -> Result<Solution, ModelError> {
    solve_problem(&mut AdProblem::new(model)?, None, options)
}

/// Solves a model from `start`, moved into the bounds.
///
/// # Errors
/// As [`solve`], and [`ModelError::Length`] or [`ModelError::StartNotFinite`] for the start.
#[inline]
pub fn solve_from<M: Model>(
    model: &M,
    start: &[f64],
    options: &Options,
) -> Result<Solution, ModelError> {
    solve_problem(&mut AdProblem::new(model)?, Some(start), options)
}

/// Not generic: compiled here, not with every model.
fn solve_problem(
    problem: &mut dyn Problem,
    start: Option<&[f64]>,
    options: &Options,
) -> Result<Solution, ModelError> {
    let mut solver = Solver::new(options.clone())?;
    solver.run(problem, start, None)?;
    Ok(solver.solution)
}

/// A solver for many solves: it keeps its workspace, so that a second solve of the same pattern
/// allocates nothing and repeats no symbolic work.
///
/// ```
/// use mcp_core::{AdProblem, Method, Options, Solver};
/// # use mcp_core::{Equation, Model, Parameter, Reader, Real, Scalar, Shape, Variable};
/// # struct Demand(Shape);
/// # impl Model for Demand {
/// #     fn shape(&self) -> &Shape { &self.0 }
/// #     fn row<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
/// #         read.var(0) - read.param(0)
/// #     }
/// # }
/// # let shape = Shape::builder().variable(Variable::new("x").lower(0.0))
/// #     .equation(Equation::new("f").complements("x")).parameter(Parameter::new("a", 1.0)).build()?;
/// let mut problem = AdProblem::new(Demand(shape))?; // x − a ⟂ x >= 0
/// let mut solver = Solver::new(Options::new(Method::NewtonFb))?;
/// for a in [1.0, 2.0, 3.0] {
///     problem.set_parameter("a", &[a])?;
///     assert!((solver.solve(&mut problem)?.z[0] - a).abs() < 1e-9);
/// }
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
pub struct Solver {
    options: Options,
    workspace: Option<Workspace>,
    custom: Option<Box<dyn LinearSolver>>,
    solution: Solution,
}

impl Solver {
    /// A solver with these options.
    ///
    /// # Errors
    /// [`ModelError::Option`] names an option out of range.
    pub fn new(options: Options) -> Result<Self, ModelError> {
        options.validate()?;
        let solution = Solution { method: options.method, ..Solution::nothing() };
        Ok(Solver { options, workspace: None, custom: None, solution })
    }

    /// A solver that uses the caller's linear solver instead of [`Options::linear`] for Newton
    /// systems; damped steps and pivoting, whose matrices have other patterns, keep the option.
    ///
    /// # Errors
    /// As [`Solver::new`].
    pub fn with_linear_solver(
        options: Options,
        linear: Box<dyn LinearSolver>,
    ) -> Result<Self, ModelError> {
        let mut solver = Self::new(options)?;
        solver.custom = Some(linear);
        Ok(solver)
    }

    /// The options.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// Solves from the problem's own start.
    ///
    /// # Errors
    /// [`ModelError::Linear`] if the linear solver cannot take the problem.
    pub fn solve(&mut self, problem: &mut dyn Problem) -> Result<&Solution, ModelError> {
        self.run(problem, None, None)
    }

    /// Solves from `start`, moved into the bounds.
    ///
    /// # Errors
    /// As [`Solver::solve`], and [`ModelError::Length`] or [`ModelError::StartNotFinite`].
    pub fn solve_from(
        &mut self,
        problem: &mut dyn Problem,
        start: &[f64],
    ) -> Result<&Solution, ModelError> {
        self.run(problem, Some(start), None)
    }

    /// Solves from `start` or, with `None`, from the problem's own, showing every iterate to a
    /// monitor.
    ///
    /// # Errors
    /// As [`Solver::solve_from`].
    pub fn solve_monitored(
        &mut self,
        problem: &mut dyn Problem,
        start: Option<&[f64]>,
        monitor: &mut dyn Monitor,
    ) -> Result<&Solution, ModelError> {
        self.run(problem, start, Some(monitor))
    }

    fn run(
        &mut self,
        problem: &mut dyn Problem,
        start: Option<&[f64]>,
        monitor: Option<&mut dyn Monitor>,
    ) -> Result<&Solution, ModelError> {
        let work = self.prepare(problem, start)?;
        Ok(self.go(problem, work, monitor))
    }

    /// The workspace, with the first iterate.
    fn prepare(
        &mut self,
        problem: &dyn Problem,
        start: Option<&[f64]>,
    ) -> Result<Workspace, ModelError> {
        if let Some(start) = start {
            problem.shape().check_start(start)?;
        }
        let mut work = match self.workspace.take() {
            Some(workspace) if workspace.fits(problem.pattern()) => workspace,
            other => {
                if let Some(linear) = other.and_then(Workspace::into_custom) {
                    self.custom = Some(linear);
                }
                Workspace::new(problem.pattern(), &self.options, &mut self.custom)?
            }
        };
        work.set_bounds(problem.shape());
        work.system.begin();
        work.reference.reset();
        work.current.z.copy_from_slice(start.unwrap_or(problem.shape().start()));
        problem.shape().bounds().project(&mut work.current.z);
        Ok(work)
    }

    /// Solves from the iterate in `work`.
    fn go(
        &mut self,
        problem: &mut dyn Problem,
        mut work: Workspace,
        monitor: Option<&mut dyn Monitor>,
    ) -> &Solution {
        let monitor = monitor.map(|monitor| monitor as &mut dyn Monitor);
        let mut run = Run::new(problem, &self.options, &mut work, monitor);
        let ControlFlow::Break(status) = match self.options.method {
            Method::NewtonFb => newton_fb::solve(&mut run),
            Method::NewtonMinFb => newton_min_fb::solve(&mut run),
            Method::OldFb => old_fb::solve(&mut run),
            Method::Robust => robust::solve(&mut run),
            Method::Lemke => pivot::solve(&mut run),
        };
        finish(&mut run, status, &mut self.solution);
        self.workspace = Some(work);
        &self.solution
    }
}

/// Exchanges lists of the same length; one that has another becomes zeros first.
fn exchange(to: &mut Vec<f64>, from: &mut Vec<f64>) {
    resize(to, from.len());
    std::mem::swap(to, from);
}

/// The certificate has the last word: it judges every end that it has not judged yet.
fn finish(run: &mut Run<'_>, status: Status, solution: &mut Solution) {
    let certificate = run.certificate.unwrap_or_else(|| run.certify());
    solution.status = match certificate.verdict(run.options.tol, run.options.tol_relative) {
        // Robust has looked further, and Lemke not at a problem that is not affine.
        Verdict::Accepted
            if run.options.method != Method::Robust && status != Status::NotAffine =>
        {
            Status::Solved
        }
        _ => status,
    };
    solution.certificate = certificate;
    solution.shape.clone_from(run.problem.shape());
    // Both are written before they are read again.
    exchange(&mut solution.z, &mut run.work.answer);
    exchange(&mut solution.f, run.work.certifier.f_mut());
    solution.stats = run.stats;
    solution.fill = run.work.system.fill();
    solution.method = run.options.method;
    let fault = run.fault.filter(|_| solution.status == Status::DomainError);
    solution.fault = fault.map(|fault| DomainFault {
        equation: fault.equation,
        variable: fault.variable,
        value: fault.value,
        z: run.work.fault_point.clone(),
    });
    solution.start_was_moved = run.start_was_moved;
    solution.stages.clear();
    if let Some(memory) = &run.work.robust {
        solution.stages.extend_from_slice(&memory.records);
    }
    let diagnosis = run.work.diagnosis.take();
    solution.diagnosis = diagnosis.filter(|_| solution.status != Status::Solved);
}
