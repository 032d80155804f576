//! What people and programs read: the model before a solve, its iterations, its outcome.
//!
//! | type | says | as |
//! | --- | --- | --- |
//! | [`Statement`] | what the model is and how its Jacobian looks at the start | text, serde |
//! | [`IterationTable`] | one line for each iterate, PATH's columns | text, while solving |
//! | [`IterationLog`] | the same, kept | CSV, JSON |
//! | [`Report`] | status, residuals, [`Statistics`], solution table, reports and definitions | text, CSV, JSON |
//!
//! Everything is named by variable and equation, and everything is written to a
//! [`Write`](std::io::Write) or [`Display`](std::fmt::Display) of the caller's choice; nothing is
//! printed. CSV and JSON need the feature `serde`.
//!
//! # Numbers
//!
//! Text shows six significant digits, exact zeros as `0`, infinities as `inf`. Rounding is
//! monotone, so a level inside its bounds is never shown outside them. Files hold every digit. A
//! negative zero is written as zero everywhere.

mod derived;
#[cfg(feature = "serde")]
mod export;
pub(crate) mod format;
mod log;
mod matrix;
mod norms;
mod outcome;
mod rows;
mod statement;
mod statement_text;
mod statistics;
mod table;
mod text;

#[cfg(test)]
mod samples;

pub use derived::{DerivedKind, DerivedRow};
#[cfg(feature = "serde")]
pub use export::Number;
pub use log::{IterationLog, IterationRecord};
pub use outcome::{Fault, Report};
pub use rows::{ReportRow, State};
pub use statement::{
    ColumnNorm, Examples, FamilyStatement, Kinds, PairStatement, RowNorm, Statement,
};
pub use statistics::{Measure, Statistics};
pub use table::IterationTable;

use crate::error::ModelError;
use std::io;

/// The sign convention, as it stands in every report: that of PATH, GAMS and JuMP.
pub const SIGN_CONVENTION: &str =
    "at a lower bound F >= 0, at an upper bound F <= 0, in between F = 0";

/// Why a report could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The writer failed.
    #[error("the report could not be written: {0}")]
    Io(#[from] io::Error),
    /// A family was asked for that does not exist.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A table with row and column labels was asked of a family without two index sets.
    #[error("`{family}` has {indices} index sets; a table of rows and columns needs 2")]
    NotTwoDimensional {
        /// The family.
        family: String,
        /// Number of its index sets.
        indices: usize,
    },
    /// The CSV encoder failed for another reason than its writer.
    #[cfg(feature = "serde")]
    #[error("the table could not be written as CSV: {0}")]
    Csv(csv::Error),
    /// The JSON encoder failed for another reason than its writer.
    #[cfg(feature = "serde")]
    #[error("the report could not be written as JSON: {0}")]
    Json(serde_json::Error),
}

#[cfg(feature = "serde")]
impl From<csv::Error> for ReportError {
    fn from(error: csv::Error) -> Self {
        if error.is_io_error() { ReportError::Io(error.into()) } else { ReportError::Csv(error) }
    }
}

#[cfg(feature = "serde")]
impl From<serde_json::Error> for ReportError {
    fn from(error: serde_json::Error) -> Self {
        if error.is_io() { ReportError::Io(error.into()) } else { ReportError::Json(error) }
    }
}
