use super::*;
use crate::mcp_fn;
use crate::problem::Problem;
use crate::solver::{Options, Verdict, examine, solve};
use proptest::prelude::*;

#[mcp_fn(lower = -3.0, upper = 3.0)]
fn waves<D: Scalar>(z: [Real<D>; 6]) -> [Real<D>; 6] {
    std::array::from_fn(|i| {
        3 * z[i] + z[i].powi(3) + z[(i + 1) % 6].sin() * (z[(i + 5) % 6] / 2).exp()
    })
}

fn place() -> impl Strategy<Value = Place> {
    prop_oneof![
        (0.0..2.0).prop_map(|margin| Place::Lower { margin }),
        (0.0..2.0).prop_map(|margin| Place::Upper { margin }),
        Just(Place::Between),
        Just(Place::Lower { margin: 0.0 }),
    ]
}

proptest! {
    #[test]
    fn the_chosen_point_is_a_solution_with_the_chosen_margins(
        z in proptest::array::uniform6(-2.0..2.0),
        places in proptest::array::uniform6(place()),
    ) {
        let model = Manufactured::new(Waves::new().unwrap(), &z, &places).unwrap();
        for (f, place) in rows_at(&model, &z).unwrap().into_iter().zip(places) {
            let w = match place {
                Place::Lower { margin } => margin,
                Place::Between => 0.0,
                Place::Upper { margin } => -margin,
            };
            prop_assert!((f - w.into()).to_f64().abs() < 1e-28);
        }
        let certificate = examine(&mut AdProblem::new(&model).unwrap(), &z).unwrap();
        prop_assert_eq!(certificate.verdict(Some(1e-13), 1e-14), Verdict::Accepted);
    }
}

#[test]
fn a_solver_finds_the_chosen_solution_of_a_monotone_model() {
    let mix = Mix { lower: 0.3, upper: 0.2, degenerate: 0.5, margin: 1.0 };
    let z = [0.1, -0.4, 0.3, 0.8, -0.2, 0.5];
    let model = Manufactured::new(Waves::new().unwrap(), &z, &mix.places(6)).unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    for (found, z) in solution.z.iter().zip(z) {
        assert!((found - z).abs() < 1e-12, "{found} is not {z}");
    }
}

#[test]
fn bounds_without_room_for_the_solution_are_dropped() {
    let z = [3.0, 4.0, 0.0, 0.0, 0.0, 0.0];
    let model = Manufactured::new(Waves::new().unwrap(), &z, &[Place::Between; 6]).unwrap();
    let bounds = model.shape().bounds();
    assert_eq!(bounds.upper()[..3], [f64::INFINITY, f64::INFINITY, 3.0]);
    assert_eq!(bounds.lower()[..3], [-3.0; 3]);
}

#[test]
fn a_mix_has_its_shares() {
    let mix = Mix { lower: 0.3, upper: 0.2, degenerate: 0.5, margin: 2.0 };
    let places = mix.places(1000);
    let count = |is: fn(&Place) -> bool| places.iter().filter(|place| is(place)).count();
    assert!(count(|place| matches!(place, Place::Lower { .. })).abs_diff(300) <= 5);
    assert!(count(|place| matches!(place, Place::Upper { .. })).abs_diff(200) <= 5);
    let degenerate =
        count(|place| matches!(place, Place::Lower { margin: 0.0 } | Place::Upper { margin: 0.0 }));
    assert!(degenerate.abs_diff(250) <= 25, "{degenerate}");
}

#[test]
fn impossible_choices_are_named() {
    let make = |z: &[f64], places: &[Place]| Manufactured::new(Waves::new().unwrap(), z, places);
    let (z, between) = ([0.5; 6], [Place::Between; 6]);
    assert!(make(&z[..5], &between).is_err() && make(&z, &between[..5]).is_err());
    let negative = [Place::Lower { margin: -1.0 }; 6];
    let error = make(&z, &negative).unwrap_err().to_string();
    assert_eq!(error, "the margin of `z[1]` is -1, but must be at least 0 and finite");
    let far = [1e300; 6];
    assert!(matches!(make(&far, &between), Err(AccuracyError::NotFinite { .. })));
}

#[test]
fn derivatives_are_those_of_the_model() {
    let z = [0.2; 6];
    let model = Manufactured::new(Waves::new().unwrap(), &z, &[Place::Between; 6]).unwrap();
    let jacobian = |problem: &mut dyn Problem| {
        let mut jac = vec![0.0; problem.pattern().nnz()];
        problem.evaluate(&z, None, Some(&mut jac));
        jac
    };
    let of_model = jacobian(&mut AdProblem::new(Waves::new().unwrap()).unwrap());
    assert_eq!(jacobian(&mut AdProblem::new(&model).unwrap()), of_model);
}
