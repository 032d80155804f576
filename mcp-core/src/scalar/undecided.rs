//! Derivatives where a set of numbers, an [`Interval`](super::Interval), does not decide which arm is
//! taken.

use super::Scalar;
use super::jet::{Jet, lanes};

impl<const N: usize, T: Scalar> Jet<N, T> {
    /// One of two functions that are equal where they change places, with value `v`: the hull of
    /// both derivatives.
    #[cold]
    #[inline(never)]
    pub(super) fn either(self, other: Self, v: T) -> Self {
        Jet { v, d: lanes(|k| self.d[k].hull(other.d[k])) }
    }
    /// `a` or `b`, undecided by `s`. They may differ where `s` changes its sign, so that no slope
    /// along a variable of `s` is known.
    #[cold]
    #[inline(never)]
    pub(super) fn undecided(s: Self, a: Self, b: Self) -> Self {
        let d =
            lanes(|k| if s.d[k].is_zero() { a.d[k].hull(b.d[k]) } else { T::constant(f64::NAN) });
        Jet { v: T::select(s.v, a.v, b.v), d }
    }
}

/// Whether the sign of a set of numbers is undecided.
#[inline]
pub(super) fn may_be_zero<T: Scalar>(x: T) -> bool {
    T::ENCLOSES && x.overlaps(&T::constant(0.0))
}

/// `[−1, 1]`, of unknown derivative: the slopes of `|x|` around 0.
pub(super) fn unit_slopes<T: Scalar>() -> T {
    T::constant(-1.0).hull(T::constant(1.0)).with_unknown_tangents()
}
