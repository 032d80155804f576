//! [`NlError`]: what is wrong with a file, and where.

use mcp_core::ModelError;
use std::fmt;
use std::io;
use std::path::PathBuf;

/// Where in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Line of a text file, counted from 1.
    Line(usize),
    /// Byte of a binary file, counted from 0.
    Byte(usize),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Line(line) => write!(f, "line {line}"),
            Place::Byte(byte) => write!(f, "byte {byte}"),
        }
    }
}

/// Which part of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Segment {
    /// One of the ten lines of the header, counted from 1.
    Header(usize),
    /// Between two segments, where a letter stands.
    Between,
    /// A segment by its letter and, where it has one, its number: `C3`.
    Body(char, Option<usize>),
}

impl fmt::Display for Segment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Segment::Header(line) => write!(f, "header line {line}"),
            Segment::Between => write!(f, "next segment"),
            Segment::Body(letter, None) => write!(f, "segment {letter}"),
            Segment::Body(letter, Some(number)) => write!(f, "segment {letter}{number}"),
        }
    }
}

/// Why a file is not a mixed complementarity problem that can be solved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum NlError {
    /// The file can not be read.
    #[error("cannot read {}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The file ends early or does not say what the format asks for.
    #[error("{place}, {segment}: expected {expected}, found {found}")]
    Syntax {
        /// Where.
        place: Place,
        /// In which segment.
        segment: Segment,
        /// What the format asks for.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// The file says something that a mixed complementarity problem does not have.
    #[error("{place}, {segment}: {what}")]
    Unsupported {
        /// Where.
        place: Place,
        /// In which segment.
        segment: Segment,
        /// What it is, and what to do about it.
        what: String,
    },
    /// Variables that must be integers.
    #[error(
        "{} must be integral, the first `{variable}`: a complementarity problem has real variables \
         only", counted(*count, "variable")
    )]
    Integer {
        /// How many.
        count: usize,
        /// Name of the first.
        variable: String,
    },
    /// A function to minimise or maximise.
    #[error(
        "{place}, {segment}: the file has an objective, but a complementarity problem has none: \
         write the optimality conditions as `complements`, or in Rust use mcp_core::kkt"
    )]
    Objective {
        /// Where.
        place: Place,
        /// In which segment.
        segment: Segment,
    },
    /// An imported function.
    #[error("{place}, {segment}: the function `{name}` is imported, which is not supported")]
    ImportedFunction {
        /// Where.
        place: Place,
        /// In which segment.
        segment: Segment,
        /// Its name.
        name: String,
    },
    /// An inequality that complements nothing.
    #[error(
        "row `{row}` is an inequality and complements no variable: write \
         `{row}: … complements v >= 0` with its multiplier `v`"
    )]
    Inequality {
        /// Name of the row.
        row: String,
    },
    /// A variable with bounds that no row complements.
    #[error(
        "variable `{variable}` has bounds, [{lower}, {upper}], but no row complements it: \
         equations go with free variables only"
    )]
    BoundedWithoutRow {
        /// Name of the variable.
        variable: String,
        /// Its lower bound.
        lower: f64,
        /// Its upper bound.
        upper: f64,
    },
    /// Numbers of equations and of the free variables left for them differ.
    #[error(
        "the system is not square: {} for {} that no row complements{}",
        counted(*equations, "equation"), counted(*variables, "free variable"), excess(.first)
    )]
    NotSquare {
        /// Rows with `=` that complement no variable.
        equations: usize,
        /// Free variables that no row complements.
        variables: usize,
        /// Name of the first row or variable left over.
        first: String,
    },
    /// Two rows complement one variable.
    #[error("variable `{variable}` is complemented by both `{first}` and `{second}`")]
    ComplementedTwice {
        /// Name of the variable.
        variable: String,
        /// The row that comes first.
        first: String,
        /// The other.
        second: String,
    },
    /// A row says which bounds of its variable are finite, and the bounds say otherwise.
    #[error(
        "row `{row}` complements `{variable}` with {said}, but its bounds are [{lower}, {upper}]: \
         make bounds and condition the same, for example `l <= {variable} <= u complements …`"
    )]
    BoundsOfPair {
        /// Name of the row.
        row: String,
        /// Name of the variable.
        variable: String,
        /// Which bounds the row says are finite.
        said: &'static str,
        /// The lower bound.
        lower: f64,
        /// The upper bound.
        upper: f64,
    },
    /// Bounds or starts that no model may have.
    #[error(transparent)]
    Model(#[from] ModelError),
}

fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

fn excess(first: &str) -> String {
    if first.is_empty() { String::new() } else { format!("; `{first}` is the first without one") }
}
