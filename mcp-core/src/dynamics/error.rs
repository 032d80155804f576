//! [`DynamicsError`]: a system that cannot be simulated, or a step that was not solved.

use crate::error::ModelError;
use crate::linalg::LinearError;
use crate::solver::Status;

/// What is wrong with a system, or which step failed and why.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DynamicsError {
    /// A number of the system or the scheme is out of range.
    #[error("{what} is {value}, but {rule}")]
    OutOfRange {
        /// The number.
        what: String,
        /// Its value.
        value: f64,
        /// What it must be.
        rule: &'static str,
    },
    /// A list has the wrong length.
    #[error("{what} has {found} entries, expected {expected}")]
    Length {
        /// The list.
        what: String,
        /// Entries it should have.
        expected: usize,
        /// Entries it has.
        found: usize,
    },
    /// An effect acts on a coordinate that its body does not have.
    #[error("{what} needs the coordinate {coordinate}")]
    NoCoordinate {
        /// The effect, by its name.
        what: String,
        /// The missing coordinate, by its name.
        coordinate: String,
    },
    /// The circuit does not determine voltages and currents from its state.
    #[error("the circuit has no unique currents and voltages: {reason}")]
    Circuit {
        /// What is left undetermined, or contradictory.
        reason: String,
    },
    /// The complementarity problem of a step was not solved.
    #[error(
        "step {step} to t = {time} ({active}) is not solved: {status}, residual {residual:.1e}"
    )]
    NotSolved {
        /// The step, counted from 1.
        step: u64,
        /// The time at its end.
        time: f64,
        /// Names of its unknowns.
        active: String,
        /// How the last solve ended.
        status: Status,
        /// Natural residual of the last point.
        residual: f64,
    },
    /// A state became NaN or infinite.
    #[error("{name} is not finite at t = {time}")]
    NotFinite {
        /// The state variable.
        name: String,
        /// The time.
        time: f64,
    },
    /// The matrix of the free motion is singular.
    #[error("the matrix of the free motion: {0}")]
    Linear(#[from] LinearError),
    /// The step problem is not well formed: names used twice, crossed bounds.
    #[error(transparent)]
    Model(#[from] ModelError),
}

/// `value` if it satisfies the rule.
pub(super) fn check(
    what: impl FnOnce() -> String,
    value: f64,
    holds: bool,
    rule: &'static str,
) -> Result<f64, DynamicsError> {
    if holds { Ok(value) } else { Err(DynamicsError::OutOfRange { what: what(), value, rule }) }
}

/// A finite number above 0.
pub(super) fn positive(what: impl FnOnce() -> String, value: f64) -> Result<f64, DynamicsError> {
    check(what, value, value > 0.0 && value.is_finite(), "must be a positive number")
}

/// A finite number of at least 0.
pub(super) fn not_negative(
    what: impl FnOnce() -> String,
    value: f64,
) -> Result<f64, DynamicsError> {
    check(what, value, value >= 0.0 && value.is_finite(), "must be a number of at least 0")
}

/// A finite number.
pub(super) fn finite(what: impl FnOnce() -> String, value: f64) -> Result<f64, DynamicsError> {
    check(what, value, value.is_finite(), "must be finite")
}

/// A share: `0 <= value <= 1`.
pub(super) fn share(what: impl FnOnce() -> String, value: f64) -> Result<f64, DynamicsError> {
    check(what, value, (0.0..=1.0).contains(&value), "must lie between 0 and 1")
}
