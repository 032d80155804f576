//! [`Kkt`]: the model whose rows are derivatives of the Lagrangian.

use super::directional::Directional;
use super::{KktBuilder, Program};
use crate::model::{Model, Reader, Shape};
use crate::scalar::{Real, Scalar, Trace};

/// The Karush–Kuhn–Tucker system of a [`Program`]; see the [module page](super).
///
/// Variables: `x` in the order of declaration, then the multipliers `λ`. Row `∂L/∂x_j` evaluates `f`
/// and those `g_k` that use `x_j`, and reads what they use; its Jacobian is a row of `∇²L` beside a
/// row of `−g'(x)ᵀ`. One evaluation of all rows costs about `n` of `f` and, for each `k`, as many of
/// `g_k` as it uses variables, each with one lane more; a row allocates the point it is evaluated at.
#[derive(Clone, Debug)]
pub struct Kkt<P> {
    program: P,
    system: System,
}

/// Everything about the system but the functions.
#[derive(Clone, Debug)]
pub(super) struct System {
    /// 1 to minimise, −1 to maximise.
    sense: f64,
    shape: Shape,
    /// Number of variables `x`.
    n: usize,
    /// Variables that `f` uses, increasing.
    objective: Vec<usize>,
    /// Variables that each `g_k` uses, increasing.
    constraints: Vec<Vec<usize>>,
    /// What `∂L/∂x_j` depends on.
    slopes: Vec<Slope>,
}

/// What `∂L/∂x_j` depends on.
#[derive(Clone, Debug)]
struct Slope {
    /// Whether `f` uses `x_j`.
    in_objective: bool,
    /// The constraints that use `x_j`.
    constraints: Vec<usize>,
    /// Variables that any of these functions uses, increasing.
    variables: Vec<usize>,
}

/// The functions of a program in one arithmetic, whatever the program: what uses them is compiled
/// once for all programs.
pub(super) trait FunctionsIn<D: Scalar> {
    fn f(&self, x: &[Real<D>]) -> Real<D>;
    fn g(&self, k: usize, x: &[Real<D>]) -> Real<D>;
}

impl<P: Program, D: Scalar> FunctionsIn<D> for P {
    fn f(&self, x: &[Real<D>]) -> Real<D> {
        self.objective(x)
    }
    fn g(&self, k: usize, x: &[Real<D>]) -> Real<D> {
        self.constraint(k, x)
    }
}

impl<P: Program> Kkt<P> {
    /// Starts the declaration of `min f(x)`.
    pub fn minimise(program: P) -> KktBuilder<P> {
        KktBuilder::new(program, 1.0)
    }

    /// Starts the declaration of `max f(x)`.
    pub fn maximise(program: P) -> KktBuilder<P> {
        KktBuilder::new(program, -1.0)
    }

    pub(super) fn new(program: P, system: System) -> Self {
        Kkt { program, system }
    }

    /// The program.
    pub fn program(&self) -> &P {
        &self.program
    }
}

impl System {
    /// The system of a shape whose last `m` variables are multipliers.
    pub(super) fn new(
        program: &dyn FunctionsIn<Trace>,
        sense: f64,
        shape: Shape,
        m: usize,
    ) -> Self {
        let n = shape.n() - m;
        let at = &shape.start()[..n];
        let objective = support(at, &|x| program.f(x));
        let constraints: Vec<Vec<usize>> =
            (0..m).map(|k| support(at, &|x| program.g(k, x))).collect();
        let slopes = (0..n).map(|j| Slope::new(j, &objective, &constraints)).collect();
        System { sense, shape, n, objective, constraints, slopes }
    }

    /// `sense · ∂L/∂x_j`, with `L = f − Σ λ_k (g_k − b_k)`.
    fn slope<D: Scalar>(
        &self,
        program: &dyn FunctionsIn<Directional<D>>,
        j: usize,
        read: &Reader<'_, D>,
    ) -> Real<D> {
        let Slope { in_objective, constraints, variables } = &self.slopes[j];
        let x = self.point(variables, |i| Directional::new(read.var(i).0, i == j));
        let by_x_j = |value: Real<Directional<D>>| Real(value.0.derivative());
        let mut slope = Real::from(0.0);
        if *in_objective {
            slope += by_x_j(program.f(&x));
        }
        for &k in constraints {
            slope -= read.var(self.n + k) * by_x_j(program.g(k, &x));
        }
        self.sense * slope
    }

    /// `sense · (g_k − b_k)`; in the arithmetic of the slopes, so that programs are compiled in no
    /// other.
    fn gap<D: Scalar>(
        &self,
        program: &dyn FunctionsIn<Directional<D>>,
        k: usize,
        read: &Reader<'_, D>,
    ) -> Real<D> {
        let x = self.point(&self.constraints[k], |i| Directional::new(read.var(i).0, false));
        self.sense * (Real(program.g(k, &x).0.value_in_base()) - read.param(k))
    }

    /// All of `x`, NaN where nobody reads it.
    fn point<T: Scalar>(&self, variables: &[usize], number: impl Fn(usize) -> T) -> Vec<Real<T>> {
        let mut x = vec![Real::from(f64::NAN); self.n];
        for &i in variables {
            x[i] = Real(number(i));
        }
        x
    }

    /// The last family holds the constraints, the others one slope for each variable.
    fn row<D: Scalar>(
        &self,
        program: &dyn FunctionsIn<Directional<D>>,
        (family, index): (usize, usize),
        read: &Reader<'_, D>,
    ) -> Real<D> {
        match self.shape.variables()[family].offset() + index {
            j if j < self.n => self.slope(program, j, read),
            row => self.gap(program, row - self.n, read),
        }
    }
}

impl Slope {
    fn new(j: usize, objective: &[usize], constraints: &[Vec<usize>]) -> Self {
        let in_objective = objective.contains(&j);
        let uses = |k: &usize| constraints[*k].contains(&j);
        let of_j: Vec<usize> = (0..constraints.len()).filter(uses).collect();
        let mut variables = if in_objective { objective.to_vec() } else { Vec::new() };
        variables.extend(of_j.iter().flat_map(|&k| &constraints[k]));
        variables.sort_unstable();
        variables.dedup();
        Slope { in_objective, constraints: of_j, variables }
    }
}

/// The variables that a function uses, increasing: traced, 128 at a time.
fn support(at: &[f64], function: &dyn Fn(&[Real<Trace>]) -> Real<Trace>) -> Vec<usize> {
    let mut support = Vec::new();
    for first in (0..at.len()).step_by(Trace::LANES) {
        let seed = |(j, &x): (usize, &f64)| Real(Trace::seed(x, j.wrapping_sub(first)));
        let x: Vec<Real<Trace>> = at.iter().enumerate().map(seed).collect();
        let value = function(&x).0;
        let window = first..at.len().min(first + Trace::LANES);
        support.extend(window.filter(|j| value.depends_on(j - first)));
    }
    support
}

impl<P: Program> Model for Kkt<P> {
    fn shape(&self) -> &Shape {
        &self.system.shape
    }
    fn row<D: Scalar>(&self, family: usize, index: usize, read: &Reader<'_, D>) -> Real<D> {
        self.system.row(&self.program, (family, index), read)
    }
    /// `f(x)`.
    fn report(&self, _family: usize, _index: usize, read: &Reader<'_, f64>) -> Real<f64> {
        let x = self.system.point(&self.system.objective, |i| read.var(i).0);
        self.program.objective(&x)
    }
}
