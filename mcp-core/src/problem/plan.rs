//! [`Plan`]: who reads what, and where derivatives go.

use super::Pattern;
use super::constants::{Constants, Read, Survey};
use super::record::{Recorded, all_rows, block, small};
use super::rows::{JetRows, Kind};
use super::runs::{RowList, Sequence};
use crate::model::{Point, Shape};
use std::ops::Range;

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

/// The variables that rows are paired with, by the numbers of the rows.
#[derive(Debug, Default)]
enum Paired {
    /// That of the same number.
    #[default]
    Same,
    /// Listed.
    List(Vec<u32>),
}

/// Who reads what and where derivatives go; fixed for a problem.
///
/// Targets are positions in the Jacobian for equations, in the own gradient for definitions.
#[derive(Debug, Default)]
pub(super) struct Plan {
    pub(super) equations: Sequence,
    pub(super) definitions: Sequence,
    paired: Paired,
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
        let is_same = (0..row_count).all(|row| shape.variable_of_row(row) == row);
        let mut plan = Plan { supports: Supports::new(supports), ..Plan::default() };
        if !is_same {
            let variables = (0..row_count).map(|row| small(shape.variable_of_row(row)));
            plan.paired = Paired::List(variables.collect());
        }
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
        let mut is_carried = vec![false; supports.len()];
        let (mut variables, mut definitions) = (Vec::new(), Vec::new());
        let mut list = RowList::default();
        for (kind, reads) in
            [(Kind::Definition, &recorded.definitions), (Kind::Equation, &recorded.rows)]
        {
            let blocks = plan.sequence(kind).blocks.clone();
            for (number, row) in all_rows(blocks.into_iter()).enumerate() {
                if let Some(rows) = rows {
                    let point = Point { z: shape.start(), definitions: &values, parameters };
                    let value = survey.run(rows, (kind, row), point);
                    if let Kind::Definition = kind {
                        values[number] = value;
                    }
                    numbers_of(&survey.variables, |read| !read.is_constant, &mut variables);
                    let varies =
                        |read: &Read| !read.is_constant || is_carried[read.number as usize];
                    numbers_of(&survey.definitions, varies, &mut definitions);
                } else {
                    let own = reads.row(number);
                    variables.clear();
                    variables.extend_from_slice(own.variables);
                    definitions.clear();
                    definitions.extend_from_slice(own.definitions);
                }
                plan.list((kind, number), &variables, &mut definitions, pattern, &mut list);
                let row = list.row();
                if rows.is_some() {
                    constants.add(&plan, ((kind, number), row), pattern, survey);
                }
                if let Kind::Definition = kind {
                    is_carried[number] = row.lanes() > 0;
                }
                plan.sequence_mut(kind).push(row);
            }
            plan.sequence_mut(kind).shrink();
        }
        constants.shrink();
        (plan, constants)
    }

    /// The variable that equation `row` is paired with.
    #[inline]
    pub(super) fn variable_of(&self, row: usize) -> usize {
        match &self.paired {
            Paired::Same => row,
            Paired::List(variables) => variables[row] as usize,
        }
    }

    /// Of every definition, then of every equation: how many lanes it carries, and how many variables
    /// the definitions among them have.
    pub(super) fn carried(&self) -> Vec<(usize, usize)> {
        let mut list = RowList::default();
        let mut carried = Vec::new();
        for rows in [&self.definitions, &self.equations] {
            let mut walk = rows.walk(&mut list);
            for _ in 0..rows.len() {
                let row = walk.next();
                let [_, definitions, _] = row.split();
                let size = |&d: &u32| self.gradient_of[d as usize].len();
                carried.push((row.lanes(), definitions.iter().map(size).sum()));
            }
        }
        carried
    }

    /// Length of the longest list of a row, and most definitions in a list.
    pub(super) fn most(&self) -> [usize; 2] {
        let [definitions, equations] = [self.definitions.most(), self.equations.most()];
        std::array::from_fn(|k| definitions[k].max(equations[k]))
    }

    /// Most variables of one definition.
    pub(super) fn largest_support(&self) -> usize {
        self.gradient_of.iter().map(Range::len).max().unwrap_or(0)
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
                .position(self.variable_of(number), j as usize)
                .expect("the pattern has every support"),
            Kind::Definition => {
                let support = self.supports.variables(self.supports.of_definition[number]);
                let place = support.binary_search(&j).expect("in the support");
                self.gradient_of[number].start + place
            }
        }
    }

    /// What a row carries that reads this; definitions are brought into the order of their supports.
    fn list(
        &self,
        row: (Kind, usize),
        variables: &[u32],
        definitions: &mut [u32],
        pattern: &Pattern,
        list: &mut RowList,
    ) {
        // Targets of a definition are those in its own gradient.
        let start = match row.0 {
            Kind::Equation => 0,
            Kind::Definition => self.gradient_of[row.1].start,
        };
        definitions.sort_by_key(|&d| self.supports.of_definition[d as usize]);
        list.begin(variables, definitions);
        let target = |&j: &u32| small(self.place(row, j, pattern) - start);
        variables.iter().map(target).for_each(|target| list.push(target));
        for group in self.supports.groups(definitions) {
            let support = self.supports.of_definition[group[0] as usize];
            let variables = self.supports.variables(support);
            variables.iter().map(target).for_each(|target| list.push(target));
        }
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

    /// Whether a definition is among these, which are in the order of their supports.
    pub(super) fn find(&self, definitions: &[u32], d: u32) -> bool {
        let key = |d: u32| (self.of_definition[d as usize], d);
        definitions.binary_search_by_key(&key(d), |&d| key(d)).is_ok()
    }
}
