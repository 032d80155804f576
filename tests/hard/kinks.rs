//! `F` with kinks of its own: absolute values, maxima, tariffs in steps.

use crate::case::{Case, Expect};
use mcp_core::{AdProblem, Model, ModelError, Real, Scalar, max, mcp_fn, min};

/// |z − 1| = 2 with z >= 0, from the kink.
#[mcp_fn(lower = 0.0, start = 1.0)]
fn absolute<D: Scalar>([z]: [Real<D>; 1]) -> [Real<D>; 1] {
    [(z - 1).abs() - 2]
}

/// A tariff of 1 up to 2 units and 3 beyond: marginal cost `max(z, 3 z − 4) = 5`.
#[mcp_fn(lower = 0.0)]
fn tariff<D: Scalar>([z]: [Real<D>; 1]) -> [Real<D>; 1] {
    [max(z, 3 * z - 4) - 5]
}

/// The solution is the kink itself: `max(z − 1, 3 (z − 1)) = 0`.
#[mcp_fn(lower = 0.0)]
fn at_the_kink<D: Scalar>([z]: [Real<D>; 1]) -> [Real<D>; 1] {
    [max(z - 1, 3 * (z - 1))]
}

/// Supply limited to 4 against a demand of 10 − p: q = min(p, 4), p = 6.
#[mcp_fn(lower = 0.0)]
fn rationed<D: Scalar>([p, q]: [Real<D>; 2]) -> [Real<D>; 2] {
    [q - (10 - p), q - min(p, Real::from(4.0))]
}

/// |z| + 1 = 0 has no solution; the kink is its minimum.
#[mcp_fn(start = 3.0)]
fn valley<D: Scalar>([z]: [Real<D>; 1]) -> [Real<D>; 1] {
    [z.abs() + 1]
}

fn case<M: Model + 'static>(name: &str, model: Result<M, ModelError>, expect: Expect) -> Case {
    let problem = AdProblem::new(model.expect("well formed")).expect("well formed");
    let start = problem.shape().start().to_vec();
    Case::new(name, problem, &start, expect)
}

fn near(solution: &[f64]) -> Expect {
    Expect::Near { solutions: vec![solution.to_vec()], within: 1e-8 }
}

pub(crate) fn cases() -> Vec<Case> {
    use mcp_core::Status::{SingularSystem, Stalled, StationaryPoint};
    vec![
        case("|z − 1| = 2 from its kink", Absolute::new(), near(&[3.0])),
        case("a tariff in two steps", Tariff::new(), near(&[3.0])),
        case("a solution at a kink", AtTheKink::new(), near(&[1.0])),
        case("rationed supply", Rationed::new(), near(&[6.0, 4.0])),
        case(
            "|z| + 1 = 0",
            Valley::new(),
            Expect::Fails(&[StationaryPoint, Stalled, SingularSystem]),
        ),
    ]
}

#[cfg(test)]
#[test]
fn kinks_in_f_are_solved_or_refused() {
    crate::check::check_all(cases());
}
