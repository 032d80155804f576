//! Ill-conditioned families of linear problems: of Murty and Fathi, on which pivoting or Newton's method
//! may need `2^n` steps, and with Hilbert's matrices (sources in [`mcp_core::testing`]).

use crate::case::{Case, Expect};
use mcp_core::ModelError;
use mcp_core::testing::{self, Known};

pub(crate) fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    cases.extend([8, 32, 128].map(|n| family(testing::murty, n, 1e-8)));
    cases.extend([8, 32, 128].map(|n| family(testing::fathi, n, 1e-8)));
    // Of positive definite problems the only solution is known by enumeration.
    cases.extend([3, 4, 5, 6].map(|n| family(testing::hilbert, n, 1e-6)));
    cases
}

/// A family at one order, from 0, with the published or enumerated solution.
fn family(make: fn(usize) -> Result<Known, ModelError>, n: usize, within: f64) -> Case {
    let mut known = make(n).expect("the problem is well formed");
    if known.solutions.is_empty() {
        let all = testing::enumerate_affine(&mut *known.problem);
        known.solutions = all.expect("affine and small").solutions;
    }
    Case {
        name: known.name,
        start: known.starts.swap_remove(0),
        problem: known.problem,
        expect: Expect::Near { solutions: known.solutions, within },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::{natural_residual, solve};
    use mcp_core::{Method, Options};

    #[test]
    fn ill_conditioned_families_are_solved() {
        crate::check::check_all(cases());
    }

    #[test]
    fn steps_do_not_explode_with_the_order() {
        for (make, n) in [
            (testing::murty as fn(usize) -> Result<Known, ModelError>, 256),
            (testing::fathi, 256),
            (testing::ahn, 256),
        ] {
            let mut known = make(n).unwrap();
            let solution = solve(&mut *known.problem, &Options::new(Method::Robust));
            assert!(solution.is_solved(), "{}", known.name);
            let stats = solution.stats;
            assert!(stats.jacobian_evaluations <= 40, "{} {stats:?}", known.name);
        }
    }

    /// `zᵀF <= δ` and `F >= −δ` bound the distance in the energy norm, whatever the condition.
    #[test]
    fn hilbert_matrices_of_any_condition_are_solved_to_rounding() {
        for n in [8, 10, 12, 14] {
            let mut known = testing::hilbert(n).unwrap();
            let solution = solve(&mut *known.problem, &Options::new(Method::Robust));
            assert!(solution.is_solved(), "{n}: {}", solution.status);
            let terms = solution.z.iter().fold(1.0_f64, |most, z| most.max(z.abs()));
            let residual = natural_residual(&mut *known.problem, &solution.z);
            assert!(residual <= 1e-12 * terms, "{n}: {residual:e} of {terms:e}");
        }
    }
}
