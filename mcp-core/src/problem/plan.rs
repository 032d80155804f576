//! [`Plan`]: who reads what, and where derivatives go.

use super::Pattern;
use super::record::{Recorded, RowReads, all_rows, block, small};
use crate::model::{Row, Shape};
use std::ops::Range;

/// What one row reads, as ranges into the lists of [`Plan`].
pub(super) struct RowPlan {
    pub(super) row: Row,
    /// Variables read: their lanes come first.
    pub(super) variables: Range<usize>,
    /// Definitions read: their lanes follow.
    pub(super) definitions: Range<usize>,
    /// Where derivatives are added up: one target for each variable read, then, for each definition
    /// read, one for each variable of its support.
    pub(super) targets: Range<usize>,
}

/// Rows of a kind: entry and length of each family, and where the ranges of each row end.
#[derive(Debug, Default)]
pub(super) struct Sequence {
    pub(super) blocks: Vec<(usize, usize)>,
    /// Where the ranges of the first row start.
    pub(super) start: [u32; 3],
    pub(super) ends: Vec<[u32; 3]>,
}

impl Sequence {
    /// All rows in the order of their numbers.
    pub(super) fn rows(&self) -> impl Iterator<Item = RowPlan> + '_ {
        let starts = std::iter::once(&self.start).chain(&self.ends);
        let rows = all_rows(self.blocks.iter().copied());
        rows.zip(starts.zip(&self.ends)).map(|(row, (start, end))| {
            let range = |k: usize| start[k] as usize..end[k] as usize;
            RowPlan { row, variables: range(0), definitions: range(1), targets: range(2) }
        })
    }
}

/// Who reads what and where derivatives go; fixed for a problem.
#[derive(Debug, Default)]
pub(super) struct Plan {
    pub(super) equations: Sequence,
    pub(super) definitions: Sequence,
    pub(super) variable_of_row: Vec<u32>,
    pub(super) variables_read: Vec<u32>,
    pub(super) definitions_read: Vec<u32>,
    /// Positions in the Jacobian for equations, in the own gradient for definitions.
    pub(super) targets: Vec<u32>,
    /// Where the gradient of each definition stands among all.
    pub(super) gradient_of: Vec<Range<usize>>,
}

impl Plan {
    pub(super) fn new(shape: &Shape, recorded: &Recorded, pattern: &Pattern) -> Self {
        let supports = &recorded.definition_supports;
        let mut plan = Plan {
            variable_of_row: (0..shape.row_count())
                .map(|r| small(shape.variable_of_row(r)))
                .collect(),
            ..Plan::default()
        };
        let (of_rows, of_definitions) = (recorded.rows.sizes(), recorded.definitions.sizes());
        plan.variables_read.reserve_exact(of_rows[0] + of_definitions[0]);
        plan.definitions_read.reserve_exact(of_rows[1] + of_definitions[1]);
        plan.targets.reserve(of_rows[0] + of_definitions[0]);
        plan.equations.ends.reserve_exact(recorded.rows.len());
        plan.definitions.blocks = shape.definitions().iter().map(block).collect();
        for (k, support) in supports.iter().enumerate() {
            let place = |j: u32| support.binary_search(&j).expect("in the support");
            let ends = plan.row(recorded.definitions.row(k), supports, place);
            plan.definitions.ends.push(ends);
            let start = plan.gradient_of.last().map_or(0, |range| range.end);
            plan.gradient_of.push(start..start + support.len());
        }
        plan.equations.blocks = shape.equations().map(block).collect();
        plan.equations.start = plan.here();
        for number in 0..recorded.rows.len() {
            let i = plan.variable_of_row[number] as usize;
            let place = |j| pattern.position(i, j as usize).expect("the pattern has every support");
            let ends = plan.row(recorded.rows.row(number), supports, place);
            plan.equations.ends.push(ends);
        }
        plan
    }

    /// Where the lists end.
    fn here(&self) -> [u32; 3] {
        [&self.variables_read, &self.definitions_read, &self.targets].map(|list| small(list.len()))
    }

    /// Appends what a row reads and where its derivatives go.
    fn row(
        &mut self,
        reads: RowReads<'_>,
        supports: &[Vec<u32>],
        place: impl Fn(u32) -> usize,
    ) -> [u32; 3] {
        self.variables_read.extend_from_slice(reads.variables);
        self.definitions_read.extend_from_slice(reads.definitions);
        self.targets.extend(reads.variables.iter().map(|&j| small(place(j))));
        for &d in reads.definitions {
            self.targets.extend(supports[d as usize].iter().map(|&j| small(place(j))));
        }
        self.here()
    }
}
