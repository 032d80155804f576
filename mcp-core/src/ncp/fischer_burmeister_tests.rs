use super::*;
use proptest::prelude::*;

/// Numbers of any sign and magnitude between 1e-150 and 1e150.
fn wide() -> impl Strategy<Value = f64> {
    (-150.0..150.0_f64, any::<bool>())
        .prop_map(|(e, negative)| if negative { -10_f64.powf(e) } else { 10_f64.powf(e) })
}

#[test]
fn textbook_cancellations_are_exact_to_the_last_digits() {
    // (a, b, φ): the literal formula, which Siconos uses, returns 0, inf or 4 % errors.
    let cases = [
        (1e8, 1e-9, 1e-9),
        (1e8, 1e-7, 1e-7),
        (1.0, 1e-17, 1e-17),
        (1e12, 1e-5, 1e-5),
        (1e-16, 1.0, 1e-16),
        (-1e-9, 1000.0, -1e-9),
        (-1.0, -1e-20, -2.0),
        (1e200, 1.0, 1.0),
    ];
    for (a, b, exact) in cases {
        for value in [fischer_burmeister(a, b), fischer_burmeister(b, a)] {
            assert!((value - exact).abs() <= 1e-11 * f64::abs(exact), "φ({a}, {b}) = {value}");
        }
    }
    let huge = fischer_burmeister(1e200, 1e200);
    assert!((huge / 1e200 - (2.0 - 2_f64.sqrt())).abs() < 1e-15);
    let tiny = fischer_burmeister(1e-200, 1e-200);
    assert!((tiny / 1e-200 - (2.0 - 2_f64.sqrt())).abs() < 1e-15);
}

#[test]
fn the_largest_numbers_are_no_exception() {
    const MAX: f64 = f64::MAX;
    for b in [-1.0, 3.0] {
        assert!((fischer_burmeister(MAX, b) / b - 1.0).abs() <= 4.0 * f64::EPSILON);
    }
    for (a, b) in [(1e308, 1e308), (MAX, MAX), (1e308, 5e307)] {
        let scaled = fischer_burmeister(a / 16.0, b / 16.0) * 16.0;
        assert!((fischer_burmeister(a, b) / scaled - 1.0).abs() < 1e-15);
        let [da, db] = fischer_burmeister_derivative(a / 16.0, b / 16.0);
        assert_eq!(fischer_burmeister_derivative(a, b), [da, db]);
    }
}

#[test]
fn nan_is_never_hidden() {
    for (a, b) in [(f64::NAN, 0.0), (0.0, f64::NAN), (f64::NAN, f64::NAN)] {
        assert!(fischer_burmeister(a, b).is_nan());
    }
}

proptest! {
    #[test]
    fn phi_vanishes_exactly_at_complementary_pairs(a in wide()) {
        prop_assert_eq!(fischer_burmeister(a.abs(), 0.0), 0.0);
        prop_assert_eq!(fischer_burmeister(0.0, a.abs()), 0.0);
        prop_assert!(fischer_burmeister(-a.abs(), 0.0) < 0.0);
        prop_assert!(fischer_burmeister(0.0, -a.abs()) < 0.0);
    }

    #[test]
    fn phi_has_the_sign_of_the_smaller_argument(a in wide(), b in wide()) {
        let phi = fischer_burmeister(a, b);
        prop_assert_eq!(phi > 0.0, a > 0.0 && b > 0.0);
        prop_assert_eq!(phi.to_bits(), fischer_burmeister(b, a).to_bits());
    }

    #[test]
    fn phi_is_within_constants_of_the_minimum(a in wide(), b in wide()) {
        // (2 − √2) |min| <= |φ| <= (2 + √2) |min|.
        let (phi, min) = (fischer_burmeister(a, b).abs(), a.min(b).abs());
        let slack = 1.0 + 8.0 * f64::EPSILON;
        prop_assert!(phi * slack >= (2.0 - 2_f64.sqrt()) * min);
        prop_assert!(phi <= (2.0 + 2_f64.sqrt()) * min * slack);
    }

    #[test]
    fn phi_is_positively_homogeneous(a in wide(), b in wide(), k in -100..100_i32) {
        let t = 2_f64.powi(k);
        let scaled = fischer_burmeister(t * a, t * b);
        prop_assert!((scaled - t * fischer_burmeister(a, b)).abs() <= 8.0 * f64::EPSILON * scaled.abs());
    }

    #[test]
    fn the_derivative_satisfies_euler_and_lies_on_the_circle(a in wide(), b in wide()) {
        // φ is homogeneous of degree 1: φ = a φ_a + b φ_b; (1 − φ_a)² + (1 − φ_b)² = 1.
        let [da, db] = fischer_burmeister_derivative(a, b);
        prop_assert!((0.0..=2.0).contains(&da) && (0.0..=2.0).contains(&db));
        let circle = (1.0 - da).powi(2) + (1.0 - db).powi(2);
        prop_assert!((circle - 1.0).abs() <= 16.0 * f64::EPSILON);
        let euler = a * da + b * db;
        let terms = (a * da).abs() + (b * db).abs();
        prop_assert!((euler - fischer_burmeister(a, b)).abs() <= 8.0 * f64::EPSILON * terms);
    }

    #[test]
    fn the_kink_element_is_the_limit_along_its_direction(a in wide(), b in wide()) {
        let limit = fischer_burmeister_derivative(1e-5 * a, 1e-5 * b);
        let element = kink_element(a, b);
        for (x, y) in limit.iter().zip(element) {
            // Units in the last place, also of subnormal numbers.
            prop_assert!((x - y).abs() <= 8.0 * f64::EPSILON * y.abs().max(f64::MIN_POSITIVE));
        }
    }
}
