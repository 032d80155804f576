//! What the rows of every model call, compiled here in the arithmetics of a solve: the compiler takes
//! an instance of a function that is never inlined from the crate that has it.

use super::layout::{Layout, Sparse};
use crate::model::{Asked, Reader};
use crate::scalar::{Jet, Real, Scalar, Wide};

/// Reads in one arithmetic.
#[expect(dead_code, reason = "that there are these functions is what it is for")]
struct Reads<D: Scalar> {
    number: fn(&Reader<'_, D>, Asked, usize) -> Real<D>,
    variable: fn(&Layout, &Reader<'_, D>, usize) -> Real<D>,
    sparse_variable: fn(&Sparse, &Reader<'_, D>, usize) -> Real<D>,
}

impl<D: Scalar> Reads<D> {
    const ALL: Self = Reads {
        number: |read, what, k| read.apart(what, k),
        variable: Layout::variable_apart,
        sparse_variable: Sparse::variable_apart,
    };
}

/// What a jet of rows does at corners.
#[expect(dead_code, reason = "that there are these functions is what it is for")]
struct Corners<J> {
    chain: fn(J, f64, f64) -> J,
    chain2: fn(J, J, f64, f64, f64) -> J,
    quotient: fn(J, J, f64) -> J,
    scale: fn(J, f64, f64) -> J,
    unknown: fn(J, J, f64) -> J,
}

#[used]
static PLAIN: Reads<f64> = Reads::ALL;
#[used]
static JET: Reads<Jet<8>> = Reads::ALL;
#[used]
static WIDE: Reads<Wide> = Reads::ALL;
#[used]
static CORNERS: Corners<Jet<8>> = Corners {
    chain: Jet::chain_at_corner,
    chain2: Jet::chain2_at_corner,
    quotient: Jet::quotient_at_corner,
    scale: Jet::scale_at_corner,
    unknown: Jet::unknown,
};
