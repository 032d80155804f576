use super::*;
use crate::accuracy::problems;

#[test]
fn a_source_that_a_case_lacks_and_a_solution_that_is_not_known_are_errors() {
    let case = problems::walras(10).unwrap();
    assert!(matches!(case.problem(Source::ByHand), Err(AccuracyError::NotByHand { .. })));
    let case = Case { references: Vec::new(), ..case };
    assert!(matches!(case.error(&[1.0; 10]), Err(AccuracyError::NoReference { .. })));
    assert!(matches!(case.problem(Source::BestCentral), Err(AccuracyError::NoReference { .. })));
}

#[test]
fn errors_are_distances_to_the_nearest_solution() {
    let case = problems::kojima_shindo(true).unwrap();
    for reference in &case.references {
        let z: Vec<f64> = reference.z.iter().map(|z| z.to_f64()).collect();
        assert!(case.error(&z).unwrap() < f64::EPSILON);
    }
}

#[test]
fn f_in_double_double_is_the_nearest_plain_number() {
    let case = problems::cournot_10().unwrap();
    let z = [7.25; 10];
    let (mut plain, mut precise) = ([0.0; 10], [0.0; 10]);
    case.in_arithmetic(Arithmetic::F64).unwrap().evaluate(&z, Some(&mut plain), None);
    case.in_arithmetic(Arithmetic::DoubleDouble).unwrap().evaluate(&z, Some(&mut precise), None);
    let terms = 100.0;
    for (plain, precise) in plain.iter().zip(precise) {
        assert!((plain - precise).abs() <= 8.0 * f64::EPSILON * terms, "{plain} {precise}");
    }
    assert_ne!(plain, precise, "some digit was lost");
}

#[test]
fn differences_cost_evaluations_of_f() {
    let case = problems::chain(30).unwrap();
    let (f, jets) = case.operations(Source::Jet).unwrap();
    assert!(jets.is_some_and(|jets| jets > f));
    assert_eq!(case.operations(Source::OneSided).unwrap(), (f, Some(4 * f)));
    assert_eq!(case.operations(Source::Central).unwrap(), (f, Some(7 * f)));
    assert_eq!(case.operations(Source::NumDual).unwrap(), (f, None));
}

#[test]
fn the_jacobian_in_double_double_rounds_to_that_of_jets() {
    let case = problems::walras(12).unwrap();
    let z = case.solution().unwrap();
    let exact = case.exact_jacobian(&z).unwrap();
    let mut jac = vec![0.0; exact.len()];
    case.problem(Source::Jet).unwrap().evaluate(&z, None, Some(&mut jac));
    let largest = jac.iter().copied().fold(0.0, |a: f64, b| a.max(b.abs()));
    for (jet, exact) in jac.iter().zip(exact) {
        assert!((exact - (*jet).into()).to_f64().abs() <= 64.0 * f64::EPSILON * largest);
    }
}
