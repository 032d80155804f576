//! [`Jet`]: a value with `N` exact tangents, over any base arithmetic.

use super::Scalar;
use super::undecided::{may_be_zero, unit_slopes};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `v + Σ dₖ εₖ` with `εₖ² = 0`: a value and its derivatives along `N` directions.
///
/// The base `T` is itself a [`Scalar`], so jets nest: `Jet<1, Jet<1>>` carries the second
/// derivative in `x.d[0].d[0]`.
///
/// Cost of one operation: one in `T` for the value and `N` multiply-adds for the tangents; a
/// transcendental function is evaluated once whatever `N`.
///
/// ```
/// use mcp_core::{Jet, Scalar};
/// let x = Jet::<1>::seed(9.0, 0);
/// let y = x.sqrt();
/// assert_eq!((y.v, y.d), (3.0, [1.0 / 6.0]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<const N: usize, T: Scalar = f64> {
    /// Value.
    pub v: T,
    /// Tangents.
    pub d: [T; N],
}

impl<const N: usize, T: Scalar> Jet<N, T> {
    /// The independent variable `v` (itself an element of the base arithmetic) in `lane`.
    #[inline]
    pub fn variable(v: T, lane: usize) -> Self {
        if N > UNIT_AT {
            return Jet { v, d: lanes(|k| T::constant(if k == lane { 1.0 } else { 0.0 })) };
        }
        let first = UNIT_AT - if lane < N { lane } else { UNIT_AT };
        Jet { v, d: lanes(|k| T::constant(UNIT[first + k])) }
    }

    /// `f(x)` with `f(x) = v`, `f'(x) = slope`. Zero tangents stay zero where the slope is not
    /// finite.
    #[inline]
    fn chain(self, v: T, slope: T) -> Self {
        if slope.is_finite() {
            Jet { v, d: lanes(|k| self.d[k] * slope) }
        } else {
            self.chain_at_corner(v, slope)
        }
    }
    /// Apart, as all that corners need: it would be compiled wherever a model computes.
    #[cold]
    #[inline(never)]
    pub(crate) fn chain_at_corner(self, v: T, slope: T) -> Self {
        Jet { v, d: lanes(|k| tangent_product(self.d[k], slope)) }
    }

    /// `f(x, y)` with partial derivatives `fx`, `fy`.
    #[inline]
    fn chain2(self, other: Self, v: T, fx: T, fy: T) -> Self {
        if fx.is_finite() && fy.is_finite() {
            Jet { v, d: lanes(|k| self.d[k] * fx + other.d[k] * fy) }
        } else {
            self.chain2_at_corner(other, v, fx, fy)
        }
    }
    #[cold]
    #[inline(never)]
    pub(crate) fn chain2_at_corner(self, other: Self, v: T, fx: T, fy: T) -> Self {
        let d = lanes(|k| tangent_product(self.d[k], fx) + tangent_product(other.d[k], fy));
        Jet { v, d }
    }

    /// `(a/b)'` where `a/b` or `1/b` is not finite.
    #[cold]
    #[inline(never)]
    pub(crate) fn quotient_at_corner(self, other: Self, v: T) -> Self {
        let quotient = |a: T| if a.is_zero() { a } else { a / other.v };
        Jet { v, d: lanes(|k| quotient(self.d[k] - tangent_product(other.d[k], v))) }
    }
    /// `c f` with `c f = v`, where `c` is 0 or not finite.
    #[inline(never)]
    pub(crate) fn scale_at_corner(self, v: T, c: f64) -> Self {
        if c == 0.0 { Jet { v, d: [T::constant(0.0); N] } } else { self.chain(v, T::constant(c)) }
    }
    /// NaN, which the larger and the smaller of two numbers are if one is.
    #[cold]
    #[inline(never)]
    pub(crate) fn unknown(self, other: Self, v: T) -> Self {
        self.chain2(other, v, v, v)
    }
}

/// Zeros around a one, which stands at [`UNIT_AT`]: every unit vector of up to that length.
const UNIT: [f64; 2 * UNIT_AT] = {
    let mut unit = [0.0; 2 * UNIT_AT];
    unit[UNIT_AT] = 1.0;
    unit
};
const UNIT_AT: usize = 16;

/// A number for every lane. `array::from_fn` would be compiled for each closure.
#[inline]
pub(super) fn lanes<const N: usize, T: Scalar>(lane: impl Fn(usize) -> T) -> [T; N] {
    let mut lanes = [T::constant(0.0); N];
    let mut k = 0;
    while k < N {
        lanes[k] = lane(k);
        k += 1;
    }
    lanes
}

/// `tangent · slope`, 0 where the tangent is 0.
#[inline]
fn tangent_product<T: Scalar>(tangent: T, slope: T) -> T {
    if tangent.is_zero() { tangent } else { tangent.limit_product(slope) }
}

/// `√(1−x²)`, as `√((1−x)(1+x))` for `|x| > 1/2`: each form cancels where the other does not, the
/// first near ±1, the second in its derivative near 0.
fn leg<T: Scalar>(x: T) -> T {
    let square = if x.value().abs() > 0.5 {
        (-x).shift(1.0).limit_product(x.shift(1.0))
    } else {
        (-x.limit_product(x)).shift(1.0)
    };
    square.sqrt()
}

impl<const N: usize, T: Scalar> Neg for Jet<N, T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Jet { v: -self.v, d: lanes(|k| -self.d[k]) }
    }
}

impl<const N: usize, T: Scalar> Add for Jet<N, T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Jet { v: self.v + other.v, d: lanes(|k| self.d[k] + other.d[k]) }
    }
}

impl<const N: usize, T: Scalar> Sub for Jet<N, T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Jet { v: self.v - other.v, d: lanes(|k| self.d[k] - other.d[k]) }
    }
}

impl<const N: usize, T: Scalar> Mul for Jet<N, T> {
    type Output = Self;
    /// Unchecked, being the commonest operation: an infinite factor makes zero tangents NaN, but the
    /// product is not finite then either.
    #[allow(clippy::suspicious_arithmetic_impl, reason = "the product rule adds")]
    #[inline]
    fn mul(self, other: Self) -> Self {
        Jet { v: self.v * other.v, d: lanes(|k| self.d[k] * other.v + other.d[k] * self.v) }
    }
}

impl<const N: usize, T: Scalar> Div for Jet<N, T> {
    type Output = Self;
    /// `(a/b)' = (a' − (a/b) b') / b`.
    #[inline]
    fn div(self, other: Self) -> Self {
        let v = self.v / other.v;
        let inverse = other.v.recip();
        if inverse.is_finite() && v.is_finite() {
            Jet { v, d: lanes(|k| (self.d[k] - other.d[k] * v) * inverse) }
        } else {
            self.quotient_at_corner(other, v)
        }
    }
}

impl<const N: usize, T: Scalar> Scalar for Jet<N, T> {
    const LANES: usize = N;
    const ENCLOSES: bool = T::ENCLOSES;

    #[inline]
    fn constant(v: f64) -> Self {
        Jet { v: T::constant(v), d: [T::constant(0.0); N] }
    }
    #[inline]
    fn seed(v: f64, lane: usize) -> Self {
        Jet::variable(T::constant(v), lane)
    }
    #[inline]
    fn tangent(&self, lane: usize) -> f64 {
        self.d[lane].value()
    }
    #[inline]
    fn value(&self) -> f64 {
        self.v.value()
    }
    #[inline]
    fn is_zero(&self) -> bool {
        self.v.is_zero() && self.d.iter().all(T::is_zero)
    }
    #[inline]
    fn is_finite(&self) -> bool {
        self.v.is_finite() && self.d.iter().all(T::is_finite)
    }
    #[inline]
    fn rounded(v: f64) -> Self {
        Jet { v: T::rounded(v), d: [T::constant(0.0); N] }
    }
    #[inline]
    fn overlaps(&self, other: &Self) -> bool {
        self.v.overlaps(&other.v)
    }
    #[inline]
    fn hull(self, other: Self) -> Self {
        Jet { v: self.v.hull(other.v), d: self.d }.with_unknown_tangents()
    }
    #[inline]
    fn with_unknown_tangents(self) -> Self {
        Jet { v: self.v, d: [T::constant(f64::NAN); N] }
    }
    #[inline]
    fn linearised<const K: usize>(value: f64, gradient: &[f64; K], arguments: &[Self; K]) -> Self {
        let v = T::linearised(value, gradient, &arguments.map(|a| a.v));
        let d = lanes(|k| {
            let mut sum = T::constant(0.0);
            for (a, &g) in arguments.iter().zip(gradient) {
                if !a.d[k].is_zero() {
                    sum = sum + a.d[k].scale(g);
                }
            }
            if arguments.iter().all(|a| a.d[k].is_zero()) {
                sum
            } else {
                sum.with_unknown_tangents()
            }
        });
        Jet { v, d }
    }

    #[inline]
    fn shift(self, c: f64) -> Self {
        Jet { v: self.v.shift(c), d: self.d }
    }
    #[inline]
    fn scale(self, c: f64) -> Self {
        let v = self.v.scale(c);
        if c.is_finite() && c != 0.0 {
            Jet { v, d: lanes(|k| self.d[k].scale(c)) }
        } else {
            self.scale_at_corner(v, c)
        }
    }
    #[inline]
    fn over(self, c: f64) -> Self {
        let v = self.v.over(c);
        if c == 0.0 || c.is_nan() {
            self.chain(v, T::constant(c.recip()))
        } else {
            Jet { v, d: lanes(|k| self.d[k].over(c)) }
        }
    }
    #[inline]
    fn limit_product(self, other: Self) -> Self {
        self.chain2(other, self.v.limit_product(other.v), other.v, self.v)
    }
    #[inline]
    fn recip(self) -> Self {
        let r = self.v.recip();
        self.chain(r, -r.limit_product(r))
    }

    #[inline]
    fn powi(self, n: i32) -> Self {
        let slope = match n {
            0 => T::constant(0.0),
            1 => T::constant(1.0),
            i32::MIN => (self.v.powi(n) / self.v).scale(f64::from(n)),
            _ => self.v.powi(n - 1).scale(f64::from(n)),
        };
        self.chain(self.v.powi(n), slope)
    }
    #[inline]
    fn powf(self, p: f64) -> Self {
        let v = self.v.powf(p);
        self.chain(v, self.v.powf_slope(p, v))
    }
    /// The slope of `p w` with `w = xᵖ⁻¹` is `p (p−1) (w/x)`.
    #[inline]
    fn powf_slope(self, p: f64, v: Self) -> Self {
        if p == 0.0 {
            return Self::constant(0.0);
        }
        let slope = self.v.powf_slope(p, v.v);
        self.chain(slope, self.v.powf_slope(p - 1.0, slope.over(p)).scale(p))
    }
    /// `∂ₓ xʸ = y (v/x)`: the exponent `y − 1` would be rounded; `∂ᵧ xʸ = xʸ ln x` with the limit 0
    /// at `x = 0 < y` and `x = ∞, y < 0`.
    #[inline]
    fn pow(self, y: Self) -> Self {
        let v = self.v.pow(y.v);
        let (base, exponent) = (self.v.value(), y.v.value());
        let by_x = if y.v.is_zero() {
            T::constant(0.0)
        } else if v.value().is_normal() && (v.value() / base).is_normal() {
            y.v * (v / self.v)
        } else {
            y.v * self.v.pow(y.v.shift(-1.0))
        };
        let by_y = if base == 0.0 && exponent > 0.0 || base == f64::INFINITY && exponent < 0.0 {
            T::constant(0.0)
        } else {
            v * self.v.ln()
        };
        self.chain2(y, v, by_x, by_y)
    }
    #[inline]
    fn sqrt(self) -> Self {
        let s = self.v.sqrt();
        self.chain(s, s.abs().recip().scale(0.5))
    }
    /// `∛x / (3x)`: one rounding of the root enters, not two as in `1/(3 ∛x²)`.
    #[inline]
    fn cbrt(self) -> Self {
        let c = self.v.cbrt();
        let x = self.v.value();
        let slope = if x != 0.0 && x.is_finite() {
            c.over(3.0) / self.v
        } else {
            let r = c.recip();
            r.limit_product(r.over(3.0))
        };
        self.chain(c, slope)
    }
    #[inline]
    fn exp(self) -> Self {
        let e = self.v.exp();
        self.chain(e, e)
    }
    #[inline]
    fn exp_m1(self) -> Self {
        self.chain(self.v.exp_m1(), self.v.exp())
    }
    #[inline]
    fn ln(self) -> Self {
        let v = self.v.ln();
        if v.value().is_nan() { self.chain(v, v) } else { self.chain(v, self.v.abs().recip()) }
    }
    #[inline]
    fn ln_1p(self) -> Self {
        let v = self.v.ln_1p();
        if v.value().is_nan() { self.chain(v, v) } else { self.chain(v, self.v.shift(1.0).recip()) }
    }
    #[inline]
    fn log10(self) -> Self {
        let v = self.v.log10();
        let slope = T::rounded(std::f64::consts::LOG10_E) / self.v.abs();
        if v.value().is_nan() { self.chain(v, v) } else { self.chain(v, slope) }
    }
    #[inline]
    fn sin(self) -> Self {
        self.chain(self.v.sin(), self.v.cos())
    }
    #[inline]
    fn cos(self) -> Self {
        self.chain(self.v.cos(), -self.v.sin())
    }
    /// `tan' = 1 + tan²`.
    #[inline]
    fn tan(self) -> Self {
        let t = self.v.tan();
        self.chain(t, t.limit_product(t).shift(1.0))
    }
    /// `asin' = 1/√(1−x²)`.
    #[inline]
    fn asin(self) -> Self {
        self.chain(self.v.asin(), leg(self.v).recip())
    }
    #[inline]
    fn acos(self) -> Self {
        self.chain(self.v.acos(), -leg(self.v).recip())
    }
    /// `atan' = 1/(1+x²)`, for `|x| > 1` as `r²/(1+r²)` with `r = 1/x`: `x²` may overflow.
    #[inline]
    fn atan(self) -> Self {
        let slope = if self.v.value().abs() > 1.0 {
            let r = self.v.recip();
            let rr = r.limit_product(r);
            rr / rr.shift(1.0)
        } else {
            self.v.limit_product(self.v).shift(1.0).recip()
        };
        self.chain(self.v.atan(), slope)
    }
    /// `∂ = (x, −y) / (x² + y²)`, with the ratio `t` of the smaller to the larger argument: the
    /// squares may overflow.
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let (a, b) = (self.v, x.v);
        let (by_y, by_x) = if a.value().abs() <= b.value().abs() {
            let t = a / b;
            let by_y = (b * t.limit_product(t).shift(1.0)).recip();
            (by_y, -(t * by_y))
        } else {
            let t = b / a;
            let by_x = (a * t.limit_product(t).shift(1.0)).recip();
            (t * by_x, -by_x)
        };
        self.chain2(x, a.atan2(b), by_y, by_x)
    }
    #[inline]
    fn sinh(self) -> Self {
        self.chain(self.v.sinh(), self.v.cosh())
    }
    #[inline]
    fn cosh(self) -> Self {
        self.chain(self.v.cosh(), self.v.sinh())
    }
    /// `tanh' = 1 − tanh²` for `|x| < 1/2`; elsewhere that cancels, and it is `4e/(1+e)²` with
    /// `e = exp(−2|x|)`, which never overflows.
    #[inline]
    fn tanh(self) -> Self {
        let t = self.v.tanh();
        let slope = if t.value().abs() < 0.46 {
            (-t.limit_product(t)).shift(1.0)
        } else {
            let e = self.v.abs().scale(-2.0).exp();
            let sum = e.shift(1.0);
            e.scale(4.0) / sum.limit_product(sum)
        };
        self.chain(t, slope)
    }
    /// `∂ = (x, y)/r`, as `(1, t)/√(1 + t²)` with `t` the ratio of the smaller to the larger: `x/r`
    /// would cancel in the second derivative.
    #[inline]
    fn hypot(self, y: Self) -> Self {
        let (a, b) = (self.v, y.v);
        let r = a.hypot(b);
        let (a_may_vanish, b_may_vanish) = (may_be_zero(a), may_be_zero(b));
        if a_may_vanish && b_may_vanish {
            return self.chain2(y, r, unit_slopes(), unit_slopes());
        }
        if r.value() == 0.0 {
            return Jet { v: r, d: [T::constant(0.0); N] };
        }
        let a_is_larger = if a_may_vanish || b_may_vanish {
            b_may_vanish
        } else {
            a.value().abs() >= b.value().abs()
        };
        let (larger, t) = if a_is_larger { (a, b / a) } else { (b, a / b) };
        let major =
            t.limit_product(t).shift(1.0).sqrt().recip().scale(1_f64.copysign(larger.value()));
        if a_is_larger {
            self.chain2(y, r, major, t * major)
        } else {
            self.chain2(y, r, t * major, major)
        }
    }
    /// `(x ln x)' = ln x + 1`.
    #[inline]
    fn xlogx(self) -> Self {
        self.chain(self.v.xlogx(), self.v.ln().shift(1.0))
    }
    #[inline]
    fn abs(self) -> Self {
        let v = self.v.abs();
        if v.value().is_nan() {
            self.chain(v, v)
        } else if may_be_zero(self.v) {
            self.chain(v, unit_slopes())
        } else if self.value() < 0.0 {
            -self
        } else {
            Jet { v, d: self.d }
        }
    }
    #[inline]
    fn max(self, other: Self) -> Self {
        let (a, b) = (self.value(), other.value());
        if a.is_nan() || b.is_nan() {
            self.unknown(other, self.v.max(other.v))
        } else if T::ENCLOSES && self.v.overlaps(&other.v) {
            self.either(other, self.v.max(other.v))
        } else if a >= b {
            self
        } else {
            other
        }
    }
    #[inline]
    fn min(self, other: Self) -> Self {
        let (a, b) = (self.value(), other.value());
        if a.is_nan() || b.is_nan() {
            self.unknown(other, self.v.min(other.v))
        } else if T::ENCLOSES && self.v.overlaps(&other.v) {
            self.either(other, self.v.min(other.v))
        } else if a <= b {
            self
        } else {
            other
        }
    }
    #[inline]
    fn select(s: Self, a: Self, b: Self) -> Self {
        if s.value().is_nan() {
            let v = T::select(s.v, a.v, b.v);
            s.chain2(a.chain2(b, v, v, v), v, v, T::constant(1.0))
        } else if may_be_zero(s.v) {
            Self::undecided(s, a, b)
        } else if s.value() > 0.0 {
            a
        } else {
            b
        }
    }
}
