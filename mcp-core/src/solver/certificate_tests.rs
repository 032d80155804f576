use super::*;
use crate::model::Shape;
use crate::problem::Pattern;
use proptest::prelude::*;
use std::sync::Arc;

const INF: f64 = f64::INFINITY;

/// `F = c + J z` with numbers that need not be finite.
struct Line {
    shape: Arc<Shape>,
    pattern: Pattern,
    c: Vec<f64>,
    jac: Vec<f64>,
}

impl Problem for Line {
    fn shape(&self) -> &Arc<Shape> {
        &self.shape
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        if let Some(f) = f {
            f.copy_from_slice(&self.c);
            for (k, i, j) in self.pattern.entries() {
                // What a model does not depend on does not disturb it.
                if self.jac[k] != 0.0 && self.jac[k].is_finite() {
                    f[i] += self.jac[k] * z[j];
                }
            }
        }
        if let Some(jac) = jac {
            jac.copy_from_slice(&self.jac);
        }
    }
}

/// `J` column by column, starting at `start`.
fn line(bounds: &[(f64, f64)], start: &[f64], c: &[f64], jac: &[f64]) -> Line {
    let (lower, upper): (Vec<f64>, Vec<f64>) = bounds.iter().copied().unzip();
    Line {
        shape: Shape::anonymous(&lower, &upper, start).unwrap().into(),
        pattern: Pattern::dense(bounds.len()),
        c: c.to_vec(),
        jac: jac.to_vec(),
    }
}

fn scalar(bounds: (f64, f64), start: f64, c: f64, slope: f64) -> Line {
    line(&[bounds], &[start], &[c], &[slope])
}

const FREE: (f64, f64) = (-INF, INF);
const NONNEGATIVE: (f64, f64) = (0.0, INF);

fn verdict(problem: &mut Line, z: &[f64]) -> Verdict {
    examine(problem, z).unwrap().verdict(Some(1e-6), 1e-8)
}

#[test]
fn zero_is_a_solution_like_any_other() {
    // z = 0, F = 0, from 0: no magnitude anywhere.
    let certificate = examine(&mut scalar(FREE, 0.0, 0.0, 3.0), &[0.0]).unwrap();
    assert_eq!(certificate.verdict(Some(1e-300), 1e-300), Verdict::Accepted);
    assert_eq!((certificate.natural_residual, certificate.relative_residual), (0.0, 0.0));
    // 3z − 3e-9 at 0: nothing says that 1e-9 is small. The rounding of numbers of order 1 is.
    assert_eq!(verdict(&mut scalar(FREE, 0.0, -3e-9, 3.0), &[0.0]), Verdict::Refused);
    assert_eq!(verdict(&mut scalar(FREE, 0.0, -5e-17, 3.0), &[0.0]), Verdict::Accepted);
    // Next to a force of 1 against a bound.
    let at_rest = |f: f64| {
        let bounds = [FREE, NONNEGATIVE];
        verdict(&mut line(&bounds, &[0.0; 2], &[f, 1.0], &[1.0, 0.5, 0.5, 1.0]), &[0.0; 2])
    };
    assert_eq!([1e-16, 1e-6].map(at_rest), [Verdict::Accepted, Verdict::Refused]);
    // At a bound, F decides by its sign.
    assert_eq!(verdict(&mut scalar(NONNEGATIVE, 0.0, 7.0, 1.0), &[0.0]), Verdict::Accepted);
    assert_eq!(verdict(&mut scalar(NONNEGATIVE, 0.0, -7.0, 1.0), &[0.0]), Verdict::Refused);
}

#[test]
fn a_zero_f_needs_no_size() {
    // F = 0 with a derivative of 0 at a bound: 0/0 is no residual.
    let certificate = examine(&mut scalar(NONNEGATIVE, 0.0, 0.0, 0.0), &[0.0]).unwrap();
    assert_eq!(certificate.verdict(None, 1e-8), Verdict::Accepted);
    assert_eq!((certificate.relative_residual, certificate.vanishing_row), (0.0, None));
}

#[test]
fn a_row_that_must_hold_and_has_no_derivatives_is_named() {
    for slope in [0.0, -0.0, 1e-310] {
        let mut problem = line(&[FREE; 2], &[1.0; 2], &[1.0, 0.0], &[-1.0, 0.0, 0.0, slope]);
        let certificate = examine(&mut problem, &[1.0, 1.0]).unwrap();
        assert_eq!(certificate.vanishing_row, Some(1), "{slope:e}");
        assert_eq!(certificate.verdict(Some(1e-6), 1e-8), Verdict::Asymptotic, "{slope:e}");
    }
    // Not where the variable is at its bound, and not at the smallest normal derivative.
    assert_eq!(
        examine(&mut scalar(NONNEGATIVE, 0.0, 1.0, 0.0), &[0.0]).unwrap().vanishing_row,
        None
    );
    let smallest = scalar(FREE, 0.0, 0.0, f64::MIN_POSITIVE);
    assert_eq!(examine(&mut { smallest }, &[0.0]).unwrap().vanishing_row, None);
}

#[test]
fn a_vanishing_row_or_a_diverging_variable_excuses_no_residual() {
    for tol in [None, Some(1e-6)] {
        let certificate = examine(&mut scalar(FREE, 0.0, 1.0, 0.0), &[0.0]).unwrap();
        assert_eq!(certificate.vanishing_row, Some(0));
        assert_eq!(certificate.verdict(tol, 1e-8), Verdict::Refused, "F = 1, {tol:?}");
        let certificate = examine(&mut scalar(FREE, 0.0, 1e13, 1.0), &[1e13]).unwrap();
        assert_eq!(certificate.diverging, Some(0));
        assert_eq!(certificate.verdict(tol, 1e-8), Verdict::Refused, "F = 2e13, {tol:?}");
    }
}

#[test]
fn a_variable_diverges_relative_to_its_start() {
    let at = |start: f64, z: f64| examine(&mut scalar(FREE, start, -z, 1.0), &[z]).unwrap();
    assert_eq!(at(0.0, 1e12).diverging, None);
    assert_eq!(at(0.0, -1.1e12).diverging, Some(0));
    assert_eq!(at(1e3, 1.1e12).diverging, None);
    assert_eq!(at(1e-9, 1.1e12).diverging, Some(0), "a tiny start counts as 1");
}

#[test]
fn a_far_solution_is_a_solution_and_a_fading_residual_is_not() {
    let far = examine(&mut scalar(FREE, 0.0, -2e13, 1.0), &[2e13]).unwrap();
    assert_eq!(far.verdict(Some(1e-6), 1e-8), Verdict::Accepted);
    assert_eq!(far.verdict(None, 1e-8), Verdict::Accepted);
    // F = 1e-7 at z = 1.1e12 with slope 1e-17: a small residual that Newton would not call so.
    let c = 1e-7 - 1e-17 * 1.1e12;
    let fading = examine(&mut scalar(FREE, 0.0, c, 1e-17), &[1.1e12]).unwrap();
    assert_eq!(fading.verdict(Some(1e-6), 1e-8), Verdict::Asymptotic);
    assert_eq!(fading.verdict(None, 1e-8), Verdict::Refused);
}

/// `F₁ = v + d(z)`, `F₂ = v` in `(z, v)`, of which `d` and its derivative are given.
struct Beside {
    shape: Arc<Shape>,
    pattern: Pattern,
    curve: fn(f64) -> (f64, f64),
}

impl Problem for Beside {
    fn shape(&self) -> &Arc<Shape> {
        &self.shape
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        let (d, slope) = (self.curve)(z[0]);
        if let Some(f) = f {
            f.copy_from_slice(&[z[1] + d, z[1]]);
        }
        if let Some(jac) = jac {
            jac.copy_from_slice(&[slope, 0.0, 1.0, 1.0]);
        }
    }
}

#[test]
fn a_variable_that_fades_twice_as_far_as_well_is_on_its_way_to_infinity() {
    let at = |z: f64, start: f64, curve: fn(f64) -> (f64, f64)| {
        let shape = Shape::anonymous(&[-INF; 2], &[INF; 2], &[start, 1.0]).unwrap().into();
        let mut problem = Beside { shape, pattern: Pattern::dense(2), curve };
        let certificate = examine(&mut problem, &[z, 0.0]).unwrap();
        (certificate.fading, certificate.verdict(None, 1e-8))
    };
    let decay = |z: f64| ((-z).exp(), -(-z).exp());
    assert_eq!(at(28.0, 1.0, decay), (Some(0), Verdict::Asymptotic));
    assert_eq!(at(-28.0, 1.0, |z| (z.exp(), z.exp())), (Some(0), Verdict::Asymptotic));
    assert_eq!(at(1.2e6, 0.0, |z| (z.powi(-2), -2.0 * z.powi(-3))), (Some(0), Verdict::Asymptotic));
    assert_eq!(at(28.0, 28.0, decay), (None, Verdict::Accepted), "the start says it is ordinary");
    assert_eq!(at(20.0, 1.0, decay), (None, Verdict::Refused), "no small residual yet");
    // A hundredth before roots of multiplicity 1 and 2 that are hardly seen.
    assert_eq!(at(27.0, 1.0, |z| (1e-12 * (z - 27.3), 1e-12)), (None, Verdict::Accepted));
    let double = |z: f64| (1e-12 * (z - 27.3).powi(2), 2e-12 * (z - 27.3));
    assert_eq!(at(27.0, 1.0, double), (None, Verdict::Accepted));
}

#[test]
fn scaling_an_equation_changes_no_relative_residual() {
    // J = [2 1; 1e-3 3], z = (1, 0) from (1, 0), F = (1e-3, 1e-5): row 2 times 2^k.
    let residual = |k: i32| {
        let t = 2_f64.powi(k);
        let mut problem = line(
            &[FREE, FREE],
            &[1.0, 0.0],
            &[1e-3 - 2.0, t * (1e-5 - 1e-3)],
            &[2.0, t * 1e-3, 1.0, t * 3.0],
        );
        examine(&mut problem, &[1.0, 0.0]).unwrap().relative_residual
    };
    for k in [-200, -60, -7, 7, 60, 200] {
        assert_eq!(residual(k).to_bits(), residual(0).to_bits(), "2^{k}");
    }
}

#[test]
fn an_equation_in_tiny_units_is_not_solved_at_a_zero_start() {
    // F = 1e-18 (z − 1) from 0, alone and beside a solved equation of ordinary size.
    let mut alone = scalar(FREE, 0.0, -1e-18, 1e-18);
    assert_eq!(examine(&mut alone, &[0.0]).unwrap().verdict(Some(1e-6), 1e-8), Verdict::Refused);
    let mut beside = line(&[FREE, FREE], &[1.0, 0.0], &[-1.0, -1e-18], &[1.0, 0.0, 0.0, 1e-18]);
    let certificate = examine(&mut beside, &[1.0, 0.0]).unwrap();
    assert_eq!(
        (certificate.worst_relative, certificate.verdict(None, 1e-8)),
        (1, Verdict::Refused)
    );
}

#[test]
fn a_huge_variable_does_not_excuse_an_unconnected_one() {
    let mut apart = line(&[FREE, FREE], &[0.0, 0.0], &[-1e16, -2.0], &[1.0, 0.0, 0.0, 1.0]);
    let certificate = examine(&mut apart, &[1e16, 2.002]).unwrap();
    assert_eq!(certificate.worst_relative, 1);
    assert!(certificate.relative_residual > 1e-4);
}

#[test]
fn a_point_of_the_wrong_length_is_an_error() {
    for z in [&[][..], &[1.0, 2.0]] {
        assert!(matches!(
            examine(&mut scalar(FREE, 0.0, 1.0, 1.0), z),
            Err(ModelError::Length { expected: 1, .. })
        ));
    }
}

#[test]
fn nan_and_infinity_are_never_hidden() {
    for bad in [f64::NAN, INF, -INF] {
        for bounds in [FREE, NONNEGATIVE, (-INF, 0.0), (0.0, 0.0), (0.0, 1.0)] {
            let is_free = bounds == FREE;
            for (c, slope) in [(bad, 1.0), (0.0, bad)].into_iter().take(1 + usize::from(is_free)) {
                let certificate = examine(&mut scalar(bounds, 0.0, c, slope), &[0.0]).unwrap();
                assert!(!certificate.is_finite, "{bounds:?} {c} {slope}");
                assert!(certificate.relative_residual.is_nan(), "{bounds:?} {c} {slope}");
                assert_eq!(certificate.natural_residual.is_nan(), c.is_nan(), "{bounds:?} {c}");
                for tol in [None, Some(INF), Some(1e-6)] {
                    assert_eq!(certificate.verdict(tol, INF), Verdict::Refused, "{bounds:?}");
                }
            }
        }
        let certificate = examine(&mut scalar(FREE, 0.0, 0.0, 1.0), &[bad]).unwrap();
        assert_eq!(certificate.verdict(Some(INF), INF), Verdict::Refused);
    }
}

#[test]
fn derivatives_of_an_equation_met_on_a_bound_need_not_be_finite() {
    for bad in [f64::NAN, INF, -INF] {
        for (bounds, f) in [(NONNEGATIVE, 1.1), (NONNEGATIVE, 0.0), ((-INF, 0.0), -3.0)] {
            let here = |f: f64| examine(&mut scalar(bounds, 0.0, f, bad), &[0.0]).unwrap();
            assert_eq!(here(f).verdict(None, 1e-8), Verdict::Accepted, "{bounds:?} {f} {bad}");
            assert_eq!((here(f).natural_residual, here(f).relative_residual), (0.0, 0.0));
            let wrong = if bounds == NONNEGATIVE { -1e-300 } else { 1e-300 };
            assert_eq!(here(wrong).verdict(Some(INF), INF), Verdict::Refused, "{bounds:?} {bad}");
        }
        // The same derivative in an equation that must hold counts.
        let bounds = [NONNEGATIVE, FREE];
        let mut both = line(&bounds, &[0.0; 2], &[1.0, 0.0], &[bad, bad, 0.0, 1.0]);
        assert!(!examine(&mut both, &[0.0; 2]).unwrap().is_finite);
    }
}

#[test]
fn a_nan_in_a_later_row_stays_the_worst() {
    let jac = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    let c = [5.0, f64::NAN, 9.0];
    let certificate = examine(&mut line(&[FREE; 3], &[0.0; 3], &c, &jac), &[0.0; 3]).unwrap();
    assert!(certificate.natural_residual.is_nan());
    assert_eq!(certificate.worst, 1);
}

#[test]
fn a_point_outside_the_box_is_refused_however_near() {
    let mut problem = scalar((0.0, 1.0), 0.5, 0.0, 1.0);
    let certificate = examine(&mut problem, &[-1e-300]).unwrap();
    assert_eq!(certificate.bound_violation, 1e-300);
    assert_eq!(certificate.verdict(Some(1.0), 1.0), Verdict::Refused);
    let above = f64::from_bits(1.0_f64.to_bits() + 1);
    let certificate = examine(&mut scalar((0.0, 1.0), 0.5, -2.0, 1.0), &[above]).unwrap();
    assert_eq!(certificate.bound_violation, f64::EPSILON);
    assert_eq!(certificate.verdict(Some(1.0), 1.0), Verdict::Refused);
}

#[test]
fn the_worst_rows_are_named() {
    // Natural residuals 1, 3, 2; relative 1e-6-ish, small, large.
    let jac = [1e6, 0.0, 0.0, 0.0, 1e3, 0.0, 0.0, 0.0, 1.0];
    let mut problem = line(&[FREE; 3], &[1.0; 3], &[1.0 - 1e6, 3.0 - 1e3, 2.0 - 1.0], &jac);
    let certificate = examine(&mut problem, &[1.0; 3]).unwrap();
    assert_eq!((certificate.natural_residual, certificate.worst), (3.0, 1));
    assert_eq!(certificate.worst_relative, 2);
}

#[test]
fn the_start_keeps_the_gauge_from_collapsing() {
    // z − 1e-9: wrong at 0 if z starts at 1e-9; a solution that is small against its start is judged at
    // 1e-4 of it, one that starts at 0 at 1e-6 in the units of the model.
    let e = |start: f64, z: f64| {
        examine(&mut scalar(FREE, start, -1e-9, 1.0), &[z]).unwrap().relative_residual
    };
    assert!(e(1e-9, 0.0) > 0.1, "{}", e(1e-9, 0.0));
    for z in [0.0, 1e-12] {
        assert!((1e-6..1e-4).contains(&e(1.0, z)), "{z}: {}", e(1.0, z));
        assert!((1e-4..1e-2).contains(&e(0.0, z)), "{z}: {}", e(0.0, z));
    }
}

#[test]
fn a_size_that_overflows_accepts_nothing() {
    // F = −1e303, but s = 2e308 is infinite.
    let certificate = examine(&mut scalar(FREE, 1e10, -1.000_01e308, 1e298), &[1e10]).unwrap();
    assert!(certificate.relative_residual > 1e-6, "{certificate:?}");
    assert_eq!(certificate.verdict(None, 1e-8), Verdict::Refused);
}

#[test]
fn subnormal_numbers_make_no_nan() {
    let mut problem = line(
        &[FREE, NONNEGATIVE],
        &[5e-324, 5e-324],
        &[5e-324, 5e-324],
        &[5e-324, 1.0, f64::MAX, f64::MIN_POSITIVE],
    );
    let certificate = examine(&mut problem, &[5e-324, 0.0]).unwrap();
    assert!(certificate.is_finite);
    assert!(!certificate.natural_residual.is_nan() && !certificate.relative_residual.is_nan());
}

proptest! {
    /// One row in other units, by a power of four: `e` keeps its bits.
    #[test]
    fn the_units_of_a_single_equation_leave_no_trace(
        k in -300..300_i32, z in 0.1..10.0_f64, c in -5.0..5.0_f64
    ) {
        let scale = 4_f64.powi(k);
        let own = examine(&mut scalar(FREE, 1.0, c, 3.0), &[z]).unwrap().relative_residual;
        let other =
            examine(&mut scalar(FREE, 1.0, c * scale, 3.0 * scale), &[z]).unwrap().relative_residual;
        prop_assert_eq!(own, other);
    }

    /// Nearer to the solution is better, and the tolerance is one for relative errors.
    #[test]
    fn the_relative_residual_is_about_the_relative_error(
        solution in 0.01..100.0_f64, error in 1e-12..1e-3_f64, slope in 1e-9..1e9_f64
    ) {
        let z = solution * (1.0 + error);
        let e = examine(&mut scalar(FREE, 1.0, -slope * solution, slope), &[z]).unwrap().relative_residual;
        prop_assert!((0.05 * error..2.0 * error).contains(&(e + 1e-14)), "{e} {error}");
    }
}

#[test]
fn zeros_in_any_units_are_no_solution() {
    // Kojima and Shindo's F at 0 with every other variable, or all, in units of 1e-12 or 1e12.
    let c = [-6.0, -2.0, -9.0, -3.0];
    for units in [[1e-12, 1.0, 1e-12, 1.0], [1e12, 1.0, 1e12, 1.0], [1e-12; 4], [1e12; 4]] {
        for f in [1e-12, 1.0, 1e12] {
            let entry = |k: usize| f * (1.0 + (k % 3) as f64) / units[k / 4];
            let jac: Vec<f64> = (0..16).map(entry).collect();
            let mut problem = line(&[NONNEGATIVE; 4], &[0.0; 4], &c.map(|c| f * c), &jac);
            let certificate = examine(&mut problem, &[0.0; 4]).unwrap();
            let verdict = certificate.verdict(None, 1e-8);
            assert_eq!(verdict, Verdict::Refused, "{units:?} {f}: {certificate:?}");
        }
    }
}

#[test]
fn rounding_of_numbers_of_order_ten_is_accepted_at_a_start_of_zero() {
    // (z + 10) − 10.1 + 0.1.
    let noise = (0.0 + 10.0) - 10.1 + 0.1;
    assert!(noise != 0.0);
    for z in [0.0, 1e-16] {
        let accepted = verdict(&mut scalar(FREE, 0.0, noise, 1.0), &[z]);
        assert_eq!(accepted, Verdict::Accepted, "{z}");
    }
}

#[test]
fn a_large_f_against_a_bound_excuses_no_other_row() {
    // Two variables in [0, 1], F₁ = z₁ + z₂ − 1e9, F₂ = z₂ − z₁: only (1, 1).
    let bounds = [(0.0, 1.0); 2];
    let jac = [1.0, -1.0, 1.0, 1.0];
    let mut boxed = line(&bounds, &[0.0; 2], &[-1e9, 0.0], &jac);
    assert_eq!(verdict(&mut boxed, &[0.0; 2]), Verdict::Refused);
    assert_eq!(verdict(&mut boxed, &[1.0; 2]), Verdict::Accepted);
    // Nine large forces against their bounds beside z₁₀ − 1 = 0.
    let n = 10;
    let entry = |k: usize| match (k % n, k / n) {
        (i, j) if i == j => 1.0,
        (9, _) => 0.25,
        (_, 9) => 0.5,
        _ => 0.0,
    };
    let jac: Vec<f64> = (0..n * n).map(entry).collect();
    let mut c = vec![1e9; n];
    c[9] = -1.0;
    let mut forces = line(&[NONNEGATIVE; 10], &[0.0; 10], &c, &jac);
    assert_eq!(verdict(&mut forces, &[0.0; 10]), Verdict::Refused);
}

#[test]
fn quantities_tell_nothing_about_prices_that_share_no_equation() {
    // 2 − p ⟂ q >= 0, q − 3 ⟂ p >= 0 at (3, 0), with q in any unit.
    for unit in [1.0, 2_f64.powi(-30), 2_f64.powi(30)] {
        let jac = [0.0, unit, -1.0, 0.0];
        let mut market = line(&[NONNEGATIVE; 2], &[0.0; 2], &[2.0, -3.0], &jac);
        let certificate = examine(&mut market, &[3.0 / unit, 0.0]).unwrap();
        assert!(certificate.relative_residual > 1e-3, "{unit}: {certificate:?}");
    }
}
