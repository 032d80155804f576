//! Newton direction of the min map, Fischer–Burmeister merit: [FP03](crate#references) algorithm minFBLSA, p. 855,
//! extended to boxes.
//!
//! As [`newton_fb`](super::newton_fb), but step 2 solves
//!
//! ```text
//! d_i = −(z_i − l_i)  where z_i − l_i <= F_i          d_i = −(z_i − u_i)  where z_i − u_i >= F_i
//! (J d)_i = −F_i      elsewhere
//! ```
//!
//! and falls back to `H d = −Φ` where this system is singular. Ties take the bound. On an affine
//! problem every full step solves for one active set, so it ends at a solution to the last digit.

use super::monitor::Direction;
use super::newton_fb::line_search_newton;
use super::run::{Flow, Run};
use std::convert::Infallible;

/// Runs until something ends the solve.
pub(super) fn solve(run: &mut Run<'_>) -> Flow<Infallible> {
    line_search_newton(run, min_or_fb_direction)
}

fn min_or_fb_direction(run: &mut Run<'_>) -> Option<Direction> {
    run.min_direction().or_else(|| run.fb_direction())
}
