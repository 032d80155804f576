//! Billups' problem `(z − 1)² − 1.01 ⟂ z >= 0`: the Fischer–Burmeister merit has a local minimum at
//! −0.005 that is no solution.

use crate::case::Case;
use crate::common::{NONNEGATIVE, dense};
use mcp_core::Problem;

/// `n` copies, each coupled to the next by `c (z_{i+1} − z*)`, which leaves the solution where it is.
fn billups(n: usize, c: f64, start: &[f64]) -> impl Problem + use<> {
    let solution = 1.0 + 1.01_f64.sqrt();
    dense(&vec![NONNEGATIVE; n], start, move |z: &[f64], f: &mut [f64], jac: &mut [f64]| {
        jac.fill(0.0);
        for i in 0..n {
            let next = (i + 1) % n;
            f[i] = (z[i] - 1.0) * (z[i] - 1.0) - 1.01 + c * (z[next] - solution);
            jac[i + n * i] += 2.0 * (z[i] - 1.0);
            jac[i + n * next] += c;
        }
    })
}

pub(crate) fn cases() -> Vec<Case> {
    let solution = 1.0 + 1.01_f64.sqrt();
    let mut cases = Vec::new();
    for start in [-1.0, 0.0, 0.5, 0.9, 1.0, 1.5, 3.0, 1e4] {
        let problem = billups(1, 0.0, &[start]);
        cases.push(Case::at(format!("billups from {start}"), problem, &[start], &[solution]));
    }
    for n in [2, 5, 10] {
        let start = vec![0.0; n];
        let name = format!("{n} copies of billups from 0");
        cases.push(Case::at(name, billups(n, 0.0, &start), &start, &vec![solution; n]));
        // Half of the copies start beyond the trap.
        let start: Vec<f64> = (0..n).map(|i| if i % 2 == 0 { 0.0 } else { 3.0 }).collect();
        let name = format!("{n} copies of billups, every other from 3");
        cases.push(Case::at(name, billups(n, 0.0, &start), &start, &vec![solution; n]));
    }
    cases
}

#[cfg(test)]
mod tests {
    use super::*;
    use mcp_core::{Method, Status};

    #[test]
    fn robust_leaves_the_trap_and_nobody_claims_it() {
        crate::check::check_all(cases());
    }

    #[test]
    fn descent_on_the_merit_ends_in_the_trap_and_says_so() {
        for method in Method::CLASSICAL {
            for n in [1, 2, 5] {
                let start = vec![0.0; n];
                let mut problem = billups(n, 0.0, &start);
                let options = mcp_core::Options::new(method).with(|o| o.max_iterations = 1000);
                let solution = crate::common::solve_from(&mut problem, &start, &options);
                assert_eq!(solution.status, Status::StationaryPoint, "{method} {n}");
                assert!(
                    solution.z.iter().all(|z| z.abs() < 0.01),
                    "{method} {n}: {:?}",
                    solution.z
                );
            }
        }
    }
}
