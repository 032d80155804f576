//! [`NalgebraLu`]: dense LU from nalgebra's column kernels.

use nalgebra::{DMatrix, DVectorViewMut};

use super::pivots::{PivotRange, check_finite};
use super::storage::{KeptPattern, scatter_column, try_filled};
use super::{FactorInfo, LinearError, LinearSolver};
use crate::problem::Pattern;

/// Dense LU with partial pivoting for some tens of unknowns, unblocked.
///
/// The steps of nalgebra's `LU::new` on a matrix kept between factorisations, so that nothing is
/// allocated after [`analyse`](LinearSolver::analyse). Factor `2n³/3`, solve `2n²` flops, memory
/// `n²` numbers. Any order is right, but the blocked
/// [`FaerDenseLu`](super::FaerDenseLu) is faster from 40 to 100 unknowns on, by the width of the
/// processor's vectors. \[GV13\] Alg. 3.4.1.
///
/// Pivots are used through their reciprocals: one whose reciprocal overflows counts as zero.
///
/// \[GV13\]: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., 2013.
#[derive(Clone, Debug, Default)]
pub struct NalgebraLu {
    pattern: KeptPattern,
    /// `L` without its unit diagonal below, `U` on and above the diagonal.
    factors: DMatrix<f64>,
    /// Row exchanged with row `k` in step `k`.
    exchanges: Vec<usize>,
}

impl NalgebraLu {
    /// For any order, without memory until [`analyse`](LinearSolver::analyse) is called.
    pub fn new() -> Self {
        Self::default()
    }
}

impl LinearSolver for NalgebraLu {
    fn name(&self) -> &'static str {
        "nalgebra dense LU"
    }

    fn analyse(&mut self, pattern: &Pattern) -> Result<(), LinearError> {
        if self.pattern.is(pattern) {
            return Ok(());
        }
        self.pattern.forget();
        let n = pattern.n();
        let entries = n.checked_mul(n).ok_or(LinearError::OutOfMemory { n })?;
        self.factors = DMatrix::from_vec(n, n, try_filled(0.0, entries, n)?);
        self.exchanges = try_filled(0, n, n)?;
        self.pattern.keep(pattern);
        Ok(())
    }

    fn factor(&mut self, values: &[f64]) -> Result<FactorInfo, LinearError> {
        let pattern = self.pattern.get();
        assert_eq!(values.len(), pattern.nnz(), "one value for every entry of the pattern");
        check_finite(values)?;
        let n = pattern.n();
        let a = &mut self.factors;
        for (j, column) in a.as_mut_slice().chunks_exact_mut(n.max(1)).enumerate() {
            scatter_column(pattern, values, j, column);
        }
        let mut pivots = PivotRange::new();
        for k in 0..n {
            let p = a.view_range(k.., k).icamax() + k;
            let reciprocal = pivots.take(a[(p, k)], k)?;
            self.exchanges[k] = p;
            if p != k {
                a.swap_rows(k, p);
            }
            let (mut left, mut right) = a.columns_range_pair_mut(k, k + 1..);
            let mut multipliers = left.rows_range_mut(k + 1..);
            multipliers *= reciprocal;
            for mut column in right.column_iter_mut() {
                let u = column[k];
                column.rows_range_mut(k + 1..).axpy(-u, &multipliers, 1.0);
            }
        }
        Ok(pivots.info())
    }

    fn solve(&mut self, rhs: &mut [f64]) {
        assert_eq!(rhs.len(), self.exchanges.len(), "one right-hand side for every row");
        for (k, &p) in self.exchanges.iter().enumerate() {
            rhs.swap(k, p);
        }
        let n = rhs.len();
        if n == 0 {
            return; // nalgebra's substitution takes at least one row
        }
        let mut x = DVectorViewMut::from_slice(rhs, n);
        self.factors.solve_lower_triangular_with_diag_mut(&mut x, 1.0);
        self.factors.solve_upper_triangular_unchecked_mut(&mut x);
    }

    fn solve_transposed(&mut self, rhs: &mut [f64]) {
        let n = self.exchanges.len();
        assert_eq!(rhs.len(), n, "one right-hand side for every column");
        let mut x = DVectorViewMut::from_slice(rhs, n);
        self.factors.tr_solve_upper_triangular_unchecked_mut(&mut x);
        for k in (0..n).rev() {
            let below = self.factors.view_range(k + 1.., k).dot(&x.rows_range(k + 1..));
            x[k] -= below;
        }
        for (k, &p) in self.exchanges.iter().enumerate().rev() {
            rhs.swap(k, p);
        }
    }
}
