//! Newton on the Fischer–Burmeister equations with line search: [FP03](crate#references) algorithm VFBLSA, p. 834,
//! extended from `z >= 0` to boxes.
//!
//! ```text
//! 1  stop if the criterion is met and the certificate agrees
//! 2  H d = −Φ(z), H an element of the generalised derivative;  d = −∇θ if H is singular
//!    if θ(z + d) <= σ θ(z): z ← z + d, next iteration
//! 3  unless ∇θ·d <= −ρ ‖d‖ᵖ: d ← −∇θ
//! 4  largest t in {t₀, t₀/2, t₀/4, …} with θ(z + t d) <= θ_ref + γ t ∇θ·d;  z ← z + t d
//! ```
//!
//! Constants `σ = 0.9`, `ρ = 1e-8`, `p = 2.1`, `γ = 1e-4`. Every limit point is stationary for `θ`;
//! the rate is quadratic at a regular solution. Cost of an iteration: one `J`, one factorisation,
//! one `F` for each trial point. Not scale-free: multiplying an equation changes the iterates.

use super::monitor::Direction;
use super::run::{Candidate, Flow, Run};
use std::convert::Infallible;

/// Runs until something ends the solve.
pub(super) fn solve(run: &mut Run<'_>) -> Flow<Infallible> {
    line_search_newton(run, Run::fb_direction)
}

/// The loop shared with the min-map method, which differs in step 2.
pub(super) fn line_search_newton<'a>(
    run: &mut Run<'a>,
    newton: fn(&mut Run<'a>) -> Option<Direction>,
) -> Flow<Infallible> {
    run.start()?;
    loop {
        run.begin_iteration()?;
        let mut searched = None;
        if let Some(direction) = newton(run) {
            let full = run.evaluate(Candidate::Full, 1.0);
            // False for NaN: such a step is never taken.
            let suffices = full <= run.options.full_step * run.work.current.merit;
            if suffices && run.take(Candidate::Full, 1.0, direction)? {
                continue;
            }
            searched = run.descent_slope().map(|slope| (direction, slope));
        }
        if let Some((direction, slope)) = searched {
            run.search(direction, slope, true)?;
        } else {
            let (direction, slope) = run.gradient_direction()?;
            run.search(direction, slope, false)?;
        }
    }
}
