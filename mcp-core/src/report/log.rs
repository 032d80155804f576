//! [`IterationLog`]: the iterations of a solve, kept.

use crate::solver::{Direction, Iteration, Monitor, Stage};
use std::ops::ControlFlow;

#[cfg(feature = "serde")]
use super::{
    ReportError,
    export::{direction_letter, number, stage_name, written},
    format::exact,
};
#[cfg(feature = "serde")]
use std::io::Write;

/// One iterate of a solve: a line of [`IterationTable`](super::IterationTable).
///
/// In files the fields are called as the columns of the table: `iter`, `func`, `jac`, `residual`,
/// `natural`, `step`, `type`, `stage`, `act`, `worst`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct IterationRecord {
    /// Number of the iterate; 0 is the start.
    pub iter: usize,
    /// Evaluations of `F` alone so far.
    pub func: usize,
    /// Evaluations of `J` so far.
    pub jac: usize,
    /// `‖Φ(z)‖₂`, the 2-norm of the Fischer–Burmeister vector.
    #[cfg_attr(feature = "serde", serde(serialize_with = "number"))]
    pub residual: f64,
    /// Natural residual `max |mid(z−l, F, z−u)|`, in the units of the model.
    #[cfg_attr(feature = "serde", serde(serialize_with = "number"))]
    pub natural: f64,
    /// Step length; 0 for the start.
    #[cfg_attr(feature = "serde", serde(serialize_with = "number"))]
    pub step: f64,
    /// Where the step came from; in files its letter, as `type`.
    #[cfg_attr(feature = "serde", serde(rename = "type", serialize_with = "direction_letter"))]
    pub direction: Direction,
    /// The stage it belongs to; `newton` for the classical methods.
    #[cfg_attr(feature = "serde", serde(serialize_with = "stage_name"))]
    pub stage: Stage,
    /// Variables taken to be at a bound; in files `act`.
    #[cfg_attr(feature = "serde", serde(rename = "act"))]
    pub active: usize,
    /// Equation of the largest natural residual.
    pub worst: String,
}

impl IterationRecord {
    /// Column names, in the order of the table.
    pub const COLUMNS: [&'static str; 10] =
        ["iter", "func", "jac", "residual", "natural", "step", "type", "stage", "act", "worst"];

    /// What an iteration says, by name.
    pub fn new(iteration: &Iteration<'_>) -> Self {
        let shape = iteration.problem.shape();
        let named = iteration.worst < shape.n();
        IterationRecord {
            iter: iteration.k,
            func: iteration.residual_evaluations,
            jac: iteration.jacobian_evaluations,
            residual: iteration.fb_norm,
            natural: iteration.natural_residual,
            step: iteration.step,
            direction: iteration.direction,
            stage: iteration.stage,
            active: iteration.active,
            worst: if named { shape.equation_name(iteration.worst) } else { String::new() },
        }
    }
}

/// A [`Monitor`] that keeps one [`IterationRecord`] for each iterate, the start and the last one
/// included.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct IterationLog {
    records: Vec<IterationRecord>,
}

impl IterationLog {
    /// An empty log.
    pub fn new() -> Self {
        Self::default()
    }

    /// All records, in order.
    pub fn records(&self) -> &[IterationRecord] {
        &self.records
    }

    /// Writes all records as CSV with [`IterationRecord::COLUMNS`] as header; numbers with every
    /// digit.
    ///
    /// # Errors
    /// [`ReportError::Io`], [`ReportError::Csv`].
    #[cfg(feature = "serde")]
    pub fn write_csv(&self, out: impl Write) -> Result<(), ReportError> {
        let mut csv = csv::Writer::from_writer(out);
        csv.write_record(IterationRecord::COLUMNS)?;
        for record in &self.records {
            csv.write_record([
                record.iter.to_string(),
                record.func.to_string(),
                record.jac.to_string(),
                exact(record.residual),
                exact(record.natural),
                exact(record.step),
                record.direction.letter().to_string(),
                record.stage.name().to_owned(),
                record.active.to_string(),
                record.worst.clone(),
            ])?;
        }
        Ok(csv.flush()?)
    }

    /// Writes all records as a JSON array of objects; a number that is not finite is the string
    /// `"inf"`, `"-inf"` or `"NaN"`.
    ///
    /// # Errors
    /// [`ReportError::Io`], [`ReportError::Json`].
    #[cfg(feature = "serde")]
    pub fn write_json(&self, out: impl Write) -> Result<(), ReportError> {
        written(&self.records, out)
    }
}

impl Monitor for IterationLog {
    fn iteration(&mut self, iteration: &Iteration<'_>) -> ControlFlow<()> {
        self.records.push(IterationRecord::new(iteration));
        ControlFlow::Continue(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::cubic;
    use super::*;
    use crate::solver::{Options, Solver};

    fn logged() -> IterationLog {
        let mut log = IterationLog::new();
        let mut solver = Solver::new(Options::default()).unwrap();
        solver.solve_monitored(&mut cubic("a, \"b\""), None, &mut log).unwrap();
        log
    }

    #[test]
    fn a_log_has_the_start_and_every_iterate_after_it() {
        let log = logged();
        assert_eq!(log.records()[0].direction, Direction::Start);
        assert!(log.records().len() > 1);
        assert!(log.records().iter().enumerate().all(|(k, record)| record.iter == k));
    }

    #[cfg(feature = "serde")]
    #[test]
    fn csv_and_json_have_the_same_columns_and_read_back() {
        let log = logged();
        let (mut csv_text, mut json_text) = (Vec::new(), Vec::new());
        log.write_csv(&mut csv_text).unwrap();
        log.write_json(&mut json_text).unwrap();

        let mut reader = csv::Reader::from_reader(&csv_text[..]);
        assert_eq!(reader.headers().unwrap(), &IterationRecord::COLUMNS[..]);
        let json: Vec<serde_json::Value> = serde_json::from_slice(&json_text).unwrap();
        for ((row, object), record) in reader.records().zip(&json).zip(log.records()) {
            let row = row.unwrap();
            assert_eq!(row[3].parse::<f64>().unwrap().to_bits(), record.residual.to_bits());
            assert_eq!(&row[6], object["type"].as_str().unwrap());
            assert_eq!(&row[7], object["stage"].as_str().unwrap());
            assert_eq!(&row[9], "f[a, \"b\"]");
            assert_eq!(object["worst"], "f[a, \"b\"]");
            let keys = object.as_object().unwrap();
            assert!(IterationRecord::COLUMNS.iter().all(|column| keys.contains_key(*column)));
            assert_eq!(keys.len(), IterationRecord::COLUMNS.len());
        }
        // Digit by digit: the parser of serde_json may be off by one unit in the last place.
        let text = String::from_utf8(json_text).unwrap();
        let lines = text.lines().filter_map(|line| line.trim().strip_prefix("\"residual\": "));
        let residuals: Vec<f64> =
            lines.map(|line| line.trim_end_matches(',').parse().unwrap()).collect();
        assert!(log.records().iter().map(|record| record.residual).eq(residuals));
    }
}
