//! The collection of problems: what a method calls solved is a solution.
#![allow(clippy::unwrap_used, reason = "a test stops where a problem is not well formed")]

use mcp_core::testing::{collection, hock_schittkowski, judge};
use mcp_core::{Method, Options, Solver};

#[test]
fn no_method_claims_a_solution_where_the_judge_sees_none_or_none_exists() {
    let instances = collection::all().unwrap();
    for method in Method::ALL {
        let options = Options::new(method).with(|o| o.max_iterations = o.max_iterations.min(300));
        for instance in &instances {
            let mut solver = Solver::new(options.clone()).unwrap();
            let solution = solver.solve(&mut *instance.problem().unwrap()).unwrap();
            assert!(solution.z.iter().all(|z| z.is_finite()), "{method} {}", instance.name);
            if solution.is_solved() {
                let judgement = judge(instance, &solution.z).unwrap();
                let name = &instance.name;
                assert!(instance.solvable && judgement.accepts(), "{method} {name}: {judgement:?}");
            }
        }
    }
}

/// From the starts of the book, multipliers 0: how many systems are solved, and at how many of these
/// the objective is the published one; the others are further stationary points of non-convex
/// programs.
fn solved_and_published(method: Method) -> (usize, usize) {
    let (mut solved, mut published) = (0, 0);
    for program in hock_schittkowski::all().unwrap() {
        let mut problem = program.problem().unwrap();
        let mut solver = Solver::new(Options::new(method)).unwrap();
        let solution = solver.solve(&mut *problem).unwrap();
        if solution.is_solved() {
            let f = program.objective(&solution.z[..program.x.len()]);
            solved += 1;
            published += usize::from((f - program.f).abs() <= 1e-6 * program.f.abs().max(1.0));
        }
    }
    (solved, published)
}

#[test]
fn robust_solves_all_karush_kuhn_tucker_systems_of_hock_and_schittkowski() {
    assert_eq!(solved_and_published(Method::Robust), (76, 64));
    // At the end of problem 55 its multipliers are beyond 1e8: solved asymptotically.
    assert_eq!(solved_and_published(Method::NewtonFb), (62, 56));
}
