//! [`Labels`]: what a user may give for a set.

use super::DataError;
use super::Place;
use super::cells::{Cells, Columns};
#[cfg(feature = "serde")]
use super::csv_source::CsvSource;
use crate::Set;
use crate::model::MOST_ELEMENTS;
#[cfg(feature = "serde")]
use std::path::Path;

/// The labels of a set: a list, a number of elements, another set, or the first column of a file.
///
/// ```
/// use mcp_core::language::input::Labels;
///
/// let plants = Labels::from(["seattle", "san-diego"]).into_set("plants")?;
/// assert_eq!(plants.index_of("san-diego")?, 1);
///
/// let firms = Labels::from(3).into_set("firms")?;
/// assert_eq!(firms.labels().collect::<Vec<_>>(), ["1", "2", "3"]);
///
/// let told = Labels::from(["a", "b", "a"]).into_set("plants").unwrap_err();
/// assert_eq!(told.to_string(), "`plants` has the label `a` twice");
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Labels(Form);

#[derive(Clone, Debug, PartialEq)]
enum Form {
    List(Cells),
    Count(usize),
    Set(Set),
}

impl Labels {
    /// The first column of a CSV file below its header line.
    #[cfg(feature = "serde")]
    pub fn csv(path: impl AsRef<Path>) -> Self {
        Labels(Form::List(Cells::Csv(CsvSource::file(path))))
    }

    /// The first column of a CSV text below its header line; messages call the text `name`.
    #[cfg(feature = "serde")]
    pub fn csv_text(name: impl Into<String>, text: impl Into<String>) -> Self {
        Labels(Form::List(Cells::Csv(CsvSource::text(name, text))))
    }

    /// The set with these labels.
    ///
    /// # Errors
    /// [`DataError::EmptySet`], [`DataError::EmptyLabel`], [`DataError::DuplicateLabel`],
    /// [`DataError::TooManyElements`], and what may be wrong with a file.
    pub fn into_set(self, name: &str) -> Result<Set, DataError> {
        let count = match &self.0 {
            Form::Count(n) => *n,
            Form::Set(set) => set.len(),
            Form::List(_) => 0,
        };
        if count > MOST_ELEMENTS {
            return Err(DataError::TooManyElements { form: name.to_owned() });
        }
        let cells = match self.0 {
            Form::Count(n) if n > 0 => return Ok(Set::count(name, n)),
            Form::Set(set) if set.name() == name && !set.is_empty() && !set.has_blank_label() => {
                return Ok(set);
            }
            Form::Count(_) => Cells::Given(Vec::new()),
            Form::Set(set) => Cells::list(set.labels()),
            Form::List(cells) => cells,
        };
        let rows = cells.rows(name, &Columns::FIRST)?;
        if rows.rows.is_empty() {
            let place = Place::of(rows.file(), None);
            return Err(DataError::EmptySet { set: name.to_owned(), place });
        }
        let labels = rows.labels(name, |row| row.cells[0].clone())?;
        Ok(labelled(name, labels))
    }
}

/// The set with labels that were checked to differ.
pub(super) fn labelled(name: &str, labels: Vec<String>) -> Set {
    Set::new(name, labels).unwrap_or_else(|error| unreachable!("labels were checked: {error}"))
}

impl<const N: usize> From<[&str; N]> for Labels {
    fn from(labels: [&str; N]) -> Self {
        Labels(Form::List(Cells::list(labels)))
    }
}

impl From<Vec<&str>> for Labels {
    fn from(labels: Vec<&str>) -> Self {
        Labels(Form::List(Cells::list(labels)))
    }
}

impl From<Vec<String>> for Labels {
    fn from(labels: Vec<String>) -> Self {
        Labels(Form::List(Cells::list(labels)))
    }
}

impl From<usize> for Labels {
    fn from(count: usize) -> Self {
        Labels(Form::Count(count))
    }
}

impl From<Set> for Labels {
    fn from(set: Set) -> Self {
        Labels(Form::Set(set))
    }
}

impl From<&Set> for Labels {
    fn from(set: &Set) -> Self {
        Labels(Form::Set(set.clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(labels: impl Into<Labels>) -> String {
        labels.into().into_set("plants").unwrap_err().to_string()
    }

    fn labels(labels: impl Into<Labels>) -> Vec<String> {
        let set = labels.into().into_set("plants").unwrap();
        assert_eq!(set.name(), "plants");
        set.labels().collect()
    }

    #[test]
    fn every_form_gives_the_same_set() {
        let set = Set::new("elsewhere", ["a", "b"]).unwrap();
        assert_eq!(labels(["a", "b"]), ["a", "b"]);
        assert_eq!(labels(vec!["a", "b"]), ["a", "b"]);
        assert_eq!(labels(vec!["a".to_owned(), "b".to_owned()]), ["a", "b"]);
        assert_eq!(labels(&set), ["a", "b"]);
        assert_eq!(labels(set), ["a", "b"]);
        assert_eq!(labels(2), ["1", "2"]);
    }

    #[test]
    fn an_empty_set_is_an_error() {
        let empty = "set `plants` is empty: give at least one label";
        assert_eq!(told([]), empty);
        assert_eq!(told(0), empty);
        assert_eq!(told(Set::count("plants", 0)), empty);
    }

    #[test]
    fn labels_must_differ_and_must_not_be_empty() {
        assert_eq!(told(["a", "b", "a"]), "`plants` has the label `a` twice");
        assert_eq!(told(["a", " "]), "label 2 of `plants` is empty");
        assert_eq!(told(Set::new("plants", ["a", " "]).unwrap()), "label 2 of `plants` is empty");
    }

    #[test]
    fn a_set_of_more_elements_than_an_index_can_tell_is_an_error() {
        let many = "`plants` has more than 2^31 elements";
        assert_eq!(told((1 << 31) + 1), many);
        assert_eq!(told(Set::count("elsewhere", usize::MAX)), many);
        assert_eq!(Labels::from(1 << 31).into_set("plants").unwrap().len(), 1 << 31);
    }

    #[cfg(feature = "serde")]
    #[test]
    fn a_file_gives_its_first_column() {
        let csv = |text| Labels::csv_text("plants.csv", text);
        assert_eq!(labels(csv("plant,capacity\n# west\nseattle,350\nsan-diego,600\n")).len(), 2);
        let empty = "plants.csv: set `plants` is empty: give at least one label";
        assert_eq!(told(csv("plant,capacity\n")), empty);
        let twice = "plants.csv, line 3: `plants` has the label `a` twice";
        assert_eq!(told(csv("plant\na\na\n")), twice);
        let empty = "plants.csv, line 3: label 2 of `plants` is empty";
        assert_eq!(told(csv("plant,capacity\na,1\n,2\n")), empty);
        assert_eq!(told(csv("")), "plants.csv has no header line");
        let file = told(Labels::csv("no/such/plants.csv"));
        assert!(file.starts_with("`plants` cannot be read from no/such/plants.csv: "), "{file}");
    }
}
