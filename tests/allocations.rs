//! Memory: nothing is allocated from the second solve on, and never by an evaluation.
//!
//! Siconos allocates vectors, matrix and parameters in every call, and leaks some (its defect 14).

#![allow(unsafe_code, reason = "a counting allocator has to implement an unsafe trait")]

mod common;
#[path = "allocations/counter.rs"]
mod counter;

use common::{FREE, NONNEGATIVE, dense, scalar, siconos};
use counter::allocations;
use mcp_core::testing::{self, Known};
use mcp_core::{
    AdProblem, Definition, Equation, Iteration, Linear, Method, Model, ModelError, Problem, Reader,
    Real, Scalar, Set, Shape, Solver, Status, Variable, mcp, mcp_fn,
};
use std::ops::ControlFlow;

#[test]
fn the_counter_counts() {
    assert_eq!(allocations(|| ()), 0);
    assert_eq!(allocations(|| drop(std::hint::black_box(vec![1_u8; 64]))), 1);
}

/// Kojima & Shindo (1986).
#[mcp_fn(lower = 0.0)]
fn quadratic<D: Scalar>([x1, x2, x3, x4]: [Real<D>; 4]) -> [Real<D>; 4] {
    [
        3 * x1 * x1 + 2 * x1 * x2 + 2 * x2 * x2 + x3 + 3 * x4 - 6,
        2 * x1 * x1 + x1 + x2 * x2 + 10 * x3 + 2 * x4 - 2,
        3 * x1 * x1 + x1 * x2 + 2 * x2 * x2 + 2 * x3 + 9 * x4 - 9,
        x1 * x1 + 3 * x2 * x2 + 2 * x3 + 3 * x4 - 3,
    ]
}

/// Firms in a ring that see the total through a definition: `q + total²/n + next/4 − (3 + i mod 4)`.
struct Ring(Shape, usize);

impl Ring {
    fn new(n: usize) -> Result<Self, ModelError> {
        let firms = Set::count("firms", n);
        let shape = Shape::builder()
            .variable(Variable::new("q").over(&[&firms]).lower(0.0))
            .definition(Definition::new("total"))
            .definition(Definition::new("square"))
            .equation(Equation::new("profit").over(&[&firms]).complements("q"))
            .build()?;
        Ok(Ring(shape, n))
    }
}

impl Model for Ring {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let next = read.var((i + 1) % self.1);
        read.var(i) + read.def(1) + 0.25 * next - 3.0 - (i % 4) as f64
    }
    fn def<D: Scalar>(&self, family: usize, _index: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            0 => (0..self.1).map(|i| read.var(i)).sum::<Real<D>>() / self.1 as f64,
            _ => read.def(0) * read.def(0),
        }
    }
}

mcp! {
    /// Shipments of one good between towns, with prices.
    model Trade {
        data { towns: usize, cost[towns, towns]: f64, supply[towns]: f64, scale[towns]: f64 }
        var x[i in towns, j in towns] >= 0.0;
        var p[i in towns] >= 0.0 start 1.0;
        def received[j in towns]: sum(towns, |i| x[i, j]);
        eq arbitrage[i in towns, j in towns]: p[i] + cost[i, j] >= p[j]      complements x[i, j];
        eq market[j in towns]: supply[j] + received[j] - sum(towns, |k| x[j, k]) >= scale[j] / (1.0 + p[j])
            complements p[j];
    }
}

fn trade(n: usize) -> Box<dyn Problem> {
    let cost = (0..n * n).map(|k| if k % (n + 1) == 0 { 1.0 } else { 0.1 + 0.01 * k as f64 });
    let towns = |f: fn(f64) -> f64| (0..n).map(|k| f(k as f64)).collect::<Vec<f64>>();
    let model = Trade::builder()
        .towns(n)
        .cost(cost.collect::<Vec<f64>>())
        .supply(towns(|k| 1.0 + k))
        .scale(towns(|k| 9.0 - k))
        .build();
    Box::new(AdProblem::new(model.expect("well formed")).expect("well formed"))
}

/// Lemke's method solves affine problems only.
const METHODS: [Method; 4] = [Method::Robust, Method::NewtonFb, Method::NewtonMinFb, Method::OldFb];

fn from_start(known: Result<Known, ModelError>) -> Box<dyn Problem> {
    known.expect("the problems are well formed").problem
}

fn ring(n: usize) -> Box<dyn Problem> {
    Box::new(AdProblem::new(Ring::new(n).expect("well formed")).expect("well formed"))
}

/// Problems over the range of every dense linear solver.
fn problems() -> Vec<(Box<dyn Problem>, Linear)> {
    let quadratic = Quadratic::new().expect("well formed");
    vec![
        (Box::new(AdProblem::new(quadratic).expect("well formed")), Linear::Stack),
        (from_start(testing::rosen_suzuki()), Linear::Stack),
        (ring(10), Linear::Stack),
        (trade(3), Linear::Stack),
        (trade(6), Linear::Nalgebra),
        (ring(40), Linear::Nalgebra),
        (from_start(testing::fathi(40)), Linear::Nalgebra),
        (ring(120), Linear::FaerDense),
        (from_start(testing::murty(120)), Linear::FaerDense),
    ]
}

#[test]
fn nothing_is_allocated_from_the_second_solve_on() {
    for (mut problem, linear) in problems() {
        let n = problem.shape().n();
        let other = vec![0.5; n];
        for method in METHODS {
            let case = format!("{method} {linear} n = {n}");
            assert_eq!(Linear::Auto.resolve(problem.pattern()), linear, "{case}");
            let mut solver = Solver::new(siconos(method)).unwrap();
            assert!(solver.solve(&mut problem).unwrap().is_solved(), "{case}");
            // From another start Robust may enter a stage, and its memory, for the first time.
            solver.solve_from(&mut problem, &other).unwrap();
            let again = allocations(|| {
                for _ in 0..3 {
                    solver.solve(&mut problem).unwrap();
                    solver.solve_from(&mut problem, &other).unwrap();
                }
            });
            assert_eq!(again, 0, "{case}");
        }
    }
}

#[test]
fn pivoting_allocates_nothing_from_the_second_solve_on() {
    for n in [8, 40, 120] {
        let mut problem = from_start(testing::murty(n));
        let mut solver = Solver::new(siconos(Method::Lemke)).unwrap();
        assert!(solver.solve(&mut problem).unwrap().is_solved());
        let again = allocations(|| {
            solver.solve(&mut problem).unwrap();
        });
        assert_eq!(again, 0, "n = {n}");
    }
}

#[test]
fn a_solution_kept_or_dropped_changes_nothing() {
    let mut problem = ring(40);
    for method in METHODS {
        let mut solver = Solver::new(siconos(method)).unwrap();
        let kept = solver.solve(&mut problem).unwrap().clone();
        let mut again = || {
            allocations(|| {
                solver.solve(&mut problem).unwrap();
            })
        };
        assert_eq!(again(), 0, "{method}: kept");
        assert!(kept.level("q[1]").unwrap() >= 0.0);
        drop(kept);
        assert_eq!(again(), 0, "{method}: dropped");
    }
}

#[test]
fn a_monitor_that_allocates_nothing_changes_nothing() {
    let mut problem = ring(40);
    for method in METHODS {
        let mut solver = Solver::new(siconos(method)).unwrap();
        solver.solve(&mut problem).unwrap();
        let mut worst = 0.0_f64;
        let mut monitor = |it: &Iteration<'_>| {
            worst = worst.max(it.natural_residual);
            ControlFlow::Continue(())
        };
        let again = allocations(|| {
            solver.solve_monitored(&mut problem, None, &mut monitor).unwrap();
        });
        assert_eq!(again, 0, "{method}");
        assert!(worst > 0.0);
    }
}

#[test]
fn an_evaluation_never_allocates() {
    let mut all = problems();
    all.extend(testing::all().unwrap().into_iter().map(|known| (known.problem, Linear::Auto)));
    all.push((from_start(testing::obstacle(20)), Linear::FaerSparse));
    for (mut problem, _) in all {
        let (n, nnz) = (problem.shape().n(), problem.pattern().nnz());
        let (z, mut f, mut jac) = (vec![0.7; n], vec![0.0; n], vec![0.0; nnz]);
        let evaluations = allocations(|| {
            problem.evaluate(&z, Some(&mut f), None);
            problem.evaluate(&z, None, Some(&mut jac));
            problem.evaluate(&z, Some(&mut f), Some(&mut jac));
            problem.evaluate(&z, None, None);
        });
        assert_eq!(evaluations, 0, "n = {n}");
    }
}

#[test]
fn a_failing_solve_allocates_at_most_its_report_of_the_fault() {
    for method in Method::CLASSICAL {
        // No fault to report: stationary, stalled, limited.
        let mut billups = testing::billups().unwrap();
        let mut solver = Solver::new(siconos(method)).unwrap();
        solver.solve_from(&mut billups.problem, &[0.5]).unwrap();
        let again = allocations(|| {
            let status = solver.solve_from(&mut billups.problem, &[0.5]).unwrap().status;
            assert_eq!(status, Status::StationaryPoint);
        });
        assert_eq!(again, 0, "{method}");

        // Trial points outside the domain are no fault of the solve.
        let mut cliff = dense(&[FREE, NONNEGATIVE], &[3.0, 1.0], |z, f, jac| {
            f.copy_from_slice(&[z[0].ln(), z[1] - 1.0]);
            jac.copy_from_slice(&[1.0 / z[0], 0.0, 0.0, 1.0]);
        });
        let mut solver = Solver::new(siconos(method)).unwrap();
        let stats = solver.solve(&mut cliff).unwrap().stats;
        assert!(stats.residual_evaluations > stats.iterations + 1, "{method}: no trial refused");
        let again = allocations(|| assert!(solver.solve(&mut cliff).unwrap().is_solved()));
        assert_eq!(again, 0, "{method}");

        // A domain error carries its point: one list.
        let mut nowhere = scalar(FREE, -1.0, |z| (z.ln(), 1.0 / z));
        let mut solver = Solver::new(siconos(method)).unwrap();
        assert_eq!(solver.solve(&mut nowhere).unwrap().status, Status::DomainError);
        let again = allocations(|| {
            solver.solve(&mut nowhere).unwrap();
        });
        assert!(again <= 1, "{method}: {again}");
    }
}

#[test]
fn a_smaller_and_a_larger_problem_in_turn_are_solved_as_if_alone() {
    for method in METHODS {
        let mut solver = Solver::new(siconos(method)).unwrap();
        let mut problems = [ring(10), ring(40), ring(4), ring(120)];
        let alone: Vec<_> = problems
            .iter_mut()
            .map(|problem| Solver::new(siconos(method)).unwrap().solve(problem).unwrap().clone())
            .collect();
        for k in [0, 1, 2, 3, 1, 0, 0, 3, 2] {
            assert_eq!(*solver.solve(&mut problems[k]).unwrap(), alone[k], "{method} {k}");
        }
    }
}
