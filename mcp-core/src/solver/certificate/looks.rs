//! Second looks of the certificate at a point that might be accepted.

use super::{Certifier, all_finite};
use crate::problem::Problem;

/// Growth from which rounding in a sum of terms is more than the default of `tol_relative` of its
/// terms at the start: `2²⁶`.
const GROWN: f64 = 67_108_864.0;
/// Share of `w` beside the point where slopes are measured again: the default of `tol_relative`.
const BESIDE: f64 = 1e-8;
/// Share of the terms of an equation that a variable on its way to infinity has left of it.
const FADED: f64 = 1e-5;
/// Residual, relative to the term of the only variable that matters, of a point that still moves: `e^(−z²)` at 13.
const MOVING: f64 = 3e-3;

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

    /// A variable that has grown and whose terms have become small beside the others in all equations, although
    /// not beside the residuals.
    pub(super) fn fading_variable(&self, problem: &dyn Problem, z: &[f64]) -> Option<usize> {
        let (shape, pattern) = (problem.shape(), problem.pattern());
        let must_hold = |i: usize| self.sizes.must_hold(shape.bounds(), i, z[i], self.f[i]);
        let fades = |&j: &usize| {
            let terms = pattern.column(j).map(|k| (pattern.row(k), (self.jac[k] * z[j]).abs()));
            let seen = terms
                .filter(|&(i, _)| must_hold(i))
                .map(|(i, term)| (term / self.sizes.of_row[i], self.f[i].abs() / term));
            let (share, residual) =
                seen.fold((0.0, 0.0), |most, own| if own.0 > most.0 { own } else { most });
            0.0 < share && share <= FADED && residual >= MOVING
        };
        let has_grown = |j: &usize| z[*j].abs() > shape.start()[*j].abs().max(1.0);
        (0..z.len()).find(|j| has_grown(j) && must_hold(*j) && fades(j))
    }

    /// Whether an equation that must hold does so only by what `k` adds to its size.
    pub(super) fn leans_on_known(&mut self, problem: &dyn Problem, z: &[f64]) -> bool {
        let Certifier { f, jac, sizes, beside: own, .. } = self;
        own.fill(0.0);
        problem.pattern().add_sizes(jac, |j| z[j].abs(), own);
        let bounds = problem.shape().bounds();
        (0..z.len()).any(|i| f[i].abs() > BESIDE * own[i] && sizes.must_hold(bounds, i, z[i], f[i]))
    }

    /// Whether all derivatives by a variable between its bounds are zero or subnormal.
    pub(super) fn has_free_variable(&self, problem: &dyn Problem, z: &[f64]) -> bool {
        let (pattern, bounds) = (problem.pattern(), problem.shape().bounds());
        let is_free = |j| pattern.column(j).all(|k| self.jac[k].abs() < f64::MIN_POSITIVE);
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
        if is_moved {
            problem.evaluate(&self.beside, Some(&mut self.f_beside), None);
        }
        is_moved && self.f_beside.iter().any(|f| f.is_infinite())
    }
}
