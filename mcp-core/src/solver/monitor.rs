//! [`Monitor`]: watching a solve, and stopping it.

use super::stage::Stage;
use crate::problem::Problem;
use std::ops::ControlFlow;

/// Where the step of an iteration came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum Direction {
    /// The start: no step yet.
    Start,
    /// Newton direction of the Fischer–Burmeister equations.
    FischerBurmeister,
    /// Newton direction of the min map.
    MinMap,
    /// Negative gradient of the merit.
    Gradient,
    /// Levenberg–Marquardt direction.
    LevenbergMarquardt,
    /// Solution of the linearised problem.
    Pivoting,
}

impl Direction {
    /// One letter for tables: `S`, `F`, `M`, `G`, `L`, `P`.
    pub fn letter(self) -> char {
        match self {
            Direction::Start => 'S',
            Direction::FischerBurmeister => 'F',
            Direction::MinMap => 'M',
            Direction::Gradient => 'G',
            Direction::LevenbergMarquardt => 'L',
            Direction::Pivoting => 'P',
        }
    }
}

/// Facts about one iterate, for a [`Monitor`].
#[non_exhaustive]
pub struct Iteration<'a> {
    /// Number of the iterate; 0 is the start.
    pub k: usize,
    /// Evaluations of `F` alone so far.
    pub residual_evaluations: usize,
    /// Evaluations of `J` so far.
    pub jacobian_evaluations: usize,
    /// `‖Φ(z)‖₂` (PATH's `residual`); for [`Method::Robust`](crate::Method::Robust) in its scaled
    /// variables, of the equations of the stage.
    pub fb_norm: f64,
    /// `max |mid(z−l, F, z−u)|` at the iterate, which may lie outside the box.
    pub natural_residual: f64,
    /// Step length; 0 for the start.
    pub step: f64,
    /// Where the step came from.
    pub direction: Direction,
    /// The stage the iterate belongs to.
    pub stage: Stage,
    /// Variables on the bound branch of the min map.
    pub active: usize,
    /// Variable of the largest natural residual; its equation is the worst one.
    pub worst: usize,
    /// The iterate.
    pub z: &'a [f64],
    /// `F` there.
    pub f: &'a [f64],
    /// The problem, for names.
    pub problem: &'a dyn Problem,
}

/// Watches a solve, one call for each iterate, the start included.
///
/// Printing is up to the monitor; the solvers print nothing. `()` watches nothing; a closure over
/// an [`Iteration`] is a monitor, and so is a pair of monitors: both are shown every iterate.
///
/// ```
/// use mcp_core::{AdProblem, Iteration, Options, Real, Scalar, Solver, Status, mcp_fn};
/// use std::ops::ControlFlow;
/// #[mcp_fn(start = 3.0)]
/// fn root<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
///     [x.exp() - 2.0]
/// }
/// let mut stop = |iteration: &Iteration<'_>| match iteration.k {
///     0..2 => ControlFlow::Continue(()),
///     _ => ControlFlow::Break(()),
/// };
/// let mut problem = AdProblem::new(Root::new()?)?;
/// let mut solver = Solver::new(Options::default())?;
/// let solution = solver.solve_monitored(&mut problem, None, &mut stop)?;
/// assert_eq!((solution.status, solution.stats.iterations), (Status::Interrupted, 2));
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
pub trait Monitor {
    /// Takes note of an iterate; `Break` ends the solve as
    /// [`Interrupted`](crate::Status::Interrupted).
    fn iteration(&mut self, iteration: &Iteration<'_>) -> ControlFlow<()>;
}

impl Monitor for () {
    #[inline]
    fn iteration(&mut self, _: &Iteration<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

impl<A: Monitor, B: Monitor> Monitor for (A, B) {
    /// The solve goes on if both let it.
    fn iteration(&mut self, iteration: &Iteration<'_>) -> ControlFlow<()> {
        let (first, second) = (self.0.iteration(iteration), self.1.iteration(iteration));
        if first.is_break() { first } else { second }
    }
}

impl<W: FnMut(&Iteration<'_>) -> ControlFlow<()>> Monitor for W {
    fn iteration(&mut self, iteration: &Iteration<'_>) -> ControlFlow<()> {
        self(iteration)
    }
}
