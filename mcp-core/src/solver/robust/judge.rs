//! When a point is taken for a solution, asked of the certificate, and kept as the best.

use super::Search;
use super::equilibrate::{exponent, power_of_two};
use super::memory::Memory;
use crate::solver::certificate::Verdict;
use crate::solver::run::Flow;
use crate::solver::stage::{Stage, StageEnd};
use crate::solver::status::Status;
use crate::solver::workspace::Point;
use std::ops::ControlFlow::{Break, Continue};

/// Relative residual below which a point is polished and shown to the certificate.
const NEARLY: f64 = 1e-8;
/// Relative residual that no further step will reduce.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Relative residual of a point that should satisfy every tolerance that can be satisfied.
pub(super) const SHARP: f64 = 1e-13;
/// Growth beyond which a stage is left.
pub(super) const DIVERGED: f64 = 1e12;
/// How far below its start a variable may fall before its start counts: `2⁻¹³`.
pub(super) const FLOOR: i32 = 13;

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
        let mut verdict = self.ask();
        if verdict == Verdict::Accepted {
            verdict = self.look_ahead()?;
            if verdict == Verdict::Refused {
                // Newton goes on in the scales measured there.
                self.run.certificate = None;
                let is_crash = self.run.stage == Stage::Crash;
                let end = if is_crash { StageEnd::Stalled } else { StageEnd::Drifted };
                self.memory.leave = Some(end);
                return Continue(());
            }
        }
        if verdict == Verdict::Asymptotic {
            let Search { run, memory } = self;
            memory.runs_on |= run.certificate.is_some_and(|c| c.fading.is_some());
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
    pub(super) fn ask(&mut self) -> Verdict {
        let Search { run, memory } = self;
        let bounds = run.problem.shape().bounds();
        memory.view.unscale(&memory.here.z, bounds, &mut run.work.current.z);
        let certificate = run.certify();
        certificate.verdict(run.options.tol, run.options.tol_relative)
    }
}

impl Memory {
    /// `max_i |mid((z_i − l_i)/w_i, F_i/s_i, (z_i − u_i)/w_i)|` with the weights and sizes at hand.
    pub(super) fn largest_residual(&self, z: &[f64], f: &[f64], (l, u): (&[f64], &[f64])) -> f64 {
        (0..z.len()).fold(0.0, |worst: f64, i| {
            let (w, s) = (self.weight[i], self.size[i]);
            let ratio = if f[i] == 0.0 { 0.0 } else { f[i] / s.min(f64::MAX) };
            let middle = ((z[i] - l[i]) / w).min(((z[i] - u[i]) / w).max(ratio)).abs();
            if middle <= worst { worst } else { middle }
        })
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
