//! [`CsvSource`]: a CSV file or text, read into a [`Sheet`] that knows its lines.

use super::cells::{Columns, Row, Rows};
use super::{DataError, Place};
use csv::StringRecord;
use std::borrow::Cow;
use std::fs;
use std::path::{Path, PathBuf};

/// A CSV file that is read when the data are needed, or the text of one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum CsvSource {
    File(PathBuf),
    Text { name: String, text: String },
}

/// The header and the rows of a file; all rows are as long as the header.
#[derive(Debug)]
pub(crate) struct Sheet {
    pub(crate) file: String,
    pub(crate) header: Vec<String>,
    pub(crate) header_line: u64,
    pub(crate) rows: Vec<(u64, StringRecord)>,
}

impl CsvSource {
    pub(crate) fn file(path: impl AsRef<Path>) -> Self {
        CsvSource::File(path.as_ref().to_owned())
    }

    pub(crate) fn text(name: impl Into<String>, text: impl Into<String>) -> Self {
        CsvSource::Text { name: name.into(), text: text.into() }
    }

    fn name(&self) -> String {
        match self {
            CsvSource::File(path) => path.display().to_string(),
            CsvSource::Text { name, .. } => name.clone(),
        }
    }

    fn read(&self) -> std::io::Result<Cow<'_, str>> {
        match self {
            CsvSource::File(path) => fs::read_to_string(path).map(Cow::Owned),
            CsvSource::Text { text, .. } => Ok(Cow::Borrowed(text)),
        }
    }

    pub(crate) fn sheet(&self, data: &str) -> Result<Sheet, DataError> {
        let file = self.name();
        let unreadable = |reason: String| {
            let (data, file) = (data.to_owned(), file.clone());
            DataError::Unreadable { data, file, reason }
        };
        let text = self.read().map_err(|error| unreadable(error.to_string()))?;
        let mut records = records(&text).map_err(|error| unreadable(error.to_string()))?;
        if records.is_empty() {
            return Err(DataError::EmptyFile { file });
        }
        let (header_line, header) = records.remove(0);
        let width = (0..header.len()).rfind(|&c| !header[c].is_empty()).map_or(0, |last| last + 1);
        let header: Vec<String> = header.iter().take(width).map(str::to_owned).collect();
        for (line, row) in &mut records {
            if row.len() > width && row.iter().skip(width).all(str::is_empty) {
                row.truncate(width);
            }
            if row.len() != width {
                let place = Place { file, line: Some(*line) };
                return Err(DataError::RowColumns { expected: width, found: row.len(), place });
            }
        }
        Ok(Sheet { file, header, header_line, rows: records })
    }
}

impl Sheet {
    pub(crate) fn place(&self, line: u64) -> Place {
        Place { file: self.file.clone(), line: Some(line) }
    }

    pub(crate) fn check_columns(
        &self,
        data: &str,
        allowed: bool,
        expected: impl FnOnce() -> String,
    ) -> Result<(), DataError> {
        if allowed {
            return Ok(());
        }
        let (found, place) = (self.header.len(), self.place(self.header_line));
        Err(DataError::Columns { data: data.to_owned(), expected: expected(), found, place })
    }

    /// The number in a cell.
    pub(crate) fn number(
        &self,
        line: u64,
        row: &StringRecord,
        column: usize,
    ) -> Result<f64, DataError> {
        row[column].parse().map_err(|_| {
            let (column, text) = (self.header[column].clone(), row[column].to_owned());
            DataError::NotANumber { column, text, place: self.place(line) }
        })
    }

    pub(super) fn into_rows(self, data: &str, columns: &Columns) -> Result<Rows, DataError> {
        let allowed = columns.number.contains(&self.header.len());
        self.check_columns(data, allowed, || columns.names.to_owned())?;
        let row = |(line, record): &(u64, StringRecord)| Row {
            line: Some(*line),
            cells: record.iter().map(str::to_owned).collect(),
        };
        Ok(Rows { rows: self.rows.iter().map(row).collect(), file: Some(self.file) })
    }
}

/// All records with their lines, without comments and without those whose cells are all empty.
fn records(text: &str) -> Result<Vec<(u64, StringRecord)>, csv::Error> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    let mut lines = Lines { text: text.as_bytes(), byte: 0, line: 1 };
    let mut records = Vec::new();
    for record in reader.records() {
        let record = record?;
        let byte = record.position().map_or(0, csv::Position::byte);
        let line = lines.of_record(usize::try_from(byte).unwrap_or(usize::MAX));
        if !record.iter().all(str::is_empty) && !lines.is_comment() {
            records.push((line, record));
        }
    }
    Ok(records)
}

/// Counts lines on the way through a text.
struct Lines<'a> {
    text: &'a [u8],
    byte: usize,
    line: u64,
}

impl Lines<'_> {
    /// The line of the record that the reader found from `byte` on: the reader skips line ends and
    /// comments first, and does not count them.
    fn of_record(&mut self, byte: usize) -> u64 {
        while self.byte < byte.min(self.text.len()) {
            self.step();
        }
        while let Some(&letter) = self.text.get(self.byte) {
            match letter {
                b'\n' | b'\r' => self.step(),
                b'#' => self.skip_line(),
                _ => break,
            }
        }
        self.line
    }

    /// Whether this line is a comment after spaces, which the reader takes for a record.
    fn is_comment(&self) -> bool {
        let rest = self.text.get(self.byte..).unwrap_or_default();
        rest.trim_ascii_start().starts_with(b"#")
    }

    fn skip_line(&mut self) {
        while self.text.get(self.byte).is_some_and(|&letter| letter != b'\n') {
            self.byte += 1;
        }
    }

    fn step(&mut self) {
        self.line += u64::from(self.text[self.byte] == b'\n');
        self.byte += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sheet(text: &str) -> Result<Sheet, DataError> {
        CsvSource::text("cost.csv", text).sheet("cost")
    }

    fn lines_of(text: &str) -> (u64, Vec<u64>) {
        let sheet = sheet(text).unwrap();
        (sheet.header_line, sheet.rows.iter().map(|(line, _)| *line).collect())
    }

    #[test]
    fn comments_and_blank_lines_are_skipped_and_counted() {
        let text =
            "# a comment, \"quoted\n\nplant,cost\na,1\n\n# more\n  \n,,\nb,2\n\"c\nd\",3\ne,4\n";
        assert_eq!(lines_of(text), (3, vec![4, 9, 10, 12]));
        assert_eq!(lines_of(&text.replace('\n', "\r\n")), (3, vec![4, 9, 10, 12]));
        assert_eq!(lines_of("plant,cost\na,1\n#end\nb,2"), (1, vec![2, 4]));
    }

    #[test]
    fn a_byte_order_mark_and_spaces_around_cells_are_ignored() {
        let sheet = sheet("\u{feff}plant , cost\n  new york ,\t2.5 \n").unwrap();
        assert_eq!(sheet.header, ["plant", "cost"]);
        assert_eq!(sheet.rows[0].1, vec!["new york", "2.5"]);
    }

    #[test]
    fn empty_columns_at_the_end_do_not_count() {
        let sheet = sheet("plant,cost,,\na,1,\nb,2,,\nc,\n").unwrap();
        assert_eq!(sheet.header.len(), 2);
        assert!(sheet.rows.iter().all(|(_, row)| row.len() == 2));
    }

    #[test]
    fn a_row_of_another_length_is_an_error_with_its_line() {
        let told = |text| sheet(text).unwrap_err().to_string();
        let short = "cost.csv, line 3: expected 2 columns as in the header, found 1";
        assert_eq!(told("plant,cost\na,1\nb\n"), short);
        let long = "cost.csv, line 2: expected 2 columns as in the header, found 3";
        assert_eq!(told("plant,cost\na,1,2\n"), long);
    }

    #[test]
    fn a_file_without_a_header_is_an_error() {
        assert_eq!(sheet("\n# nothing\n").unwrap_err().to_string(), "cost.csv has no header line");
    }

    #[test]
    fn a_file_that_is_not_there_is_an_error_with_its_path() {
        let error = CsvSource::file("no/such/cost.csv").sheet("cost").unwrap_err();
        let told = "`cost` cannot be read from no/such/cost.csv: ";
        assert!(error.to_string().starts_with(told), "{error}");
    }

    proptest! {
        #[test]
        fn rows_know_their_lines_whatever_stands_between(
            parts in prop::collection::vec(
                prop::sample::select(vec!["", "  ", ",", "# x", "  # \"y", "a,1", "\"b\n#c\",2", "\"#d\","]),
                0..20,
            ),
            end in prop::sample::select(vec!["\n", "\r\n"]),
        ) {
            let (mut text, mut line, mut expected) = (format!("k,v{end}"), 2, Vec::new());
            for part in parts {
                if part.starts_with(['a', '"']) {
                    expected.push(line);
                }
                line += 1 + u64::from(part.contains('\n'));
                text = text + part + end;
            }
            prop_assert_eq!(lines_of(&text), (1, expected.clone()));
            prop_assert_eq!(lines_of(text.trim_end_matches(end)), (1, expected));
        }

        #[test]
        fn any_text_is_read_or_refused(
            letters in prop::collection::vec(prop::sample::select(b"ab1,,\"# \r\n\n".to_vec()), 0..60),
        ) {
            let text: String = letters.into_iter().map(char::from).collect();
            if let Ok(sheet) = sheet(&text) {
                let lines = text.split('\n').count() as u64;
                prop_assert!(sheet.rows.iter().all(|(line, _)| *line <= lines));
                prop_assert!(sheet.rows.iter().all(|(_, row)| row.len() == sheet.header.len()));
            }
        }
    }
}
