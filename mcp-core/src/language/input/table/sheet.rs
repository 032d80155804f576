//! Tables from CSV: long (a row for each number) or wide (a column for each label of the last set).

use super::entries::Entries;
use crate::Set;
use crate::error::nearest;
use crate::language::input::DataError;
use crate::language::input::csv_source::Sheet;
use crate::language::input::positions::Positions;

/// What stands in which column.
struct Layout<'a> {
    /// The sets whose labels stand in columns, each with its column.
    keys: Vec<(Positions<'a>, usize)>,
    /// Columns with numbers, each with its position in the last index.
    numbers: Vec<(usize, usize)>,
    /// Length of the last index, if it runs over columns.
    width: usize,
}

/// Puts all numbers of a sheet, or those of the column with this header, into a table.
pub(super) fn fill(
    sheet: &Sheet,
    column: Option<&str>,
    entries: &mut Entries<'_>,
) -> Result<(), DataError> {
    let layout = match column {
        Some(column) => Layout::named(sheet, entries, column)?,
        None => Layout::new(sheet, entries)?,
    };
    for (line, row) in &sheet.rows {
        let mut base = 0;
        for (positions, column) in &layout.keys {
            let i = positions.find(entries.table, &row[*column], entries.file, Some(*line))?;
            base = base * positions.len() + i;
        }
        for &(column, i) in &layout.numbers {
            if !row[column].is_empty() {
                let number = sheet.number(*line, row, column)?;
                entries.put(base * layout.width + i, number, Some(*line))?;
            }
        }
    }
    Ok(())
}

impl<'a> Layout<'a> {
    fn new(sheet: &Sheet, entries: &Entries<'a>) -> Result<Self, DataError> {
        if let Some((last, sets)) = entries.sets.split_last() {
            let last = Positions::new(last);
            let columns = sheet.header.iter().skip(sets.len());
            if columns.clone().any(|header| last.get(header).is_some()) {
                return Layout::wide(sheet, entries, sets, &last);
            }
        }
        Layout::long(sheet, entries)
    }

    /// A long file with several columns of numbers, of which one is named.
    fn named(sheet: &Sheet, entries: &Entries<'a>, column: &str) -> Result<Self, DataError> {
        let (sets, place) = (entries.sets, || sheet.place(sheet.header_line));
        let numbers = sheet.header.iter().skip(sets.len());
        let mut found = (sets.len()..).zip(numbers.clone()).filter(|(_, header)| *header == column);
        match (found.next(), found.next()) {
            (Some((number, _)), None) => {
                Ok(Layout { keys: keys(sheet, sets), numbers: vec![(number, 0)], width: 1 })
            }
            (Some(_), Some(_)) => {
                Err(DataError::DuplicateColumn { column: column.to_owned(), place: place() })
            }
            (None, _) => Err(DataError::NoColumn {
                column: column.to_owned(),
                nearest: nearest(column, numbers.map(String::as_str)),
                place: place(),
            }),
        }
    }

    fn wide(
        sheet: &Sheet,
        entries: &Entries<'_>,
        sets: &[&'a Set],
        last: &Positions<'_>,
    ) -> Result<Self, DataError> {
        let line = Some(sheet.header_line);
        let mut taken = vec![false; last.len()];
        let mut numbers = Vec::with_capacity(last.len());
        for (column, header) in sheet.header.iter().enumerate().skip(sets.len()) {
            let i = last.find(entries.table, header, entries.file, line)?;
            if std::mem::replace(&mut taken[i], true) {
                let (column, place) = (header.clone(), sheet.place(sheet.header_line));
                return Err(DataError::DuplicateColumn { column, place });
            }
            numbers.push((column, i));
        }
        Ok(Layout { keys: keys(sheet, sets), numbers, width: last.len() })
    }

    fn long(sheet: &Sheet, entries: &Entries<'a>) -> Result<Self, DataError> {
        let sets = entries.sets;
        let fits = sheet.header.len() == sets.len() + 1;
        sheet.check_columns(entries.table, fits, || expected(sets))?;
        Ok(Layout { keys: keys(sheet, sets), numbers: vec![(sets.len(), 0)], width: 1 })
    }
}

/// The key columns: found by their headers if these are the names of the sets, else in order.
fn keys<'a>(sheet: &Sheet, sets: &[&'a Set]) -> Vec<(Positions<'a>, usize)> {
    let headers = &sheet.header[..sets.len()];
    let column = |set: &&Set| headers.iter().position(|header| header == set.name());
    let by_name: Vec<usize> = sets.iter().filter_map(column).collect();
    let is_permutation = (0..sets.len()).all(|column| by_name.contains(&column));
    let column = |k: usize| if is_permutation { by_name[k] } else { k };
    sets.iter().enumerate().map(|(k, &set)| (Positions::new(set), column(k))).collect()
}

/// The columns of a long and of a wide file, for a message.
fn expected(sets: &[&Set]) -> String {
    let columns = |sets: &[&Set], numbers: &str| {
        let names = sets.iter().map(|set| set.name());
        names.chain([numbers]).collect::<Vec<_>>().join(", ")
    };
    let long = columns(sets, "value");
    let Some((last, others)) = sets.split_last() else {
        return long;
    };
    let numbers = format!("one column for each label of {}", last.name());
    format!("{long}; or {}", columns(others, &numbers))
}
