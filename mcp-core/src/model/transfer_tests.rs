use super::*;
use crate::model::by_name::tests::trade;
use crate::model::{Equation, ShapeBuilder, Variable};
use std::sync::Arc;

/// Fixed variables need no equations.
fn fixed(names: [&str; 3]) -> Shape {
    let variables = names.map(|name| Variable::new(name).fixed(1.0));
    variables.into_iter().fold(Shape::builder(), ShapeBuilder::variable).build().unwrap()
}

fn paired(name: &str, sets: &[&Set], only: Option<&[usize]>) -> Shape {
    let mut variable = Variable::new(name).over(sets).start(0.5);
    let mut equation = Equation::new("f").over(sets).complements(name);
    if let Some(only) = only {
        (variable, equation) = (variable.only(only), equation.only(only));
    }
    Shape::builder().variable(variable).equation(equation).build().unwrap()
}

fn solution(shape: &Shape, z: &[f64]) -> Solution {
    Solution { shape: Arc::new(shape.clone()), z: z.to_vec(), ..Solution::nothing() }
}

#[test]
fn a_start_is_taken_over_by_name() {
    let old = solution(&trade(&["new-york", "chicago"]), &[1.0, 20.0, 3.0, 40.0, -5.0]);
    let mut new = trade(&["chicago", "topeka"]);
    assert_eq!(new.start_from(&old), Ok(3));
    // chicago from the point, topeka from the own start, p moved into its bounds.
    assert_eq!(new.start(), [20.0, 1.0, 40.0, 1.0, 0.0]);
}

#[test]
fn the_same_sets_take_everything_over() {
    let old = trade(&["new-york", "chicago"]);
    let z = [1.0, 2.0, 3.0, 4.0, 5.0];
    // A copy shares its sets, a second model has equal ones.
    for mut new in [old.clone(), trade(&["new-york", "chicago"])] {
        assert_eq!(new.start_from(&solution(&old, &z)), Ok(5));
        assert_eq!(new.start(), z);
    }
}

#[test]
fn numbered_and_named_sets_meet_in_their_labels() {
    let old = paired("x", &[&Set::count("periods", 3)], None);
    let mut new = paired("x", &[&Set::new("periods", ["3", "4", "1"]).unwrap()], None);
    assert_eq!(new.start_from(&solution(&old, &[1.0, 2.0, 3.0])), Ok(2));
    assert_eq!(new.start(), [3.0, 0.5, 1.0]);
}

#[test]
fn only_elements_that_both_have_are_taken() {
    let (plants, markets) = (Set::count("plants", 2), Set::count("markets", 3));
    let old = paired("x", &[&plants, &markets], Some(&[0, 2, 4]));
    let old = solution(&old, &[1.0, 2.0, 3.0]);
    let mut dense = paired("x", &[&plants, &markets], None);
    assert_eq!(dense.start_from(&old), Ok(3));
    assert_eq!(dense.start(), [1.0, 0.5, 2.0, 0.5, 3.0, 0.5]);
    let mut sparse = paired("x", &[&plants, &markets], Some(&[2, 3, 4]));
    assert_eq!(sparse.start_from(&old), Ok(2));
    assert_eq!(sparse.start(), [2.0, 0.5, 3.0]);
}

#[test]
fn a_family_of_one_meets_an_element_of_the_same_name() {
    let singles = fixed(["z[1]", "z[2]", "y[1]"]);
    let mut family = paired("z", &[&Set::count("rows", 3)], None);
    assert_eq!(family.start_from(&solution(&singles, &[7.0, 8.0, 9.0])), Ok(2));
    assert_eq!(family.start(), [7.0, 8.0, 0.5]);
    let mut singles = fixed(["z[3]", "y[1]", "z[4]"]);
    assert_eq!(singles.start_from(&solution(&family, &[4.0, 5.0, 6.0])), Ok(1));
    assert_eq!(singles.start(), [1.0, 1.0, 1.0], "fixed variables stay where they are fixed");
}

#[test]
fn other_index_sets_and_other_names_have_nothing_in_common() {
    let rows = Set::count("rows", 2);
    let old = solution(&paired("x", &[&rows], None), &[1.0, 2.0]);
    for mut new in [paired("x", &[&rows, &rows], None), paired("y", &[&rows], None)] {
        let before = new.start().to_vec();
        assert_eq!(new.start_from(&old), Ok(0));
        assert_eq!(new.start(), before);
    }
}

#[test]
fn a_point_that_is_none_is_refused_and_changes_nothing() {
    let shape = trade(&["new-york"]);
    let mut new = shape.clone();
    let short = new.start_from(&solution(&shape, &[1.0])).unwrap_err();
    assert_eq!(short.to_string(), "the length of `levels of the solution` is 1, expected 3");
    let nan = new.start_from(&solution(&shape, &[4.0, f64::NAN, 4.0])).unwrap_err();
    let message = "the start of variable `x[san-diego, new-york]` is NaN: give a finite number";
    assert_eq!(nan.to_string(), message);
    assert_eq!(new, shape);
}

#[test]
fn a_million_variables_take_no_quadratic_time() {
    let labels = |from: usize| (from..from + 1000).map(|k| format!("place {k}"));
    let set = |from| Set::new("places", labels(from)).unwrap();
    let old = paired("x", &[&set(0), &set(0)], None);
    let old = solution(&old, &vec![2.0; 1_000_000]);
    let mut new = paired("x", &[&set(500), &set(1)], None);
    assert_eq!(new.start_from(&old), Ok(500 * 999));
}
