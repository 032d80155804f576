//! [`TimeStepper`]: what all schemes have in common.

use super::error::DynamicsError;
use crate::scalar::OperationCounts;

/// What a step did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StepReport {
    /// Steps so far, this one included.
    pub step: u64,
    /// Time at the end of the step, `step · h`.
    pub time: f64,
    /// Unknowns of its complementarity problem; 0: there was none to solve.
    pub unknowns: usize,
    /// Contacts (of mechanics) or pairs that took part.
    pub active: usize,
    /// Iterations of the solver.
    pub iterations: usize,
    /// Natural residual by the certificate.
    pub residual: f64,
}

/// Size of the complementarity problem of a step, and what its functions cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct StepSize {
    /// Unknowns.
    pub unknowns: usize,
    /// Structural nonzeros of the Jacobian.
    pub nonzeros: usize,
    /// Operations of the free motion and of one `F`.
    pub operations: u64,
}

impl StepSize {
    pub(super) fn new(
        unknowns: usize,
        nonzeros: usize,
        counts: impl IntoIterator<Item = OperationCounts>,
    ) -> Self {
        let operations = counts.into_iter().map(|counts| counts.total()).sum();
        StepSize { unknowns, nonzeros, operations }
    }
}

/// A system on its way through time, step by step.
pub trait TimeStepper {
    /// One step of size `h`.
    ///
    /// # Errors
    /// [`DynamicsError::NotSolved`] with time and names if its complementarity problem was not
    /// solved, [`DynamicsError::NotFinite`]; the state is then that of the step before.
    fn step(&mut self) -> Result<StepReport, DynamicsError>;

    /// Step size `h`.
    fn step_size(&self) -> f64;

    /// Names of the numbers of [`write_state`](Self::write_state).
    fn state_names(&self) -> Vec<String>;

    /// Puts the state, and the multipliers `λ` of the last step behind it, into `state`.
    fn write_state(&self, state: &mut Vec<f64>);

    /// The state as a new list.
    fn state(&self) -> Vec<f64> {
        let mut state = Vec::new();
        self.write_state(&mut state);
        state
    }

    /// Stored energy, if the system has one.
    fn energy(&self) -> Option<f64>;

    /// Size of the problem of the last step.
    fn size(&self) -> StepSize;
}
