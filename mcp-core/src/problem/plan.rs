//! [`Plan`]: who reads what, and where derivatives go.

use super::Pattern;
use super::constants::{Constants, Read, Survey};
use super::record::{Recorded, RowReads, all_rows, block, small};
use super::rows::{JetRows, Kind};
use crate::model::{Point, Row, Shape};
use std::ops::Range;

/// By what the derivatives of one row are not constant: parts of the lists of [`Plan`].
pub(super) struct RowPlan<'a> {
    /// Variables read: their lanes come first.
    pub(super) variables: &'a [u32],
    /// Definitions read: their lanes follow.
    pub(super) definitions: &'a [u32],
    /// Where derivatives are added up: one target for each variable read, then, for each support
    /// among the definitions read, one for each of its variables.
    pub(super) targets: &'a [u32],
}

impl RowPlan<'_> {
    #[inline]
    pub(super) fn lanes(&self) -> usize {
        self.variables.len() + self.definitions.len()
    }
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
    /// Range `k` of row `number`: variables, definitions, targets.
    fn range(&self, number: usize, k: usize) -> Range<usize> {
        let start = number.checked_sub(1).map_or(&self.start, |before| &self.ends[before]);
        start[k] as usize..self.ends[number][k] as usize
    }

    /// Whether a row that is already known carries any derivative.
    fn is_carried(&self, number: u32) -> bool {
        let of = |k| !self.range(number as usize, k).is_empty();
        of(0) || of(1)
    }

    /// All rows in the order of their numbers.
    pub(super) fn rows(&self) -> impl Iterator<Item = Row> + '_ {
        all_rows(self.blocks.iter().copied())
    }
}

/// Variables that definitions depend on: each list once, however many definitions have it.
#[derive(Debug, Default)]
pub(super) struct Supports {
    variables: Vec<u32>,
    ranges: Vec<Range<usize>>,
    /// Number of the support of every definition.
    pub(super) of_definition: Vec<u32>,
}

impl Supports {
    fn new(supports: &[Vec<u32>]) -> Self {
        let mut by_list: Vec<usize> = (0..supports.len()).collect();
        by_list.sort_by_key(|&d| &supports[d]);
        let mut all = Supports { of_definition: vec![0; supports.len()], ..Supports::default() };
        for (k, &d) in by_list.iter().enumerate() {
            if k == 0 || supports[by_list[k - 1]] != supports[d] {
                let start = all.variables.len();
                all.variables.extend_from_slice(&supports[d]);
                all.ranges.push(start..all.variables.len());
            }
            all.of_definition[d] = small(all.ranges.len() - 1);
        }
        all
    }

    /// The variables of a support, increasing.
    pub(super) fn variables(&self, support: u32) -> &[u32] {
        &self.variables[self.ranges[support as usize].clone()]
    }
}

/// Who reads what and where derivatives go; fixed for a problem.
#[derive(Debug, Default)]
pub(super) struct Plan {
    pub(super) equations: Sequence,
    pub(super) definitions: Sequence,
    pub(super) variable_of_row: Vec<u32>,
    pub(super) variables_read: Vec<u32>,
    /// Those of a row in the order of their supports.
    pub(super) definitions_read: Vec<u32>,
    /// Positions in the Jacobian for equations, in the own gradient for definitions.
    pub(super) targets: Vec<u32>,
    /// Where the gradient of each definition stands among all.
    pub(super) gradient_of: Vec<Range<usize>>,
    pub(super) supports: Supports,
}

impl Plan {
    /// With `rows`, constant derivatives are found and left out of the lists.
    pub(super) fn new(
        rows: Option<&dyn JetRows>,
        shape: &Shape,
        recorded: &Recorded,
        pattern: &Pattern,
        survey: &mut Survey,
    ) -> (Self, Constants) {
        let supports = &recorded.definition_supports;
        let row_count = shape.row_count();
        let mut plan = Plan {
            variable_of_row: (0..row_count).map(|r| small(shape.variable_of_row(r))).collect(),
            supports: Supports::new(supports),
            ..Plan::default()
        };
        for support in supports {
            let start = plan.gradient_of.last().map_or(0, |range| range.end);
            plan.gradient_of.push(start..start + support.len());
        }
        plan.definitions.blocks = shape.definitions().iter().map(block).collect();
        plan.equations.blocks = shape.equations().map(block).collect();
        let parameters = shape.parameter_values();
        let mut constants = Constants::default();
        if rows.is_some() {
            constants.clear(&plan, pattern, parameters);
        }
        let mut values = vec![0.0; supports.len()];
        let (mut variables, mut definitions) = (Vec::new(), Vec::new());
        for (kind, reads) in
            [(Kind::Definition, &recorded.definitions), (Kind::Equation, &recorded.rows)]
        {
            plan.sequence_mut(kind).start = plan.here();
            let blocks = plan.sequence(kind).blocks.clone();
            for (number, row) in all_rows(blocks.into_iter()).enumerate() {
                let Some(rows) = rows else {
                    plan.push(kind, number, reads.row(number), pattern);
                    continue;
                };
                let point = Point { z: shape.start(), definitions: &values, parameters };
                let value = survey.run(rows, (kind, row), point);
                if let Kind::Definition = kind {
                    values[number] = value;
                }
                let is_carried = |d: u32| plan.definitions.is_carried(d);
                numbers_of(&survey.variables, |read| !read.is_constant, &mut variables);
                let varies = |read: &Read| !read.is_constant || is_carried(read.number);
                numbers_of(&survey.definitions, varies, &mut definitions);
                let carried = RowReads { variables: &variables, definitions: &definitions };
                plan.push(kind, number, carried, pattern);
                constants.add(&plan, (kind, number), pattern, survey);
            }
        }
        constants.shrink();
        (plan, constants)
    }

    /// What row `number` carries, which starts where the last one ended.
    #[inline]
    pub(super) fn row<'a>(
        &'a self,
        rows: &Sequence,
        number: usize,
        start: &mut [u32; 3],
    ) -> RowPlan<'a> {
        let end = rows.ends[number];
        let range = |k: usize| start[k] as usize..end[k] as usize;
        let row = RowPlan {
            variables: &self.variables_read[range(0)],
            definitions: &self.definitions_read[range(1)],
            targets: &self.targets[range(2)],
        };
        *start = end;
        row
    }

    /// Of every definition, then of every equation: how many lanes it carries, and how many variables
    /// the definitions among them have.
    pub(super) fn carried(&self) -> impl Iterator<Item = (usize, usize)> {
        [&self.definitions, &self.equations].into_iter().flat_map(move |rows| {
            let mut here = rows.start;
            (0..rows.ends.len()).map(move |number| {
                let row = self.row(rows, number, &mut here);
                let size = |&d: &u32| self.gradient_of[d as usize].len();
                (row.lanes(), row.definitions.iter().map(size).sum())
            })
        })
    }

    /// Most definitions that a row carries, and most variables of one definition.
    pub(super) fn largest(&self) -> [usize; 2] {
        let carried = |rows: &Sequence| (0..rows.ends.len()).map(|k| rows.range(k, 1).len()).max();
        let definitions = carried(&self.definitions).max(carried(&self.equations));
        let support = self.gradient_of.iter().map(Range::len).max();
        [definitions, support].map(|size| size.unwrap_or(0))
    }

    pub(super) fn sequence(&self, kind: Kind) -> &Sequence {
        match kind {
            Kind::Equation => &self.equations,
            Kind::Definition => &self.definitions,
        }
    }

    fn sequence_mut(&mut self, kind: Kind) -> &mut Sequence {
        match kind {
            Kind::Equation => &mut self.equations,
            Kind::Definition => &mut self.definitions,
        }
    }

    /// Number of entries of the gradients of all definitions.
    pub(super) fn gradient_entries(&self) -> usize {
        self.gradient_of.last().map_or(0, |range| range.end)
    }

    /// Where the derivative of a row by a variable goes: in the Jacobian or among all gradients.
    pub(super) fn place(&self, (kind, number): (Kind, usize), j: u32, pattern: &Pattern) -> usize {
        match kind {
            Kind::Equation => pattern
                .position(self.variable_of_row[number] as usize, j as usize)
                .expect("the pattern has every support"),
            Kind::Definition => {
                let support = self.supports.variables(self.supports.of_definition[number]);
                let place = support.binary_search(&j).expect("in the support");
                self.gradient_of[number].start + place
            }
        }
    }

    /// Where the lists end.
    fn here(&self) -> [u32; 3] {
        [&self.variables_read, &self.definitions_read, &self.targets].map(|list| small(list.len()))
    }

    /// Appends what a row reads and where its derivatives go.
    fn push(&mut self, kind: Kind, number: usize, reads: RowReads<'_>, pattern: &Pattern) {
        // Targets of a definition are those in its own gradient.
        let start = match kind {
            Kind::Equation => 0,
            Kind::Definition => self.gradient_of[number].start,
        };
        let of_row = (kind, number);
        let first = self.definitions_read.len();
        self.variables_read.extend_from_slice(reads.variables);
        self.definitions_read.extend_from_slice(reads.definitions);
        let of_definition = &self.supports.of_definition;
        self.definitions_read[first..].sort_by_key(|&d| of_definition[d as usize]);
        let mut targets = std::mem::take(&mut self.targets);
        let target = |&j: &u32| small(self.place(of_row, j, pattern) - start);
        targets.extend(reads.variables.iter().map(target));
        for group in self.supports.groups(&self.definitions_read[first..]) {
            let support = self.supports.of_definition[group[0] as usize];
            targets.extend(self.supports.variables(support).iter().map(target));
        }
        self.targets = targets;
        let ends = self.here();
        self.sequence_mut(kind).ends.push(ends);
    }

    /// Whether the derivative of a row by a variable is carried.
    pub(super) fn carries_variable(&self, (kind, number): (Kind, usize), j: u32) -> bool {
        let range = self.sequence(kind).range(number, 0);
        self.variables_read[range].binary_search(&j).is_ok()
    }

    /// Whether the derivative of a row by a definition is carried.
    pub(super) fn carries_definition(&self, (kind, number): (Kind, usize), d: u32) -> bool {
        let key = |d: u32| (self.supports.of_definition[d as usize], d);
        let range = self.sequence(kind).range(number, 1);
        self.definitions_read[range].binary_search_by_key(&key(d), |&d| key(d)).is_ok()
    }
}

/// Numbers of those reads that are to be carried.
fn numbers_of(reads: &[Read], is_carried: impl Fn(&Read) -> bool, numbers: &mut Vec<u32>) {
    numbers.clear();
    numbers.extend(reads.iter().filter(|read| is_carried(read)).map(|read| read.number));
}

impl Supports {
    /// Definitions in the order of their supports, by support.
    pub(super) fn groups<'a>(&self, definitions: &'a [u32]) -> impl Iterator<Item = &'a [u32]> {
        let of = &self.of_definition;
        definitions.chunk_by(|&a, &b| of[a as usize] == of[b as usize])
    }
}
