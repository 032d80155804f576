//! Several solutions, a continuum of them, and none.

use crate::case::{Case, Expect};
use crate::common::{FREE, NONNEGATIVE, affine, dense, scalar};
use mcp_core::Status;

/// `(F, F')`.
type Line = fn(f64) -> (f64, f64);

/// Words for "no solution here".
const NONE: &[Status] = &[
    Status::Diverged,
    Status::SolvedAsymptotically,
    Status::SingularSystem,
    Status::StationaryPoint,
    Status::Stalled,
];

pub(crate) fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    // (z − 1)(z − 2)(z − 3) ⟂ z <= 10: three roots, and F(10) > 0 excludes the bound; z >= 0 does
    // not bind, F(0) = −6.
    let cubic = |z: f64| {
        let (a, b, c) = (z - 1.0, z - 2.0, z - 3.0);
        (a * b * c, a * b + a * c + b * c)
    };
    for start in [-4.0, 0.0, 1.4, 1.6, 2.5, 8.0, 1e3] {
        let solutions = [1.0, 2.0, 3.0].map(|z| vec![z]).to_vec();
        let expect = Expect::Near { solutions, within: 1e-8 };
        let problem = scalar((0.0, f64::INFINITY), start, cubic);
        cases.push(Case::new(format!("three roots from {start}"), problem, &[start], expect));
    }
    // Two crossing lines: (1, 0), (0, 1) and (1/3, 1/3).
    for start in [[0.0, 0.0], [0.3, 0.3], [5.0, 0.0], [2.0, 7.0]] {
        let m = vec![vec![1.0, 2.0], vec![2.0, 1.0]];
        let problem = affine(m, vec![-1.0; 2], &[NONNEGATIVE; 2], &start);
        let solutions = vec![vec![1.0, 0.0], vec![0.0, 1.0], vec![1.0 / 3.0; 2]];
        let expect = Expect::Near { solutions, within: 1e-8 };
        cases.push(Case::new(format!("three corners from {start:?}"), problem, &start, expect));
    }
    // A segment of solutions: x + y = 1, x, y >= 0.
    let segment = affine(vec![vec![1.0; 2]; 2], vec![-1.0; 2], &[NONNEGATIVE; 2], &[3.0, 0.0]);
    let on_it = |z: &[f64]| (z[0] + z[1] - 1.0).abs() < 1e-8 && z[0] >= 0.0 && z[1] >= 0.0;
    cases.push(Case::new("a segment", segment, &[3.0, 0.0], Expect::Member(Box::new(on_it))));

    let none: [(&str, (f64, f64), Line); 7] = [
        ("−1 ⟂ z >= 0", NONNEGATIVE, |_| (-1.0, 0.0)),
        ("−1 − z ⟂ z >= 0", NONNEGATIVE, |z| (-1.0 - z, -1.0)),
        ("−e^−z ⟂ z >= 0", NONNEGATIVE, |z| (-(-z).exp(), (-z).exp())),
        ("e^z = 0", FREE, |z| (z.exp(), z.exp())),
        ("z² + 1 = 0", FREE, |z| (z * z + 1.0, 2.0 * z)),
        ("√(z² + 1) = 0", FREE, |z| (z.hypot(1.0), z / z.hypot(1.0))),
        ("arctan z = 2", FREE, |z| (z.atan() - 2.0, 1.0 / (1.0 + z * z))),
    ];
    for (name, bounds, line) in none {
        let problem = scalar(bounds, 2.0, line);
        cases.push(Case::new(name, problem, &[2.0], Expect::Fails(NONE)));
    }
    let parallel = dense(&[FREE; 2], &[3.0, 1.0], |z, f, jac| {
        f.copy_from_slice(&[z[0] - z[1] - 1.0, z[0] - z[1] - 2.0]);
        jac.copy_from_slice(&[1.0, 1.0, -1.0, -1.0]);
    });
    cases.push(Case::new("parallel lines", parallel, &[3.0, 1.0], Expect::Fails(NONE)));
    // Rank one and inconsistent: along (1, 2, 3) the residual stays and its terms grow.
    let m: Vec<Vec<f64>> =
        [1.0, -2.0, 1.0].map(|a| [1.0, -2.0, 1.0].map(|b| a * b).to_vec()).to_vec();
    let bounds = [(f64::NEG_INFINITY, 0.0), (0.0, 0.0), NONNEGATIVE];
    let rank_one = affine(m, vec![2.0, -3.0, 0.0], &bounds, &[0.0; 3]);
    cases.push(Case::new("rank one, inconsistent", rank_one, &[0.0; 3], Expect::Fails(NONE)));
    // No equation reads z₂, and its own has the wrong sign at its bound.
    let m = vec![vec![11.0, 0.0], vec![-3.0, 0.0]];
    let bounds = [(f64::NEG_INFINITY, -0.4), (f64::NEG_INFINITY, 0.0)];
    let unread = affine(m, vec![2.0, 1.0], &bounds, &[-1.0, -1.0]);
    cases.push(Case::new("unread and unbalanced", unread, &[-1.0; 2], Expect::Fails(NONE)));
    cases
}

#[cfg(test)]
#[test]
fn one_of_several_solutions_is_found_and_none_is_never_claimed() {
    crate::check::check_all(cases());
}
