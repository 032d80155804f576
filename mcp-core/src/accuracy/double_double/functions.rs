//! Functions of [`DoubleDouble`]: series after reduction, or one Newton step from the `f64` value.

use super::{DoubleDouble, two_product};
use crate::scalar::Scalar;

const HALF_PI: DoubleDouble =
    DoubleDouble { high: std::f64::consts::FRAC_PI_2, low: 6.123_233_995_736_766e-17 };
const LN_2: DoubleDouble =
    DoubleDouble { high: std::f64::consts::LN_2, low: 2.319_046_813_846_299_6e-17 };
const LN_10: DoubleDouble =
    DoubleDouble { high: std::f64::consts::LN_10, low: -2.170_756_223_382_249_4e-16 };

/// Terms of a series smaller than this share of its first one do not count.
const NEGLIGIBLE: f64 = 1e-34;

fn constant(v: f64) -> DoubleDouble {
    v.into()
}

/// `xⁿ` by repeated squaring, `1/xⁿ` for `n < 0`.
pub(super) fn powi(x: DoubleDouble, n: i32) -> DoubleDouble {
    let (mut power, mut square, mut left) = (constant(1.0), x, n.unsigned_abs());
    while left > 0 {
        if left & 1 == 1 {
            power = power * square;
        }
        left >>= 1;
        if left > 0 {
            square = square * square;
        }
    }
    if n < 0 { constant(1.0) / power } else { power }
}

/// `r + (x − r²)/(2r)` with `r = √high`.
pub(super) fn sqrt(x: DoubleDouble) -> DoubleDouble {
    let root = x.high.sqrt();
    if !root.is_finite() || root == 0.0 {
        return constant(root);
    }
    let rest = x - two_product(root, root);
    constant(root) + constant(rest.high / (2.0 * root))
}

/// `r + (x − r³)/(3r²)` with `r = ∛high`.
pub(super) fn cbrt(x: DoubleDouble) -> DoubleDouble {
    let root = x.high.cbrt();
    if !root.is_finite() || root == 0.0 {
        return constant(root);
    }
    let square = two_product(root, root);
    let rest = x - square * constant(root);
    constant(root) + constant(rest.high / (3.0 * square.high))
}

/// `e^(k ln 2 + r) = 2ᵏ (1 + (eʳ − 1))`.
pub(super) fn exp(x: DoubleDouble) -> DoubleDouble {
    let plain = x.high.exp();
    if !plain.is_finite() || plain == 0.0 {
        return constant(plain);
    }
    let k = (x.high / LN_2.high).round();
    let reduced = x - LN_2 * constant(k);
    #[allow(clippy::cast_possible_truncation, reason = "|k| < 1100 where exp is finite")]
    (exp_m1_near_zero(reduced) + constant(1.0)).times_power_of_two(k as i32)
}

/// `eʳ − 1` for `|r| <= 0.4`: the Taylor series of `r/512`, then nine times `e²ˢ − 1 = 2t + t²` with
/// `t = eˢ − 1`, which keeps the relative error.
fn exp_m1_near_zero(r: DoubleDouble) -> DoubleDouble {
    const HALVINGS: i32 = 9;
    let s = r.times_power_of_two(-HALVINGS);
    let (mut sum, mut term) = (s, s);
    for k in 2..12 {
        term = term * s / constant(f64::from(k));
        sum = sum + term;
        if term.high.abs() <= NEGLIGIBLE * s.high.abs() {
            break;
        }
    }
    for _ in 0..HALVINGS {
        sum = sum.times_power_of_two(1) + sum * sum;
    }
    sum
}

pub(super) fn exp_m1(x: DoubleDouble) -> DoubleDouble {
    if x.high.abs() <= 0.4 { exp_m1_near_zero(x) } else { exp(x) - constant(1.0) }
}

/// `y + (x e⁻ʸ − 1)` with `y = ln(high)`; near 1 a series, since that difference has only absolute
/// accuracy.
pub(super) fn ln(x: DoubleDouble) -> DoubleDouble {
    let plain = x.high.ln();
    if !plain.is_finite() {
        return constant(plain);
    }
    if (x.high - 1.0).abs() <= 0.1 {
        let difference = x - constant(1.0);
        return two_atanh(difference / (x + constant(1.0)));
    }
    // In two steps, so that e⁻ʸ neither over- nor underflows where x is near the limits.
    let half = 0.5 * plain;
    let step = x * exp(constant(-half)) * exp(constant(half - plain));
    constant(plain) + (step - constant(1.0))
}

/// `2 artanh s = 2 (s + s³/3 + s⁵/5 + …)` for `|s| <= 0.06`.
fn two_atanh(s: DoubleDouble) -> DoubleDouble {
    let square = s * s;
    let (mut sum, mut power) = (s, s);
    for k in 1..16 {
        power = power * square;
        sum = sum + power / constant(f64::from(2 * k + 1));
    }
    sum.times_power_of_two(1)
}

/// `ln(1 + x) = 2 artanh(x/(2 + x))`.
pub(super) fn ln_1p(x: DoubleDouble) -> DoubleDouble {
    if x.high.abs() <= 0.1 { two_atanh(x / (x + constant(2.0))) } else { ln(x + constant(1.0)) }
}

pub(super) fn log10(x: DoubleDouble) -> DoubleDouble {
    ln(x) / LN_10
}

/// `e^(y ln x)`; the corners, roots and integer powers as `f64` has them.
pub(super) fn pow(x: DoubleDouble, y: DoubleDouble) -> DoubleDouble {
    let plain = x.high.powf(y.high);
    if !plain.is_finite() || plain == 0.0 || y.high == 0.0 || x.high == 0.0 {
        return constant(plain);
    }
    if y.low == 0.0 {
        if y.high == 0.5 {
            return sqrt(x);
        }
        if y.high.fract() == 0.0 && y.high.abs() <= 64.0 {
            #[allow(clippy::cast_possible_truncation, reason = "an integer of at most 64")]
            return powi(x, y.high as i32);
        }
    }
    let size = exp(y * ln(x.abs()));
    if plain < 0.0 { -size } else { size }
}

/// Sine and cosine: Taylor series after `x = k π/2 + r`.
fn sin_cos(x: DoubleDouble) -> [DoubleDouble; 2] {
    if !(x.high.abs() <= 1e6) {
        // Reduction would leave no digits of double-double.
        return [x.high.sin(), x.high.cos()].map(constant);
    }
    let k = (x.high / HALF_PI.high).round();
    let r = x - HALF_PI * constant(k);
    let (sine, cosine) = (taylor(r, r, 1.0), taylor(constant(1.0), r, 0.0));
    match k.rem_euclid(4.0) {
        0.0 => [sine, cosine],
        1.0 => [cosine, -sine],
        2.0 => [-sine, -cosine],
        _ => [-cosine, sine],
    }
}

/// `t₀ + t₁ + …` with `tₖ₊₁ = −tₖ r²/((m+1)(m+2))`, where `m` is the degree of `tₖ`.
fn taylor(first: DoubleDouble, r: DoubleDouble, mut degree: f64) -> DoubleDouble {
    let square = -(r * r);
    let (mut sum, mut term) = (first, first);
    while term.high.abs() > NEGLIGIBLE * first.high.abs() {
        term = term * square / constant((degree + 1.0) * (degree + 2.0));
        sum = sum + term;
        degree += 2.0;
    }
    sum
}

pub(super) fn sin(x: DoubleDouble) -> DoubleDouble {
    sin_cos(x)[0]
}

pub(super) fn cos(x: DoubleDouble) -> DoubleDouble {
    sin_cos(x)[1]
}

pub(super) fn tan(x: DoubleDouble) -> DoubleDouble {
    let [sine, cosine] = sin_cos(x);
    sine / cosine
}

pub(super) fn atan(x: DoubleDouble) -> DoubleDouble {
    atan2(x, constant(1.0))
}

/// `a + (y cos a − x sin a)/(x cos a + y sin a)` with `a` the angle in `f64`: the angle between
/// `(x, y)` and the direction of `a`, so small that it is its tangent.
pub(super) fn atan2(y: DoubleDouble, x: DoubleDouble) -> DoubleDouble {
    let angle = y.high.atan2(x.high);
    let is_ordinary = y.high != 0.0 && x.is_finite() && y.is_finite();
    if !is_ordinary || angle.is_nan() {
        return constant(angle);
    }
    let larger = x.high.abs().max(y.high.abs());
    let (x, y) = (x / constant(larger), y / constant(larger));
    let [sine, cosine] = sin_cos(constant(angle));
    let rest = (y * cosine - x * sine) / (x * cosine + y * sine);
    constant(angle) + rest
}

/// The angle of `(√(1 − x²), x)`.
pub(super) fn asin(x: DoubleDouble) -> DoubleDouble {
    atan2(x, sqrt((constant(1.0) - x) * (constant(1.0) + x)))
}

/// The angle of `(x, √(1 − x²))`.
pub(super) fn acos(x: DoubleDouble) -> DoubleDouble {
    let leg = sqrt((constant(1.0) - x) * (constant(1.0) + x));
    atan2(leg, x)
}

/// `(t + t/(1 + t))/2` with `t = eˣ − 1`, which does not cancel.
pub(super) fn sinh(x: DoubleDouble) -> DoubleDouble {
    let size = exp_m1(x.abs());
    let plain = x.high.sinh();
    if !plain.is_finite() || !size.is_finite() {
        return constant(plain);
    }
    let sinh = (size + size / (size + constant(1.0))).times_power_of_two(-1);
    if x.high < 0.0 { -sinh } else { sinh }
}

pub(super) fn cosh(x: DoubleDouble) -> DoubleDouble {
    let size = exp(x.abs());
    if !size.is_finite() {
        return constant(x.high.cosh());
    }
    (size + constant(1.0) / size).times_power_of_two(-1)
}

/// `t/(t + 2)` with `t = e²ˣ − 1`; 1 beyond 40.
pub(super) fn tanh(x: DoubleDouble) -> DoubleDouble {
    if !(x.high.abs() <= 40.0) {
        return constant(x.high.tanh());
    }
    let t = exp_m1(x.times_power_of_two(1));
    t / (t + constant(2.0))
}

/// `m √((x/m)² + (y/m)²)` with `m` the larger of the two.
pub(super) fn hypot(x: DoubleDouble, y: DoubleDouble) -> DoubleDouble {
    let plain = x.high.hypot(y.high);
    if !plain.is_finite() || plain == 0.0 {
        return constant(plain);
    }
    let larger = constant(x.high.abs().max(y.high.abs()));
    let (x, y) = (x / larger, y / larger);
    larger * sqrt(x * x + y * y)
}

pub(super) fn xlogx(x: DoubleDouble) -> DoubleDouble {
    if x.high == 0.0 { constant(0.0) } else { x * ln(x) }
}
