//! One implicit step of the Zhuravlev–Ivanov model of a bouncing mass.

use super::{Known, equalities_first};
use crate::error::ModelError;
use crate::model::{Model, Reader, Shape};
use crate::scalar::{Real, Scalar};

/// The step from position `x` and velocity `v`, `z = (p₀, s₀, p₁, s₁) >= 0`:
///
/// ```text
/// l = 2p − 1,  r₁ = g l₀ / (1 − κ l₀ l₁),  r₀ = −κ l₀ l₁ (v + γ h r₁)
/// F = (x + h (v + θ h r₁) + h r₀ + s₀,  1 − p₀,  v + h r₁ + s₁,  1 − p₁)
/// ```
///
/// The next state is `x = F₀ − s₀`, `v = F₂ − s₁`. Step `h = 10⁻³`, `θ = γ = 1`, `κ = 0.7`,
/// `g = 9.81`: the test `NCP_ZI1` of Siconos.
#[derive(Clone, Debug)]
pub struct ZhuravlevIvanov {
    shape: Shape,
    /// Position and velocity at the start of the step.
    pub state: [f64; 2],
}

impl ZhuravlevIvanov {
    /// The step from `state`.
    ///
    /// # Errors
    /// None in practice.
    pub fn new(state: [f64; 2]) -> Result<Self, ModelError> {
        Ok(ZhuravlevIvanov { shape: equalities_first(4, 0)?, state })
    }
}

impl Model for ZhuravlevIvanov {
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
        let [p0, s0, p1, s1] = read.first();
        let ([x, v], h, kappa, g) = (self.state, 1e-3, 0.7, 9.81);
        let (l0, l1) = (2.0 * p0 - 1.0, 2.0 * p1 - 1.0);
        let r1 = g * l0 / (1.0 - kappa * l0 * l1);
        let r0 = -kappa * l0 * l1 * (v + h * r1);
        f[0] = x + h * (v + h * r1) + h * r0 + s0;
        f[1] = 1.0 - p0;
        f[2] = v + h * r1 + s1;
        f[3] = 1.0 - p1;
    }
}

/// The first step of the test: from position 1 with velocity 10; `z = 0` solves it.
///
/// # Errors
/// None in practice.
pub fn zhuravlev_ivanov_step() -> Result<Known, ModelError> {
    let model = ZhuravlevIvanov::new([1.0, 10.0])?;
    Known::new("zhuravlev-ivanov", model, vec![vec![0.0; 4]], vec![vec![0.0; 4]])
}
