//! Smoothing continuation: `Φ_μ(y) = 0` for `μ → 0`, iterates strictly inside the box.
//!
//! ```text
//! μ ← μ/10 once ‖Φ_μ‖/√n <= ½√μ, μ/2 where no step is found; ends at √μ < 10⁻⁵, then Newton on Φ
//! left where fifteen steps for one μ do not reduce ‖Φ_μ‖² by 30 %
//! y ← inside(y + t d): at most 9/10 of the way to a bound, component by component
//! ```
//!
//! `φ_μ` of [Kan96](crate#references); `Φ_μ = 0` is the central path. For monotone problems the path
//! exists; following it avoids the local minima of `‖Φ‖`.

use super::Search;
use super::map::Map;
use crate::globalise::{Stall, StallWatch};
use crate::solver::monitor::Direction;
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::Continue;

/// Part of the distance to a bound that every step leaves.
const LEFT: f64 = 0.1;
/// Path steps without success.
const FAILURES: usize = 6;
/// Steps for one `μ` that together must reduce the merit by 30 %: where the path turns back, as it does
/// where there is no solution, they go on until the budget ends.
const CRAWL: Stall = Stall { iterations: 15, factor: 0.7 };
/// Steps of Newton's method after the path.
const AFTERWARDS: usize = 30;

impl Search<'_, '_> {
    /// Follows the path for at most `budget` steps, then Newton on `Φ`.
    pub(super) fn smoothing_and_newton(&mut self, budget: usize) -> Flow<StageEnd> {
        let end = self.smoothing(budget)?;
        if end == StageEnd::NotFinite {
            return Continue(end);
        }
        self.memory.leave = None;
        if !self.restart()? {
            return Continue(StageEnd::NotFinite);
        }
        self.newton_on(Map::FischerBurmeister, AFTERWARDS)
    }

    fn smoothing(&mut self, budget: usize) -> Flow<StageEnd> {
        if !self.move_strictly_inside()? {
            return Continue(StageEnd::NotFinite);
        }
        let n = self.memory.center.len().max(1) as f64;
        let mean_square = 2.0 * self.memory.here.merit / n;
        let mut mu = mean_square.clamp(0.1, 1e4);
        let mut failures = 0;
        let mut stall = StallWatch::new(f64::INFINITY);
        for _ in 0..budget {
            self.begin()?;
            if let Some(end) = self.memory.leave {
                return Continue(end);
            }
            self.set_map(Map::Smoothed { mu });
            if failures > 0 || (2.0 * self.memory.here.merit / n).sqrt() <= 0.5 * mu.sqrt() {
                mu *= if failures > 0 { 0.5 } else { 0.1 };
                if failures > FAILURES {
                    return Continue(StageEnd::NoStep);
                }
                if mu.sqrt() < 1e-5 {
                    return Continue(StageEnd::Budget);
                }
                self.set_map(Map::Smoothed { mu });
                stall = StallWatch::new(self.memory.here.merit);
            } else if stall.observe(self.memory.here.merit, CRAWL) {
                return Continue(StageEnd::Stalled);
            }
            failures = if self.path_step()? { 0 } else { failures + 1 };
        }
        Continue(StageEnd::Budget)
    }

    /// A step that reduces the merit of `Φ_μ`: Newton's, or else a damped one.
    fn path_step(&mut self) -> Flow<bool> {
        self.memory.linearise(self.run.problem.pattern());
        for direction in [Direction::FischerBurmeister, Direction::LevenbergMarquardt] {
            let memory = &mut *self.memory;
            let merit = memory.here.merit;
            memory.rhs.copy_from_slice(&memory.here.phi);
            let found = if direction == Direction::FischerBurmeister {
                self.undamped_direction()
            } else {
                self.damped_direction(1e-4 * (2.0 * merit).sqrt().clamp(1e-8, 1.0))
            };
            if !found {
                continue;
            }
            let mut t = 1.0;
            while t > 1e-3 {
                self.set_inside_trial(t);
                let trial = self.evaluate_trial();
                if trial <= (1.0 - 1e-4 * t) * merit && self.accept(direction, t)? {
                    return Continue(true);
                }
                t *= 0.5;
            }
        }
        Continue(false)
    }

    /// `y + t d`, but at most nine tenths of the way to any bound.
    fn set_inside_trial(&mut self, t: f64) {
        let memory = &mut *self.memory;
        for j in 0..memory.direction.len() {
            let (l, u, y) = (memory.view.lower[j], memory.view.upper[j], memory.here.z[j]);
            let mut to = y + t * memory.direction[j];
            if l.is_finite() {
                to = to.max(l + LEFT * (y - l));
            }
            if u.is_finite() {
                to = to.min(u - LEFT * (u - y));
            }
            memory.trial.z[j] = if l < u { to } else { l };
        }
    }

    /// Moves the iterate off its bounds, by a tenth of 1 or of a quarter of the box, by all of it
    /// where that is outside the domain of `F`; false if that does not help.
    fn move_strictly_inside(&mut self) -> Flow<bool> {
        for share in [0.1, 1.0] {
            let memory = &mut *self.memory;
            for j in 0..memory.here.z.len() {
                let (l, u) = (memory.view.lower[j], memory.view.upper[j]);
                if l < u {
                    let width = share * (0.25 * (u - l)).min(1.0);
                    memory.here.z[j] = memory.here.z[j].max(l + width).min(u - width);
                }
            }
            memory.map = Map::FischerBurmeister;
            if self.evaluate_here() && self.jacobian() {
                self.judge()?;
                return Continue(true);
            }
        }
        Continue(false)
    }
}
