//! Josephy–Newton: the problem is linearised, not its equations.
//!
//! ```text
//! ŷ solves  G(y) + J(y) (ŷ − y) ⟂ l <= ŷ <= u,  by pivoting;  J + ε I, ε = 10⁻², 1, on a ray
//! t in {1, ½, …}: θ(y + t (ŷ − y)) <= (1 − 10⁻⁴ t) max of the last merits
//! ```
//!
//! [Jos79](crate#references), with the merit function of [FKM99](crate#references). An affine problem
//! is solved by one step. Each linearisation is tried from the basis of the iterate first, which
//! near a solution needs few exchanges, then from the bounds, where the theory of
//! [pivoting](crate::solver::pivot) holds.

use super::Search;
use super::map::Map;
use crate::solver::monitor::Direction;
use crate::solver::pivot::{Affine, Basis, PathEnd};
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::Continue;

/// Regularisation: none, then these.
const EPSILON: [f64; 3] = [0.0, 1e-2, 1.0];
/// Shortest step.
const SHORTEST: f64 = 1e-3;
/// Steps this short in a row end the stage.
const SHORT: f64 = 0.05;
const MOST_SHORT: usize = 8;

/// Variables up to which linearisations are tried before semismooth steps: above, an exchange of
/// pivoting costs more than it saves.
const EARLY: usize = 500;

impl Search<'_, '_> {
    /// The stage right after the crash, for small problems: where the crash fails, it needs a third of
    /// the steps of semismooth Newton.
    pub(super) fn josephy_first(&mut self, budget: usize) -> Flow<StageEnd> {
        if self.run.problem.pattern().n() > EARLY {
            return Continue(StageEnd::Skipped);
        }
        self.josephy(budget)
    }

    /// At most `budget` linearisations.
    pub(super) fn josephy(&mut self, budget: usize) -> Flow<StageEnd> {
        let n = self.run.problem.pattern().n();
        if n > self.run.options.robust.josephy_size || !self.prepare_basis() {
            return Continue(StageEnd::Skipped);
        }
        self.set_map(Map::FischerBurmeister);
        let mut short = 0;
        for _ in 0..budget {
            self.begin()?;
            if let Some(end) = self.memory.leave {
                return Continue(end);
            }
            if !self.linearised_direction() {
                return Continue(StageEnd::Ray);
            }
            let reference = self.memory.reference.value(self.memory.here.merit);
            let (mut t, mut taken) = (1.0, false);
            while t > SHORTEST && !taken {
                let trial = self.evaluate(t);
                let suffices = trial <= (1.0 - 1e-4 * t) * reference;
                taken = suffices && self.accept(Direction::Pivoting, t)?;
                t *= 0.5;
            }
            if !taken {
                return Continue(StageEnd::NoStep);
            }
            short = if t < 0.5 * SHORT { short + 1 } else { 0 };
            if short > MOST_SHORT {
                return Continue(StageEnd::Stalled);
            }
        }
        Continue(StageEnd::Budget)
    }

    /// Memory for the pivoting; false if no linear solver takes the pattern.
    fn prepare_basis(&mut self) -> bool {
        let Search { run, memory } = self;
        let pattern = run.problem.pattern();
        if memory.basis.as_ref().is_none_or(|basis| !basis.fits(pattern)) {
            memory.basis = Basis::new(pattern, run.options);
        }
        memory.basis.is_some()
    }

    /// `ŷ − y`, if one of the linearisations can be solved.
    fn linearised_direction(&mut self) -> bool {
        let Search { run, memory } = self;
        let memory = &mut **memory;
        let Some(basis) = &mut memory.basis else { return false };
        let pattern = run.problem.pattern();
        let limit = 10 * pattern.n() + 100;
        for epsilon in EPSILON {
            basis.set_matrix(&memory.jac, epsilon);
            // q = G(y) − (J + ε I) y.
            for (q, (g, y)) in memory.rhs.iter_mut().zip(memory.here.f.iter().zip(&memory.here.z)) {
                *q = g - epsilon * y;
            }
            for (k, i, j) in pattern.entries() {
                memory.rhs[i] -= memory.jac[k] * memory.here.z[j];
            }
            let (lower, upper) = (&memory.view.lower[..], &memory.view.upper[..]);
            let problem = Affine { q: &memory.rhs, lower, upper };
            for is_warm in [true, false] {
                if is_warm {
                    basis.start_at(problem, &memory.here.z, &memory.here.f);
                } else {
                    basis.start_at_bounds(problem);
                }
                let end = basis.follow(problem, limit);
                run.stats.factorisations += basis.factorisations;
                if end == PathEnd::Solved {
                    for j in 0..memory.direction.len() {
                        memory.direction[j] = basis.y[j] - memory.here.z[j];
                    }
                    return memory.direction.iter().all(|d| d.is_finite());
                }
            }
        }
        false
    }
}
