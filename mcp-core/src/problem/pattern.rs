//! [`Pattern`]: where a Jacobian can be different from zero.

use std::ops::Range;
use std::sync::Arc;

/// Rows, columns and positions as they are stored: half the memory of `usize`.
pub(crate) type Index = u32;

/// Order above which the diagonal of a pattern that has it is looked up instead of listed.
const LONG: usize = 4096;

/// An index as it is stored.
///
/// # Panics
/// From 2³² on: a matrix with as many entries takes 50 GB before it is factored.
pub(crate) fn small(index: usize) -> Index {
    Index::try_from(index).expect("fewer than 2^32 structural nonzeros")
}

/// The structural nonzeros of a square matrix, compressed by columns.
///
/// One pattern belongs to a problem for good; every Jacobian is a slice of values in its order.
/// Invariants: `column_starts` has `n + 1` entries, starts at 0 and does not decrease; the rows of
/// one column are strictly increasing and below `n`; there are fewer than 2³² of them. A clone shares
/// the entries.
#[derive(Clone, Debug, Eq)]
pub struct Pattern {
    entries: Arc<Entries>,
}

#[derive(Debug, PartialEq, Eq)]
struct Entries {
    column_starts: Vec<Index>,
    rows: Vec<Index>,
}

impl PartialEq for Pattern {
    /// Clones are equal at once.
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.entries, &other.entries) || self.entries == other.entries
    }
}

impl Pattern {
    fn new(column_starts: Vec<Index>, rows: Vec<Index>) -> Self {
        Pattern { entries: Arc::new(Entries { column_starts, rows }) }
    }

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
            rows.extend(column.into_iter().map(small));
            column_starts.push(small(rows.len()));
        }
        let n = column_starts.len() - 1;
        assert!(
            rows.iter().all(|&i| (i as usize) < n),
            "a row of the pattern lies outside the matrix"
        );
        Self::new(column_starts, rows)
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

    /// From the columns of every row, given as a list without repetitions; `row(i, put)` calls `put`
    /// for each of them, the same in both passes. Two sweeps, no list for each row.
    pub(crate) fn from_row_lists(n: usize, row: impl Fn(usize, &mut dyn FnMut(usize))) -> Self {
        let mut starts: Vec<Index> = vec![0; n + 1];
        for i in 0..n {
            row(i, &mut |j| starts[j + 1] += 1);
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start as usize;
            *start = small(sum);
        }
        let mut rows: Vec<Index> = vec![0; sum];
        // While column j is filled, starts[j] is where its next entry goes: at last the next start.
        for i in 0..n {
            row(i, &mut |j| {
                rows[starts[j] as usize] = small(i);
                starts[j] += 1;
            });
        }
        starts.rotate_right(1);
        starts[0] = 0;
        Self::new(starts, rows)
    }

    /// Every entry of an `n × n` matrix.
    pub fn dense(n: usize) -> Self {
        Self::from_columns((0..n).map(|_| (0..n).collect()))
    }

    /// Number of rows and columns.
    pub fn n(&self) -> usize {
        self.entries.column_starts.len() - 1
    }

    /// Number of structural nonzeros: the length of every slice of values.
    pub fn nnz(&self) -> usize {
        self.entries.rows.len()
    }

    /// Row of the structural nonzero at position `k`.
    #[inline]
    pub fn row(&self, k: usize) -> usize {
        self.entries.rows[k] as usize
    }

    /// Row of every structural nonzero, column by column.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = usize> + '_ {
        self.entries.rows.iter().map(|&i| i as usize)
    }

    /// Positions of column `j` in a slice of values.
    #[inline]
    pub fn column(&self, j: usize) -> Range<usize> {
        self.entries.column_starts[j] as usize..self.entries.column_starts[j + 1] as usize
    }

    /// Rows of the structural nonzeros of column `j`, increasing.
    pub fn column_rows(&self, j: usize) -> impl ExactSizeIterator<Item = usize> + '_ {
        self.entries.rows[self.column(j)].iter().map(|&i| i as usize)
    }

    /// Position of entry `(i, j)`, if it is a structural nonzero.
    pub fn position(&self, i: usize, j: usize) -> Option<usize> {
        let column = self.column(j);
        let start = column.start;
        let place = self.entries.rows[column].binary_search(&Index::try_from(i).ok()?);
        place.ok().map(|k| start + k)
    }

    /// As it is stored: where each column starts, `n + 1` entries, and the row of every nonzero.
    pub(crate) fn stored(&self) -> (&[Index], &[Index]) {
        (&self.entries.column_starts, &self.entries.rows)
    }

    /// All entries `(position, row, column)`, column by column.
    pub fn entries(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        (0..self.n()).flat_map(move |j| self.column(j).map(move |k| (k, self.row(k), j)))
    }

    /// Position, row and column of the first of these values that is not finite.
    pub(crate) fn first_not_finite(&self, values: &[f64]) -> Option<(usize, usize, usize)> {
        let k = values.iter().position(|value| !value.is_finite())?;
        let starts = &self.entries.column_starts;
        let column = starts.partition_point(|&start| start as usize <= k) - 1;
        Some((k, self.row(k), column))
    }

    /// `sizes_i += Σ_j |v_ij w_j|`: how large the terms of the rows are.
    pub(crate) fn add_sizes(
        &self,
        values: &[f64],
        weight: impl Fn(usize) -> f64,
        sizes: &mut [f64],
    ) {
        for j in 0..self.n() {
            let w = weight(j).abs();
            for k in self.column(j) {
                sizes[self.row(k)] += values[k].abs() * w;
            }
        }
    }

    /// Whether every entry is structurally nonzero.
    pub fn is_dense(&self) -> bool {
        self.nnz() == self.n() * self.n()
    }

    /// Whether the pattern is its own transpose. `O(nnz)`.
    pub fn is_symmetric(&self) -> bool {
        // Columns are swept in order, so the partners in each column come in order too.
        let mut next = self.entries.column_starts[..self.n()].to_vec();
        self.entries().all(|(_, i, j)| {
            let partner = next[i] as usize;
            next[i] += 1;
            partner < self.column(i).end && self.row(partner) == j
        })
    }

    /// This pattern with the whole diagonal, where each old entry went, and where the diagonal is.
    pub fn with_diagonal(&self) -> WithDiagonal {
        if (0..self.n()).all(|j| self.position(j, j).is_some()) {
            let listed = if self.n() > LONG { 0 } else { self.n() };
            let diagonal = (0..listed).filter_map(|j| self.position(j, j).map(small)).collect();
            return WithDiagonal { pattern: self.clone(), entries: None, diagonal };
        }
        let columns = (0..self.n()).map(|j| self.column_rows(j).chain([j]).collect());
        let pattern = Self::from_columns(columns);
        let place = |i, j| pattern.position(i, j).map(small);
        let entries = Some(self.entries().filter_map(|(_, i, j)| place(i, j)).collect());
        let diagonal = (0..self.n()).filter_map(|j| place(j, j)).collect();
        WithDiagonal { pattern, entries, diagonal }
    }
}

/// A pattern that contains the diagonal: [`Pattern::with_diagonal`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WithDiagonal {
    pattern: Pattern,
    /// New position of every old entry; `None` if the old pattern had the diagonal.
    entries: Option<Vec<Index>>,
    /// Empty where it is looked up.
    diagonal: Vec<Index>,
}

impl WithDiagonal {
    /// The union of the old pattern and the diagonal.
    pub fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// Whether the old pattern had the diagonal: every entry keeps its position.
    pub fn is_unchanged(&self) -> bool {
        self.entries.is_none()
    }

    /// New position of old entry `k`.
    #[inline]
    pub fn entry(&self, k: usize) -> usize {
        self.entries.as_ref().map_or(k, |entries| entries[k] as usize)
    }

    /// Position of the diagonal entry of column `j`.
    ///
    /// # Panics
    /// If there is no column `j`.
    #[inline]
    pub fn diagonal(&self, j: usize) -> usize {
        match self.diagonal.get(j) {
            Some(&k) => k as usize,
            None => self.pattern.position(j, j).expect("the pattern has the diagonal"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_sorted_and_free_of_repetitions() {
        let pattern = Pattern::from_rows(&[vec![1, 0, 1], vec![], vec![1]]);
        assert_eq!(pattern.stored(), (&[0, 1, 3, 3][..], &[0, 0, 2][..]));
        assert_eq!(pattern.column_rows(1).collect::<Vec<_>>(), [0, 2]);
        assert_eq!(pattern.position(2, 1), Some(2));
        assert_eq!(pattern.position(1, 1), None);
        assert!(!pattern.is_dense());
        assert!(Pattern::dense(3).is_dense());
    }

    #[test]
    fn lists_of_rows_give_the_same_pattern_as_vectors() {
        let rows = [vec![0, 2], vec![], vec![3, 1, 0], vec![2]];
        let listed =
            Pattern::from_row_lists(4, |i, put| rows[i].iter().copied().for_each(&mut *put));
        assert_eq!(listed, Pattern::from_rows(&rows));
        assert_eq!(Pattern::from_row_lists(0, |_, _| ()), Pattern::dense(0));
    }

    #[test]
    fn a_pattern_is_symmetric_if_every_entry_has_its_partner() {
        assert!(Pattern::from_rows(&[vec![1, 3], vec![0, 1], vec![], vec![0]]).is_symmetric());
        for rows in [[vec![1], vec![]], [vec![], vec![0]], [vec![0, 1], vec![1]]] {
            assert!(!Pattern::from_rows(&rows).is_symmetric());
        }
    }

    #[test]
    fn a_complete_diagonal_leaves_the_pattern_as_it_is() {
        let pattern = Pattern::from_rows(&[vec![0, 1], vec![1]]);
        let with = pattern.with_diagonal();
        assert_eq!(*with.pattern(), pattern);
        assert!(with.is_unchanged());
        assert_eq!([0, 1, 2].map(|k| with.entry(k)), [0, 1, 2]);
        assert_eq!([0, 1].map(|j| with.diagonal(j)), [0, 2]);
    }

    #[test]
    fn a_matrix_without_entries_gets_its_diagonal() {
        let with = Pattern::from_rows(&[vec![], vec![]]).with_diagonal();
        assert!(!with.is_unchanged());
        assert_eq!(with.pattern().nnz(), 2);
    }

    #[test]
    fn the_diagonal_is_added_once_and_old_entries_are_found_again() {
        let pattern = Pattern::from_rows(&[vec![0, 1], vec![0], vec![1]]);
        let with = pattern.with_diagonal();
        assert_eq!(with.pattern.nnz(), pattern.nnz() + 2);
        for (k, i, j) in pattern.entries() {
            assert_eq!(with.pattern.position(i, j), Some(with.entry(k)));
        }
        for j in 0..3 {
            assert_eq!(with.pattern.position(j, j), Some(with.diagonal(j)));
        }
    }
}
