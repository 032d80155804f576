//! [`Interval`]: all the values a number may have.

mod functions;

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A closed interval of real numbers; an infinite end stands for numbers without limit.
///
/// Every operation contains the exact results for all numbers of its arguments ([Moo66](crate#references) and
/// [Neu90](crate#references)). **Assumption:** `+ − × ÷ √` of `f64` are correctly rounded (IEEE 754),
/// so that one unit in the last place outwards is enough; the other functions of `f64` err by at
/// most 4 units and are widened by 4. Integer powers are products.
///
/// Functions are undefined on a set that reaches outside their domain (`√` of a negative number,
/// `atan2` across its cut), and so is everything computed from them. Division by an interval with 0
/// gives the whole line. `max`, `min`, `abs` and `select` cover both arms where an interval does
/// not decide. A constant is taken as it is: `0.1` is the `f64` nearest to 1/10.
///
/// [`Jet<N, Interval>`](crate::Jet) carries enclosures of the derivatives: where a kink is undecided
/// the hull of both sides, where a `select` may jump nothing finite. The mean value theorem holds for
/// them wherever they are finite.
///
/// ```
/// use mcp_core::{Interval, Jet, Real, Scalar};
/// fn f<D: Scalar>(x: Real<D>) -> Real<D> {
///     x.powi(2) + (x - 1.0).abs()
/// }
/// let x = Jet::<1, Interval>::variable(Interval::new(0.5, 2.0), 0);
/// let y = f(Real::from_scalar(x)).into_scalar();
/// assert!(y.v.contains(0.75) && y.v.contains(5.0) && y.v.upper() < 5.01);
/// assert!(y.d[0].contains(2.0 * 0.5 - 1.0) && y.d[0].contains(2.0 * 2.0 + 1.0)); // 2x ± 1
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Below `+inf`.
    lower: f64,
    /// Above `-inf`.
    upper: f64,
}

impl Interval {
    /// All real numbers.
    pub const WHOLE: Interval = Interval { lower: f64::NEG_INFINITY, upper: f64::INFINITY };
    /// What a function gives outside its domain.
    pub const UNDEFINED: Interval = Interval { lower: f64::NAN, upper: f64::NAN };
    const ZERO: Interval = Interval { lower: 0.0, upper: 0.0 };

    /// `[lower, upper]`; undefined if they are crossed or not numbers. An infinite number is the
    /// interval of all that overflow.
    pub fn new(lower: f64, upper: f64) -> Self {
        if lower <= upper {
            Interval { lower: lower.min(f64::MAX), upper: upper.max(f64::MIN) }
        } else {
            Self::UNDEFINED
        }
    }

    /// `[v, v]`.
    pub fn point(v: f64) -> Self {
        Self::new(v, v)
    }

    /// The numbers no further than `distance >= 0` from `centre`, rounded outwards.
    pub fn around(centre: f64, distance: f64) -> Self {
        outward(centre - distance, centre + distance)
    }

    /// The smallest number; NaN if undefined.
    pub fn lower(&self) -> f64 {
        self.lower
    }

    /// The largest number; NaN if undefined.
    pub fn upper(&self) -> f64 {
        self.upper
    }

    /// Whether `x` is one of the numbers.
    pub fn contains(&self, x: f64) -> bool {
        self.lower <= x && x <= self.upper
    }

    /// Whether no number of this interval is an end of `other` or outside it.
    pub fn is_inside(&self, other: &Self) -> bool {
        other.lower < self.lower && self.upper < other.upper
    }

    /// Whether it has no numbers because a function was called outside its domain.
    pub fn is_undefined(&self) -> bool {
        self.lower.is_nan()
    }

    /// The largest absolute value; NaN if undefined.
    pub fn magnitude(&self) -> f64 {
        if self.is_undefined() { f64::NAN } else { self.lower.abs().max(self.upper.abs()) }
    }

    /// The smallest absolute value; NaN if undefined.
    pub fn mignitude(&self) -> f64 {
        if self.contains(0.0) { 0.0 } else { self.lower.abs().min(self.upper.abs()) }
    }

    /// The smallest interval that contains both; undefined if one of them is.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        if self.is_undefined() || other.is_undefined() {
            return Self::UNDEFINED;
        }
        Interval { lower: self.lower.min(other.lower), upper: self.upper.max(other.upper) }
    }

    fn is_exactly_zero(&self) -> bool {
        self.lower == 0.0 && self.upper == 0.0
    }

    /// The hull of `op` at the four pairs of ends, one unit outwards; all numbers where an end has
    /// no result (`0 · ∞`).
    fn at_corners(self, other: Self, op: fn(f64, f64) -> f64) -> Self {
        if self.is_undefined() || other.is_undefined() {
            return Self::UNDEFINED;
        }
        let corners = [
            op(self.lower, other.lower),
            op(self.lower, other.upper),
            op(self.upper, other.lower),
            op(self.upper, other.upper),
        ];
        if corners.iter().any(|corner| corner.is_nan()) {
            return Self::WHOLE;
        }
        let [lower, upper] = ends(corners);
        outward(lower, upper)
    }
}

/// Smallest and largest of numbers that are not NaN.
fn ends<const K: usize>(numbers: [f64; K]) -> [f64; 2] {
    [
        numbers.into_iter().fold(f64::INFINITY, f64::min),
        numbers.into_iter().fold(f64::MIN, f64::max),
    ]
}

/// `[lower, upper]`, one unit in the last place outwards.
fn outward(lower: f64, upper: f64) -> Interval {
    if lower <= upper {
        Interval { lower: lower.next_down(), upper: upper.next_up() }
    } else {
        Interval::UNDEFINED
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Interval { lower: -self.upper, upper: -self.lower }
    }
}

impl Add for Interval {
    type Output = Self;
    /// Adding 0 is exact.
    fn add(self, other: Self) -> Self {
        if self.is_exactly_zero() {
            other
        } else if other.is_exactly_zero() {
            self
        } else {
            outward(self.lower + other.lower, self.upper + other.upper)
        }
    }
}

impl Sub for Interval {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl, reason = "x − y = x + (−y), exactly")]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    /// Products with 1, −1 and, of bounded sets, with 0 are exact.
    fn mul(self, other: Self) -> Self {
        for (factor, x) in [(self, other), (other, self)] {
            if factor.lower == factor.upper && !x.is_undefined() {
                match factor.lower {
                    1.0 => return x,
                    -1.0 => return -x,
                    0.0 if x.lower.is_finite() && x.upper.is_finite() => return Self::ZERO,
                    _ => {}
                }
            }
        }
        self.at_corners(other, |a, b| a * b)
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if self.is_undefined() {
            Self::UNDEFINED
        } else if other.contains(0.0) {
            Self::WHOLE
        } else {
            self.at_corners(other, |a, b| a / b)
        }
    }
}
