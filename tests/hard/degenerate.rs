//! Pairs with `z_i = 0` and `F_i = 0`: no method knows on which side of the kink it is.

use crate::case::{Case, Expect};
use crate::common::{NONNEGATIVE, affine};
use mcp_core::testing;

/// `M (z − z*) + w*` with a dominant diagonal, so one solution; of `n` pairs `k` are degenerate, the
/// others alternate.
fn manufactured(n: usize, k: usize) -> Case {
    let noise = |i: usize| ((i * 7919 + 104_729) % 1009) as f64 / 504.5 - 1.0;
    let entry = |i: usize, j: usize| if i == j { 1.0 + n as f64 } else { noise(i * n + j) };
    let m: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
    let side =
        |i: usize, odd: usize| if i >= k && i % 2 == odd { 1.0 + noise(i).abs() } else { 0.0 };
    let z: Vec<f64> = (0..n).map(|i| side(i, 0)).collect();
    let q = (0..n).map(|i| side(i, 1) - m[i].iter().zip(&z).map(|(m, z)| m * z).sum::<f64>());
    let problem = affine(m.clone(), q.collect(), &vec![NONNEGATIVE; n], &vec![1.0; n]);
    Case::at(format!("{k} of {n} pairs degenerate"), problem, &vec![1.0; n], &z)
}

pub(crate) fn cases() -> Vec<Case> {
    let mut cases: Vec<Case> = [(4, 1), (4, 4), (10, 5), (10, 10), (30, 15), (30, 30)]
        .map(|(n, k)| manufactured(n, k))
        .into();
    // Every z >= 0 solves 0 ⟂ z >= 0: the answer is the start, and no equation depends on anything.
    let zeros = affine(vec![vec![0.0; 3]; 3], vec![0.0; 3], &[NONNEGATIVE; 3], &[0.0; 3]);
    cases.push(Case::at("all zero, from a corner", zeros, &[0.0; 3], &[0.0; 3]));
    for make in [testing::kojima_shindo, testing::josephy, testing::watson4] {
        let number = make().expect("the problem is well formed").starts.len();
        for start in 0..number {
            let known = make().expect("the problem is well formed");
            cases.push(Case {
                name: format!("{} from start {start}", known.name),
                start: known.starts[start].clone(),
                problem: known.problem,
                expect: Expect::Near { solutions: known.solutions, within: 1e-6 },
            });
        }
    }
    cases
}

#[cfg(test)]
#[test]
fn degenerate_pairs_are_solved_from_every_start() {
    crate::check::check_all(cases());
}
