//! Affine problems `F(z) = M z + q`: tests of Siconos, families of LCPs, an obstacle problem.

use super::{Known, equalities_first};
use crate::error::ModelError;
use crate::model::{Model, Reader, Shape};
use crate::scalar::{Real, Scalar};

/// `F_i = q_i + Σ_j M_ij z_j` over the nonzeros of `M`.
#[derive(Clone, Debug)]
pub struct Affine {
    shape: Shape,
    rows: Vec<Vec<(usize, f64)>>,
    q: Vec<f64>,
}

impl Affine {
    /// With `M` given by a function of row and column; the first `equalities` variables are free,
    /// the others nonnegative.
    ///
    /// # Errors
    /// None in practice.
    pub fn new(
        equalities: usize,
        q: Vec<f64>,
        m: impl Fn(usize, usize) -> f64,
    ) -> Result<Self, ModelError> {
        let n = q.len();
        let row = |i| (0..n).map(|j| (j, m(i, j))).filter(|&(_, m)| m != 0.0).collect();
        Ok(Affine { shape: equalities_first(n, equalities)?, rows: (0..n).map(row).collect(), q })
    }

    /// With `M` given by its nonzeros `(column, value)`, row by row; all variables nonnegative.
    ///
    /// # Errors
    /// None in practice.
    pub fn sparse(q: Vec<f64>, rows: Vec<Vec<(usize, f64)>>) -> Result<Self, ModelError> {
        Ok(Affine { shape: equalities_first(q.len(), 0)?, rows, q })
    }

    /// With bounds; `M` given by its nonzeros, row by row, and the start moved into the box.
    ///
    /// # Errors
    /// As [`Shape::anonymous`].
    pub fn boxed(
        bounds: (&[f64], &[f64]),
        start: &[f64],
        q: Vec<f64>,
        rows: Vec<Vec<(usize, f64)>>,
    ) -> Result<Self, ModelError> {
        Ok(Affine { shape: Shape::anonymous(bounds.0, bounds.1, start)?, rows, q })
    }
}

impl Model for Affine {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let mut f = Real::from(self.q[i]);
        for &(j, m) in &self.rows[i] {
            f += m * read.var(j);
        }
        f
    }
}

fn from_zero(name: String, model: Affine, solutions: Vec<Vec<f64>>) -> Result<Known, ModelError> {
    let n = model.shape.n();
    Known::new(name, model, vec![vec![0.0; n]], solutions)
}

/// `unit(n, i)`: 1 at `i`, 0 elsewhere.
fn unit(n: usize, i: usize) -> Vec<f64> {
    (0..n).map(|j| f64::from(u8::from(i == j))).collect()
}

/// The 2 × 2 test of Siconos, `M = [2 1; 1 2]`, `q = (−5, −6)`; solution `(4/3, 7/3)`.
///
/// # Errors
/// None in practice.
pub fn siconos_2x2(equalities: usize) -> Result<Known, ModelError> {
    let m = |i, j| if i == j { 2.0 } else { 1.0 };
    let model = Affine::new(equalities, vec![-5.0, -6.0], m)?;
    from_zero(format!("siconos-2x2-{equalities}"), model, vec![vec![4.0 / 3.0, 7.0 / 3.0]])
}

/// The tridiagonal test of Siconos, `n = 10`, `M = (1, 2, 1)`, `q_i = 7 − i` or, shifted,
/// `−5 − i` (`i` from 0).
///
/// # Errors
/// None in practice.
pub fn siconos_tridiagonal(equalities: usize, shifted: bool) -> Result<Known, ModelError> {
    let q = |i: usize| if shifted { -5.0 - i as f64 } else { 7.0 - i as f64 };
    let m = |i: usize, j: usize| match i.abs_diff(j) {
        0 => 2.0,
        1 => 1.0,
        _ => 0.0,
    };
    let model = Affine::new(equalities, (0..10).map(q).collect(), m)?;
    from_zero(format!("siconos-tridiagonal-{equalities}"), model, vec![])
}

/// Murty's family: upper triangular with 1 and 2, `q = −1`; solution `e_n` ([Mur78](crate#references)).
///
/// # Errors
/// None in practice.
pub fn murty(n: usize) -> Result<Known, ModelError> {
    let model = Affine::new(0, vec![-1.0; n], murty_matrix)?;
    from_zero(format!("murty-{n}"), model, vec![unit(n, n - 1)])
}

pub(crate) fn murty_matrix(i: usize, j: usize) -> f64 {
    match i.cmp(&j) {
        std::cmp::Ordering::Less => 2.0,
        std::cmp::Ordering::Equal => 1.0,
        std::cmp::Ordering::Greater => 0.0,
    }
}

/// Fathi's family: `MᵀM` of Murty's, symmetric positive definite, `q = −1`; solution `e_1`
/// ([Fat79](crate#references)).
///
/// # Errors
/// None in practice.
pub fn fathi(n: usize) -> Result<Known, ModelError> {
    let m = |i: usize, j: usize| 4.0 * i.min(j) as f64 + if i == j { 1.0 } else { 2.0 };
    from_zero(format!("fathi-{n}"), Affine::new(0, vec![-1.0; n], m)?, vec![unit(n, 0)])
}

/// Ahn's family: tridiagonal `(1, 4, −2)`, `q = −1` ([Ahn83](crate#references)).
///
/// # Errors
/// None in practice.
pub fn ahn(n: usize) -> Result<Known, ModelError> {
    from_zero(format!("ahn-{n}"), Affine::new(0, vec![-1.0; n], ahn_matrix)?, vec![])
}

pub(super) fn ahn_matrix(i: usize, j: usize) -> f64 {
    match (i, j) {
        (i, j) if i == j => 4.0,
        (i, j) if j == i + 1 => -2.0,
        (i, j) if i == j + 1 => 1.0,
        _ => 0.0,
    }
}

/// A P-matrix on which the pure Newton method of the min map cycles ([BG12](crate#references)): `q = 1` from
/// `(−1, 0, 0)`, `q = −1` from `(1, 0, 0)`.
///
/// # Errors
/// None in practice.
pub fn cyclic(q: f64) -> Result<Known, ModelError> {
    let solution = if q > 0.0 { vec![0.0; 3] } else { vec![1.0 / 3.0; 3] };
    let model = Affine::new(0, vec![q; 3], cyclic_matrix)?;
    let starts = vec![vec![-q, 0.0, 0.0], vec![0.0; 3]];
    Known::new(format!("cyclic({q})"), model, starts, vec![solution])
}

pub(super) fn cyclic_matrix(i: usize, j: usize) -> f64 {
    [[1.0, 0.0, 2.0], [2.0, 1.0, 0.0], [0.0, 2.0, 1.0]][i][j]
}

/// The Hilbert matrix with `q = −1`: positive definite, condition 10¹⁰ at `n = 8`.
///
/// # Errors
/// None in practice.
pub fn hilbert(n: usize) -> Result<Known, ModelError> {
    let model = Affine::new(0, vec![-1.0; n], hilbert_matrix)?;
    from_zero(format!("hilbert-{n}"), model, vec![])
}

pub(crate) fn hilbert_matrix(i: usize, j: usize) -> f64 {
    1.0 / (i + j + 1) as f64
}

/// Membrane over an obstacle on a `k × k` interior grid: `−Δu = −10`, `u >= ψ`,
/// `ψ = −0.3 + 0.15 sin 3πx sin 3πy`, with `z = u − ψ` and `F = A(z + ψ) + 10 h²`, five-point
/// stencil.
///
/// # Errors
/// None in practice.
pub fn obstacle(k: usize) -> Result<Known, ModelError> {
    from_zero(format!("obstacle-{k}"), obstacle_model(k)?, vec![])
}

pub(crate) fn obstacle_model(k: usize) -> Result<Affine, ModelError> {
    let h = 1.0 / (k + 1) as f64;
    let wave = |i: usize| (3.0 * std::f64::consts::PI * (i + 1) as f64 * h).sin();
    let psi = |x: usize, y: usize| -0.3 + 0.15 * wave(x) * wave(y);
    let (mut q, mut rows) = (Vec::new(), Vec::new());
    for y in 0..k {
        for x in 0..k {
            let mut row = vec![(x + k * y, 4.0)];
            let mut load = 10.0 * h * h + 4.0 * psi(x, y);
            let neighbours = [
                (x > 0).then(|| (x - 1, y)),
                (x + 1 < k).then(|| (x + 1, y)),
                (y > 0).then(|| (x, y - 1)),
                (y + 1 < k).then(|| (x, y + 1)),
            ];
            for (x, y) in neighbours.into_iter().flatten() {
                row.push((x + k * y, -1.0));
                load -= psi(x, y);
            }
            q.push(load);
            rows.push(row);
        }
    }
    Affine::sparse(q, rows)
}
