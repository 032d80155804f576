use super::*;
use crate::linalg::Linear;
use crate::problem::Pattern;
use crate::solver::options::{Method, Options};

const INF: f64 = f64::INFINITY;

fn basis(n: usize, m: impl Fn(usize, usize) -> f64) -> Basis {
    let pattern = Pattern::dense(n);
    let options = Options::new(Method::Lemke).with(|o| o.linear = Linear::Nalgebra);
    let mut basis = Basis::new(&pattern, &options).expect("nalgebra takes every order");
    let jac: Vec<f64> = pattern.entries().map(|(_, i, j)| m(i, j)).collect();
    basis.set_matrix(&jac, 0.0);
    basis
}

/// `max |mid(y − l, M y + q, y − u)|`.
fn residual(n: usize, m: impl Fn(usize, usize) -> f64, problem: Affine<'_>, y: &[f64]) -> f64 {
    (0..n).fold(0.0, |worst: f64, i| {
        let s = problem.q[i] + (0..n).map(|j| m(i, j) * y[j]).sum::<f64>();
        let middle = (y[i] - problem.lower[i]).min(s.max(y[i] - problem.upper[i]));
        worst.max(middle.abs())
    })
}

fn noise(k: usize) -> f64 {
    ((k * 7919 + 131) % 1009) as f64 / 504.5 - 1.0
}

#[test]
fn boxes_of_every_kind_are_solved_from_the_bounds_and_from_any_basis() {
    for n in [1, 2, 5, 12, 30] {
        let m = |i: usize, j: usize| if i == j { 1.0 + n as f64 } else { noise(31 * i + j) };
        let q: Vec<f64> = (0..n).map(|i| 3.0 * n as f64 * noise(i + 77)).collect();
        let lower: Vec<f64> = (0..n).map(|i| [-INF, 0.0, -INF, -0.5, 0.3][i % 5]).collect();
        let upper: Vec<f64> = (0..n).map(|i| [INF, INF, 1.0, 0.5, 0.3][i % 5]).collect();
        let problem = Affine { q: &q, lower: &lower, upper: &upper };
        let mut basis = basis(n, m);
        for start in 0..4 {
            if start == 0 {
                basis.start_at_bounds(problem);
            } else {
                let at = |k: usize| (0..n).map(|i| noise(i * 13 + k * start)).collect::<Vec<_>>();
                basis.start_at(problem, &at(5), &at(6));
            }
            assert_eq!(basis.follow(problem, 1000), PathEnd::Solved, "n = {n}, start {start}");
            let error = residual(n, m, problem, &basis.y);
            assert!(error < 1e-10, "n = {n}, start {start}: {error:e}");
        }
    }
}

#[test]
fn murty_and_fathi_are_solved_although_all_ratios_tie() {
    for n in [8, 16] {
        let murty = |i: usize, j: usize| match i.cmp(&j) {
            std::cmp::Ordering::Less => 2.0,
            std::cmp::Ordering::Equal => 1.0,
            std::cmp::Ordering::Greater => 0.0,
        };
        let fathi = |i: usize, j: usize| (0..n).map(|k| murty(k, i) * murty(k, j)).sum::<f64>();
        let (q, lower, upper) = (vec![-1.0; n], vec![0.0; n], vec![INF; n]);
        let problem = Affine { q: &q, lower: &lower, upper: &upper };
        for m in [&murty as &dyn Fn(usize, usize) -> f64, &fathi] {
            let mut basis = basis(n, m);
            basis.start_at_bounds(problem);
            assert_eq!(basis.follow(problem, 100_000), PathEnd::Solved, "n = {n}");
            assert!(residual(n, m, problem, &basis.y) < 1e-9, "n = {n}");
        }
    }
}

#[test]
fn a_ray_is_found_where_a_copositive_plus_problem_has_no_solution() {
    // M = 0, q = −1: infeasible. The second pair is another problem, and solved.
    let m = |i: usize, j: usize| if i == 1 && j == 1 { 1.0 } else { 0.0 };
    let (q, lower, upper) = ([-1.0, -1.0], [0.0, 0.0], [INF, INF]);
    let problem = Affine { q: &q, lower: &lower, upper: &upper };
    let mut basis = basis(2, m);
    basis.start_at_bounds(problem);
    assert_eq!(basis.follow(problem, 100), PathEnd::Ray);
    assert!(basis.ray[0] > 0.0, "{:?}", basis.ray);
}

#[test]
fn a_level_flips_to_its_other_bound_without_an_exchange() {
    // −1 ⟂ y in [0, 2]: at the upper bound.
    let problem = Affine { q: &[-1.0], lower: &[0.0], upper: &[2.0] };
    let mut basis = basis(1, |_, _| 0.0);
    basis.start_at_bounds(problem);
    assert_eq!(basis.follow(problem, 100), PathEnd::Solved);
    assert_eq!(basis.y, [2.0]);
}

#[test]
fn a_tridiagonal_problem_of_many_variables_is_solved_by_every_linear_solver() {
    // Ahn (1983): all levels become basic, one after the other.
    let m = |i: usize, j: usize| match (i, j) {
        _ if i == j => 4.0,
        _ if j == i + 1 => -2.0,
        _ if i == j + 1 => 1.0,
        _ => 0.0,
    };
    for (n, linear) in [
        (60, Linear::Nalgebra),
        (200, Linear::Nalgebra),
        (200, Linear::FaerDense),
        (60, Linear::FaerSparse),
        (200, Linear::FaerSparse),
        (700, Linear::FaerSparse),
    ] {
        let near = |j: usize| (j.saturating_sub(1)..n.min(j + 2)).collect();
        let pattern = Pattern::from_columns((0..n).map(near));
        let options = Options::new(Method::Lemke).with(|o| o.linear = linear);
        let mut basis = Basis::new(&pattern, &options).expect("they take every order");
        let jac: Vec<f64> = pattern.entries().map(|(_, i, j)| m(i, j)).collect();
        basis.set_matrix(&jac, 0.0);
        let (q, lower, upper) = (vec![-1.0; n], vec![0.0; n], vec![INF; n]);
        let problem = Affine { q: &q, lower: &lower, upper: &upper };
        basis.start_at_bounds(problem);
        let end = basis.follow(problem, 10_000);
        assert_eq!(end, PathEnd::Solved, "n = {n} {linear}: {} exchanges", basis.exchanges);
        assert!(residual(n, m, problem, &basis.y) < 1e-9, "n = {n} {linear}");
    }
}
