//! [`Pattern`]: where a Jacobian can be different from zero.

use std::ops::Range;

/// The structural nonzeros of a square matrix, compressed by columns.
///
/// One pattern belongs to a problem for good; every Jacobian is a slice of values in its order.
/// Invariants: `column_starts` has `n + 1` entries, starts at 0 and does not decrease; the rows of
/// one column are strictly increasing and below `n`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    column_starts: Vec<usize>,
    rows: Vec<usize>,
}

impl Pattern {
    /// From the rows of every column, in any order, with repetitions allowed.
    ///
    /// # Panics
    /// If a row is not below the number of columns: patterns are made by engines, not from input.
    pub fn from_columns(columns: impl IntoIterator<Item = Vec<usize>>) -> Self {
        let mut column_starts = vec![0];
        let mut rows = Vec::new();
        for mut column in columns {
            column.sort_unstable();
            column.dedup();
            rows.extend_from_slice(&column);
            column_starts.push(rows.len());
        }
        let n = column_starts.len() - 1;
        assert!(rows.iter().all(|&i| i < n), "a row of the pattern lies outside the matrix");
        Pattern { column_starts, rows }
    }

    /// From the columns of every row, in any order, with repetitions allowed.
    pub fn from_rows(row_columns: &[Vec<usize>]) -> Self {
        let mut columns = vec![Vec::new(); row_columns.len()];
        for (i, row) in row_columns.iter().enumerate() {
            for &j in row {
                columns[j].push(i);
            }
        }
        Self::from_columns(columns)
    }

    /// Every entry of an `n × n` matrix.
    pub fn dense(n: usize) -> Self {
        Self::from_columns((0..n).map(|_| (0..n).collect()))
    }

    /// Number of rows and columns.
    pub fn n(&self) -> usize {
        self.column_starts.len() - 1
    }

    /// Number of structural nonzeros: the length of every slice of values.
    pub fn nnz(&self) -> usize {
        self.rows.len()
    }

    /// Where each column starts in [`rows`](Self::rows); `n + 1` entries.
    pub fn column_starts(&self) -> &[usize] {
        &self.column_starts
    }

    /// Row of every structural nonzero, column by column.
    pub fn rows(&self) -> &[usize] {
        &self.rows
    }

    /// Positions of column `j` in a slice of values.
    pub fn column(&self, j: usize) -> Range<usize> {
        self.column_starts[j]..self.column_starts[j + 1]
    }

    /// Position of entry `(i, j)`, if it is a structural nonzero.
    pub fn position(&self, i: usize, j: usize) -> Option<usize> {
        let column = self.column(j);
        let start = column.start;
        self.rows[column].binary_search(&i).ok().map(|k| start + k)
    }

    /// All entries `(position, row, column)`, column by column.
    pub fn entries(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        (0..self.n()).flat_map(move |j| self.column(j).map(move |k| (k, self.rows[k], j)))
    }

    /// Position, row and column of the first of these values that is not finite.
    pub(crate) fn first_not_finite(&self, values: &[f64]) -> Option<(usize, usize, usize)> {
        let k = values.iter().position(|value| !value.is_finite())?;
        let column = self.column_starts.partition_point(|&start| start <= k) - 1;
        Some((k, self.rows[k], column))
    }

    /// Whether every entry is structurally nonzero.
    pub fn is_dense(&self) -> bool {
        self.nnz() == self.n() * self.n()
    }

    /// This pattern with the whole diagonal, where each old entry went, and where the diagonal is.
    pub fn with_diagonal(&self) -> WithDiagonal {
        let columns = (0..self.n()).map(|j| {
            let mut rows = self.rows[self.column(j)].to_vec();
            rows.push(j);
            rows
        });
        let pattern = Self::from_columns(columns);
        let entries = self.entries().filter_map(|(_, i, j)| pattern.position(i, j)).collect();
        let diagonal = (0..self.n()).filter_map(|j| pattern.position(j, j)).collect();
        WithDiagonal { pattern, entries, diagonal }
    }
}

/// A pattern that contains the diagonal: [`Pattern::with_diagonal`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WithDiagonal {
    /// The union of the old pattern and the diagonal.
    pub pattern: Pattern,
    /// New position of every old entry.
    pub entries: Vec<usize>,
    /// Position of every diagonal entry.
    pub diagonal: Vec<usize>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_sorted_and_free_of_repetitions() {
        let pattern = Pattern::from_rows(&[vec![1, 0, 1], vec![], vec![1]]);
        assert_eq!(pattern.column_starts(), [0, 1, 3, 3]);
        assert_eq!(pattern.rows(), [0, 0, 2]);
        assert_eq!(pattern.position(2, 1), Some(2));
        assert_eq!(pattern.position(1, 1), None);
        assert!(!pattern.is_dense());
        assert!(Pattern::dense(3).is_dense());
    }

    #[test]
    fn the_diagonal_is_added_once_and_old_entries_are_found_again() {
        let pattern = Pattern::from_rows(&[vec![0, 1], vec![0], vec![1]]);
        let with = pattern.with_diagonal();
        assert_eq!(with.pattern.nnz(), pattern.nnz() + 2);
        for (k, i, j) in pattern.entries() {
            assert_eq!(with.pattern.position(i, j), Some(with.entries[k]));
        }
        for j in 0..3 {
            assert_eq!(with.pattern.position(j, j), Some(with.diagonal[j]));
        }
    }
}
