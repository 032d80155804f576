//! [`Memory`]: what [`Search`](super::Search) works with, kept between solves.

use super::levenberg_marquardt::Damped;
use super::map::Map;
use super::view::View;
use crate::globalise::{Nonmonotone, Reference};
use crate::problem::Pattern;
use crate::solver::pivot::Basis;
use crate::solver::stage::{StageEnd, StageRecord};
use crate::solver::workspace::{Point, resize};

/// Stages that are recorded without allocating: more than the cascade has.
const RECORDS: usize = 64;

/// Vectors of one solve; `y` and `G` are in the scaled problem, `z` in the units of the model.
#[derive(Default)]
pub(in crate::solver) struct Memory {
    pub(super) view: View,
    /// The equations `Φ = 0` of the stage.
    pub(super) map: Map,
    /// `μ` of `F + μ (y − center)`, in the proximal stage.
    pub(super) proximal: Option<f64>,
    pub(super) center: Vec<f64>,
    /// The iterate, a trial point, and one more.
    pub(super) here: Point,
    pub(super) trial: Point,
    pub(super) other: Point,
    /// `J` at the iterate, or at the one before it.
    pub(super) jac: Vec<f64>,
    /// `H = diag(a) + diag(b) J` and `∇θ = HᵀΦ`.
    pub(super) a: Vec<f64>,
    pub(super) b: Vec<f64>,
    pub(super) gradient: Vec<f64>,
    pub(super) direction: Vec<f64>,
    pub(super) rhs: Vec<f64>,
    pub(super) zeta: Vec<f64>,
    pub(super) slope: Vec<f64>,
    /// `w_j` and `s_i` of the relative residual.
    pub(super) weight: Vec<f64>,
    pub(super) size: Vec<f64>,
    pub(super) reference: Reference,
    /// Start, best point and the point where Newton got stuck, in the units of the model.
    pub(super) start: Vec<f64>,
    pub(super) best: Vec<f64>,
    pub(super) stuck: Vec<f64>,
    pub(super) model_z: Vec<f64>,
    /// The start, scaled.
    pub(super) start_y: Vec<f64>,
    /// The way from the start to the point where a variable ran away last.
    pub(super) runaway: Vec<f64>,
    /// The units of the first scales.
    pub(super) unit: Vec<f64>,
    /// Mean exponent of the largest entries of rows when the scales were measured.
    pub(super) level_measured: i64,
    /// Relative residual of the best point.
    pub(super) best_residual: f64,
    /// Why the stage at hand has to be left.
    pub(super) leave: Option<StageEnd>,
    /// Whether a point was met that is a solution only at infinity; it is then the best one.
    pub(super) asymptotic: bool,
    /// Whether Newton led on to infinity from a point that the certificate accepts.
    pub(super) runs_on: bool,
    pub(super) damped: Option<Damped>,
    pub(super) basis: Option<Basis>,
    pub(in crate::solver) records: Vec<StageRecord>,
}

impl Memory {
    /// The iterate goes to the start of the solve.
    pub(super) fn go_to_start(&mut self) {
        self.view.scale(&self.start, &mut self.here.z);
    }

    /// The iterate goes where Newton got stuck.
    pub(super) fn go_to_stuck(&mut self) {
        self.view.scale(&self.stuck, &mut self.here.z);
    }

    /// Made ready for a new solve.
    pub(super) fn resize(&mut self, n: usize, nnz: usize, memory: usize) {
        self.view.resize(n);
        for point in [&mut self.here, &mut self.trial, &mut self.other] {
            point.resize(n);
        }
        for list in [
            &mut self.center,
            &mut self.a,
            &mut self.b,
            &mut self.gradient,
            &mut self.direction,
            &mut self.rhs,
            &mut self.zeta,
            &mut self.slope,
            &mut self.weight,
            &mut self.size,
            &mut self.start,
            &mut self.best,
            &mut self.stuck,
            &mut self.model_z,
            &mut self.start_y,
            &mut self.unit,
            &mut self.runaway,
        ] {
            resize(list, n);
        }
        resize(&mut self.jac, nnz);
        if !self.reference.remembers(Nonmonotone::Max, memory) {
            self.reference = Reference::new(Nonmonotone::Max, memory);
        }
        self.map = Map::FischerBurmeister;
        self.proximal = None;
        self.best_residual = f64::INFINITY;
        self.leave = None;
        self.asymptotic = false;
        self.runs_on = false;
        self.records.clear();
        self.records.reserve(RECORDS);
    }

    /// `a`, `b` and `∇θ` at the iterate, from its `J`: the element of the generalised derivative
    /// along `ζ` at kinks ([FP03](crate#references) p. 808), which smoothed maps do not have.
    pub(super) fn linearise(&mut self, pattern: &Pattern) {
        let Point { z, f, phi, .. } = &self.here;
        let mut has_kinks = false;
        for (i, row) in self.view.rows().enumerate() {
            (self.a[i], self.b[i]) = self.map.derivative(&row, z[i], f[i]);
            self.zeta[i] = 0.0;
            if !matches!(self.map, Map::Smoothed { .. })
                && let Some(direction) = row.kink(z[i], f[i], || 0.0)
            {
                (self.zeta[i], has_kinks) = (direction, true);
            }
        }
        if has_kinks {
            self.slope.fill(0.0);
            for j in (0..z.len()).filter(|&j| self.zeta[j] != 0.0) {
                for k in pattern.column(j) {
                    self.slope[pattern.row(k)] += self.jac[k] * self.zeta[j];
                }
            }
            let mu = self.proximal.unwrap_or(0.0);
            for (i, row) in self.view.rows().enumerate() {
                if self.zeta[i] != 0.0 {
                    let slope = self.slope[i] + mu * self.zeta[i];
                    (self.a[i], self.b[i]) = row.kink_derivative(self.zeta[i], slope);
                }
            }
        }
        // J + μ I: the diagonal goes to a.
        if let Some(mu) = self.proximal {
            for (a, b) in self.a.iter_mut().zip(&self.b) {
                *a += mu * b;
            }
        }
        for j in 0..z.len() {
            let mut sum = self.a[j] * phi[j];
            for k in pattern.column(j) {
                let i = pattern.row(k);
                sum += self.b[i] * self.jac[k] * phi[i];
            }
            self.gradient[j] = sum;
        }
    }
}
