//! Reports as CSV and JSON.
//!
//! Every number keeps all its digits. JSON has no infinities: a number that is not finite is the
//! string `"inf"`, `"-inf"` or `"NaN"`, never `null`; `null` means "there is none", as for the
//! marginal of a variable without equation. CSV has the same words, and an empty field for none.

use super::format::{exact, special};
use super::{DerivedRow, Fault, Report, ReportError, SIGN_CONVENTION, Statistics};
use crate::solver::{Direction, Stage, Stats};
use serde::ser::{Serialize, SerializeSeq, Serializer};
use std::fmt;
use std::io::{BufWriter, Write};

/// Columns of the solution table.
const COLUMNS: [&str; 9] =
    ["variable", "lower", "level", "upper", "marginal", "rent", "state", "unit", "equation"];

impl Report {
    /// Writes the whole solution table as CSV: `variable, lower, level, upper, marginal, rent,
    /// state, unit, equation`. Every digit is kept; infinities are `inf` and `-inf`; what there is
    /// not is empty. The state is that of the text: `at lower`, …; after the variables come reports
    /// and definitions, whose state is `report` or `definition`.
    ///
    /// # Errors
    /// [`ReportError::Io`], [`ReportError::Csv`].
    pub fn write_csv(&self, out: impl Write) -> Result<(), ReportError> {
        let mut csv = csv::Writer::from_writer(out);
        csv.write_record(COLUMNS)?;
        let optional = |x: Option<f64>| x.map(exact).unwrap_or_default();
        for row in self.rows() {
            csv.write_record([
                &row.variable,
                &exact(row.lower),
                &exact(row.level),
                &exact(row.upper),
                &optional(row.marginal),
                &optional(row.rent),
                row.state.name(),
                &row.unit,
                row.equation.as_deref().unwrap_or_default(),
            ])?;
        }
        for row in self.derived() {
            let (kind, value) = (row.kind.to_string(), exact(row.value));
            csv.write_record([&row.name, "", &value, "", "", "", &kind, &row.unit, ""])?;
        }
        Ok(csv.flush()?)
    }

    /// Writes everything as one JSON object: `name, parts, sign_convention, method, status, meaning,
    /// advice, natural_residual, worst_equation, relative_residual, worst_relative_equation,
    /// bound_violation, vanishing_equation, diverging_variable, start_was_moved, fault, stats,
    /// statistics, variables, derived`. `parts` are those that are on.
    ///
    /// A number that is not finite is the string `"inf"`, `"-inf"` or `"NaN"`; `null` means that
    /// there is none. States are `at_lower`, `at_upper`, `interior`, `fixed`, `free`, `outside`.
    ///
    /// # Errors
    /// [`ReportError::Io`], [`ReportError::Json`].
    pub fn write_json(&self, out: impl Write) -> Result<(), ReportError> {
        written(self, out)
    }

    fn document(&self) -> Document<'_> {
        let (solution, certificate) = (self.solution(), self.certificate());
        let (natural, relative) = (certificate.natural_residual, certificate.relative_residual);
        let exists = |i: &usize| *i < self.row_count();
        Document {
            name: (!self.name.is_empty()).then_some(&self.name),
            parts: self.shape.parts(),
            sign_convention: SIGN_CONVENTION,
            method: solution.method.name(),
            status: solution.status.name(),
            meaning: solution.status.meaning(),
            advice: solution.status.advice(),
            natural_residual: natural,
            worst_equation: self.worst_equation(natural, certificate.worst),
            relative_residual: relative,
            worst_relative_equation: self
                .worst_equation(relative, certificate.worst_relative)
                .filter(|_| certificate.is_finite),
            bound_violation: certificate.bound_violation,
            vanishing_equation: certificate
                .vanishing_row
                .filter(exists)
                .map(|i| self.shape.equation_name(i)),
            diverging_variable: certificate
                .runaway()
                .filter(exists)
                .map(|j| self.shape.variable_name(j)),
            start_was_moved: solution.start_was_moved,
            fault: self.fault(),
            stats: &solution.stats,
            statistics: self.statistics(),
            variables: Rows(self),
            derived: self.derived().collect(),
        }
    }
}

#[derive(serde::Serialize)]
struct Document<'a> {
    name: Option<&'a String>,
    parts: Vec<&'static str>,
    sign_convention: &'static str,
    method: &'static str,
    status: &'static str,
    meaning: &'static str,
    advice: &'static str,
    #[serde(serialize_with = "number")]
    natural_residual: f64,
    worst_equation: Option<String>,
    #[serde(serialize_with = "number")]
    relative_residual: f64,
    worst_relative_equation: Option<String>,
    #[serde(serialize_with = "number")]
    bound_violation: f64,
    vanishing_equation: Option<String>,
    diverging_variable: Option<String>,
    start_was_moved: bool,
    fault: Option<&'a Fault>,
    stats: &'a Stats,
    statistics: &'a Statistics,
    variables: Rows<'a>,
    derived: Vec<DerivedRow>,
}

/// The rows of a report, made one by one.
struct Rows<'a>(&'a Report);

impl Serialize for Rows<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.rows())
    }
}

/// The object of [`Report::write_json`].
impl Serialize for Report {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.document().serialize(serializer)
    }
}

/// Writes a value as JSON, with a line break at its end.
pub(super) fn written(value: &impl Serialize, out: impl Write) -> Result<(), ReportError> {
    let mut out = BufWriter::new(out);
    serde_json::to_writer_pretty(&mut out, value)?;
    writeln!(out)?;
    Ok(out.flush()?)
}

/// A number, or a word if it is not finite.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "the signature is that of serde")]
pub(super) fn number<S: Serializer>(x: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    if x.is_finite() {
        serializer.serialize_f64(x + 0.0)
    } else {
        serializer.serialize_str(&special(*x))
    }
}

/// A number as the files of this module have it. `Display`: every digit, `inf`, `-inf`, `NaN`, zeros
/// without sign; `Serialize`: a number, or one of these words.
///
/// ```
/// use mcp_core::report::Number;
/// let numbers = [Number(0.1), Number(-0.0), Number(f64::INFINITY)];
/// assert_eq!(serde_json::to_string(&numbers).unwrap(), r#"[0.1,0.0,"inf"]"#);
/// assert_eq!(Number(1e-30).to_string(), "1e-30");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number(pub f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&exact(self.0))
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        number(&self.0, serializer)
    }
}

/// A number or none.
#[expect(clippy::ref_option, reason = "the signature is that of serde")]
pub(super) fn optional_number<S: Serializer>(
    x: &Option<f64>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    x.map(Number).serialize(serializer)
}

/// Names with values, as objects.
pub(super) fn reads<S: Serializer>(
    reads: &[(String, f64)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    #[derive(serde::Serialize)]
    struct Read<'a> {
        variable: &'a str,
        value: Number,
    }
    let mut list = serializer.serialize_seq(Some(reads.len()))?;
    for (variable, value) in reads {
        list.serialize_element(&Read { variable, value: Number(*value) })?;
    }
    list.end()
}

/// The letter of a direction.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "the signature is that of serde")]
pub(super) fn direction_letter<S: Serializer>(
    direction: &Direction,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.serialize_char(direction.letter())
}

/// A stage as its name.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes references")]
pub(super) fn stage_name<S: Serializer>(stage: &Stage, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(stage.name())
}

#[cfg(test)]
#[path = "export_tests.rs"]
mod tests;
