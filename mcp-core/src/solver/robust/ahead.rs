//! A last look at a point that the certificate accepts: where would Newton's method go from there?
//!
//! ```text
//! ρ = e(y + d) / e(y),  d Newton's step, or that of Levenberg–Marquardt where the matrix is singular
//! towards a root of multiplicity m      ρ = (1 − 1/m)^m     < 1/e
//! towards infinity, G as y^-p or e^-y   ρ = (1 + 1/p)^-p    >= 1/e
//! past a minimum of |G|                 anything, but not twice
//! at a root, G rounded                  anything, but G(y + 16 d) = −15 G(y) but for rounding
//! ```
//!
//! It is taken where an equation holds by what is known of the sizes of its variables and not by their
//! values, where variables have grown far or are lost in rounding, where the residual is more than rounding, and
//! beyond a point from which Newton led on to infinity. Steps towards infinity are of one length; those towards a
//! root of multiplicity `m` shrink by `1 − 1/m`. Cost: one factorisation and one or two `F`; several of each and
//! of `J` near a multiple root and where the matrix is singular.

use super::Search;
use super::far::{AT_START, FAR};
use super::judge::{DIVERGED, SHARP};
use crate::ncp::Branch;
use crate::solver::certificate::Verdict;
use crate::solver::monitor::Direction;
use crate::solver::run::Flow;
use std::ops::ControlFlow::Continue;

/// Relative residual of contradictions that rounding cannot be told from, and share of the tolerance that is as
/// good.
const ROUNDING: f64 = 1e-14;
const SETTLED: f64 = 1e-6;
/// Growth, in scaled units, beyond which a small residual may be one at infinity; where polishing
/// has made it sharp, only from the second on.
const GROWN: [f64; 2] = [10.0, 100.0];
/// Share of the tolerance that is left of the residual at a point beyond doubt, and, in terms near the start, at
/// a solution with a singular matrix. What contradicts itself by more is none.
const CONTRADICTION: f64 = 0.01;
/// Relative Newton step of a point that still moves.
const MOVING: f64 = 0.1;
/// What a step towards a root multiplies the residual by, up to multiplicity 20.
const CONTRACTION: f64 = 0.36;
/// The same that leaves no doubt.
const QUICK: f64 = 0.05;
/// Newton steps, relative to the variable, that are short.
const SHORT: f64 = 1e-4;
/// Steps, relative to the variable or its start, over which `G` is linear.
const TINY: f64 = 1e-6;
/// Share of what is left after a tiny step that its linearisation must not explain where `G` is rounded.
const SURPRISE: f64 = 0.1;
/// Length, in Newton steps, over which `G` is looked at where it is rounded.
const STRIDE: f64 = 16.0;
/// Multiple of what is seen of the rounding that there may be of it; `e^-z` needs 15.
const ROUNDED: f64 = 8.0;
/// Share of its mean that the last of several steps has towards a root of multiplicity 12.
const EVEN: f64 = 0.8;
/// Steps that are taken to see.
const STEPS: usize = 6;

impl Search<'_, '_> {
    /// What the iterate turns out to be, which the certificate has just accepted.
    pub(super) fn look_ahead(&mut self) -> Flow<Verdict> {
        let e = self.judged_residual();
        let limit = GROWN[usize::from(e <= SHARP)];
        let leans = self.run.work.certifier.leans();
        let memory = &*self.memory;
        let growth = (0..memory.unit.len()).fold(0.0, |most: f64, j| most.max(memory.growth(j)));
        if self.is_far_from_solved() {
            return Continue(Verdict::Asymptotic);
        }
        let judged = self.run.certificate.map_or(f64::INFINITY, |c| c.relative_residual);
        let is_settled = growth <= limit && e <= self.settled() && !leans
            || judged <= self.settled() && !self.has_grown(2.0);
        // A smaller residual may be one farther on the way of an earlier point.
        if is_settled && !(self.memory.runs_on && self.has_grown(2.0)) {
            return Continue(Verdict::Accepted);
        }
        // In scales of its own, a matrix that is nearly singular is one in all units.
        self.measure_scales();
        if growth > FAR && self.is_free_when_far() {
            return Continue(Verdict::Asymptotic);
        }
        let is_singular = !self.undamped_min_map_direction();
        if (is_singular || leans) && self.has_lost_a_variable() {
            return Continue(Verdict::Asymptotic);
        }
        let told = if is_singular {
            self.look_where_singular(growth)
        } else {
            let is_sharp = !leans && !self.has_grown(GROWN[0])
                || judged <= self.clear() && !self.has_grown(2.0);
            self.look_where_regular(limit, is_sharp)
        };
        if let Some(verdict) = told {
            return Continue(verdict);
        }
        if self.settles(is_singular)? {
            // The point may have moved.
            return Continue(self.ask());
        }
        let Search { run, memory } = self;
        memory.view.unscale(&memory.here.z, run.problem.shape().bounds(), &mut memory.model_z);
        if is_singular || !self.leads_on(SHORT, 1.0) {
            return Continue(Verdict::Refused);
        }
        self.memory.runs_on = true;
        Continue(Verdict::Asymptotic)
    }

    /// What can be said without a step. Singular is also every system with multipliers that are not unique.
    fn look_where_singular(&mut self, growth: f64) -> Option<Verdict> {
        if self.memory.asymptotic && growth > GROWN[0] {
            return Some(Verdict::Asymptotic);
        }
        let near = self.near_residual(AT_START);
        if near <= self.settled() && growth <= GROWN[0] {
            return Some(Verdict::Accepted);
        }
        if near > self.clear() {
            let has_grown = self.has_grown(1.0);
            return Some(if has_grown { Verdict::Asymptotic } else { Verdict::Refused });
        }
        // Beyond scales no step can tell.
        let verdict = if growth > DIVERGED { Verdict::Asymptotic } else { Verdict::Accepted };
        self.is_beyond_scales().then_some(verdict)
    }

    /// What Newton's direction says, that of a point which is sharp or not.
    fn look_where_regular(&mut self, limit: f64, is_sharp: bool) -> Option<Verdict> {
        if self.leads_on(MOVING, limit) {
            self.memory.runs_on = true;
            return Some(Verdict::Asymptotic);
        }
        (is_sharp && !self.drifts(1.0)).then_some(Verdict::Accepted)
    }

    /// Relative residual of a point that is clearly a solution.
    fn clear(&self) -> f64 {
        (CONTRADICTION * self.run.options.tol_relative).max(SHARP)
    }

    /// Relative residual of a point with which all is said.
    fn settled(&self) -> f64 {
        (SETTLED * self.run.options.tol_relative).max(ROUNDING)
    }

    /// The relative residual with the `J` of the certificate, which is the one at the iterate.
    fn judged_residual(&mut self) -> f64 {
        let Search { run, memory } = self;
        let bounds = run.problem.shape().bounds();
        memory.view.unscale(&memory.here.z, bounds, &mut memory.model_z);
        memory.jac.copy_from_slice(run.work.certifier.jac());
        memory.view.scale_jacobian(run.problem.pattern(), &mut memory.jac);
        self.relative_residual()
    }

    /// Whether the direction changes a variable that has grown by more than `limit` by more than the share
    /// `moving`.
    fn leads_on(&self, moving: f64, limit: f64) -> bool {
        let memory = &*self.memory;
        let (y, d) = (&memory.here.z, &memory.direction);
        (0..y.len()).any(|j| {
            memory.growth(j) > limit && d[j].abs() > moving * y[j].abs() && self.is_inside(j)
        })
    }

    /// Whether the direction changes a variable that is more than `times` its start by more than a little.
    fn drifts(&self, times: f64) -> bool {
        (0..self.memory.unit.len()).any(|j| self.is_drifting(j, times))
    }

    fn is_drifting(&self, j: usize, times: f64) -> bool {
        let memory = &*self.memory;
        let (y, d) = (memory.here.z[j], memory.direction[j]);
        let has_grown = memory.model_z[j].abs() > times * memory.own(j);
        has_grown && d.abs() > SHORT * y.abs() && self.is_inside(j)
    }

    /// Whether a variable is taken to lie between its bounds: its direction is Newton's, not the way to a bound.
    pub(super) fn is_inside(&self, j: usize) -> bool {
        let memory = &*self.memory;
        memory.view.natural(&memory.here, j).1 == Branch::Equation
    }

    /// Goes on with Newton's steps, damped ones where the matrix is singular, as long as they lead to a
    /// root. Whether they do.
    fn settles(&mut self, is_singular: bool) -> Flow<bool> {
        let leans = self.run.work.certifier.leans();
        // A residual may vanish at infinity, but there no step is right twice.
        let least = if is_singular { 0 } else { 2 };
        for k in 0..STEPS {
            let e = self.relative_residual();
            if k >= least && e <= self.settled() && (is_singular || !self.drifts(2.0)) {
                // At a singular matrix terms may have grown and left `G` as it was.
                if !is_singular || self.near_residual(AT_START) <= self.settled() {
                    return Continue(true);
                }
                self.relative_residual();
            }
            if !self.min_map_direction(1e-16) {
                return Continue(false);
            }
            let is_short = !is_singular && self.is_short();
            // What one variable has left of its digits may hide where another one goes.
            if is_short && (k > 0 || !leans) {
                return Continue(true);
            }
            let mut next = self.residual_ahead();
            if is_short && next.is_nan() {
                return Continue(true);
            }
            if !is_short && !(next <= CONTRACTION * e) {
                let most = self.run.options.tol_relative.max(STRIDE * e);
                let is_noise = if is_singular {
                    self.is_rounded()
                } else {
                    next <= most && self.is_straight()
                };
                if is_noise && !(self.memory.runs_on && self.drifts(2.0)) {
                    return Continue(true);
                }
                // A matrix that is nearly singular makes much of rounding.
                if !is_singular && self.damped_direction(1e-16) {
                    next = self.residual_ahead();
                }
                if !(next <= CONTRACTION * e) {
                    return Continue(false);
                }
            }
            if k > 0 && !is_singular && next <= QUICK * e && !self.drifts(2.0) {
                return Continue(true);
            }
            self.swap();
            self.run.stats.iterations += 1;
            self.run.last = (Direction::MinMap, 1.0);
            self.report()?;
            if !self.jacobian() {
                return Continue(false);
            }
        }
        Continue(is_singular || !self.has_gone_on())
    }

    /// Whether a variable that drifts has done so by steps of one length, all [`STEPS`] of them.
    fn has_gone_on(&self) -> bool {
        let memory = &*self.memory;
        let (y, d, units) = (&memory.here.z, &memory.direction, memory.view.units());
        let is_even = |j: usize| {
            let way = y[j] - memory.model_z[j] / units[j];
            STEPS as f64 * d[j].abs() > EVEN * way.abs()
        };
        (0..y.len()).any(|j| self.is_drifting(j, 1.0) && is_even(j))
    }

    /// Whether the direction changes no variable by more than a little of it, or the rounding of its start.
    fn is_short(&self) -> bool {
        self.is_within(SHORT, 64.0 * f64::EPSILON)
    }

    /// Whether the direction changes every variable by at most the share `of_level` of it or `of_start` of its
    /// size at the start.
    fn is_within(&self, of_level: f64, of_start: f64) -> bool {
        let memory = &*self.memory;
        let (y, units) = (&memory.here.z, memory.view.units());
        let most = |j: usize| (of_level * y[j].abs()).max(of_start * memory.own(j) / units[j]);
        (0..y.len()).all(|j| memory.direction[j].abs() <= most(j))
    }

    /// `e` at the end of the direction, in the sizes of the iterate; the trial point stays there.
    fn residual_ahead(&mut self) -> f64 {
        if self.evaluate(1.0).is_nan() { f64::NAN } else { self.trial_residual() }
    }

    /// The same at the trial point.
    fn trial_residual(&self) -> f64 {
        let memory = &*self.memory;
        let bounds = (&memory.view.lower[..], &memory.view.upper[..]);
        memory.largest_residual(&memory.trial.z, &memory.trial.f, bounds)
    }

    /// Whether the min map at `y + d`, the trial point, is not what its linearisation says, although `d` is tiny:
    /// contradictions stay what they are.
    fn is_rounded(&mut self) -> bool {
        let memory = &mut *self.memory;
        memory.zeta.copy_from_slice(&memory.direction);
        memory.multiply(self.run.problem.pattern());
        let (mut surprise, mut left) = (0.0_f64, 0.0_f64);
        for i in 0..memory.rhs.len() {
            let value = memory.view.natural(&memory.trial, i).0;
            surprise =
                surprise.max((value - memory.rhs[i] - memory.slope[i]).abs() / memory.size[i]);
            left = left.max(value.abs() / memory.size[i]);
        }
        surprise > SURPRISE * left && self.is_within(TINY, TINY)
    }

    /// Whether `G(y + 16 d) = −15 G(y)`, but for what is left of it at `y + d`, the trial point, and rounding.
    fn is_straight(&mut self) -> bool {
        let memory = &mut *self.memory;
        memory.slope.copy_from_slice(&memory.trial.f);
        if self.evaluate(STRIDE).is_nan() {
            return false;
        }
        // A short step may be due to the rounding of terms as large as at the start.
        let is_tiny = self.is_within(TINY, TINY);
        let Search { run, memory } = self;
        let mut size = std::mem::take(&mut memory.zeta);
        size.fill(0.0);
        let (y, units) = (&memory.here.z, memory.view.units());
        let own = |j: usize| if is_tiny { memory.own(j) / units[j] } else { 0.0 };
        let level = |j: usize| y[j].abs().max(own(j));
        run.problem.pattern().add_sizes(&memory.jac, level, &mut size);
        let is_straight = (0..y.len()).all(|i| {
            let (g, ahead, far) = (memory.here.f[i], memory.slope[i], memory.trial.f[i]);
            let rounding = g.abs().max(ahead.abs()) + f64::EPSILON * size[i];
            let is_bound = memory.view.natural(&memory.here, i).1 != Branch::Equation;
            is_bound || (far - (1.0 - STRIDE) * g).abs() <= ROUNDED * rounding
        });
        memory.zeta = size;
        is_straight
    }
}
