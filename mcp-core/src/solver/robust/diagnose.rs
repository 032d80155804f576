//! Why the cascade failed: told at the best point.

use super::Search;
use super::map::Map;
use crate::solver::certificate::Verdict;
use crate::solver::diagnosis::{Diagnosis, SHOWN, STATIONARY, entries_by_size, largest_entries};
use crate::solver::stage::StageEnd;
use crate::solver::status::Status;

/// `‖H v‖∞` of a null vector `v` with largest entry 1, relative to `√(‖H‖₁ ‖H‖∞)`.
const NULL: f64 = 1e-9;

impl Search<'_, '_> {
    /// The status of a solve that no stage has ended.
    pub(super) fn diagnose(&mut self) -> Status {
        if self.memory.asymptotic {
            return Status::SolvedAsymptotically;
        }
        self.go_to_best();
        if !(self.evaluate_here() && self.jacobian()) {
            return Status::DomainError;
        }
        self.memory.linearise(self.run.problem.pattern());
        let gradient = self.relative_gradient();
        if let Some(diagnosis) = self.null_vector() {
            self.run.work.diagnosis = Some(diagnosis);
            return Status::SingularSystem;
        }
        let has_diverged = |record: &crate::solver::StageRecord| record.end == StageEnd::Diverged;
        if self.memory.records.iter().any(has_diverged) {
            let growing = largest_entries(&self.memory.runaway);
            self.run.work.diagnosis = Some(Diagnosis::Diverged { growing });
            return Status::Diverged;
        }
        let worst = self.worst_equations();
        self.run.work.diagnosis = Some(Diagnosis::Stationary { worst, gradient });
        if gradient <= STATIONARY { Status::StationaryPoint } else { Status::Stalled }
    }

    /// The best point seen becomes the answer, whatever ended the solve.
    pub(super) fn conclude(&mut self, status: Status) -> Status {
        let Search { run, memory } = self;
        if status == Status::Solved {
            return status;
        }
        if memory.best_residual < f64::INFINITY {
            run.work.current.z.copy_from_slice(&memory.best);
            memory.model_z.copy_from_slice(&memory.best);
            let (o, certificate) = (run.options, run.certify());
            if certificate.verdict(o.tol, o.tol_relative) == Verdict::Accepted
                && self.is_far_from_solved()
            {
                return Status::SolvedAsymptotically;
            }
            if matches!(status, Status::IterationLimit | Status::TimeLimit) {
                let worst = self.worst_at_best();
                self.run.work.diagnosis = Some(Diagnosis::Unfinished { worst });
            }
        }
        match status {
            Status::IterationLimit if self.memory.asymptotic => Status::SolvedAsymptotically,
            status => status,
        }
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

    /// `‖∇θ‖∞` over the box, relative to the terms it is summed from.
    fn relative_gradient(&self) -> f64 {
        let memory = &*self.memory;
        let pattern = self.run.problem.pattern();
        let (mut largest, mut terms) = (0.0_f64, 0.0_f64);
        for j in 0..memory.gradient.len() {
            let mut sum = (memory.a[j] * memory.here.phi[j]).abs();
            for k in pattern.column(j) {
                let i = pattern.row(k);
                sum += (memory.b[i] * memory.jac[k] * memory.here.phi[i]).abs();
            }
            let (y, g) = (memory.here.z[j], memory.gradient[j]);
            // At a bound the gradient may point out of the box.
            let is_blocked =
                y <= memory.view.lower[j] && g > 0.0 || y >= memory.view.upper[j] && g < 0.0;
            if !is_blocked {
                largest = largest.max(g.abs());
            }
            terms = terms.max(sum);
        }
        if terms > 0.0 { largest / terms } else { 0.0 }
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
