//! What holds however a solve ends, and the check of all cases of a group.

use crate::case::Case;
use mcp_core::{Method, Problem, Report, Solution, Status};

/// Evaluations of `F` that no solve of a hard case exceeds.
const ENOUGH: usize = 60_000;

/// What must hold however a solve ends: a finite point in the box, a report without NaN unless a
/// domain error is what it reports, counts within bounds.
pub(crate) fn check_sane(problem: &mut dyn Problem, solution: &Solution, case: &str) {
    assert!(solution.z.iter().all(|z| z.is_finite()), "{case}: {:?}", solution.z);
    assert!(problem.shape().bounds().contain(&solution.z), "{case}: outside the box");
    assert!(solution.stats.iterations <= 5000, "{case}: {:?}", solution.stats);
    assert!(solution.stats.residual_evaluations <= ENOUGH, "{case}: {:?}", solution.stats);
    let finite = solution.f.iter().all(|f| f.is_finite());
    if finite {
        let report = Report::new(problem, solution).expect("the solution is of this problem");
        let text = format!("{report} {:?}", solution.diagnosis);
        let says_nan = text.contains("NaN");
        assert!(!says_nan || solution.status == Status::DomainError, "{case}: {text}");
    } else {
        assert!(!solution.is_solved(), "{case}");
    }
}

/// Every method is sane on every case and claims nothing false; `Robust` answers as expected.
pub(crate) fn check_all(cases: Vec<Case>) {
    let mut wrong = Vec::new();
    for mut case in cases {
        for method in Method::ALL {
            let solution = case.solve(method);
            let label = format!("{} by {method}", case.name);
            check_sane(&mut *case.problem, &solution, &label);
            assert!(!case.is_false_claim(&solution), "{label}: {:?}", solution.z);
            if method == Method::Robust && !case.is_met_by(&solution) {
                let (z, expected) = (&solution.z, case.expectation());
                wrong.push(format!("{label}: {expected}, got {:?} {z:?}", solution.status));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
