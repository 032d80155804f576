//! num-dual's types as [`Scalar`]s: the second opinion on every derivative.
//!
//! The second opinion must not share formulas with [`Jet`], so num-dual's own functions are called.
//! Their answer is kept where every part is finite and the value agrees with the `f64` function to
//! 4 ulp. Elsewhere (`powf` at 0, `sqrt(0)`, `tanh(800)`, `atan2(1, 0)`, an infinite slope times a
//! zero tangent, ...) num-dual 0.15 is known to be wrong, and the limits of the
//! [corner table](super#values-and-derivatives-at-the-corners) take its place: value, gradient and
//! second derivatives of a nested [`Jet`], composed with the parts of the arguments.
//!
//! The operators are num-dual's own: `a / b` is `a · (1/b)`, so its value may differ from the `f64`
//! quotient by 1.5 ulp and is infinite or 0 where `1/b` is. `pow` with a `Real` exponent is
//! `exp(y ln x)` there, and loses more than 4 ulp once `|y ln x|` exceeds about 8.

mod parts;

use super::{Jet, Scalar};
use num_dual::{Dual2_64, Dual64, DualNum, DualSVec64, HyperDual64};
use parts::{Expansion, Parts};

/// Whether num-dual's value is within 4 ulp of the `f64` one.
fn agrees(value: f64, plain: f64) -> bool {
    value - plain == 0.0
        || value.is_sign_negative() == plain.is_sign_negative()
            && value.to_bits().abs_diff(plain.to_bits()) <= 4
}

/// num-dual's `answer` where it is right, else the composition of the limits of `f`.
fn checked<T: Parts + Scalar, const K: usize>(
    arguments: [T; K],
    answer: T,
    plain: impl Fn([f64; K]) -> f64,
    f: impl Fn([Jet<K, Jet<K>>; K]) -> Jet<K, Jet<K>>,
) -> T {
    let x = arguments.map(|a| Scalar::value(&a));
    if Scalar::is_finite(&answer) && agrees(answer.value(), plain(x)) {
        answer
    } else {
        T::compose(&arguments, &Expansion::of(x, f))
    }
}

/// The undefined number: NaN wherever an argument has a tangent.
fn undefined<T: Parts, const K: usize>(arguments: [T; K]) -> T {
    T::compose(&arguments, &Expansion::linear(f64::NAN, [f64::NAN; K]))
}

/// `a` or `b`, undefined if either value is.
fn kink<T: Parts + Scalar>(a: T, b: T, first: bool) -> T {
    if Scalar::value(&a).is_nan() || Scalar::value(&b).is_nan() {
        undefined([a, b])
    } else if first {
        a
    } else {
        b
    }
}

macro_rules! unary {
    ($($function:ident)*) => {$(
        fn $function(self) -> Self {
            let answer = DualNum::$function(&self);
            checked([self], answer, |[x]| Scalar::$function(x), |[x]| x.$function())
        }
    )*};
}

macro_rules! scalar {
    ($([$($generic:tt)*] $Type:ty),* $(,)?) => {$(
        impl<$($generic)*> Scalar for $Type {
            const LANES: usize = <Self as Parts>::DIRECTIONS;

            fn constant(v: f64) -> Self {
                Self::from_re(v)
            }
            fn seed(v: f64, lane: usize) -> Self {
                if lane < Self::LANES { Self::variable(v, lane) } else { Self::from_re(v) }
            }
            fn tangent(&self, lane: usize) -> f64 {
                self.first_order(lane)
            }
            fn value(&self) -> f64 {
                self.re
            }
            fn is_zero(&self) -> bool {
                self.re == 0.0 && self.all_parts(|part| part == 0.0)
            }
            fn is_finite(&self) -> bool {
                self.re.is_finite() && self.all_parts(f64::is_finite)
            }
            fn with_unknown_tangents(self) -> Self {
                let all_directions = (0..Self::LANES).map(|k| Self::variable(0.0, k));
                undefined([all_directions.fold(Self::from_re(0.0), |sum, a| sum + a)]).at(self.re)
            }
            fn linearised<const K: usize>(
                value: f64,
                gradient: &[f64; K],
                arguments: &[Self; K],
            ) -> Self {
                Self::compose(arguments, &Expansion::linear(value, *gradient))
            }

            fn shift(self, c: f64) -> Self {
                self + c
            }
            fn scale(self, c: f64) -> Self {
                if c == 0.0 {
                    Self::from_re(self.re * c)
                } else {
                    checked([self], self * c, |[x]| x * c, |[x]| x.scale(c))
                }
            }
            fn over(self, c: f64) -> Self {
                checked([self], self / c, |[x]| x / c, |[x]| x.over(c))
            }
            /// num-dual multiplies `n (n − 1)` in `i32`: larger powers would overflow there.
            fn powi(self, n: i32) -> Self {
                let small = n.unsigned_abs() < 1 << 15;
                let answer = if small { DualNum::powi(&self, n) } else { undefined([self]) };
                checked([self], answer, |[x]| Scalar::powi(x, n), |[x]| x.powi(n))
            }
            fn powf(self, p: f64) -> Self {
                let answer = DualNum::powf(&self, p);
                checked([self], answer, |[x]| x.powf(p), |[x]| x.powf(p))
            }
            fn powf_slope(self, p: f64, _v: Self) -> Self {
                if p == 0.0 {
                    Self::from_re(0.0)
                } else {
                    Scalar::scale(Scalar::powf(self, p - 1.0), p)
                }
            }
            fn pow(self, y: Self) -> Self {
                checked([self, y], self.powd(y), |[x, y]| x.powf(y), |[x, y]| x.pow(y))
            }
            /// num-dual divides by `x²` and squares `y/x`: slopes would underflow to 0 unnoticed.
            fn atan2(self, x: Self) -> Self {
                let moderate = |v: f64| v == 0.0 || (1e-75..1e75).contains(&v.abs());
                let answer = if moderate(self.re) && moderate(x.re) {
                    DualNum::atan2(&self, x)
                } else {
                    undefined([self, x])
                };
                checked([self, x], answer, |[y, x]| y.atan2(x), |[y, x]| y.atan2(x))
            }
            /// `√(x² + y²)` where the squares neither over- nor underflow.
            fn hypot(self, y: Self) -> Self {
                let answer = DualNum::sqrt(&(self * self + y * y));
                checked([self, y], answer, |[x, y]| x.hypot(y), |[x, y]| x.hypot(y))
            }
            fn xlogx(self) -> Self {
                let answer = self * DualNum::ln(&self);
                checked([self], answer, |[x]| x.xlogx(), |[x]| x.xlogx())
            }
            fn abs(self) -> Self {
                if self.re.is_nan() {
                    undefined([self])
                } else if self.re < 0.0 {
                    -self
                } else {
                    self.at(self.re.abs())
                }
            }
            fn max(self, other: Self) -> Self {
                kink(self, other, self.re >= other.re)
            }
            fn min(self, other: Self) -> Self {
                kink(self, other, self.re <= other.re)
            }
            fn select(s: Self, a: Self, b: Self) -> Self {
                if s.re.is_nan() {
                    undefined([s, a, b])
                } else if s.re > 0.0 {
                    a
                } else {
                    b
                }
            }

            /// For `|x| > 1` as `2/(1 + exp(−2|x|)) − 1`: the slope of num-dual's `sinh/cosh` cancels.
            fn tanh(self) -> Self {
                let answer = if self.re.abs() > 1.0 {
                    let t = DualNum::exp(&(Scalar::abs(self) * -2.0));
                    (DualNum::recip(&(t + 1.0)) * 2.0 - 1.0) * self.re.signum()
                } else {
                    DualNum::tanh(&self)
                };
                checked([self], answer, |[x]| x.tanh(), |[x]| x.tanh())
            }

            unary! { recip sqrt cbrt exp exp_m1 ln ln_1p log10 sin cos tan asin acos atan sinh cosh }
        }
    )*};
}

scalar! { [] Dual64, [const N: usize] DualSVec64<N>, [] Dual2_64, [] HyperDual64 }
