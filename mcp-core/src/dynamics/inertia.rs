//! [`Inertia`]: the matrix `M̂ = M + hθ C + (hθ)² K` of the free motion.

use super::constraint::Row;
use super::error::DynamicsError;
use super::mechanics::Mechanics;
use crate::linalg::{Linear, LinearSolver};
use crate::problem::Pattern;

/// `M̂`, factored once.
pub(super) enum Inertia {
    /// `1 / M̂_ii` where nothing couples coordinates.
    Diagonal(Vec<f64>),
    /// Factors of `M̂`, and a column at work.
    Coupled { factors: Box<dyn LinearSolver>, column: Vec<f64> },
}

impl Inertia {
    pub(super) fn new(system: &Mechanics, h_theta: f64) -> Result<Self, DynamicsError> {
        let n = system.mass.len();
        let entries = system.implicit_entries(h_theta);
        if entries.iter().all(|&(i, j, _)| i == j) {
            let mut diagonal = system.mass.clone();
            for (i, _, value) in entries {
                diagonal[i] += value;
            }
            return Ok(Inertia::Diagonal(diagonal.into_iter().map(f64::recip).collect()));
        }
        let mut columns: Vec<Vec<usize>> = (0..n).map(|j| vec![j]).collect();
        for &(i, j, _) in &entries {
            columns[j].push(i);
        }
        let pattern = Pattern::from_columns(columns);
        let mut values = vec![0.0; pattern.nnz()];
        let masses = system.mass.iter().enumerate().map(|(i, &m)| (i, i, m));
        for (i, j, value) in masses.chain(entries) {
            if let Some(k) = pattern.position(i, j) {
                values[k] += value;
            }
        }
        let mut factors = Linear::default().solver_for(&pattern)?;
        factors.analyse(&pattern)?;
        factors.factor(&values)?;
        Ok(Inertia::Coupled { factors, column: vec![0.0; n] })
    }

    /// Whether two constraints act on each other: they share a coordinate, or all are coupled.
    pub(super) fn couples(&self, a: &Row, b: &Row) -> bool {
        match self {
            Inertia::Diagonal(_) => {
                a.entries().iter().any(|(i, _)| b.entries().iter().any(|(j, _)| i == j))
            }
            Inertia::Coupled { .. } => true,
        }
    }

    /// `v += M̂⁻¹ f` on the coordinates where forces act; `f` is used up.
    pub(super) fn accelerate(&mut self, forced: &[usize], f: &mut [f64], v: &mut [f64]) {
        match self {
            Inertia::Diagonal(inverse) => {
                for &i in forced {
                    v[i] += inverse[i] * f[i];
                }
            }
            Inertia::Coupled { factors, .. } => {
                factors.solve(f);
                for (v, dv) in v.iter_mut().zip(f) {
                    *v += *dv;
                }
            }
        }
    }

    /// `v += M̂⁻¹ Σ_i H_iᵀ λ_i`.
    pub(super) fn react(&mut self, rows: &[Row], lambda: &[f64], v: &mut [f64]) {
        match self {
            Inertia::Diagonal(inverse) => {
                for (row, r) in rows.iter().zip(lambda) {
                    for &(i, h) in row.entries() {
                        v[i] += inverse[i] * h * r;
                    }
                }
            }
            Inertia::Coupled { factors, column } => {
                column.fill(0.0);
                for (row, r) in rows.iter().zip(lambda) {
                    for &(i, h) in row.entries() {
                        column[i] += h * r;
                    }
                }
                factors.solve(column);
                for (v, dv) in v.iter_mut().zip(column) {
                    *v += *dv;
                }
            }
        }
    }

    /// Row `i` of the Delassus matrix, `(H M̂⁻¹ Hᵀ)_ij`, for the columns that `entries` gives.
    pub(super) fn delassus<'a>(
        &mut self,
        rows: &[Row],
        i: usize,
        entries: impl Iterator<Item = (usize, &'a mut f64)>,
    ) {
        match self {
            Inertia::Diagonal(inverse) => {
                for (j, entry) in entries {
                    *entry = 0.0;
                    for &(a, ha) in rows[i].entries() {
                        for &(b, hb) in rows[j].entries() {
                            if a == b {
                                *entry += ha * inverse[a] * hb;
                            }
                        }
                    }
                }
            }
            Inertia::Coupled { factors, column } => {
                column.fill(0.0);
                for &(a, h) in rows[i].entries() {
                    column[a] += h;
                }
                factors.solve(column);
                for (j, entry) in entries {
                    *entry = rows[j].times(column);
                }
            }
        }
    }
}
