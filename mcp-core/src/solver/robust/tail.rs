//! Min-map steps: active variables go exactly onto their bounds, the others solve `G_I = 0`.
//!
//! ```text
//! d_i = −(y_i − l_i)  where y_i − l_i <= G_i          d_i = −(y_i − u_i)  where y_i − u_i >= G_i
//! (J d)_i = −G_i      elsewhere
//! ```
//!
//! The step of [FP03](crate#references) minFBLSA. Near a solution it converges like Newton's method,
//! and is free of the cancellation of `φ`, so that it delivers the last digits.

use super::Search;
use crate::ncp::Branch;
use crate::solver::monitor::Direction;
use crate::solver::run::Flow;
use std::ops::ControlFlow::Continue;

/// Relative residual that rounding leaves.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Relative residual above which a new `J` is worth its cost.
const WORTHWHILE: f64 = 1e-13;
/// What a step must multiply the residual by to be followed by another with the same `J`.
const SUCCESS: f64 = 0.1;

impl Search<'_, '_> {
    /// Polishes the iterate, whose relative residual is `e`, and returns the residual reached. Steps
    /// use the last `J` known, a new one only where that does not suffice.
    pub(super) fn tail(&mut self, mut e: f64) -> Flow<f64> {
        let mut is_new = false;
        for _ in 0..self.run.options.robust.tail {
            if e <= ROUNDING || !self.min_map_direction(1e-16) {
                break;
            }
            let merit = self.evaluate(1.0);
            self.swap();
            let next = self.relative_residual();
            if !merit.is_nan() && next <= 0.5 * e {
                self.run.stats.iterations += 1;
                self.run.last = (Direction::MinMap, 1.0);
                let was_slow = next > SUCCESS * e;
                e = next;
                self.report()?;
                if !was_slow {
                    continue;
                }
            } else {
                self.swap();
            }
            if is_new || e <= WORTHWHILE || !self.jacobian() {
                break;
            }
            is_new = true;
        }
        Continue(e)
    }

    /// The min-map direction at the iterate; damped by `damping · max |H|²` where its matrix is
    /// singular. False if there is none.
    pub(super) fn min_map_direction(&mut self, damping: f64) -> bool {
        self.undamped_min_map_direction() || self.damped_direction(damping)
    }

    /// The same without damping; false where the matrix is singular.
    pub(super) fn undamped_min_map_direction(&mut self) -> bool {
        let memory = &mut *self.memory;
        for i in 0..memory.rhs.len() {
            let (value, branch) = memory.view.natural(&memory.here, i);
            let identity = branch != Branch::Equation;
            memory.rhs[i] = value;
            memory.a[i] = f64::from(u8::from(identity));
            memory.b[i] = f64::from(u8::from(!identity));
        }
        self.undamped_direction()
    }
}
