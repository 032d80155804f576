//! What counts as small: the sizes `w_j` of variables and `s_i` of equations.

use crate::model::{Bounds, Shape};
use crate::problem::Pattern;
use crate::solver::workspace::resize;

/// Share of its start below which a variable counts as that large: `2⁻¹³`, about `10⁻⁴`.
const FLOOR: f64 = 1.0 / 8192.0;
/// What a variable that starts at 0 counts as where nothing else tells its size: `2⁻²⁰`, about `10⁻⁶`.
const ZERO_FLOOR: f64 = 1.0 / 1_048_576.0;

/// Workspace and result.
#[derive(Clone, Debug, Default)]
pub(super) struct Sizes {
    /// `k_j`, the level of a variable, or what is known of its size where that is more.
    known: Vec<f64>,
    /// `w_j`.
    pub(super) weight: Vec<f64>,
    /// `s_i`.
    pub(super) of_row: Vec<f64>,
}

impl Sizes {
    pub(super) fn resize(&mut self, n: usize) {
        for list in [&mut self.known, &mut self.weight, &mut self.of_row] {
            resize(list, n);
        }
    }

    /// The sizes at `z`, with finite `J`.
    pub(super) fn measure(&mut self, shape: &Shape, pattern: &Pattern, z: &[f64], jac: &[f64]) {
        self.know(pattern, shape.start(), z, jac);
        add_terms(pattern, jac, &self.known, &mut self.of_row);
        self.weigh(shape, pattern, z, jac);
    }

    /// `k_j = max(|z_j|, 2⁻¹³ |z_j⁰|)`. For a start of 0 a size `s_i / |J_ij|` stands for it, with `s_i` over
    /// the variables that do not start there: of several the one nearest to 1. An equation of variables
    /// that all start at 0 says `2⁻⁷`.
    fn know(&mut self, pattern: &Pattern, start: &[f64], z: &[f64], jac: &[f64]) {
        let floor = |j: usize| FLOOR * start[j].abs();
        for j in 0..z.len() {
            self.known[j] = if floor(j) > 0.0 { z[j].abs().max(floor(j)) } else { 0.0 };
        }
        if self.known.iter().all(|k| *k > 0.0) {
            return;
        }
        add_terms(pattern, jac, &self.known, &mut self.of_row);
        for j in 0..z.len() {
            if self.known[j] == 0.0 {
                let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
                for k in pattern.column(j).filter(|&k| counts(jac[k])) {
                    let size = self.of_row[pattern.row(k)];
                    let ratio = if size > 0.0 { size / jac[k].abs() } else { ZERO_FLOOR / FLOOR };
                    (least, most) = (least.min(ratio), most.max(ratio));
                }
                let floor =
                    if least <= most { FLOOR * least.max(most.min(1.0)) } else { ZERO_FLOOR };
                self.known[j] = z[j].abs().max(floor.min(f64::MAX));
            }
        }
    }

    /// `w_j = max(k_j, min_i s_i / |J_ij|)`, but no more than the width of the box, unless `|z_j|` is, and than
    /// the start (or 1), unless that is 0.
    fn weigh(&mut self, shape: &Shape, pattern: &Pattern, z: &[f64], jac: &[f64]) {
        let bounds = shape.bounds();
        for j in 0..z.len() {
            let ratio = |k: usize| self.of_row[pattern.row(k)] / jac[k].abs();
            let matters = pattern.column(j).filter(|&k| counts(jac[k])).map(ratio);
            let start = shape.start()[j].abs();
            let most = if start > 0.0 { start.max(1.0) } else { f64::MAX };
            let least = matters.fold(f64::INFINITY, f64::min);
            let own = self.known[j].max(if least < f64::INFINITY { least.min(most) } else { 0.0 });
            let width = bounds.upper()[j] - bounds.lower()[j];
            // Nothing can be resolved in a box of subnormal width.
            let is_box = width >= f64::MIN_POSITIVE;
            self.weight[j] = if is_box { own.min(width.max(z[j].abs())) } else { own };
        }
    }

    /// `(z_i − l_i)/w_i`, `F_i/s_i` and `(z_i − u_i)/w_i`.
    pub(super) fn relative(&self, bounds: &Bounds, i: usize, z: f64, f: f64) -> [f64; 3] {
        let (w, s) = (self.weight[i], self.of_row[i]);
        // A size that has overflowed must not make the residual 0.
        let f = if f == 0.0 { 0.0 } else { f / s.min(f64::MAX) };
        [(z - bounds.lower()[i]) / w, f, (z - bounds.upper()[i]) / w]
    }

    /// Whether `F_i = 0` is asked for: `F_i` is nearer to 0 than `z_i` to the bound on its side.
    pub(super) fn must_hold(&self, bounds: &Bounds, i: usize, z: f64, f: f64) -> bool {
        let [above, f, below] = self.relative(bounds, i, z, f);
        above > f && below < f
    }

    /// Rows are no larger than with other slopes; `other` is for the sizes with them.
    pub(super) fn lessen(&mut self, pattern: &Pattern, jac: &[f64], other: &mut [f64]) {
        add_terms(pattern, jac, &self.known, other);
        for (size, other) in self.of_row.iter_mut().zip(other) {
            *size = size.min(*other);
        }
    }
}

/// Subnormal derivatives count as zero: no solver can divide by them; so do those that are not finite.
fn counts(derivative: f64) -> bool {
    (f64::MIN_POSITIVE..=f64::MAX).contains(&derivative.abs())
}

/// `s_i = Σ_j |J_ij| k_j`.
fn add_terms(pattern: &Pattern, jac: &[f64], known: &[f64], of_row: &mut [f64]) {
    of_row.fill(0.0);
    for j in 0..pattern.n() {
        for k in pattern.column(j) {
            if counts(jac[k]) {
                of_row[pattern.row(k)] += jac[k].abs() * known[j];
            }
        }
    }
}
