//! The Zhuravlev–Ivanov model of a bouncing mass, in implicit steps.

use super::{Known, equalities_first};
use crate::dynamics::{DynamicsError, StepReport, StepSize, TimeStepper};
use crate::error::ModelError;
use crate::model::{Model, Reader, Shape};
use crate::problem::{AdProblem, Problem};
use crate::scalar::{Real, Scalar};
use crate::solver::{Options, Solver};

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
    /// Step `h`.
    pub h: f64,
    /// `κ`.
    pub kappa: f64,
    /// `g`.
    pub gravity: f64,
}

impl ZhuravlevIvanov {
    /// The step from `state`, with the numbers of the test.
    ///
    /// # Errors
    /// None in practice.
    pub fn new(state: [f64; 2]) -> Result<Self, ModelError> {
        let shape = equalities_first(4, 0)?;
        Ok(ZhuravlevIvanov { shape, state, h: 1e-3, kappa: 0.7, gravity: 9.81 })
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
        let ([x, v], h, kappa, g) = (self.state, self.h, self.kappa, self.gravity);
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

/// The mass step by step.
pub struct ZhuravlevIvanovStepper {
    problem: AdProblem<ZhuravlevIvanov>,
    solver: Solver,
    z: Vec<f64>,
    warm: bool,
    steps: u64,
}

impl ZhuravlevIvanovStepper {
    /// From the state of `first`; `warm`: each solve starts at the last solution, otherwise at 0.
    ///
    /// # Errors
    /// [`ModelError::Option`].
    pub fn new(first: ZhuravlevIvanov, options: Options, warm: bool) -> Result<Self, ModelError> {
        let (problem, solver) = (AdProblem::changing(first)?, Solver::new(options)?);
        Ok(ZhuravlevIvanovStepper { problem, solver, z: vec![0.0; 4], warm, steps: 0 })
    }
}

impl TimeStepper for ZhuravlevIvanovStepper {
    fn step(&mut self) -> Result<StepReport, DynamicsError> {
        let (step, time) = (self.steps + 1, (self.steps + 1) as f64 * self.step_size());
        if !self.warm {
            self.z.fill(0.0);
        }
        let solution = self.solver.solve_from(&mut self.problem, &self.z)?;
        let residual = solution.certificate.natural_residual;
        if !solution.is_solved() {
            let (active, status) = ("p0, s0, p1, s1".to_owned(), solution.status);
            return Err(DynamicsError::NotSolved { step, time, active, status, residual });
        }
        let iterations = solution.stats.iterations;
        self.z.copy_from_slice(&solution.z);
        // x = F₀ − s₀, v = F₂ − s₁
        let state = [solution.f[0] - solution.z[1], solution.f[2] - solution.z[3]];
        self.problem.model_mut().state = state;
        self.steps = step;
        Ok(StepReport { step, time, unknowns: 4, active: 1, iterations, residual })
    }

    fn step_size(&self) -> f64 {
        self.problem.model().h
    }

    fn state_names(&self) -> Vec<String> {
        ["x", "v", "p0", "s0", "p1", "s1"].map(String::from).to_vec()
    }

    fn write_state(&self, state: &mut Vec<f64>) {
        state.clear();
        state.extend_from_slice(&self.problem.model().state);
        state.extend_from_slice(&self.z);
    }

    /// None: the state is that of the transformed equations.
    fn energy(&self) -> Option<f64> {
        None
    }

    fn size(&self) -> Result<StepSize, DynamicsError> {
        let operations_of_f = self.problem.operations().total();
        // Two subtractions are for the state.
        let operations = operations_of_f + self.problem.jacobian_operations()? + 2;
        let nonzeros = self.problem.pattern().nnz();
        Ok(StepSize { unknowns: 4, nonzeros, operations, operations_of_f })
    }
}
