//! [`AccuracyError`]: why a study of accuracy has no answer.

use crate::error::ModelError;
use crate::linalg::LinearError;

/// Why a study of accuracy has no answer.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AccuracyError {
    /// The model or an option is not well formed.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A margin of a manufactured solution is negative or not finite.
    #[error("the margin of `{variable}` is {margin}, but must be at least 0 and finite")]
    Margin {
        /// The variable.
        variable: String,
        /// The margin.
        margin: f64,
    },
    /// The model is not defined at the chosen solution.
    #[error("`{equation}` is not finite at the chosen solution")]
    NotFinite {
        /// The equation.
        equation: String,
    },
    /// Newton's method in double-double did not converge.
    #[error("refinement has not settled: its last step is {step:.1e} relative to the variables")]
    NotSettled {
        /// The last step.
        step: f64,
    },
    /// The refined point violates a bound or a sign.
    #[error(
        "the refined point is no solution: `{variable}` and its equation violate {violation:.1e}"
    )]
    NoSolution {
        /// The variable.
        variable: String,
        /// By how much, relative to the terms of the equation.
        violation: f64,
    },
    /// A case has no Jacobian written by hand.
    #[error("`{case}` has no Jacobian written by hand")]
    NotByHand {
        /// The case.
        case: String,
    },
    /// No solution is known of a case.
    #[error("no solution of `{case}` is known")]
    NoReference {
        /// The case.
        case: String,
    },
    /// A figure could not be drawn.
    #[error("the figure cannot be drawn: {reason}")]
    Drawing {
        /// What the drawing library says.
        reason: String,
    },
}

impl From<LinearError> for AccuracyError {
    fn from(error: LinearError) -> Self {
        AccuracyError::Model(error.into())
    }
}
