//! Karush–Kuhn–Tucker systems of two small programs: equations first, then inequalities.

use super::{Affine, Known, equalities_first};
use crate::error::ModelError;
use crate::model::{Model, Reader, Shape};
use crate::scalar::{Real, Scalar};

/// Nocedal & Wright (2006), example 16.4: `min (x₁−1)² + (x₂−2.5)²` under five inequalities;
/// solution `x = (1.4, 1.7)`, first multiplier 0.8.
///
/// # Errors
/// None in practice.
pub fn nocedal_16_4() -> Result<Known, ModelError> {
    let a = [[1.0, -2.0], [-1.0, -2.0], [-1.0, 2.0], [1.0, 0.0], [0.0, 1.0]];
    let m = |i: usize, j: usize| match (i < 2, j < 2) {
        (true, true) if i == j => 2.0,
        (true, false) => -a[j - 2][i],
        (false, true) => a[i - 2][j],
        _ => 0.0,
    };
    let model = Affine::new(2, vec![-2.0, -5.0, 2.0, 6.0, 2.0, 0.0, 0.0], m)?;
    let solution = vec![1.4, 1.7, 0.8, 0.0, 0.0, 0.0, 0.0];
    Known::new("nocedal-16.4", model, vec![vec![0.0; 7]], vec![solution])
}

pub(super) struct RosenSuzuki(Shape);

impl RosenSuzuki {
    pub(super) fn new() -> Result<Self, ModelError> {
        Ok(RosenSuzuki(equalities_first(7, 4)?))
    }
}

impl Model for RosenSuzuki {
    const WHOLE: Option<usize> = Some(7);

    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let mut f = [Real::from(0.0); 7];
        self.whole(read, &mut f);
        f[i]
    }
    /// `∇f(x) − Σ λ_k ∇g_k(x) = 0`, `g(x) >= 0 ⟂ λ >= 0`.
    fn whole<D: Scalar>(&self, read: &Reader<'_, D>, f: &mut [Real<D>]) {
        let [a, b, c, d, u, v, w] = read.first();
        f[0] = 2.0 * a - 5.0 - u * (-2.0 * a - 1.0) - v * (-2.0 * a + 1.0) - w * (-4.0 * a - 2.0);
        f[1] = 2.0 * b - 5.0 - u * (-2.0 * b + 1.0) - v * (-4.0 * b) - w * (-2.0 * b + 1.0);
        f[2] = 4.0 * c - 21.0 - u * (-2.0 * c - 1.0) - v * (-2.0 * c) - w * (-2.0 * c);
        f[3] = 2.0 * d + 7.0 - u * (-2.0 * d + 1.0) - v * (-4.0 * d + 1.0) - w;
        f[4] = 8.0 - a * a - b * b - c * c - d * d - a + b - c + d;
        f[5] = 10.0 - a * a - 2.0 * b * b - c * c - 2.0 * d * d + a + d;
        f[6] = 5.0 - 2.0 * a * a - b * b - c * c - 2.0 * a + b + d;
    }
}

/// Rosen & Suzuki (1965), problem 43 of Hock & Schittkowski (1981): `x = (0, 1, 2, −1)`,
/// multipliers `(1, 0, 2)`.
///
/// # Errors
/// None in practice.
pub fn rosen_suzuki() -> Result<Known, ModelError> {
    let solution = vec![0.0, 1.0, 2.0, -1.0, 1.0, 0.0, 2.0];
    Known::new("rosen-suzuki", RosenSuzuki::new()?, vec![vec![0.0; 7]], vec![solution])
}
