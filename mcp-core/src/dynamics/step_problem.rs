//! [`StepProblem`]: the mixed complementarity problem of one time step.

use super::error::DynamicsError;
use super::sparse_rows::SparseRows;
use crate::globalise::Stall;
use crate::model::{Equation, Model, Reader, Set, Shape, Variable};
use crate::problem::{AdProblem, Problem};
use crate::scalar::{Real, Scalar};
use crate::solver::{Method, Options, Solution, Solver};

/// How an unknown `λ_i` and `y_i = q_i + Σ_j M_ij λ_j` belong together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Law {
    /// `y_i` complementary to `λ_i` between its bounds.
    Bounds,
    /// Coulomb's law in the plane: `λ_i` opposes the slip `y_i` with at most `μ λ_normal`.
    Coulomb { normal: usize, mu: f64 },
}

/// An unknown of a step.
#[derive(Clone, Debug)]
pub(super) struct Unknown {
    pub(super) name: String,
    pub(super) lower: f64,
    pub(super) upper: f64,
    pub(super) law: Law,
}

/// The numbers of a step problem, in any arithmetic.
pub(super) struct StepData<D = f64> {
    pub(super) q: Vec<D>,
    pub(super) m: SparseRows<D>,
    /// `1 / M_ii` of friction rows.
    pub(super) rho: Vec<D>,
}

impl StepData {
    /// Place for the same numbers in another arithmetic.
    pub(super) fn zeros_like<D: Scalar>(&self) -> StepData<D> {
        let zeros = vec![D::constant(0.0); self.q.len()];
        StepData { q: zeros.clone(), m: self.m.zeros_like(), rho: zeros }
    }
}

/// The problem of one step, affine but for friction:
///
/// ```text
/// y = q + M λ
/// F_i = y_i                                                  by the bounds of λ_i
/// F_i = λ_i − clamp(λ_i − y_i / M_ii, −μ λ_n, μ λ_n)         friction, λ_i free
/// ```
///
/// The second is Coulomb's law for every factor of `y_i`; with `1/M_ii` a sticking contact has the
/// same units on both sides. `q` and `M` change from step to step, the pattern does not.
pub(super) struct StepModel {
    shape: Shape,
    laws: Vec<Law>,
    pub(super) data: StepData,
}

impl StepModel {
    /// `y_i = Σ_j M_ij λ_j + q_i`.
    fn y<D: Scalar>(&self, i: usize, lambda: impl Fn(usize) -> D) -> D {
        let StepData { q, m, .. } = &self.data;
        m.times(i, lambda).map_or(D::constant(q[i]), |y| y.shift(q[i]))
    }
}

impl Model for StepModel {
    fn shape(&self) -> &Shape {
        &self.shape
    }

    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let y = Real::from_scalar(self.y(i, |j| read.var(j).0));
        match self.laws[i] {
            Law::Bounds => y,
            Law::Coulomb { normal, mu } => {
                let (r, limit) = (read.var(i), mu * read.var(normal));
                r - (r - self.data.rho[i] * y).clamp(-limit, limit)
            }
        }
    }
}

/// What the solve of a step cost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Solved {
    pub(super) iterations: usize,
    pub(super) residual: f64,
}

impl Solved {
    fn of(solution: &Solution) -> Self {
        let residual = solution.certificate.natural_residual;
        Solved { iterations: solution.stats.iterations, residual }
    }
}

/// The problem of a step for one set of active pairs, with its solver: pattern, symbolic work and
/// memory are kept while the set stays the same.
pub(super) struct StepProblem {
    problem: AdProblem<StepModel>,
    solver: Solver,
    /// For steps that the first does not solve.
    second: Option<Box<Solver>>,
    /// Start of the next solve, and its solution.
    pub(super) lambda: Vec<f64>,
    /// `F` there.
    y: Vec<f64>,
    names: String,
}

impl StepProblem {
    /// For these unknowns; `columns` are the unknowns that each `y_i` reads.
    pub(super) fn new(
        unknowns: &[Unknown],
        columns: &[Vec<usize>],
        options: &Options,
    ) -> Result<Self, DynamicsError> {
        let n = unknowns.len();
        let labels = Set::new("pairs", unknowns.iter().map(|u| u.name.clone()))?;
        let bounds = |bound: fn(&Unknown) -> f64| unknowns.iter().map(bound).collect::<Vec<_>>();
        let lambda = Variable::new("lambda")
            .over(&[&labels])
            .lower(bounds(|u| u.lower))
            .upper(bounds(|u| u.upper));
        let law = Equation::new("y").over(&[&labels]).complements("lambda");
        let shape = Shape::builder().variable(lambda).equation(law).build()?;
        let model = StepModel {
            shape,
            laws: unknowns.iter().map(|u| u.law).collect(),
            data: StepData {
                q: vec![0.0; n],
                m: SparseRows::with_columns(columns),
                rho: vec![0.0; n],
            },
        };
        let names: Vec<&str> = unknowns.iter().map(|u| u.name.as_str()).collect();
        Ok(StepProblem {
            problem: AdProblem::changing(model)?,
            solver: Solver::new(options.clone())?,
            second: None,
            lambda: vec![0.0; n],
            y: vec![0.0; n],
            names: names.join(", "),
        })
    }

    /// The data of the step, to be changed.
    pub(super) fn data_mut(&mut self) -> &mut StepData {
        &mut self.problem.model_mut().data
    }

    /// The data of the step.
    pub(super) fn data(&self) -> &StepData {
        &self.problem.model().data
    }

    /// Pairs with `F = 0` at the last solution: `|F_i|` is below the distance of `λ_i` from its bounds.
    pub(super) fn inner_pairs(&self) -> usize {
        let bounds = self.problem.shape().bounds();
        let inner = |&i: &usize| {
            let (below, above) =
                (self.lambda[i] - bounds.lower()[i], bounds.upper()[i] - self.lambda[i]);
            self.y[i].abs() < below.min(above)
        };
        (0..self.lambda.len()).filter(inner).count()
    }

    /// Solves from `lambda`, where the solution is put; `step` and `time` name a failure.
    pub(super) fn solve(&mut self, step: u64, time: f64) -> Result<Solved, DynamicsError> {
        let first = self.solver.solve_from(&mut self.problem, &self.lambda)?;
        let mut solved = Solved::of(first);
        let solution = if first.is_solved() {
            first
        } else {
            let second = match &mut self.second {
                Some(second) => second,
                none => none.insert(Box::new(Solver::new(second_options())?)),
            };
            let solution = second.solve_from(&mut self.problem, &self.lambda)?;
            let iterations = solved.iterations + solution.stats.iterations;
            solved = Solved { iterations, ..Solved::of(solution) };
            solution
        };
        if !solution.is_solved() {
            let (active, status, residual) = (self.names.clone(), solution.status, solved.residual);
            return Err(DynamicsError::NotSolved { step, time, active, status, residual });
        }
        self.lambda.copy_from_slice(&solution.z);
        self.y.copy_from_slice(&solution.f);
        Ok(solved)
    }

    /// Structural nonzeros of `J`.
    pub(super) fn nonzeros(&self) -> usize {
        self.problem.pattern().nnz()
    }

    /// Operations of one `F` and one `J`.
    pub(super) fn operations(&self) -> Result<u64, DynamicsError> {
        Ok(self.operations_of_f() + self.problem.jacobian_operations()?)
    }

    /// Operations of one `F`.
    pub(super) fn operations_of_f(&self) -> u64 {
        self.problem.operations().total()
    }
}

/// Options of a step: [`Method::NewtonMinFb`] to `1e-13`.
///
/// The problems are affine or nearly so, and one step of the min map from the last solution solves
/// them to the last digits. A step on which it makes no progress for ten iterations, such as where it
/// cycles ([BG12](crate#references)), is given to [`Method::Robust`], to `1e-12` of the terms of each
/// equation.
#[must_use]
pub fn step_options() -> Options {
    Options::new(Method::NewtonMinFb).with(|o| {
        o.tol = Some(1e-13);
        o.stall = Some(Stall { iterations: 10, ..Stall::default() });
    })
}

fn second_options() -> Options {
    Options::new(Method::Robust).with(|o| o.tol_relative = 1e-12)
}
