//! What the parts that are on add to rows, found while the model is put together.

use super::assemble::{Assembly, PerElement};
use super::input::DataError;
use super::ix::narrow;
use super::layout::{Elements, Layout};
use crate::model::Set;

/// A term that is added to a row.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Term {
    /// Which of the additions of the text.
    pub addition: u32,
    /// For which combination of the indices that the addition runs over.
    combination: u32,
}

impl Term {
    /// For which combination of the indices that the addition runs over.
    #[inline]
    pub fn combination(self) -> usize {
        self.combination as usize
    }
}

/// The terms of each row of a family, those of a row in the order of the text: the list of all, where
/// those of each row start, and where the last end.
#[derive(Clone, Debug)]
pub(super) struct Additions {
    terms: Vec<Term>,
    starts: Vec<u32>,
}

impl Additions {
    /// The terms of a row.
    #[inline]
    pub(super) fn of(&self, row: usize) -> &[Term] {
        &self.terms[self.starts[row] as usize..self.starts[row + 1] as usize]
    }
}

/// The additions to one family that are on, in the order of the text.
#[derive(Default)]
pub(super) struct Found {
    /// Rows of the family.
    rows: usize,
    /// Each with its number and the row of every combination.
    additions: Vec<(u32, Vec<Option<usize>>)>,
}

impl Found {
    /// One addition more, to a family of `rows` rows.
    pub(super) fn push(&mut self, rows: usize, addition: (u32, Vec<Option<usize>>)) {
        self.rows = rows;
        self.additions.push(addition);
    }

    /// The terms of each row.
    pub(super) fn additions(&self) -> Additions {
        let all = || self.additions.iter().flat_map(|(addition, rows)| of_one(*addition, rows));
        let mut starts = vec![0; self.rows + 1];
        for (row, _) in all() {
            starts[row + 1] += 1;
        }
        for row in 0..self.rows {
            starts[row + 1] += starts[row];
        }
        let mut next = starts.clone();
        let mut terms = vec![Term { addition: 0, combination: 0 }; all().count()];
        for (row, term) in all() {
            terms[next[row] as usize] = term;
            next[row] += 1;
        }
        Additions { terms, starts }
    }
}

/// The terms of one addition, with their rows.
fn of_one(addition: u32, rows: &[Option<usize>]) -> impl Iterator<Item = (usize, Term)> + '_ {
    let term = move |(k, row): (usize, &Option<usize>)| {
        row.map(|row| (row, Term { addition, combination: narrow(k) }))
    };
    rows.iter().enumerate().filter_map(term)
}

impl Assembly {
    /// Finds the rows to which the addition number `addition` adds: for each combination of `sets` the
    /// one that `row` gives, if there is one; there must be some, unless a set is empty. The target, the
    /// family number `number` among those with additions, is called `name`, has `rows` rows, and is
    /// computed with what is added under `entry`.
    pub fn addition(
        &mut self,
        (name, number, rows, entry): (&str, usize, usize, usize),
        addition: u32,
        sets: &[&Set],
        row: &dyn PerElement<Option<usize>>,
    ) -> Layout {
        let layout = self.attempt(|pieces| {
            let layout = Layout::new(name, sets)?;
            let row = |combination| row.value(&layout.split(combination));
            let found: Vec<Option<usize>> = (0..layout.count).map(row).collect();
            if !found.is_empty() && found.iter().all(Option::is_none) {
                let (part, target) = (pieces.switches.at_hand(), name.to_owned());
                let sets = sets.iter().map(|set| set.name().to_owned()).collect();
                return Err(DataError::AddedToAbsent { part, target, sets }.into());
            }
            if !found.is_empty() {
                pieces.shape.enter(name, entry);
                pieces.switches.adds(number, rows, (addition, found));
            }
            Ok(layout)
        });
        layout.unwrap_or(Layout::EMPTY)
    }
}

#[cfg(test)]
#[path = "additions_tests.rs"]
mod tests;
