//! The bouncing mass of Zhuravlev and Ivanov over ten seconds: 10 000 steps, the last thousands in
//! sliding mode, where the solution is degenerate. The methods of Siconos fail on 3 to 8841 of them.

use mcp_core::dynamics::TimeStepper;
use mcp_core::testing::{ZhuravlevIvanov, ZhuravlevIvanovStepper};
use mcp_core::{Method, Options};

const STEPS: usize = 10_000;

/// Largest residual of any step, and the last state; `warm`: each step starts at the last solution.
fn trajectory(method: Method, warm: bool) -> (f64, [f64; 2]) {
    let first = ZhuravlevIvanov::new([1.0, 10.0]).unwrap();
    let mut mass = ZhuravlevIvanovStepper::new(first, Options::new(method), warm).unwrap();
    let mut worst = 0.0_f64;
    for _ in 0..STEPS {
        let report = mass.step().unwrap_or_else(|error| panic!("{error}, {:?}", mass.state()));
        worst = worst.max(report.residual);
    }
    let state = mass.state();
    (worst, [state[0], state[1]])
}

#[test]
fn robust_solves_every_step_cold_and_warm_and_the_mass_comes_to_rest() {
    for warm in [false, true] {
        let (worst, state) = trajectory(Method::Robust, warm);
        assert!(worst < 1e-10, "warm: {warm}, residual {worst:e}");
        assert!(state.iter().all(|x| x.abs() < 1e-8), "warm: {warm}, {state:?}");
    }
}
