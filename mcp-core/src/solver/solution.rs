//! [`Solution`]: where a solve ended and what it cost.

use super::certificate::Certificate;
use super::options::Method;
use super::status::Status;
use std::fmt;

/// Where a solve ended.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Solution {
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
    /// The method that ran.
    pub method: Method,
    /// For [`Status::DomainError`]: what was not finite, and where.
    pub fault: Option<DomainFault>,
    /// Whether `F` or `J` was not finite at the start, which was then moved inside the bounds.
    pub start_was_moved: bool,
}

impl Solution {
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
    /// Evaluations of `F` and `J` by the certificate.
    pub certificate_evaluations: usize,
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
