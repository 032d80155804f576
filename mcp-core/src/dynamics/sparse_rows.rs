//! [`SparseRows`]: a matrix row by row, its zeros left out.

use crate::scalar::Scalar;

/// The nonzero entries of a matrix, row by row.
#[derive(Clone, Debug, Default)]
pub(super) struct SparseRows {
    starts: Vec<usize>,
    columns: Vec<usize>,
    pub(super) values: Vec<f64>,
}

impl SparseRows {
    /// Entries at these columns of every row, all 0.
    pub(super) fn with_columns(rows: &[Vec<usize>]) -> Self {
        let mut matrix = SparseRows { starts: vec![0], ..SparseRows::default() };
        for row in rows {
            matrix.columns.extend_from_slice(row);
            matrix.starts.push(matrix.columns.len());
        }
        matrix.values.resize(matrix.columns.len(), 0.0);
        matrix
    }

    /// Entries of a full matrix that are not zero.
    pub(super) fn from_dense(rows: &[Vec<f64>]) -> Self {
        let nonzero = |row: &Vec<f64>| (0..row.len()).filter(|&j| row[j] != 0.0).collect();
        let mut matrix = Self::with_columns(&rows.iter().map(nonzero).collect::<Vec<_>>());
        let entries = rows.iter().flatten().filter(|&&entry| entry != 0.0);
        for (value, &entry) in matrix.values.iter_mut().zip(entries) {
            *value = entry;
        }
        matrix
    }

    /// Column and value of the entries of row `i`.
    pub(super) fn row(&self, i: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let entries = self.starts[i]..self.starts[i + 1];
        entries.map(|k| (self.columns[k], self.values[k]))
    }

    /// Columns and values of row `i`, the values to be changed.
    pub(super) fn row_mut(&mut self, i: usize) -> impl Iterator<Item = (usize, &mut f64)> {
        let entries = self.starts[i]..self.starts[i + 1];
        self.columns[entries.clone()].iter().copied().zip(&mut self.values[entries])
    }

    /// `Σ_j A_ij x_j`; the constant 0 for an empty row.
    #[inline]
    pub(super) fn times<D: Scalar>(&self, i: usize, x: impl Fn(usize) -> D) -> D {
        let mut terms = self.row(i).map(|(j, a)| x(j).scale(a));
        match terms.next() {
            Some(first) => terms.fold(first, |sum, term| sum + term),
            None => D::constant(0.0),
        }
    }
}
