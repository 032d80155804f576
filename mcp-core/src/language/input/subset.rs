//! [`LabelSubset`]: what a user may give for a subset.

use super::DataError;
use super::cells::{Cells, Columns};
#[cfg(feature = "serde")]
use super::csv_source::CsvSource;
use super::positions::Positions;
use crate::Set;
#[cfg(feature = "serde")]
use std::path::Path;

/// The labels of a subset in any order: a list or the first column of a file. It may be empty.
///
/// ```
/// use mcp_core::Set;
/// use mcp_core::language::input::LabelSubset;
///
/// let gens = Set::new("gens", ["coal", "wind", "gas"])?;
/// assert_eq!(LabelSubset::from(["gas", "coal"]).resolve("thermal", &gens)?, [0, 2]);
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LabelSubset(Cells);

impl LabelSubset {
    /// The first column of a CSV file below its header line.
    #[cfg(feature = "serde")]
    pub fn csv(path: impl AsRef<Path>) -> Self {
        LabelSubset(Cells::Csv(CsvSource::file(path)))
    }

    /// The first column of a CSV text below its header line; messages call the text `name`.
    #[cfg(feature = "serde")]
    pub fn csv_text(name: impl Into<String>, text: impl Into<String>) -> Self {
        LabelSubset(Cells::Csv(CsvSource::text(name, text)))
    }

    /// Positions of the labels in `of`, in the order of `of`.
    ///
    /// # Errors
    /// [`DataError::UnknownLabel`], [`DataError::DuplicateLabel`], [`DataError::EmptyLabel`], and
    /// what may be wrong with a file.
    pub fn resolve(&self, subset: &str, of: &Set) -> Result<Vec<usize>, DataError> {
        let rows = self.0.rows(subset, &Columns::FIRST)?;
        let labels = rows.labels(subset, |row| row.cells[0].clone())?;
        let positions = Positions::new(of);
        let mut found = labels
            .iter()
            .zip(&rows.rows)
            .map(|(label, row)| positions.find(subset, label, rows.file(), row.line))
            .collect::<Result<Vec<_>, _>>()?;
        found.sort_unstable();
        Ok(found)
    }
}

impl Default for LabelSubset {
    /// The empty subset.
    fn default() -> Self {
        LabelSubset(Cells::Given(Vec::new()))
    }
}

impl<const N: usize> From<[&str; N]> for LabelSubset {
    fn from(labels: [&str; N]) -> Self {
        LabelSubset(Cells::list(labels))
    }
}

impl From<Vec<&str>> for LabelSubset {
    fn from(labels: Vec<&str>) -> Self {
        LabelSubset(Cells::list(labels))
    }
}

impl From<Vec<String>> for LabelSubset {
    fn from(labels: Vec<String>) -> Self {
        LabelSubset(Cells::list(labels))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn resolve(subset: impl Into<LabelSubset>) -> Result<Vec<usize>, String> {
        let gens = Set::new("gens", ["coal", "wind", "gas"]).unwrap();
        subset.into().resolve("thermal", &gens).map_err(|error| error.to_string())
    }

    #[test]
    fn positions_come_in_the_order_of_the_set() {
        for subset in [["coal", "gas"], ["gas", "coal"]] {
            assert_eq!(resolve(subset), Ok(vec![0, 2]));
            assert_eq!(resolve(subset.to_vec()), Ok(vec![0, 2]));
            assert_eq!(resolve(subset.map(str::to_owned).to_vec()), Ok(vec![0, 2]));
        }
    }

    #[test]
    fn a_subset_may_be_empty() {
        assert_eq!(resolve([]), Ok(vec![]));
        assert_eq!(resolve(LabelSubset::default()), Ok(vec![]));
    }

    #[test]
    fn labels_must_differ_and_be_labels_of_the_set() {
        let twice = "`thermal` has the label `gas` twice";
        assert_eq!(resolve(["gas", "gas"]).unwrap_err(), twice);
        let unknown = "`thermal` names `goal`, which is no label of `gens`; did you mean `coal`?";
        assert_eq!(resolve(["goal"]).unwrap_err(), unknown);
    }

    #[cfg(feature = "serde")]
    #[test]
    fn a_file_gives_its_first_column() {
        let csv = |text| resolve(LabelSubset::csv_text("thermal.csv", text));
        assert_eq!(csv("gen,note\ngas,new\ncoal,\n"), Ok(vec![0, 2]));
        assert_eq!(csv("gen\n"), Ok(vec![]));
        let unknown = "thermal.csv, line 2: `thermal` names `oil`, which is no label of `gens`";
        assert_eq!(csv("gen\noil\n").unwrap_err(), unknown);
        let file = resolve(LabelSubset::csv("no/such.csv")).unwrap_err();
        assert!(file.starts_with("`thermal` cannot be read from no/such.csv: "), "{file}");
    }
}
