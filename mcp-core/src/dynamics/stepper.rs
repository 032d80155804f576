//! [`TimeStepper`]: what all schemes have in common.

use super::error::DynamicsError;
use super::step_problem::StepProblem;

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
    /// Of mechanics the contacts that took part; of a linear system the pairs whose multiplier is
    /// strictly between its bounds, so that `y = 0`: diodes that conduct, relays that slide, equations.
    pub active: usize,
    /// Iterations of the solver.
    pub iterations: usize,
    /// Natural residual by the certificate.
    pub residual: f64,
}

/// Size of the complementarity problem of a step, and what the whole step costs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct StepSize {
    /// Unknowns.
    pub unknowns: usize,
    /// Structural nonzeros of the Jacobian.
    pub nonzeros: usize,
    /// Operations of the step: free motion, gaps, rows, the numbers of its problem, one `F` and one `J`
    /// of it, and the state after it. What the solver does between evaluations is not counted.
    pub operations: u64,
    /// Of these, one `F` of the problem.
    pub operations_of_f: u64,
}

impl StepSize {
    /// By the operations outside the problem, if there is one.
    pub(super) fn of(
        operations: u64,
        problem: Option<&StepProblem>,
    ) -> Result<Self, DynamicsError> {
        Ok(match problem {
            None => StepSize { operations, ..StepSize::default() },
            Some(problem) => StepSize {
                unknowns: problem.lambda.len(),
                nonzeros: problem.nonzeros(),
                operations: operations + problem.operations()?,
                operations_of_f: problem.operations_of_f(),
            },
        })
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

    /// Size of the problem of the last step, and operations of that step.
    ///
    /// # Errors
    /// None in practice: those of [`jacobian_operations`](crate::AdProblem::jacobian_operations).
    fn size(&self) -> Result<StepSize, DynamicsError>;
}
