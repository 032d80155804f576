//! [`Monitor`]: watching a solve, and stopping it.

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
}

impl Direction {
    /// One letter for tables: `S`, `F`, `M`, `G`.
    pub fn letter(self) -> char {
        match self {
            Direction::Start => 'S',
            Direction::FischerBurmeister => 'F',
            Direction::MinMap => 'M',
            Direction::Gradient => 'G',
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
    /// `‖Φ(z)‖₂` (PATH's `residual`).
    pub fb_norm: f64,
    /// `max |mid(z−l, F, z−u)|` at the iterate, which may lie outside the box.
    pub natural_residual: f64,
    /// Step length; 0 for the start.
    pub step: f64,
    /// Where the step came from.
    pub direction: Direction,
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
/// Printing is up to the monitor; the solvers print nothing. `()` watches nothing; any
/// `FnMut(&Iteration) -> ControlFlow<()>` is a monitor.
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

impl<W: FnMut(&Iteration<'_>) -> ControlFlow<()>> Monitor for W {
    fn iteration(&mut self, iteration: &Iteration<'_>) -> ControlFlow<()> {
        self(iteration)
    }
}
