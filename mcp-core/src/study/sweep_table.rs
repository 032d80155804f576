//! [`SweepTable`]: chosen numbers of a sweep, as text, CSV and picture.

use super::Sweep;
use super::compare::percent;
use crate::error::ModelError;
use crate::report::format::{Align, Grid, number};
use crate::solver::Status;
use std::fmt;

/// Names of variables that a line shows before it only counts.
const NAMES: usize = 3;

/// Chosen numbers at every point of a sweep.
///
/// `Display` is a table with one line for each point, with iterations and with the variables that came
/// to a bound or left one. Numbers of points that are no solutions are left out, the status is shown.
#[derive(Clone, Debug)]
pub struct SweepTable {
    /// Name of the parameter.
    pub parameter: String,
    /// What is known of each point.
    pub points: Vec<SweepLine>,
    /// The chosen numbers.
    pub columns: Vec<SweepColumn>,
    pub(super) is_percent: bool,
}

/// What a table knows of a point.
#[derive(Clone, Debug)]
pub struct SweepLine {
    /// Value of the parameter.
    pub value: f64,
    /// How the solve ended.
    pub status: Status,
    /// Iterations of the solve.
    pub iterations: usize,
    /// Variables that came to a bound or left one, each with its state.
    pub changes: Vec<String>,
}

/// One number at every point.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepColumn {
    /// Its name, such as `p[iron]`.
    pub name: String,
    /// Its unit, possibly empty; `%` in a table of percentages.
    pub unit: String,
    /// One value for each point; NaN where there is no solution.
    pub values: Vec<f64>,
}

impl SweepTable {
    pub(super) fn new(sweep: &Sweep, names: &[&str]) -> Result<Self, ModelError> {
        let mut columns = Vec::new();
        if let Some(first) = sweep.points.first() {
            let shape = &first.solution.shape;
            for name in names {
                for quantity in shape.quantities(name)? {
                    let values = sweep.points.iter().map(|point| {
                        let value = quantity.value(&point.solution.z, &point.derived);
                        value.filter(|_| point.solution.is_solved()).unwrap_or(f64::NAN)
                    });
                    let unit = quantity.family(shape).0.unit().to_owned();
                    let (name, values) = (quantity.name(shape), values.collect());
                    columns.push(SweepColumn { name, unit, values });
                }
            }
        }
        let line = |point: &super::SweepPoint| SweepLine {
            value: point.value,
            status: point.solution.status,
            iterations: point.solution.stats.iterations,
            changes: point.changes.iter().map(ToString::to_string).collect(),
        };
        let points = sweep.points.iter().map(line).collect();
        Ok(SweepTable { parameter: sweep.parameter.clone(), points, columns, is_percent: false })
    }

    /// The same as changes in percent of the first solution. A number that is 0 there has no
    /// percentage: NaN.
    #[must_use]
    pub fn in_percent(mut self) -> Self {
        for column in &mut self.columns {
            let first = column.values.iter().copied().find(|value| !value.is_nan());
            let first = first.filter(|&first| first != 0.0).unwrap_or(f64::NAN);
            for value in &mut column.values {
                *value = 100.0 * (*value - first) / first.abs();
            }
            "%".clone_into(&mut column.unit);
        }
        self.is_percent = true;
        self
    }

    /// Writes the table as CSV: the parameter, `status`, `iterations`, `changes` with names separated
    /// by semicolons, and one column for each number, with every digit.
    ///
    /// # Errors
    /// [`ReportError`](crate::ReportError) of the writer.
    #[cfg(feature = "serde")]
    pub fn write_csv(&self, out: impl std::io::Write) -> Result<(), crate::ReportError> {
        use crate::report::format::exact;
        let mut csv = csv::Writer::from_writer(out);
        let heads = [self.parameter.as_str(), "status", "iterations", "changes"];
        let names = self.columns.iter().map(|column| column.name.as_str());
        csv.write_record(heads.into_iter().chain(names))?;
        for (k, point) in self.points.iter().enumerate() {
            let iterations = point.iterations.to_string();
            let heads = [
                exact(point.value),
                point.status.name().to_owned(),
                iterations,
                point.changes.join("; "),
            ];
            let values = self.columns.iter().map(|column| exact(column.values[k]));
            csv.write_record(heads.into_iter().chain(values))?;
        }
        Ok(csv.flush()?)
    }
}

impl fmt::Display for SweepTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let all_solved = self.points.iter().all(|point| point.status == Status::Solved);
        let heads = self.columns.iter().map(|column| match column.unit.as_str() {
            "" => column.name.clone(),
            unit => format!("{} [{unit}]", column.name),
        });
        let heads: Vec<String> = heads.collect();
        let columns = [(self.parameter.as_str(), Align::Point, true)]
            .into_iter()
            .chain(heads.iter().map(|head| (head.as_str(), Align::Point, true)))
            .chain([
                ("iterations", Align::Right, true),
                ("status", Align::Left, !all_solved),
                ("now", Align::Left, true),
            ]);
        let mut grid = Grid::with_shown(columns);
        for (k, point) in self.points.iter().enumerate() {
            let shown = |value: f64| match value {
                value if value.is_nan() => String::new(),
                value if self.is_percent => percent(value),
                value => number(value),
            };
            let values = self.columns.iter().map(|column| shown(column.values[k]));
            let more = point.changes.len().saturating_sub(NAMES);
            let mut changes = point.changes[..point.changes.len() - more].join(", ");
            if more > 0 {
                changes = format!("{changes} and {more} more");
            }
            let tail = [point.iterations.to_string(), point.status.name().to_owned(), changes];
            grid.row([number(point.value)].into_iter().chain(values).chain(tail));
        }
        grid.fmt(f)
    }
}
