//! Defect 12 of the Siconos solvers: they cannot give up. Here a solve that crawls ends early and says
//! so, one that progresses goes on, and what the default patience costs is stated.

mod common;

use common::{siconos, solve, solve_from};
use mcp_core::{AdProblem, Method, Stall, Status, testing};

/// D12: no test for stagnation: Kojima–Shindo from (100, …) burns 1000 iterations and 20 142
/// evaluations; a failed line search takes a step of 1e-17 and goes on.
#[test]
fn d12_a_crawling_solve_ends_early_with_an_honest_status() {
    let far = [100.0; 4];
    for (mut known, method) in [
        (testing::kojima_shindo().unwrap(), Method::NewtonFb),
        (testing::josephy().unwrap(), Method::OldFb),
    ] {
        let solution = solve_from(&mut known.problem, &far, &siconos(method));
        assert_eq!(solution.status, Status::Stalled, "{}", known.name);
        assert!(solution.stats.iterations < 250, "{}", known.name);
        assert!(solution.stats.residual_evaluations < 4000, "{}", known.name);
        let endless = siconos(method).with(|o| o.stall = None);
        let crawled = solve_from(&mut known.problem, &far, &endless);
        assert!(crawled.stats.iterations > solution.stats.iterations, "{}", known.name);
        assert!(!crawled.is_solved(), "{}: giving up early lost nothing", known.name);
    }
    // A search that fails ends the solve there and then, and a step that rounding swallows has
    // failed: without a watch for stagnation, too, a local minimum is left alone.
    let mut known = testing::billups().unwrap();
    for method in Method::CLASSICAL {
        let patient = siconos(method).with(|o| o.stall = None);
        let solution = solve_from(&mut known.problem, &[0.0], &patient);
        assert_eq!(solution.status, Status::StationaryPoint, "{method}");
        assert!(solution.stats.iterations < 20, "{method} {:?}", solution.stats);
    }
}

/// D12, what patience is for: this step of the Zhuravlev–Ivanov scene crawls for 60 iterations
/// before it is solved in 71. The default patience of 100 iterations waits for it, 50 would not.
#[test]
fn d12_the_default_patience_waits_for_a_step_that_can_be_solved() {
    let state = [-0.011_347_301_270_261_703, -2.713_364_428_287_563_5];
    let mut problem = AdProblem::new(testing::ZhuravlevIvanov::new(state).unwrap()).unwrap();
    for method in [Method::NewtonFb, Method::OldFb] {
        let solution = solve(&mut problem, &siconos(method));
        assert_eq!((solution.status, solution.stats.iterations), (Status::Solved, 71), "{method}");
        let mut stall = Stall::default();
        stall.iterations = 50;
        let impatient = solve(&mut problem, &siconos(method).with(|o| o.stall = Some(stall)));
        assert_eq!(impatient.status, Status::Stalled, "{method}");
    }
    let solution = solve(&mut problem, &siconos(Method::NewtonMinFb));
    assert_eq!((solution.status, solution.stats.iterations), (Status::Solved, 3));
}

/// D12, the other side: a solve that progresses is not taken for one that crawls.
#[test]
fn d12_slow_progress_is_not_stagnation() {
    let mut known = testing::murty(160).unwrap();
    let stall = Some(Stall::default());
    let solution = solve(&mut known.problem, &siconos(Method::NewtonFb).with(|o| o.stall = stall));
    assert_eq!(solution.status, Status::Solved);
    assert!(solution.stats.iterations > 2 * Stall::default().iterations);
}
