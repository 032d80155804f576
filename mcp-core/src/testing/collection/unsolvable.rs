//! Problems without a solution: any `Solved` is a false claim.

use super::super::affine::Affine;
use super::Instance;
use crate::error::ModelError;
use crate::mcp_fn;
use crate::scalar::{Real, Scalar};

/// Zero is approached as `x → ∞` and never attained.
#[mcp_fn(lower = 0.0)]
fn vanishing<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    [-(-x).exp()]
}

/// `x² + 1 = 0`.
#[mcp_fn(start = 2.0)]
fn no_root<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    [x * x + 1]
}

/// Two parallel lines.
#[mcp_fn]
fn parallel<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x + y - 1, x + y - 2]
}

pub(super) fn instances() -> Result<Vec<Instance>, ModelError> {
    let falling = Affine::new(0, vec![-1.0], |_, _| -1.0)?;
    let infeasible =
        Affine::new(0, vec![-1.0, -1.0], |i, j| if (i, j) == (1, 1) { 1.0 } else { 0.0 })?;
    let own = "test of this collection";
    let all = vec![
        Instance::new("none-lcp", own, falling),
        Instance::new("none-lcp2", own, infeasible),
        Instance::new("none-exp", own, Vanishing::new()?),
        Instance::new("none-eq", own, NoRoot::new()?),
        Instance::new("none-singular", own, Parallel::new()?),
    ];
    Ok(all.into_iter().map(Instance::unsolvable).collect())
}
