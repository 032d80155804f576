//! [`FaerSparseLu`]: sparse LU by faer, in the COLAMD order of its columns.

use faer::dyn_stack::StackReq;
use faer::perm::PermRef;
use faer::sparse::linalg::lu::simplicial::{
    SimplicialLu, factorize_simplicial_numeric_lu, factorize_simplicial_numeric_lu_scratch,
};
use faer::sparse::linalg::lu::{
    LuRef, LuSymbolicParams, NumericLu, SymbolicLu, factorize_symbolic_lu,
};
use faer::sparse::linalg::{LuError, SupernodalThreshold};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par};

use super::pivots::{PivotRange, check_finite};
use super::storage::{KeptPattern, Scratch, try_filled};
use super::{FactorInfo, LinearError, LinearSolver};
use crate::problem::{Index, Pattern};

/// Orders below this get simplicial factors: blocks do not pay there.
const SUPERNODAL_FROM: usize = 16;

/// Supernodal factors are chosen above this multiple of faer's own threshold, the flops per nonzero
/// of the factors. Measured on grids, bands, blocks and random patterns of 150 to 90 000 unknowns:
/// 1 loses up to a factor 7 on some, 0.03 a factor 4 on tridiagonal ones.
const SUPERNODAL_RATIO: f64 = 0.15;

/// Sparse LU with partial pivoting, on one thread.
///
/// [`analyse`](LinearSolver::analyse) orders the columns by COLAMD and lets faer choose between two
/// kinds of factors by an estimate of their fill:
///
/// * *simplicial*, one column at a time, for factors that stay very sparse. Memory is kept: a
///   factorisation allocates only when its fill exceeds that of all before it.
/// * *supernodal*, dense blocks of columns, for factors that fill. The factors are kept; faer
///   allocates its update matrices anew in every factorisation.
///
/// Solves allocate nothing. A factorisation costs the fill's flops, about `n^1.5` of them on grids
/// in the plane; memory is the fill's. \[GV13\] section 11.1 has the sparse direct methods.
///
/// Pivots are used through their reciprocals: one whose reciprocal overflows counts as zero.
/// faer does not show the pivots of supernodal factors. They are tested by solving once with a
/// fixed right-hand side `b`, which a zero pivot turns into NaN or infinity; then the simplicial
/// factorisation, several times slower, is run as well and gives the verdict and the column. The
/// `pivot_ratio` of supernodal factors is `|b| / (|H| |H⁻¹ b|)` in the 1-norm: up to rounding an
/// upper bound of the reciprocal condition number.
///
/// \[GV13\]: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., 2013.
#[derive(Debug)]
pub struct FaerSparseLu {
    pattern: KeptPattern,
    /// Whether factors may be supernodal.
    may_block: bool,
    /// Absent for order 0.
    symbolic: Option<SymbolicLu<Index>>,
    kind: Kind,
    /// Which factors solves use: those of the last factorisation.
    current: Kind,
    simplicial: Simplicial,
    supernodal: NumericLu<Index, f64>,
    /// The right-hand side of the test of supernodal factors.
    probe: Vec<f64>,
    /// Its solution.
    response: Vec<f64>,
    scratch: Scratch,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Simplicial,
    Supernodal,
}

/// Simplicial factors with their permutation of the rows.
#[derive(Clone, Debug, Default)]
struct Simplicial {
    lu: SimplicialLu<Index, f64>,
    rows: Vec<Index>,
    rows_inverse: Vec<Index>,
}

impl FaerSparseLu {
    /// For any order, without memory until [`analyse`](LinearSolver::analyse) is called.
    pub fn new() -> Self {
        FaerSparseLu {
            pattern: KeptPattern::default(),
            may_block: true,
            symbolic: None,
            kind: Kind::Simplicial,
            current: Kind::Simplicial,
            simplicial: Simplicial::default(),
            supernodal: NumericLu::new(),
            probe: Vec::new(),
            response: Vec::new(),
            scratch: Scratch::empty(),
        }
    }

    /// The same with simplicial factors alone: slower where they fill, and their fill is known.
    pub fn simplicial() -> Self {
        FaerSparseLu { may_block: false, ..Self::new() }
    }

    fn analyse_anew(
        &mut self,
        pattern: &Pattern,
        threshold: SupernodalThreshold,
    ) -> Result<(), LinearError> {
        self.pattern.forget();
        self.symbolic = None;
        // faer's factors do not shrink to a smaller order.
        self.simplicial = Simplicial::default();
        self.supernodal = NumericLu::new();
        let n = pattern.n();
        if n > 0 {
            let parameters = LuSymbolicParams {
                supernodal_flop_ratio_threshold: threshold,
                ..Default::default()
            };
            let symbolic = factorize_symbolic_lu(structure(pattern), parameters)
                .map_err(|_| LinearError::OutOfMemory { n })?;
            let simplicial = factorize_simplicial_numeric_lu_scratch::<Index, f64>(n, n);
            let chosen =
                symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, faer::Spec::default());
            // faer keeps its choice to itself. Supernodal factors ask for 32 bytes per unknown more
            // at least, which beats the alignment from order 8 on.
            self.kind = if chosen == simplicial { Kind::Simplicial } else { Kind::Supernodal };
            let request = StackReq::any_of(&[
                simplicial,
                chosen,
                symbolic.solve_in_place_scratch::<f64>(1, Par::Seq),
                symbolic.solve_transpose_in_place_scratch::<f64>(1, Par::Seq),
            ]);
            self.scratch = Scratch::try_new(request, n)?;
            if self.kind == Kind::Supernodal {
                self.probe = try_filled(0.0, n, n)?;
                self.response = try_filled(0.0, n, n)?;
                fill_probe(&mut self.probe);
            }
            self.symbolic = Some(symbolic);
        }
        self.pattern.keep(pattern);
        Ok(())
    }

    /// Supernodal factors and their test. `None`: a pivot may be zero.
    fn factor_supernodal(&mut self, values: &[f64]) -> Result<Option<FactorInfo>, LinearError> {
        let pattern = self.pattern.get();
        let symbolic = self.symbolic.as_ref().expect("analysed matrices of order > 0 have one");
        let stack = self.scratch.stack();
        let matrix = matrix(pattern, values);
        let done = symbolic.factorize_numeric_lu(
            &mut self.supernodal,
            matrix,
            Par::Seq,
            stack,
            faer::Spec::default(),
        );
        match done {
            Err(LuError::SymbolicSingular { .. }) => return Ok(None),
            Err(LuError::Generic(_)) => return Err(LinearError::OutOfMemory { n: pattern.n() }),
            Ok(lu) => {
                self.response.copy_from_slice(&self.probe);
                let x = MatMut::from_column_major_slice_mut(&mut self.response, pattern.n(), 1);
                lu.solve_in_place_with_conj(Conj::No, x, Par::Seq, stack);
            }
        }
        if check_finite(&self.response).is_err() {
            return Ok(None);
        }
        let norm = (0..pattern.n()).map(|j| norm_1(&values[pattern.column(j)])).fold(0.0, f64::max);
        let ratio = norm_1(&self.probe) / norm / norm_1(&self.response);
        Ok(Some(FactorInfo::new(ratio.min(1.0))))
    }

    /// Simplicial factors and their pivots.
    fn factor_simplicial(&mut self, values: &[f64]) -> Result<FactorInfo, LinearError> {
        let pattern = self.pattern.get();
        let n = pattern.n();
        let symbolic = self.symbolic.as_ref().expect("analysed matrices of order > 0 have one");
        let order = symbolic.col_perm();
        let Simplicial { lu, rows, rows_inverse } = &mut self.simplicial;
        if rows.len() != n {
            *rows = try_filled(0, n, n)?;
            *rows_inverse = try_filled(0, n, n)?;
        }
        let done = factorize_simplicial_numeric_lu(
            rows,
            rows_inverse,
            lu,
            matrix(pattern, values),
            order,
            self.scratch.stack(),
        );
        match done {
            Err(LuError::SymbolicSingular { index }) => {
                return Err(LinearError::Singular { column: order.arrays().0[index] as usize });
            }
            Err(LuError::Generic(_)) => return Err(LinearError::OutOfMemory { n }),
            Ok(()) => {}
        }
        let (l, u) = (lu.l_factor_unsorted(), lu.u_factor_unsorted());
        let mut pivots = PivotRange::new();
        for j in 0..n {
            let (above, below) = (u.val_of_col(j), l.val_of_col(j));
            let pivot = above.last().copied().unwrap_or(0.0);
            pivots.take(pivot, order.arrays().0[j] as usize)?;
            check_finite(above)?;
            check_finite(below)?;
        }
        Ok(pivots.info())
    }

    fn solve_either(&mut self, rhs: &mut [f64], transposed: bool) {
        let n = self.pattern.get().n();
        assert_eq!(rhs.len(), n, "one right-hand side for every row");
        let Some(symbolic) = &self.symbolic else {
            return;
        };
        let x = MatMut::from_column_major_slice_mut(rhs, n, 1);
        let stack = self.scratch.stack();
        match self.current {
            Kind::Simplicial => {
                let Simplicial { lu, rows, rows_inverse } = &self.simplicial;
                let rows = PermRef::new_checked(rows, rows_inverse, n);
                let columns = symbolic.col_perm();
                if transposed {
                    let conj = Conj::No;
                    lu.solve_transpose_in_place_with_conj(rows, columns, conj, x, Par::Seq, stack);
                } else {
                    lu.solve_in_place_with_conj(rows, columns, Conj::No, x, Par::Seq, stack);
                }
            }
            Kind::Supernodal => {
                let lu = LuRef::new_unchecked(symbolic, &self.supernodal);
                if transposed {
                    lu.solve_transpose_in_place_with_conj(Conj::No, x, Par::Seq, stack);
                } else {
                    lu.solve_in_place_with_conj(Conj::No, x, Par::Seq, stack);
                }
            }
        }
    }
}

impl Default for FaerSparseLu {
    fn default() -> Self {
        Self::new()
    }
}

impl LinearSolver for FaerSparseLu {
    fn name(&self) -> &'static str {
        "faer sparse LU"
    }

    fn analyse(&mut self, pattern: &Pattern) -> Result<(), LinearError> {
        if self.pattern.is(pattern) {
            return Ok(());
        }
        let threshold = if pattern.n() < SUPERNODAL_FROM || !self.may_block {
            SupernodalThreshold::FORCE_SIMPLICIAL
        } else {
            SupernodalThreshold(SUPERNODAL_RATIO)
        };
        self.analyse_anew(pattern, threshold)
    }

    fn factor(&mut self, values: &[f64]) -> Result<FactorInfo, LinearError> {
        let nnz = self.pattern.get().nnz();
        assert_eq!(values.len(), nnz, "one value for every entry of the pattern");
        check_finite(values)?;
        if self.symbolic.is_none() {
            return Ok(PivotRange::new().info());
        }
        if self.kind == Kind::Supernodal
            && let Some(info) = self.factor_supernodal(values)?
        {
            self.current = Kind::Supernodal;
            return Ok(info);
        }
        self.current = Kind::Simplicial;
        self.factor_simplicial(values)
    }

    /// Of simplicial factors; faer does not show the size of supernodal ones.
    fn fill(&self) -> Option<usize> {
        let entries = |factor: SparseColMatRef<'_, Index, f64>| {
            (0..factor.ncols()).map(|j| factor.val_of_col(j).len()).sum::<usize>()
        };
        let Simplicial { lu, rows, .. } = &self.simplicial;
        (self.current == Kind::Simplicial && !rows.is_empty())
            .then(|| entries(lu.l_factor_unsorted()) + entries(lu.u_factor_unsorted()))
    }

    fn solve(&mut self, rhs: &mut [f64]) {
        self.solve_either(rhs, false);
    }

    fn solve_transposed(&mut self, rhs: &mut [f64]) {
        self.solve_either(rhs, true);
    }
}

/// The pattern as faer sees it. `O(nnz)` checks, no copy.
fn structure(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, Index> {
    let n = pattern.n();
    let (starts, rows) = pattern.stored();
    SymbolicSparseColMatRef::new_checked(n, n, starts, None, rows)
}

fn matrix<'a>(pattern: &'a Pattern, values: &'a [f64]) -> SparseColMatRef<'a, Index, f64> {
    SparseColMatRef::new(structure(pattern), values)
}

/// Numbers of either sign and size 1/2 to 1 from a Weyl sequence: in no special relation to any
/// matrix of a model, and the same in every run.
fn fill_probe(probe: &mut [f64]) {
    let mut weyl = 0.5;
    for value in probe {
        weyl = (weyl + 0.618_033_988_749_894_9) % 1.0;
        *value = if weyl < 0.5 { weyl + 0.5 } else { -weyl };
    }
}

fn norm_1(x: &[f64]) -> f64 {
    x.iter().map(|value| value.abs()).sum()
}

#[cfg(test)]
#[path = "faer_sparse_tests.rs"]
mod tests;
