//! The functions of the field on [`Real`]. Values and derivatives at the corners:
//! [table](super#values-and-derivatives-at-the-corners).

use super::{Real, Scalar};

/// What may stand in `x.pow(…)`: an integer, an `f64` or a [`Real`].
pub trait Exponent<D: Scalar> {
    /// `base` to this power.
    fn power_of(self, base: Real<D>) -> Real<D>;
}

impl<D: Scalar> Exponent<D> for i32 {
    #[inline]
    fn power_of(self, base: Real<D>) -> Real<D> {
        base.powi(self)
    }
}

impl<D: Scalar> Exponent<D> for f64 {
    #[inline]
    fn power_of(self, base: Real<D>) -> Real<D> {
        Real(base.0.powf(self))
    }
}

impl<D: Scalar> Exponent<D> for Real<D> {
    #[inline]
    fn power_of(self, base: Real<D>) -> Real<D> {
        Real(base.0.pow(self.0))
    }
}

impl<D: Scalar> Real<D> {
    /// `xᵖ` for an integer, `f64` or `Real` exponent.
    #[inline]
    pub fn pow(self, exponent: impl Exponent<D>) -> Self {
        exponent.power_of(self)
    }
    /// `xⁿ` by repeated squaring.
    #[inline]
    pub fn powi(self, n: i32) -> Self {
        Real(self.0.powi(n))
    }
    /// `1/x`.
    #[inline]
    pub fn recip(self) -> Self {
        Real(self.0.recip())
    }
    /// Square root.
    #[inline]
    pub fn sqrt(self) -> Self {
        Real(self.0.sqrt())
    }
    /// Cube root, also of negative numbers.
    #[inline]
    pub fn cbrt(self) -> Self {
        Real(self.0.cbrt())
    }
    /// `eˣ`.
    #[inline]
    pub fn exp(self) -> Self {
        Real(self.0.exp())
    }
    /// `eˣ − 1`, accurate near 0.
    #[inline]
    pub fn exp_m1(self) -> Self {
        Real(self.0.exp_m1())
    }
    /// Natural logarithm.
    #[inline]
    pub fn ln(self) -> Self {
        Real(self.0.ln())
    }
    /// `ln(1 + x)`, accurate near 0.
    #[inline]
    pub fn ln_1p(self) -> Self {
        Real(self.0.ln_1p())
    }
    /// Logarithm to base 10.
    #[inline]
    pub fn log10(self) -> Self {
        Real(self.0.log10())
    }
    /// Sine of an angle in radians.
    #[inline]
    pub fn sin(self) -> Self {
        Real(self.0.sin())
    }
    /// Cosine of an angle in radians.
    #[inline]
    pub fn cos(self) -> Self {
        Real(self.0.cos())
    }
    /// Tangent of an angle in radians.
    #[inline]
    pub fn tan(self) -> Self {
        Real(self.0.tan())
    }
    /// Inverse sine, in radians.
    #[inline]
    pub fn asin(self) -> Self {
        Real(self.0.asin())
    }
    /// Inverse cosine, in radians.
    #[inline]
    pub fn acos(self) -> Self {
        Real(self.0.acos())
    }
    /// Inverse tangent, in radians.
    #[inline]
    pub fn atan(self) -> Self {
        Real(self.0.atan())
    }
    /// Angle of the point `(x, self)` in radians.
    #[inline]
    pub fn atan2(self, x: impl Into<Self>) -> Self {
        Real(self.0.atan2(x.into().0))
    }
    /// Hyperbolic sine.
    #[inline]
    pub fn sinh(self) -> Self {
        Real(self.0.sinh())
    }
    /// Hyperbolic cosine.
    #[inline]
    pub fn cosh(self) -> Self {
        Real(self.0.cosh())
    }
    /// Hyperbolic tangent.
    #[inline]
    pub fn tanh(self) -> Self {
        Real(self.0.tanh())
    }
    /// `√(x² + y²)` without overflow.
    #[inline]
    pub fn hypot(self, y: impl Into<Self>) -> Self {
        Real(self.0.hypot(y.into().0))
    }
    /// `x ln x`, 0 at 0.
    #[inline]
    pub fn xlogx(self) -> Self {
        Real(self.0.xlogx())
    }
    /// `|x|`; declared kink at 0.
    #[inline]
    pub fn abs(self) -> Self {
        Real(self.0.abs())
    }
    /// The larger of the two; declared kink at a tie; NaN if either is.
    #[inline]
    pub fn max(self, other: impl Into<Self>) -> Self {
        Real(self.0.max(other.into().0))
    }
    /// The smaller of the two; declared kink at a tie; NaN if either is.
    #[inline]
    pub fn min(self, other: impl Into<Self>) -> Self {
        Real(self.0.min(other.into().0))
    }
    /// `max(lower, min(x, upper))`, with ties going to `x`; the limits may be `Real`. Crossed
    /// limits give `lower`.
    #[inline]
    pub fn clamp(self, lower: impl Into<Self>, upper: impl Into<Self>) -> Self {
        self.min(upper).max(lower)
    }
}

/// The larger of two numbers, at least one of them a `Real`: [`Real::max`].
#[inline]
pub fn max<D: Scalar>(a: impl Into<Real<D>>, b: impl Into<Real<D>>) -> Real<D> {
    a.into().max(b)
}

/// The smaller of two numbers, at least one of them a `Real`: [`Real::min`].
#[inline]
pub fn min<D: Scalar>(a: impl Into<Real<D>>, b: impl Into<Real<D>>) -> Real<D> {
    a.into().min(b)
}

/// Angle of the point `(x, y)` in radians.
#[inline]
pub fn atan2<D: Scalar>(y: impl Into<Real<D>>, x: impl Into<Real<D>>) -> Real<D> {
    y.into().atan2(x)
}

/// `√(x² + y²)` without overflow.
#[inline]
pub fn hypot<D: Scalar>(x: impl Into<Real<D>>, y: impl Into<Real<D>>) -> Real<D> {
    x.into().hypot(y)
}

/// `a` where `s > 0`, `b` where `s <= 0`. Both are always evaluated, so derivative and pattern see
/// both arms; the derivative is that of the arm taken.
#[inline]
pub fn select<D: Scalar>(s: Real<D>, a: impl Into<Real<D>>, b: impl Into<Real<D>>) -> Real<D> {
    Real(D::select(s.0, a.into().0, b.into().0))
}

/// `ln Σ exp(xᵢ)` without overflow, in one pass over the terms:
/// `m + ln Σ exp(xᵢ − m)` with `m` the largest value so far, a constant for the derivative.
///
/// ```
/// use mcp_core::{Real, logsumexp};
/// let x = [1000.0, 1000.0].map(Real::<f64>::from);
/// assert_eq!(logsumexp(x, |x| x).into_scalar(), 1000.0 + 2_f64.ln());
/// ```
pub fn logsumexp<D: Scalar, I: IntoIterator>(
    set: I,
    mut term: impl FnMut(I::Item) -> Real<D>,
) -> Real<D> {
    let mut largest = f64::NEG_INFINITY;
    let mut sum = D::constant(0.0);
    let mut unbounded: Option<D> = None;
    for i in set {
        let x = term(i).0;
        let value = x.value();
        if value.is_nan() || value == f64::INFINITY {
            unbounded = Some(unbounded.map_or(x, |others| others + x));
        } else if value > largest {
            let rescale = D::constant(largest).shift(-value).exp();
            sum = if largest.is_finite() { sum * rescale } else { absent(sum) }
                + x.shift(-value).exp();
            largest = value;
        } else if value > f64::NEG_INFINITY {
            sum = sum + x.shift(-largest).exp();
        } else {
            sum = sum + absent(x);
        }
    }
    if let Some(infinite_or_nan) = unbounded {
        Real(infinite_or_nan + absent(sum))
    } else if largest == f64::NEG_INFINITY {
        Real(sum.shift(largest))
    } else {
        Real(sum.ln().shift(largest))
    }
}

/// 0 with zero tangents, which still depends on `x`: the pattern must not depend on the point.
pub(crate) fn absent<D: Scalar>(x: D) -> D {
    D::select(D::constant(-1.0), x, D::constant(0.0))
}

/// `(a + b + √((a−b)² + 4ε²)) / 2` with `width = ε`: differentiable, above `max(a, b)` by at most
/// `ε`.
///
/// Evaluated as `max(a, b) + 2ε² / (|a−b| + √((a−b)² + 4ε²))`, which does not cancel.
#[inline]
pub fn smooth_max<D: Scalar>(a: impl Into<Real<D>>, b: impl Into<Real<D>>, width: f64) -> Real<D> {
    let (a, b) = (a.into(), b.into());
    if width == 0.0 { a.max(b) } else { a.max(b) + corner(a, b, width) }
}

/// `(a + b − √((a−b)² + 4ε²)) / 2` with `width = ε`: differentiable, below `min(a, b)` by at most
/// `ε`. Evaluated like [`smooth_max`].
#[inline]
pub fn smooth_min<D: Scalar>(a: impl Into<Real<D>>, b: impl Into<Real<D>>, width: f64) -> Real<D> {
    let (a, b) = (a.into(), b.into());
    if width == 0.0 { a.min(b) } else { b.min(a) - corner(a, b, width) }
}

/// `2ε² / (|a−b| + √((a−b)² + 4ε²))`. Its kink at `a = b` cancels those of `max(a, b)` and
/// `min(b, a)`: all three take the side `a >= b` there.
fn corner<D: Scalar>(a: Real<D>, b: Real<D>, width: f64) -> Real<D> {
    let distance = (a - b).abs();
    2.0 * width * (width / (distance + distance.hypot(2.0 * width)))
}
