//! [`FaerDenseLu`]: dense LU by faer's blocked kernels.

use faer::dyn_stack::StackReq;
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::perm::PermRef;
use faer::{MatMut, MatRef, Par};

use super::pivots::{PivotRange, check_finite};
use super::storage::{KeptPattern, Scratch, scatter_column, try_filled};
use super::{FactorInfo, LinearError, LinearSolver};
use crate::problem::Pattern;

/// Dense LU with partial pivoting for hundreds of unknowns and more, blocked and recursive, on one
/// thread.
///
/// Factor `2n³/3`, solve `2n²` flops, memory `n²` numbers, all of it allocated by
/// [`analyse`](LinearSolver::analyse). Below 40 unknowns [`NalgebraLu`](super::NalgebraLu) is
/// faster. \[GV13\] section 3.4 (partial pivoting) and 3.2 (blocks).
///
/// Pivots are used through their reciprocals: one whose reciprocal overflows counts as zero.
///
/// \[GV13\]: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., 2013.
#[derive(Debug)]
pub struct FaerDenseLu {
    pattern: KeptPattern,
    /// Column-major: `L` without its unit diagonal below, `U` on and above the diagonal.
    factors: Vec<f64>,
    /// Row of the matrix in every row of the factors.
    rows: Vec<usize>,
    /// The inverse of `rows`.
    rows_inverse: Vec<usize>,
    scratch: Scratch,
}

impl FaerDenseLu {
    /// For any order, without memory until [`analyse`](LinearSolver::analyse) is called.
    pub fn new() -> Self {
        FaerDenseLu {
            pattern: KeptPattern::default(),
            factors: Vec::new(),
            rows: Vec::new(),
            rows_inverse: Vec::new(),
            scratch: Scratch::empty(),
        }
    }
}

impl Default for FaerDenseLu {
    fn default() -> Self {
        Self::new()
    }
}

impl LinearSolver for FaerDenseLu {
    fn name(&self) -> &'static str {
        "faer dense LU"
    }

    fn analyse(&mut self, pattern: &Pattern) -> Result<(), LinearError> {
        if self.pattern.is(pattern) {
            return Ok(());
        }
        self.pattern.forget();
        let n = pattern.n();
        let entries = n.checked_mul(n).ok_or(LinearError::OutOfMemory { n })?;
        self.factors = try_filled(0.0, entries, n)?;
        self.rows = try_filled(0, n, n)?;
        self.rows_inverse = try_filled(0, n, n)?;
        for (i, (row, inverse)) in self.rows.iter_mut().zip(&mut self.rows_inverse).enumerate() {
            (*row, *inverse) = (i, i);
        }
        let parameters = faer::Spec::default();
        let request = StackReq::any_of(&[
            factor::lu_in_place_scratch::<usize, f64>(n, n, Par::Seq, parameters),
            solve::solve_in_place_scratch::<usize, f64>(n, 1, Par::Seq),
            solve::solve_transpose_in_place_scratch::<usize, f64>(n, 1, Par::Seq),
        ]);
        self.scratch = Scratch::try_new(request, n)?;
        self.pattern.keep(pattern);
        Ok(())
    }

    fn factor(&mut self, values: &[f64]) -> Result<FactorInfo, LinearError> {
        let pattern = self.pattern.get();
        assert_eq!(values.len(), pattern.nnz(), "one value for every entry of the pattern");
        check_finite(values)?;
        let n = pattern.n();
        for (j, column) in self.factors.chunks_exact_mut(n.max(1)).enumerate() {
            scatter_column(pattern, values, j, column);
        }
        factor::lu_in_place(
            MatMut::from_column_major_slice_mut(&mut self.factors, n, n),
            &mut self.rows,
            &mut self.rows_inverse,
            Par::Seq,
            self.scratch.stack(),
            faer::Spec::default(),
        );
        // faer divides by a zero pivot and goes on: the columns before it are right, the first bad
        // diagonal entry is the pivot itself.
        let mut pivots = PivotRange::new();
        for k in 0..n {
            pivots.take(self.factors[k * (n + 1)], k)?;
        }
        Ok(pivots.info())
    }

    fn solve(&mut self, rhs: &mut [f64]) {
        let n = self.rows.len();
        let factors = MatRef::from_column_major_slice(&self.factors, n, n);
        solve::solve_in_place(
            factors,
            factors,
            PermRef::new_checked(&self.rows, &self.rows_inverse, n),
            MatMut::from_column_major_slice_mut(rhs, n, 1),
            Par::Seq,
            self.scratch.stack(),
        );
    }

    fn solve_transposed(&mut self, rhs: &mut [f64]) {
        let n = self.rows.len();
        let factors = MatRef::from_column_major_slice(&self.factors, n, n);
        solve::solve_transpose_in_place(
            factors,
            factors,
            PermRef::new_checked(&self.rows, &self.rows_inverse, n),
            MatMut::from_column_major_slice_mut(rhs, n, 1),
            Par::Seq,
            self.scratch.stack(),
        );
    }
}
