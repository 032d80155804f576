//! [`Table`]: numbers for all elements of index sets.

mod convert;
mod entries;
#[cfg(feature = "serde")]
mod sheet;
#[cfg(all(test, feature = "serde"))]
mod sheet_tests;
#[cfg(test)]
mod tests;

pub use convert::{Key, Number};

#[cfg(feature = "serde")]
use super::csv_source::CsvSource;
use super::positions::{Positions, element_name, key_name};
use super::{DataError, Place};
use crate::Set;
use crate::model::combinations;
use entries::Entries;
#[cfg(feature = "serde")]
use std::path::Path;

/// One number for every element of a family such as `cost[plants, markets]`.
///
/// It is made of one number (the same for all), of a list in the sets' order with the last index
/// running fastest, of a nested list, of keys with numbers in any order, or of a CSV file (feature
/// `serde`). Numbers are `f64` or `i32`; infinities are numbers, NaN is not.
///
/// ```
/// use mcp_core::Set;
/// use mcp_core::language::input::Table;
///
/// let plants = Set::new("plants", ["seattle", "san-diego"])?;
/// let markets = Set::new("markets", ["chicago", "topeka"])?;
/// let sets = [&plants, &markets];
///
/// let rows = Table::from([[1.7, 1.8], [1.8, 1.4]]);
/// assert_eq!(rows.resolve("cost", &sets)?, [1.7, 1.8, 1.8, 1.4]);
///
/// let keyed = Table::from([
///     (("san-diego", "chicago"), 1.8),
///     (("san-diego", "topeka"), 1.4),
///     (("seattle", "chicago"), 1.7),
/// ]);
/// let told = keyed.resolve("cost", &sets).unwrap_err();
/// assert_eq!(told.to_string(), "`cost[seattle, topeka]` has no value (missing: 1 of 4)");
///
/// assert_eq!(Table::from([350, 600]).resolve("capacity", &[&plants])?, [350.0, 600.0]);
/// assert_eq!(Table::from(90.0).resolve("freight", &[])?, [90.0]);
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
///
/// A CSV file is *long*, with one column for each index and one for the number, or *wide*, with
/// one column for each label of the last set. It is wide if a header after the first columns, one
/// for each set but the last, is a label of the last set. Key columns are found by their headers
/// if these are the names of the sets, and stand in the sets' order if not. Rows and label columns
/// come in any order; an empty cell is a missing number.
///
/// ```
/// # #[cfg(feature = "serde")] {
/// # use mcp_core::Set;
/// # use mcp_core::language::input::Table;
/// # let plants = Set::new("plants", ["seattle", "san-diego"])?;
/// # let markets = Set::new("markets", ["chicago", "topeka"])?;
/// let long = "plants,markets,cost
///     seattle,topeka,1.8
///     seattle,chicago,1.7
///     san-diego,topeka,1.4
///     san-diego,chicago,1.8";
/// let wide = "plants,topeka,chicago
///     san-diego,1.4,1.8
///     seattle,1.8,1.7";
/// for text in [long, wide] {
///     let cost = Table::csv_text("cost.csv", text).resolve("cost", &[&plants, &markets])?;
///     assert_eq!(cost, [1.7, 1.8, 1.8, 1.4]);
/// }
/// # }
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Table(Form);

#[derive(Clone, Debug, PartialEq)]
enum Form {
    Same(f64),
    Each(Vec<f64>),
    Rows(Vec<Vec<f64>>),
    Keyed(Vec<(Vec<String>, f64)>),
    /// The file, and the header of the column with the numbers if it was named.
    #[cfg(feature = "serde")]
    Csv(CsvSource, Option<String>),
}

impl Table {
    /// The numbers of a CSV file, long or wide.
    #[cfg(feature = "serde")]
    pub fn csv(path: impl AsRef<Path>) -> Self {
        Table(Form::Csv(CsvSource::file(path), None))
    }

    /// The numbers in one column of a CSV file, found by its header. Keys stand in the first columns, as
    /// in a long file; other columns are ignored.
    #[cfg(feature = "serde")]
    pub fn csv_column(path: impl AsRef<Path>, column: impl Into<String>) -> Self {
        Table(Form::Csv(CsvSource::file(path), Some(column.into())))
    }

    /// The numbers of a CSV text, long or wide; messages call the text `name`.
    #[cfg(feature = "serde")]
    pub fn csv_text(name: impl Into<String>, text: impl Into<String>) -> Self {
        Table(Form::Csv(CsvSource::text(name, text), None))
    }

    /// The numbers of `table[sets]` in the sets' order, the last index running fastest.
    ///
    /// # Errors
    /// Every [`DataError`] about numbers, keys, shapes and files.
    pub fn resolve(&self, table: &str, sets: &[&Set]) -> Result<Vec<f64>, DataError> {
        let target = Target { table, sets, len: element_count(table, sets)? };
        match &self.0 {
            Form::Same(number) => target.list(&vec![*number; target.len]),
            Form::Each(numbers) => target.list(numbers),
            Form::Rows(rows) => target.nested(rows),
            Form::Keyed(entries) => target.keyed(entries),
            #[cfg(feature = "serde")]
            Form::Csv(source, column) => target.csv(source, column.as_deref()),
        }
    }
}

/// The table to be filled.
struct Target<'a> {
    table: &'a str,
    sets: &'a [&'a Set],
    len: usize,
}

impl Target<'_> {
    fn list(&self, numbers: &[f64]) -> Result<Vec<f64>, DataError> {
        if numbers.len() != self.len {
            return Err(self.wrong_shape(numbers.len(), numbers.len().to_string()));
        }
        match numbers.iter().position(|number| number.is_nan()) {
            Some(i) => {
                let key = element_name(self.table, self.sets, i);
                Err(DataError::Nan { key, place: None })
            }
            None => Ok(numbers.to_vec()),
        }
    }

    fn nested(&self, rows: &[Vec<f64>]) -> Result<Vec<f64>, DataError> {
        let numbers = rows.concat();
        if let [first, second] = self.sets {
            if rows.len() == first.len() {
                self.check_rows(rows, first, second)?;
                return self.list(&numbers);
            }
        } else if self.sets.is_empty() && numbers.len() == 1 {
            return self.list(&numbers);
        }
        let width = rows.first().map_or(0, Vec::len);
        let is_even = rows.iter().all(|row| row.len() == width);
        let rows = rows.len();
        let found = if is_even { format!("{rows} x {width}") } else { format!("{rows} rows") };
        Err(self.wrong_shape(numbers.len(), found))
    }

    /// Rows of different lengths are told one by one, rows of the same wrong length as a shape.
    fn check_rows(&self, rows: &[Vec<f64>], first: &Set, second: &Set) -> Result<(), DataError> {
        let expected = second.len();
        let Some(i) = rows.iter().position(|row| row.len() != expected) else {
            return Ok(());
        };
        let found = rows[i].len();
        if rows.iter().all(|row| row.len() == found) {
            return Err(self.wrong_shape(rows.len() * found, format!("{} x {found}", rows.len())));
        }
        let key = key_name(self.table, &[first.label(i)]);
        Err(DataError::RowLength { key, expected, found })
    }

    fn keyed(&self, given: &[(Vec<String>, f64)]) -> Result<Vec<f64>, DataError> {
        let positions: Vec<Positions<'_>> =
            self.sets.iter().map(|set| Positions::new(set)).collect();
        let mut entries = Entries::new(self.table, self.sets, self.len, None);
        for (key, number) in given {
            if key.len() != self.sets.len() {
                let (key, form) = (key_name(self.table, key), form(self.table, self.sets));
                return Err(DataError::KeyLength { key, form });
            }
            let mut position = 0;
            for (label, positions) in key.iter().zip(&positions) {
                let i = positions.find(self.table, label, None, None)?;
                position = position * positions.len() + i;
            }
            entries.put(position, *number, None)?;
        }
        entries.finish()
    }

    #[cfg(feature = "serde")]
    fn csv(&self, source: &CsvSource, column: Option<&str>) -> Result<Vec<f64>, DataError> {
        let sheet = source.sheet(self.table)?;
        if self.sets.is_empty() && sheet.rows.len() != 1 {
            return Err(self.not_one_number(sheet.rows.len(), Some(&sheet.file)));
        }
        let mut entries = Entries::new(self.table, self.sets, self.len, Some(&sheet.file));
        sheet::fill(&sheet, column, &mut entries)?;
        entries.finish()
    }

    fn wrong_shape(&self, numbers: usize, found: String) -> DataError {
        if self.sets.is_empty() {
            return self.not_one_number(numbers, None);
        }
        let lengths: Vec<String> = self.sets.iter().map(|set| set.len().to_string()).collect();
        let (form, expected) = (form(self.table, self.sets), lengths.join(" x "));
        DataError::Shape { form, expected, found }
    }

    fn not_one_number(&self, found: usize, file: Option<&str>) -> DataError {
        let (table, place) = (self.table.to_owned(), Place::of(file, None));
        DataError::NotOneNumber { table, found, place }
    }
}

/// The table with its index sets, such as `cost[plants, markets]`.
fn form(table: &str, sets: &[&Set]) -> String {
    let names: Vec<&str> = sets.iter().map(|set| set.name()).collect();
    key_name(table, &names)
}

fn element_count(table: &str, sets: &[&Set]) -> Result<usize, DataError> {
    combinations(sets).ok_or_else(|| DataError::TooManyElements { form: form(table, sets) })
}
