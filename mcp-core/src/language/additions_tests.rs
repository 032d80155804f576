use super::super::layout::At;
use super::super::parts::{PartText, Parts, PartsOf};
use super::*;
use crate::error::ModelError;
use crate::model::Shape;

static TEXTS: &[PartText] = &[PartText { name: "tax", requires: &[], excludes: &[] }];

struct Tax;

impl PartsOf<()> for Tax {
    fn give(self, assembly: &mut Assembly) {
        assembly.switch_on(0);
    }
}

/// One addition to a family of so many rows over `s`: the row of every combination.
fn found(additions: &[(u32, &[Option<usize>])], rows: usize) -> Additions {
    let mut found = Found::default();
    for (addition, of) in additions {
        found.push(rows, (*addition, of.to_vec()));
    }
    found.additions()
}

#[test]
fn a_row_has_its_own_terms_in_the_order_of_the_text() {
    let additions = found(
        &[(0, &[Some(0), Some(1), Some(3)]), (2, &[Some(3), None, Some(0)]), (5, &[Some(3)])],
        4,
    );
    let terms = |row: usize| -> Vec<(u32, usize)> {
        additions.of(row).iter().map(|term| (term.addition, term.combination())).collect()
    };
    assert_eq!(terms(0), [(0, 0), (2, 2)]);
    assert_eq!(terms(1), [(0, 1)]);
    assert_eq!(terms(2), []);
    assert_eq!(terms(3), [(0, 2), (2, 0), (5, 0)]);
}

/// What is said if the tax adds to `market` over sets of these lengths, where it has these rows.
fn said(lengths: &[usize], row: &dyn PerElement<Option<usize>>) -> Option<String> {
    let mut assembly = Parts::off(TEXTS).with(&Shape::default(), Tax).unwrap();
    let sets: Vec<Set> = lengths.iter().map(|&n| Set::count(format!("set{n}"), n)).collect();
    let sets: Vec<&Set> = sets.iter().collect();
    assembly.enter(0);
    assembly.addition(("market", 0, 4, 1), 0, &sets, row);
    let finished = assembly.finish(&mut Shape::default());
    finished.err().map(|error: ModelError| error.to_string())
}

#[test]
fn an_addition_to_no_row_at_all_is_an_error() {
    assert_eq!(
        said(&[], &|_: &At| None).unwrap(),
        "the part `tax` adds to `market`, which has no row there: its condition does not hold"
    );
    assert_eq!(
        said(&[2, 3], &|_: &At| None).unwrap(),
        "the part `tax` adds to `market` over `set2`, `set3`, where it has no row: its condition \
         holds for none of them"
    );
    let only_one = |at: &At| (at[0] == 1).then_some(0);
    assert_eq!(said(&[2], &only_one), None);
    assert_eq!(said(&[0], &|_: &At| None), None, "an empty set has nothing to add");
}
