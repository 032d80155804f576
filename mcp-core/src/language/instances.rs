//! What the rows of every model call, compiled here in the arithmetics of a solve: the compiler takes
//! an instance of a function that is never inlined from the crate that has it.

use super::layout::Sparse;
use crate::model::Reader;
use crate::scalar::{Jet, Real, Scalar, Taped};

/// Reads a variable, a definition or a parameter.
type Number<D> = fn(&Reader<'_, D>, usize) -> Real<D>;

/// Reads in one arithmetic.
#[expect(dead_code, reason = "that there are these functions is what it is for")]
struct Reads<D: Scalar> {
    numbers: [Number<D>; 3],
    sparse_variable: fn(&Sparse, &Reader<'_, D>, usize) -> Real<D>,
}

impl<D: Scalar> Reads<D> {
    const ALL: Self = Reads {
        numbers: [
            |read, j| read.variable(j),
            |read, k| read.definition(k),
            |read, k| read.parameter(k),
        ],
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

impl<const N: usize> Corners<Jet<N>> {
    const ALL: Self = Corners {
        chain: Jet::chain_at_corner,
        chain2: Jet::chain2_at_corner,
        quotient: Jet::quotient_at_corner,
        scale: Jet::scale_at_corner,
        unknown: Jet::unknown,
    };
}

#[used]
static PLAIN: Reads<f64> = Reads::ALL;
#[used]
static JET: Reads<Jet<8>> = Reads::ALL;
#[used]
static TAPED: Reads<Taped<'static>> = Reads::ALL;
#[used]
static CORNERS: Corners<Jet<8>> = Corners::ALL;
