//! Twice the digits of `f64` and no over- or underflow: the reference for derivatives.

use std::f64::consts::{FRAC_PI_2, LN_2};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `(hi + lo) · 2^e` with `1 <= |hi| < 2`, or zero: about 104 significant bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wide {
    hi: f64,
    lo: f64,
    e: i64,
}

fn power_of_two(k: i64) -> f64 {
    f64::from_bits(u64::try_from(k + 1023).unwrap() << 52)
}

fn exponent(x: f64) -> i64 {
    i64::try_from(x.to_bits() >> 52 & 0x7ff).unwrap() - 1023
}

fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

fn two_product(a: f64, b: f64) -> (f64, f64) {
    (a * b, a.mul_add(b, -(a * b)))
}

impl Wide {
    pub(super) const ZERO: Wide = Wide { hi: 0.0, lo: 0.0, e: 0 };

    /// `hi` must be 0 or normal.
    fn new(hi: f64, lo: f64, e: i64) -> Self {
        let (hi, lo) = two_sum(hi, lo);
        if hi.to_bits() << 1 == 0 {
            return Wide::ZERO;
        }
        let k = exponent(hi);
        let (half, rest) = (power_of_two(-(k / 2)), power_of_two(k / 2 - k));
        Wide { hi: hi * half * rest, lo: lo * half * rest, e: e + k }
    }

    /// The number `2^-1074`.
    pub(super) fn smallest() -> Self {
        Wide { hi: 1.0, lo: 0.0, e: -1074 }
    }

    /// Whether it is beyond the largest `f64`.
    pub(super) fn overflows(self) -> bool {
        self.e >= 1024
    }

    /// Rounded; saturates at `±inf` and 0.
    pub(super) fn round(self) -> f64 {
        let half = self.e.clamp(-2100, 2100) / 2;
        let rest = self.e.clamp(-2100, 2100) - half;
        let step = |k: i64| power_of_two(k.clamp(-1022, 1023));
        (self.hi + self.lo) * step(half) * step(rest)
    }

    pub(super) fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    pub(super) fn sqrt(self) -> Self {
        if self.hi.to_bits() << 1 == 0 {
            return Wide::ZERO;
        }
        let odd = self.e.rem_euclid(2);
        let mantissa = Wide { e: odd, ..self };
        let root = Wide::from(mantissa.round().sqrt());
        let root = root + (mantissa - root * root) / (root + root);
        Wide { e: root.e + (self.e - odd) / 2, ..root }
    }

    /// Taylor series of `Σ rᵏ/k!` over `k = first, first + step, …`, with alternating sign if `step = 2`.
    fn series(self, first: u32, step: u32) -> Self {
        let mut term = (1..=first).fold(Wide::from(1.0), |t, k| t * self / f64::from(k).into());
        let (mut sum, mut k) = (term, first);
        while k < 32 {
            for _ in 0..step {
                k += 1;
                term = term * self / f64::from(k).into();
            }
            term = if step == 2 { -term } else { term };
            sum = sum + term;
        }
        sum
    }

    /// For `|x| < 1e6`.
    pub(super) fn exp(self) -> Self {
        let k = (self.round() / LN_2).round();
        let ln2 = Wide::new(LN_2, 2.319_046_813_846_299_6e-17, 0);
        let y = (self - Wide::from(k) * ln2).series(0, 1);
        #[allow(clippy::cast_possible_truncation, reason = "an integer below 2e6")]
        Wide { e: y.e + k as i64, ..y }
    }

    /// For `x > 0`: one Newton step from the `f64` logarithm of the mantissa.
    pub(super) fn ln(self) -> Self {
        let mantissa = Wide { e: 0, ..self };
        let y = Wide::from(self.hi.ln());
        let d = mantissa * (-y).exp() - 1.0.into();
        let ln2 = Wide::new(LN_2, 2.319_046_813_846_299_6e-17, 0);
        y + (d - d * d / 2.0.into()) + Wide::from(self.e as f64) * ln2
    }

    /// Sine and cosine, for `|x| < 1e6`.
    pub(super) fn sin_cos(self) -> (Self, Self) {
        let k = (self.round() / FRAC_PI_2).round();
        let half_pi = Wide::new(FRAC_PI_2, 6.123_233_995_736_766e-17, 0);
        let rest = Wide::from(k) * Wide::from(-1.497_384_904_859_169_8e-33);
        let r = self - Wide::from(k) * half_pi - rest;
        let (s, c) = (r.series(1, 2), r.series(0, 2));
        #[allow(clippy::cast_possible_truncation, reason = "an integer below 1e6")]
        match (k as i64).rem_euclid(4) {
            0 => (s, c),
            1 => (c, -s),
            2 => (-s, -c),
            _ => (-c, s),
        }
    }
}

impl From<f64> for Wide {
    fn from(x: f64) -> Self {
        if x.is_normal() {
            Wide::new(x, 0.0, 0)
        } else {
            Wide::new(x * power_of_two(100), 0.0, -100)
        }
    }
}

impl Neg for Wide {
    type Output = Wide;
    fn neg(self) -> Wide {
        Wide { hi: -self.hi, lo: -self.lo, ..self }
    }
}

impl Add for Wide {
    type Output = Wide;
    fn add(self, other: Wide) -> Wide {
        let (zero, other_zero) = (self.hi.to_bits() << 1 == 0, other.hi.to_bits() << 1 == 0);
        if zero || other_zero {
            return if zero { other } else { self };
        }
        let (a, b) = if self.e >= other.e { (self, other) } else { (other, self) };
        if a.e - b.e > 220 {
            return a;
        }
        let scale = power_of_two(b.e - a.e);
        let (s, t) = two_sum(a.hi, b.hi * scale);
        let (u, v) = two_sum(a.lo, b.lo * scale);
        let (s, t) = two_sum(s, t + u);
        Wide::new(s, t + v, a.e)
    }
}

impl Sub for Wide {
    type Output = Wide;
    fn sub(self, other: Wide) -> Wide {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Wide;
    fn mul(self, other: Wide) -> Wide {
        let (p, q) = two_product(self.hi, other.hi);
        Wide::new(p, q + (self.hi * other.lo + self.lo * other.hi), self.e + other.e)
    }
}

impl Div for Wide {
    type Output = Wide;
    fn div(self, other: Wide) -> Wide {
        let mantissa = Wide { e: 0, ..other };
        let quotient = |a: Wide| Wide::new(a.hi / mantissa.hi, 0.0, a.e);
        let first = quotient(self);
        let rest = self - first * mantissa;
        let second = quotient(rest);
        let third = quotient(rest - second * mantissa);
        let q = first + second + third;
        if q.hi.to_bits() << 1 == 0 { q } else { Wide { e: q.e - other.e, ..q } }
    }
}

#[test]
fn the_reference_has_thirty_digits() {
    let w = Wide::from;
    let error = |a: Wide, b: Wide| ((a - b) / b).abs().round();
    for x in [1e-9, 0.3, 2.0, 17.25, 300.0, 1e5] {
        let x = w(x);
        assert!(error(x.ln().exp(), x) < 1e-29);
        assert!(error(x.sqrt() * x.sqrt(), x) < 1e-30);
        assert!(error(w(1.0) / x * x, w(1.0)) < 1e-30);
        let (s, c) = x.sin_cos();
        assert!(error(s * s + c * c, w(1.0)) < 1e-30);
        let (s2, c2) = (x + x).sin_cos();
        assert!(error(s2, w(2.0) * s * c) < 1e-23, "sin 2x = 2 sin x cos x");
        assert!(error(c2, c * c - s * s) < 1e-23, "cos 2x = cos² x - sin² x");
    }
    assert!(error(w(700.0).exp() * w(-700.0).exp(), w(1.0)) < 1e-28);
    assert!((w(1.0).exp() - w(std::f64::consts::E)).round().abs() < 2e-16);
    assert!((w(1.0).exp().round() - std::f64::consts::E).abs() < 1e-18);
}
