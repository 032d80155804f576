//! Linear systems `H d = r` of the Newton steps, behind one object-safe trait.
//!
//! `H` is square with one [`Pattern`] for a whole solve, so the symbolic part is done once
//! ([`LinearSolver::analyse`]), the numeric part at every iteration ([`LinearSolver::factor`]).
//!
//! | solver | used by `Auto` for | factor | reference |
//! | --- | --- | --- | --- |
//! | [`StackLu`] | `n < 16` | `2n³/3` flops, no heap | \[GV13\] Alg. 3.4.1 |
//! | [`NalgebraLu`] | `n <= 100` | `2n³/3`, unblocked | nalgebra |
//! | [`FaerDenseLu`] | dense, `n > 100` | `2n³/3`, blocked | faer |
//! | [`FaerSparseLu`] | sparse, `n > 100` | fill of column approximate minimum degree order (COLAMD) | faer |
//! | [`FaerCholesky`] | the same, `H` symmetric: `L Lᵀ` or `L D Lᵀ` | fill of approximate minimum degree order (AMD) | faer |
//! | [`MultigridCg`] | never: the caller brings it | `O(n)` | [BHM00](crate#references) |
//!
//! The LU factorisations use partial pivoting. None knows of bounds. [`Linear`] chooses among them.
//!
//! \[GV13\]: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., 2013.

mod auto;
mod condition;
mod faer_cholesky;
mod faer_dense;
mod faer_sparse;
mod multigrid;
mod nalgebra_lu;
mod pivots;
mod singular;
mod stack_lu;
mod storage;
#[cfg(test)]
mod tests;

pub use auto::{Linear, UnknownLinear};
pub use faer_cholesky::FaerCholesky;
pub use faer_dense::FaerDenseLu;
pub use faer_sparse::FaerSparseLu;
pub use multigrid::{Grid, MultigridCg};
pub use nalgebra_lu::NalgebraLu;
pub(crate) use singular::smallest_singular;
pub use stack_lu::StackLu;

use crate::problem::Pattern;

/// What went wrong in a linear solver. These are facts about the matrix, not about its entries'
/// meaning: the caller decides what a singular system is a sign of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LinearError {
    /// No pivot other than zero was left, or none with a finite reciprocal.
    #[error("the matrix is singular: no pivot for column {column}")]
    Singular {
        /// The column without a pivot.
        column: usize,
    },
    /// A symmetric matrix is not positive definite, which this solver needs.
    #[error("the matrix is not positive definite: the pivot of column {column} is not positive")]
    NotDefinite {
        /// The column of the pivot.
        column: usize,
    },
    /// An entry is NaN or infinite, or became so in the factorisation.
    #[error("the matrix or its factors have a non-finite entry")]
    NotFinite,
    /// The factors need more memory than there is.
    #[error("not enough memory for the factors of a matrix of order {n}")]
    OutOfMemory {
        /// Order of the matrix.
        n: usize,
    },
    /// The matrix couples unknowns that are no neighbours on the grid of the solver.
    #[error("the matrix of order {n} couples more than neighbours on a grid of {rows} × {columns}")]
    NotOnGrid {
        /// Order of the matrix.
        n: usize,
        /// Nodes along the first index.
        rows: usize,
        /// Nodes along the second index.
        columns: usize,
    },
    /// The solver does not take matrices of this order.
    #[error("the matrix has order {n}, but the solver takes at most {limit}")]
    TooLarge {
        /// Order of the matrix.
        n: usize,
        /// Largest order of the solver.
        limit: usize,
    },
}

/// What a factorisation found out about the matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct FactorInfo {
    /// Smallest over largest pivot in absolute value: 0 for a singular matrix, small for a
    /// badly conditioned one. A heuristic, not a condition number, which is
    /// [`LinearSolver::condition`].
    pub pivot_ratio: f64,
}

impl FactorInfo {
    /// From the ratio of the extreme pivots.
    pub fn new(pivot_ratio: f64) -> Self {
        FactorInfo { pivot_ratio }
    }
}

/// A solver for square systems of one pattern. Implement it to bring your own.
///
/// Calls come in the order `analyse`, then any number of `factor`, each followed by any number of
/// `solve` and `solve_transposed`. After an error of `factor`, only `factor` may follow.
pub trait LinearSolver {
    /// Name for logs, e.g. `faer sparse LU`.
    fn name(&self) -> &'static str;

    /// Whether the solver takes symmetric matrices only. [`factor`](Self::factor) may then refuse
    /// those that are not positive definite.
    fn needs_symmetry(&self) -> bool {
        false
    }

    /// Whether solutions are as accurate as was asked for with [`set_accuracy`](Self::set_accuracy), and
    /// no more; NaN where the iteration has broken down.
    fn is_iterative(&self) -> bool {
        false
    }

    /// How far the next [`solve`](Self::solve) has to reduce the residual `‖rhs − H x‖₂`, relative to
    /// `‖rhs‖₂`. Direct solvers do what they can and ignore it, the default.
    fn set_accuracy(&mut self, _relative: f64) {}

    /// Symbolic analysis and allocation, once per pattern. A repeated call with the same pattern
    /// is cheap and allocates nothing.
    ///
    /// # Errors
    /// [`LinearError::OutOfMemory`], [`LinearError::TooLarge`].
    fn analyse(&mut self, pattern: &Pattern) -> Result<(), LinearError>;

    /// Numeric factorisation of the matrix with `values` in the order of the pattern.
    ///
    /// # Errors
    /// [`LinearError::Singular`] for an exactly zero pivot, [`LinearError::NotFinite`].
    fn factor(&mut self, values: &[f64]) -> Result<FactorInfo, LinearError>;

    /// Entries of the factors at hand, with those that blocks of columns add; `None` where the solver
    /// cannot tell, the default.
    fn fill(&self) -> Option<usize> {
        None
    }

    /// An estimate of the condition number `‖H‖₁ ‖H⁻¹‖₁` of the matrix factored last, whose pattern and
    /// values these are: a lower bound, mostly above a third of it; infinite where a solution is not
    /// finite.
    ///
    /// `‖H⁻¹‖₁` by a walk over the corners of the unit ball: [Hig88](crate#references) algorithm 4.1. It
    /// takes 3 to 12 solves and three vectors, and only where it is asked for.
    fn condition(&mut self, pattern: &Pattern, values: &[f64]) -> f64 {
        condition::norm_1(pattern, values) * condition::norm_1_of_inverse(self, pattern.n())
    }

    /// `rhs ← H⁻¹ rhs`.
    fn solve(&mut self, rhs: &mut [f64]);

    /// [`solve`](Self::solve) with memory that is lent for the time of the call, of any length and with any
    /// numbers in it, which are lost. For iterative solvers; the default leaves it alone.
    fn solve_with(&mut self, rhs: &mut [f64], _lent: &mut [f64]) {
        self.solve(rhs);
    }

    /// Gives back the memory of the factors, which [`factor`](Self::factor) takes anew: nothing else may
    /// follow. For solvers whose factors cost little; the default keeps them.
    fn release(&mut self) {}

    /// `rhs ← H⁻ᵀ rhs`.
    fn solve_transposed(&mut self, rhs: &mut [f64]);
}
