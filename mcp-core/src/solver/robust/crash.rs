//! Projected Newton: full min-map steps from the start, as long as they pay.
//!
//! ```text
//! d as in the tail;  t in {1, ½}:  ‖nat(P(y + t d))‖ <= (1 − 0.01 t) ‖nat(y)‖
//! nat(y) = mid(y − l, G(y), y − u)
//! ```
//!
//! After the crash procedure of [DF97](crate#references), which projects Newton steps of the
//! equations that seem to hold ([Ber82](crate#references)). One `J` and mostly one `F` a step; a
//! problem whose active set settles is solved here. Shorter steps are left to the stages after it.

use super::Search;
use crate::solver::monitor::Direction;
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::Continue;

/// Steps tried.
const STEPS: [f64; 2] = [1.0, 0.5];
/// Growth of the residual along a full step that suggests other scales there: as much as the
/// [drift](super::semismooth) of `J` that counts.
const JUMP: f64 = 1024.0;

impl Search<'_, '_> {
    /// At most `budget` steps from the iterate; `Drifted` where the last full step, not taken, leads to
    /// residuals of another size.
    pub(super) fn crash(&mut self, budget: usize) -> Flow<StageEnd> {
        for _ in 0..budget {
            self.begin()?;
            if !self.min_map_direction(1e-8) {
                return Continue(StageEnd::NoStep);
            }
            let norm = self.memory.view.natural_norm(&self.memory.here);
            let (mut taken, mut has_jumped) = (false, false);
            for t in STEPS {
                self.evaluate(t);
                let trial = self.memory.view.natural_norm(&self.memory.trial);
                // Both are false for NaN.
                has_jumped |= t == 1.0 && trial > JUMP * norm;
                if trial <= (1.0 - 0.01 * t) * norm && self.accept(Direction::MinMap, t)? {
                    taken = true;
                    break;
                }
            }
            if !taken {
                return Continue(if has_jumped { StageEnd::Drifted } else { StageEnd::NoStep });
            }
            if let Some(end) = self.memory.leave {
                return Continue(end);
            }
        }
        Continue(StageEnd::Budget)
    }
}
