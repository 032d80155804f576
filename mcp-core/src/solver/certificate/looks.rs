//! Second looks of the certificate at a point that might be accepted.

use super::{Certifier, all_finite};
use crate::model::Shape;
use crate::problem::Problem;

/// Growth from which rounding in a sum of terms is more than the default of `tol_relative` of its
/// terms at the start: `2²⁶`.
const GROWN: f64 = 67_108_864.0;
/// Share of `w` beside the point where slopes are measured again: the default of `tol_relative`.
const BESIDE: f64 = 1e-8;
/// Share of the terms of an equation that a variable on its way to infinity has left of it.
const FADED: f64 = 1e-5;
/// Residual, relative to that term, of a point that still moves: `e^(−z²)` at 12.
const MOVING: f64 = 3e-3;
/// What of it is left twice as far: `z^-p` with `p > 0.4`.
const FADING: f64 = 0.75;
/// Variables that are looked at twice as far.
const CANDIDATES: usize = 8;

impl Certifier {
    /// A variable that has grown far although no equation with it sees anything but its own terms.
    pub(super) fn lost_constants(&mut self, problem: &dyn Problem, z: &[f64]) -> Option<usize> {
        let (shape, pattern) = (problem.shape(), problem.pattern());
        let has_grown = |j: &usize| z[*j].abs() > GROWN * shape.start()[*j].abs().max(1.0);
        let first = (0..z.len()).find(has_grown)?;
        // What is left of `F` without the terms that have grown, and which equations are asked for it.
        let (constant, bounds) = (&mut self.beside, shape.bounds());
        constant.copy_from_slice(&self.f);
        self.f_beside.fill(0.0);
        for j in (0..z.len()).filter(has_grown) {
            for k in pattern.column(j).filter(|&k| self.jac[k] != 0.0) {
                let i = pattern.row(k);
                constant[i] -= self.jac[k] * z[j];
                if self.sizes.must_hold(bounds, i, z[i], self.f[i]) {
                    self.f_beside[i] = 1.0;
                }
            }
        }
        let mut asked = (0..z.len()).filter(|&i| self.f_beside[i] > 0.0).peekable();
        asked.peek()?;
        let is_lost = |i: usize| constant[i].abs() <= 8.0 * f64::EPSILON * self.sizes.of_row[i];
        asked.all(is_lost).then_some(first)
    }

    /// A variable beyond its start and between its bounds whose terms have become small beside the others in all
    /// equations that must hold, although not beside the residual of the one where it is largest; and that
    /// residual becomes less where the variable is twice as far.
    pub(super) fn fading_variable(
        &mut self,
        problem: &mut dyn Problem,
        z: &[f64],
    ) -> Option<usize> {
        let mut looks = 0;
        for j in 0..z.len() {
            let Some(place) = self.fading_in(problem, z, j) else {
                continue;
            };
            if self.fades_on(problem, z, j, place) {
                return Some(j);
            }
            looks += 1;
            if looks == CANDIDATES {
                break;
            }
        }
        None
    }

    /// The equation where a variable is largest and its term, if that is small there, although not beside the
    /// residual.
    fn fading_in(&self, problem: &dyn Problem, z: &[f64], j: usize) -> Option<(usize, f64)> {
        let (shape, pattern) = (problem.shape(), problem.pattern());
        let must_hold = |i: usize| self.sizes.must_hold(shape.bounds(), i, z[i], self.f[i]);
        if !(has_grown(shape, z, j) && must_hold(j)) {
            return None;
        }
        let terms = pattern.column(j).map(|k| (pattern.row(k), (self.jac[k] * z[j]).abs()));
        let shares = terms
            .filter(|&(i, _)| must_hold(i))
            .map(|(i, term)| (term / self.sizes.of_row[i], i, term));
        let (share, i, term) = shares.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let is_small = 0.0 < share && share <= FADED && self.f[i].abs() >= MOVING * term;
        is_small.then_some((i, term))
    }

    /// Whether `F_i`, with variables put onto the bounds they belong to, is no less a share of the term, keeps its
    /// sign and shrinks where `z_j` is twice as large.
    fn fades_on(
        &mut self,
        problem: &mut dyn Problem,
        z: &[f64],
        j: usize,
        (i, term): (usize, f64),
    ) -> bool {
        self.put_onto_bounds(problem, z);
        problem.evaluate(&self.beside, Some(&mut self.f_beside), None);
        let here = self.f_beside[i];
        self.beside[j] *= 2.0;
        problem.shape().bounds().project(&mut self.beside);
        problem.evaluate(&self.beside, Some(&mut self.f_beside), None);
        let is_twice = self.beside[j] == 2.0 * z[j];
        let left = self.f_beside[i] / here;
        is_twice && here.abs() >= MOVING * term && (0.0..=FADING).contains(&left)
    }

    /// Whether an equation that must hold does so only by what `k` adds to its size.
    pub(super) fn leans_on_known(&mut self, problem: &dyn Problem, z: &[f64]) -> bool {
        let Certifier { f, jac, sizes, beside: own, .. } = self;
        own.fill(0.0);
        problem.pattern().add_sizes(jac, |j| z[j].abs(), own);
        let bounds = problem.shape().bounds();
        (0..z.len()).any(|i| f[i].abs() > BESIDE * own[i] && sizes.must_hold(bounds, i, z[i], f[i]))
    }

    /// Whether all derivatives by a variable between its bounds are zero or subnormal, or the variable is beyond
    /// its start and lost in the rounding of all equations.
    pub(super) fn has_free_variable(&self, problem: &dyn Problem, z: &[f64]) -> bool {
        let (pattern, bounds) = (problem.pattern(), problem.shape().bounds());
        let is_lost = |k: usize, j: usize| {
            let (slope, size) = (self.jac[k].abs(), self.sizes.of_row[pattern.row(k)]);
            let is_rounded = slope * z[j].abs() < f64::EPSILON * size;
            slope < f64::MIN_POSITIVE || is_rounded && has_grown(problem.shape(), z, j)
        };
        let is_free = |j: usize| pattern.column(j).all(|k| is_lost(k, j));
        (0..z.len()).any(|j| is_free(j) && self.sizes.must_hold(bounds, j, z[j], self.f[j]))
    }

    /// Rows are no larger than with the slopes at `z ± 10⁻⁸ w`; a slope that is not finite there on
    /// either side counts as none.
    pub(super) fn look_beside(&mut self, problem: &mut dyn Problem, z: &[f64]) {
        for sign in [1.0, -1.0] {
            let bounds = problem.shape().bounds();
            for j in 0..z.len() {
                let step = BESIDE * self.sizes.weight[j];
                let [first, second] = [z[j] + sign * step, z[j] - sign * step];
                let fits = |x: f64| bounds.lower()[j] <= x && x <= bounds.upper()[j];
                self.beside[j] = if fits(first) || !fits(second) { first } else { second };
            }
            bounds.project(&mut self.beside);
            problem.evaluate(&self.beside, None, Some(&mut self.jac));
            if all_finite(&self.jac) {
                break;
            }
        }
        self.sizes.lessen(problem.pattern(), &self.jac, &mut self.f_beside);
        problem.evaluate(z, None, Some(&mut self.jac));
        self.forgive(problem, z);
    }

    /// Whether `F` is infinite where variables that belong onto a bound are put there. Where it is NaN,
    /// as `z ln z` at 0, it may have a limit.
    pub(super) fn is_infinite_on_bounds(&mut self, problem: &mut dyn Problem, z: &[f64]) -> bool {
        let is_moved = self.put_onto_bounds(problem, z);
        if is_moved {
            problem.evaluate(&self.beside, Some(&mut self.f_beside), None);
        }
        is_moved && self.f_beside.iter().any(|f| f.is_infinite())
    }

    /// The point with variables on the bounds they belong to; whether it is another one.
    fn put_onto_bounds(&mut self, problem: &dyn Problem, z: &[f64]) -> bool {
        let bounds = problem.shape().bounds();
        let mut is_moved = false;
        for i in 0..z.len() {
            let (l, u, f) = (bounds.lower()[i], bounds.upper()[i], self.f[i]);
            self.beside[i] = match () {
                () if z[i] - l <= f => l,
                () if z[i] - u >= f => u,
                () => z[i],
            };
            is_moved |= self.beside[i] != z[i];
        }
        is_moved
    }
}

/// Whether a variable is beyond its start, or 1 if that is 0.
fn has_grown(shape: &Shape, z: &[f64], j: usize) -> bool {
    let start = shape.start()[j].abs();
    z[j].abs() > if start > 0.0 { start } else { 1.0 }
}
