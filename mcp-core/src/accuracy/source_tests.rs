use super::*;
use crate::accuracy::problems;
use crate::mcp_fn;
use crate::problem::{AdProblem, Counting};
use crate::scalar::{Real, Scalar};

#[mcp_fn(lower = 0.0, upper = [1.0, f64::INFINITY], start = [1.0, 2.0])]
fn curved<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x.exp() * y, (1 - x).sqrt() + y.powi(3)]
}

fn jacobian(problem: &mut dyn Problem, z: &[f64]) -> Vec<f64> {
    let mut jac = vec![0.0; problem.pattern().nnz()];
    problem.evaluate(z, None, Some(&mut jac));
    jac
}

fn curved_problem() -> AdProblem<Curved> {
    AdProblem::new(Curved::new().unwrap()).unwrap()
}

/// The largest relative error of an entry.
fn error(found: &[f64], exact: &[f64]) -> f64 {
    found.iter().zip(exact).map(|(a, b)| ((a - b) / b).abs()).fold(0.0, f64::max)
}

#[test]
fn differences_have_the_errors_of_their_order() {
    let z = [0.3, 2.0];
    let exact = jacobian(&mut curved_problem(), &z);
    let of = |scheme| jacobian(&mut Differences::new(curved_problem(), scheme), &z);
    let (one_sided, central) =
        (error(&of(Scheme::OneSided), &exact), error(&of(Scheme::Central), &exact));
    assert!((1e-10..1e-6).contains(&one_sided), "{one_sided:e}");
    assert!((1e-14..1e-8).contains(&central), "{central:e}");
}

#[test]
fn one_sided_differences_stay_in_the_box() {
    // From x = 1 a step upwards leaves the domain of the root.
    let jac = jacobian(&mut Differences::new(curved_problem(), Scheme::OneSided), &[1.0, 2.0]);
    assert!(jac.iter().all(|entry| f64::is_finite(*entry)), "{jac:?}");
}

#[test]
fn central_differences_are_one_sided_where_one_side_does_not_exist() {
    let z = [1.0 - 1e-9, 2.0];
    let jac = jacobian(&mut Differences::new(curved_problem(), Scheme::Central), &z);
    assert!(jac.iter().all(|entry| f64::is_finite(*entry)), "{jac:?}");
}

#[test]
fn the_best_steps_are_no_worse_than_the_default_ones() {
    let z = [0.3, 2.0];
    let exact = jacobian(&mut curved_problem(), &z);
    let steps = Differences::new(curved_problem(), Scheme::Central).best_steps(&z, &exact);
    let best = Differences::new(curved_problem(), Scheme::Central).with_steps(&steps);
    let of = |mut problem: Differences<_>| error(&jacobian(&mut problem, &z), &exact);
    assert!(of(best) <= of(Differences::new(curved_problem(), Scheme::Central)));
}

#[test]
fn a_band_of_three_takes_three_groups_whatever_its_length() {
    for n in [3, 30, 300] {
        let chain = problems::chain(n).unwrap();
        let plain = chain.problem(Source::Jet).unwrap();
        let mut counting = Counting::new(plain);
        let mut differences = Differences::new(&mut counting, Scheme::Central);
        assert_eq!(differences.passes_per_jacobian(), 7);
        let z = chain.solution().unwrap();
        let found = jacobian(&mut differences, &z);
        assert_eq!(counting.passes().residual, 7);
        let exact = jacobian(&mut chain.problem(Source::Jet).unwrap(), &z);
        assert!(error(&found, &exact) < 1e-8);
    }
}

#[test]
fn the_jacobian_by_hand_is_the_given_one_and_f_that_of_the_problem() {
    let mut by_hand = ByHand::new(curved_problem(), |_: &[f64], jac: &mut [f64]| jac.fill(7.0));
    let (mut f, mut jac) = ([0.0; 2], [0.0; 4]);
    by_hand.evaluate(&[0.0, 2.0], Some(&mut f), Some(&mut jac));
    assert_eq!((f, jac), ([2.0, 9.0], [7.0; 4]));
}
