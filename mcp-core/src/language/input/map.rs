//! [`LabelMap`]: what a user may give for a map between sets.

use super::cells::{Cells, Columns, Row, Rows};
#[cfg(feature = "serde")]
use super::csv_source::CsvSource;
use super::positions::{Positions, key_name};
use super::{DataError, Place};
use crate::Set;
#[cfg(feature = "serde")]
use std::path::Path;

/// For every element of a set an element of another: pairs (from, to) in any order, as a list or
/// as the two columns of a file.
///
/// ```
/// use mcp_core::Set;
/// use mcp_core::language::input::LabelMap;
///
/// let gens = Set::new("gens", ["coal", "wind"])?;
/// let nodes = Set::new("nodes", ["north", "south"])?;
/// let site = LabelMap::from([("wind", "north"), ("coal", "south")]);
/// assert_eq!(site.resolve("site", &gens, &nodes)?, [1, 0]);
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LabelMap(Cells);

/// Columns of a file.
const COLUMNS: Columns = Columns { number: 2..=2, names: "from, to" };

impl LabelMap {
    /// The two columns of a CSV file below its header line.
    #[cfg(feature = "serde")]
    pub fn csv(path: impl AsRef<Path>) -> Self {
        LabelMap(Cells::Csv(CsvSource::file(path)))
    }

    /// The two columns of a CSV text below its header line; messages call the text `name`.
    #[cfg(feature = "serde")]
    pub fn csv_text(name: impl Into<String>, text: impl Into<String>) -> Self {
        LabelMap(Cells::Csv(CsvSource::text(name, text)))
    }

    /// For each element of `from` in order, the position of its image in `to`.
    ///
    /// # Errors
    /// [`DataError::Missing`], [`DataError::DuplicateKey`], [`DataError::UnknownLabel`], and what
    /// may be wrong with a file.
    pub fn resolve(&self, map: &str, from: &Set, to: &Set) -> Result<Vec<usize>, DataError> {
        let rows = self.0.rows(map, &COLUMNS)?;
        let (sources, targets) = (Positions::new(from), Positions::new(to));
        let mut images: Vec<Option<(usize, &Row)>> = vec![None; from.len()];
        for row in &rows.rows {
            let source = sources.find(map, &row.cells[0], rows.file(), row.line)?;
            let target = targets.find(map, &row.cells[1], rows.file(), row.line)?;
            if let Some((_, first)) = images[source].replace((target, row)) {
                let (key, first) = (key_name(map, &row.cells[..1]), first.line);
                return Err(DataError::DuplicateKey { key, first, place: rows.place(row) });
            }
        }
        let found: Vec<usize> = images.iter().flatten().map(|&(target, _)| target).collect();
        match images.iter().position(Option::is_none) {
            Some(first) => Err(missing(map, &from.label(first), from.len(), found.len(), &rows)),
            None => Ok(found),
        }
    }
}

fn missing(map: &str, label: &str, expected: usize, found: usize, rows: &Rows) -> DataError {
    let (key, place) = (key_name(map, &[label]), Place::of(rows.file(), None));
    DataError::Missing { key, missing: expected - found, expected, place }
}

impl<A: Into<String>, B: Into<String>> From<Vec<(A, B)>> for LabelMap {
    fn from(pairs: Vec<(A, B)>) -> Self {
        let row = |(from, to): (A, B)| vec![from.into(), to.into()];
        LabelMap(Cells::Given(pairs.into_iter().map(row).collect()))
    }
}

impl<const N: usize> From<[(&str, &str); N]> for LabelMap {
    fn from(pairs: [(&str, &str); N]) -> Self {
        LabelMap::from(Vec::from(pairs))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn resolve(map: impl Into<LabelMap>) -> Result<Vec<usize>, String> {
        let gens = Set::new("gens", ["coal", "wind", "gas"]).unwrap();
        let nodes = Set::new("nodes", ["north", "south"]).unwrap();
        map.into().resolve("site", &gens, &nodes).map_err(|error| error.to_string())
    }

    #[test]
    fn pairs_may_come_in_any_order() {
        let pairs = [("gas", "north"), ("coal", "south"), ("wind", "north")];
        assert_eq!(resolve(pairs), Ok(vec![1, 0, 0]));
        assert_eq!(resolve(pairs.to_vec()), Ok(vec![1, 0, 0]));
        let owned: Vec<(String, String)> =
            pairs.map(|(from, to)| (from.to_owned(), to.to_owned())).to_vec();
        assert_eq!(resolve(owned), Ok(vec![1, 0, 0]));
    }

    #[test]
    fn every_element_has_one_image() {
        let missing = "`site[wind]` has no value (missing: 2 of 3)";
        assert_eq!(resolve([("coal", "north")]).unwrap_err(), missing);
        let twice = "`site[coal]` is given twice";
        assert_eq!(resolve([("coal", "north"), ("coal", "north")]).unwrap_err(), twice);
    }

    #[test]
    fn both_ends_are_labels_of_their_sets() {
        let from = "`site` names `goal`, which is no label of `gens`; did you mean `coal`?";
        assert_eq!(resolve([("goal", "north")]).unwrap_err(), from);
        let to = "`site` names `nort`, which is no label of `nodes`; did you mean `north`?";
        assert_eq!(resolve([("coal", "nort")]).unwrap_err(), to);
    }

    #[cfg(feature = "serde")]
    #[test]
    fn a_file_has_two_columns() {
        let csv = |text| resolve(LabelMap::csv_text("site.csv", text));
        assert_eq!(csv("gen,node\ngas,north\ncoal,south\nwind,north\n"), Ok(vec![1, 0, 0]));
        let twice = "site.csv, line 3: `site[gas]` is given twice, first in line 2";
        assert_eq!(csv("gen,node\ngas,north\ngas,south\n").unwrap_err(), twice);
        let missing = "site.csv: `site[coal]` has no value (missing: 3 of 3)";
        assert_eq!(csv("gen,node\n").unwrap_err(), missing);
        let columns = "site.csv, line 1: `site` needs the columns from, to; found 3";
        assert_eq!(csv("gen,node,cap\n").unwrap_err(), columns);
        let file = resolve(LabelMap::csv("no/such.csv")).unwrap_err();
        assert!(file.starts_with("`site` cannot be read from no/such.csv: "), "{file}");
    }
}
