//! Bounds of a wrong length or type.

use mcp_core::{Real, Scalar, mcp_fn};

const LOW: [f64; 3] = [0.0; 3];

#[mcp_fn(lower = LOW, upper = "1.0", start = [0, Some(0.5)])]
fn pair<D: Scalar>([x1, x2]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x1, x2]
}

const N: usize = 4;

#[mcp_fn(lower = [0.0, 1.0])]
fn four<D: Scalar>(z: [Real<D>; N]) -> [Real<D>; N] {
    z
}

fn main() {}
