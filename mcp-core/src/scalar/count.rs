//! [`Counted`]: what an evaluation costs, in operations instead of seconds.

#![allow(clippy::suspicious_arithmetic_impl, reason = "every operation adds to a count")]

use super::Scalar;
use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Operations of one or more evaluations, by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct OperationCounts {
    /// Additions, subtractions and negations.
    pub additions: u64,
    /// Multiplications; an integer power counts the squarings and products it takes.
    pub multiplications: u64,
    /// Divisions and reciprocals.
    pub divisions: u64,
    /// Roots, powers, exponentials, logarithms, trigonometric and hyperbolic functions, `hypot`,
    /// `atan2`, external functions.
    pub functions: u64,
    /// `max`, `min`, `abs`, `select`.
    pub selections: u64,
}

impl OperationCounts {
    /// All operations together.
    pub fn total(&self) -> u64 {
        self.additions + self.multiplications + self.divisions + self.functions + self.selections
    }
}

/// The counter that the [`Counted`] numbers of one evaluation share.
#[derive(Debug, Default)]
pub struct Tally(Cell<OperationCounts>);

impl Tally {
    /// A counter at zero.
    pub fn new() -> Self {
        Self::default()
    }
    /// An independent variable whose operations are counted here.
    pub fn variable(&self, value: f64) -> Counted<'_> {
        Counted { value, tally: Some(self) }
    }
    /// What was counted so far.
    pub fn counts(&self) -> OperationCounts {
        self.0.get()
    }
    fn update(&self, change: impl FnOnce(&mut OperationCounts)) {
        let mut counts = self.0.get();
        change(&mut counts);
        self.0.set(counts);
    }
}

/// A value that counts the operations done to it.
///
/// Operations among constants only are not counted: a model does those once, on data.
///
/// ```
/// use mcp_core::{Real, Scalar, Tally};
/// fn f<D: Scalar>(x: Real<D>) -> Real<D> {
///     3.0 * x * x + x.sqrt()
/// }
/// let tally = Tally::new();
/// f(Real::from_scalar(tally.variable(2.0)));
/// let counts = tally.counts();
/// assert_eq!((counts.multiplications, counts.additions, counts.functions), (2, 1, 1));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Counted<'t> {
    value: f64,
    tally: Option<&'t Tally>,
}

impl Counted<'_> {
    fn one(self, value: f64, kind: impl FnOnce(&mut OperationCounts)) -> Self {
        if let Some(tally) = self.tally {
            tally.update(kind);
        }
        Counted { value, ..self }
    }

    fn two(self, other: Self, value: f64, kind: impl FnOnce(&mut OperationCounts)) -> Self {
        Counted { value, tally: self.tally.or(other.tally) }.one(value, kind)
    }
}

impl Neg for Counted<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.one(-self.value, |c| c.additions += 1)
    }
}

impl Add for Counted<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.two(other, self.value + other.value, |c| c.additions += 1)
    }
}

impl Sub for Counted<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.two(other, self.value - other.value, |c| c.additions += 1)
    }
}

impl Mul for Counted<'_> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.two(other, self.value * other.value, |c| c.multiplications += 1)
    }
}

impl Div for Counted<'_> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.two(other, self.value / other.value, |c| c.divisions += 1)
    }
}

macro_rules! unary {
    ($kind:ident: $($function:ident)*) => {$(
        fn $function(self) -> Self {
            self.one(Scalar::$function(self.value), |c| c.$kind += 1)
        }
    )*};
}

macro_rules! binary {
    ($kind:ident: $($function:ident)*) => {$(
        fn $function(self, other: Self) -> Self {
            self.two(other, Scalar::$function(self.value, other.value), |c| c.$kind += 1)
        }
    )*};
}

/// Multiplications of `xⁿ` by repeated squaring.
fn multiplications_of_power(n: i32) -> u64 {
    let n = n.unsigned_abs();
    if n < 2 { 0 } else { u64::from(n.ilog2() + n.count_ones() - 1) }
}

impl Scalar for Counted<'_> {
    const LANES: usize = 0;

    fn constant(v: f64) -> Self {
        Counted { value: v, tally: None }
    }
    fn seed(v: f64, _lane: usize) -> Self {
        Self::constant(v)
    }
    fn tangent(&self, _lane: usize) -> f64 {
        0.0
    }
    fn value(&self) -> f64 {
        self.value
    }
    fn is_zero(&self) -> bool {
        self.value == 0.0
    }
    fn is_finite(&self) -> bool {
        self.value.is_finite()
    }
    fn with_unknown_tangents(self) -> Self {
        self
    }
    fn linearised<const K: usize>(value: f64, _: &[f64; K], arguments: &[Self; K]) -> Self {
        let tally = arguments.iter().find_map(|a| a.tally);
        Counted { value, tally }.one(value, |c| c.functions += 1)
    }

    fn shift(self, c: f64) -> Self {
        self.one(self.value + c, |c| c.additions += 1)
    }
    fn scale(self, c: f64) -> Self {
        self.one(self.value * c, |c| c.multiplications += 1)
    }
    fn over(self, c: f64) -> Self {
        self.one(self.value / c, |c| c.divisions += 1)
    }
    fn powi(self, n: i32) -> Self {
        self.one(Scalar::powi(self.value, n), |c| {
            c.multiplications += multiplications_of_power(n);
            c.divisions += u64::from(n < 0);
        })
    }
    fn powf(self, p: f64) -> Self {
        self.one(self.value.powf(p), |c| c.functions += 1)
    }
    fn powf_slope(self, p: f64, v: Self) -> Self {
        self.two(v, Scalar::powf_slope(self.value, p, v.value), |c| {
            c.multiplications += 1;
            c.divisions += 1;
        })
    }
    fn select(s: Self, a: Self, b: Self) -> Self {
        let value = Scalar::select(s.value, a.value, b.value);
        Counted { value, tally: s.tally.or(a.tally).or(b.tally) }.one(value, |c| c.selections += 1)
    }

    unary! { divisions: recip }
    unary! { functions: sqrt cbrt exp exp_m1 ln ln_1p log10 sin cos tan asin acos atan sinh cosh
    tanh xlogx }
    unary! { selections: abs }
    binary! { functions: pow atan2 hypot }
    binary! { selections: max min }
}
