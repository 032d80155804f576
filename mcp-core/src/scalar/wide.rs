//! [`Wide`]: [`Jet`] with 16 lanes, its operations behind calls.

use super::{Jet, Scalar};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The lanes of [`Wide`].
type Lanes = Jet<16>;

/// [`Jet<16>`](Jet) for the rows of models. A user's compiler meets every row in every arithmetic; of
/// this one it compiles calls, which are short against 16 lanes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wide(Lanes);

macro_rules! operators {
    ($($Op:ident $op:ident),*) => { $(
        impl $Op for Wide {
            type Output = Wide;
            #[inline(never)]
            fn $op(self, other: Wide) -> Wide {
                Wide($Op::$op(self.0, other.0))
            }
        }
    )* };
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Wide {
    type Output = Wide;
    #[inline(never)]
    fn neg(self) -> Wide {
        Wide(-self.0)
    }
}

macro_rules! functions {
    ($($name:ident($($x:ident)?; $($other:ident),*; $($c:ident: $C:ty),*))*) => { $(
        #[inline(never)]
        fn $name($($x,)? $($other: Wide,)* $($c: $C),*) -> Wide {
            Wide(Lanes::$name($($x.0,)? $($other.0,)* $($c),*))
        }
    )* };
}

impl Scalar for Wide {
    const LANES: usize = Lanes::LANES;

    #[inline]
    fn seed(v: f64, lane: usize) -> Self {
        Wide(Lanes::seed(v, lane))
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
        Wide(Lanes::linearised(value, gradient, &arguments.map(|a| a.0)))
    }

    /// Not behind a call: it is repeated for all terms of a sum.
    #[inline]
    fn accumulate(&mut self, term: Wide) {
        self.0 = self.0 + term.0;
    }

    #[inline(never)]
    fn powf_slope(self, p: f64, v: Wide) -> Wide {
        Wide(self.0.powf_slope(p, v.0))
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

#[cfg(test)]
#[path = "wide_tests.rs"]
mod tests;
