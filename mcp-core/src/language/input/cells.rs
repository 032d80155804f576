//! [`Cells`]: rows of labels, given in the program or in a file.

#[cfg(feature = "serde")]
use super::csv_source::CsvSource;
use super::{DataError, Place};
use std::collections::HashSet;
use std::ops::RangeInclusive;

/// Rows of labels as a user gives them.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Cells {
    Given(Vec<Vec<String>>),
    #[cfg(feature = "serde")]
    Csv(CsvSource),
}

/// Rows of labels, and where they come from.
pub(super) struct Rows {
    pub(super) file: Option<String>,
    pub(super) rows: Vec<Row>,
}

/// A row of labels and its line in the file.
pub(super) struct Row {
    pub(super) line: Option<u64>,
    pub(super) cells: Vec<String>,
}

/// How many columns a file may have, and what they are.
#[cfg_attr(not(feature = "serde"), expect(dead_code, reason = "only files have columns"))]
pub(super) struct Columns {
    pub(super) number: RangeInclusive<usize>,
    pub(super) names: &'static str,
}

impl Columns {
    /// The first column counts, further ones are ignored.
    pub(super) const FIRST: Columns = Columns { number: 1..=usize::MAX, names: "label" };
}

impl Cells {
    /// One label in each row.
    pub(super) fn list<L: Into<String>>(labels: impl IntoIterator<Item = L>) -> Self {
        Cells::Given(labels.into_iter().map(|label| vec![label.into()]).collect())
    }

    /// All rows, with as many columns as `data` need.
    #[cfg_attr(
        not(feature = "serde"),
        expect(unused_variables, clippy::unnecessary_wraps, reason = "only a file can fail")
    )]
    pub(super) fn rows(&self, data: &str, columns: &Columns) -> Result<Rows, DataError> {
        match self {
            Cells::Given(rows) => {
                let rows = rows.iter().cloned().map(|cells| Row { line: None, cells });
                Ok(Rows { file: None, rows: rows.collect() })
            }
            #[cfg(feature = "serde")]
            Cells::Csv(source) => source.sheet(data)?.into_rows(data, columns),
        }
    }
}

impl Rows {
    pub(super) fn file(&self) -> Option<&str> {
        self.file.as_deref()
    }

    pub(super) fn place(&self, row: &Row) -> Option<Box<Place>> {
        Place::of(self.file(), row.line)
    }

    /// The labels of a set, one made of each row, none of them empty or there twice.
    pub(super) fn labels(
        &self,
        set: &str,
        label: impl Fn(&Row) -> String,
    ) -> Result<Vec<String>, DataError> {
        let labels: Vec<String> = self.rows.iter().map(label).collect();
        let mut seen = HashSet::with_capacity(labels.len());
        for (i, (label, row)) in labels.iter().zip(&self.rows).enumerate() {
            let set = || set.to_owned();
            if label.trim().is_empty() {
                let (number, place) = (i + 1, self.place(row));
                return Err(DataError::EmptyLabel { set: set(), number, place });
            }
            if !seen.insert(label.as_str()) {
                let (label, place) = (label.clone(), self.place(row));
                return Err(DataError::DuplicateLabel { set: set(), label, place });
            }
        }
        Ok(labels)
    }
}
