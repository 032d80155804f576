use super::super::input::Table;
use super::super::layout::{At, Elements, Sparse};
use super::*;

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
        let mut parts = Parts::off(TEXTS);
        let mut assembly = parts.with(order).unwrap();
        parts.finish(&mut assembly, &mut Shape::default()).unwrap();
        assert_eq!(parts.names(), ["contact", "friction"]);
        let again = parts.with(Place(0)).unwrap_err();
        assert_eq!(again, ModelError::PartTwice { part: "contact".to_owned() });
    }
}

#[test]
fn parts_that_do_not_fit_together_are_named() {
    let message = |error: Result<Assembly, ModelError>| error.unwrap_err().to_string();
    let parts = Parts::off(TEXTS);
    assert_eq!(
        message(parts.with(Some(Place(1)))),
        "the part `friction` requires `contact`: switch both on, in one tuple"
    );
    assert_eq!(
        message(parts.with((Place(2), Place(1), Place(0)))),
        "the parts `friction` and `joint` exclude each other: switch one of them on"
    );
    assert!(parts.with((None::<Place>, ())).is_ok());
}

#[test]
fn an_element_is_fixed_by_one_part_only() {
    let with = |fixing: &[Option<usize>]| {
        built(Parts::off(TEXTS).with((Place(0), Place(1))).unwrap(), fixing)
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
    // The part `joint` is off.
    assert!(with(&[Some(0), Some(2)]).is_ok());
}

#[test]
fn an_addition_reaches_the_rows_that_it_is_for() {
    let layout = |length| Layout::new("x", &[&Set::count("s", length)]).unwrap();
    let all = Added::new(layout(3), 3, &[Some(0), Some(1), Some(2)]);
    assert_eq!([0, 1, 2].map(|row| all.to(row)), [Some(0), Some(1), Some(2)]);
    let some = Added::new(layout(3), 4, &[Some(3), None, Some(0)]);
    assert_eq!([0, 1, 2, 3].map(|row| some.to(row)), [Some(2), None, None, Some(0)]);
    let first = Added::new(layout(1), 2, &[Some(0)]);
    assert_eq!([0, 1].map(|row| first.to(row)), [Some(0), None]);
}

#[test]
fn an_addition_to_a_single_row_that_does_not_exist_is_an_error() {
    let mut assembly = Assembly::default();
    let added = assembly.addition(("market", 0, 1), &[], &|_: &At| None);
    assert_eq!(added.split(0), [0; 6]);
    let error = assembly.finish(&mut Shape::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "`adds market` names a row that does not exist: its condition does not hold"
    );
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
