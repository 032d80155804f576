//! Derivatives of a model that is one function: all variables carry lanes at once.

use super::Pattern;
use super::ad::Pass;
use crate::model::{Model, Point, Reader, Shape};
use crate::scalar::{Real, Scalar};

/// Workspace of dense lanes in the arithmetic `D`: one pass for every `D::LANES` variables.
pub(super) struct Lanes<D: Scalar> {
    z: Vec<Real<D>>,
    f: Vec<Real<D>>,
    parameters: Vec<Real<D>>,
    plain: Vec<Real<f64>>,
    /// The variable each row is paired with.
    variable_of_row: Vec<usize>,
    /// The row of every structural nonzero, in the order of the pattern; nothing if all entries are
    /// there and row `i` belongs to variable `i`.
    row_of_entry: Vec<usize>,
}

impl<D: Scalar> Lanes<D> {
    pub(super) fn new(shape: &Shape, pattern: &Pattern) -> Self {
        let zero = Real(D::constant(0.0));
        let rows = shape.row_count();
        let row_of = |i: usize| shape.row_of_variable(i).expect("an entry belongs to a row");
        let variable_of_row: Vec<usize> = (0..rows).map(|row| shape.variable_of_row(row)).collect();
        let is_dense = pattern.nnz() == rows * rows && variable_of_row.is_sorted();
        let entries = if is_dense { 0 } else { pattern.nnz() };
        Lanes {
            z: vec![zero; shape.n()],
            f: vec![zero; rows],
            parameters: vec![zero; shape.parameter_values().len()],
            plain: vec![Real(0.0); rows],
            variable_of_row,
            row_of_entry: pattern.rows().take(entries).map(row_of).collect(),
        }
    }

    /// `f_i ← value(row paired with i)`; variables without a row keep 0.
    fn give<T: Scalar>(variable_of_row: &[usize], rows: &[Real<T>], f: &mut [f64]) {
        if f.len() > rows.len() {
            f.fill(0.0);
        }
        for (&i, row) in variable_of_row.iter().zip(rows) {
            f[i] = row.0.value();
        }
    }
}

impl<M: Model, D: Scalar> Pass<M> for Lanes<D> {
    fn residual(&mut self, model: &M, z: &[f64], parameters: &[f64], f: &mut [f64]) {
        let point = Point { z, definitions: &[], parameters };
        model.whole(&Reader::plain(point), &mut self.plain);
        Self::give(&self.variable_of_row, &self.plain, f);
    }

    fn jacobian(
        &mut self,
        model: &M,
        (z, parameters): (&[f64], &[f64]),
        pattern: &Pattern,
        f: Option<&mut [f64]>,
        jac: &mut [f64],
    ) {
        for (own, &p) in self.parameters.iter_mut().zip(parameters) {
            *own = Real(D::constant(p));
        }
        let n = z.len();
        for first in (0..n).step_by(D::LANES) {
            for (j, (own, &z)) in self.z.iter_mut().zip(z).enumerate() {
                *own = Real(D::seed(z, j.wrapping_sub(first)));
            }
            model.whole(&Reader::lanes(&self.z, &[], &self.parameters), &mut self.f);
            for j in first..n.min(first + D::LANES) {
                let (lane, column) = (j - first, pattern.column(j));
                if self.row_of_entry.is_empty() {
                    for (entry, f) in jac[column].iter_mut().zip(&self.f) {
                        *entry = f.0.tangent(lane);
                    }
                } else {
                    for (entry, &row) in
                        jac[column.clone()].iter_mut().zip(&self.row_of_entry[column])
                    {
                        *entry = self.f[row].0.tangent(lane);
                    }
                }
            }
        }
        if let Some(f) = f {
            Self::give(&self.variable_of_row, &self.f, f);
        }
    }
}
