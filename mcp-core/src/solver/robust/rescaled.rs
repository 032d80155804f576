//! The Newton stages again in scales measured where they got stuck.

use super::Search;
use super::map::Map;
use super::starts::CRASH;
use crate::solver::monitor::Direction;
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::Continue;

/// Newton steps from one point.
const STEPS: usize = 60;

impl Search<'_, '_> {
    /// New scales at the point where Newton got stuck, and its stages again.
    pub(super) fn rescaled(&mut self, _budget: usize) -> Flow<StageEnd> {
        if !self.run.options.robust.equilibrate {
            return Continue(StageEnd::Skipped);
        }
        self.leap_from_start()?;
        self.memory.go_to_stuck();
        if !self.restart()? {
            return Continue(StageEnd::NotFinite);
        }
        self.measure_scales();
        self.newton_on(Map::FischerBurmeister, STEPS)?;
        self.memory.go_to_stuck();
        let smoothing = self.run.options.robust.smoothing;
        if smoothing > 0 && self.restart()? {
            self.smoothing_and_newton(smoothing)?;
        }
        self.memory.go_to_stuck();
        let josephy = self.run.options.robust.josephy;
        if josephy > 0 && self.restart()? {
            self.josephy(josephy)?;
        }
        self.scale_as_at_start()?;
        Continue(StageEnd::Budget)
    }

    /// The full min-map step from the start, whatever it does to the merit, new scales there, and the
    /// Newton stages: where the scales of the start are not those of the solution.
    fn leap_from_start(&mut self) -> Flow {
        self.memory.go_to_start();
        if !self.restart()? || !self.min_map_direction(1e-8) || self.evaluate(1.0).is_nan() {
            return Continue(());
        }
        if self.accept(Direction::MinMap, 1.0)? {
            self.measure_scales();
            self.crash(CRASH)?;
            self.newton_on(Map::FischerBurmeister, STEPS)?;
        }
        Continue(())
    }
}
