//! When a point is taken for a solution, asked of the certificate, and kept as the best.

use super::Search;
use super::equilibrate::{exponent, power_of_two};
use super::memory::Memory;
use crate::solver::certificate::Verdict;
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use crate::solver::status::Status;
use crate::solver::workspace::Point;
use std::ops::ControlFlow::{Break, Continue};

/// Relative residual below which a point is polished and shown to the certificate.
const NEARLY: f64 = 1e-8;
/// Relative residual that no further step will reduce.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Relative residual of a point that should satisfy every tolerance that can be satisfied.
const SHARP: f64 = 1e-13;
/// Growth, in scaled units, beyond which a small residual may be one at infinity; where polishing
/// has made it sharp, only from the second on.
const GROWN: [f64; 2] = [10.0, 100.0];
/// Growth beyond which a small residual with a singular matrix is one at infinity.
const FAR: f64 = 1e4;
/// Growth up to which terms are counted where a variable has grown beyond [`FAR`].
const NEAR: f64 = 100.0;
/// The same where the matrix is singular.
const AT_START: f64 = 1.0;
/// Share of the tolerance that is left of the residual, in terms near the start, at a solution with a
/// singular matrix. What contradicts itself by more is none.
const CONTRADICTION: f64 = 0.01;
/// Relative Newton step of a point that still moves.
const MOVING: f64 = 0.1;
/// Growth beyond which a stage is left.
const DIVERGED: f64 = 1e12;
/// How far below its start a variable may fall before its start counts: `2⁻¹³`.
const FLOOR: i32 = 13;

impl Search<'_, '_> {
    /// Keeps the iterate if it is the best; if it is nearly a solution, polishes it and ends the
    /// solve if the certificate agrees.
    pub(super) fn judge(&mut self) -> Flow {
        let e = self.relative_residual();
        self.keep_best(e);
        if e <= NEARLY.min(self.run.options.tol_relative) {
            self.finish(e)?;
        }
        let memory = &mut *self.memory;
        let far = |(y, start): (&f64, &f64)| y.abs() > DIVERGED * start.abs().max(1.0);
        if memory.here.z.iter().zip(&memory.start_y).any(far) {
            memory.leave = Some(StageEnd::Diverged);
            for j in 0..memory.start_y.len() {
                memory.slope[j] = memory.here.z[j] - memory.start_y[j];
            }
            memory.view.unscale_direction(&memory.slope, &mut memory.runaway);
        }
        Continue(())
    }

    /// Where all variables stand on bounds that `F` keeps them at, `J` need not be finite.
    pub(super) fn judge_on_bounds(&mut self) -> Flow {
        let memory = &*self.memory;
        if memory.view.natural_max(&memory.here) == 0.0 { self.judge_start() } else { Continue(()) }
    }

    /// A start of zeros may be a solution but for rounding, from which no scales follow.
    pub(super) fn judge_zeros(&mut self) -> Flow {
        let is_zero = self.memory.start.iter().all(|z| *z == 0.0);
        if is_zero { self.judge_start() } else { Continue(()) }
    }

    /// Ends the solve if the certificate accepts the start.
    fn judge_start(&mut self) -> Flow {
        if self.ask() == Verdict::Accepted {
            self.report()?;
            return Break(Status::Solved);
        }
        // Of the start, not of the end.
        self.run.certificate = None;
        Continue(())
    }

    /// `e = max_i |mid((y_i − l_i)/w_i, G_i/s_i, (y_i − u_i)/w_i)|` with `w_j = |y_j| + τ`,
    /// `s_i = Σ_j |J_ij| w_j`, from the last `J` known: the residual of the certificate, in scaled
    /// variables with one gauge `τ`.
    pub(super) fn relative_residual(&mut self) -> f64 {
        let memory = &mut *self.memory;
        let pattern = self.run.problem.pattern();
        let tau = gauge(&memory.here.z, &memory.start_y);
        for (w, y) in memory.weight.iter_mut().zip(&memory.here.z) {
            *w = y.abs() + tau;
        }
        memory.size.fill(0.0);
        pattern.add_sizes(&memory.jac, |j| memory.weight[j], &mut memory.size);
        let Point { z: y, f: g, .. } = &memory.here;
        memory.largest_residual(y, g, (&memory.view.lower, &memory.view.upper))
    }

    fn keep_best(&mut self, e: f64) {
        let Search { run, memory } = self;
        if e < memory.best_residual && !memory.asymptotic {
            memory.best_residual = e;
            let bounds = run.problem.shape().bounds();
            memory.view.unscale(&memory.here.z, bounds, &mut memory.best);
        }
    }

    /// Polishes the iterate and asks the certificate. If it refuses, the iterate is as before.
    fn finish(&mut self, e: f64) -> Flow {
        self.report()?;
        let memory = &mut *self.memory;
        memory.other.copy_from(&memory.here);
        let polished = if e > ROUNDING { self.tail(e)? } else { e };
        let verdict = self.ask();
        let is_asymptotic = match verdict {
            Verdict::Accepted => self.still_moves(polished),
            Verdict::Asymptotic => true,
            Verdict::Refused => false,
        };
        if is_asymptotic {
            let Search { run, memory } = self;
            if !memory.asymptotic {
                memory.best.copy_from_slice(&run.work.answer);
                memory.best_residual = polished;
                memory.asymptotic = true;
            }
            memory.leave = Some(StageEnd::Diverged);
            return Continue(());
        }
        if verdict == Verdict::Accepted {
            let _ = self.report();
            return Break(Status::Solved);
        }
        self.keep_best(polished);
        let certificate = self.run.certificate.take();
        let accurate = |c: crate::solver::certificate::Certificate| {
            c.verdict(None, self.run.options.tol_relative) == Verdict::Accepted
        };
        if polished <= SHARP && certificate.is_some_and(accurate) {
            // Only the absolute tolerance is not met, and never will be.
            let _ = self.report();
            return Break(Status::LineSearchFailed);
        }
        let memory = &mut *self.memory;
        memory.here.copy_from(&memory.other);
        Continue(())
    }

    /// The certificate of the iterate.
    fn ask(&mut self) -> Verdict {
        let Search { run, memory } = self;
        let bounds = run.problem.shape().bounds();
        memory.view.unscale(&memory.here.z, bounds, &mut run.work.current.z);
        let certificate = run.certify();
        certificate.verdict(run.options.tol, run.options.tol_relative)
    }

    /// Whether a variable has grown far and Newton's method would move it on, or equations contradict
    /// each other but for terms that have grown: the residual then vanishes only at infinity, as that of a
    /// KKT system without multipliers.
    fn still_moves(&mut self, e: f64) -> bool {
        let limit = GROWN[usize::from(e <= SHARP)];
        let Search { run, memory } = self;
        let bounds = run.problem.shape().bounds();
        memory.view.unscale(&memory.here.z, bounds, &mut memory.model_z);
        let growth = (0..memory.unit.len()).fold(0.0, |most: f64, j| most.max(memory.growth(j)));
        if self.is_far_from_solved() {
            return true;
        }
        if growth <= limit && e <= SHARP || !self.jacobian() {
            return false;
        }
        // In scales of its own, a matrix that is nearly singular is one in all units.
        self.measure_scales();
        if !self.undamped_min_map_direction() {
            let limit = (CONTRADICTION * self.run.options.tol_relative).max(SHARP);
            // So is every system with multipliers that are not unique.
            return self.memory.asymptotic && growth > FAR || self.near_residual(AT_START) > limit;
        }
        let memory = &*self.memory;
        (0..memory.unit.len()).any(|j| {
            memory.growth(j) > limit && memory.direction[j].abs() > MOVING * memory.here.z[j].abs()
        })
    }
}

impl Search<'_, '_> {
    /// Whether the point last judged, `model_z`, is far away, and small residuals are due to that.
    pub(super) fn is_far_from_solved(&mut self) -> bool {
        let memory = &*self.memory;
        (0..memory.unit.len()).any(|j| memory.growth(j) > FAR)
            && self.near_residual(NEAR) > self.run.options.tol_relative
    }

    /// The relative residual at the point last judged, with terms no larger than where no variable has
    /// grown by more than the factor `near`. Along a null curve of `F` terms grow and `F` stays what it was:
    /// small relative to its terms, and no smaller than at the start.
    fn near_residual(&mut self, near: f64) -> f64 {
        let Search { run, memory } = self;
        let jac = run.work.certifier.spare();
        for j in 0..memory.weight.len() {
            let own = memory.own(j);
            memory.slope[j] = memory.model_z[j].clamp(-near * own, near * own);
            memory.weight[j] = memory.slope[j].abs() + own;
        }
        run.problem.shape().bounds().project(&mut memory.slope);
        for z in [&memory.slope, &memory.model_z] {
            run.stats.jacobian_evaluations += 1;
            run.problem.evaluate(z, None, Some(jac));
            if jac.iter().all(|entry| entry.is_finite()) {
                break;
            }
        }
        memory.size.fill(0.0);
        run.problem.pattern().add_sizes(jac, |j| memory.weight[j], &mut memory.size);
        let (z, f, bounds) =
            (&memory.model_z, run.work.certifier.f(), run.problem.shape().bounds());
        memory.largest_residual(z, f, (bounds.lower(), bounds.upper()))
    }
}

impl Memory {
    /// `max_i |mid((z_i − l_i)/w_i, F_i/s_i, (z_i − u_i)/w_i)|` with the weights and sizes at hand.
    fn largest_residual(&self, z: &[f64], f: &[f64], (l, u): (&[f64], &[f64])) -> f64 {
        (0..z.len()).fold(0.0, |worst: f64, i| {
            let (w, s) = (self.weight[i], self.size[i]);
            let ratio = if f[i] == 0.0 { 0.0 } else { f[i] / s.min(f64::MAX) };
            let middle = ((z[i] - l[i]) / w).min(((z[i] - u[i]) / w).max(ratio)).abs();
            if middle <= worst { worst } else { middle }
        })
    }

    /// The size of a variable at the start, or the unit of the first scales where it starts at 0.
    fn own(&self, j: usize) -> f64 {
        match self.start[j].abs() {
            0.0 => self.unit[j],
            start => start,
        }
    }

    /// `|z_j|` in `model_z`, relative to the start or to the unit of the first scales.
    fn growth(&self, j: usize) -> f64 {
        self.model_z[j].abs() / self.start[j].abs().max(self.unit[j])
    }
}

/// `τ`: the geometric mean of `max(|y_j|, 2⁻¹³ |y⁰_j|)` over the entries that are not 0, in binary
/// exponents; 1 if all are.
fn gauge(y: &[f64], start: &[f64]) -> f64 {
    let (mut sum, mut count) = (0_i64, 0_i64);
    for (y, start) in y.iter().zip(start) {
        let of = |x: f64, floor: i32| (x != 0.0).then(|| exponent(x) - floor);
        if let Some(exponent) = of(*y, 0).max(of(*start, FLOOR)) {
            sum += i64::from(exponent);
            count += 1;
        }
    }
    if count == 0 {
        return 1.0;
    }
    power_of_two(i32::try_from(sum.div_euclid(count)).expect("a mean of exponents is one"))
}
