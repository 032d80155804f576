//! [`SparseRows`]: a matrix row by row, its zeros left out.

use crate::scalar::Scalar;

/// The nonzero entries of a matrix, row by row.
#[derive(Clone, Debug)]
pub(super) struct SparseRows<D = f64> {
    starts: Vec<usize>,
    columns: Vec<usize>,
    pub(super) values: Vec<D>,
}

impl<D: Scalar> SparseRows<D> {
    /// Entries at these columns of every row, all 0.
    pub(super) fn with_columns(rows: &[Vec<usize>]) -> Self {
        let (mut starts, mut columns) = (vec![0], Vec::new());
        for row in rows {
            columns.extend_from_slice(row);
            starts.push(columns.len());
        }
        let values = vec![D::constant(0.0); columns.len()];
        SparseRows { starts, columns, values }
    }

    /// Columns and values of row `i`.
    pub(super) fn row(&self, i: usize) -> impl DoubleEndedIterator<Item = (usize, D)> + '_ {
        let entries = self.starts[i]..self.starts[i + 1];
        entries.map(|k| (self.columns[k], self.values[k]))
    }

    /// Columns and values of row `i`, the values to be changed.
    pub(super) fn row_mut(&mut self, i: usize) -> impl Iterator<Item = (usize, &mut D)> {
        let entries = self.starts[i]..self.starts[i + 1];
        self.columns[entries.clone()].iter().copied().zip(&mut self.values[entries])
    }
}

impl SparseRows {
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

    /// The same entries in another arithmetic, all 0.
    pub(super) fn zeros_like<D: Scalar>(&self) -> SparseRows<D> {
        let (starts, columns) = (self.starts.clone(), self.columns.clone());
        SparseRows { starts, columns, values: vec![D::constant(0.0); self.values.len()] }
    }

    /// `Σ_j A_ij x_j`; `None` for an empty row.
    #[inline]
    pub(super) fn times<D: Scalar>(&self, i: usize, x: impl Fn(usize) -> D) -> Option<D> {
        self.row(i).map(|(j, a)| x(j).scale(a)).reduce(|sum, term| sum + term)
    }
}
