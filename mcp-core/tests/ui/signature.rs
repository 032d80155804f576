//! The macro's own messages, as the compiler shows them.

use mcp_core::{Real, Scalar, mcp_fn};

#[mcp_fn(lower = 0.0)]
fn plain([x1, x2]: [f64; 2]) -> [f64; 2] {
    [x1, x2]
}

#[mcp_fn(lowr = 0.0, upper = [1.0, 2.0, 3.0])]
fn wrong<D: Scalar>([x1, _]: [Real<D>; 2]) -> [Real<D>; 1] {
    [x1]
}

fn main() {}
