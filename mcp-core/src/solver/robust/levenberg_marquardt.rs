//! Levenberg–Marquardt directions: `min ‖H d + Φ‖² + μ ‖d‖²`.
//!
//! ```text
//! [ √μ I    H   ] [ s ]   [ −Φ ]
//! [  Hᵀ   −√μ I ] [ d ] = [  0 ]
//! ```
//!
//! The augmented system has the accuracy of a QR factorisation where the normal equations square
//! the condition, and it is as sparse as `H`. It is symmetric and quasi-definite, so that
//! [`NewtonSystem`] solves it by `L D Lᵀ`, looks at the backward error, and has LU behind it.
//! For `μ = O(‖Φ‖)` the steps keep Newton's rate under an error bound ([KP04](crate#references)).

use super::Search;
use crate::generic::generic;
use crate::problem::Pattern;
use crate::solver::newton_system::NewtonSystem;
use crate::solver::options::Options;
use crate::solver::robust::memory::Memory;

/// The augmented system of a pattern.
pub(super) struct Damped {
    /// The pattern of `J`.
    source: Pattern,
    n: usize,
    /// Positions of the entries of `J`, of the diagonal of `H`, in both blocks; of `±√μ`.
    upper: Vec<usize>,
    lower: Vec<usize>,
    upper_diagonal: Vec<usize>,
    lower_diagonal: Vec<usize>,
    diagonal: Vec<usize>,
    values: Vec<f64>,
    spare: Vec<f64>,
    /// Rows `0 d_i + 1 (K d)_i` of the augmented matrix `K`.
    zeros: Vec<f64>,
    ones: Vec<f64>,
    rhs: Vec<f64>,
    solution: Vec<f64>,
    system: NewtonSystem,
}

impl Damped {
    /// Of the pattern of `J`; `None` if no linear solver takes it.
    fn new(source: &Pattern, options: &Options) -> Option<Self> {
        let n = source.n();
        let with_diagonal = source.with_diagonal();
        let h = with_diagonal.pattern();
        let mut columns = vec![Vec::new(); 2 * n];
        for (_, i, j) in h.entries() {
            columns[n + j].push(i);
            columns[i].push(n + j);
        }
        for (k, column) in columns.iter_mut().enumerate() {
            column.push(k);
        }
        let pattern = Pattern::from_columns(columns);
        let find = |i: usize, j: usize| pattern.position(i, j).expect("made of these entries");
        let (mut upper, mut lower) = (vec![0; h.nnz()], vec![0; h.nnz()]);
        for (k, i, j) in h.entries() {
            (upper[k], lower[k]) = (find(i, n + j), find(n + j, i));
        }
        let entries =
            |from: &[usize]| (0..source.nnz()).map(|k| from[with_diagonal.entry(k)]).collect();
        let diagonal = |from: &[usize]| (0..n).map(|j| from[with_diagonal.diagonal(j)]).collect();
        let options = options.clone().with(|o| o.linear = o.linear.for_order(&pattern));
        Some(Damped {
            n,
            upper_diagonal: diagonal(&upper),
            lower_diagonal: diagonal(&lower),
            upper: entries(&upper),
            lower: entries(&lower),
            diagonal: (0..2 * n).map(|k| find(k, k)).collect(),
            values: vec![0.0; pattern.nnz()],
            spare: vec![0.0; pattern.nnz()],
            zeros: vec![0.0; 2 * n],
            ones: vec![1.0; 2 * n],
            rhs: vec![0.0; 2 * n],
            solution: vec![0.0; 2 * n],
            source: source.clone(),
            system: NewtonSystem::new(&pattern, &options, &mut None).ok()?,
        })
    }

    /// Factors for `H = diag(a) + diag(b) J` and `μ`; false if that fails.
    fn factor(&mut self, jac: &[f64], a: &[f64], b: &[f64], mu: f64) -> bool {
        self.values.fill(0.0);
        for (k, i) in self.source.rows().enumerate() {
            let h = b[i] * jac[k];
            self.values[self.upper[k]] = h;
            self.values[self.lower[k]] = h;
        }
        for j in 0..self.n {
            self.values[self.upper_diagonal[j]] += a[j];
            self.values[self.lower_diagonal[j]] += a[j];
            self.values[self.diagonal[j]] = mu.sqrt();
            self.values[self.diagonal[self.n + j]] = -mu.sqrt();
        }
        self.system.factor(&self.values, &mut self.spare, (&self.zeros, &self.ones)).is_some()
    }

    /// `d` for the right-hand side `−(first, second)`; false if it is not finite.
    fn solve(&mut self, first: &[f64], second: Option<&[f64]>, d: &mut [f64]) -> bool {
        let (top, bottom) = self.rhs.split_at_mut(self.n);
        top.copy_from_slice(first);
        match second {
            Some(second) => bottom.copy_from_slice(second),
            None => bottom.fill(0.0),
        }
        let Damped { system, values, spare, zeros, ones, rhs, solution, .. } = self;
        system.back_solve(values, spare, (zeros, ones), rhs, solution);
        d.copy_from_slice(&solution[self.n..]);
        d.iter().all(|d| d.is_finite())
    }
}

impl Memory {
    /// `‖H‖₁ ‖H‖_∞ >= ‖H‖₂²` for `H = diag(a) + diag(b) J`.
    pub(super) fn squared_norm_bound(&mut self, pattern: &Pattern) -> f64 {
        let (mut columns, mut rows) = (0.0_f64, 0.0_f64);
        for (slope, a) in self.slope.iter_mut().zip(&self.a) {
            *slope = a.abs();
        }
        for j in 0..pattern.n() {
            let mut sum = self.a[j].abs();
            for k in pattern.column(j) {
                let i = pattern.row(k);
                let size = (self.b[i] * self.jac[k]).abs();
                sum += size;
                self.slope[i] += size;
            }
            columns = columns.max(sum);
        }
        for &sum in &self.slope {
            rows = rows.max(sum);
        }
        columns * rows
    }
}

impl Search<'_, '_> {
    /// `d` of `min ‖H d + r‖² + μ ‖d‖²` with `H` of `a` and `b`, `r` in `rhs` and
    /// `μ = damping ‖H‖²`. False if the stage is switched off or nothing finite comes out.
    pub(super) fn damped_direction(&mut self, damping: f64) -> bool {
        let Search { run, memory } = self;
        if run.options.robust.levenberg_marquardt == 0 {
            return false;
        }
        let pattern = run.problem.pattern();
        if memory.damped.as_ref().is_none_or(|damped| damped.source != *pattern) {
            memory.damped = Damped::new(pattern, run.options);
        }
        let mu = damping * memory.squared_norm_bound(pattern);
        let memory = &mut **memory;
        let Some(damped) = &mut memory.damped else { return false };
        run.stats.factorisations += 1;
        mu > 0.0
            && damped.factor(&memory.jac, &memory.a, &memory.b, mu)
            && damped.solve(&memory.rhs, None, &mut memory.direction)
    }

    /// A direction of smallest `‖H v‖` by inverse iteration, largest entry 1, in `direction`; false
    /// if there is none. `H` of `a` and `b`.
    pub(super) fn null_direction(&mut self) -> bool {
        let n = self.memory.rhs.len();
        self.memory.rhs.fill(0.0);
        if !self.damped_direction(1e-24) && !self.damped_direction(1e-16) {
            return false;
        }
        let memory = &mut *self.memory;
        let Some(damped) = &mut memory.damped else { return false };
        for (j, v) in memory.slope.iter_mut().enumerate() {
            *v = 1.0 + 0.3 * generic(j);
        }
        for _ in 0..4 {
            if !damped.solve(&memory.rhs, Some(&memory.slope), &mut memory.direction) {
                return false;
            }
            let largest = memory.direction.iter().fold(0.0_f64, |m, d| m.max(d.abs()));
            for j in 0..n {
                memory.slope[j] = memory.direction[j] / largest;
            }
        }
        memory.direction.copy_from_slice(&memory.slope);
        memory.direction.iter().all(|d| d.is_finite())
    }
}
