//! [`EulerMoreau`]: first-order systems, step by step.

use super::complementarity_system::ComplementaritySystem;
use super::error::{DynamicsError, positive, share};
use super::sparse_rows::SparseRows;
use super::step_problem::{Law, Solved, StepProblem, Unknown};
use super::stepper::{StepReport, StepSize, TimeStepper};
use crate::linalg::LinearError;
use crate::scalar::{Counted, OperationCounts, Scalar, Tally};
use crate::solver::Options;
use nalgebra::DMatrix;

/// The Euler–Moreau(θ) scheme for `x' = A x + b + B λ`, `y = C x + a + D λ` ([AB08](crate#references)):
///
/// ```text
/// (I − hθA) x⁺ = (I + h(1−θ)A) x + h b + h B λ⁺
/// y⁺ = C x⁺ + a + D λ⁺      complementary to λ⁺ by its bounds
/// ```
///
/// With `W = (I − hθA)⁻¹` and the free state `x° = W ((I + h(1−θ)A) x + h b)` the problem of a step
/// is `y = (C x° + a) + (h C W B + D) λ`, of as many unknowns as there are pairs; then
/// `x⁺ = x° + h W B λ`. Its matrix is the same in all steps. Without pairs there is no problem.
///
/// ```
/// use mcp_core::dynamics::{ComplementaritySystem, EulerMoreau, Pair, TimeStepper, step_options};
/// // x' = λ with the relay λ = −sign(x): 0 is reached in finite time and held.
/// let mut system = ComplementaritySystem::new(["x"], &[0.25], &[vec![0.0]])?;
/// system.pair(Pair::new("relay", [1.0], [1.0]).within(-1.0, 1.0))?;
/// let mut stepper = EulerMoreau::new(&system, 0.1, 0.5, &step_options())?;
/// for _ in 0..5 {
///     stepper.step()?;
/// }
/// assert!(stepper.state()[0].abs() < 1e-15);
/// # Ok::<(), mcp_core::dynamics::DynamicsError>(())
/// ```
pub struct EulerMoreau {
    h: f64,
    names: Vec<String>,
    x: Vec<f64>,
    free: Vec<f64>,
    /// `W (I + h(1−θ)A)` and `h W b`.
    transition: SparseRows,
    drift: Vec<f64>,
    /// `C` and `a`.
    output: SparseRows,
    offset: Vec<f64>,
    /// `h W B`.
    input: SparseRows,
    problem: Option<Box<StepProblem>>,
    storage: Option<Vec<f64>>,
    steps: u64,
}

impl EulerMoreau {
    /// The system with step size `h` and `0 <= θ <= 1`, its steps solved with these options
    /// ([`step_options`](super::step_options)).
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] for `h` and `θ`, [`DynamicsError::Linear`] if `I − hθA` is
    /// singular, [`DynamicsError::Model`] for bounds no number satisfies or names used twice.
    pub fn new(
        system: &ComplementaritySystem,
        h: f64,
        theta: f64,
        options: &Options,
    ) -> Result<Self, DynamicsError> {
        positive(|| "the step h".to_owned(), h)?;
        share(|| "theta".to_owned(), theta)?;
        let (n, m) = (system.states.len(), system.pairs.len());
        let a = DMatrix::from_fn(n, n, |i, j| system.a[i][j]);
        let identity = DMatrix::<f64>::identity(n, n);
        let singular = LinearError::Singular { column: n.saturating_sub(1) };
        let w = (&identity - h * theta * &a).try_inverse().ok_or(singular)?;
        let b = DMatrix::from_fn(n, m, |i, j| system.pairs[j].input[i]);
        let c = DMatrix::from_fn(m, n, |i, j| system.pairs[i].output[j]);
        let drift = DMatrix::from_column_slice(n, 1, &system.drift);
        let mut d = DMatrix::zeros(m, m);
        for &(i, j, value) in &system.feedthrough {
            d[(i, j)] += value;
        }
        let input = h * &w * b;
        let coupling = rows_of(&(&c * &input + d));
        let problem = (m > 0).then(|| step_problem(system, &coupling, options)).transpose()?;
        Ok(EulerMoreau {
            h,
            names: state_names(system),
            x: system.start.clone(),
            free: vec![0.0; n],
            transition: SparseRows::from_dense(&rows_of(
                &(&w * (&identity + h * (1.0 - theta) * &a)),
            )),
            drift: (h * &w * drift).as_slice().to_vec(),
            output: SparseRows::from_dense(&rows_of(&c)),
            offset: system.pairs.iter().map(|pair| pair.offset).collect(),
            input: SparseRows::from_dense(&rows_of(&input)),
            problem,
            storage: system.storage.clone(),
            steps: 0,
        })
    }

    /// `x°_i`, in any arithmetic.
    fn free_state<D: Scalar>(&self, i: usize, x: impl Fn(usize) -> D) -> D {
        let moved = self.transition.times(i, x);
        if self.drift[i] == 0.0 { moved } else { moved + D::constant(self.drift[i]) }
    }

    /// Operations of the free state and of `C x° + a`.
    fn free_operations(&self) -> OperationCounts {
        let tally = Tally::new();
        let x: Vec<Counted<'_>> = self.x.iter().map(|&x| tally.variable(x)).collect();
        for i in 0..x.len() {
            self.free_state(i, |j| x[j]);
        }
        for i in 0..self.offset.len() {
            self.output_at(i, |j| x[j]);
        }
        tally.counts()
    }

    /// `(C x + a)_i`.
    fn output_at<D: Scalar>(&self, i: usize, x: impl Fn(usize) -> D) -> D {
        let output = self.output.times(i, x);
        if self.offset[i] == 0.0 { output } else { output + D::constant(self.offset[i]) }
    }
}

impl TimeStepper for EulerMoreau {
    fn step(&mut self) -> Result<StepReport, DynamicsError> {
        let (step, time) = (self.steps + 1, (self.steps + 1) as f64 * self.h);
        for i in 0..self.x.len() {
            self.free[i] = self.free_state(i, |j| self.x[j]);
        }
        if let Some(i) = self.free.iter().position(|x| !x.is_finite()) {
            return Err(DynamicsError::NotFinite { name: self.names[i].clone(), time });
        }
        let mut solved = Solved::default();
        if let Some(mut problem) = self.problem.take() {
            for i in 0..self.offset.len() {
                problem.model_mut().q[i] = self.output_at(i, |j| self.free[j]);
            }
            let result = problem.solve(step, time);
            if result.is_ok() {
                for i in 0..self.x.len() {
                    self.free[i] += self.input.times(i, |j| problem.lambda[j]);
                }
            }
            self.problem = Some(problem);
            solved = result?;
        }
        std::mem::swap(&mut self.x, &mut self.free);
        self.steps = step;
        let unknowns = self.offset.len();
        Ok(StepReport {
            step,
            time,
            unknowns,
            active: unknowns,
            iterations: solved.iterations,
            residual: solved.residual,
        })
    }

    fn step_size(&self) -> f64 {
        self.h
    }

    fn state_names(&self) -> Vec<String> {
        self.names.clone()
    }

    fn write_state(&self, state: &mut Vec<f64>) {
        state.clear();
        state.extend_from_slice(&self.x);
        if let Some(problem) = &self.problem {
            state.extend_from_slice(&problem.lambda);
        }
    }

    fn energy(&self) -> Option<f64> {
        let weights = self.storage.as_ref()?;
        Some(weights.iter().zip(&self.x).map(|(s, x)| 0.5 * s * x * x).sum())
    }

    fn size(&self) -> StepSize {
        let nonzeros = self.problem.as_deref().map_or(0, StepProblem::nonzeros);
        let of_problem = self.problem.as_deref().map(StepProblem::operations);
        let counts = std::iter::once(self.free_operations()).chain(of_problem);
        StepSize::new(self.offset.len(), nonzeros, counts)
    }
}

/// The problem of all steps: its matrix is constant.
fn step_problem(
    system: &ComplementaritySystem,
    coupling: &[Vec<f64>],
    options: &Options,
) -> Result<Box<StepProblem>, DynamicsError> {
    let matrix = SparseRows::from_dense(coupling);
    let unknowns: Vec<Unknown> = system
        .pairs
        .iter()
        .map(|pair| Unknown {
            name: pair.name.clone(),
            lower: pair.lower,
            upper: pair.upper,
            law: Law::Bounds,
        })
        .collect();
    let columns = |i: usize| matrix.row(i).map(|(j, _)| j).collect();
    let columns: Vec<Vec<usize>> = (0..unknowns.len()).map(columns).collect();
    let mut problem = StepProblem::new(&unknowns, &columns, options)?;
    problem.model_mut().m.values.copy_from_slice(&matrix.values);
    Ok(Box::new(problem))
}

/// States, then multipliers.
fn state_names(system: &ComplementaritySystem) -> Vec<String> {
    let lambda = system.pairs.iter().map(|pair| pair.name.clone());
    system.states.iter().cloned().chain(lambda).collect()
}

fn rows_of(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}
