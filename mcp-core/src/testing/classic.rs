//! Small nonlinear problems of the literature.

use super::Known;
use crate::error::ModelError;
use crate::model::{Equation, Model, Reader, Set, Shape, Variable};
use crate::scalar::{Real, Scalar, sum};

/// `w ⟂ z >= 0` of a given size, or `w = 0` with free `z`.
fn square(n: usize, lower: f64) -> Result<Shape, ModelError> {
    let rows = Set::count("rows", n);
    Shape::builder()
        .variable(Variable::new("z").over(&[&rows]).lower(lower))
        .equation(Equation::new("w").over(&[&rows]).complements("z"))
        .build()
}

/// The four quadratic functions shared by Kojima & Shindo and Josephy.
struct Quadratic {
    shape: Shape,
    /// Coefficients of `z_3` in `F_2`, of `z_4` in `F_3`, and the constant of `F_3`.
    c: [f64; 3],
}

impl Model for Quadratic {
    const WHOLE: Option<usize> = Some(4);

    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let mut f = [Real::from(0.0); 4];
        self.whole(read, &mut f);
        f[i]
    }
    fn whole<D: Scalar>(&self, read: &Reader<'_, D>, f: &mut [Real<D>]) {
        let [x1, x2, x3, x4] = read.first();
        let c = self.c;
        f[0] = 3.0 * x1 * x1 + 2.0 * x1 * x2 + 2.0 * x2 * x2 + x3 + 3.0 * x4 - 6.0;
        f[1] = 2.0 * x1 * x1 + x1 + x2 * x2 + c[0] * x3 + 2.0 * x4 - 2.0;
        f[2] = 3.0 * x1 * x1 + x1 * x2 + 2.0 * x2 * x2 + 2.0 * x3 + c[1] * x4 - c[2];
        f[3] = x1 * x1 + 3.0 * x2 * x2 + 2.0 * x3 + 3.0 * x4 - 3.0;
    }
}

/// Starts of the Siconos comparison.
fn starts() -> Vec<Vec<f64>> {
    vec![
        vec![0.0; 4],
        vec![1.0; 4],
        vec![1.0, 0.0, 1.0, 0.0],
        vec![100.0; 4],
        vec![1.0, 0.0, 0.0, 0.0],
    ]
}

pub(crate) fn kojima_shindo_model() -> Result<impl Model + 'static, ModelError> {
    Ok(Quadratic { shape: square(4, 0.0)?, c: [10.0, 9.0, 9.0] })
}

pub(super) fn josephy_model() -> Result<impl Model + 'static, ModelError> {
    Ok(Quadratic { shape: square(4, 0.0)?, c: [3.0, 3.0, 1.0] })
}

pub(super) fn watson4_model() -> Result<impl Model + 'static, ModelError> {
    Ok(Watson4(square(5, 0.0)?))
}

pub(super) fn billups_model() -> Result<impl Model + 'static, ModelError> {
    Ok(Billups(square(1, 0.0)?))
}

/// Kojima & Shindo (1986): a degenerate solution `(√6/2, 0, 0, ½)` and a regular one
/// `(1, 0, 3, 0)`.
///
/// # Errors
/// None in practice.
pub fn kojima_shindo() -> Result<Known, ModelError> {
    let model = kojima_shindo_model()?;
    let degenerate = vec![1.5_f64.sqrt(), 0.0, 0.0, 0.5];
    Known::new("kojima-shindo", model, starts(), vec![degenerate, vec![1.0, 0.0, 3.0, 0.0]])
}

/// Josephy (1979); solution `(√6/2, 0, 0, ½)`.
///
/// # Errors
/// None in practice.
pub fn josephy() -> Result<Known, ModelError> {
    Known::new("josephy", josephy_model()?, starts(), vec![vec![1.5_f64.sqrt(), 0.0, 0.0, 0.5]])
}

struct Watson4(Shape);

impl Model for Watson4 {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let distance = |j: usize| read.var(j) - j as f64 + 1.0;
        2.0 * distance(i) * sum(0..5, |j| distance(j) * distance(j)).exp()
    }
}

/// Watson (1979), problem 4: `F_i = 2 (z_i − i + 2) exp Σ_j (z_j − j + 2)²`, `i = 1, …, 5`;
/// degenerate solution `(0, 0, 1, 2, 3)`.
///
/// # Errors
/// None in practice.
pub fn watson4() -> Result<Known, ModelError> {
    let starts = vec![vec![0.0; 5], vec![1.0; 5]];
    Known::new("watson-4", watson4_model()?, starts, vec![vec![0.0, 0.0, 1.0, 2.0, 3.0]])
}

struct Billups(Shape);

impl Model for Billups {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _family: usize, _index: usize, read: &Reader<'_, D>) -> Real<D> {
        (read.var(0) - 1.0).powi(2) - 1.01
    }
}

/// Billups (1995): `(z − 1)² − 1.01 ⟂ z >= 0`, solution `1 + √1.01`. Methods that descend on the
/// Fischer–Burmeister merit end at a local minimum near `−0.005` from the starts below 1.
///
/// # Errors
/// None in practice.
pub fn billups() -> Result<Known, ModelError> {
    let starts = [0.0, 0.5, 0.9, 1.5, 3.0].map(|z| vec![z]).to_vec();
    Known::new("billups", billups_model()?, starts, vec![vec![1.0 + 1.01_f64.sqrt()]])
}

struct LogEquation(Shape);

impl Model for LogEquation {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _family: usize, _index: usize, read: &Reader<'_, D>) -> Real<D> {
        read.var(0).ln()
    }
}

/// `ln z = 0`, `z` free: the full Newton step from 3 leaves the domain.
///
/// # Errors
/// None in practice.
pub fn log_equation() -> Result<Known, ModelError> {
    let model = LogEquation(square(1, f64::NEG_INFINITY)?);
    Known::new("log-equation", model, vec![vec![3.0]], vec![vec![1.0]])
}
