//! A branch on a variable, and an entry that is no number.

use mcp_core::{Real, Scalar, mcp_fn};

#[mcp_fn(lower = 0.0)]
fn branches<D: Scalar>([x1, x2]: [Real<D>; 2]) -> [Real<D>; 2] {
    if x1 > x2 { [x1, x2] } else { [x2, x1] }
}

#[mcp_fn(lower = 0.0)]
fn mixes<D: Scalar>([x1, x2]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x1 - x2, 1.0]
}

fn main() {}
