use super::*;
use crate::accuracy::problems;
use crate::scalar::Scalar;
use crate::{ModelError, mcp_fn};

/// `x² − a ⟂ x >= 0` with `a = 2`.
#[mcp_fn(lower = 0.0, start = 1.0)]
fn root_of_two<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    [x * x - 2]
}

#[mcp_fn(lower = 0.0, start = 1.0)]
fn square<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    [(x - 1) * (x - 1)]
}

#[test]
fn a_refined_root_has_thirty_digits() {
    let reference = Reference::refined(&RootOfTwo::new().unwrap(), &[1.4]).unwrap();
    let error = (reference.z[0] - DoubleDouble::from(2.0).sqrt()).to_f64();
    assert!(error.abs() < 1e-30 && reference.error < 1e-22, "{error:e}");
    assert_eq!(reference.origin, Origin::Refined);
}

#[test]
fn refinement_agrees_with_the_solution_a_problem_was_made_for() {
    let manufactured = problems::chain(150).unwrap();
    let exact = manufactured.solution().unwrap();
    let near: Vec<f64> = exact.iter().map(|z| z * (1.0 + 1e-9)).collect();
    let refined = manufactured.refine(&near).unwrap();
    assert!(refined.distance(&exact) < 1e-28, "{:e}", refined.distance(&exact));
}

#[test]
fn a_double_root_is_not_refined() {
    let result = Reference::refined(&Square::new().unwrap(), &[1.001]);
    assert!(
        matches!(
            result,
            Err(AccuracyError::NotSettled { .. } | AccuracyError::Model(ModelError::Linear(_)))
        ),
        "{result:?}"
    );
}

#[test]
fn a_point_with_a_wrong_sign_is_no_solution() {
    // The min map takes −1.1 for active; at the bound F = −2.
    let result = Reference::refined(&RootOfTwo::new().unwrap(), &[-1.5]);
    match result {
        Err(AccuracyError::NoSolution { variable, violation }) => {
            assert_eq!(variable, "x");
            assert!(violation > 0.1);
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_point_of_another_length_is_an_error() {
    assert!(Reference::refined(&RootOfTwo::new().unwrap(), &[1.0, 2.0]).is_err());
}

#[test]
fn distances_are_relative_to_each_variable_and_zeros_to_the_largest() {
    let reference = Reference::closed_form([1e-6, 0.0, 100.0]);
    assert!((reference.distance(&[1.5e-6, 0.0, 100.0]) - 0.5).abs() < 1e-12);
    assert!((reference.distance(&[1e-6, 1.0, 100.0]) - 0.01).abs() < 1e-15);
    assert_eq!(reference.distance(&[1e-6, 0.0, 100.0]), 0.0);
    assert!(reference.distance(&[1e-6, f64::NAN, 100.0]).is_nan());
    assert_eq!(Reference::closed_form([0.0]).distance(&[0.25]), 0.25);
}
