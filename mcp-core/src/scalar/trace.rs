//! [`Trace`]: which variables a number depends on.

use super::Scalar;
use std::ops::{Add, BitOr, Div, Mul, Neg, Sub};

/// A value and the set of variables it was computed from, a window of 128 of them at a time.
///
/// Run through a model it gives the rows of the pattern. Both arms of `max`, `min`, `abs` and
/// `select` are recorded, so the pattern does not depend on the point. It is a structural superset:
/// `x − x` depends on `x`.
#[derive(Clone, Copy, Debug)]
pub struct Trace {
    value: f64,
    reads: u128,
    second_order: bool,
}

impl Trace {
    /// Whether the number depends on the variable seeded in `lane`.
    pub fn depends_on(&self, lane: usize) -> bool {
        lane < Self::LANES && self.reads >> lane & 1 == 1
    }

    /// Whether its second derivatives are known: false once an
    /// [`external`](super::external()) function entered it.
    pub fn has_second_order(&self) -> bool {
        self.second_order
    }

    fn map(self, value: f64) -> Self {
        Trace { value, ..self }
    }

    fn join(self, other: Self, value: f64) -> Self {
        Trace {
            value,
            reads: self.reads.bitor(other.reads),
            second_order: self.second_order && other.second_order,
        }
    }
}

impl Neg for Trace {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(-self.value)
    }
}

impl Add for Trace {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.join(other, self.value + other.value)
    }
}

impl Sub for Trace {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.join(other, self.value - other.value)
    }
}

impl Mul for Trace {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.join(other, self.value * other.value)
    }
}

impl Div for Trace {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.join(other, self.value / other.value)
    }
}

macro_rules! unary {
    ($($function:ident)*) => {$(
        fn $function(self) -> Self {
            self.map(Scalar::$function(self.value))
        }
    )*};
}

macro_rules! binary {
    ($($function:ident)*) => {$(
        fn $function(self, other: Self) -> Self {
            self.join(other, Scalar::$function(self.value, other.value))
        }
    )*};
}

impl Scalar for Trace {
    const LANES: usize = 128;

    fn constant(v: f64) -> Self {
        Trace { value: v, reads: 0, second_order: true }
    }
    fn seed(v: f64, lane: usize) -> Self {
        let reads = if lane < Self::LANES { 1 << lane } else { 0 };
        Trace { value: v, reads, second_order: true }
    }
    /// 1 where the number depends on the lane's variable, 0 elsewhere.
    fn tangent(&self, lane: usize) -> f64 {
        if self.depends_on(lane) { 1.0 } else { 0.0 }
    }
    fn value(&self) -> f64 {
        self.value
    }
    fn is_zero(&self) -> bool {
        self.value == 0.0 && self.reads == 0
    }
    fn is_finite(&self) -> bool {
        self.value.is_finite()
    }
    fn with_unknown_tangents(self) -> Self {
        self
    }
    fn linearised<const K: usize>(value: f64, _: &[f64; K], arguments: &[Self; K]) -> Self {
        let joined = arguments.iter().fold(Self::constant(value), |all, &a| all.join(a, value));
        Trace { second_order: joined.reads == 0, ..joined }
    }

    fn shift(self, c: f64) -> Self {
        self.map(self.value + c)
    }
    fn scale(self, c: f64) -> Self {
        self.map(self.value * c)
    }
    fn over(self, c: f64) -> Self {
        self.map(self.value / c)
    }
    fn powi(self, n: i32) -> Self {
        self.map(Scalar::powi(self.value, n))
    }
    fn powf(self, p: f64) -> Self {
        self.map(self.value.powf(p))
    }
    fn powf_slope(self, p: f64, v: Self) -> Self {
        self.join(v, Scalar::powf_slope(self.value, p, v.value))
    }
    fn select(s: Self, a: Self, b: Self) -> Self {
        s.join(a, 0.0).join(b, Scalar::select(s.value, a.value, b.value))
    }

    unary! { recip sqrt cbrt exp exp_m1 ln ln_1p log10 sin cos tan asin acos atan sinh cosh tanh
    xlogx abs }
    binary! { pow atan2 hypot max min }
}
