//! Systems with `H = diag(a) + diag(b) J` that several stages solve, and products with it.

use super::Search;
use super::memory::Memory;
use crate::problem::Pattern;

/// Pivot ratio of a matrix that counts as singular.
const SINGULAR: f64 = 1e-15;

impl Search<'_, '_> {
    /// `H d = −r` with `r` in `rhs`; false where `H` is singular or `d` not finite.
    pub(super) fn undamped_direction(&mut self) -> bool {
        let Search { run, memory } = self;
        run.stats.factorisations += 1;
        let system = &mut run.work.system;
        let matrix = (&memory.a[..], &memory.b[..]);
        let spare = run.work.certifier.spare();
        let ratio = system.factor(&memory.jac, spare, matrix);
        if !ratio.is_some_and(|ratio| ratio > SINGULAR) {
            return false;
        }
        system.back_solve(&memory.jac, spare, matrix, &memory.rhs, &mut memory.direction);
        memory.direction.iter().all(|d| d.is_finite())
    }
}

impl Memory {
    /// `slope ← H d` with `d` in `zeta`.
    pub(super) fn multiply(&mut self, pattern: &Pattern) {
        self.slope.fill(0.0);
        for j in 0..pattern.n() {
            let d = self.zeta[j];
            self.slope[j] += self.a[j] * d;
            for k in pattern.column(j) {
                let i = pattern.row(k);
                self.slope[i] += self.b[i] * self.jac[k] * d;
            }
        }
    }
}
