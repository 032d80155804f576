//! Other starts: corners of the boxes, and perturbed ones, the same every time.

use super::map::Map;
use super::{Search, Sizes};
use crate::solver::monitor::Direction;
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::Continue;

/// Sizes of the perturbations, relative to `1 + |y⁰|` in scaled units.
const SIZES: [f64; 3] = [0.1, 1.0, 10.0];
/// Steps from one start.
const STEPS: usize = 60;
/// Steps of the crash from one start.
const CRASH: usize = 20;

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

    /// Crash, Newton and smoothing from `budget` perturbed starts.
    pub(super) fn starts(&mut self, budget: usize) -> Flow<StageEnd> {
        let smoothing = self.run.options.robust.smoothing;
        let mut numbers = Numbers(0);
        for k in 0..budget {
            let size = SIZES[k % SIZES.len()];
            // First to one side, then to both.
            let is_one_sided = (k / SIZES.len()).is_multiple_of(2);
            let memory = &mut *self.memory;
            memory.go_to_start();
            for y in &mut memory.here.z {
                let number = numbers.next();
                let noise = if is_one_sided { number } else { 3.0 * (2.0 * number - 1.0) };
                *y += size * (1.0 + y.abs()) * noise;
            }
            memory.view.project(&mut memory.here.z);
            if !self.restart()? {
                continue;
            }
            self.keep_stuck();
            self.crash(CRASH)?;
            self.newton_on(Map::FischerBurmeister, STEPS)?;
            self.memory.go_to_stuck();
            if smoothing > 0 && self.restart()? {
                self.smoothing_and_newton(smoothing)?;
            }
        }
        Continue(StageEnd::Budget)
    }

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

    /// Goes back to the scales of the start.
    fn scale_as_at_start(&mut self) -> Flow {
        self.memory.go_to_start();
        if self.restart()? {
            self.measure_scales();
        }
        Continue(())
    }

    /// Keeps the iterate as the point where Newton got stuck.
    pub(super) fn keep_stuck(&mut self) {
        let Search { run, memory } = self;
        let bounds = run.problem.shape().bounds();
        memory.view.unscale(&memory.here.z, bounds, &mut memory.stuck);
    }
}

/// Numbers in `[0, 1)` that look random: `SplitMix64` ([SLF14](crate#references)).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ x >> 31) >> 11) as f64 / (1_u64 << 53) as f64
    }
}
