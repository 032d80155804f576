use super::super::input::Table;
use super::super::layout::{At, Elements, Sparse};
use super::*;
use crate::model::Set;

static TEXTS: &[PartText] = &[
    PartText { name: "contact", requires: &[], excludes: &[] },
    PartText { name: "friction", requires: &[0], excludes: &[2] },
    PartText { name: "joint", requires: &[], excludes: &[] },
];

/// A part by its place in the text, without data.
struct Place(usize);

impl PartsOf<()> for Place {
    fn give(self, assembly: &mut Assembly) {
        assembly.switch_on(self.0);
    }
}

/// `x` with one element for each part at hand, of which each part fixes the first.
fn built(mut assembly: Assembly, fixing: &[Option<usize>]) -> Result<Shape, ModelError> {
    let mut x = Sparse::EMPTY;
    let sets = [&Set::count("all", 2)];
    assembly.variables(&["x", "", ""], &sets, None).fill(&mut x);
    for &part in fixing {
        if let Some(part) = part {
            assembly.enter(part);
        }
        assembly.fix("x", &[], &|_: &At| (Some(0), 1.0));
        assembly.leave();
    }
    assembly.equation_like(&["e", "", ""], &sets, "x", None);
    let mut shape = Shape::default();
    assembly.finish(&mut shape).map(|()| shape)
}

#[test]
fn parts_are_on_in_the_order_of_the_text_whatever_the_order_of_the_caller() {
    for order in [(Place(1), Place(0)), (Place(0), Place(1))] {
        let (mut parts, before) = (Parts::off(TEXTS), Shape::default());
        let (mut assembly, mut shape) = (parts.with(&before, order).unwrap(), Shape::default());
        parts.finish(&mut assembly, &before, &mut shape).unwrap();
        assert_eq!(shape.parts(), ["contact", "friction"]);
        let again = parts.with(&shape, Place(0)).unwrap_err();
        assert_eq!(again, ModelError::PartTwice { part: "contact".to_owned() });
    }
}

#[test]
fn parts_that_do_not_fit_together_are_named() {
    let message = |error: Result<Assembly, ModelError>| error.unwrap_err().to_string();
    let (parts, base) = (Parts::off(TEXTS), Shape::default());
    assert_eq!(
        message(parts.with(&base, Some(Place(1)))),
        "the part `friction` requires `contact`: switch both on, in one tuple"
    );
    assert_eq!(
        message(parts.with(&base, (Place(2), Place(1), Place(0)))),
        "the parts `friction` and `joint` exclude each other: switch one of them on"
    );
    assert!(parts.with(&base, (None::<Place>, ())).is_ok());
}

#[test]
fn an_element_is_fixed_by_one_part_only() {
    let with = |fixing: &[Option<usize>]| {
        let parts = Parts::off(TEXTS);
        built(parts.with(&Shape::default(), (Place(0), Place(1))).unwrap(), fixing)
    };
    let twice = |error: Result<Shape, ModelError>| error.unwrap_err().to_string();
    assert_eq!(with(&[Some(1), Some(1)]).unwrap().bounds().upper()[0], 1.0);
    assert_eq!(
        twice(with(&[None, Some(1)])),
        "`x[1]` is fixed twice, by the model and by the part `friction`"
    );
    assert_eq!(
        twice(with(&[Some(0), Some(1)])),
        "`x[1]` is fixed twice, by the part `contact` and by the part `friction`"
    );
    assert_eq!(
        twice(with(&[Some(1), Some(0), None])),
        "`x[1]` is fixed twice, by the part `friction` and by the part `contact`"
    );
    // The part `joint` is off.
    assert!(with(&[Some(0), Some(2)]).is_ok());
}

#[test]
fn values_that_are_kept_come_before_those_of_the_text() {
    let mut made = Filled::EMPTY;
    for kept in [false, true] {
        let mut assembly = Assembly::default();
        assembly.keep(0, &made);
        if !kept {
            assembly.give(0, Table::from(3.0));
        }
        assembly.parameter(0, &["t", "", ""], &[], Some(&|_: &At| 1.0)).fill(&mut made);
        assert_eq!(made.values(), [3.0]);
    }
}
