//! [`Real`]: the number a model sees, with operators on both sides.

use super::Scalar;
use std::iter::{Product, Sum};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A real number inside a model; `D` says what is carried along with its value.
///
/// Works with `f64`, integer literals and references on either side:
///
/// ```
/// use mcp_core::{Real, Scalar};
/// fn f<D: Scalar>(x: Real<D>, c: &[f64]) -> Real<D> {
///     3.0 * x + 2 * x - c[0] / (1 + x).powi(2)
/// }
/// assert_eq!(f(Real::<f64>::from(1.0), &[4.0]).into_scalar(), 4.0);
/// ```
///
/// Two integer literals divide as integers before they meet a `Real`: `1 / 2 * x` is `0 * x`; write
/// `1.0 / 2.0`, or `x / 2`.
///
/// There is deliberately no comparison: see the [module page](super).
#[must_use = "an expression has no effect of its own"]
#[repr(transparent)]
#[derive(Clone, Copy, Debug)]
pub struct Real<D: Scalar>(pub(crate) D);

impl<D: Scalar> Real<D> {
    /// Wraps a number of the engine's arithmetic.
    #[inline]
    pub fn from_scalar(value: D) -> Self {
        Real(value)
    }

    /// The number of the engine's arithmetic: for engines and tests. A model that branches on it
    /// hides one arm from derivative and pattern.
    #[doc(hidden)]
    #[inline]
    pub fn into_scalar(self) -> D {
        self.0
    }
}

impl<D: Scalar> From<f64> for Real<D> {
    #[inline]
    fn from(v: f64) -> Self {
        Real(D::constant(v))
    }
}

impl<D: Scalar> From<i32> for Real<D> {
    #[inline]
    fn from(v: i32) -> Self {
        Real(D::constant(f64::from(v)))
    }
}

impl<D: Scalar> From<&f64> for Real<D> {
    #[inline]
    fn from(v: &f64) -> Self {
        Real(D::constant(*v))
    }
}

/// One operator: `Real ∘ Real`, `Real ∘ f64`, `f64 ∘ Real`, the same with `i32`, and every
/// combination with references.
macro_rules! operator {
    ($Op:ident $op:ident, $OpAssign:ident $op_assign:ident,
     $real:expr, $right:expr, $left:expr) => {
        impl<D: Scalar> $Op for Real<D> {
            type Output = Real<D>;
            #[inline]
            fn $op(self, other: Real<D>) -> Real<D> {
                let apply: fn(D, D) -> D = $real;
                Real(apply(self.0, other.0))
            }
        }
        impl<D: Scalar> $Op<f64> for Real<D> {
            type Output = Real<D>;
            #[inline]
            fn $op(self, c: f64) -> Real<D> {
                let apply: fn(D, f64) -> D = $right;
                Real(apply(self.0, c))
            }
        }
        impl<D: Scalar> $Op<Real<D>> for f64 {
            type Output = Real<D>;
            #[inline]
            fn $op(self, x: Real<D>) -> Real<D> {
                let apply: fn(f64, D) -> D = $left;
                Real(apply(self, x.0))
            }
        }
        impl<D: Scalar> $Op<i32> for Real<D> {
            type Output = Real<D>;
            #[inline]
            fn $op(self, c: i32) -> Real<D> {
                $Op::$op(self, f64::from(c))
            }
        }
        impl<D: Scalar> $Op<Real<D>> for i32 {
            type Output = Real<D>;
            #[inline]
            fn $op(self, x: Real<D>) -> Real<D> {
                $Op::$op(f64::from(self), x)
            }
        }
        by_reference!($Op $op, Real<D>, Real<D>);
        by_reference!($Op $op, Real<D>, f64);
        by_reference!($Op $op, f64, Real<D>);
        by_reference!($Op $op, Real<D>, i32);
        by_reference!($Op $op, i32, Real<D>);

        impl<D: Scalar, R> $OpAssign<R> for Real<D>
        where
            Real<D>: $Op<R, Output = Real<D>>,
        {
            #[inline]
            fn $op_assign(&mut self, other: R) {
                *self = $Op::$op(*self, other);
            }
        }
    };
}

macro_rules! by_reference {
    ($Op:ident $op:ident, $Left:ty, $Right:ty) => {
        impl<D: Scalar> $Op<&$Right> for $Left {
            type Output = Real<D>;
            #[inline]
            fn $op(self, other: &$Right) -> Real<D> {
                $Op::$op(self, *other)
            }
        }
        impl<D: Scalar> $Op<$Right> for &$Left {
            type Output = Real<D>;
            #[inline]
            fn $op(self, other: $Right) -> Real<D> {
                $Op::$op(*self, other)
            }
        }
        impl<D: Scalar> $Op<&$Right> for &$Left {
            type Output = Real<D>;
            #[inline]
            fn $op(self, other: &$Right) -> Real<D> {
                $Op::$op(*self, *other)
            }
        }
    };
}

operator!(Add add, AddAssign add_assign, |a, b| a + b, |a, c| a.shift(c), |c, b| b.shift(c));
operator!(Sub sub, SubAssign sub_assign, |a, b| a - b, |a, c| a.shift(-c), |c, b| (-b).shift(c));
operator!(Mul mul, MulAssign mul_assign, |a, b| a * b, |a, c| a.scale(c), |c, b| b.scale(c));
operator!(Div div, DivAssign div_assign, |a, b| a / b, |a, c| a.over(c), |c, b| D::constant(c) / b);

impl<D: Scalar> Neg for Real<D> {
    type Output = Real<D>;
    #[inline]
    fn neg(self) -> Real<D> {
        Real(-self.0)
    }
}

impl<D: Scalar> Neg for &Real<D> {
    type Output = Real<D>;
    #[inline]
    fn neg(self) -> Real<D> {
        Real(-self.0)
    }
}

impl<D: Scalar> Sum for Real<D> {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        super::sum(terms, |term| term)
    }
}

impl<D: Scalar> Product for Real<D> {
    fn product<I: Iterator<Item = Self>>(factors: I) -> Self {
        super::prod(factors, |factor| factor)
    }
}
