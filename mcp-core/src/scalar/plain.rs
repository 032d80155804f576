//! `f64` as a [`Scalar`]: the values every other arithmetic reproduces bit by bit.

use super::Scalar;

impl Scalar for f64 {
    const LANES: usize = 0;

    #[inline]
    fn constant(v: f64) -> Self {
        v
    }
    #[inline]
    fn seed(v: f64, _lane: usize) -> Self {
        v
    }
    #[inline]
    fn tangent(&self, _lane: usize) -> f64 {
        0.0
    }
    #[inline]
    fn value(&self) -> f64 {
        *self
    }
    #[inline]
    fn is_zero(&self) -> bool {
        *self == 0.0
    }
    #[inline]
    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }
    #[inline]
    fn with_unknown_tangents(self) -> Self {
        self
    }
    #[inline]
    fn linearised<const K: usize>(value: f64, _: &[f64; K], _: &[Self; K]) -> Self {
        value
    }

    #[inline]
    fn shift(self, c: f64) -> Self {
        self + c
    }
    #[inline]
    fn scale(self, c: f64) -> Self {
        self * c
    }
    #[inline]
    fn over(self, c: f64) -> Self {
        self / c
    }
    #[inline]
    fn recip(self) -> Self {
        1.0 / self
    }

    /// Repeated squaring in a fixed order: `f64::powi` may differ between builds. A negative power
    /// is `1/xⁿ`, or `(1/x)ⁿ` where `xⁿ` over- or underflows.
    #[inline]
    fn powi(self, n: i32) -> Self {
        let power = natural_power(self, n.unsigned_abs());
        if n >= 0 {
            power
        } else if power.is_normal() {
            1.0 / power
        } else {
            natural_power(1.0 / self, n.unsigned_abs())
        }
    }
    #[inline]
    fn powf(self, p: f64) -> Self {
        f64::powf(self, p)
    }
    /// `(p v)/x`: no second power. Where `v` or the product is not a normal number digits are lost
    /// (or it is 0/0), and the quotient or the power is taken first.
    fn powf_slope(self, p: f64, v: Self) -> Self {
        if p == 0.0 {
            return 0.0;
        }
        let (product, quotient) = (p * v, v / self);
        if v.is_normal() && product.is_normal() {
            product / self
        } else if v.is_normal() && quotient.is_normal() {
            p * quotient
        } else {
            p * f64::powf(self, p - 1.0)
        }
    }
    #[inline]
    fn pow(self, y: Self) -> Self {
        f64::powf(self, y)
    }
    #[inline]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline]
    fn cbrt(self) -> Self {
        f64::cbrt(self)
    }
    #[inline]
    fn exp(self) -> Self {
        f64::exp(self)
    }
    #[inline]
    fn exp_m1(self) -> Self {
        f64::exp_m1(self)
    }
    #[inline]
    fn ln(self) -> Self {
        f64::ln(self)
    }
    #[inline]
    fn ln_1p(self) -> Self {
        f64::ln_1p(self)
    }
    #[inline]
    fn log10(self) -> Self {
        f64::log10(self)
    }
    #[inline]
    fn sin(self) -> Self {
        f64::sin(self)
    }
    #[inline]
    fn cos(self) -> Self {
        f64::cos(self)
    }
    #[inline]
    fn tan(self) -> Self {
        f64::tan(self)
    }
    #[inline]
    fn asin(self) -> Self {
        f64::asin(self)
    }
    #[inline]
    fn acos(self) -> Self {
        f64::acos(self)
    }
    #[inline]
    fn atan(self) -> Self {
        f64::atan(self)
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        f64::atan2(self, x)
    }
    #[inline]
    fn sinh(self) -> Self {
        f64::sinh(self)
    }
    #[inline]
    fn cosh(self) -> Self {
        f64::cosh(self)
    }
    #[inline]
    fn tanh(self) -> Self {
        f64::tanh(self)
    }
    #[inline]
    fn hypot(self, y: Self) -> Self {
        f64::hypot(self, y)
    }
    #[inline]
    fn xlogx(self) -> Self {
        if self == 0.0 { 0.0 } else { self * f64::ln(self) }
    }
    #[inline]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline]
    fn max(self, other: Self) -> Self {
        if self.is_nan() || other.is_nan() {
            f64::NAN
        } else if self >= other {
            self
        } else {
            other
        }
    }
    #[inline]
    fn min(self, other: Self) -> Self {
        if self.is_nan() || other.is_nan() {
            f64::NAN
        } else if self <= other {
            self
        } else {
            other
        }
    }
    #[inline]
    fn select(s: Self, a: Self, b: Self) -> Self {
        if s.is_nan() {
            f64::NAN
        } else if s > 0.0 {
            a
        } else {
            b
        }
    }
}

/// `xⁿ` by repeated squaring.
#[inline]
fn natural_power(x: f64, n: u32) -> f64 {
    let (mut power, mut square, mut left) = (1.0, x, n);
    while left > 0 {
        if left & 1 == 1 {
            power *= square;
        }
        left >>= 1;
        if left > 0 {
            square *= square;
        }
    }
    power
}
