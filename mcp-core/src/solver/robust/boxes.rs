//! Other starts: corners of the two-sided boxes.
//!
//! A problem with such boxes is often a game or a relay, whose merit has a local minimum between the
//! corners: Newton from the middle, the upper and the lower corner.

use super::Search;
use super::map::Map;
use super::starts::CRASH;
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::Continue;

impl Search<'_, '_> {
    /// Crash and Newton from the middle, the upper and the lower corner of the two-sided boxes.
    pub(super) fn boxes(&mut self, budget: usize) -> Flow<StageEnd> {
        let view = &self.memory.view;
        let is_box = |(l, u): (&f64, &f64)| l.is_finite() && u.is_finite() && l < u;
        if !view.lower.iter().zip(&view.upper).any(is_box) {
            return Continue(StageEnd::Skipped);
        }
        for share in [0.5, 1.0, 0.0] {
            let memory = &mut *self.memory;
            memory.go_to_start();
            for j in 0..memory.here.z.len() {
                let (l, u) = (memory.view.lower[j], memory.view.upper[j]);
                if l.is_finite() && u.is_finite() {
                    memory.here.z[j] = (1.0 - share) * l + share * u;
                }
            }
            if self.restart()? {
                self.crash(CRASH)?;
                self.newton_on(Map::FischerBurmeister, budget)?;
            }
        }
        Continue(StageEnd::Budget)
    }
}
