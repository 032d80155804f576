//! Which variables, definitions and parameters every row reads.

use super::Pattern;
pub(super) use super::pattern::small;
use super::rows::{Kind, RowsIn};
use crate::error::ModelError;
use crate::generic::generic;
use crate::model::{Family, Model, Point, Reader, Reads, Recorder, Row, Shape};
use crate::scalar::{Real, Scalar, Trace};
use std::cell::RefCell;

/// What rows of a kind read, one after the other, each sorted and without repetitions.
#[derive(Debug, Default)]
pub(super) struct ReadTable {
    variables: Vec<u32>,
    definitions: Vec<u32>,
    /// Where the reads of each row end.
    ends: Vec<[u32; 2]>,
}

/// What one row reads.
#[derive(Clone, Copy, Debug)]
pub(super) struct RowReads<'a> {
    pub(super) variables: &'a [u32],
    pub(super) definitions: &'a [u32],
}

impl ReadTable {
    /// Number of rows.
    pub(super) fn len(&self) -> usize {
        self.ends.len()
    }

    /// What row number `k` reads.
    pub(super) fn row(&self, k: usize) -> RowReads<'_> {
        let start = k.checked_sub(1).map_or([0, 0], |before| self.ends[before]);
        let range = |which: usize| start[which] as usize..self.ends[k][which] as usize;
        RowReads { variables: &self.variables[range(0)], definitions: &self.definitions[range(1)] }
    }

    fn push(&mut self, reads: &Reads) {
        self.variables.extend(reads.variables.iter().map(|&j| small(j)));
        self.definitions.extend(reads.definitions.iter().map(|&d| small(d)));
        self.ends.push([small(self.variables.len()), small(self.definitions.len())]);
    }
}

/// What all rows of a model read.
#[derive(Debug)]
pub(super) struct Recorded {
    /// In the order of the rows.
    pub(super) rows: ReadTable,
    /// In the order of the definitions.
    pub(super) definitions: ReadTable,
    /// Variables that every definition depends on, directly or through earlier definitions.
    pub(super) definition_supports: Vec<Vec<u32>>,
}

/// Entry and length of a family.
pub(super) fn block(family: &Family) -> (usize, usize) {
    (family.entry(), family.len())
}

/// Rows of a kind in the order of their numbers, family by family.
pub(super) fn all_rows(blocks: impl Iterator<Item = (usize, usize)>) -> impl Iterator<Item = Row> {
    blocks.flat_map(|(family, len)| (0..len).map(move |index| Row { family, index }))
}

/// Runs every row once at the start of the model and notes what it reads, and what it reads `besides` by
/// word of the caller: pairs of a variable, whose equation it is, and a variable read. At three other
/// points every row must read no more than that.
pub(super) fn record_rows(
    model: &dyn RowsIn<f64>,
    shape: &Shape,
    besides: &[(usize, usize)],
) -> Result<Recorded, ModelError> {
    let (mut definitions, mut rows) = (ReadTable::default(), ReadTable::default());
    for_each_row(model, shape, shape.start(), &mut |row, reads| {
        sort(&mut reads.variables);
        sort(&mut reads.definitions);
        match row {
            Numbered::Definition(k) => {
                if let Some(&later) = reads.definitions.iter().find(|&&d| d >= k) {
                    let definition = shape.definition_name(k);
                    let later = shape.definition_name(later);
                    return Err(ModelError::DefinitionOrder { definition, later });
                }
                definitions.push(reads);
            }
            Numbered::Equation(number) if besides.is_empty() => {
                debug_assert_eq!(number, rows.len());
                rows.push(reads);
            }
            Numbered::Equation(number) => {
                let i = shape.variable_of_row(number);
                let more = besides.iter().filter(|(equation, _)| *equation == i);
                reads.variables.extend(more.map(|&(_, j)| j));
                sort(&mut reads.variables);
                rows.push(reads);
            }
        }
        Ok(())
    })?;
    let mut definition_supports: Vec<Vec<u32>> = Vec::new();
    for k in 0..definitions.len() {
        let support = support_of(definitions.row(k), &definition_supports);
        definition_supports.push(support);
    }
    let recorded = Recorded { rows, definitions, definition_supports };
    check_reads(model, shape, &recorded)?;
    Ok(recorded)
}

/// Where rows are run again: `z_j = z⁰_j + factor · part_j · max(|z⁰_j|, 1)`, with its own part of each
/// variable, between −1 and 1. The first two are on either side of the start, the third is far away.
const ELSEWHERE: [f64; 3] = [1.0, -1.0, 16.0];

/// Every row again at points away from the start and its special values: it reads nothing new.
fn check_reads(
    model: &dyn RowsIn<f64>,
    shape: &Shape,
    recorded: &Recorded,
) -> Result<(), ModelError> {
    let mut check = |row: Numbered, reads: &mut Reads| {
        let known = match row {
            Numbered::Definition(k) => recorded.definitions.row(k),
            Numbered::Equation(number) => recorded.rows.row(number),
        };
        let read = match (
            first_unknown(&reads.variables, known.variables),
            first_unknown(&reads.definitions, known.definitions),
        ) {
            (Some(j), _) => shape.variable_name(j),
            (None, Some(d)) => shape.definition_name(d),
            (None, None) => return Ok(()),
        };
        Err(ModelError::ReadsVary { row: row.name(shape), read })
    };
    for factor in ELSEWHERE {
        let moved = |(j, start): (usize, &f64)| {
            start + factor * (2.0 * generic(j) - 1.0) * start.abs().max(1.0)
        };
        let mut z: Vec<f64> = shape.start().iter().enumerate().map(moved).collect();
        shape.bounds().project(&mut z);
        for_each_row(model, shape, &z, &mut check)?;
    }
    Ok(())
}

/// The first of the reads that is not among the known ones, which are sorted.
fn first_unknown(reads: &[usize], known: &[u32]) -> Option<usize> {
    reads.iter().copied().find(|&read| known.binary_search(&small(read)).is_err())
}

fn sort(reads: &mut Vec<usize>) {
    reads.sort_unstable();
    reads.dedup();
}

/// A row by its number among those of its kind.
#[derive(Clone, Copy)]
enum Numbered {
    Definition(usize),
    Equation(usize),
}

impl Numbered {
    fn name(self, shape: &Shape) -> String {
        match self {
            Numbered::Definition(k) => shape.definition_name(k),
            Numbered::Equation(number) => shape.equation_name(shape.variable_of_row(number)),
        }
    }
}

/// Runs all definitions, then all equations at a point, and hands on what each reads.
fn for_each_row(
    model: &dyn RowsIn<f64>,
    shape: &Shape,
    z: &[f64],
    with: &mut dyn FnMut(Numbered, &mut Reads) -> Result<(), ModelError>,
) -> Result<(), ModelError> {
    // A definition has a value once it has been run.
    let mut definitions = vec![f64::NAN; shape.definition_count()];
    let parameters = shape.parameter_values();
    let mut reads = RefCell::new(Reads::default());
    for (k, row) in all_rows(shape.definitions().iter().map(block)).enumerate() {
        let number = Numbered::Definition(k);
        let mut recorder =
            Recorder { point: Point { z, definitions: &definitions, parameters }, reads };
        let run = |r: &Reader<'_, f64>| model.row_in(Kind::Definition, row, r);
        let value = record(shape, &mut recorder, number, run)?;
        reads = recorder.reads;
        definitions[k] = value;
        with(number, reads.get_mut())?;
    }
    let point = Point { z, definitions: &definitions, parameters };
    let mut recorder = Recorder { point, reads };
    for (number, row) in all_rows(shape.equations().map(block)).enumerate() {
        let number = Numbered::Equation(number);
        let run = |r: &Reader<'_, f64>| model.row_in(Kind::Equation, row, r);
        record(shape, &mut recorder, number, run)?;
        with(number, recorder.reads.get_mut())?;
    }
    Ok(())
}

/// Variables that a row depends on, directly or through definitions; sorted.
pub(super) fn support_of(reads: RowReads<'_>, definition_supports: &[Vec<u32>]) -> Vec<u32> {
    let mut support = reads.variables.to_vec();
    for &d in reads.definitions {
        support.extend_from_slice(&definition_supports[d as usize]);
    }
    support.sort_unstable();
    support.dedup();
    support
}

/// Runs one row and gives its value; reads that point nowhere are an error.
fn record(
    shape: &Shape,
    recorder: &mut Recorder<'_>,
    number: Numbered,
    row: impl FnOnce(&Reader<'_, f64>) -> Real<f64>,
) -> Result<f64, ModelError> {
    recorder.reads.get_mut().clear();
    let value = row(&Reader::other(&*recorder)).0;
    let reads = recorder.reads.get_mut();
    let limits = [
        ("variable", &reads.variables, shape.n()),
        ("definition", &reads.definitions, shape.definition_count()),
        ("parameter", &reads.parameters, shape.parameter_values().len()),
    ];
    for (kind, list, count) in limits {
        if let Some(&index) = list.iter().find(|&&read| read >= count) {
            return Err(ModelError::ReadOutOfRange { row: number.name(shape), kind, index, count });
        }
    }
    Ok(value)
}

/// Pattern of a model whose rows come from one function: dependencies traced through the function,
/// 128 variables at a time.
pub(super) fn trace_whole<M: Model>(model: &M, shape: &Shape) -> Pattern {
    let n = shape.n();
    let mut columns = vec![Vec::new(); n];
    let mut f = vec![Real(Trace::constant(0.0)); shape.row_count()];
    let parameters = constants(shape.parameter_values());
    for first in (0..n).step_by(Trace::LANES) {
        let seed = |(j, &z): (usize, &f64)| Real(Trace::seed(z, j.wrapping_sub(first)));
        let z: Vec<Real<Trace>> = shape.start().iter().enumerate().map(seed).collect();
        model.whole(&Reader::lanes(&z, &[], &parameters), &mut f);
        for (row, f) in f.iter().enumerate() {
            let i = shape.variable_of_row(row);
            for j in first..n.min(first + Trace::LANES) {
                if f.into_scalar().depends_on(j - first) {
                    columns[j].push(i);
                }
            }
        }
    }
    Pattern::from_columns(columns)
}

/// Numbers without tangents.
pub(crate) fn constants<D: Scalar>(values: &[f64]) -> Vec<Real<D>> {
    values.iter().map(|&value| Real(D::constant(value))).collect()
}
