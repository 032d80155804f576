//! Largest entries of the rows and columns of a Jacobian.

use crate::model::{BoundKind, Shape};
use crate::problem::Pattern;

/// Norms of rows and columns without fixed variables: their equations need not hold, and they do
/// not move.
pub(super) struct Norms {
    pub(super) rows: Lines,
    pub(super) columns: Lines,
}

/// Norms of the rows, or of the columns, with structural nonzeros; the others have none.
pub(super) struct Lines(Vec<Option<f64>>);

impl Norms {
    /// `max |J_ij|` of every row and column. An entry that is not finite is no zero, and makes its
    /// norms infinite. A column read only by equations of fixed variables has norm 0.
    pub(super) fn of(shape: &Shape, pattern: &Pattern, jac: &[f64]) -> Self {
        let (mut rows, mut columns) = (vec![None::<f64>; pattern.n()], vec![None; pattern.n()]);
        let is_fixed = |i: usize| shape.bounds().kind(i) == BoundKind::Fixed;
        for (k, i, j) in pattern.entries() {
            let size = if jac[k].is_nan() { f64::INFINITY } else { jac[k].abs() };
            let in_column = if is_fixed(i) { 0.0 } else { size };
            for (norm, size, line) in [(&mut rows[i], size, i), (&mut columns[j], in_column, j)] {
                if !is_fixed(line) {
                    *norm = Some(norm.unwrap_or(0.0).max(size));
                }
            }
        }
        Norms { rows: Lines(rows), columns: Lines(columns) }
    }
}

impl Lines {
    /// Lines with structural nonzeros that are all zero.
    pub(super) fn zeros(&self) -> impl Iterator<Item = usize> + '_ {
        self.0.iter().enumerate().filter(|(_, norm)| **norm == Some(0.0)).map(|(k, _)| k)
    }

    /// The first of the smallest norms that are neither zero nor infinite.
    pub(super) fn smallest(&self) -> Option<(usize, f64)> {
        self.proper().reduce(|least, line| if line.1 < least.1 { line } else { least })
    }

    /// The first of the largest norms that are neither zero nor infinite.
    pub(super) fn largest(&self) -> Option<(usize, f64)> {
        self.proper().reduce(|most, line| if line.1 > most.1 { line } else { most })
    }

    fn proper(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let lines = self.0.iter().enumerate();
        lines
            .filter_map(|(k, norm)| norm.map(|norm| (k, norm)))
            .filter(|&(_, norm)| norm > 0.0 && norm.is_finite())
    }
}
