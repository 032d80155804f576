//! [`ActiveSets`]: the problems of the sets of contacts seen so far.

use super::error::DynamicsError;
use super::step_problem::StepProblem;

/// Sets that are remembered; beads in a column go back and forth between a few dozen.
const MOST_SETS: usize = 64;

/// One problem, with its pattern, symbolic work and memory, for each set of contacts; the oldest is
/// given up for a new one when there are 64.
#[derive(Default)]
pub(super) struct ActiveSets {
    sets: Vec<(Vec<usize>, Box<StepProblem>)>,
    current: usize,
    /// Which is the oldest.
    oldest: usize,
}

impl ActiveSets {
    /// Makes this set the current one and gives its problem; `build` makes that of a new set.
    pub(super) fn select(
        &mut self,
        active: &[usize],
        build: impl FnOnce() -> Result<StepProblem, DynamicsError>,
    ) -> Result<&mut StepProblem, DynamicsError> {
        let is_current = self.sets.get(self.current).is_some_and(|(set, _)| set == active);
        if !is_current {
            let found = self.sets.iter().position(|(set, _)| set == active);
            self.current = match found {
                Some(found) => found,
                None => self.insert((active.to_vec(), Box::new(build()?))),
            };
        }
        Ok(&mut self.sets[self.current].1)
    }

    /// Adds a set and returns its number.
    fn insert(&mut self, entry: (Vec<usize>, Box<StepProblem>)) -> usize {
        if self.sets.len() < MOST_SETS {
            self.sets.push(entry);
            return self.sets.len() - 1;
        }
        let place = self.oldest;
        self.sets[place] = entry;
        self.oldest = (place + 1) % MOST_SETS;
        place
    }

    /// The problem of the current set; `None` before the first.
    pub(super) fn current(&self) -> Option<&StepProblem> {
        self.sets.get(self.current).map(|(_, problem)| &**problem)
    }
}
