//! What `Robust` says where there is no solution: the cause, at a point that shows it.

mod common;

use common::{FREE, NONNEGATIVE, dense, solve};
use mcp_core::{Diagnosis, Method, Options, Problem, Solution, Status};

/// One equation `f(z) ⟂ z` of which `f` and its derivative are given.
fn one(bounds: (f64, f64), start: f64, f: impl Fn(f64) -> (f64, f64)) -> Solution {
    let mut problem = dense(&[bounds], &[start], move |z, value, jac| (value[0], jac[0]) = f(z[0]));
    solve(&mut problem, &Options::default())
}

#[test]
fn an_exponential_without_a_bound_is_solved_at_infinity_only() {
    for start in [-3.0, 0.5, 1.0, 10.0] {
        let solution = one(FREE, start, |z| ((-z).exp(), -(-z).exp()));
        assert_eq!(solution.status, Status::SolvedAsymptotically, "{start}");
        match &solution.diagnosis {
            Some(Diagnosis::Diverged { growing }) => assert!(growing[0].1 > 10.0, "{growing:?}"),
            other => panic!("{other:?}"),
        }
    }
}

/// `(d, d')` of functions that vanish at infinity, for `z >= 0`.
const DECAYS: [fn(f64) -> (f64, f64); 5] = [
    |z| ((-z).exp(), -(-z).exp()),
    |z| ((-z * z).exp(), -2.0 * z * (-z * z).exp()),
    |z| (z.recip(), -z.powi(-2)),
    |z| ((z + 1.0).powi(-2), -2.0 * (z + 1.0).powi(-3)),
    |z| ((-z).exp() / z, -(-z).exp() * (z + 1.0) / (z * z)),
];

#[test]
fn a_decay_beside_a_variable_that_is_0_is_not_taken_for_solved_by_any_method() {
    // a v = d(z) and c v = 0, whose start makes the size of the first equation.
    for (number, decay) in DECAYS.into_iter().enumerate() {
        for start in [[0.5, 1.0], [1.0, -2.0], [2.5, 1.0], [3.0, 0.3]] {
            for (pinned, a, c) in [(FREE, 2.0, 1.5), (NONNEGATIVE, 0.5, 2.0), (FREE, -1.0, 0.1)] {
                for method in Method::ALL {
                    let bounds = [NONNEGATIVE, pinned];
                    let mut problem = dense(&bounds, &start, move |z, f, jac| {
                        let (value, slope) = decay(z[0]);
                        f.copy_from_slice(&[a * z[1] - value, c * z[1]]);
                        jac.copy_from_slice(&[-slope, 0.0, a, c]);
                    });
                    let solution = solve(&mut problem, &Options::new(method));
                    let case = format!("{number} {start:?} {a} {c} {method}: {solution:?}");
                    assert!(!solution.is_solved(), "{case}");
                    if method == Method::Robust && number == 0 {
                        assert_eq!(solution.status, Status::SolvedAsymptotically, "{case}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_parabola_above_0_is_not_solved_from_however_far_and_said_to_have_a_minimum() {
    let from = |start: f64| one(FREE, start, |z| (z * z + 1.0, 2.0 * z));
    for start in [3.0, 1e3] {
        let solution = from(start);
        assert_eq!(solution.status, Status::StationaryPoint, "{start:e}: {solution:?}");
        assert!(solution.f[0] < 1.001, "{start:e}: {:?}", solution.f);
    }
    for start in [1e6, -1e9, 1e10, 1e11, 1e12, -1e13] {
        assert!(!from(start).is_solved(), "{start:e}");
    }
}

#[test]
fn a_root_beside_an_infinity_on_the_bound_is_a_domain_error_that_names_the_bound() {
    // ln z + 700 is 0 at 10^-304 and −∞ on the bound.
    let solution = one(NONNEGATIVE, 1.0, |z| (z.ln() + 700.0, 1.0 / z));
    assert_eq!(solution.status, Status::DomainError);
    let fault = solution.fault.expect("a domain error has one");
    assert_eq!((fault.equation, fault.z[0]), (0, 0.0));
    assert_eq!(fault.value, f64::NEG_INFINITY);
}

#[test]
fn an_answer_is_finite_where_steps_overflow() {
    // e^z + c from where e^z is hardly more than nothing: Newton's step is beyond all numbers.
    for (start, c) in [(-709.567_160_214_712_4, 20.157_950_370_019_964), (-6.9, 0.7)] {
        let mut problem = dense(&[FREE], &[start], move |z, f, jac| {
            (f[0], jac[0]) = (z[0].exp() + c, z[0].exp());
        });
        for method in Method::ALL {
            let solution = solve(&mut problem, &Options::new(method));
            assert!(!solution.is_solved() && solution.z[0].is_finite(), "{method}: {solution:?}");
        }
    }
}

#[test]
fn an_answer_is_finite_where_units_are_three_hundred_decades_apart() {
    // v2 is in no equation, with 1e-300 as bound and 1e308 as start; then a slope of 5e-324.
    let bounds = [(-1e300, 1e-160), (1e-300, f64::INFINITY)];
    let mut far = dense(&bounds, &[1e300, 1e308], |z, f, jac| {
        f.copy_from_slice(&[0.67 + 1e150 * z[0], z[0] - 1.0]);
        jac.copy_from_slice(&[1e150, 1.0, 0.0, 0.0]);
    });
    let mut flat = dense(&[(f64::NEG_INFINITY, 1e-160)], &[1e-160], |z, f, jac| {
        (f[0], jac[0]) = (1.0 + 5e-324 * z[0], 5e-324);
    });
    for method in Method::ALL {
        for problem in [&mut far as &mut dyn Problem, &mut flat] {
            let solution = solve(problem, &Options::new(method));
            assert!(solution.z.iter().all(|z| z.is_finite()), "{method}: {solution:?}");
        }
    }
}

#[test]
fn roots_of_steep_exponentials_are_not_taken_for_infinity() {
    for (bounds, start, k, c) in [
        (NONNEGATIVE, 3.0, 100.0, 4.179_543_610_903_63e138),
        ((0.0, 7.0), 2.0, 100.0, 1e120),
        ((f64::NEG_INFINITY, 7.0), 1.0, 80.0, 3.901_001_750_182_099e158),
    ] {
        let solution = one(bounds, start, move |z| ((k * z).exp() - c, k * (k * z).exp()));
        assert!(solution.is_solved(), "{start} {solution:?}");
        // `tol_relative` is 1e-8 of the term, `J z`.
        assert!((solution.z[0] - c.ln() / k).abs() < 1e-8 * solution.z[0], "{start} {solution:?}");
    }
}

#[test]
fn a_price_that_a_free_good_leaves_open_is_not_taken_for_infinite() {
    // v + 0.1 ⟂ v >= 0 and √v / p ⟂ p >= 0: any p at v = 0.
    let mut problem = dense(&[NONNEGATIVE; 2], &[1.0, 1.0], |z, f, jac| {
        f.copy_from_slice(&[z[0] + 0.1, z[0].sqrt() / z[1]]);
        jac.copy_from_slice(&[1.0, 0.5 / z[0].sqrt() / z[1], 0.0, -z[0].sqrt() / (z[1] * z[1])]);
    });
    let solution = solve(&mut problem, &Options::new(Method::NewtonFb));
    assert!(solution.is_solved(), "{solution:?}");
}
