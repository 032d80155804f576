//! The published solution is a Karush–Kuhn–Tucker point with the published value, to the digits
//! printed: each function, bound and sign of a problem enters.

use super::*;
use crate::{Options, Solution, Solver, examine};
use nalgebra::{DMatrix, DVector};

/// A variable of `x` is inside its bounds, a constraint inactive, beyond this share of its size.
const INSIDE: f64 = 1e-5;

/// `F` and `J` at `z`, dense.
fn dense_jacobian(problem: &mut dyn Problem, z: &[f64]) -> (Vec<f64>, DMatrix<f64>) {
    let mut f = vec![0.0; z.len()];
    let mut values = vec![0.0; problem.pattern().nnz()];
    problem.evaluate(z, Some(&mut f), Some(&mut values));
    let mut jacobian = DMatrix::zeros(z.len(), z.len());
    for (k, i, j) in problem.pattern().entries() {
        jacobian[(i, j)] = values[k];
    }
    (f, jacobian)
}

/// `(x*, λ)` with the multipliers of least squares: `∇f_j = Σ λ_k ∂g_k/∂x_j` where `x*_j` is inside
/// its bounds, `λ_k = 0` where `g_k` is positive.
fn point(case: &HockSchittkowski, problem: &mut dyn Problem) -> Vec<f64> {
    let n = case.n();
    let mut z = problem.shape().start().to_vec();
    z[..n].copy_from_slice(&case.x);
    z[n..].fill(0.0);
    let (f, jacobian) = dense_jacobian(problem, &z);
    let bounds = problem.shape().bounds();
    let inside = |j: &usize| {
        let margin = INSIDE * z[*j].abs().max(1.0);
        z[*j] > bounds.lower()[*j] + margin && z[*j] < bounds.upper()[*j] - margin
    };
    let rows: Vec<usize> = (0..n).filter(inside).collect();
    // What g_k changes by where x* moves by its last digits.
    let size = |k: usize| (0..n).map(|j| (jacobian[(k, j)] * z[j]).abs()).fold(1e-8, f64::max);
    let active = |k: &usize| bounds.lower()[*k] < 0.0 || f[*k].abs() <= INSIDE * size(*k);
    let columns: Vec<usize> = (n..z.len()).filter(active).collect();
    if rows.is_empty() || columns.is_empty() {
        return z;
    }
    let gradients =
        DMatrix::from_fn(rows.len(), columns.len(), |i, k| -jacobian[(rows[i], columns[k])]);
    let gradient = DVector::from_fn(rows.len(), |i, _| f[rows[i]]);
    let lambda = gradients.svd(true, true).solve(&gradient, 1e-10).unwrap();
    for (&k, &lambda) in columns.iter().zip(lambda.iter()) {
        z[k] = lambda;
    }
    z
}

fn solve_from(problem: &mut dyn Problem, z: &[f64]) -> Solution {
    let mut solver = Solver::new(Options::default()).unwrap();
    solver.solve_from(problem, z).unwrap().clone()
}

/// Largest change of `x`, relative to `max(1, |x*_j|)`.
fn moved(case: &HockSchittkowski, z: &[f64]) -> f64 {
    case.x.iter().zip(z).map(|(x, z)| (z - x).abs() / x.abs().max(1.0)).fold(0.0, f64::max)
}

fn difference(case: &HockSchittkowski, z: &[f64]) -> f64 {
    (case.objective(z) - case.f).abs() / case.f.abs().max(1.0)
}

#[test]
fn numbers_increase_and_names_follow() {
    let all = all().unwrap();
    assert_eq!(all.len(), 76);
    assert!(all.windows(2).all(|pair| pair[0].number < pair[1].number));
    assert_eq!(all[75].name(), "hs113");
}

#[test]
fn the_published_points_have_the_published_values() {
    for case in all().unwrap() {
        let difference = difference(&case, &case.x);
        assert!(difference <= 1e-6, "{}: {difference:e}", case.name());
    }
}

#[test]
fn the_published_points_solve_the_system_with_multipliers_of_least_squares() {
    for case in all().unwrap() {
        let mut problem = case.problem().unwrap();
        let z = point(&case, &mut *problem);
        assert!(problem.shape().bounds().contain(&z), "{}", case.name());
        let residual = examine(&mut *problem, &z).unwrap().relative_residual;
        // The book prints seven digits; in problem 79 terms 20 times smaller than `x` must cancel.
        assert!(residual <= 1e-5, "{}: {residual:e}", case.name());
    }
}

#[test]
fn from_there_a_solve_only_adds_digits() {
    for case in all().unwrap() {
        let mut problem = case.problem().unwrap();
        let z = point(&case, &mut *problem);
        let solution = solve_from(&mut *problem, &z);
        assert!(solution.is_solved(), "{}: {:?}", case.name(), solution.status);
        let (moved, difference) = (moved(&case, &solution.z), difference(&case, &solution.z));
        assert!(moved <= 5e-6, "{} moves by {moved:e}", case.name());
        assert!(difference <= 5e-8, "{}: {difference:e}", case.name());
    }
}
