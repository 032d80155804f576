//! Random starts of problems with published solutions: no panic, no endless loop, no false claim. One
//! seed, the same every run.

use super::check::check_sane;
use super::random::Random;
use crate::common::solve_from;
use mcp_core::testing::{self, Known};
use mcp_core::{Method, Options};

fn is_near(z: &[f64], solution: &[f64]) -> bool {
    z.iter().zip(solution).all(|(z, s)| (z - s).abs() <= 1e-6 * s.abs().max(1.0))
}

/// Nonlinear problems all of whose solutions are published.
fn published() -> Vec<Known> {
    let make = [testing::kojima_shindo, testing::josephy, testing::watson4, testing::billups];
    make.iter().map(|make| make().expect("the problems are well formed")).collect()
}

#[test]
fn random_starts_of_published_problems_end_at_their_solutions_or_say_so() {
    let mut random = Random(42);
    for mut known in published() {
        let mut solved = 0;
        for number in 0..1750 {
            let n = known.starts[0].len();
            let start: Vec<f64> =
                (0..n).map(|_| random.unit() * 10_f64.powf(2.0 * random.unit())).collect();
            for method in [Method::Robust].into_iter().chain(Method::CLASSICAL) {
                let solution = solve_from(&mut *known.problem, &start, &Options::new(method));
                let case = format!("{} {number} from {start:?} by {method}", known.name);
                check_sane(&mut *known.problem, &solution, &case);
                let right = known.solutions.iter().any(|s| is_near(&solution.z, s));
                assert!(!solution.is_solved() || right, "{case}: {:?}", solution.z);
                solved += usize::from(method == Method::Robust && solution.is_solved());
            }
        }
        assert!(solved >= 1300, "{}: {solved} of 1750", known.name);
    }
}
