use crate::linalg::{FactorInfo, LinearError, LinearSolver, NalgebraLu};
use crate::model::Shape;
use crate::problem::{Pattern, Problem};
use crate::solver::{Method, Options, Solution, Solver};
use std::cmp::Ordering;
use std::sync::Arc;

/// `tanh z_i + c (2 z_i − z_(i−1)) − above z_(i+1) − b ⟂ −bound <= z_i <= bound` from 1, whose `J` is NaN where
/// `z_0 < edge`.
struct Chain {
    above: f64,
    shape: Arc<Shape>,
    pattern: Pattern,
    b: f64,
    edge: f64,
}

const N: usize = 5;
const C: f64 = 0.01;

fn chain(b: f64, bound: f64, edge: f64) -> Chain {
    let near = |j: usize| (j.saturating_sub(1)..N.min(j + 2)).collect();
    Chain {
        above: C,
        shape: Arc::new(Shape::anonymous(&[-bound; N], &[bound; N], &[1.0; N]).unwrap()),
        pattern: Pattern::from_columns((0..N).map(near)),
        b,
        edge,
    }
}

impl Problem for Chain {
    fn shape(&self) -> &Arc<Shape> {
        &self.shape
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        let at = |i: usize| z.get(i).copied().unwrap_or(0.0);
        if let Some(f) = f {
            for i in 0..N {
                let before = at(i.wrapping_sub(1));
                f[i] = z[i].tanh() + C * (2.0 * z[i] - before) - self.above * at(i + 1) - self.b;
            }
        }
        if let Some(jac) = jac {
            for (k, i, j) in self.pattern.entries() {
                let own = 1.0 - z[i].tanh().powi(2) + 2.0 * C;
                let value = match i.cmp(&j) {
                    Ordering::Less => -self.above,
                    Ordering::Equal => own,
                    Ordering::Greater => -C,
                };
                jac[k] = if z[0] < self.edge { f64::NAN } else { value };
            }
        }
    }
}

/// LU that says it is iterative or not, and refuses its first matrices.
struct Posing {
    lu: NalgebraLu,
    is_iterative: bool,
    refusals: usize,
}

impl LinearSolver for Posing {
    fn name(&self) -> &'static str {
        "posing LU"
    }
    fn needs_symmetry(&self) -> bool {
        true
    }
    fn is_iterative(&self) -> bool {
        self.is_iterative
    }
    fn analyse(&mut self, pattern: &Pattern) -> Result<(), LinearError> {
        self.lu.analyse(pattern)
    }
    fn factor(&mut self, values: &[f64]) -> Result<FactorInfo, LinearError> {
        if self.refusals > 0 {
            self.refusals -= 1;
            return Err(LinearError::NotDefinite { column: 0 });
        }
        self.lu.factor(values)
    }
    fn solve(&mut self, rhs: &mut [f64]) {
        self.lu.solve(rhs);
    }
    fn solve_with(&mut self, rhs: &mut [f64], lent: &mut [f64]) {
        lent.fill(f64::NAN);
        self.lu.solve(rhs);
    }
    fn solve_transposed(&mut self, rhs: &mut [f64]) {
        self.lu.solve_transposed(rhs);
    }
}

fn solve(method: Method, mut problem: Chain, is_iterative: bool, refusals: usize) -> Solution {
    let linear = Posing { lu: NalgebraLu::new(), is_iterative, refusals };
    let mut solver = Solver::with_linear_solver(Options::new(method), Box::new(linear)).unwrap();
    let first = solver.solve(&mut problem).unwrap().clone();
    assert!(first.is_solved(), "{method}: {}", first.status);
    if refusals == 0 {
        assert_eq!(*solver.solve(&mut problem).unwrap(), first, "{method}: a second solve");
    }
    first
}

#[test]
fn lists_that_serve_in_turn_change_no_bit() {
    for method in Method::CLASSICAL {
        for b in [0.0, 0.3, 2.0, -2.0] {
            let apart = solve(method, chain(b, 1.0, -5.0), false, 0);
            let in_turn = solve(method, chain(b, 1.0, -5.0), true, 0);
            assert_eq!((&in_turn.z, &in_turn.f), (&apart.z, &apart.f), "{method} {b}");
            assert_eq!(in_turn.stats, apart.stats, "{method} {b}");
        }
    }
}

#[test]
fn a_step_to_where_j_is_not_finite_is_cut_also_if_j_has_lost_its_place() {
    for method in Method::CLASSICAL {
        let apart = solve(method, chain(0.0, f64::INFINITY, -0.1), false, 0);
        let in_turn = solve(method, chain(0.0, f64::INFINITY, -0.1), true, 0);
        assert!(apart.stats.residual_evaluations > apart.stats.iterations + 1, "{method}: no cut");
        assert_eq!(in_turn.z, apart.z, "{method}");
    }
}

#[test]
fn a_jacobian_that_is_not_symmetric_keeps_its_place() {
    for method in Method::CLASSICAL {
        let skew = || Chain { above: 0.0, ..chain(0.3, 1.0, -5.0) };
        let (apart, in_turn) = (solve(method, skew(), false, 0), solve(method, skew(), true, 0));
        assert_eq!((&in_turn.z, in_turn.stats), (&apart.z, apart.stats), "{method}");
    }
}

#[test]
fn a_lost_jacobian_is_evaluated_again_where_the_solver_refuses_the_matrix() {
    for method in Method::CLASSICAL {
        let accepted = solve(method, chain(0.3, 1.0, -5.0), true, 0);
        let refused = solve(method, chain(0.3, 1.0, -5.0), true, 1);
        let [once, twice] = [accepted, refused].map(|solution| solution.stats.jacobian_evaluations);
        assert_eq!(twice, once + 1, "{method}");
    }
}
