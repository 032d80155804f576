//! [`EulerMoreau`]: first-order systems, step by step.

use super::complementarity_system::ComplementaritySystem;
use super::error::{DynamicsError, positive, share};
use super::sparse_rows::SparseRows;
use super::step_problem::{Law, Solved, StepProblem, Unknown};
use super::stepper::{StepReport, StepSize, TimeStepper};
use crate::linalg::LinearError;
use crate::scalar::{Counted, Scalar, Tally};
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
    /// State before the last step.
    before: Vec<f64>,
    maps: Maps,
    problem: Option<Box<StepProblem>>,
    storage: Option<Vec<f64>>,
    steps: u64,
}

/// The linear maps of a step, applied in any arithmetic; sums are taken by columns, from the first.
struct Maps {
    /// `W (I + h(1−θ)A)` and `h W b`.
    transition: SparseRows,
    drift: Vec<f64>,
    /// `C` and `a`.
    output: SparseRows,
    offset: Vec<f64>,
    /// `h W B`.
    input: SparseRows,
}

impl Maps {
    /// `x°`.
    fn free_state<D: Scalar>(&self, x: &[D], free: &mut [D]) {
        for (i, free) in free.iter_mut().enumerate() {
            *free = affine(self.transition.times(i, |j| x[j]), self.drift[i]);
        }
    }

    /// `C x° + a`.
    fn output<D: Scalar>(&self, free: &[D], y: &mut [D]) {
        for (i, y) in y.iter_mut().enumerate() {
            *y = affine(self.output.times(i, |j| free[j]), self.offset[i]);
        }
    }

    /// `x° += h W B λ`.
    fn react<D: Scalar>(&self, lambda: &[D], free: &mut [D]) {
        for (i, x) in free.iter_mut().enumerate() {
            if let Some(dx) = self.input.times(i, |j| lambda[j]) {
                *x = *x + dx;
            }
        }
    }
}

/// `sum + c`, where there is a sum and `c` is not 0.
fn affine<D: Scalar>(sum: Option<D>, c: f64) -> D {
    match sum {
        Some(sum) if c == 0.0 => sum,
        Some(sum) => sum.shift(c),
        None => D::constant(c),
    }
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
        positive("step", "the scheme", h)?;
        share("theta", "the scheme", theta)?;
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
            before: system.start.clone(),
            maps: Maps {
                transition: SparseRows::from_dense(&rows_of(
                    &(&w * (&identity + h * (1.0 - theta) * &a)),
                )),
                drift: (h * &w * drift).as_slice().to_vec(),
                output: SparseRows::from_dense(&rows_of(&c)),
                offset: system.pairs.iter().map(|pair| pair.offset).collect(),
                input: SparseRows::from_dense(&rows_of(&input)),
            },
            problem,
            storage: system.storage.clone(),
            steps: 0,
        })
    }

    /// Operations of the last step outside its problem: it is done again in the counting arithmetic.
    fn operations(&self) -> u64 {
        let tally = Tally::new();
        let numbers = |x: &[f64]| x.iter().map(|&x| tally.variable(x)).collect::<Vec<_>>();
        let x: Vec<Counted<'_>> = numbers(&self.before);
        let mut free = x.clone();
        self.maps.free_state(&x, &mut free);
        if let Some(problem) = &self.problem {
            let lambda = numbers(&problem.lambda);
            self.maps.output(&free, &mut lambda.clone());
            self.maps.react(&lambda, &mut free);
        }
        tally.counts().total()
    }
}

impl TimeStepper for EulerMoreau {
    fn step(&mut self) -> Result<StepReport, DynamicsError> {
        let (step, time) = (self.steps + 1, (self.steps + 1) as f64 * self.h);
        let EulerMoreau { x, before, maps, problem, .. } = self;
        // What was `before` becomes the state, unless the step fails.
        let next = before;
        maps.free_state(x, next);
        if let Some(i) = next.iter().position(|x| !x.is_finite()) {
            return Err(DynamicsError::NotFinite { name: self.names[i].clone(), time });
        }
        let (mut solved, mut active) = (Solved::default(), 0);
        if let Some(problem) = problem {
            maps.output(next, &mut problem.data_mut().q);
            solved = problem.solve(step, time)?;
            maps.react(&problem.lambda, next);
            active = problem.inner_pairs();
        }
        std::mem::swap(x, next);
        self.steps = step;
        Ok(StepReport {
            step,
            time,
            unknowns: self.maps.offset.len(),
            active,
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

    fn size(&self) -> Result<StepSize, DynamicsError> {
        StepSize::of(self.operations(), self.problem.as_deref())
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
    problem.data_mut().m.values.copy_from_slice(&matrix.values);
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
