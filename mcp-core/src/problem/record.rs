//! Which variables, definitions and parameters every row reads.

use super::Pattern;
use super::rows::{Kind, RowsIn};
use crate::error::ModelError;
use crate::model::{Model, Point, Reader, Reads, Recorder, Row, Shape};
use crate::scalar::{Real, Scalar, Trace};
use std::cell::RefCell;

/// What one row reads, sorted and without repetitions.
#[derive(Clone, Debug, Default)]
pub(super) struct RowReads {
    pub(super) variables: Vec<usize>,
    pub(super) definitions: Vec<usize>,
}

/// What all rows of a model read.
#[derive(Debug)]
pub(super) struct Recorded {
    /// In the order of the rows.
    pub(super) rows: Vec<RowReads>,
    /// In the order of the definitions.
    pub(super) definitions: Vec<RowReads>,
    /// Variables that every definition depends on, directly or through earlier definitions.
    pub(super) definition_supports: Vec<Vec<usize>>,
}

/// Rows of a kind in the order of their numbers.
pub(super) fn all_rows(lengths: impl Iterator<Item = usize>) -> Vec<Row> {
    lengths
        .enumerate()
        .flat_map(|(family, len)| (0..len).map(move |index| Row { family, index }))
        .collect()
}

/// Runs every row once at the start of the model and notes what it reads. The values do not matter:
/// models cannot branch on them.
pub(super) fn record_rows(model: &dyn RowsIn<f64>, shape: &Shape) -> Result<Recorded, ModelError> {
    let unknown = vec![f64::NAN; shape.definition_count()];
    let point =
        Point { z: shape.start(), definitions: &unknown, parameters: shape.parameter_values() };
    let mut definitions: Vec<RowReads> = Vec::new();
    for (k, &row) in all_rows(shape.definitions().iter().map(crate::Family::len)).iter().enumerate()
    {
        let name = || shape.definition_name(k);
        let reads = record(shape, point, &name, |r| model.row_in(Kind::Definition, row, r))?;
        if let Some(&later) = reads.definitions.iter().find(|&&d| d >= k) {
            let (definition, later) = (name(), shape.definition_name(later));
            return Err(ModelError::DefinitionOrder { definition, later });
        }
        definitions.push(reads);
    }
    let mut rows = Vec::new();
    for (number, &row) in all_rows(shape.equations().map(crate::Family::len)).iter().enumerate() {
        let name = || shape.equation_name(shape.variable_of_row(number));
        rows.push(record(shape, point, &name, |r| model.row_in(Kind::Equation, row, r))?);
    }
    let mut definition_supports: Vec<Vec<usize>> = Vec::new();
    for reads in &definitions {
        let support = support_of(reads, &definition_supports);
        definition_supports.push(support);
    }
    Ok(Recorded { rows, definitions, definition_supports })
}

/// Variables that a row depends on, directly or through definitions; sorted.
pub(super) fn support_of(reads: &RowReads, definition_supports: &[Vec<usize>]) -> Vec<usize> {
    let mut support = reads.variables.clone();
    for &d in &reads.definitions {
        support.extend_from_slice(&definition_supports[d]);
    }
    support.sort_unstable();
    support.dedup();
    support
}

/// Runs one row; reads that point nowhere are an error.
fn record(
    shape: &Shape,
    point: Point<'_>,
    name: &dyn Fn() -> String,
    row: impl FnOnce(&Reader<'_, f64>) -> Real<f64>,
) -> Result<RowReads, ModelError> {
    let recorder = Recorder { point, reads: RefCell::new(Reads::default()) };
    let _ = row(&Reader::other(&recorder));
    let Reads { mut variables, mut definitions, mut parameters } = recorder.reads.into_inner();
    let limits = [
        ("variable", &mut variables, shape.n()),
        ("definition", &mut definitions, shape.definition_count()),
        ("parameter", &mut parameters, shape.parameter_values().len()),
    ];
    for (kind, list, count) in limits {
        list.sort_unstable();
        list.dedup();
        if let Some(&index) = list.last().filter(|&&last| last >= count) {
            return Err(ModelError::ReadOutOfRange { row: name(), kind, index, count });
        }
    }
    Ok(RowReads { variables, definitions })
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
