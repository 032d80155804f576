//! The functions of the field over [`Interval`].

use super::{Interval, ends, outward};
use crate::scalar::Scalar;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Units in the last place by which functions other than `+ − × ÷ √` are widened.
const FUNCTION_ULPS: usize = 4;

/// `[lower, upper]`, [`FUNCTION_ULPS`] outwards.
fn widened(lower: f64, upper: f64) -> Interval {
    if !(lower <= upper) {
        return Interval::UNDEFINED;
    }
    let widen = |x: f64, step: fn(f64) -> f64| (0..FUNCTION_ULPS).fold(x, |x, _| step(x));
    Interval { lower: widen(lower, f64::next_down), upper: widen(upper, f64::next_up) }
}

impl Interval {
    /// `f` where it rises.
    fn rising(self, f: fn(f64) -> f64) -> Self {
        widened(f(self.lower), f(self.upper))
    }

    /// Undefined unless all numbers lie in `[lower, upper]`, the domain of a function.
    fn in_domain(self, lower: f64, upper: f64) -> Self {
        if self.lower >= lower && self.upper <= upper { self } else { Self::UNDEFINED }
    }

    /// Without the numbers outside `[lower, upper]`, which a function does not take.
    fn limited(self, lower: f64, upper: f64) -> Self {
        if self.is_undefined() {
            return self;
        }
        Interval { lower: self.lower.max(lower), upper: self.upper.min(upper) }
    }

    fn is_bounded(self) -> bool {
        self.lower.is_finite() && self.upper.is_finite()
    }

    /// Whether it may contain one of `offset + k · period`. The error of the quotients is below the
    /// margin; far from 0 the answer is yes.
    fn may_meet(self, offset: f64, period: f64) -> bool {
        let first = (self.lower - offset) / period;
        let last = (self.upper - offset) / period;
        let margin = 8.0 * f64::EPSILON * (1.0 + first.abs() + last.abs());
        (first - margin).ceil() <= (last + margin).floor()
    }

    /// A wave between −1 and 1 with crests at `crest + 2πk` and troughs half a period later.
    fn wave(self, f: fn(f64) -> f64, crest: f64) -> Self {
        if !self.is_bounded() {
            return Self::UNDEFINED;
        }
        let [lower, upper] = ends([f(self.lower), f(self.upper)]);
        let lower = if self.may_meet(crest + PI, TAU) { -1.0 } else { lower };
        let upper = if self.may_meet(crest, TAU) { 1.0 } else { upper };
        widened(lower, upper).limited(-1.0, 1.0)
    }

    /// `xⁿ` for one `x >= 0`, by repeated squaring.
    fn natural_power(x: f64, n: u32) -> Self {
        let (mut power, mut square, mut left) = (None, Self::point(x), n);
        while left > 0 {
            if left & 1 == 1 {
                power = Some(power.map_or(square, |power| power * square));
            }
            left >>= 1;
            if left > 0 {
                square = square * square;
            }
        }
        power.unwrap_or(Self::point(1.0)).limited(0.0, f64::INFINITY)
    }

    /// `xⁿ`, `n >= 0`: even powers of the absolute value, odd ones rise.
    fn natural(self, n: u32) -> Self {
        if self.is_undefined() {
            return self;
        }
        if n.is_multiple_of(2) {
            let lower = Self::natural_power(self.mignitude(), n).lower;
            return Interval { lower, upper: Self::natural_power(self.magnitude(), n).upper };
        }
        let odd = |x: f64| {
            let power = Self::natural_power(x.abs(), n);
            if x < 0.0 { -power } else { power }
        };
        Interval { lower: odd(self.lower).lower, upper: odd(self.upper).upper }
    }

    /// `xᵖ` of nonnegative numbers: monotone in `x` and in `p`, so that the ends of both decide.
    fn real_power(self, p: Self) -> Self {
        if self.is_undefined() {
            return self;
        }
        let power = |x: f64, p: f64| f64::powf(x, p);
        let [lower, upper] = ends([
            power(self.lower, p.lower),
            power(self.lower, p.upper),
            power(self.upper, p.lower),
            power(self.upper, p.upper),
        ]);
        widened(lower, upper).limited(0.0, f64::INFINITY)
    }
}

impl Scalar for Interval {
    const LANES: usize = 0;
    const ENCLOSES: bool = true;

    fn constant(v: f64) -> Self {
        Self::point(v)
    }
    fn rounded(v: f64) -> Self {
        outward(v, v)
    }
    fn seed(v: f64, _lane: usize) -> Self {
        Self::point(v)
    }
    fn tangent(&self, _lane: usize) -> f64 {
        0.0
    }
    /// A number in the middle, finite, and 0 only if 0 is the middle; NaN if undefined.
    fn value(&self) -> f64 {
        let (lower, upper) = (self.lower.max(f64::MIN), self.upper.min(f64::MAX));
        let middle = 0.5 * lower + 0.5 * upper;
        if self.is_undefined() {
            f64::NAN
        } else if lower == upper || middle == 0.0 && lower == 0.0 {
            upper
        } else {
            middle
        }
    }
    fn is_zero(&self) -> bool {
        self.is_exactly_zero()
    }
    fn is_finite(&self) -> bool {
        self.is_bounded()
    }
    fn with_unknown_tangents(self) -> Self {
        self
    }
    /// A function known at one point only says nothing about an interval.
    fn linearised<const K: usize>(_: f64, _: &[f64; K], _: &[Self; K]) -> Self {
        Self::UNDEFINED
    }
    fn overlaps(&self, other: &Self) -> bool {
        !(self.upper < other.lower || other.upper < self.lower)
    }
    fn hull(self, other: Self) -> Self {
        self.union(other)
    }

    fn shift(self, c: f64) -> Self {
        self + Self::point(c)
    }
    fn scale(self, c: f64) -> Self {
        self * Self::point(c)
    }
    fn over(self, c: f64) -> Self {
        self / Self::point(c)
    }
    fn recip(self) -> Self {
        Self::point(1.0) / self
    }
    fn powi(self, n: i32) -> Self {
        let power = self.natural(n.unsigned_abs());
        if n >= 0 { power } else { power.recip() }
    }
    #[allow(clippy::cast_possible_truncation, reason = "an integer in the range of `i32`")]
    fn powf(self, p: f64) -> Self {
        if p == p.trunc() && p.abs() <= f64::from(i32::MAX) {
            self.powi(p as i32)
        } else if p.is_finite() {
            self.in_domain(0.0, f64::INFINITY).real_power(Self::point(p))
        } else {
            Self::UNDEFINED
        }
    }
    /// `p` may be the rounded difference of an exponent and 1 or 2. Such differences are exact above
    /// −½; below, `p v / x` with `p` widened contains the slopes of both.
    fn powf_slope(self, p: f64, v: Self) -> Self {
        if p <= -0.5 {
            let p = Self::new(p.next_down().next_down(), p.next_up().next_up());
            p * v / self
        } else if p == p.trunc() {
            self.powf(p - 1.0).scale(p)
        } else {
            Scalar::pow(self, Self::point(p).shift(-1.0)).scale(p)
        }
    }
    /// Undefined where 0 meets an exponent that may be 0 or negative.
    fn pow(self, y: Self) -> Self {
        if y.lower == y.upper {
            return self.powf(y.lower);
        }
        let touches_pole = self.lower <= 0.0 && y.lower <= 0.0;
        if touches_pole || y.is_undefined() {
            return Self::UNDEFINED;
        }
        self.in_domain(0.0, f64::INFINITY).real_power(y)
    }
    fn sqrt(self) -> Self {
        let x = self.in_domain(0.0, f64::INFINITY);
        outward(x.lower.sqrt(), x.upper.sqrt()).limited(0.0, f64::INFINITY)
    }
    fn cbrt(self) -> Self {
        self.rising(f64::cbrt)
    }
    fn exp(self) -> Self {
        self.rising(f64::exp).limited(0.0, f64::INFINITY)
    }
    fn exp_m1(self) -> Self {
        self.rising(f64::exp_m1).limited(-1.0, f64::INFINITY)
    }
    fn ln(self) -> Self {
        self.in_domain(0.0, f64::INFINITY).rising(f64::ln)
    }
    fn ln_1p(self) -> Self {
        self.in_domain(-1.0, f64::INFINITY).rising(f64::ln_1p)
    }
    fn log10(self) -> Self {
        self.in_domain(0.0, f64::INFINITY).rising(f64::log10)
    }
    fn sin(self) -> Self {
        self.wave(f64::sin, FRAC_PI_2)
    }
    fn cos(self) -> Self {
        self.wave(f64::cos, 0.0)
    }
    fn tan(self) -> Self {
        if !self.is_bounded() {
            Self::UNDEFINED
        } else if self.may_meet(FRAC_PI_2, PI) {
            Self::WHOLE
        } else {
            self.rising(f64::tan)
        }
    }
    fn asin(self) -> Self {
        self.in_domain(-1.0, 1.0).rising(f64::asin)
    }
    fn acos(self) -> Self {
        let x = self.in_domain(-1.0, 1.0);
        widened(x.upper.acos(), x.lower.acos()).limited(0.0, f64::INFINITY)
    }
    fn atan(self) -> Self {
        self.rising(f64::atan)
    }
    /// Monotone along every edge of a box that the cut, the negative half of the axis `y = 0`, does
    /// not meet.
    fn atan2(self, x: Self) -> Self {
        let y = self;
        let meets_cut = x.lower <= 0.0 && y.contains(0.0) && !(x.upper < 0.0 && y.lower == 0.0);
        if meets_cut || !y.is_bounded() || !x.is_bounded() {
            return Self::UNDEFINED;
        }
        // `+ 0.0`: the angle of −0 is that of the other side of the cut.
        let angle = |y: f64, x: f64| f64::atan2(y + 0.0, x + 0.0);
        let [lower, upper] = ends([
            angle(y.lower, x.lower),
            angle(y.lower, x.upper),
            angle(y.upper, x.lower),
            angle(y.upper, x.upper),
        ]);
        widened(lower, upper)
    }
    fn sinh(self) -> Self {
        self.rising(f64::sinh)
    }
    fn cosh(self) -> Self {
        widened(self.mignitude().cosh(), self.magnitude().cosh()).limited(1.0, f64::INFINITY)
    }
    fn tanh(self) -> Self {
        self.rising(f64::tanh).limited(-1.0, 1.0)
    }
    fn hypot(self, y: Self) -> Self {
        if self.is_undefined() || y.is_undefined() {
            return Self::UNDEFINED;
        }
        let lower = self.mignitude().hypot(y.mignitude());
        widened(lower, self.magnitude().hypot(y.magnitude())).limited(0.0, f64::INFINITY)
    }
    /// Falls to `−1/e` at `x = 1/e` and rises from there.
    fn xlogx(self) -> Self {
        let x = self.in_domain(0.0, f64::INFINITY);
        if x.is_undefined() {
            return x;
        }
        let least = (-1_f64).exp();
        let may_contain_least = x.lower <= least * 1.001 && x.upper >= least * 0.999;
        let [lower, upper] = ends([Scalar::xlogx(x.lower), Scalar::xlogx(x.upper)]);
        widened(if may_contain_least { lower.min(-least) } else { lower }, upper)
    }
    fn abs(self) -> Self {
        if self.is_undefined() {
            return self;
        }
        Interval { lower: self.mignitude(), upper: self.magnitude() }
    }
    fn max(self, other: Self) -> Self {
        if self.is_undefined() || other.is_undefined() {
            return Self::UNDEFINED;
        }
        Interval { lower: self.lower.max(other.lower), upper: self.upper.max(other.upper) }
    }
    fn min(self, other: Self) -> Self {
        -(-self).max(-other)
    }
    fn select(s: Self, a: Self, b: Self) -> Self {
        if s.is_undefined() {
            s
        } else if s.lower > 0.0 {
            a
        } else if s.upper <= 0.0 {
            b
        } else {
            a.union(b)
        }
    }
}
