//! The Fischer–Burmeister function ([Fis92](crate#references)), free of cancellation and overflow.

/// `√(a² + b²)`, without the scaling of `hypot` where squares are harmless.
#[inline]
fn radius(a: f64, b: f64) -> f64 {
    let square = a * a + b * b;
    if (1e-280..1e280).contains(&square) { square.sqrt() } else { a.hypot(b) }
}

/// Whether something made of two finite numbers is beyond the largest one.
#[inline]
fn overflows(a: f64, b: f64, made: f64) -> bool {
    made.is_infinite() && a.is_finite() && b.is_finite()
}

/// `φ(a, b) = a + b − √(a² + b²)`, relative error at most 4 eps.
///
/// For `a + b > 0` the two terms cancel, and `φ = 2ab / (a + b + r)` is evaluated as
/// `2 max · (min / (a + b + r))`, which neither overflows nor underflows. NaN gives NaN.
///
/// ```
/// use mcp_core::ncp::fischer_burmeister;
/// assert_eq!(fischer_burmeister(1e12, 1e-5), 1e-5); // the textbook form gives 0
/// ```
#[inline]
pub fn fischer_burmeister(a: f64, b: f64) -> f64 {
    let r = radius(a, b);
    let sum = a + b;
    if overflows(a, b, sum + r) {
        // φ(ta, tb) = t φ(a, b).
        return 4.0 * fischer_burmeister(0.25 * a, 0.25 * b);
    }
    if sum > 0.0 {
        let (larger, smaller) = if a > b { (a, b) } else { (b, a) };
        2.0 * larger * (smaller / (sum + r))
    } else {
        sum - r
    }
}

/// `[∂φ/∂a, ∂φ/∂b] = [1 − a/r, 1 − b/r]`, relative error at most 4 eps; both lie in `[0, 2]`.
///
/// At the kink `a = b = 0` this is `[1 − 1/√2, 1 − 1/√2]`, the element along `(1, 1)`; where the
/// direction matters use [`kink_element`].
#[inline]
pub fn fischer_burmeister_derivative(a: f64, b: f64) -> [f64; 2] {
    let r = radius(a, b);
    if r == 0.0 {
        return kink_element(1.0, 1.0);
    }
    if overflows(a, b, r + a.max(b)) {
        return fischer_burmeister_derivative(0.25 * a, 0.25 * b);
    }
    // 1 − a/r = b² / (r (r + a)) for a > 0.
    let towards = |a: f64, b: f64| if a > 0.0 { (b / r) * (b / (r + a)) } else { 1.0 - a / r };
    [towards(a, b), towards(b, a)]
}

/// The limit of the derivative at `a = b = 0` along `(da, db)`: an element of the
/// B-subdifferential. Zero or non-finite directions count as `(1, 1)`.
#[inline]
pub fn kink_element(da: f64, db: f64) -> [f64; 2] {
    let r = radius(da, db);
    if r > 0.0 && r.is_finite() {
        fischer_burmeister_derivative(da, db)
    } else {
        [1.0 - std::f64::consts::FRAC_1_SQRT_2; 2]
    }
}

#[cfg(test)]
#[path = "fischer_burmeister_tests.rs"]
mod tests;
