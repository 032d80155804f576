//! The collection of problems: what a method calls solved is a solution.
#![allow(clippy::unwrap_used, reason = "a test stops where a problem is not well formed")]

use mcp_core::testing::{collection, judge};
use mcp_core::{Method, Options, Solver};

#[test]
fn no_method_claims_a_solution_where_the_judge_sees_none_or_none_exists() {
    let instances = collection::all().unwrap();
    for method in Method::ALL {
        let options = Options::new(method).with(|o| o.max_iterations = o.max_iterations.min(300));
        for instance in &instances {
            let mut solver = Solver::new(options.clone()).unwrap();
            let solution = solver.solve(&mut *instance.problem().unwrap()).unwrap();
            assert!(solution.z.iter().all(|z| z.is_finite()), "{method} {}", instance.name);
            if solution.is_solved() {
                let judgement = judge(instance, &solution.z).unwrap();
                let name = &instance.name;
                assert!(instance.solvable && judgement.accepts(), "{method} {name}: {judgement:?}");
            }
        }
    }
}
