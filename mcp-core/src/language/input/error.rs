//! [`DataError`]: data that do not fit the sets and tables a model declares.

use crate::error::did_you_mean;
use std::fmt;

/// What is wrong with the data of a model, and where. Every message names the offender.
///
/// `place` is the file and line; data from the program have none.
#[derive(Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DataError {
    /// A field of the data was not given.
    #[error("`{name}` is not given: call `.{name}(…)` before `.build()`")]
    NotGiven {
        /// The field.
        name: String,
    },
    /// A `fix` names a combination of indices for which the variable has no element.
    #[error("`fix {name}` names an element that does not exist: its condition does not hold")]
    FixedAbsent {
        /// The variable.
        name: String,
    },
    /// A part adds terms to rows of which the target has none.
    #[error("the part `{part}` adds to `{target}`{}", no_rows(.sets))]
    AddedToAbsent {
        /// The part.
        part: String,
        /// The equation or definition.
        target: String,
        /// The index sets that the part runs over; none where it names one row.
        sets: Vec<String>,
    },
    /// A set has no elements.
    #[error("{}set `{set}` is empty: give at least one label", at(.place.as_deref()))]
    EmptySet {
        /// The set.
        set: String,
        /// The file.
        place: Option<Box<Place>>,
    },
    /// A label is the empty text.
    #[error("{}label {number} of `{set}` is empty", at(.place.as_deref()))]
    EmptyLabel {
        /// The set.
        set: String,
        /// Which label, counted from 1.
        number: usize,
        /// File and line.
        place: Option<Box<Place>>,
    },
    /// A label is given twice.
    #[error("{}`{set}` has the label `{label}` twice", at(.place.as_deref()))]
    DuplicateLabel {
        /// The set, subset or pairs.
        set: String,
        /// The label.
        label: String,
        /// File and line of the second.
        place: Option<Box<Place>>,
    },
    /// A label that the set does not have.
    #[error(
        "{}`{data}` names `{label}`, which is no label of `{set}`{}",
        at(.place.as_deref()), did_you_mean(.nearest.as_deref())
    )]
    UnknownLabel {
        /// The table, map, subset or pairs.
        data: String,
        /// The set.
        set: String,
        /// The label.
        label: String,
        /// The nearest label of the set, if one is near.
        nearest: Option<String>,
        /// File and line.
        place: Option<Box<Place>>,
    },
    /// Elements without a value.
    #[error("{}`{key}` has no value (missing: {missing} of {expected})", at(.place.as_deref()))]
    Missing {
        /// The first of them, such as `cost[seattle, topeka]`.
        key: String,
        /// How many there are.
        missing: usize,
        /// How many values there should be.
        expected: usize,
        /// The file.
        place: Option<Box<Place>>,
    },
    /// An element has two values.
    #[error("{}`{key}` is given twice{}", at(.place.as_deref()), first_line(*.first))]
    DuplicateKey {
        /// The element, such as `cost[seattle, topeka]`.
        key: String,
        /// Line of the first value in the file.
        first: Option<u64>,
        /// File and line of the second.
        place: Option<Box<Place>>,
    },
    /// A key has more or fewer labels than the table has index sets.
    #[error("the key `{key}` does not fit `{form}`")]
    KeyLength {
        /// The key with the labels given.
        key: String,
        /// The table with its index sets.
        form: String,
    },
    /// A value is NaN.
    #[error("{}`{key}` is NaN: give a number", at(.place.as_deref()))]
    Nan {
        /// The element, such as `cost[seattle, topeka]`.
        key: String,
        /// File and line.
        place: Option<Box<Place>>,
    },
    /// A list of numbers has another shape than the index sets.
    #[error("`{form}` has the wrong shape: expected {expected}, found {found}")]
    Shape {
        /// The table with its index sets.
        form: String,
        /// Such as `2 x 3`.
        expected: String,
        /// Such as `2 x 2`.
        found: String,
    },
    /// One row of a nested list has the wrong length.
    #[error("`{key}` has the wrong length: expected {expected}, found {found}")]
    RowLength {
        /// The row, such as `cost[seattle]`.
        key: String,
        /// Numbers it should have.
        expected: usize,
        /// Numbers it has.
        found: usize,
    },
    /// A table without index sets has none or several numbers.
    #[error("{}`{table}` has no index sets: give one number, not {found}", at(.place.as_deref()))]
    NotOneNumber {
        /// The table.
        table: String,
        /// How many numbers were given.
        found: usize,
        /// The file.
        place: Option<Box<Place>>,
    },
    /// A set or a table has more than 2³¹ elements.
    #[error("`{form}` has more than 2^31 elements")]
    TooManyElements {
        /// The set, or the table with its index sets.
        form: String,
    },
    /// The header of a file has another number of columns than the data need.
    #[error("{place}: `{data}` needs the columns {expected}; found {found}")]
    Columns {
        /// The table, map or pairs.
        data: String,
        /// The columns there should be.
        expected: String,
        /// How many there are.
        found: usize,
        /// File and line.
        place: Place,
    },
    /// A row of a file is longer or shorter than its header.
    #[error("{place}: expected {expected} columns as in the header, found {found}")]
    RowColumns {
        /// Columns of the header.
        expected: usize,
        /// Columns of the row.
        found: usize,
        /// File and line.
        place: Place,
    },
    /// Two columns have the same label.
    #[error("{place}: there are two columns `{column}`")]
    DuplicateColumn {
        /// The label.
        column: String,
        /// File and line.
        place: Place,
    },
    /// No column of numbers has this header.
    #[error(
        "{place}: there is no column `{column}`{}", did_you_mean(.nearest.as_deref())
    )]
    NoColumn {
        /// The header asked for.
        column: String,
        /// The nearest header.
        nearest: Option<String>,
        /// File and line.
        place: Place,
    },
    /// A cell is not a number.
    #[error("{place}, column `{column}`: `{text}` is not a number")]
    NotANumber {
        /// Header of the column.
        column: String,
        /// What stands there.
        text: String,
        /// File and line.
        place: Place,
    },
    /// A file has no header line.
    #[error("{file} has no header line")]
    EmptyFile {
        /// The file.
        file: String,
    },
    /// A file is not there, or is not a text.
    #[error("`{data}` cannot be read from {file}: {reason}")]
    Unreadable {
        /// What it was to give.
        data: String,
        /// The file.
        file: String,
        /// What the system says.
        reason: String,
    },
}

/// As [`Display`](fmt::Display): what `main` prints of an error it returns.
impl fmt::Debug for DataError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// A line of a file, or the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file as it was named.
    pub file: String,
    /// The line, counted from 1; `None` for the whole file.
    pub line: Option<u64>,
}

impl Place {
    /// A place in a file, none without a file.
    pub(super) fn of(file: Option<&str>, line: Option<u64>) -> Option<Box<Self>> {
        file.map(|file| Box::new(Place { file: file.to_owned(), line }))
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.file)?;
        self.line.map_or(Ok(()), |line| write!(f, ", line {line}"))
    }
}

fn at(place: Option<&Place>) -> String {
    place.map(|place| format!("{place}: ")).unwrap_or_default()
}

fn first_line(first: Option<u64>) -> String {
    first.map(|line| format!(", first in line {line}")).unwrap_or_default()
}

fn no_rows(sets: &[String]) -> String {
    if sets.is_empty() {
        return ", which has no row there: its condition does not hold".to_owned();
    }
    format!(
        " over `{}`, where it has no row: its condition holds for none of them",
        sets.join("`, `")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ModelError;

    #[test]
    fn a_model_error_repeats_the_sentence() {
        let error = DataError::EmptySet { set: "plants".to_owned(), place: None };
        assert_eq!(ModelError::from(error.clone()).to_string(), error.to_string());
    }

    #[test]
    fn a_place_is_a_file_with_or_without_a_line() {
        let place = |line| Place { file: "cost.csv".to_owned(), line }.to_string();
        assert_eq!(place(None), "cost.csv");
        assert_eq!(place(Some(3)), "cost.csv, line 3");
    }
}
