//! [`Magnitude`]: how large the terms are that a derivative is summed from.

use super::{Jet, Scalar};
use std::array::from_fn;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value and, in `N` lanes, the sum of the absolute values of the terms of its derivative: the
/// chain rule with every factor replaced by its absolute value.
///
/// Rounding errors of a derivative are proportional to these sums, not to the derivative itself:
/// this is the yardstick of [`check_derivatives`](crate::check_derivatives).
///
/// ```
/// use mcp_core::{Magnitude, Scalar};
/// let x = Magnitude::<1>::seed(3.0, 0);
/// let y = x * x - x * x; // derivative 2x − 2x = 0 from terms of size 4x
/// assert_eq!((y.value(), y.tangent(0)), (0.0, 12.0));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Magnitude<const N: usize> {
    v: f64,
    d: [f64; N],
}

impl<const N: usize> Magnitude<N> {
    /// `f(x)` by its value and slope, found by [`Jet`].
    fn unary(self, f: impl FnOnce(Jet<1>) -> Jet<1>) -> Self {
        let y = f(Jet::seed(self.v, 0));
        Magnitude { v: y.v, d: from_fn(|k| size(self.d[k], y.d[0])) }
    }

    /// `f(x, y)` likewise.
    fn binary(self, other: Self, f: impl FnOnce(Jet<2>, Jet<2>) -> Jet<2>) -> Self {
        let y = f(Jet::seed(self.v, 0), Jet::seed(other.v, 1));
        Magnitude { v: y.v, d: from_fn(|k| size(self.d[k], y.d[0]) + size(other.d[k], y.d[1])) }
    }
}

/// `|tangent · slope|`; a zero tangent stays zero.
fn size(tangent: f64, slope: f64) -> f64 {
    if tangent == 0.0 { 0.0 } else { (tangent * slope).abs() }
}

macro_rules! operators {
    ($($Op:ident $op:ident),*) => {$(
        impl<const N: usize> $Op for Magnitude<N> {
            type Output = Self;
            fn $op(self, other: Self) -> Self {
                self.binary(other, $Op::$op)
            }
        }
    )*};
}

operators! { Add add, Sub sub, Mul mul, Div div }

impl<const N: usize> Neg for Magnitude<N> {
    type Output = Self;
    fn neg(self) -> Self {
        Magnitude { v: -self.v, ..self }
    }
}

macro_rules! unary {
    ($($function:ident)*) => {$(
        fn $function(self) -> Self {
            self.unary(Scalar::$function)
        }
    )*};
}

macro_rules! binary {
    ($($function:ident)*) => {$(
        fn $function(self, other: Self) -> Self {
            self.binary(other, Scalar::$function)
        }
    )*};
}

impl<const N: usize> Scalar for Magnitude<N> {
    const LANES: usize = N;

    fn constant(v: f64) -> Self {
        Magnitude { v, d: [0.0; N] }
    }
    fn seed(v: f64, lane: usize) -> Self {
        Magnitude { v, d: from_fn(|k| if k == lane { 1.0 } else { 0.0 }) }
    }
    /// Sum of the absolute terms of the derivative in `lane`.
    fn tangent(&self, lane: usize) -> f64 {
        self.d[lane]
    }
    fn value(&self) -> f64 {
        self.v
    }
    fn is_zero(&self) -> bool {
        self.v == 0.0 && self.d.iter().all(|&d| d == 0.0)
    }
    fn is_finite(&self) -> bool {
        self.v.is_finite() && self.d.iter().all(Scalar::is_finite)
    }
    fn with_unknown_tangents(self) -> Self {
        Magnitude { d: [f64::NAN; N], ..self }
    }
    fn linearised<const K: usize>(value: f64, gradient: &[f64; K], arguments: &[Self; K]) -> Self {
        let terms = |k: usize| arguments.iter().zip(gradient).map(move |(a, &g)| size(a.d[k], g));
        Magnitude { v: value, d: from_fn(|k| terms(k).sum()) }
    }

    fn shift(self, c: f64) -> Self {
        self.unary(|x| x.shift(c))
    }
    fn scale(self, c: f64) -> Self {
        self.unary(|x| x.scale(c))
    }
    fn over(self, c: f64) -> Self {
        self.unary(|x| x.over(c))
    }
    fn powi(self, n: i32) -> Self {
        self.unary(|x| x.powi(n))
    }
    fn powf(self, p: f64) -> Self {
        self.unary(|x| x.powf(p))
    }
    fn powf_slope(self, p: f64, _v: Self) -> Self {
        self.unary(|x| x.powf_slope(p, x.powf(p)))
    }
    fn max(self, other: Self) -> Self {
        self.binary(other, Scalar::max)
    }
    fn min(self, other: Self) -> Self {
        self.binary(other, Scalar::min)
    }
    fn select(s: Self, a: Self, b: Self) -> Self {
        a.binary(b, |a, b| Jet::select(Jet::constant(s.v), a, b))
    }

    unary! { recip sqrt cbrt exp exp_m1 ln ln_1p log10 sin cos tan asin acos atan sinh cosh tanh
    xlogx abs }
    binary! { pow atan2 hypot }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Real;
    use proptest::prelude::*;

    fn expression<D: Scalar>(x: Real<D>, y: Real<D>) -> Real<D> {
        (x * y - 3.0 * x).exp() / (1.0 + y * y) - (x - y).abs() + x.max(y).tanh()
    }

    proptest! {
        #[test]
        fn magnitudes_bound_derivatives_and_values_agree(x in -2.0..2.0, y in -2.0..2.0) {
            let magnitude = |v, k| Real::from_scalar(Magnitude::<2>::seed(v, k));
            let jet = |v, k| Real::from_scalar(Jet::<2>::seed(v, k));
            let size = expression(magnitude(x, 0), magnitude(y, 1)).into_scalar();
            let exact = expression(jet(x, 0), jet(y, 1)).into_scalar();
            prop_assert_eq!(size.v, exact.v);
            for k in 0..2 {
                prop_assert!(size.d[k] >= exact.d[k].abs() * (1.0 - 1e-14));
            }
        }
    }
}
