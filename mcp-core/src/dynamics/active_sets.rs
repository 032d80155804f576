//! [`ActiveSets`]: the problems of the sets of contacts seen so far.

use super::error::DynamicsError;
use super::step_problem::{StepProblem, Unknown};
use crate::solver::Options;

/// Sets that are remembered; beads in a column go back and forth between a few dozen.
const MOST_SETS: usize = 64;

/// One problem, with its pattern, symbolic work and memory, for each set of contacts; the oldest is
/// given up for a new one when there are 64.
pub(super) struct ActiveSets {
    options: Options,
    sets: Vec<(Vec<usize>, Option<Box<StepProblem>>)>,
    current: usize,
    /// Which is the oldest.
    oldest: usize,
}

impl ActiveSets {
    pub(super) fn new(options: Options) -> Self {
        ActiveSets { options, sets: Vec::new(), current: 0, oldest: 0 }
    }

    /// Makes the set the current one; false if it is not known.
    pub(super) fn select(&mut self, active: &[usize]) -> bool {
        let is_current = self.sets.get(self.current).is_some_and(|(set, _)| set == active);
        if is_current {
            return true;
        }
        let found = self.sets.iter().position(|(set, _)| set == active);
        self.current = found.unwrap_or(self.current);
        found.is_some()
    }

    /// Adds a set and makes it the current one.
    pub(super) fn insert(
        &mut self,
        active: &[usize],
        unknowns: &[Unknown],
        columns: &[Vec<usize>],
    ) -> Result<(), DynamicsError> {
        let problem = StepProblem::new(unknowns, columns, &self.options)?;
        let entry = (active.to_vec(), Some(Box::new(problem)));
        if self.sets.len() < MOST_SETS {
            self.current = self.sets.len();
            self.sets.push(entry);
        } else {
            self.current = self.oldest;
            self.sets[self.oldest] = entry;
            self.oldest = (self.oldest + 1) % MOST_SETS;
        }
        Ok(())
    }

    /// The current problem, for work; [`put_back`](Self::put_back) returns it.
    pub(super) fn take(&mut self) -> Option<Box<StepProblem>> {
        self.sets.get_mut(self.current)?.1.take()
    }

    /// Returns what [`take`](Self::take) gave.
    pub(super) fn put_back(&mut self, problem: Box<StepProblem>) {
        self.sets[self.current].1 = Some(problem);
    }

    /// The current problem.
    pub(super) fn current(&self) -> Option<&StepProblem> {
        self.sets.get(self.current)?.1.as_deref()
    }
}
