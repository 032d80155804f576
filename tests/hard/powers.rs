//! Powers, logarithms and nests at zero, where derivatives are infinite.

use crate::case::Case;
use mcp_core::economics::{ces2, cobb};
use mcp_core::{AdProblem, Model, ModelError, Real, Scalar, mcp_fn};

/// √z = 2.
#[mcp_fn(lower = 0.0)]
fn root<D: Scalar>([z]: [Real<D>; 1]) -> [Real<D>; 1] {
    [z.sqrt() - 2]
}

/// 2 − z^−½: demand falls to supply at z = ¼; infinite at 0.
#[mcp_fn(lower = 0.0)]
fn reciprocal_root<D: Scalar>([z]: [Real<D>; 1]) -> [Real<D>; 1] {
    [2 - z.pow(-0.5)]
}

/// z^1.5 + z ⟂ z >= 0.
#[mcp_fn(lower = 0.0, start = 1)]
fn power<D: Scalar>([z]: [Real<D>; 1]) -> [Real<D>; 1] {
    [z.pow(1.5) + z]
}

/// z ln z + z = 0, whose derivative is −∞ at 0, 0 at e^−1.
#[mcp_fn(lower = 0.01, start = 1)]
fn entropy<D: Scalar>([z]: [Real<D>; 1]) -> [Real<D>; 1] {
    [z.xlogx() + z]
}

/// Two inputs with unit elasticities of supply; the nest costs 1: p₁ = p₂ = 1 by symmetry.
#[mcp_fn(lower = 0.0, start = 0.0)]
fn cobb_douglas<D: Scalar>([p, q]: [Real<D>; 2]) -> [Real<D>; 2] {
    [cobb([(1.0, p), (1.0, q)], |input| input) - 1, p - q]
}

/// The same with σ = ½.
#[mcp_fn(lower = 0.0, start = 0.0)]
fn complements<D: Scalar>([p, q]: [Real<D>; 2]) -> [Real<D>; 2] {
    [ces2(0.5, 0.5, p, q) - 1, p - q]
}

/// The same with σ = 4.
#[mcp_fn(lower = 0.0, start = 0.0)]
fn substitutes<D: Scalar>([p, q]: [Real<D>; 2]) -> [Real<D>; 2] {
    [ces2(4.0, 0.5, p, q) - 1, p - q]
}

/// Two roads, 10 (1 + 0.15 (x/2)⁴) and 15, ten travellers: x = 2 (10/3)^¼, the rest on the other.
#[mcp_fn(lower = 0.0)]
fn roads<D: Scalar>([x, y, t]: [Real<D>; 3]) -> [Real<D>; 3] {
    [10 * (1 + 0.15 * (x / 2).powi(4)) - t, 15 - t, x + y - 10]
}

fn solved<M: Model + 'static>(name: &str, model: Result<M, ModelError>, solution: &[f64]) -> Case {
    let problem = AdProblem::new(model.expect("well formed")).expect("well formed");
    let start = problem.shape().start().to_vec();
    Case::at(name, problem, &start, solution)
}

pub(crate) fn cases() -> Vec<Case> {
    let x = 2.0 * (10.0_f64 / 3.0).powf(0.25);
    vec![
        solved("√z = 2 from 0", Root::new(), &[4.0]),
        solved("z^−½ = 2 from 0", ReciprocalRoot::new(), &[0.25]),
        solved("z^1.5 + z ⟂ z >= 0", Power::new(), &[0.0]),
        solved("z ln z + z = 0", Entropy::new(), &[(-1.0_f64).exp()]),
        solved("Cobb–Douglas from zero prices", CobbDouglas::new(), &[1.0, 1.0]),
        solved("CES, σ = ½, from zero prices", Complements::new(), &[1.0, 1.0]),
        solved("CES, σ = 4, from zero prices", Substitutes::new(), &[1.0, 1.0]),
        solved("two roads (BPR)", Roads::new(), &[x, 10.0 - x, 15.0]),
    ]
}

#[cfg(test)]
#[test]
fn powers_at_zero_are_solved() {
    crate::check::check_all(cases());
}
