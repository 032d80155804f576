//! `φ(a, b) = a + b − √(a² + b²)` where the literal formula returns 0, ∞ or NaN.

use mcp_core::ncp::{fischer_burmeister, fischer_burmeister_derivative};

/// `a² + b² = c²` in integers, so that `φ(a, b) = a + b − c` is exact. With `b = 2m`, `a = m² − 1`
/// large, all but half of the digits cancel.
fn triples() -> Vec<[f64; 3]> {
    let mut triples = vec![[3.0, 4.0, 5.0], [5.0, 12.0, 13.0], [20.0, 21.0, 29.0], [0.0, 1.0, 1.0]];
    triples.extend([3, 11, 20, 25].map(|k| {
        let m = 2_f64.powi(k);
        [m * m - 1.0, 2.0 * m, m * m + 1.0]
    }));
    triples
}

#[test]
fn phi_is_exact_to_four_units_at_every_magnitude_and_sign() {
    for [a, b, c] in triples() {
        for k in (-1000..=960).step_by(20) {
            let unit = 2_f64.powi(k);
            for (a, b) in [(a, b), (a, -b), (-a, b), (-a, -b)] {
                let (exact, (a, b)) = ((a + b - c) * unit, (a * unit, b * unit));
                for value in [fischer_burmeister(a, b), fischer_burmeister(b, a)] {
                    let error = (value - exact).abs();
                    assert!(
                        error <= 4.0 * f64::EPSILON * exact.abs(),
                        "φ({a:e}, {b:e}) = {value:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn the_derivative_is_exact_to_four_units_at_every_magnitude_and_sign() {
    for [a, b, c] in triples() {
        for k in (-1000..=960).step_by(20) {
            let unit = 2_f64.powi(k);
            for (a, b) in [(a, b), (a, -b), (-a, b), (-a, -b)] {
                let exact = [(c - a) / c, (c - b) / c];
                let value = fischer_burmeister_derivative(a * unit, b * unit);
                for (value, exact) in value.iter().zip(exact) {
                    let error = (value - exact).abs();
                    assert!(error <= 4.0 * f64::EPSILON * exact, "at ({a:e}, {b:e}) 2^{k}");
                }
            }
        }
    }
}

#[test]
fn zeros_of_either_sign_and_infinities_have_values() {
    for a in [0.0, -0.0] {
        for b in [0.0, -0.0] {
            assert_eq!(fischer_burmeister(a, b), 0.0);
            let derivative = fischer_burmeister_derivative(a, b);
            assert!(derivative.iter().all(|d| (d - (1.0 - 0.5_f64.sqrt())).abs() < 1e-16));
        }
    }
    // The smallest and the largest positive numbers.
    let (tiny, huge) = (f64::from_bits(1), f64::MAX);
    assert!((fischer_burmeister(tiny, 1.0) - tiny).abs() <= tiny);
    assert!((fischer_burmeister(huge, tiny) - tiny).abs() <= tiny);
    assert_eq!(fischer_burmeister(-huge, tiny), -f64::INFINITY, "−2 · MAX");
    assert!(fischer_burmeister(huge, huge).is_finite());
}
