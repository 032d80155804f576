//! How far a point is from the start, and what of its small residuals is due to that.
//!
//! ```text
//! growth_j = |z_j| / max(|z_j⁰|, unit_j)
//! near     = max_i |mid((z_i − l_i)/w_i, F_i/s_i, (z_i − u_i)/w_i)|,  s_i = Σ_j |J_ij(ẑ)| w_j,
//!            ẑ_j = z_j clipped to ±k |z_j⁰|,  w_j = |ẑ_j| + |z_j⁰|
//! ```
//!
//! `unit` is the unit of the first scales, which stands for a start of 0. Cost: one `J`; for each of up to eight
//! variables that are lost in their equations one for each factor 2 of growth, and twelve if it is seen again.

use super::Search;
use super::memory::Memory;
use crate::ncp::Branch;

/// Growth beyond which a small residual may be due to terms that have grown with a variable.
pub(super) const FAR: f64 = 1e4;
/// Growth up to which terms are counted where a variable has grown beyond [`FAR`].
const NEAR: f64 = 100.0;
/// The same where the matrix is singular.
pub(super) const AT_START: f64 = 1.0;
/// Derivatives that are small in spite of the scales.
const SMALL: f64 = 1e-8;
/// Share of a variable in its equations that counts as none, and one that cannot come of rounding.
const LOST: f64 = f64::EPSILON;
const SEEN: f64 = 1e-8;
/// On the way back to where a lost variable is seen: what a step multiplies it by, and how often the last one is
/// halved.
const SHORTER: f64 = 0.5;
const BISECTIONS: usize = 12;
/// Lost variables that are looked at.
const CANDIDATES: usize = 8;

impl Search<'_, '_> {
    /// Whether the iterate is far away, and small residuals are due to that.
    pub(super) fn is_far_from_solved(&mut self) -> bool {
        let memory = &*self.memory;
        (0..memory.unit.len()).any(|j| memory.growth(j) > FAR)
            && self.near_residual(NEAR) > self.run.options.tol_relative
    }

    /// The relative residual of the iterate, with terms no larger than where no variable has
    /// grown by more than the factor `near`. Along a null curve of `F` terms grow and `F` stays what it was:
    /// small relative to its terms, and no smaller than at the start.
    pub(super) fn near_residual(&mut self, near: f64) -> f64 {
        let Search { run, memory } = self;
        let bounds = run.problem.shape().bounds();
        memory.view.unscale(&memory.here.z, bounds, &mut memory.model_z);
        memory.view.unscale_residual(&memory.here.f, &mut memory.zeta);
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
        let bounds = run.problem.shape().bounds();
        let (z, f) = (&memory.model_z, &memory.zeta);
        memory.largest_residual(z, f, (bounds.lower(), bounds.upper()))
    }

    /// Whether a variable is more than `times` what it was at the start.
    pub(super) fn has_grown(&self, times: f64) -> bool {
        let memory = &*self.memory;
        (0..memory.unit.len()).any(|j| memory.model_z[j].abs() > times * memory.own(j))
    }

    /// Whether variables that have grown far could as well have grown half as far, by terms near the start.
    pub(super) fn is_free_when_far(&mut self) -> bool {
        self.near_residual(NEAR);
        let Search { run, memory } = self;
        memory.slope.copy_from_slice(&memory.model_z);
        for j in 0..memory.unit.len() {
            if memory.growth(j) > FAR {
                memory.slope[j] *= 0.5;
            }
        }
        run.problem.shape().bounds().project(&mut memory.slope);
        run.stats.residual_evaluations += 1;
        run.problem.evaluate(&memory.slope, Some(&mut memory.zeta), None);
        let bounds = run.problem.shape().bounds();
        let sides = (bounds.lower(), bounds.upper());
        memory.largest_residual(&memory.slope, &memory.zeta, sides) <= run.options.tol_relative
    }

    /// Whether an equation that is taken to hold, or its variable, has derivatives so small that no scale has made
    /// them what others are.
    pub(super) fn is_beyond_scales(&mut self) -> bool {
        let pattern = self.run.problem.pattern();
        let memory = &mut *self.memory;
        memory.slope.fill(0.0);
        memory.zeta.fill(0.0);
        for (k, i, j) in pattern.entries() {
            let size = memory.jac[k].abs();
            memory.slope[i] = memory.slope[i].max(size);
            memory.zeta[j] = memory.zeta[j].max(size);
        }
        (0..memory.unit.len()).any(|i| {
            memory.slope[i].min(memory.zeta[i]) < SMALL
                && memory.view.natural(&memory.here, i).1 == Branch::Equation
        })
    }

    /// Whether a variable has grown and left all equations smoothly on its way, as `z` leaves `v = e^-z`, and not
    /// at a kink, as it leaves `v = max(0, 1 − z)`: on the way back its derivatives come into sight by degrees.
    pub(super) fn has_lost_a_variable(&mut self) -> bool {
        let n = self.memory.unit.len();
        self.memory.slope.copy_from_slice(&self.memory.model_z);
        self.slopes();
        let mut from = 0;
        for _ in 0..CANDIDATES {
            let Some(j) = (from..n).find(|&j| self.is_lost(j)) else {
                return false;
            };
            if self.left_smoothly(j) {
                return true;
            }
            from = j + 1;
            self.memory.slope.copy_from_slice(&self.memory.model_z);
            self.slopes();
        }
        false
    }

    /// Whether a variable has grown between its bounds and no equation sees it, with the slopes at the iterate.
    fn is_lost(&self, j: usize) -> bool {
        let memory = &*self.memory;
        memory.model_z[j].abs() > memory.own(j) && self.is_inside(j) && self.share(j) < LOST
    }

    /// Whether the derivatives of a lost variable come into sight by degrees on the way back to the start.
    fn left_smoothly(&mut self, j: usize) -> bool {
        let own = self.memory.own(j);
        let mut far = self.memory.model_z[j];
        let mut near = SHORTER * far;
        let mut share_at = |z: f64| {
            self.memory.slope[j] = z;
            self.run.problem.shape().bounds().project(&mut self.memory.slope);
            self.slopes();
            self.share(j)
        };
        while share_at(near) < LOST {
            if !(near.abs() > own) {
                return false;
            }
            (far, near) = (near, SHORTER * near);
        }
        for _ in 0..BISECTIONS {
            let between = 0.5 * (far + near);
            match share_at(between) {
                share if share < LOST => far = between,
                share if share < SEEN => return true,
                _ => near = between,
            }
        }
        false
    }

    /// `J` at the point in `slope`.
    fn slopes(&mut self) {
        let Search { run, memory } = self;
        run.stats.jacobian_evaluations += 1;
        run.problem.evaluate(&memory.slope, None, Some(run.work.certifier.spare()));
    }

    /// The largest share of `z_j` in the terms of an equation, with the slopes at the point in `slope`.
    fn share(&self, j: usize) -> f64 {
        let Search { run, memory } = self;
        let (jac, size) = (run.work.certifier.jac(), run.work.certifier.row_size());
        let pattern = run.problem.pattern();
        let z = memory.slope[j];
        pattern
            .column(j)
            .fold(0.0, |most: f64, k| most.max((jac[k] * z).abs() / size[pattern.row(k)]))
    }
}

impl Memory {
    /// The size of a variable at the start, or the unit of the first scales where it starts at 0.
    pub(super) fn own(&self, j: usize) -> f64 {
        match self.start[j].abs() {
            0.0 => self.unit[j],
            start => start,
        }
    }

    /// `|z_j|` in `model_z`, relative to the start or to the unit of the first scales.
    pub(super) fn growth(&self, j: usize) -> f64 {
        self.model_z[j].abs() / self.start[j].abs().max(self.unit[j])
    }
}
