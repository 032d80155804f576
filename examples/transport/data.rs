//! Plants, markets and distances from three CSV files.
//!
//! | file | columns |
//! | --- | --- |
//! | `plants.csv` | `plant`, `capacity_cases` |
//! | `markets.csv` | `market`, `demand_cases` |
//! | `distances.csv` | `plant`, `market`, `thousand_miles`: one row for each pair |
//!
//! Rows and columns may come in any order; further columns are ignored. Everything else that is
//! not as it should be is a [`DataError`] that says where.

use mcp_core::{ModelError, Set};
use std::collections::HashMap;
use std::fs;
use std::path::Path;

/// What the model needs, in the order of the sets.
#[derive(Clone, Debug)]
pub(crate) struct TransportData {
    pub(crate) plants: Set,
    pub(crate) markets: Set,
    /// Capacity of each plant [cases].
    pub(crate) capacity: Vec<f64>,
    /// Demand of each market [cases].
    pub(crate) demand: Vec<f64>,
    /// Distance of each pair, plant by plant [thousand miles].
    pub(crate) distance: Vec<f64>,
}

impl TransportData {
    /// Reads the three files of a directory.
    pub(crate) fn read(directory: &Path) -> Result<Self, DataError> {
        let plants = Table::open(directory, "plants.csv", ["plant", "capacity_cases"])?;
        let (plants, capacity) = plants.amounts("plants")?;
        let markets = Table::open(directory, "markets.csv", ["market", "demand_cases"])?;
        let (markets, demand) = markets.amounts("markets")?;
        let columns = ["plant", "market", "thousand_miles"];
        let distances = Table::open(directory, "distances.csv", columns)?;
        let distance = distances.matrix(&plants, &markets)?;
        Ok(TransportData { plants, markets, capacity, demand, distance })
    }
}

/// What is wrong with the files, and where.
#[derive(Debug, thiserror::Error)]
pub(crate) enum DataError {
    /// There is no such file, or it is not a text.
    #[error("{path}: {source}")]
    Unreadable { path: String, source: std::io::Error },
    /// A cell is not what it should be, or is not there.
    #[error("{file}, line {line}, column `{column}`: {fault}")]
    Cell { file: &'static str, line: u64, column: String, fault: Fault },
}

/// What is wrong with a cell.
#[derive(Debug, PartialEq, thiserror::Error)]
pub(crate) enum Fault {
    #[error("the file is empty")]
    EmptyFile,
    #[error("there are no rows")]
    NoRows,
    #[error("there is no such column, only `{found}`")]
    MissingColumn { found: String },
    #[error("there are two columns of this name")]
    ColumnTwice,
    #[error("the row has {found} cells, the header {expected}")]
    RowLength { found: usize, expected: usize },
    #[error("the cell is empty")]
    EmptyCell,
    #[error("`{found}` is not a number")]
    NotANumber { found: String },
    #[error("{found} is not finite")]
    NotFinite { found: f64 },
    #[error("{found} is negative")]
    Negative { found: f64 },
    #[error("`{label}` was given before, in line {line}")]
    Duplicate { label: String, line: u64 },
    #[error("{0}")]
    Label(ModelError),
    #[error("the pair `{plant}`, `{market}` was given before, in line {line}")]
    DuplicatePair { plant: String, market: String, line: u64 },
    #[error("there is no row for `{plant}`, `{market}`")]
    MissingPair { plant: String, market: String },
    #[error("{0}")]
    Malformed(String),
}

/// The `N` columns of a file that are asked for, in that order.
struct Table<const N: usize> {
    file: &'static str,
    columns: [&'static str; N],
    rows: Vec<TableRow<N>>,
    /// Line after the last row.
    end: u64,
}

struct TableRow<const N: usize> {
    line: u64,
    cells: [String; N],
}

impl<const N: usize> Table<N> {
    fn open(
        directory: &Path,
        file: &'static str,
        columns: [&'static str; N],
    ) -> Result<Self, DataError> {
        let path = directory.join(file);
        let text = fs::read_to_string(&path)
            .map_err(|source| DataError::Unreadable { path: path.display().to_string(), source })?;
        let mut table = Table { file, columns, rows: Vec::new(), end: 1 };
        let mut reader = csv::ReaderBuilder::new()
            .flexible(true)
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());

        let header = reader.headers().map_err(|e| table.malformed(&e))?.clone();
        if header.iter().all(str::is_empty) {
            return Err(table.fault(1, 0, Fault::EmptyFile));
        }
        let mut position = [0; N];
        for (k, column) in columns.iter().enumerate() {
            let mut found = (0..header.len()).filter(|&c| &header[c] == *column);
            position[k] = found.next().ok_or_else(|| {
                let found = header.iter().collect::<Vec<_>>().join("`, `");
                table.fault(1, k, Fault::MissingColumn { found })
            })?;
            if found.next().is_some() {
                return Err(table.fault(1, k, Fault::ColumnTwice));
            }
        }

        for record in reader.records() {
            let record = record.map_err(|e| table.malformed(&e))?;
            let line = line_of(&record, &text);
            if record.len() != header.len() {
                let (found, expected) = (record.len(), header.len());
                let column = header[found.min(expected - 1)].to_owned();
                let fault = Fault::RowLength { found, expected };
                return Err(DataError::Cell { file, line, column, fault });
            }
            table.rows.push(TableRow { line, cells: position.map(|c| record[c].to_owned()) });
        }
        table.end = text.lines().count() as u64 + 1;
        if table.rows.is_empty() {
            return Err(table.fault(table.end, 0, Fault::NoRows));
        }
        Ok(table)
    }

    /// The number in a cell: finite and not negative.
    fn number(&self, row: &TableRow<N>, column: usize) -> Result<f64, DataError> {
        let cell = &row.cells[column];
        let fault = match cell.parse::<f64>() {
            Ok(value) if value >= 0.0 && value.is_finite() => return Ok(value),
            Ok(found) if found.is_finite() => Fault::Negative { found },
            Ok(found) => Fault::NotFinite { found },
            Err(_) if cell.is_empty() => Fault::EmptyCell,
            Err(_) => Fault::NotANumber { found: cell.clone() },
        };
        Err(self.fault(row.line, column, fault))
    }

    /// Which element of a set a cell names.
    fn index(&self, row: &TableRow<N>, column: usize, set: &Set) -> Result<usize, DataError> {
        set.index_of(&row.cells[column])
            .map_err(|error| self.fault(row.line, column, Fault::Label(error)))
    }

    fn fault(&self, line: u64, column: usize, fault: Fault) -> DataError {
        let column = self.columns[column].to_owned();
        DataError::Cell { file: self.file, line, column, fault }
    }

    fn malformed(&self, error: &csv::Error) -> DataError {
        let line = error.position().map_or(1, csv::Position::line);
        self.fault(line, 0, Fault::Malformed(error.to_string()))
    }
}

impl Table<2> {
    /// A set and an amount for each of its elements.
    fn amounts(&self, name: &str) -> Result<(Set, Vec<f64>), DataError> {
        let mut lines = HashMap::new();
        let mut amounts = Vec::new();
        for row in &self.rows {
            let label = &row.cells[0];
            if label.is_empty() {
                return Err(self.fault(row.line, 0, Fault::EmptyCell));
            }
            if let Some(line) = lines.insert(label, row.line) {
                let label = label.clone();
                return Err(self.fault(row.line, 0, Fault::Duplicate { label, line }));
            }
            amounts.push(self.number(row, 1)?);
        }
        let labels = self.rows.iter().map(|row| row.cells[0].as_str());
        let set = Set::new(name, labels).map_err(|e| self.fault(1, 0, Fault::Label(e)))?;
        Ok((set, amounts))
    }
}

impl Table<3> {
    /// A number for each pair of elements, the second index running fastest.
    fn matrix(&self, first: &Set, second: &Set) -> Result<Vec<f64>, DataError> {
        let mut found: Vec<Option<(f64, u64)>> = vec![None; first.len() * second.len()];
        let pair = |k: usize| (first.label(k / second.len()), second.label(k % second.len()));
        for row in &self.rows {
            let k = self.index(row, 0, first)? * second.len() + self.index(row, 1, second)?;
            let number = self.number(row, 2)?;
            if let Some((_, line)) = found[k].replace((number, row.line)) {
                let (plant, market) = pair(k);
                let fault = Fault::DuplicatePair { plant, market, line };
                return Err(self.fault(row.line, 1, fault));
            }
        }
        let number = |(k, found): (usize, &Option<(f64, u64)>)| {
            found.map(|(number, _)| number).ok_or_else(|| {
                let (plant, market) = pair(k);
                self.fault(self.end, 2, Fault::MissingPair { plant, market })
            })
        };
        found.iter().enumerate().map(number).collect()
    }
}

/// The line a record stands in: the reader's own count stops at blank lines before it.
fn line_of(record: &csv::StringRecord, text: &str) -> u64 {
    let Some(position) = record.position() else {
        return 1;
    };
    let byte = usize::try_from(position.byte()).unwrap_or(usize::MAX);
    let rest = text.as_bytes().get(byte..).unwrap_or_default();
    let blank = rest.iter().take_while(|byte| byte.is_ascii_whitespace());
    position.line() + blank.filter(|&&byte| byte == b'\n').count() as u64
}
