//! The bouncing mass of Zhuravlev and Ivanov over ten seconds: 10 000 steps, the last thousands in
//! sliding mode, where the solution is degenerate. The methods of Siconos fail on 3 to 8841 of them.

use crate::common::natural_residual;
use mcp_core::testing::ZhuravlevIvanov;
use mcp_core::{AdProblem, Method, Options, Solver};

const STEPS: usize = 10_000;

/// Largest residual of any step, and the last state; `warm`: each step starts at the last solution.
fn trajectory(method: Method, warm: bool) -> (f64, [f64; 2]) {
    let mut solver = Solver::new(Options::new(method)).unwrap();
    let (mut state, mut start, mut worst) = ([1.0, 10.0], vec![0.0; 4], 0.0_f64);
    for step in 0..STEPS {
        let mut problem = AdProblem::new(ZhuravlevIvanov::new(state).unwrap()).unwrap();
        let solution = solver.solve_from(&mut problem, &start).unwrap().clone();
        assert!(solution.is_solved(), "step {step}, state {state:?}: {}", solution.status);
        worst = worst.max(natural_residual(&mut problem, &solution.z));
        // x = F₀ − s₀, v = F₂ − s₁
        state = [solution.f[0] - solution.z[1], solution.f[2] - solution.z[3]];
        if warm {
            start.clone_from(&solution.z);
        }
    }
    (worst, state)
}

#[test]
fn robust_solves_every_step_cold_and_warm_and_the_mass_comes_to_rest() {
    for warm in [false, true] {
        let (worst, state) = trajectory(Method::Robust, warm);
        assert!(worst < 1e-10, "warm: {warm}, residual {worst:e}");
        assert!(state.iter().all(|x| x.abs() < 1e-8), "warm: {warm}, {state:?}");
    }
}
