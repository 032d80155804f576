//! Numbers inside a model: one source text, many arithmetics.
//!
//! A model computes `F(z)` with [`Real<D>`] numbers, where `D` is any [`Scalar`]: plain `f64` for
//! values, [`Jet`] for values with exact first derivatives (nested: second derivatives), num-dual's
//! types as an independent second opinion, [`Trace`] for the sparsity pattern, [`Counted`] for the
//! number of operations, [`Interval`] for proofs. The same text therefore gives `F`, `J`, the pattern,
//! the cost and enclosures, and they can not disagree.
//!
//! # Values and derivatives at the corners
//!
//! Complementarity puts solutions at the corners of the domain (`x = 0`), so every function states
//! its value and its derivative there. Values have the same bits in every arithmetic of this crate,
//! those of `f64` (integer powers by repeated squaring, which `f64::powi` does not promise); the functions of num-dual's types agree to 4 ulp. Derivatives are written without
//! cancellation, with error at most `4 eps (|f'| + |x f''|)` and one subnormal number (for powers
//! multiplied by `p` or `ln x`, as the power is). Nested jets keep the same bound one order up,
//! `4 eps (|f''| + |x f'''|)`, where no intermediate result over- or underflows; for `atan2` and
//! `hypot` relative to the largest second derivative, scaled by the arguments. **A zero tangent
//! stays zero** even where the derivative is infinite, so a function at its corner does not poison
//! variables it does not depend on.
//!
//! | function | at | value | derivative |
//! | --- | --- | --- | --- |
//! | `sqrt` | 0 | 0 | +inf |
//! | `sqrt` | x < 0 | NaN | NaN |
//! | `sqrt` | +inf | +inf | 0 |
//! | `cbrt` | 0 | 0 | +inf |
//! | `cbrt` | +-inf | +-inf | 0 |
//! | `recip` | 0 | +inf | -inf |
//! | `recip` | -0 | -inf | -inf |
//! | `recip` | +-inf | 0 | 0 |
//! | `recip` | abs(x) < 5e-309 | +-inf | -inf |
//! | `pow(p)`, p > 1 | 0 | 0 | 0 |
//! | `pow(p)`, p > 1 | +inf | +inf | +inf |
//! | `pow(1)` | 0, +-inf or NaN | x | 1 |
//! | `pow(p)`, 0 < p < 1 | 0 | 0 | +inf |
//! | `pow(p)`, 0 < p < 1 | +inf | +inf | 0 |
//! | `pow(0)` | any x: 0, +-inf and NaN included | 1 | 0 |
//! | `pow(p)`, p < 0 | 0 | +inf | -inf |
//! | `pow(p)`, p < 0 | +inf | 0 | 0 |
//! | `pow(p)`, p not an integer | x < 0 | NaN | NaN |
//! | `pow(p)` | result over- or underflows | +inf or 0 | limit of `p x^(p-1)` |
//! | `powi(n)` | as `pow(p)` with integer p, any sign of x | | |
//! | `pow(y)`, y a `Real` > 0 | 0 | 0 | by x as `pow(p)`; by y: 0 |
//! | `pow(y)`, y = 0 | 0 | 1 | by x: 0; by y: -inf |
//! | `pow(y)`, y < 0 | 0 | +inf | by x: -inf; by y: -inf |
//! | `pow(y)`, y > 0 | +inf | +inf | by x as `pow(p)`; by y: +inf |
//! | `pow(y)`, y < 0 | +inf | 0 | by x: 0; by y: 0 |
//! | `pow(y)`, y = +inf | x > 1 | +inf | by x: +inf; by y: +inf |
//! | `pow(y)`, y = -inf | x > 1 | 0 | by x: NaN; by y: 0 |
//! | `pow(y)`, y = NaN | 1 | 1 | by x: NaN; by y: 0 |
//! | `pow(y)` | x < 0, y an integer | x^y | by x: y x^(y-1); by y: NaN |
//! | `exp` | > 709.8 | +inf | +inf |
//! | `exp` | < -745.2 | 0 | 0 |
//! | `exp_m1` | > 709.8 | +inf | +inf |
//! | `exp_m1` | < -745.2 | -1 | 0 |
//! | `ln`, `log10` | 0 | -inf | +inf |
//! | `ln`, `log10` | x < 0 | NaN | NaN |
//! | `ln`, `log10` | +inf | +inf | 0 |
//! | `ln`, `log10` | 0 < x < 2e-309 | finite | +inf |
//! | `ln_1p` | -1 | -inf | +inf |
//! | `ln_1p` | x < -1 | NaN | NaN |
//! | `ln_1p` | +inf | +inf | 0 |
//! | `asin` | +-1 | +-pi/2 | +inf |
//! | `acos` | +-1 | 0, pi | -inf |
//! | `asin`, `acos` | abs(x) > 1 | NaN | NaN |
//! | `atan` | +-inf | +-pi/2 | 0 |
//! | `sin`, `cos`, `tan` | +-inf | NaN | NaN |
//! | `tanh` | abs(x) > 20 | +-1 | `sech^2 x`, down to 0 |
//! | `sinh` | abs(x) > 711 | +-inf | +inf |
//! | `cosh` | abs(x) > 711 | +inf | +-inf |
//! | `atan2(y, x)` | (0, 0) | as `f64` | NaN |
//! | `atan2(y, x)` | (0, x) | 0 or pi | by y: 1/x; by x: 0 |
//! | `atan2(y, x)` | (y, 0) | +-pi/2 | by y: 0; by x: -1/y |
//! | `atan2(y, x)` | one of them +-inf | as `f64` | 0 |
//! | `atan2(y, x)` | both +-inf | as `f64` | NaN |
//! | `atan2(y, x)` | 1/x^2 over- or underflows | as `f64` | by y: 1/x; by x: 0 or -inf |
//! | `hypot(x, y)` | (0, 0) | 0 | 0, an element of the generalised derivative |
//! | `hypot(x, y)` | (x, 0) | abs(x) | by x: +-1; by y: 0 |
//! | `hypot(x, y)` | (+-inf, y) | +inf | by x: +-1; by y: 0 |
//! | `hypot(x, y)` | both +-inf | +inf | NaN |
//! | `hypot(x, y)` | (inf, NaN) | +inf | NaN |
//! | `hypot(x, y)` | result overflows | +inf | x/r, y/r |
//! | `hypot(x, y)` | subnormal x and y | as `f64` | x/r, y/r |
//! | `abs` | 0 | 0 | 1 (kink) |
//! | `abs` | +-inf | +inf | +-1 |
//! | `max`, `min` | tie | the common value | of the first argument (kink) |
//! | `max`, `min` | an argument +-inf | of the winner | of the winner |
//! | `clamp(l, u)` | at a limit | the limit | 1: ties go to x (kink) |
//! | `clamp(l, u)` | l > u | l | of l |
//! | `select(s, a, b)` | s = 0 | b | of b (kink where a and b differ) |
//! | `select(s, a, b)` | s = NaN | NaN | NaN |
//! | `smooth_max`, `smooth_min`, width 0 | tie | the common value | of the first argument (kink) |
//! | `smooth_max`, `smooth_min`, width > 0 | tie | above, below by the width | 1/2 of each |
//! | `xlogx` | 0 | 0 | -inf |
//! | `xlogx` | x < 0 | NaN | NaN |
//! | `xlogx` | +inf | +inf | +inf |
//! | `logsumexp` | no terms | -inf | 0 |
//! | `logsumexp` | all terms -inf | -inf | 0 |
//! | `logsumexp` | one term -inf | of the others | 0 by that term |
//! | `logsumexp` | one term +inf | +inf | 1 by that term, 0 by the others |
//! | `x / 0.0`, `x * inf` | x > 0 | +inf | +inf |
//! | `x * 0.0` | finite x | 0 | 0, also of infinite tangents |
//! | any other function | NaN | NaN | NaN |
//!
//! A product is not guarded: an infinite *tangent* times a zero factor is NaN, so `x * x.sqrt()` at
//! 0 has no derivative where `x.pow(1.5)` has one. Write the power.
//!
//! `max`, `min`, `clamp`, `abs` and `select` are **declared kinks**: they return one element of the
//! generalised derivative, and they propagate NaN from any argument (`f64::max` does not).
//!
//! A model can not compare `Real` numbers or look at their values: a branch on a variable would
//! hide the other arm from the derivative and the pattern. Use the declared kinks; branches on data
//! are free.

mod behind_calls;
mod count;
mod external;
mod functions;
mod interval;
mod jet;
mod magnitude;
mod num_dual;
mod plain;
mod real;
mod sums;
mod taped;
#[cfg(test)]
mod tests;
mod trace;
mod undecided;

pub(crate) use behind_calls::behind_calls;
pub use count::{Counted, OperationCounts, Tally};
pub use external::external;
pub(crate) use functions::absent;
pub use functions::{Exponent, atan2, hypot, logsumexp, max, min, select, smooth_max, smooth_min};
pub use interval::Interval;
pub use jet::Jet;
pub use magnitude::Magnitude;
pub use real::Real;
pub use sums::{Total, prod, sum, when};
pub(crate) use taped::{Dependence, Tape, TapeMemory, Taped};
pub use trace::Trace;

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What a model may do to a number.
///
/// Implemented for `f64`, [`Jet`], [`Interval`], [`Trace`], [`Counted`] and num-dual's `Dual64`,
/// `DualSVec64<N>`, `Dual2_64`, `HyperDual64`. Model code never calls these methods: it works with
/// [`Real<D>`], which has the operators and functions. Corner values: [module page](self).
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be used as a number inside a model",
    note = "write the function as `fn f<D: Scalar>(x: Real<D>) -> Real<D>`"
)]
#[allow(clippy::return_self_not_must_use, reason = "models work with `Real`, which is must_use")]
pub trait Scalar:
    Copy
    + Debug
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
{
    /// Number of tangent lanes an engine can seed; 0 for arithmetics without derivatives.
    const LANES: usize;
    /// Whether a number stands for all numbers of a set, so that a comparison may be undecided.
    #[doc(hidden)]
    const ENCLOSES: bool = false;

    /// The constant `v`: all tangents zero.
    fn constant(v: f64) -> Self;
    /// The independent variable `v` whose tangent is 1 in `lane` and 0 elsewhere. A lane outside
    /// `0..LANES` gives the constant.
    fn seed(v: f64, lane: usize) -> Self;
    /// First derivative in `lane < LANES`.
    fn tangent(&self, lane: usize) -> f64;
    /// The plain value.
    fn value(&self) -> f64;
    /// True if value and all tangents are zero.
    fn is_zero(&self) -> bool;
    /// True if value and all tangents are finite.
    fn is_finite(&self) -> bool;
    /// The same value with every tangent unknown (NaN); the identity without tangents.
    fn with_unknown_tangents(self) -> Self;
    /// The number with `value` and first derivatives `gradient` by `arguments`; derivatives of
    /// higher order are NaN.
    fn linearised<const K: usize>(value: f64, gradient: &[f64; K], arguments: &[Self; K]) -> Self;

    /// A constant of mathematics whose nearest `f64` is `v`.
    #[doc(hidden)]
    #[inline]
    fn rounded(v: f64) -> Self {
        Self::constant(v)
    }
    /// Whether the set has a number in common with `other`, or touches it.
    #[doc(hidden)]
    #[inline]
    fn overlaps(&self, _other: &Self) -> bool {
        false
    }
    /// A set that contains both; its tangents are unknown, because what lies between may jump.
    #[doc(hidden)]
    #[inline]
    fn hull(self, _other: Self) -> Self {
        self
    }

    /// `self + term`, in place: what sums repeat.
    #[doc(hidden)]
    #[inline]
    fn accumulate(&mut self, term: Self) {
        *self = *self + term;
    }

    /// `self + c`.
    fn shift(self, c: f64) -> Self;
    /// `self · c`; all tangents zero if `c = 0`.
    fn scale(self, c: f64) -> Self;
    /// `self / c`.
    fn over(self, c: f64) -> Self;
    /// `self · other` where zero tangents stay zero even if the other factor is infinite: for
    /// slopes at corners.
    fn limit_product(self, other: Self) -> Self {
        self * other
    }
    /// `1 / self`.
    fn recip(self) -> Self;

    /// `xⁿ` by repeated squaring.
    fn powi(self, n: i32) -> Self;
    /// `xᵖ`.
    fn powf(self, p: f64) -> Self;
    /// `p xᵖ⁻¹`, given `v = xᵖ`.
    fn powf_slope(self, p: f64, v: Self) -> Self;
    /// `xʸ`.
    fn pow(self, y: Self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Cube root.
    fn cbrt(self) -> Self;
    /// `eˣ`.
    fn exp(self) -> Self;
    /// `eˣ − 1`, accurate near 0.
    fn exp_m1(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// `ln(1 + x)`, accurate near 0.
    fn ln_1p(self) -> Self;
    /// Logarithm to base 10.
    fn log10(self) -> Self;
    /// Sine.
    fn sin(self) -> Self;
    /// Cosine.
    fn cos(self) -> Self;
    /// Tangent.
    fn tan(self) -> Self;
    /// Inverse sine.
    fn asin(self) -> Self;
    /// Inverse cosine.
    fn acos(self) -> Self;
    /// Inverse tangent.
    fn atan(self) -> Self;
    /// Angle of the point `(x, self)`.
    fn atan2(self, x: Self) -> Self;
    /// Hyperbolic sine.
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    fn cosh(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// `√(x² + y²)` without overflow.
    fn hypot(self, y: Self) -> Self;
    /// `x ln x`, 0 at 0.
    fn xlogx(self) -> Self;
    /// `|x|`; a kink at 0.
    fn abs(self) -> Self;
    /// The larger; the first on a tie; NaN if either is.
    fn max(self, other: Self) -> Self;
    /// The smaller; the first on a tie; NaN if either is.
    fn min(self, other: Self) -> Self;
    /// `a` where `s > 0`, `b` where `s <= 0`, NaN where `s` is.
    fn select(s: Self, a: Self, b: Self) -> Self;
}
