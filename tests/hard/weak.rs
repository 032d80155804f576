//! Pairs that are nearly degenerate, and active blocks that are nearly singular: which side of the
//! kink is right hangs on digits far behind the point.

use crate::case::{Case, Expect};
use crate::common::{NONNEGATIVE, affine};
use mcp_core::Problem;

pub(crate) fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for k in [4, 8, 12, 15] {
        for sign in [1.0, -1.0] {
            // z₁ + ½ z₂ − 1 = 0, z₂ − ½ z₁ + ½ = ±ε: at −ε z₂ = ε/1.25, at +ε it is 0.
            let e = sign * 10_f64.powi(-k);
            let m = vec![vec![1.0, 0.5], vec![-0.5, 1.0]];
            let problem = affine(m, vec![-1.0, 0.5 + e], &[NONNEGATIVE; 2], &[3.0, 3.0]);
            let z2 = (-e / 1.25).max(0.0);
            let solutions = vec![vec![1.0 - 0.5 * z2, z2]];
            let expect = Expect::Near { solutions, within: 1e-14 };
            cases.push(Case::new(format!("slack {e:.0e}"), problem, &[3.0, 3.0], expect));
        }
    }
    for k in [4, 6, 8] {
        // An absolute residual of 1e-10, which the classical methods end at, times the condition.
        let e = 2_f64.powi(-3 * k);
        let expect = Expect::Near { solutions: vec![vec![1.0; 2]], within: 4e-10 / e };
        let name = format!("condition 2^{}", 3 * k + 2);
        cases.push(Case::new(name, nearly_singular(e), &[5.0, 0.0], expect));
    }
    cases
}

/// `[1 1; 1 1 + ε] z = (2, 2 + ε)`: the solution `(1, 1)`, with condition `4/ε`.
fn nearly_singular(e: f64) -> impl Problem {
    let m = vec![vec![1.0, 1.0], vec![1.0, 1.0 + e]];
    affine(m, vec![-2.0, -2.0 - e], &[NONNEGATIVE; 2], &[5.0, 0.0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use mcp_core::{Method, Options};

    #[test]
    fn weakly_active_pairs_are_solved_to_rounding() {
        crate::check::check_all(cases());
    }

    #[test]
    fn robust_loses_no_more_digits_than_the_condition_says() {
        for k in [12, 18, 24, 30, 36] {
            let e = 2_f64.powi(-k);
            let mut problem = nearly_singular(e);
            let solution = crate::common::solve(&mut problem, &Options::new(Method::Robust));
            let error = solution.z.iter().fold(0.0, |most: f64, z| most.max((z - 1.0).abs()));
            assert!(solution.is_solved() && error <= 8.0 * f64::EPSILON / e, "2^-{k}: {error:e}");
        }
    }
}
