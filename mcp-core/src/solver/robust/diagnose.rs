//! Why the cascade failed: told at the best point.

use super::Search;
use super::equilibrate::power_of_two;
use super::far::AT_START;
use super::judge::FLOOR;
use super::map::Map;
use super::memory::Memory;
use crate::solver::certificate::{Certificate, Verdict};
use crate::solver::diagnosis::{Diagnosis, SHOWN, STATIONARY, entries_by_size, largest_entries};
use crate::solver::run::Fault;
use crate::solver::stage::{Stage, StageEnd, StageRecord};
use crate::solver::status::Status;
use std::ops::ControlFlow::Continue;

/// Relative residuals of a point that is clearly no solution, and of one that may be.
const CLEARLY: f64 = 1e-2;
const NEARLY: f64 = 1e-6;
/// `‖H v‖∞` of a null vector `v` with largest entry 1, relative to `√(‖H‖₁ ‖H‖∞)`.
const NULL: f64 = 1e-9;

impl Search<'_, '_> {
    /// The status of a solve that no stage has ended.
    pub(super) fn diagnose(&mut self) -> Status {
        let is_last = |record: &StageRecord| record.stage == Stage::Backtracking;
        let end =
            self.memory.records.last().filter(|record| is_last(record)).map(|record| record.end);
        if self.memory.asymptotic {
            return self.at_infinity();
        }
        if end.is_some() {
            self.keep_stuck();
            if self.is_solved_but_for_growth() {
                self.memory.answer_stuck();
                return self.at_infinity();
            }
        }
        self.go_to_best();
        if !(self.evaluate_here() && self.jacobian()) {
            return Status::DomainError;
        }
        if self.is_solved_but_for_growth() {
            return self.at_infinity();
        }
        self.memory.linearise(self.run.problem.pattern());
        let gradient = self.relative_gradient();
        if let Some(diagnosis) = self.null_vector() {
            self.run.work.diagnosis = Some(diagnosis);
            return Status::SingularSystem;
        }
        let has_diverged = |record: &StageRecord| record.end == StageEnd::Diverged;
        if self.memory.records.iter().any(has_diverged) {
            let growing = largest_entries(&self.memory.runaway);
            self.run.work.diagnosis = Some(Diagnosis::Diverged { growing });
            return Status::Diverged;
        }
        if gradient > STATIONARY
            && self.memory.best_residual > CLEARLY
            && end == Some(StageEnd::NoStep)
            && self.is_stationary_where_stuck()
        {
            return Status::StationaryPoint;
        }
        let worst = self.worst_equations();
        self.run.work.diagnosis = Some(Diagnosis::Stationary { worst, gradient });
        if gradient <= STATIONARY { Status::StationaryPoint } else { Status::Stalled }
    }

    /// Whether Newton alone got stuck at a stationary point, which then counts as the best: where the gradient
    /// vanishes.
    fn is_stationary_where_stuck(&mut self) -> bool {
        self.memory.go_to_stuck();
        if !(self.evaluate_here() && self.jacobian()) {
            return false;
        }
        self.memory.linearise(self.run.problem.pattern());
        let gradient = self.relative_gradient();
        if gradient <= STATIONARY {
            let worst = self.worst_equations();
            self.run.work.diagnosis = Some(Diagnosis::Stationary { worst, gradient });
            self.memory.answer_stuck();
        }
        gradient <= STATIONARY
    }

    /// The best point seen becomes the answer, whatever ended the solve.
    pub(super) fn conclude(&mut self, status: Status) -> Status {
        if status == Status::Solved {
            return status;
        }
        if self.memory.best_residual < f64::INFINITY {
            if status == Status::Interrupted {
                self.answer_best();
                return status;
            }
            if let Some(status) = self.look_at_best() {
                return status;
            }
            if matches!(status, Status::IterationLimit | Status::TimeLimit) {
                let worst = self.worst_at_best();
                self.run.work.diagnosis = Some(Diagnosis::Unfinished { worst });
            }
        }
        match status {
            Status::IterationLimit if self.memory.asymptotic => self.at_infinity(),
            status => status,
        }
    }

    /// What the best point turns out to be, where its residuals are small after all. Unless it is a solution it
    /// is the one judged last.
    fn look_at_best(&mut self) -> Option<Status> {
        self.go_to_best();
        let mut verdict = self.ask();
        if verdict == Verdict::Accepted {
            verdict = Verdict::Refused;
            if self.evaluate_here()
                && let Continue(found) = self.look_ahead()
            {
                verdict = found;
            }
            if verdict == Verdict::Accepted {
                return Some(Status::Solved);
            }
        }
        let certificate = self.answer_best();
        if verdict == Verdict::Asymptotic {
            return Some(self.at_infinity());
        }
        let run = &mut *self.run;
        let is_small = certificate.relative_residual <= run.options.tol_relative;
        if is_small
            && !certificate.is_finite
            && let Some((equation, value, z)) = run.work.certifier.infinite_on_bounds()
        {
            run.fault = Some(Fault { equation, variable: None, value });
            run.work.fault_point.copy_from_slice(z);
            run.work.diagnosis = None;
            return Some(Status::DomainError);
        }
        None
    }

    /// The best point becomes the answer; its certificate.
    fn answer_best(&mut self) -> Certificate {
        let Search { run, memory } = self;
        run.work.current.z.copy_from_slice(&memory.best);
        memory.model_z.copy_from_slice(&memory.best);
        run.certify()
    }

    /// Whether a variable has grown, and the residuals of the iterate are small in terms near the start.
    fn is_solved_but_for_growth(&mut self) -> bool {
        self.near_residual(AT_START) <= self.run.options.tol_relative
            && (0..self.memory.unit.len()).any(|j| self.memory.growth(j) > 1.0)
            && self.relative_residual() > NEARLY
    }

    /// Solved at infinity, with the variables that grow.
    fn at_infinity(&mut self) -> Status {
        let Search { run, memory } = self;
        let grown =
            |best: f64, start: f64| if best.abs() > start.abs() { best - start } else { 0.0 };
        let way = memory.best.iter().zip(&memory.start).map(|(best, start)| grown(*best, *start));
        let growing = largest_entries(&way.collect::<Vec<_>>());
        run.work.diagnosis = Some(Diagnosis::Diverged { growing });
        Status::SolvedAsymptotically
    }

    /// Equations in the order of their relative residuals at the best point, which was judged last.
    fn worst_at_best(&self) -> Vec<usize> {
        let (shape, judge) = (self.run.problem.shape(), &self.run.work.certifier);
        let z = &self.memory.model_z;
        let residual = |i: usize| judge.relative_residual(shape, z, i);
        let mut order: Vec<usize> = (0..z.len()).filter(|&i| residual(i) > 0.0).collect();
        order.sort_by(|&i, &j| residual(j).total_cmp(&residual(i)));
        order.truncate(SHOWN);
        order
    }

    fn go_to_best(&mut self) {
        let memory = &mut *self.memory;
        memory.map = Map::FischerBurmeister;
        memory.view.scale(&memory.best, &mut memory.here.z);
    }

    /// `‖∇θ‖∞` over the box, relative to the terms it is summed from, or the share of `2θ` that a change of a
    /// variable by itself, or by `2⁻¹³` of its start, makes, whichever is less.
    fn relative_gradient(&self) -> f64 {
        let memory = &*self.memory;
        let pattern = self.run.problem.pattern();
        // Relative to the largest, squares of `Φ` do not overflow.
        let unit = memory.here.phi.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
        let phi = |i: usize| memory.here.phi[i] / unit;
        let (mut largest, mut terms, mut change) = (0.0_f64, 0.0_f64, 0.0_f64);
        for j in 0..memory.gradient.len() {
            let own = memory.a[j] * phi(j);
            let (mut g, mut sum) = (own, own.abs());
            for k in pattern.column(j) {
                let i = pattern.row(k);
                let term = memory.b[i] * memory.jac[k] * phi(i);
                g += term;
                sum += term.abs();
            }
            let y = memory.here.z[j];
            // At a bound the gradient may point out of the box.
            let is_blocked =
                y <= memory.view.lower[j] && g > 0.0 || y >= memory.view.upper[j] && g < 0.0;
            if !is_blocked {
                largest = largest.max(g.abs());
                let own = power_of_two(-FLOOR) * memory.own(j) / memory.view.units()[j];
                change = change.max(g.abs() * y.abs().max(own));
            }
            terms = terms.max(sum);
        }
        let square: f64 = (0..memory.gradient.len()).map(|i| phi(i) * phi(i)).sum();
        if terms > 0.0 { (largest / terms).min(change / square / unit) } else { 0.0 }
    }

    /// Equations in the order of `|Φ|`, the largest first.
    fn worst_equations(&self) -> Vec<usize> {
        let phi = &self.memory.here.phi;
        let mut order: Vec<usize> = (0..phi.len()).filter(|&i| phi[i] != 0.0).collect();
        order.sort_by(|&i, &j| phi[j].abs().total_cmp(&phi[i].abs()));
        order.truncate(SHOWN);
        order
    }

    /// The null vector of the Newton system, if there is one.
    fn null_vector(&mut self) -> Option<Diagnosis> {
        if !self.null_direction() {
            return None;
        }
        let memory = &mut *self.memory;
        let pattern = self.run.problem.pattern();
        memory.zeta.copy_from_slice(&memory.direction);
        memory.multiply(pattern);
        let largest = memory.slope.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let norm = memory.squared_norm_bound(pattern).sqrt();
        if !(largest <= NULL * norm.max(f64::MIN_POSITIVE)) {
            return None;
        }
        let ratio = |&(j, v): &(usize, f64)| v / memory.here.z[j];
        let mut entries = entries_by_size(&memory.direction);
        let first = entries.first().map_or(0.0, ratio);
        let is_positive = entries.first().is_some_and(|(_, v)| *v > 0.0);
        let is_homogeneous = entries.len() > 1
            && entries.iter().all(|(_, v)| (*v > 0.0) == is_positive)
            && entries.iter().all(|entry| (ratio(entry) / first - 1.0).abs() < 1e-3);
        entries.truncate(SHOWN);
        let mut direction = vec![0.0; pattern.n()];
        memory.view.unscale_direction(&memory.direction, &mut direction);
        for (j, value) in &mut entries {
            *value = direction[*j];
        }
        Some(Diagnosis::Singular { null_vector: entries, is_homogeneous })
    }
}

impl Memory {
    /// The point where Newton got stuck becomes the answer.
    fn answer_stuck(&mut self) {
        self.best.copy_from_slice(&self.stuck);
    }
}
