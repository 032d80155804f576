//! A CSV file in plain text: rows of cells, the header among them.

use std::fs;
use std::path::Path;

/// Rows of a file in `examples/data`.
pub(crate) fn rows(file: &str) -> Vec<Vec<String>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/data").join(file);
    let text = fs::read_to_string(path).unwrap();
    text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

/// The numbers of a file, without its header and the first column.
pub(crate) fn numbers(file: &str) -> Vec<Vec<f64>> {
    let cells = |row: &Vec<String>| row[1..].iter().map(|cell| cell.parse().unwrap()).collect();
    rows(file)[1..].iter().map(cells).collect()
}
