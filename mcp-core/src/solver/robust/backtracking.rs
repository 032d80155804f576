//! Newton's method alone, with steps as short as it takes.
//!
//! ```text
//! H d = −Φ;  t in {1, ½, ¼, …}: θ(P(y + t d)) <= (1 − 2·10⁻⁴ t) θ(y);  the projected gradient without such a step
//! ```
//!
//! The line search of [DFK96](crate#references) without a direction of another kind in between. Far from all
//! solutions along a nearly flat valley, as in exponents of prices, Newton's step points the right way and is
//! 10⁵ times too long; damped steps follow the valley the other way.

use super::Search;
use super::map::Map;
use crate::globalise::StallWatch;
use crate::solver::monitor::Direction;
use crate::solver::run::Flow;
use crate::solver::stage::StageEnd;
use std::ops::ControlFlow::Continue;

/// Steps are halved down to this.
const SHORTEST: f64 = 1e-12;

impl Search<'_, '_> {
    /// At most `budget` steps from the iterate.
    pub(super) fn backtracking(&mut self, budget: usize) -> Flow<StageEnd> {
        let rule = self.run.options.robust.stall;
        self.set_map(Map::FischerBurmeister);
        let mut stall = StallWatch::new(self.memory.here.merit);
        for _ in 0..budget {
            self.begin()?;
            if let Some(end) = self.memory.leave {
                return Continue(end);
            }
            let merit = self.memory.here.merit;
            if stall.observe(merit, rule) {
                return Continue(StageEnd::Stalled);
            }
            self.memory.linearise(self.run.problem.pattern());
            let newton = self.newton_direction();
            let (step, direction) = match newton.then(|| self.search_newton(1.0, SHORTEST, merit)) {
                Some(Some(t)) => (Some(t), Direction::FischerBurmeister),
                _ => (self.search_gradient(), Direction::Gradient),
            };
            let Some(t) = step else { return Continue(StageEnd::NoStep) };
            if !self.accept(direction, t)? {
                return Continue(StageEnd::NoStep);
            }
        }
        Continue(StageEnd::Budget)
    }
}
