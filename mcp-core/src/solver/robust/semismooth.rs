//! Semismooth Newton on `Φ(y) = 0`, every iterate in the box.
//!
//! ```text
//! 1  near a solution, every other time: the min-map step, if it divides the natural residual by 10
//! 2  H d = −Φ;  t in {1, ½, …, 1/16}: θ(P(y + t d)) <= max of the last merits − 10⁻⁴ t 2θ
//! 3  no step: Levenberg–Marquardt, μ = clip(‖Φ‖, 10⁻¹², 10⁻⁴) ‖H‖², × 30 while it fails
//! 4  no step: Newton's with t down to 2·10⁻⁴, then the projected gradient
//! ```
//!
//! [DFK96](crate#references) with the non-monotone reference of [GLL86](crate#references), which alone
//! can go round in circles: as many steps without progress as it remembers make it monotone. Step 3 is
//! that of [KP04](crate#references). `Ψ` is continuously differentiable, so every limit point is
//! stationary over the box.

use super::Search;
use super::equilibrate::exponent;
use super::map::Map;
use super::memory::Memory;
use crate::globalise::{Stall, StallWatch};
use crate::problem::Pattern;
use crate::solver::monitor::Direction;
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::{self, Continue};

/// Share of the decrease predicted, `2θ` for Newton steps.
const SHARE: f64 = 1e-4;
/// Newton steps shorter than this come after a damped one.
const SHORT: f64 = 0.05;
/// They are quartered down to this.
const SHORTEST: f64 = 2e-4;
/// Steps before the search remembers merits.
pub(super) const MONOTONE: usize = 2;
/// Natural residual below which min-map steps are tried, in scaled units.
const NEAR: f64 = 1e-2;
/// Damped steps in a row that together must reduce the merit by 30 %: in scales that are wrong they
/// go on for hundreds of steps.
const CRAWL: Stall = Stall { iterations: 5, factor: 0.7 };
/// Binary exponents the geometric mean of the largest entries of rows may drift to.
const DRIFT: i64 = 10;

impl Search<'_, '_> {
    /// At most `budget` steps on the Fischer–Burmeister equations.
    pub(super) fn semismooth(&mut self, budget: usize) -> Flow<StageEnd> {
        self.newton_on(Map::FischerBurmeister, budget)
    }

    /// Steps on the penalised equations, from the start, and then on the plain ones.
    pub(super) fn penalised(&mut self, budget: usize) -> Flow<StageEnd> {
        let weight = self.run.options.robust.penalty_weight;
        let end = self.newton_on(Map::Penalised { weight }, budget)?;
        if end == StageEnd::NotFinite || self.memory.leave.is_some() {
            return Continue(end);
        }
        self.newton_on(Map::FischerBurmeister, budget / 4)
    }

    /// At most `budget` steps that reduce the merit of `map`.
    pub(super) fn newton_on(&mut self, map: Map, budget: usize) -> Flow<StageEnd> {
        let rule = self.run.options.robust.stall;
        self.set_map(map);
        let mut stall = StallWatch::new(self.memory.here.merit);
        let mut crawl = StallWatch::new(self.memory.here.merit);
        for k in 0..budget {
            self.begin()?;
            if let Some(end) = self.memory.leave {
                return Continue(end);
            }
            if k > 0 && self.has_drifted() {
                return Continue(StageEnd::Drifted);
            }
            if stall.observe(self.memory.here.merit, rule) {
                return Continue(StageEnd::Stalled);
            }
            if self.run.last.0 != Direction::LevenbergMarquardt {
                crawl = StallWatch::new(self.memory.here.merit);
            } else if crawl.observe(self.memory.here.merit, CRAWL) {
                return Continue(StageEnd::Stalled);
            }
            if k % 2 == 0 && self.min_map_step()? {
                continue;
            }
            let is_monotone = k < MONOTONE || stall.lasts(self.run.options.robust.memory);
            if let ControlFlow::Break(end) = self.newton_step(is_monotone)? {
                return Continue(end);
            }
        }
        Continue(StageEnd::Budget)
    }

    /// Goes over to another map at the same point.
    pub(super) fn set_map(&mut self, map: Map) {
        let memory = &mut *self.memory;
        memory.map = map;
        memory.view.weigh(map, &mut memory.here);
        memory.reference.reset();
        memory.reference.accept(memory.here.merit);
    }

    /// Step 1; false if it was not taken.
    fn min_map_step(&mut self) -> Flow<bool> {
        let memory = &*self.memory;
        if memory.proximal.is_some() || self.run.options.robust.tail == 0 {
            return Continue(false);
        }
        let residual = memory.view.natural_max(&memory.here);
        if !(residual < NEAR && self.min_map_direction(1e-16)) || self.evaluate(1.0).is_nan() {
            return Continue(false);
        }
        let memory = &*self.memory;
        if memory.view.natural_max(&memory.trial) <= 0.1 * residual {
            return self.accept(Direction::MinMap, 1.0);
        }
        Continue(false)
    }

    /// Steps 2 to 4; `Break` if none was taken.
    pub(super) fn newton_step(&mut self, is_monotone: bool) -> Flow<ControlFlow<StageEnd>> {
        self.memory.linearise(self.run.problem.pattern());
        let reference = match self.memory.here.merit {
            merit if is_monotone => merit,
            merit => self.memory.reference.value(merit),
        };
        let has_newton = self.newton_direction();
        if has_newton
            && let Some(t) = self.search_newton(1.0, SHORT, reference)
            && self.accept(Direction::FischerBurmeister, t)?
        {
            return Continue(Continue(()));
        }
        if self.search_damped() && self.accept(Direction::LevenbergMarquardt, 1.0)? {
            return Continue(Continue(()));
        }
        if has_newton
            && self.newton_direction()
            && let Some(t) = self.search_newton(0.5 * SHORT, SHORTEST, reference)
            && self.accept(Direction::FischerBurmeister, t)?
        {
            return Continue(Continue(()));
        }
        if let Some(t) = self.search_gradient()
            && self.accept(Direction::Gradient, t)?
        {
            return Continue(Continue(()));
        }
        Continue(ControlFlow::Break(StageEnd::NoStep))
    }

    /// `H d = −Φ`; false if `H` is singular or `d` no direction of descent.
    pub(super) fn newton_direction(&mut self) -> bool {
        self.memory.rhs.copy_from_slice(&self.memory.here.phi);
        if !self.undamped_direction() {
            return false;
        }
        let memory = &*self.memory;
        let slope: f64 = memory.gradient.iter().zip(&memory.direction).map(|(g, d)| g * d).sum();
        // False for NaN.
        slope < 0.0
    }

    /// Step 2: the first step accepted in `{first, first/2, …}` down to `last`, its point in `trial`.
    pub(super) fn search_newton(&mut self, first: f64, last: f64, reference: f64) -> Option<f64> {
        let merit = self.memory.here.merit;
        let mut t = first;
        while t >= last {
            let trial = self.evaluate(t);
            if trial < reference && trial <= reference - SHARE * t * 2.0 * merit {
                return Some(t);
            }
            t *= if first == 1.0 { 0.5 } else { 0.25 };
        }
        None
    }

    /// Step 3: whether a damped step reduces the merit, its point in `trial`.
    fn search_damped(&mut self) -> bool {
        let memory = &mut *self.memory;
        memory.rhs.copy_from_slice(&memory.here.phi);
        let merit = memory.here.merit;
        let mut damping = (2.0 * merit).sqrt().clamp(1e-12, 1e-4);
        for _ in 0..self.run.options.robust.levenberg_marquardt {
            if !self.damped_direction(damping) {
                return false;
            }
            let trial = self.evaluate(1.0);
            if trial < merit && trial <= merit - 1e-3 * self.predicted_decrease().max(0.0) {
                return true;
            }
            damping *= 30.0;
        }
        false
    }

    /// `θ − ½‖Φ + H (y⁺ − y)‖²` for the trial point `y⁺`.
    fn predicted_decrease(&mut self) -> f64 {
        let memory = &mut *self.memory;
        for (j, d) in memory.zeta.iter_mut().enumerate() {
            *d = memory.trial.z[j] - memory.here.z[j];
        }
        memory.multiply(self.run.problem.pattern());
        let model = memory.here.phi.iter().zip(&memory.slope).map(|(p, s)| (p + s) * (p + s));
        memory.here.merit - 0.5 * model.sum::<f64>()
    }

    /// Step 4: a step along the projected gradient, its point in `trial`.
    pub(super) fn search_gradient(&mut self) -> Option<f64> {
        let memory = &mut *self.memory;
        let merit = memory.here.merit;
        let square: f64 = memory.gradient.iter().map(|g| g * g).sum();
        for (d, g) in memory.direction.iter_mut().zip(&memory.gradient) {
            *d = -g;
        }
        if !(square > 0.0) {
            return None;
        }
        let mut t = merit / square;
        for _ in 0..25 {
            let trial = self.evaluate(t);
            let memory = &*self.memory;
            let moved = memory.trial.z.iter().zip(&memory.here.z).map(|(to, from)| to - from);
            let slope: f64 = memory.gradient.iter().zip(moved).map(|(g, d)| g * d).sum();
            if trial < merit && trial <= merit + SHARE * slope {
                return Some(t);
            }
            t *= 0.3;
        }
        None
    }

    /// Whether the geometric mean of the largest entries of the rows of `J` has left `2^±10` times
    /// what it was when the scales were measured.
    pub(super) fn has_drifted(&mut self) -> bool {
        let robust = &self.run.options.robust;
        if !robust.equilibrate || robust.rescale == 0 || self.memory.proximal.is_some() {
            return false;
        }
        let level = self.memory.level(self.run.problem.pattern());
        (level - self.memory.level_measured).abs() >= DRIFT
    }
}

impl Memory {
    /// The mean binary exponent of the largest entries of the rows of `J`.
    pub(super) fn level(&mut self, pattern: &Pattern) -> i64 {
        self.slope.fill(0.0);
        for (i, value) in pattern.rows().zip(&self.jac) {
            self.slope[i] = self.slope[i].max(value.abs());
        }
        let (mut sum, mut count) = (0_i64, 0_i64);
        for (i, &largest) in self.slope.iter().enumerate() {
            if largest > 0.0 && self.view.lower[i] < self.view.upper[i] {
                sum += i64::from(exponent(largest));
                count += 1;
            }
        }
        if count > 0 { sum.div_euclid(count) } else { 0 }
    }
}
