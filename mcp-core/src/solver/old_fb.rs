//! The older semismooth Newton method: [KK98](crate#references) Algorithm 4.1, extended to boxes.
//!
//! ```text
//! 1  stop if the criterion is met and the certificate agrees
//! 2  H d = −Φ(z);  d = −∇θ if H is singular or not ∇θ·d <= −ρ ‖d‖ᵖ
//! 3  largest t in {1, ½, ¼, …} with θ(z + t d) <= θ(z) + γ t ∇θ·d;  z ← z + t d
//! ```
//!
//! Constants `ρ = 1e-8`, `p = 2.1`, `γ = 1e-4`. The slope always belongs to the direction taken.

use super::run::{Flow, Run};
use std::convert::Infallible;

/// Runs until something ends the solve.
pub(super) fn solve(run: &mut Run<'_>) -> Flow<Infallible> {
    run.start()?;
    loop {
        run.begin_iteration()?;
        let newton = run.fb_direction();
        let descent = newton.and_then(|d| run.descent_slope().map(|slope| (d, slope)));
        let (direction, slope) = match descent {
            Some(descent) => descent,
            None => run.gradient_direction()?,
        };
        run.search(direction, slope, false)?;
    }
}
