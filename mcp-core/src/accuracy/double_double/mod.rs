//! [`DoubleDouble`]: 31 decimal digits as a sum of two `f64`.

mod functions;
#[cfg(test)]
mod tests;

use crate::scalar::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The unevaluated sum `high + low` of two `f64` with `|low| <= ulp(high)/2`: 106 bits.
///
/// A [`Scalar`], so that the text of a model gives `F` with an error far below the digits of `f64`:
/// it tells true errors from rounding. With `u = 2⁻⁵³`, `u² = 1.2e-32`, the relative errors are
///
/// | operation | bound | source |
/// | --- | --- | --- |
/// | `+ −` | `3 u² + 13 u³` | [JMP17](crate#references) Alg. 6 |
/// | `×` | `5 u²` | [JMP17](crate#references) Alg. 12 |
/// | `÷` | `15 u² + 56 u³` | [JMP17](crate#references) Alg. 17 |
/// | `√` | `4 u²` | tested: one Newton step from the root of `high` |
/// | `powi(n)` | `5 n u²`, and `15 u²` more for `n < 0` | `n − 1` products at most, by repeated squaring |
/// | `exp`, `exp_m1` | `(64 + 4 abs(x)) u²` | tested: Taylor series after reduction |
/// | `ln`, `ln_1p` | `64 u²` near 1, else `64 u² (1 + 1/abs(ln x))` | tested: series, or a Newton step on `exp` |
/// | other functions | `1e-28`, for ordinary arguments | tested; made of those above, and a series for `sin` and `cos`, which have 53 bits beyond `abs(x) = 1e6` |
///
/// as long as no part over- or underflows (results between `1e-280` and `1e280`). Constants are the
/// `f64` of the program text: `0.1` is the `f64` nearest to 1/10, as everywhere in a model; numbers
/// rounded before they reach it (`π`, the results of an [`external`](crate::external()) function) keep
/// 53 bits. Corner values (0, ±∞, NaN) are those of `f64`.
///
/// ```
/// use mcp_core::accuracy::DoubleDouble;
/// let third = DoubleDouble::from(1.0) / DoubleDouble::from(3.0);
/// assert!((third + third + third - DoubleDouble::from(1.0)).to_f64().abs() < 1e-31);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

impl From<f64> for DoubleDouble {
    fn from(high: f64) -> Self {
        DoubleDouble { high, low: 0.0 }
    }
}

impl DoubleDouble {
    /// `high + low`, whatever their sizes.
    pub fn new(high: f64, low: f64) -> Self {
        two_sum(high, low)
    }

    /// The nearest `f64`.
    pub fn to_f64(self) -> f64 {
        self.high
    }

    /// What the nearest `f64` leaves.
    pub fn low(self) -> f64 {
        self.low
    }

    /// `self · 2ᵏ`, exactly unless it over- or underflows.
    fn times_power_of_two(self, k: i32) -> Self {
        // In two factors: 2ᵏ itself may overflow where the result does not.
        let (half, rest) = (2_f64.powi(k / 2), 2_f64.powi(k - k / 2));
        finite_or(self.high * half * rest, self.low * half * rest)
    }
}

/// The pair, or its first number alone where that is infinite or NaN.
#[inline]
fn finite_or(high: f64, low: f64) -> DoubleDouble {
    DoubleDouble { high, low: if high.is_finite() { low } else { 0.0 } }
}

/// `a + b` exactly (Knuth; [JMP17](crate#references) Alg. 2).
#[inline]
fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let sum = a + b;
    let of_a = sum - b;
    let of_b = sum - of_a;
    finite_or(sum, (a - of_a) + (b - of_b))
}

/// `a + b` exactly if `|a| >= |b|` (Dekker; [JMP17](crate#references) Alg. 1).
#[inline]
fn fast_two_sum(a: f64, b: f64) -> DoubleDouble {
    let sum = a + b;
    finite_or(sum, b - (sum - a))
}

/// `a b` exactly ([JMP17](crate#references) Alg. 3).
#[inline]
fn two_product(a: f64, b: f64) -> DoubleDouble {
    let product = a * b;
    finite_or(product, a.mul_add(b, -product))
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        DoubleDouble { high: -self.high, low: -self.low }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    /// [JMP17](crate#references) Alg. 6.
    #[inline]
    fn add(self, other: Self) -> Self {
        let s = two_sum(self.high, other.high);
        let t = two_sum(self.low, other.low);
        let v = fast_two_sum(s.high, s.low + t.high);
        fast_two_sum(v.high, t.low + v.low)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline]
    #[allow(clippy::suspicious_arithmetic_impl, reason = "x − y = x + (−y), exactly")]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    /// [JMP17](crate#references) Alg. 12.
    #[inline]
    fn mul(self, other: Self) -> Self {
        let product = two_product(self.high, other.high);
        if !product.high.is_finite() {
            return product;
        }
        let lows = self.high.mul_add(other.low, self.low * other.low);
        let rest = product.low + self.low.mul_add(other.high, lows);
        fast_two_sum(product.high, rest)
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    /// [JMP17](crate#references) Alg. 17, with the product of Alg. 9.
    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        if !quotient.is_finite() || quotient == 0.0 {
            return DoubleDouble::from(quotient);
        }
        let product = two_product(other.high, quotient);
        let back = fast_two_sum(product.high, other.low.mul_add(quotient, product.low));
        let rest = (self.high - back.high) + (self.low - back.low);
        fast_two_sum(quotient, rest / other.high)
    }
}

macro_rules! by_functions {
    ($($function:ident)*) => {$(
        fn $function(self) -> Self {
            functions::$function(self)
        }
    )*};
}

impl Scalar for DoubleDouble {
    const LANES: usize = 0;

    fn constant(v: f64) -> Self {
        v.into()
    }
    fn seed(v: f64, _lane: usize) -> Self {
        v.into()
    }
    fn tangent(&self, _lane: usize) -> f64 {
        0.0
    }
    fn value(&self) -> f64 {
        self.high
    }
    fn is_zero(&self) -> bool {
        self.high == 0.0
    }
    fn is_finite(&self) -> bool {
        self.high.is_finite()
    }
    fn with_unknown_tangents(self) -> Self {
        self
    }
    fn linearised<const K: usize>(value: f64, _: &[f64; K], _: &[Self; K]) -> Self {
        value.into()
    }

    fn shift(self, c: f64) -> Self {
        self + c.into()
    }
    fn scale(self, c: f64) -> Self {
        self * c.into()
    }
    fn over(self, c: f64) -> Self {
        self / c.into()
    }
    fn recip(self) -> Self {
        Self::from(1.0) / self
    }

    fn powi(self, n: i32) -> Self {
        functions::powi(self, n)
    }
    fn powf(self, p: f64) -> Self {
        functions::pow(self, p.into())
    }
    fn powf_slope(self, p: f64, v: Self) -> Self {
        if self.high == 0.0 || v.high == 0.0 || !v.high.is_finite() {
            return self.high.powf_slope(p, v.high).into();
        }
        v * p.into() / self
    }
    fn pow(self, y: Self) -> Self {
        functions::pow(self, y)
    }
    fn atan2(self, x: Self) -> Self {
        functions::atan2(self, x)
    }
    fn hypot(self, y: Self) -> Self {
        functions::hypot(self, y)
    }

    by_functions! { sqrt cbrt exp exp_m1 ln ln_1p log10 sin cos tan asin acos atan sinh cosh tanh xlogx }

    fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }
    fn max(self, other: Self) -> Self {
        let other_wins = other.is_above(self);
        self.or(other, other_wins)
    }
    fn min(self, other: Self) -> Self {
        let other_wins = self.is_above(other);
        self.or(other, other_wins)
    }
    fn select(s: Self, a: Self, b: Self) -> Self {
        match s.high {
            sign if sign.is_nan() => s,
            sign if sign > 0.0 => a,
            _ => b,
        }
    }
}

impl DoubleDouble {
    fn is_above(self, other: Self) -> bool {
        (self.high, self.low) > (other.high, other.low)
    }

    /// The other number if it wins or is NaN, unless this one is NaN.
    fn or(self, other: Self, other_wins: bool) -> Self {
        if !self.high.is_nan() && (other_wins || other.high.is_nan()) { other } else { self }
    }
}
