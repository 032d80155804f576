//! [`DynamicsError`]: a system that cannot be simulated, or a step that was not solved.

use crate::error::ModelError;
use crate::linalg::LinearError;
use crate::solver::Status;

/// What is wrong with a system, or which step failed and why.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DynamicsError {
    /// A number of the system or the scheme is out of range.
    #[error("the {quantity} of {of} is {value}, but {rule}")]
    OutOfRange {
        /// What the number is: `mass`, `restitution`, …
        quantity: &'static str,
        /// Of what, by its name.
        of: String,
        /// Its value.
        value: f64,
        /// What it must be.
        rule: &'static str,
    },
    /// A list has the wrong length.
    #[error("the {quantity} of {of} has {found} entries, expected {expected}")]
    Length {
        /// What the list is: `start`, `input`, …
        quantity: &'static str,
        /// Of what, by its name.
        of: String,
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
    /// The bodies of a contact or a joint have no coordinate by which they could move in the direction
    /// it acts in: a multiplier without effect.
    #[error("{what} acts along its {direction}, where its bodies cannot move")]
    NoMotion {
        /// The contact or joint, by its name.
        what: String,
        /// `normal` or `tangent`.
        direction: &'static str,
    },
    /// A contact, a joint, a spring or a damper between a body and itself.
    #[error("{what} is between {body} and itself")]
    SameBody {
        /// The effect, by its name.
        what: String,
        /// The body.
        body: String,
    },
    /// Two states, multipliers or elements have the same name; a contact with friction has the two
    /// multipliers `name` and `name friction`.
    #[error("the name `{name}` is used twice")]
    NameTwice {
        /// The name.
        name: String,
    },
    /// The circuit does not determine voltages and currents from its state.
    #[error("the circuit has no unique currents and voltages: {reason}")]
    Circuit {
        /// An element that shows it, if there is one.
        element: Option<String>,
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
    /// The step problem is not well formed.
    #[error(transparent)]
    Model(#[from] ModelError),
}

/// `value` if it satisfies the rule.
pub(super) fn check(
    quantity: &'static str,
    of: &str,
    value: f64,
    holds: bool,
    rule: &'static str,
) -> Result<f64, DynamicsError> {
    let refused = || DynamicsError::OutOfRange { quantity, of: of.to_owned(), value, rule };
    if holds { Ok(value) } else { Err(refused()) }
}

/// A finite number above 0.
pub(super) fn positive(quantity: &'static str, of: &str, value: f64) -> Result<f64, DynamicsError> {
    check(quantity, of, value, value > 0.0 && value.is_finite(), "must be a positive number")
}

/// A finite number of at least 0.
pub(super) fn not_negative(
    quantity: &'static str,
    of: &str,
    value: f64,
) -> Result<f64, DynamicsError> {
    let holds = value >= 0.0 && value.is_finite();
    check(quantity, of, value, holds, "must be a number of at least 0")
}

/// A finite number.
pub(super) fn finite(quantity: &'static str, of: &str, value: f64) -> Result<f64, DynamicsError> {
    check(quantity, of, value, value.is_finite(), "must be finite")
}

/// A share: `0 <= value <= 1`.
pub(super) fn share(quantity: &'static str, of: &str, value: f64) -> Result<f64, DynamicsError> {
    check(quantity, of, value, (0.0..=1.0).contains(&value), "must lie between 0 and 1")
}

/// `name` is not among those there are.
pub(super) fn unused<'a>(
    name: &str,
    used: impl IntoIterator<Item = &'a str>,
) -> Result<(), DynamicsError> {
    let is_used = used.into_iter().any(|other| other == name);
    if is_used { Err(DynamicsError::NameTwice { name: name.to_owned() }) } else { Ok(()) }
}
