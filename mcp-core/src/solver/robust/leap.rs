//! The crash again from where its full step leads, in the scales measured there.
//!
//! `J` at the start need not tell how large the variables of the solution are: from a start of zeros all
//! products are gone from it, and a step of the right size looks far too long in its scales.

use super::Search;
use super::starts::CRASH;
use crate::solver::monitor::Direction;
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::Continue;

impl Search<'_, '_> {
    /// Full min-map steps to points of other scales, and the crash there, at most `budget` times, then
    /// Josephy–Newton.
    pub(super) fn leap(&mut self, budget: usize) -> Flow<StageEnd> {
        let josephy = self.run.options.robust.josephy_first;
        self.memory.go_to_start();
        if !self.restart()? {
            return Continue(StageEnd::NotFinite);
        }
        let mut has_leapt = false;
        for _ in 0..budget {
            if !self.min_map_direction(1e-8)
                || self.evaluate(1.0).is_nan()
                || !self.accept(Direction::MinMap, 1.0)?
                || !self.has_drifted()
            {
                break;
            }
            has_leapt = true;
            self.measure_scales();
            if self.crash(CRASH)? != StageEnd::Drifted {
                break;
            }
        }
        let end = if has_leapt { self.josephy_first(josephy)? } else { StageEnd::NoStep };
        self.scale_as_at_start()?;
        Continue(end)
    }
}
