//! Jacobians that are singular at the solution, everywhere, or structurally.

use crate::case::{Case, Expect};
use crate::common::{FREE, NONNEGATIVE, affine, dense, scalar};
use mcp_core::{Problem, Status};

/// Two goods, excess demand of an exchange economy at prices `p`, homogeneous of degree 0: owners of
/// `(1, 0)` and `(0, 1)` spend the shares ¼ and ½ on good 1. All multiples of `p₁ = 2/3 p₂` clear.
fn walras(start: f64) -> impl Problem {
    dense(&[(1e-6, f64::INFINITY); 2], &[start; 2], |p, f, jac| {
        // 1 − ¼ − ½ p₂/p₁ and 1 − ¾ p₁/p₂ − ½.
        f.copy_from_slice(&[0.75 - 0.5 * p[1] / p[0], 0.5 - 0.75 * p[0] / p[1]]);
        jac.copy_from_slice(&[
            0.5 * p[1] / (p[0] * p[0]),
            -0.75 / p[1],
            -0.5 / p[0],
            0.75 * p[0] / (p[1] * p[1]),
        ]);
    })
}

pub(crate) fn cases() -> Vec<Case> {
    let double = |z: f64| (z * z, 2.0 * z);
    let triple = |z: f64| (z * z * z, 3.0 * z * z);
    let root = |within| Expect::Near { solutions: vec![vec![0.0]], within };
    let prices = |p: &[f64]| (p[0] / p[1] - 2.0 / 3.0).abs() < 1e-7 && p[0] >= 1e-6;
    let line = |z: &[f64]| (z[0] - z[1] - 1.0).abs() < 1e-8;
    let twice = || affine(vec![vec![1.0, -1.0]; 2], vec![-1.0, -1.0], &[FREE; 2], &[3.0, 1.0]);
    let contrary = || affine(vec![vec![1.0, -1.0]; 2], vec![0.0, -1.0], &[FREE; 2], &[3.0, 1.0]);
    let unused = |q: f64| {
        affine(vec![vec![1.0, 0.0], vec![2.0, 0.0]], vec![-1.0, q], &[FREE; 2], &[3.0, 1.0])
    };
    let sequence = |z: &[f64]| (z[0] - 1.0).abs() < 1e-8;
    vec![
        // The error of a double root is the square root of the residual's.
        Case::new("z² = 0", scalar(FREE, 3.0, double), &[3.0], root(1e-3)),
        Case::new("z² ⟂ z >= 0", scalar(NONNEGATIVE, 3.0, double), &[3.0], root(1e-3)),
        Case::new("z³ ⟂ z >= 0", scalar(NONNEGATIVE, 3.0, triple), &[3.0], root(1e-2)),
        Case::new("no numeraire", walras(1.0), &[1.0; 2], Expect::Member(Box::new(prices))),
        Case::new(
            "no numeraire, far",
            walras(50.0),
            &[50.0, 1.0],
            Expect::Member(Box::new(prices)),
        ),
        Case::new("one equation twice", twice(), &[3.0, 1.0], Expect::Member(Box::new(line))),
        Case::new(
            "two equations that contradict",
            contrary(),
            &[3.0, 1.0],
            Expect::Fails(&[Status::SingularSystem]),
        ),
        Case::new(
            "a variable no equation reads",
            unused(-2.0),
            &[3.0, 1.0],
            Expect::Member(Box::new(sequence)),
        ),
        Case::new(
            "a variable no equation reads, and a contradiction",
            unused(-1.0),
            &[3.0, 1.0],
            Expect::Fails(&[Status::SingularSystem]),
        ),
        Case::new(
            "an equation that reads nothing",
            affine(vec![vec![1.0, 0.0], vec![0.0, 0.0]], vec![-1.0, 5.0], &[FREE; 2], &[3.0, 1.0]),
            &[3.0, 1.0],
            Expect::Fails(&[Status::SingularSystem]),
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use mcp_core::{Diagnosis, Method};

    #[test]
    fn singular_problems_are_solved_or_called_singular() {
        crate::check::check_all(cases());
    }

    #[test]
    fn the_variables_that_can_move_together_are_named() {
        let contradictions = cases().into_iter().filter(|case| case.name.contains("contradict"));
        for mut case in contradictions {
            let solution = case.solve(Method::Robust);
            let Some(Diagnosis::Singular { null_vector, .. }) = solution.diagnosis else {
                panic!("{}: {:?}", case.name, solution.diagnosis);
            };
            assert!(null_vector.iter().any(|&(j, _)| j == 1), "{}: {null_vector:?}", case.name);
        }
    }
}
