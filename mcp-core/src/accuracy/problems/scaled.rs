//! A chain of cubic springs, in units of one's choice.

use super::super::{AccuracyError, Case, Manufactured, Mix, Reference};
use crate::error::ModelError;
use crate::model::{Model, Reader, Shape};
use crate::scalar::{Real, Scalar, when};

/// `f_i = r_i (3 y_i + y_i³/4 − y_{i−1} − y_{i+1}/2)` with `y = z/c`.
struct Chain {
    shape: Shape,
    /// Units of the equations.
    r: Vec<f64>,
    /// Units of the variables.
    c: Vec<f64>,
}

impl Chain {
    fn new(r: Vec<f64>, c: Vec<f64>) -> Result<Self, ModelError> {
        let n = r.len();
        let free = vec![f64::INFINITY; n];
        let lower: Vec<f64> = free.iter().map(|u| -u).collect();
        Ok(Chain { shape: Shape::anonymous(&lower, &free, &vec![0.0; n])?, r, c })
    }
}

impl Model for Chain {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let y = |j: usize| read.var(j) / self.c[j];
        let before = when(i > 0, || y(i - 1));
        let behind = when(i + 1 < self.c.len(), || y(i + 1) / 2);
        self.r[i] * (3 * y(i) + y(i).powi(3) / 4 - before - behind)
    }
}

/// The values of the Jacobian, column by column.
fn jacobian(r: &[f64], c: &[f64], z: &[f64], jac: &mut [f64]) {
    let (n, mut k) = (z.len(), 0);
    for j in 0..n {
        for i in j.saturating_sub(1)..n.min(j + 2) {
            let slope = match i {
                _ if i == j => 3.0 + 0.75 * (z[j] / c[j]).powi(2),
                _ if i > j => -1.0,
                _ => -0.5,
            };
            jac[k] = r[i] * slope / c[j];
            k += 1;
        }
    }
}

/// A manufactured solution between 1 and 2 of its units; a third of the variables is at its lower
/// bound, a sixth at its upper one, a quarter of those degenerate.
fn manufactured(name: String, r: Vec<f64>, c: Vec<f64>) -> Result<Case, AccuracyError> {
    let n = r.len();
    let solution: Vec<f64> = (0..n).map(|j| c[j] * (1.0 + (j % 7) as f64 / 7.0)).collect();
    let mix = Mix { lower: 1.0 / 3.0, upper: 1.0 / 6.0, degenerate: 0.25, margin: 1.0 };
    let model = Manufactured::new(Chain::new(r.clone(), c.clone())?, &solution, &mix.places(n))?;
    let reference = Reference::manufactured(model.solution());
    let case = Case::new(name, model).solved_by(reference);
    Ok(case.by_hand(move |z, jac| jacobian(&r, &c, z, jac)))
}

/// A chain of `n` springs with a manufactured solution; equations in units from `1e-4` to `1e4`,
/// variables from `1e-6` to `1e6`.
///
/// # Errors
/// None in practice.
pub fn badly_scaled(n: usize) -> Result<Case, AccuracyError> {
    let unit = |k: usize, most: i32| {
        let steps = i32::try_from(k % 13).unwrap_or(0);
        10_f64.powf(f64::from(most) * (f64::from(steps) / 6.0 - 1.0))
    };
    let (r, c) = ((0..n).map(|i| unit(5 * i, 4)), (0..n).map(|j| unit(7 * j, 6)));
    manufactured("badly scaled".to_owned(), r.collect(), c.collect())
}

/// The same in units of 1: a Jacobian of three diagonals.
///
/// # Errors
/// None in practice.
pub fn chain(n: usize) -> Result<Case, AccuracyError> {
    manufactured(format!("chain {n}"), vec![1.0; n], vec![1.0; n])
}
