//! Shared by the acceptance tests: problems written by hand, and settings that recur.

#![allow(dead_code, reason = "every test file uses another part")]

use mcp_core::{
    Criterion, Iteration, Method, Options, Pattern, Problem, Shape, Solution, Solver, examine,
};
use std::ops::ControlFlow;
use std::sync::Arc;

pub(crate) const INF: f64 = f64::INFINITY;
pub(crate) const FREE: (f64, f64) = (-INF, INF);
pub(crate) const NONNEGATIVE: (f64, f64) = (0.0, INF);

/// `F` and `J` as one closure: `evaluate(z, f, jac)`, `jac` in the order of the pattern.
pub(crate) struct ByHand<E> {
    shape: Arc<Shape>,
    pattern: Pattern,
    evaluate: E,
    f: Vec<f64>,
    jac: Vec<f64>,
}

impl<E: FnMut(&[f64], &mut [f64], &mut [f64])> Problem for ByHand<E> {
    fn shape(&self) -> &Arc<Shape> {
        &self.shape
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        (self.evaluate)(z, &mut self.f, &mut self.jac);
        if let Some(f) = f {
            f.copy_from_slice(&self.f);
        }
        if let Some(jac) = jac {
            jac.copy_from_slice(&self.jac);
        }
    }
}

/// A problem with the given pattern.
pub(crate) fn with_pattern<E: FnMut(&[f64], &mut [f64], &mut [f64])>(
    pattern: Pattern,
    bounds: &[(f64, f64)],
    start: &[f64],
    evaluate: E,
) -> ByHand<E> {
    let (lower, upper): (Vec<f64>, Vec<f64>) = bounds.iter().copied().unzip();
    let shape = Shape::anonymous(&lower, &upper, start).expect("the bounds make sense").into();
    let (f, jac) = (vec![0.0; bounds.len()], vec![0.0; pattern.nnz()]);
    ByHand { shape, pattern, evaluate, f, jac }
}

/// A problem with a dense Jacobian, column by column.
pub(crate) fn dense<E: FnMut(&[f64], &mut [f64], &mut [f64])>(
    bounds: &[(f64, f64)],
    start: &[f64],
    evaluate: E,
) -> ByHand<E> {
    with_pattern(Pattern::dense(bounds.len()), bounds, start, evaluate)
}

/// One equation: `f(z)` gives `(F, F')`.
pub(crate) fn scalar(
    bounds: (f64, f64),
    start: f64,
    f: impl Fn(f64) -> (f64, f64),
) -> impl Problem {
    dense(&[bounds], &[start], move |z: &[f64], out: &mut [f64], jac: &mut [f64]| {
        (out[0], jac[0]) = f(z[0]);
    })
}

/// `F = M z + q`, `M` row by row.
pub(crate) fn affine(
    m: Vec<Vec<f64>>,
    q: Vec<f64>,
    bounds: &[(f64, f64)],
    start: &[f64],
) -> impl Problem + use<> {
    dense(bounds, start, move |z: &[f64], f: &mut [f64], jac: &mut [f64]| {
        let n = z.len();
        for i in 0..n {
            f[i] = q[i] + (0..n).map(|j| m[i][j] * z[j]).sum::<f64>();
            for j in 0..n {
                jac[i + n * j] = m[i][j];
            }
        }
    })
}

/// The settings of the Siconos comparison: `‖Φ‖₂ <= 1e-10`, 1000 iterations, its first step.
pub(crate) fn siconos(method: Method) -> Options {
    Options::new(method).with(|o| {
        o.tol = Some(1e-10);
        o.max_iterations = 1000;
        o.criterion = Criterion::FbNorm;
        o.armijo.first_step = if method == Method::OldFb { 1.0 } else { 2.0 };
    })
}

/// One solve by a new solver.
pub(crate) fn solve(problem: &mut dyn Problem, options: &Options) -> Solution {
    let mut solver = Solver::new(options.clone()).expect("the options are in range");
    solver.solve(problem).expect("the linear solver takes the problem").clone()
}

/// One solve from `start` by a new solver.
pub(crate) fn solve_from(problem: &mut dyn Problem, start: &[f64], options: &Options) -> Solution {
    let mut solver = Solver::new(options.clone()).expect("the options are in range");
    solver.solve_from(problem, start).expect("the start fits").clone()
}

/// What a monitor saw of one iterate.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Seen {
    pub(crate) k: usize,
    pub(crate) evaluations: usize,
    pub(crate) fb_norm: f64,
    pub(crate) step: f64,
    pub(crate) letter: char,
    pub(crate) z: Vec<f64>,
    pub(crate) f: Vec<f64>,
}

/// One solve by a new solver, with all its iterates.
pub(crate) fn watch(
    problem: &mut dyn Problem,
    start: Option<&[f64]>,
    options: &Options,
) -> (Solution, Vec<Seen>) {
    let mut seen = Vec::new();
    let mut record = |it: &Iteration<'_>| {
        seen.push(Seen {
            k: it.k,
            evaluations: it.residual_evaluations,
            fb_norm: it.fb_norm,
            step: it.step,
            letter: it.direction.letter(),
            z: it.z.to_vec(),
            f: it.f.to_vec(),
        });
        ControlFlow::Continue(())
    };
    let mut solver = Solver::new(options.clone()).expect("the options are in range");
    let solution = solver.solve_monitored(problem, start, &mut record).expect("the start fits");
    let solution = solution.clone();
    (solution, seen)
}

/// Dense `F` and `J`, column by column.
pub(crate) fn evaluate(problem: &mut dyn Problem, z: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let n = z.len();
    let (mut f, mut values) = (vec![0.0; n], vec![0.0; problem.pattern().nnz()]);
    problem.evaluate(z, Some(&mut f), Some(&mut values));
    let mut jac = vec![0.0; n * n];
    for (k, i, j) in problem.pattern().entries() {
        jac[i + n * j] = values[k];
    }
    (f, jac)
}

/// `max |mid(z−l, F, z−u)|`, by sorting: shares no code with the library. NaN stays NaN.
pub(crate) fn natural_residual(problem: &mut dyn Problem, z: &[f64]) -> f64 {
    let mut f = vec![0.0; z.len()];
    problem.evaluate(z, Some(&mut f), None);
    let bounds = problem.shape().bounds();
    let mut worst = 0.0_f64;
    for i in 0..z.len() {
        let mut three = [z[i] - bounds.lower()[i], f[i], z[i] - bounds.upper()[i]];
        if three.iter().any(|x| x.is_nan()) {
            return f64::NAN;
        }
        three.sort_by(f64::total_cmp);
        worst = worst.max(three[1].abs());
    }
    worst
}

/// What must hold however a solve ends: `z` in the box, `F` as reported, `Solved` exactly if an
/// independent certificate accepts.
pub(crate) fn check_honest(
    problem: &mut dyn Problem,
    solution: &Solution,
    options: &Options,
    case: &str,
) {
    let mut f = vec![0.0; solution.z.len()];
    problem.evaluate(&solution.z, Some(&mut f), None);
    assert!(problem.shape().bounds().contain(&solution.z), "{case}: outside the box");
    let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&solution.f), bits(&f), "{case}: F as reported");
    let verdict = examine(problem, &solution.z)
        .expect("z has the right length")
        .verdict(options.tol, options.tol_relative);
    let accepted = verdict == mcp_core::Verdict::Accepted;
    assert_eq!(solution.is_solved(), accepted, "{case}: {} but {verdict:?}", solution.status);
    if let (true, Some(tol)) = (accepted, options.tol) {
        assert!(natural_residual(problem, &solution.z) <= tol, "{case}: residual above tol");
        assert!(f.iter().all(|f| f.is_finite()), "{case}: F is not finite");
    }
}
