//! [`Jet`]: a value with `N` exact tangents, over any base arithmetic.

use super::Scalar;
use std::array::from_fn;
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
    pub fn variable(v: T, lane: usize) -> Self {
        Jet { v, d: from_fn(|k| T::constant(if k == lane { 1.0 } else { 0.0 })) }
    }

    /// `f(x)` with `f(x) = v`, `f'(x) = slope`. Zero tangents stay zero where the slope is not
    /// finite.
    #[inline]
    fn chain(self, v: T, slope: T) -> Self {
        if slope.is_finite() {
            Jet { v, d: from_fn(|k| self.d[k] * slope) }
        } else {
            Jet { v, d: from_fn(|k| tangent_product(self.d[k], slope)) }
        }
    }

    /// `f(x, y)` with partial derivatives `fx`, `fy`.
    #[inline]
    fn chain2(self, other: Self, v: T, fx: T, fy: T) -> Self {
        if fx.is_finite() && fy.is_finite() {
            Jet { v, d: from_fn(|k| self.d[k] * fx + other.d[k] * fy) }
        } else {
            let d = from_fn(|k| tangent_product(self.d[k], fx) + tangent_product(other.d[k], fy));
            Jet { v, d }
        }
    }
}

/// `tangent · slope`, 0 where the tangent is 0.
#[inline]
fn tangent_product<T: Scalar>(tangent: T, slope: T) -> T {
    if tangent.is_zero() { tangent } else { tangent * slope }
}

impl<const N: usize, T: Scalar> Neg for Jet<N, T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Jet { v: -self.v, d: from_fn(|k| -self.d[k]) }
    }
}

impl<const N: usize, T: Scalar> Add for Jet<N, T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Jet { v: self.v + other.v, d: from_fn(|k| self.d[k] + other.d[k]) }
    }
}

impl<const N: usize, T: Scalar> Sub for Jet<N, T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Jet { v: self.v - other.v, d: from_fn(|k| self.d[k] - other.d[k]) }
    }
}

impl<const N: usize, T: Scalar> Mul for Jet<N, T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Jet {
            v: self.v * other.v,
            d: from_fn(|k| self.d[k] * other.v + other.d[k] * self.v),
        }
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
            Jet { v, d: from_fn(|k| (self.d[k] - other.d[k] * v) * inverse) }
        } else {
            let numerator = |k: usize| self.d[k] - tangent_product(other.d[k], v);
            Jet { v, d: from_fn(|k| tangent_product(numerator(k), inverse)) }
        }
    }
}

impl<const N: usize, T: Scalar> Scalar for Jet<N, T> {
    const LANES: usize = N;

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
    fn with_unknown_tangents(self) -> Self {
        Jet { v: self.v, d: [T::constant(f64::NAN); N] }
    }
    #[inline]
    fn linearised<const K: usize>(value: f64, gradient: &[f64; K], arguments: &[Self; K]) -> Self {
        let v = T::linearised(value, gradient, &arguments.map(|a| a.v));
        let d = from_fn(|k| {
            let mut sum = T::constant(0.0);
            for (a, &g) in arguments.iter().zip(gradient) {
                if !a.d[k].is_zero() {
                    sum = sum + a.d[k].scale(g);
                }
            }
            if arguments.iter().all(|a| a.d[k].is_zero()) { sum } else { sum.with_unknown_tangents() }
        });
        Jet { v, d }
    }

    #[inline]
    fn shift(self, c: f64) -> Self {
        Jet { v: self.v.shift(c), d: self.d }
    }
    #[inline]
    fn scale(self, c: f64) -> Self {
        if c == 0.0 {
            Jet { v: self.v.scale(c), d: [T::constant(0.0); N] }
        } else {
            Jet { v: self.v.scale(c), d: from_fn(|k| self.d[k].scale(c)) }
        }
    }
    #[inline]
    fn over(self, c: f64) -> Self {
        Jet { v: self.v.over(c), d: from_fn(|k| self.d[k].over(c)) }
    }
    #[inline]
    fn recip(self) -> Self {
        let r = self.v.recip();
        self.chain(r, -(r * r))
    }

    #[inline]
    fn powi(self, n: i32) -> Self {
        let slope = match n {
            0 => T::constant(0.0),
            1 => T::constant(1.0),
            _ => self.v.powi(n.saturating_sub(1)).scale(f64::from(n)),
        };
        self.chain(self.v.powi(n), slope)
    }
    #[inline]
    fn powf(self, p: f64) -> Self {
        let v = self.v.powf(p);
        self.chain(v, self.v.powf_slope(p, v))
    }
    #[inline]
    fn powf_slope(self, p: f64, _v: Self) -> Self {
        if p == 0.0 { Self::constant(0.0) } else { self.powf(p - 1.0).scale(p) }
    }
    /// `∂ₓ xʸ = y xʸ⁻¹`, `∂ᵧ xʸ = xʸ ln x` with the limit 0 at `x = 0 < y`.
    #[inline]
    fn pow(self, y: Self) -> Self {
        let v = self.v.pow(y.v);
        let exponent = y.v.value();
        let by_x = if exponent == 0.0 && y.v.is_zero() {
            T::constant(0.0)
        } else {
            y.v * self.v.pow(y.v.shift(-1.0))
        };
        let by_y = if self.v.value() == 0.0 && exponent > 0.0 {
            T::constant(0.0)
        } else {
            v * self.v.ln()
        };
        self.chain2(y, v, by_x, by_y)
    }
    #[inline]
    fn sqrt(self) -> Self {
        let s = self.v.sqrt();
        self.chain(s, s.recip().scale(0.5))
    }
    #[inline]
    fn cbrt(self) -> Self {
        let c = self.v.cbrt();
        self.chain(c, (c * c).scale(3.0).recip())
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
        let slope = self.v.abs().recip().scale(std::f64::consts::LOG10_E);
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
        self.chain(t, (t * t).shift(1.0))
    }
    /// `asin' = 1/√((1−x)(1+x))`: no cancellation near ±1.
    #[inline]
    fn asin(self) -> Self {
        let root = ((-self.v).shift(1.0) * self.v.shift(1.0)).sqrt();
        self.chain(self.v.asin(), root.recip())
    }
    #[inline]
    fn acos(self) -> Self {
        let root = ((-self.v).shift(1.0) * self.v.shift(1.0)).sqrt();
        self.chain(self.v.acos(), -root.recip())
    }
    /// `atan' = 1/(1+x²)`, for `|x| > 1` as `r²/(1+r²)` with `r = 1/x`: `x²` may overflow.
    #[inline]
    fn atan(self) -> Self {
        let slope = if self.v.value().abs() > 1.0 {
            let r = self.v.recip();
            let rr = r * r;
            rr / rr.shift(1.0)
        } else {
            (self.v * self.v).shift(1.0).recip()
        };
        self.chain(self.v.atan(), slope)
    }
    /// `∂ = (x, −y) / (x² + y²)`, divided twice by the radius: the square may overflow.
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let r = self.v.hypot(x.v);
        let by_y = x.v / r / r;
        let by_x = -(self.v / r / r);
        self.chain2(x, self.v.atan2(x.v), by_y, by_x)
    }
    #[inline]
    fn sinh(self) -> Self {
        self.chain(self.v.sinh(), self.v.cosh())
    }
    #[inline]
    fn cosh(self) -> Self {
        self.chain(self.v.cosh(), self.v.sinh())
    }
    /// `tanh' = sech²`: `1 − tanh²` would lose every digit for large arguments.
    #[inline]
    fn tanh(self) -> Self {
        let sech = self.v.cosh().recip();
        self.chain(self.v.tanh(), sech * sech)
    }
    #[inline]
    fn hypot(self, y: Self) -> Self {
        let r = self.v.hypot(y.v);
        if r.value() == 0.0 {
            Jet { v: r, d: [T::constant(0.0); N] }
        } else {
            self.chain2(y, r, self.v / r, y.v / r)
        }
    }
    /// `(x ln x)' = ln x + 1`.
    #[inline]
    fn xlogx(self) -> Self {
        self.chain(self.v.xlogx(), self.v.ln().shift(1.0))
    }
    #[inline]
    fn abs(self) -> Self {
        if self.value() < 0.0 { -self } else { Jet { v: self.v.abs(), d: self.d } }
    }
    #[inline]
    fn max(self, other: Self) -> Self {
        let (a, b) = (self.value(), other.value());
        if a.is_nan() || b.is_nan() {
            Self::constant(f64::NAN).with_unknown_tangents()
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
            Self::constant(f64::NAN).with_unknown_tangents()
        } else if a <= b {
            self
        } else {
            other
        }
    }
    #[inline]
    fn select(s: Self, a: Self, b: Self) -> Self {
        let s = s.value();
        if s.is_nan() {
            Self::constant(f64::NAN).with_unknown_tangents()
        } else if s > 0.0 {
            a
        } else {
            b
        }
    }
}
