//! Other starts: perturbed ones, the same every time.
//!
//! From another start [pivoting](crate::solver::pivot) takes another path, which is what solves affine
//! problems without monotonicity; Newton from there is only a look, since smoothing does more.

use super::Search;
use super::map::Map;
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::Continue;

/// Sizes of the perturbations, relative to `1 + |y⁰|` in scaled units.
const SIZES: [f64; 3] = [0.1, 1.0, 10.0];
/// Linearisations solved by pivoting, and Newton steps, from one perturbed start.
const PIVOTED: usize = 3;
const LOOK: usize = 20;
/// Steps of the crash from one start.
pub(super) const CRASH: usize = 20;

impl Search<'_, '_> {
    /// Crash, Josephy–Newton, Newton and smoothing from `budget` perturbed starts.
    pub(super) fn starts(&mut self, budget: usize) -> Flow<StageEnd> {
        let robust = self.run.options.robust;
        let mut numbers = Numbers(0);
        for k in 0..budget {
            let size = SIZES[k % SIZES.len()];
            // First to one side, then to both.
            let is_one_sided = (k / SIZES.len()).is_multiple_of(2);
            let memory = &mut *self.memory;
            memory.go_to_start();
            for y in &mut memory.here.z {
                let number = numbers.next();
                let noise = if is_one_sided { number } else { 3.0 * (2.0 * number - 1.0) };
                *y += size * (1.0 + y.abs()) * noise;
            }
            memory.view.project(&mut memory.here.z);
            if !self.restart()? {
                continue;
            }
            self.keep_stuck();
            self.crash(CRASH)?;
            self.josephy(PIVOTED.min(robust.josephy))?;
            self.newton_on(Map::FischerBurmeister, LOOK)?;
            self.memory.go_to_stuck();
            if robust.smoothing > 0 && self.restart()? {
                self.smoothing_and_newton(robust.smoothing)?;
            }
        }
        Continue(StageEnd::Budget)
    }
}

/// Numbers in `[0, 1)` that look random: `SplitMix64` ([SLF14](crate#references)).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ x >> 31) >> 11) as f64 / (1_u64 << 53) as f64
    }
}
