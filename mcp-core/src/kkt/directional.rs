//! [`Directional`]: a number and its derivative along one variable, its operations behind calls.

use crate::scalar::{Jet, Scalar};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// [`Jet<1, D>`](Jet) for the functions of programs. A user's compiler meets every function in every
/// arithmetic of a model, nested; of this one it compiles calls.
#[derive(Clone, Copy, Debug)]
pub(super) struct Directional<D: Scalar>(Jet<1, D>);

impl<D: Scalar> Directional<D> {
    /// A variable, and whether it is the one of the derivative.
    pub(super) fn new(v: D, along: bool) -> Self {
        Directional(Jet { v, d: [D::constant(if along { 1.0 } else { 0.0 })] })
    }
    pub(super) fn value_in_base(self) -> D {
        self.0.v
    }
    pub(super) fn derivative(self) -> D {
        self.0.d[0]
    }
}

macro_rules! operators {
    ($($Op:ident $op:ident),*) => { $(
        impl<D: Scalar> $Op for Directional<D> {
            type Output = Self;
            #[inline(never)]
            fn $op(self, other: Self) -> Self {
                Directional($Op::$op(self.0, other.0))
            }
        }
    )* };
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl<D: Scalar> Neg for Directional<D> {
    type Output = Self;
    #[inline(never)]
    fn neg(self) -> Self {
        Directional(-self.0)
    }
}

macro_rules! functions {
    ($($name:ident($($x:ident)?; $($other:ident),*; $($c:ident: $C:ty),*))*) => { $(
        #[inline(never)]
        fn $name($($x,)? $($other: Self,)* $($c: $C),*) -> Self {
            Directional(Jet::$name($($x.0,)? $($other.0,)* $($c),*))
        }
    )* };
}

impl<D: Scalar> Scalar for Directional<D> {
    const LANES: usize = 1;

    #[inline]
    fn seed(v: f64, lane: usize) -> Self {
        Directional(Jet::seed(v, lane))
    }
    #[inline]
    fn tangent(&self, lane: usize) -> f64 {
        self.0.tangent(lane)
    }
    #[inline]
    fn value(&self) -> f64 {
        self.0.value()
    }
    #[inline(never)]
    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
    #[inline(never)]
    fn is_finite(&self) -> bool {
        self.0.is_finite()
    }
    fn linearised<const K: usize>(value: f64, gradient: &[f64; K], arguments: &[Self; K]) -> Self {
        Directional(Jet::linearised(value, gradient, &arguments.map(|a| a.0)))
    }

    #[inline(never)]
    fn powf_slope(self, p: f64, v: Self) -> Self {
        Directional(self.0.powf_slope(p, v.0))
    }

    functions! {
        constant(; ; v: f64)
        with_unknown_tangents(self; ; )
        shift(self; ; c: f64)
        scale(self; ; c: f64)
        over(self; ; c: f64)
        limit_product(self; other; )
        recip(self; ; )
        powi(self; ; n: i32)
        powf(self; ; p: f64)
        pow(self; y; )
        sqrt(self; ; )
        cbrt(self; ; )
        exp(self; ; )
        exp_m1(self; ; )
        ln(self; ; )
        ln_1p(self; ; )
        log10(self; ; )
        sin(self; ; )
        cos(self; ; )
        tan(self; ; )
        asin(self; ; )
        acos(self; ; )
        atan(self; ; )
        atan2(self; x; )
        sinh(self; ; )
        cosh(self; ; )
        tanh(self; ; )
        hypot(self; y; )
        xlogx(self; ; )
        abs(self; ; )
        max(self; other; )
        min(self; other; )
        select(; s, a, b; )
    }
}
