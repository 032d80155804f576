//! Sizes that only the compiler knows.

use mcp_core::{Real, Scalar, mcp_fn};

const NONE: usize = 0;
const TWO: usize = 2;
const THREE: usize = 3;

#[mcp_fn]
fn empty<D: Scalar>(z: [Real<D>; NONE]) -> [Real<D>; NONE] {
    z
}

#[mcp_fn]
fn names<D: Scalar>([x, y]: [Real<D>; THREE]) -> [Real<D>; THREE] {
    [x, y, x]
}

#[mcp_fn]
fn shrinks<D: Scalar>([x, y, z]: [Real<D>; 3]) -> [Real<D>; TWO] {
    [x, y - z]
}

fn main() {}
