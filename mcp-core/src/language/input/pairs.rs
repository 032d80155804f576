//! [`LabelPairs`]: what a user may give for a set of pairs.

use super::DataError;
use super::cells::{Cells, Columns, Row};
#[cfg(feature = "serde")]
use super::csv_source::CsvSource;
use super::labels::labelled;
use super::positions::Positions;
use crate::Set;
#[cfg(feature = "serde")]
use std::path::Path;

/// Pairs of labels of two sets, such as the lines of a network: (from, to), or (name, from, to),
/// as a list or as the columns of a file. There may be none.
///
/// A pair without a name has the label `from->to`; parallel pairs need names.
///
/// ```
/// use mcp_core::Set;
/// use mcp_core::language::input::LabelPairs;
///
/// let nodes = Set::new("nodes", ["north", "south"])?;
/// let lines = LabelPairs::from([("north", "south"), ("south", "north")]);
/// let (lines, ends) = lines.resolve("lines", &nodes, &nodes)?;
/// assert_eq!(lines.label(0), "north->south");
/// assert_eq!(ends, [(0, 1), (1, 0)]);
///
/// let lines = LabelPairs::from([("old", "north", "south"), ("new", "north", "south")]);
/// let (lines, ends) = lines.resolve("lines", &nodes, &nodes)?;
/// assert_eq!(lines.label(1), "new");
/// assert_eq!(ends, [(0, 1), (0, 1)]);
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LabelPairs(Cells);

/// Columns of a file.
const COLUMNS: Columns = Columns { number: 2..=3, names: "from, to or name, from, to" };

impl LabelPairs {
    /// The columns from, to or name, from, to of a CSV file below its header line.
    #[cfg(feature = "serde")]
    pub fn csv(path: impl AsRef<Path>) -> Self {
        LabelPairs(Cells::Csv(CsvSource::file(path)))
    }

    /// The columns from, to or name, from, to of a CSV text below its header line; messages call
    /// the text `name`.
    #[cfg(feature = "serde")]
    pub fn csv_text(name: impl Into<String>, text: impl Into<String>) -> Self {
        LabelPairs(Cells::Csv(CsvSource::text(name, text)))
    }

    /// The set of the pairs, and for each the positions of its ends in `from` and `to`.
    ///
    /// # Errors
    /// [`DataError::UnknownLabel`], [`DataError::DuplicateLabel`], [`DataError::EmptyLabel`], and
    /// what may be wrong with a file.
    pub fn resolve(
        &self,
        pairs: &str,
        from: &Set,
        to: &Set,
    ) -> Result<(Set, Vec<(usize, usize)>), DataError> {
        let rows = self.0.rows(pairs, &COLUMNS)?;
        let (sources, targets) = (Positions::new(from), Positions::new(to));
        let mut ends = Vec::with_capacity(rows.rows.len());
        for row in &rows.rows {
            let (_, [from, to]) = parts(row);
            let source = sources.find(pairs, from, rows.file(), row.line)?;
            ends.push((source, targets.find(pairs, to, rows.file(), row.line)?));
        }
        Ok((labelled(pairs, rows.labels(pairs, label)?), ends))
    }
}

/// The name of a pair, if it has one, and its ends.
fn parts(row: &Row) -> (Option<&str>, [&str; 2]) {
    match row.cells.as_slice() {
        [name, from, to] => (Some(name), [from, to]),
        cells => (None, [&cells[0], &cells[1]]),
    }
}

fn label(row: &Row) -> String {
    let (name, [from, to]) = parts(row);
    name.map_or_else(|| format!("{from}->{to}"), str::to_owned)
}

impl Default for LabelPairs {
    /// No pairs.
    fn default() -> Self {
        LabelPairs(Cells::Given(Vec::new()))
    }
}

impl<A: Into<String>, B: Into<String>> From<Vec<(A, B)>> for LabelPairs {
    fn from(pairs: Vec<(A, B)>) -> Self {
        let row = |(from, to): (A, B)| vec![from.into(), to.into()];
        LabelPairs(Cells::Given(pairs.into_iter().map(row).collect()))
    }
}

impl<A: Into<String>, B: Into<String>, C: Into<String>> From<Vec<(A, B, C)>> for LabelPairs {
    fn from(pairs: Vec<(A, B, C)>) -> Self {
        let row = |(name, from, to): (A, B, C)| vec![name.into(), from.into(), to.into()];
        LabelPairs(Cells::Given(pairs.into_iter().map(row).collect()))
    }
}

impl<const N: usize> From<[(&str, &str); N]> for LabelPairs {
    fn from(pairs: [(&str, &str); N]) -> Self {
        LabelPairs::from(Vec::from(pairs))
    }
}

impl<const N: usize> From<[(&str, &str, &str); N]> for LabelPairs {
    fn from(pairs: [(&str, &str, &str); N]) -> Self {
        LabelPairs::from(Vec::from(pairs))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Resolved = (Vec<String>, Vec<(usize, usize)>);

    fn resolve(pairs: impl Into<LabelPairs>) -> Result<Resolved, String> {
        let nodes = Set::new("nodes", ["north", "south"]).unwrap();
        let zones = Set::new("zones", ["x", "y"]).unwrap();
        let resolved = pairs.into().resolve("lines", &nodes, &zones);
        let (set, ends) = resolved.map_err(|error| error.to_string())?;
        assert_eq!(set.name(), "lines");
        Ok((set.labels().collect(), ends))
    }

    fn expected(labels: [&str; 2], ends: [(usize, usize); 2]) -> Resolved {
        (labels.map(str::to_owned).to_vec(), ends.to_vec())
    }

    #[test]
    fn pairs_without_names_are_labelled_by_their_ends() {
        let pairs = [("south", "x"), ("north", "y")];
        let expected = expected(["south->x", "north->y"], [(1, 0), (0, 1)]);
        assert_eq!(resolve(pairs), Ok(expected.clone()));
        assert_eq!(resolve(pairs.to_vec()), Ok(expected.clone()));
        let owned = pairs.map(|(from, to)| (from.to_owned(), to.to_owned())).to_vec();
        assert_eq!(resolve(owned), Ok(expected));
    }

    #[test]
    fn pairs_with_names_may_be_parallel() {
        let pairs = [("old", "south", "x"), ("new", "south", "x")];
        let expected = expected(["old", "new"], [(1, 0), (1, 0)]);
        assert_eq!(resolve(pairs), Ok(expected.clone()));
        assert_eq!(resolve(pairs.to_vec()), Ok(expected));
    }

    #[test]
    fn there_may_be_no_pairs() {
        assert_eq!(resolve(LabelPairs::default()), Ok((vec![], vec![])));
    }

    #[test]
    fn labels_must_differ_and_must_not_be_empty() {
        let twice = "`lines` has the label `north->x` twice";
        assert_eq!(resolve([("north", "x"), ("north", "x")]).unwrap_err(), twice);
        let empty = "label 1 of `lines` is empty";
        assert_eq!(resolve([("", "north", "x")]).unwrap_err(), empty);
    }

    #[test]
    fn both_ends_are_labels_of_their_sets() {
        let from = "`lines` names `nort`, which is no label of `nodes`; did you mean `north`?";
        assert_eq!(resolve([("nort", "x")]).unwrap_err(), from);
        let to = "`lines` names `north`, which is no label of `zones`";
        assert_eq!(resolve([("north", "north")]).unwrap_err(), to);
    }

    #[cfg(feature = "serde")]
    #[test]
    fn a_file_has_two_or_three_columns() {
        let csv = |text| resolve(LabelPairs::csv_text("lines.csv", text));
        let ends = [(1, 0), (0, 1)];
        let two = "from,to\nsouth,x\nnorth,y\n";
        assert_eq!(csv(two), Ok(expected(["south->x", "north->y"], ends)));
        let three = "line,from,to\na,south,x\nb,north,y\n";
        assert_eq!(csv(three), Ok(expected(["a", "b"], ends)));
        let twice = "lines.csv, line 3: `lines` has the label `north->x` twice";
        assert_eq!(csv("from,to\nnorth,x\nnorth,x\n").unwrap_err(), twice);
        let unknown = "lines.csv, line 2: `lines` names `z`, which is no label of `zones`; \
                       did you mean `x`?";
        assert_eq!(csv("from,to\nnorth,z\n").unwrap_err(), unknown);
        let columns = "lines.csv, line 1: `lines` needs the columns from, to or name, from, to; \
                       found 1";
        assert_eq!(csv("from\n").unwrap_err(), columns);
        let file = resolve(LabelPairs::csv("no/such.csv")).unwrap_err();
        assert!(file.starts_with("`lines` cannot be read from no/such.csv: "), "{file}");
    }
}
