//! [`Sequence`]: what the rows of a kind carry, row by row, as runs of rows that are alike.
//!
//! On a grid a row carries what the row before it carries, one node on: of such rows the first is kept, and
//! one step for every number of its list. Rows without a pattern are runs of one row.

use super::record::{all_rows, small};
use crate::model::Row;

/// By what the derivatives of one row are not constant, and where they go: one list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct RowPlan<'a> {
    numbers: &'a [u32],
    variables: usize,
    definitions: usize,
}

impl<'a> RowPlan<'a> {
    /// Number of variables and definitions by which a derivative is carried.
    #[inline]
    pub(super) fn lanes(&self) -> usize {
        self.variables + self.definitions
    }

    /// Variables read, whose lanes come first; definitions read, in the order of their supports, whose lanes
    /// follow; and where derivatives are added up: one target for each variable read, then, for each support
    /// among the definitions read, one for each of its variables.
    #[inline]
    pub(super) fn split(&self) -> [&'a [u32]; 3] {
        let (variables, rest) = self.numbers.split_at(self.variables);
        let (definitions, targets) = rest.split_at(self.definitions);
        [variables, definitions, targets]
    }
}

/// What a row carries, as a list of its own.
#[derive(Clone, Debug, Default)]
pub(super) struct RowList {
    numbers: Vec<u32>,
    variables: usize,
    definitions: usize,
}

impl RowList {
    /// Empty, for a list of that length.
    pub(super) fn with_capacity(longest: usize) -> Self {
        RowList { numbers: Vec::with_capacity(longest), ..RowList::default() }
    }

    /// What is read; targets follow.
    pub(super) fn begin(&mut self, variables: &[u32], definitions: &[u32]) {
        (self.variables, self.definitions) = (variables.len(), definitions.len());
        self.numbers.clear();
        self.numbers.extend_from_slice(variables);
        self.numbers.extend_from_slice(definitions);
    }

    /// The next target.
    pub(super) fn push(&mut self, target: u32) {
        self.numbers.push(target);
    }

    pub(super) fn row(&self) -> RowPlan<'_> {
        let RowList { ref numbers, variables, definitions } = *self;
        RowPlan { numbers, variables, definitions }
    }
}

/// Rows that follow each other; the next run says where it ends.
#[derive(Clone, Copy, Debug)]
struct Run {
    /// Number of its first row.
    first: u32,
    /// Where the numbers of the first row start; then come, if it is not the only one, as many steps.
    start: u32,
    variables: u32,
    definitions: u32,
}

/// Rows of a kind: entry and length of each family, and what each row carries.
#[derive(Debug, Default)]
pub(super) struct Sequence {
    pub(super) blocks: Vec<(usize, usize)>,
    rows: u32,
    runs: Vec<Run>,
    numbers: Vec<u32>,
}

impl Sequence {
    /// All rows in the order of their numbers.
    pub(super) fn rows(&self) -> impl Iterator<Item = Row> + '_ {
        all_rows(self.blocks.iter().copied())
    }

    /// Number of rows whose lists are known.
    pub(super) fn len(&self) -> usize {
        self.rows as usize
    }

    /// Appends a row.
    pub(super) fn push(&mut self, row: RowPlan<'_>) {
        let number = self.rows;
        if !self.goes_on(row) {
            let (start, variables) = (small(self.numbers.len()), small(row.variables));
            let definitions = small(row.definitions);
            self.runs.push(Run { first: number, start, variables, definitions });
            self.numbers.extend_from_slice(row.numbers);
        }
        self.rows += 1;
    }

    /// Whether a row is the next of the last run, which a second row of the same size always is: it says
    /// what the steps are.
    fn goes_on(&mut self, row: RowPlan<'_>) -> bool {
        let Some(&run) = self.runs.last() else { return false };
        let (length, count) = self.size(self.runs.len() - 1);
        let is_alike = (run.variables as usize, run.definitions as usize, count)
            == (row.variables, row.definitions, row.numbers.len());
        if !is_alike {
            return false;
        }
        let start = run.start as usize;
        if length == 1 {
            for (k, next) in row.numbers.iter().enumerate() {
                self.numbers.push(next.wrapping_sub(self.numbers[start + k]));
            }
            return true;
        }
        let (first, steps) = self.numbers[start..].split_at(count);
        let next = |(first, step): (&u32, &u32)| first.wrapping_add(step.wrapping_mul(length));
        first.iter().zip(steps).map(next).eq(row.numbers.iter().copied())
    }

    /// Gives memory back that no further row will need.
    pub(super) fn shrink(&mut self) {
        self.runs.shrink_to_fit();
        self.numbers.shrink_to_fit();
    }

    /// Number of rows of run `k`, and how many numbers each has.
    fn size(&self, k: usize) -> (u32, usize) {
        let (run, next) = (self.runs[k], self.runs.get(k + 1));
        let end = (self.rows, small(self.numbers.len()));
        let (end, numbers_end) = next.map_or(end, |next| (next.first, next.start));
        let (length, numbers) = (end - run.first, (numbers_end - run.start) as usize);
        (length, if length == 1 { numbers } else { numbers / 2 })
    }

    /// Length of the longest list, and most definitions in a list.
    pub(super) fn most(&self) -> [usize; 2] {
        let longest = (0..self.runs.len()).map(|k| self.size(k).1).max();
        let definitions = self.runs.iter().map(|run| run.definitions as usize).max();
        [longest.unwrap_or(0), definitions.unwrap_or(0)]
    }

    /// Goes through all rows from the first; `list` is memory for one row.
    pub(super) fn walk<'a>(&'a self, list: &'a mut RowList) -> Walk<'a> {
        Walk { rows: self, list, run: 0, left: 0, steps: &[] }
    }
}

/// A walk over the rows of a [`Sequence`].
pub(super) struct Walk<'a> {
    rows: &'a Sequence,
    list: &'a mut RowList,
    /// The run to come.
    run: usize,
    /// Rows left in the run at hand, and its steps.
    left: u32,
    steps: &'a [u32],
}

impl Walk<'_> {
    /// What the next row carries.
    ///
    /// # Panics
    /// After the last row.
    #[inline]
    pub(super) fn next(&mut self) -> RowPlan<'_> {
        if self.left == 0 {
            self.enter();
        } else {
            for (number, &step) in self.list.numbers.iter_mut().zip(self.steps) {
                *number = number.wrapping_add(step);
            }
        }
        self.left -= 1;
        self.list.row()
    }

    /// Lists the first row of the next run.
    fn enter(&mut self) {
        let run = self.rows.runs[self.run];
        let (length, count) = self.rows.size(self.run);
        let (first, steps) = self.rows.numbers[run.start as usize..].split_at(count);
        self.list.numbers.clear();
        self.list.numbers.extend_from_slice(first);
        self.list.variables = run.variables as usize;
        self.list.definitions = run.definitions as usize;
        self.steps = if length == 1 { &[] } else { &steps[..count] };
        self.left = length;
        self.run += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of variables, definitions and targets.
    fn sequence(rows: &[[&[u32]; 3]]) -> Sequence {
        let (mut sequence, mut list) = (Sequence::default(), RowList::default());
        for [variables, definitions, targets] in rows {
            list.begin(variables, definitions);
            targets.iter().for_each(|&target| list.push(target));
            sequence.push(list.row());
        }
        sequence
    }

    #[test]
    fn a_walk_gives_every_row_as_it_was_pushed() {
        let rows: [[&[u32]; 3]; 9] = [
            [&[5], &[], &[1]],
            [&[0, 7], &[], &[9, 3]],
            [&[1, 6], &[], &[8, 4]],
            [&[2, 5], &[], &[7, 5]],
            [&[2, 5], &[0], &[7, 5, 1]],
            [&[], &[], &[]],
            [&[], &[], &[]],
            [&[], &[], &[]],
            [&[3], &[], &[3]],
        ];
        let sequence = sequence(&rows);
        let mut list = RowList::default();
        let mut walk = sequence.walk(&mut list);
        for row in rows {
            assert_eq!(walk.next().split(), row);
        }
        assert_eq!((sequence.len(), sequence.most()), (9, [6, 1]));
    }

    #[test]
    fn rows_that_go_on_alike_are_one_run() {
        let numbers: Vec<[u32; 1]> = (0..1000).map(|k| [3000 - 3 * k]).collect();
        let rows: Vec<[&[u32]; 3]> = numbers.iter().map(|k| [&k[..], &[], &k[..]]).collect();
        let sequence = sequence(&rows);
        assert_eq!((sequence.runs.len(), sequence.numbers.len()), (1, 4));
    }
}
