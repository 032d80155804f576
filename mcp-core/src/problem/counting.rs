//! [`Counting`]: a problem that counts its passes, independently of any solver's bookkeeping.

use super::{Derived, Pattern, Problem};
use crate::model::Shape;
use std::sync::Arc;

/// Passes over a problem. A pass that gives both `F` and `J` counts as a pass of `J`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Passes {
    /// Passes that computed `F` alone.
    pub residual: usize,
    /// Passes that computed `J`, with or without `F`.
    pub jacobian: usize,
}

/// The wrapped problem, with its passes counted.
#[derive(Debug)]
pub struct Counting<P> {
    problem: P,
    passes: Passes,
}

impl<P: Problem> Counting<P> {
    /// Wraps a problem, counters at zero.
    pub fn new(problem: P) -> Self {
        Counting { problem, passes: Passes::default() }
    }
    /// Passes since construction.
    pub fn passes(&self) -> Passes {
        self.passes
    }
}

impl<P: Problem> Problem for Counting<P> {
    fn shape(&self) -> &Arc<Shape> {
        self.problem.shape()
    }
    fn pattern(&self) -> &Pattern {
        self.problem.pattern()
    }
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        if jac.is_some() {
            self.passes.jacobian += 1;
        } else if f.is_some() {
            self.passes.residual += 1;
        }
        self.problem.evaluate(z, f, jac);
    }
    fn derived(&self, z: &[f64]) -> Derived {
        self.problem.derived(z)
    }
}
