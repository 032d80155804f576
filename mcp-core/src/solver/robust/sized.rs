//! Scales by typical sizes, those of the start ([DS96](crate#references) section 7.1).

use super::map::Map;
use super::starts::CRASH;
use super::{Search, Sizes};
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::Continue;

impl Search<'_, '_> {
    /// Crash and Newton in scales that the sizes of the variables at the start decide as much as `J`
    /// does.
    pub(super) fn sized(&mut self, budget: usize) -> Flow<StageEnd> {
        if !self.run.options.robust.equilibrate {
            return Continue(StageEnd::Skipped);
        }
        self.measure_scales_by(Sizes::AsAllEntries);
        self.crash(CRASH)?;
        let end = self.newton_on(Map::FischerBurmeister, budget)?;
        self.scale_as_at_start()?;
        Continue(end)
    }
}
