//! [`History`]: what a picture of a solve needs to know of every iterate.

use mcp_core::ncp::{Branch, mid};
use mcp_core::{Iteration, Monitor, Stage};
use std::ops::ControlFlow;

/// One iterate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moment {
    /// Natural residual, in the units of the model.
    pub(crate) residual: f64,
    /// Step length; `None` at the start.
    pub(crate) step: Option<f64>,
    /// Stage of the method.
    pub(crate) stage: Stage,
    /// Variables whose branch of the min map, bound or equation, is another than at the iterate
    /// before; 0 at the start.
    pub(crate) changes: usize,
}

/// A [`Monitor`] that remembers every iterate.
#[derive(Clone, Debug, Default)]
pub(crate) struct History {
    moments: Vec<Moment>,
    branches: Vec<Branch>,
}

impl History {
    /// All iterates, the start first.
    pub(crate) fn moments(&self) -> &[Moment] {
        &self.moments
    }
}

impl Monitor for History {
    fn iteration(&mut self, iteration: &Iteration<'_>) -> ControlFlow<()> {
        let bounds = iteration.problem.shape().bounds();
        let point = iteration.z.iter().zip(iteration.f);
        let branch = |((&z, &f), (&l, &u)): ((&f64, &f64), (&f64, &f64))| mid(z, f, l, u).1;
        let box_ = bounds.lower().iter().zip(bounds.upper());
        let branches: Vec<Branch> = point.zip(box_).map(branch).collect();
        let changes = self.branches.iter().zip(&branches).filter(|(old, new)| old != new).count();
        self.branches = branches;
        self.moments.push(Moment {
            residual: iteration.natural_residual,
            step: (!self.moments.is_empty()).then_some(iteration.step),
            stage: iteration.stage,
            changes,
        });
        ControlFlow::Continue(())
    }
}
