//! Proximal points: `F(y) + μ (y − y_k) = 0` on the box, `y_{k+1}` its solution.
//!
//! ```text
//! μ = 1;  solved: μ ← 0.3 μ;  not solved: μ ← 10 μ, at most five times
//! ```
//!
//! An implicit Euler step of `y' = −F`. The perturbed problem has a better Jacobian, and no local
//! minimum of the merit where the plain one has ([Bil95](crate#references)). Converges for monotone
//! `F`.

use super::Search;
use super::map::Map;
use super::semismooth::MONOTONE;
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::Continue;

/// Steps for one subproblem.
const STEPS: usize = 25;
/// Evaluations of `J` for one run of the stage.
const JACOBIANS: usize = 120;
/// `‖Φ‖` at which a subproblem counts as solved.
const SOLVED: f64 = 1e-3;
/// `μ` at which the perturbation no longer matters.
const SMALLEST: f64 = 1e-7;
/// Steps of Newton's method on the problem itself afterwards.
const AFTERWARDS: usize = 20;

impl Search<'_, '_> {
    /// At most `budget` subproblems, then Newton on `Φ`.
    pub(super) fn proximal(&mut self, budget: usize) -> Flow<StageEnd> {
        let begun = self.run.stats.jacobian_evaluations;
        let (mut mu, mut failures) = (1.0, 0);
        for _ in 0..budget {
            if self.run.stats.jacobian_evaluations - begun > JACOBIANS || mu < SMALLEST {
                break;
            }
            let memory = &mut *self.memory;
            memory.center.copy_from_slice(&memory.here.z);
            memory.proximal = Some(mu);
            let is_solved = self.subproblem()?;
            self.memory.proximal = None;
            if is_solved {
                mu *= 0.3;
            } else {
                let memory = &mut *self.memory;
                memory.here.z.copy_from_slice(&memory.center);
                failures += 1;
                mu *= 10.0;
            }
            if failures > 4 {
                return Continue(StageEnd::NoStep);
            }
            // Without the perturbation.
            if !self.restart()? {
                return Continue(StageEnd::NotFinite);
            }
        }
        self.newton_on(Map::FischerBurmeister, AFTERWARDS)
    }

    /// Newton on the perturbed problem at the centre.
    fn subproblem(&mut self) -> Flow<bool> {
        self.set_map(Map::FischerBurmeister);
        for k in 0..STEPS {
            self.begin()?;
            if (2.0 * self.memory.here.merit).sqrt() <= SOLVED {
                return Continue(true);
            }
            if self.newton_step(k < MONOTONE)?.is_break() {
                return Continue(false);
            }
        }
        Continue((2.0 * self.memory.here.merit).sqrt() <= SOLVED)
    }
}
