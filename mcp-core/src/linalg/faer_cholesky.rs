//! [`FaerCholesky`]: sparse Cholesky by faer, for symmetric matrices.

use faer::dyn_stack::StackReq;
use faer::linalg::cholesky::ldlt::factor::{LdltError, LdltRegularization};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, LltRef, SymbolicCholesky, SymbolicCholeskyRaw,
    SymmetricOrdering, factorize_symbolic_cholesky, supernodal::SupernodalLltRef,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

use super::pivots::check_finite;
use super::storage::{KeptPattern, Scratch, try_filled};
use super::{FactorInfo, LinearError, LinearSolver};
use crate::problem::{Index, Pattern, small};

/// Sparse `H = L Lᵀ`, or `H = L D Lᵀ` where a pivot is not positive, for symmetric matrices, on one thread.
///
/// [`analyse`](LinearSolver::analyse) orders rows and columns by approximate minimum degree and finds
/// the pattern of `L`, once; [`factor`](LinearSolver::factor) reads the lower triangle alone and
/// allocates nothing. Against [`FaerSparseLu`](super::FaerSparseLu) on five-point grids it takes a
/// third to a fifth of the time and of the memory. \[GV13\] section 4.2, 11.1.
///
/// Pivots are taken from the diagonal in the order of the analysis, whatever their size. That is stable
/// for definite matrices; for quasi-definite ones, `[A Bᵀ; B −C]` with `A` and `C` positive definite, the
/// factors exist in every order ([Van95](crate#references)), but can be inaccurate, and others may have
/// none: the caller looks at the residual. A zero pivot is [`LinearError::Singular`]. The `pivot_ratio` is
/// `min_j |D_jj| / |H_jj|`, at most 1, with `D_jj = L_jj²` for `L Lᵀ`: what elimination left of the
/// diagonal, the same for `H` and `S H S` with any diagonal `S`.
#[derive(Debug, Default)]
pub struct FaerCholesky {
    pattern: KeptPattern,
    /// The lower triangle: starts and rows of its columns, and where in the pattern each begins.
    starts: Vec<Index>,
    rows: Vec<Index>,
    first: Vec<Index>,
    /// A column without a diagonal entry: its pivot may be zero whatever the values.
    without_diagonal: Option<usize>,
    lower: Vec<f64>,
    /// Absent for order 0.
    symbolic: Option<SymbolicCholesky<Index>>,
    factor: Vec<f64>,
    /// Whether the factors are `L D Lᵀ`.
    has_d: bool,
    scratch: Scratch,
}

impl FaerCholesky {
    /// For any order, without memory until [`analyse`](LinearSolver::analyse) is called.
    pub fn new() -> Self {
        FaerCholesky::default()
    }

    /// The lower triangle of the pattern: the end of every column.
    fn keep_lower(&mut self, pattern: &Pattern) {
        let n = pattern.n();
        self.without_diagonal = None;
        for list in [&mut self.starts, &mut self.rows, &mut self.first] {
            list.clear();
        }
        self.starts.reserve_exact(n + 1);
        self.rows.reserve_exact(pattern.nnz().midpoint(n));
        self.first.reserve_exact(n);
        self.starts.push(0);
        for j in 0..n {
            let column = pattern.column(j);
            let rows = &pattern.stored().1[column.clone()];
            let above = rows.partition_point(|&i| (i as usize) < j);
            if rows.get(above) != Some(&small(j)) {
                self.without_diagonal.get_or_insert(j);
            }
            self.first.push(small(column.start + above));
            self.rows.extend_from_slice(&rows[above..]);
            self.starts.push(small(self.rows.len()));
        }
    }

    /// `min_j |D_jj| / |H_jj|`, at most 1; NaN if a pivot is.
    fn pivot_ratio(&self) -> f64 {
        let Some(symbolic) = &self.symbolic else { return 1.0 };
        let order = symbolic.perm().map(|order| order.arrays().0);
        let mut smallest = 1.0_f64;
        let mut take = |place: usize, pivot: f64| {
            let j = order.map_or(place, |order| order[place] as usize);
            let pivot = if self.has_d { pivot.abs() } else { pivot * pivot };
            let ratio = pivot / self.lower[self.starts[j] as usize].abs();
            // NaN stays.
            if !(ratio >= smallest) {
                smallest = ratio;
            }
        };
        match symbolic.raw() {
            SymbolicCholeskyRaw::Simplicial(simplicial) => {
                for (place, &start) in simplicial.col_ptr()[..simplicial.ncols()].iter().enumerate()
                {
                    take(place, self.factor[start as usize]);
                }
            }
            SymbolicCholeskyRaw::Supernodal(supernodal) => {
                let factor = SupernodalLltRef::new(supernodal, &self.factor);
                for s in 0..supernodal.n_supernodes() {
                    let block = factor.supernode(s);
                    for k in 0..block.val().ncols() {
                        take(block.start() + k, block.val()[(k, k)]);
                    }
                }
            }
        }
        smallest
    }
}

impl LinearSolver for FaerCholesky {
    fn name(&self) -> &'static str {
        "faer sparse Cholesky"
    }

    fn needs_symmetry(&self) -> bool {
        true
    }

    fn analyse(&mut self, pattern: &Pattern) -> Result<(), LinearError> {
        if self.pattern.is(pattern) {
            return Ok(());
        }
        self.pattern.forget();
        self.symbolic = None;
        let n = pattern.n();
        self.keep_lower(pattern);
        self.lower = try_filled(0.0, self.rows.len(), n)?;
        self.factor = Vec::new();
        if n > 0 {
            let lower = SymbolicSparseColMatRef::new_checked(n, n, &self.starts, None, &self.rows);
            let parameters = CholeskySymbolicParams::default();
            let order = SymmetricOrdering::Amd;
            let symbolic = factorize_symbolic_cholesky(lower, Side::Lower, order, parameters)
                .map_err(|_| LinearError::OutOfMemory { n })?;
            let specification = faer::Spec::default();
            let request = StackReq::any_of(&[
                symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, specification),
                symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, faer::Spec::default()),
                symbolic.solve_in_place_scratch::<f64>(1, Par::Seq),
            ]);
            self.scratch = Scratch::try_new(request, n)?;
            self.factor = try_filled(0.0, symbolic.len_val(), n)?;
            self.symbolic = Some(symbolic);
        }
        self.pattern.keep(pattern);
        Ok(())
    }

    fn factor(&mut self, values: &[f64]) -> Result<FactorInfo, LinearError> {
        let n = self.pattern.get().n();
        assert_eq!(values.len(), self.pattern.get().nnz(), "one value for every entry");
        let Some(symbolic) = &self.symbolic else { return Ok(FactorInfo::new(1.0)) };
        if let Some(column) = self.without_diagonal {
            return Err(LinearError::Singular { column });
        }
        for (j, &first) in self.first.iter().enumerate() {
            let to = self.starts[j] as usize..self.starts[j + 1] as usize;
            let from = first as usize..first as usize + to.len();
            self.lower[to].copy_from_slice(&values[from]);
        }
        check_finite(&self.lower)?;
        let lower = SymbolicSparseColMatRef::new_checked(n, n, &self.starts, None, &self.rows);
        let lower = SparseColMatRef::new(lower, &self.lower);
        let may_be_definite = self.starts[..n].iter().all(|&d| self.lower[d as usize] > 0.0);
        self.has_d = !may_be_definite
            || symbolic
                .factorize_numeric_llt::<f64>(
                    &mut self.factor,
                    lower,
                    Side::Lower,
                    LltRegularization::default(),
                    Par::Seq,
                    self.scratch.stack(),
                    faer::Spec::default(),
                )
                .is_err();
        if self.has_d {
            let done = symbolic.factorize_numeric_ldlt::<f64>(
                &mut self.factor,
                lower,
                Side::Lower,
                LdltRegularization::default(),
                Par::Seq,
                self.scratch.stack(),
                faer::Spec::default(),
            );
            if let Err(LdltError::ZeroPivot { index }) = done {
                let place = index.min(n - 1);
                let column = symbolic.perm().map_or(place, |p| p.arrays().0[place] as usize);
                return Err(LinearError::Singular { column });
            }
        }
        let ratio = self.pivot_ratio();
        if ratio.is_finite() { Ok(FactorInfo::new(ratio)) } else { Err(LinearError::NotFinite) }
    }

    fn fill(&self) -> Option<usize> {
        Some(self.factor.len())
    }

    fn solve(&mut self, rhs: &mut [f64]) {
        let n = self.pattern.get().n();
        assert_eq!(rhs.len(), n, "one right-hand side for every row");
        let Some(symbolic) = &self.symbolic else { return };
        let x = MatMut::from_column_major_slice_mut(rhs, n, 1);
        let stack = self.scratch.stack();
        if self.has_d {
            let factor = LdltRef::new(symbolic, &self.factor);
            factor.solve_in_place_with_conj(Conj::No, x, Par::Seq, stack);
        } else {
            let factor = LltRef::new(symbolic, &self.factor);
            factor.solve_in_place_with_conj(Conj::No, x, Par::Seq, stack);
        }
    }

    fn solve_transposed(&mut self, rhs: &mut [f64]) {
        self.solve(rhs);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The five-point Laplacian on `k × k` nodes plus `shift` on the diagonal.
    fn laplacian(k: usize, shift: f64) -> (Pattern, Vec<f64>) {
        let neighbours = |p: usize| {
            let (i, j) = (p / k, p % k);
            let mut near = vec![p];
            near.extend((i > 0).then(|| p - k));
            near.extend((i + 1 < k).then(|| p + k));
            near.extend((j > 0).then(|| p - 1));
            near.extend((j + 1 < k).then(|| p + 1));
            near
        };
        let pattern = Pattern::from_columns((0..k * k).map(neighbours));
        let value = |i, j| if i == j { 4.0 + shift } else { -1.0 };
        let values = pattern.entries().map(|(_, i, j)| value(i, j)).collect();
        (pattern, values)
    }

    #[test]
    fn solutions_satisfy_the_system_with_either_kind_of_factors() {
        for k in [1, 3, 40] {
            let (pattern, values) = laplacian(k, 0.5);
            let mut cholesky = FaerCholesky::new();
            cholesky.analyse(&pattern).unwrap();
            let info = cholesky.factor(&values).unwrap();
            assert!(info.pivot_ratio > 0.1 && info.pivot_ratio <= 1.0);
            let b: Vec<f64> = (0..k * k).map(|i| (i as f64 * 0.7).sin()).collect();
            let mut x = b.clone();
            cholesky.solve(&mut x);
            let mut residual = b;
            for (p, i, j) in pattern.entries() {
                residual[i] -= values[p] * x[j];
            }
            assert!(residual.iter().all(|r| r.abs() < 1e-14), "{k}");
        }
    }

    #[test]
    fn a_quasi_definite_matrix_has_factors_with_d_and_a_definite_one_afterwards_none() {
        let (pattern, values) = laplacian(12, 0.0);
        let sign = |i: usize| if i.is_multiple_of(3) { -1.0 } else { 1.0 };
        // [A Bᵀ; B −C]: rows of one sign changed, and their couplings with the others kept.
        let mut mixed = values.clone();
        for (k, i, j) in pattern.entries() {
            if sign(i) < 0.0 && sign(j) < 0.0 {
                mixed[k] = -mixed[k];
            }
        }
        let mut cholesky = FaerCholesky::new();
        cholesky.analyse(&pattern).unwrap();
        for (values, has_d) in [(&mixed, true), (&values, false)] {
            cholesky.factor(values).unwrap();
            assert_eq!(cholesky.has_d, has_d);
            let mut x = vec![1.0; 144];
            cholesky.solve(&mut x);
            let mut residual = vec![1.0; 144];
            for (p, i, j) in pattern.entries() {
                residual[i] -= values[p] * x[j];
            }
            assert!(residual.iter().all(|r| r.abs() < 1e-13));
        }
    }

    #[test]
    fn a_missing_diagonal_entry_is_a_zero_pivot() {
        let mut cholesky = FaerCholesky::new();
        cholesky.analyse(&Pattern::from_columns([vec![0, 1], vec![0]])).unwrap();
        let refused = cholesky.factor(&[1.0, 0.5, 0.5]);
        assert_eq!(refused, Err(LinearError::Singular { column: 1 }));
    }

    #[test]
    fn the_pivot_ratio_does_not_depend_on_diagonal_scaling() {
        let (pattern, mut values) = laplacian(9, 0.25);
        let mut cholesky = FaerCholesky::new();
        cholesky.analyse(&pattern).unwrap();
        let plain = cholesky.factor(&values).unwrap();
        for (k, i, j) in pattern.entries() {
            let scale = |i: usize| [1.0, 16.0, 0.25, 2.0][i % 4];
            values[k] *= scale(i) * scale(j);
        }
        assert_eq!(cholesky.factor(&values).unwrap(), plain);
    }
}
