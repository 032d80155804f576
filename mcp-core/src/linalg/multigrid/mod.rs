//! [`MultigridCg`]: conjugate gradients with a multigrid cycle, for elliptic problems on a grid.
//!
//! ```text
//! hierarchy   A_0 = H,  A_(l+1) = Pᵀ A_l P,  P linear interpolation from every second node
//! cycle       x ← forward Gauss–Seidel;  x ← x + P cycle(Pᵀ (b − A x));  x ← backward Gauss–Seidel
//! solve       conjugate gradients, preconditioned by one cycle, until ‖r‖ <= η ‖rhs‖
//! ```
//!
//! Nothing is factored: memory is five numbers for each unknown, and five more that the caller may lend for
//! the time of a solve; time is proportional to the unknowns.
//! [BHM00](crate#references) chapters 3 and 10; the coarse matrices are truncated where variables are known.

mod galerkin;
mod grid;
mod level;

pub use grid::Grid;

use super::pivots::check_finite;
use super::storage::KeptPattern;
use super::{FactorInfo, LinearError, LinearSolver};
use crate::problem::Pattern;
use level::Level;

/// Steps of conjugate gradients at most.
const STEPS: usize = 200;
/// Pairs of sweeps on the coarsest grid, of nine nodes at most.
const COARSEST_SWEEPS: usize = 12;

/// Conjugate gradients with a multigrid cycle for symmetric positive definite matrices that couple
/// a node of a [`Grid`] with its eight neighbours at most.
///
/// [`Solver::with_linear_solver`](crate::Solver::with_linear_solver) takes it. Systems are solved to the
/// accuracy the method asks for ([`set_accuracy`](LinearSolver::set_accuracy), at first `10⁻⁸`); a matrix
/// that is not positive definite gives NaN.
///
/// ```
/// use mcp_core::{Grid, LinearSolver, MultigridCg, Pattern};
/// // A string of 5 springs under its weight: −x_(i−1) + 2 x_i − x_(i+1) = 1.
/// let pattern = Pattern::from_columns((0..5_usize).map(|j| (j.saturating_sub(1)..5.min(j + 2)).collect()));
/// let values: Vec<f64> =
///     pattern.entries().map(|(_, i, j)| if i == j { 2.0 } else { -1.0 }).collect();
/// let mut solver = MultigridCg::new(Grid::new(1, 5));
/// solver.analyse(&pattern)?;
/// solver.factor(&values)?;
/// let mut x = [1.0; 5];
/// solver.solve(&mut x);
/// assert!((x[2] - 4.5).abs() < 1e-6);
/// # Ok::<(), mcp_core::LinearError>(())
/// ```
#[derive(Debug)]
pub struct MultigridCg {
    grid: Grid,
    pattern: KeptPattern,
    /// Whether a node of the pattern is coupled across a corner.
    has_corners: bool,
    /// Empty before the first matrix.
    levels: Vec<Level>,
    /// Fields of a solve for which no memory is lent.
    own: Vec<f64>,
    accuracy: f64,
    steps: usize,
}

impl MultigridCg {
    /// For matrices of this grid, without memory until [`factor`](LinearSolver::factor) is called.
    pub fn new(grid: Grid) -> Self {
        let pattern = KeptPattern::default();
        let (levels, own) = (Vec::new(), Vec::new());
        MultigridCg { grid, pattern, has_corners: false, levels, own, accuracy: 1e-8, steps: 0 }
    }

    /// Steps of conjugate gradients of all solves so far.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Grids without entries, from fine to coarse.
    fn lay_out(&mut self) {
        let mut next = Some(self.grid);
        while let Some(grid) = next {
            self.levels.push(Level::new(grid, self.has_corners || !self.levels.is_empty()));
            next = grid.coarser();
        }
    }

    /// Numbers that the fields of a solve take.
    fn memory(&self) -> usize {
        let sizes: usize = self.levels.iter().map(Level::size).sum();
        2 * (sizes + self.levels[0].size())
    }

    /// Solves with the cycle as preconditioner; false if the matrix turns out not to be definite. Fields
    /// stand in `memory`: `p`, `A p`, then `b` and `x` of every level.
    fn conjugate_gradients(&mut self, solution: &mut [f64], memory: &mut [f64]) -> bool {
        let Grid { rows, columns } = self.grid;
        let (levels, fine) = (&self.levels[..], &self.levels[0]);
        let (m, size) = (fine.m, fine.size());
        let (p, rest) = memory.split_at_mut(size);
        let (image, fields) = rest.split_at_mut(size);
        for zeros in [&mut *p, &mut *image, &mut fields[..size]] {
            zeros.fill(0.0);
        }
        for i in 0..rows {
            let to = (i + 1) * m + 1;
            fields[to..to + columns].copy_from_slice(&solution[i * columns..(i + 1) * columns]);
        }
        solution.fill(0.0);
        let target = self.accuracy * norm(&fields[..size]);
        let mut rz_before = 1.0;
        for k in 0..STEPS {
            if norm(&fields[..size]) <= target {
                break;
            }
            self.steps += 1;
            cycle(levels, fields, image);
            // z = x of the cycle, r = b: β = r·z / (r·z before), p = z + β p.
            let (r, rest) = fields.split_at_mut(size);
            let z = &rest[..size];
            let rz = dot(r, z);
            let beta = if k == 0 { 0.0 } else { rz / rz_before };
            rz_before = rz;
            for (p, z) in p.iter_mut().zip(z) {
                *p = z + beta * *p;
            }
            fine.apply(p, image);
            let curvature = dot(p, image);
            // False for NaN.
            if !(rz > 0.0 && curvature > 0.0) {
                return false;
            }
            let step = rz / curvature;
            for i in 0..rows {
                let from = (i + 1) * m + 1;
                let p = &p[from..from + columns];
                for (x, p) in solution[i * columns..(i + 1) * columns].iter_mut().zip(p) {
                    *x += step * p;
                }
                let image = &image[from..from + columns];
                for (r, image) in r[from..from + columns].iter_mut().zip(image) {
                    *r -= step * image;
                }
            }
        }
        true
    }
}

/// One cycle on `A x = b` from `x = 0`, with `b` and `x` of every level in `fields` and memory for a field in `r`.
fn cycle(levels: &[Level], fields: &mut [f64], r: &mut [f64]) {
    let Some((fine, coarser)) = levels.split_first() else { return };
    let (own, next) = fields.split_at_mut(2 * fine.size());
    let (b, x) = own.split_at_mut(fine.size());
    x.fill(0.0);
    let Some(coarse) = coarser.first() else {
        for _ in 0..COARSEST_SWEEPS {
            fine.smooth(b, x, r, true);
            fine.smooth(b, x, r, false);
        }
        return;
    };
    fine.smooth(b, x, r, true);
    fine.residual(b, x, r);
    fine.restrict(r, coarse, &mut next[..coarse.size()]);
    cycle(coarser, next, r);
    fine.correct(x, coarse, &next[coarse.size()..]);
    fine.smooth(b, x, r, false);
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    // Four sums side by side, always the same: the additions do not wait for each other.
    let mut sums = [0.0; 4];
    let (whole, rest) = (a.chunks_exact(4), b.chunks_exact(4));
    let tail: f64 = whole.remainder().iter().zip(rest.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in whole.zip(rest) {
        for k in 0..4 {
            sums[k] += a[k] * b[k];
        }
    }
    sums.iter().sum::<f64>() + tail
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

impl LinearSolver for MultigridCg {
    fn name(&self) -> &'static str {
        "multigrid CG"
    }

    fn needs_symmetry(&self) -> bool {
        true
    }

    fn is_iterative(&self) -> bool {
        true
    }

    fn set_accuracy(&mut self, relative: f64) {
        self.accuracy = relative;
    }

    fn analyse(&mut self, pattern: &Pattern) -> Result<(), LinearError> {
        if self.pattern.is(pattern) {
            return Ok(());
        }
        self.pattern.forget();
        let Grid { rows, columns } = self.grid;
        if pattern.n() != self.grid.n() {
            return Err(LinearError::NotOnGrid { n: pattern.n(), rows, columns });
        }
        self.has_corners = false;
        for (_, i, j) in pattern.entries() {
            let down = (i / columns).abs_diff(j / columns);
            let across = (i % columns).abs_diff(j % columns);
            if down.max(across) > 1 {
                return Err(LinearError::NotOnGrid { n: pattern.n(), rows, columns });
            }
            self.has_corners |= down + across == 2;
        }
        self.release();
        self.pattern.keep(pattern);
        Ok(())
    }

    fn factor(&mut self, values: &[f64]) -> Result<FactorInfo, LinearError> {
        check_finite(values)?;
        if self.levels.is_empty() {
            self.lay_out();
        }
        let pattern = self.pattern.get();
        let columns = self.grid.columns;
        let fine = &mut self.levels[0];
        fine.clear();
        for j in 0..pattern.n() {
            let place = (j / columns + 1) * fine.m + j % columns + 1;
            for k in pattern.column(j) {
                let i = pattern.row(k);
                // The lower triangle: i at or after j.
                if i == j {
                    fine.diagonal[place] = values[k];
                } else if i == j + 1 && i / columns == j / columns {
                    fine.east[place] = values[k];
                } else if i == j + columns {
                    fine.south[place] = values[k];
                } else if i > j + columns {
                    fine.south_east[place] = values[k];
                } else if i > j {
                    fine.south_west[place] = values[k];
                }
            }
        }
        fine.close();
        for l in 1..self.levels.len() {
            let (finer, coarser) = self.levels.split_at_mut(l);
            finer[l - 1].coarsen(&mut coarser[0]);
        }
        let fine = &self.levels[0];
        if let Some(q) = fine.not_positive() {
            let column = (q / fine.m - 1) * columns + q % fine.m - 1;
            return Err(LinearError::NotDefinite { column });
        }
        if self.levels.iter().any(|level| level.not_positive().is_some()) {
            return Err(LinearError::NotDefinite { column: 0 });
        }
        Ok(FactorInfo::new(1.0))
    }

    fn solve(&mut self, rhs: &mut [f64]) {
        self.solve_with(rhs, &mut []);
    }

    fn solve_with(&mut self, rhs: &mut [f64], lent: &mut [f64]) {
        assert_eq!(rhs.len(), self.grid.n(), "one right-hand side for every node");
        let memory = self.memory();
        let is_definite = if let Some(lent) = lent.get_mut(..memory) {
            self.conjugate_gradients(rhs, lent)
        } else {
            let mut own = std::mem::take(&mut self.own);
            own.resize(memory, 0.0);
            let is_definite = self.conjugate_gradients(rhs, &mut own);
            self.own = own;
            is_definite
        };
        if !is_definite {
            rhs.fill(f64::NAN);
        }
    }

    fn release(&mut self) {
        (self.levels, self.own) = (Vec::new(), Vec::new());
    }

    fn solve_transposed(&mut self, rhs: &mut [f64]) {
        self.solve(rhs);
    }
}

#[cfg(test)]
mod tests;
