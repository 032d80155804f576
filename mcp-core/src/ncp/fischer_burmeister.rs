//! The Fischer–Burmeister function ([Fis92](crate#references)), free of cancellation and overflow.

/// `a² + b²` where neither it nor anything made of its root over- or underflows.
#[inline]
fn ordinary_square(a: f64, b: f64) -> Option<f64> {
    let square = a * a + b * b;
    (1e-280..1e280).contains(&square).then_some(square)
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
    match ordinary_square(a, b) {
        Some(square) => with_radius(a, b, square.sqrt()),
        None => at_the_extremes(a, b),
    }
}

#[inline]
fn with_radius(a: f64, b: f64, r: f64) -> f64 {
    let sum = a + b;
    if sum > 0.0 {
        let (larger, smaller) = if a > b { (a, b) } else { (b, a) };
        2.0 * larger * (smaller / (sum + r))
    } else {
        sum - r
    }
}

/// Whether something made of two finite numbers is beyond the largest one.
fn overflows(a: f64, b: f64, made: f64) -> bool {
    made.is_infinite() && a.is_finite() && b.is_finite()
}

#[cold]
fn at_the_extremes(a: f64, b: f64) -> f64 {
    let r = a.hypot(b);
    if overflows(a, b, a + b + r) {
        // φ(ta, tb) = t φ(a, b).
        let (a, b) = (0.25 * a, 0.25 * b);
        return 4.0 * with_radius(a, b, a.hypot(b));
    }
    with_radius(a, b, r)
}

/// `[∂φ/∂a, ∂φ/∂b] = [1 − a/r, 1 − b/r]`, relative error at most 4 eps; both lie in `[0, 2]`.
///
/// Where `a > 0` the first cancels and is `(b/r) · (b/(r + a))`; likewise the second. At the kink
/// `a = b = 0` this is `[1 − 1/√2, 1 − 1/√2]`, the element along `(1, 1)`; where the direction
/// matters use [`kink_element`].
#[inline]
pub fn fischer_burmeister_derivative(a: f64, b: f64) -> [f64; 2] {
    match ordinary_square(a, b) {
        Some(square) => derivative_with_radius(a, b, square.sqrt()),
        None => derivative_at_the_extremes(a, b),
    }
}

#[inline]
fn derivative_with_radius(a: f64, b: f64, r: f64) -> [f64; 2] {
    let towards = |a: f64, b: f64| if a > 0.0 { (b / r) * (b / (r + a)) } else { 1.0 - a / r };
    [towards(a, b), towards(b, a)]
}

#[cold]
fn derivative_at_the_extremes(a: f64, b: f64) -> [f64; 2] {
    let r = a.hypot(b);
    if r == 0.0 {
        return [1.0 - std::f64::consts::FRAC_1_SQRT_2; 2];
    }
    if overflows(a, b, r + a.max(b)) {
        let (a, b) = (0.25 * a, 0.25 * b);
        return derivative_with_radius(a, b, a.hypot(b));
    }
    derivative_with_radius(a, b, r)
}

/// The limit of the derivative at `a = b = 0` along `(da, db)`: an element of the
/// B-subdifferential. Zero or non-finite directions count as `(1, 1)`.
#[inline]
pub fn kink_element(da: f64, db: f64) -> [f64; 2] {
    let is_direction = (da != 0.0 || db != 0.0) && da.is_finite() && db.is_finite();
    let (da, db) = if is_direction { (da, db) } else { (1.0, 1.0) };
    fischer_burmeister_derivative(da, db)
}

#[cfg(test)]
#[path = "fischer_burmeister_tests.rs"]
mod tests;
