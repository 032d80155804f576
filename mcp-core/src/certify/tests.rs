//! What is proved, what is refused, and that proofs are true.

use super::*;
use crate::scalar::{Real, Scalar, external, logsumexp, select};
use crate::solver::{Method, Options, solve, solve_from};
use crate::{mcp, mcp_fn};
use proptest::prelude::*;

/// `certify` at a point of our choice.
fn certify_at<M: Model>(model: &M, z: &[f64]) -> Accuracy {
    let problem = AdProblem::new(model).unwrap();
    let solution =
        Solution { shape: problem.shape().clone(), z: z.to_vec(), ..Solution::nothing() };
    certify(model, &solution).unwrap()
}

fn radius(accuracy: &Accuracy) -> f64 {
    match accuracy.proof {
        Proof::Proved { radius } => radius,
        Proof::Refused(_) => panic!("{accuracy}"),
    }
}

/// The two problems of four quadratic functions.
#[mcp_fn(lower = 0.0)]
fn josephy<D: Scalar>([x1, x2, x3, x4]: [Real<D>; 4]) -> [Real<D>; 4] {
    [
        3 * x1 * x1 + 2 * x1 * x2 + 2 * x2 * x2 + x3 + 3 * x4 - 6,
        2 * x1 * x1 + x1 + x2 * x2 + 3 * x3 + 2 * x4 - 2,
        3 * x1 * x1 + x1 * x2 + 2 * x2 * x2 + 2 * x3 + 3 * x4 - 1,
        x1 * x1 + 3 * x2 * x2 + 2 * x3 + 3 * x4 - 3,
    ]
}

#[mcp_fn(lower = 0.0)]
fn kojima_shindo<D: Scalar>([x1, x2, x3, x4]: [Real<D>; 4]) -> [Real<D>; 4] {
    [
        3 * x1 * x1 + 2 * x1 * x2 + 2 * x2 * x2 + x3 + 3 * x4 - 6,
        2 * x1 * x1 + x1 + x2 * x2 + 10 * x3 + 2 * x4 - 2,
        3 * x1 * x1 + x1 * x2 + 2 * x2 * x2 + 2 * x3 + 9 * x4 - 9,
        x1 * x1 + 3 * x2 * x2 + 2 * x3 + 3 * x4 - 3,
    ]
}

mcp! {
    model Cournot {
        data { firms: Set, cost[firms]: f64, scale[firms]: f64, power[firms]: f64, gamma: f64 }
        var q[i in firms] >= 0.0 start 10.0;
        def total: sum(firms, |i| q[i]);
        def price: 5000.0_f64.powf(1.0 / gamma) * total.pow(-1.0 / gamma);
        eq profit[i in firms]: cost[i] + (q[i] / scale[i]).pow(1.0 / power[i])
            - price + price * q[i] / (gamma * total) complements q[i];
    }
}

mcp! {
    model Transport {
        data { plants: Set, markets: Set, capacity[plants]: f64, demand[markets]: f64, cost[plants, markets]: f64 }
        var x[i in plants, j in markets] >= 0.0;
        var w[i in plants] >= 0.0;
        var p[j in markets] >= 0.0 start 1.0;
        eq profit[i in plants, j in markets]: w[i] + cost[i, j] - p[j]   complements x[i, j];
        eq supply[i in plants]: capacity[i] >= sum(markets, |j| x[i, j]) complements w[i];
        eq market[j in markets]: sum(plants, |i| x[i, j]) >= demand[j]   complements p[j];
    }
}

/// One consumer, two goods, no numeraire: any multiple of the prices is an equilibrium.
#[mcp_fn(lower = 0.0, start = 1.0)]
fn walras<D: Scalar>([p1, p2]: [Real<D>; 2]) -> [Real<D>; 2] {
    let income = p1 + 2.0 * p2;
    [1.0 - 0.5 * income / p1, 2.0 - 0.5 * income / p2]
}

#[test]
fn josephy_is_proved_and_the_closed_form_enclosed() {
    let model = Josephy::new().unwrap();
    let solution = solve_from(&model, &[1.0, 0.0, 0.0, 0.0], &Options::default()).unwrap();
    let accuracy = certify(&model, &solution).unwrap();
    assert!(radius(&accuracy) < 1e-8, "{accuracy}");
    let exact = [1.5_f64.sqrt(), 0.0, 0.0, 0.5];
    assert!((0..4).all(|j| accuracy.enclosure[j].contains(exact[j])), "{accuracy:?}");
    // F_3 = 3 · 3/2 + 3/2 − 1 = 5 and F_2 = 3 + √(3/2) + 1 − 2 are far from 0.
    assert!(accuracy.weakest.as_ref().unwrap().margin > 0.1);
}

#[test]
fn cournot_with_ten_firms_is_proved() {
    let firms: Vec<String> = (1..=10).map(|k| k.to_string()).collect();
    let model = Cournot::builder()
        .firms(firms)
        .cost([5.0, 3.0, 8.0, 5.0, 1.0, 3.0, 7.0, 4.0, 6.0, 3.0])
        .scale([10.0; 10])
        .power([1.2, 1.0, 0.9, 0.6, 1.5, 1.0, 0.7, 1.1, 0.95, 0.75])
        .gamma(1.2)
        .build()
        .unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    assert!(radius(&certify(&model, &solution).unwrap()) < 1e-8);
}

/// Plant 1 is exhausted (rent 1), plant 2 has capacity to spare and sells at its cost to `b`; the loss
/// on 2 → a is 2: every pair is strict.
#[test]
fn a_transport_problem_without_degenerate_pairs_is_proved() {
    let model = Transport::builder()
        .plants(["1", "2"])
        .markets(["a", "b"])
        .capacity([5.0, 6.0])
        .demand([4.0, 4.0])
        .cost([[1.0, 1.0], [4.0, 2.0]])
        .build()
        .unwrap();
    let solution = solve(&model, &Options::new(Method::NewtonMinFb)).unwrap().solved().unwrap();
    let accuracy = certify(&model, &solution).unwrap();
    assert!(radius(&accuracy) < 1e-8);
    let exact = [4.0, 1.0, 0.0, 3.0, 1.0, 0.0, 2.0, 2.0];
    assert!((0..8).all(|j| accuracy.enclosure[j].contains(exact[j])), "{:?}", accuracy.enclosure);
}

#[test]
fn the_degenerate_solution_of_kojima_and_shindo_is_refused_by_name() {
    let model = KojimaShindo::new().unwrap();
    let accuracy = certify_at(&model, &[1.5_f64.sqrt(), 0.0, 0.0, 0.5]);
    let Proof::Refused(Refusal::Degenerate { pairs, regularity }) = &accuracy.proof else {
        panic!("{accuracy}");
    };
    assert_eq!(pairs, &["x3"]);
    // det J of {1, 4} is 6√(3/2) · 3 − 3 · 2√(3/2) = 12√(3/2) > 0; with pair 3 it is negative.
    assert_eq!(regularity, &Degeneracy::Irregular { pairs: vec!["x3".to_owned()] });
    assert!(radius(&certify_at(&model, &[1.0, 0.0, 3.0, 0.0])) < 1e-10);
}

#[test]
fn homogeneous_prices_are_refused_and_named() {
    let model = Walras::new().unwrap();
    let accuracy = certify_at(&model, &[1.0, 0.5]);
    let movable = vec!["p1".to_owned(), "p2".to_owned()];
    assert_eq!(accuracy.proof, Proof::Refused(Refusal::Singular { movable }), "{accuracy}");
}

#[mcp_fn(start = 1.0)]
fn double_root<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    [(x - 2.0) * (x - 2.0)]
}

#[test]
fn a_double_root_is_refused_at_and_near_the_point() {
    let model = DoubleRoot::new().unwrap();
    for x in [2.0, 2.0 + 1e-15, 2.0 + 1e-8, 2.0 - 1e-5, 2.0 + 1e-3] {
        let accuracy = certify_at(&model, &[x]);
        assert!(!accuracy.is_proved(), "{x}: {accuracy}");
    }
}

#[mcp_fn(lower = 0.0, start = 1.0)]
fn steep<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [
        x - 1.0,
        y.sqrt()
            + external(&[x], |v, g| {
                *g = [1.0];
                v[0]
            })
            - 3.0,
    ]
}

#[test]
fn external_functions_are_refused_by_name() {
    let accuracy = certify_at(&Steep::new().unwrap(), &[1.0, 4.0]);
    let equation = "f[y]".to_owned();
    assert_eq!(accuracy.proof, Proof::Refused(Refusal::External { equation }));
    assert!(accuracy.to_string().starts_with("not proved: f[y] calls an external function"));
}

/// No root: the equation jumps from −1 to 1 at `x = 1`.
#[mcp_fn(start = 1.0)]
fn jump<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    [select(x - 1.0, x, x - 2.0)]
}

#[mcp_fn(start = 1.0)]
fn angle<D: Scalar>([y]: [Real<D>; 1]) -> [Real<D>; 1] {
    [crate::atan2(y, -1.0)]
}

#[mcp_fn(start = 0.5)]
fn kink<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x.max(y) + x - 2.0, (x - y).abs() + 3.0 * y - 3.0]
}

#[test]
fn a_jump_is_no_root_and_a_kink_may_be_one() {
    for x in [1.0, 1.0 - 1e-14, 1.0 + 1e-14] {
        let accuracy = certify_at(&Jump::new().unwrap(), &[x]);
        assert!(!accuracy.is_proved(), "{accuracy}");
    }
    assert!(!certify_at(&Angle::new().unwrap(), &[1e-17]).is_proved());
    assert!(radius(&certify_at(&Kink::new().unwrap(), &[1.0, 1.0])) < 1e-13);
}

#[mcp_fn(lower = [0.0, f64::NEG_INFINITY], start = 1.0)]
fn ray<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x + y - 1.0, 2.0 * x + 2.0 * y - 2.0]
}

#[test]
fn the_text_is_a_sentence() {
    let proved = Proof::Proved { radius: 3.11e-14 }.to_string();
    assert_eq!(proved, "a unique solution lies within 3.2e-14 (relative) of the point");
    let accuracy = certify_at(&Ray::new().unwrap(), &[0.5, 0.5]);
    let text = accuracy.to_string();
    assert!(
        text.starts_with("not proved: the active equations are singular: x, y can move while"),
        "{text}"
    );
}

#[test]
fn a_solution_of_another_model_is_an_error() {
    let solution = solve(&DoubleRoot::new().unwrap(), &Options::default()).unwrap();
    assert!(matches!(certify(&Ray::new().unwrap(), &solution), Err(ModelError::Length { .. })));
}

/// The bounds of the solution count, not those the model has now.
#[test]
fn the_problem_is_that_of_the_solution() {
    let model = Josephy::new().unwrap();
    let mut problem = AdProblem::new(&model).unwrap();
    problem.set_upper("x4", 0.25).unwrap();
    let mut solver = crate::Solver::new(Options::default()).unwrap();
    let solution = solver.solve_from(&mut problem, &[1.0, 0.0, 0.0, 0.0]).unwrap().clone();
    let accuracy = certify(&model, &solution).unwrap();
    assert!(radius(&accuracy) < 1e-8, "{accuracy}");
    assert!(accuracy.enclosure[3].contains(0.25));
}

mcp! {
    /// `A (g(z) − g(z*)) + c`, whose solution `z*` is known: `g` is strictly monotone and `A`
    /// dominated by its diagonal.
    model Manufactured {
        data { rows: Set, a[rows, rows]: f64, target[rows]: f64, extra[rows]: f64 }
        var z[i in rows] in -1.0..=1.0;
        def g[i in rows]: z[i].exp() + z[i].sin() - target[i].exp() - target[i].sin();
        eq f[i in rows]: sum(rows, |j| a[i, j] * g[j]) + extra[i] complements z[i];
    }
}

fn manufactured(target: &[f64], off_diagonal: &[f64]) -> Manufactured {
    let n = target.len();
    let extra: Vec<f64> =
        target.iter().map(|&z| -z * f64::from(u8::from(z.abs() == 1.0))).collect();
    let a = |i: usize, j: usize| if i == j { 2.0 * n as f64 } else { off_diagonal[i * n + j] };
    let labels: Vec<String> = (0..n).map(|i| i.to_string()).collect();
    Manufactured::builder()
        .rows(labels)
        .a((0..n).map(|i| (0..n).map(|j| a(i, j)).collect::<Vec<_>>()).collect::<Vec<_>>())
        .target(target.to_vec())
        .extra(extra)
        .build()
        .unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// `z*` solves the problem up to the rounding of `g(z*)`, a data constant; the box must hold
    /// that point within a few units in the last place.
    #[test]
    fn proofs_contain_the_manufactured_solution(
        interior in prop::collection::vec(-0.9..0.9_f64, 4),
        at_bound in prop::collection::vec(prop_oneof![Just(-1.0), Just(1.0)], 2),
        off in prop::collection::vec(-1.0..1.0_f64, 36),
        shift in prop::collection::vec(-1e-4..1e-4_f64, 6),
    ) {
        let target = [interior, at_bound].concat();
        let model = manufactured(&target, &off);
        let near: Vec<f64> =
            target.iter().zip(&shift).map(|(z, d)| (z + d).clamp(-1.0, 1.0)).collect();
        let accuracy = certify_at(&model, &near);
        prop_assert!(accuracy.is_proved(), "{}", accuracy);
        for j in 0..6 {
            let x = accuracy.enclosure[j];
            prop_assert!(x.lower() <= target[j] + 1e-14 && target[j] <= x.upper() + 1e-14);
            prop_assert!(x.lower() >= -1.0 && x.upper() <= 1.0);
        }
    }

    /// Where no solution lies within the largest box, nothing is proved.
    #[test]
    fn nothing_is_proved_far_from_the_only_solution(
        target in prop::collection::vec(-0.9..0.9_f64, 4),
        off in prop::collection::vec(-1.0..1.0_f64, 16),
        away in prop::collection::vec(0.3..0.5_f64, 4),
    ) {
        let model = manufactured(&target, &off);
        let far: Vec<f64> = target.iter().zip(&away).map(|(z, d)| z - z.signum() * d).collect();
        let accuracy = certify_at(&model, &far);
        if accuracy.is_proved() {
            for j in 0..4 {
                prop_assert!(accuracy.enclosure[j].contains(target[j]), "{}", accuracy);
            }
        }
    }
}

/// Sums of exponentials near the solution of `ln(eˣ + eʸ) = 1`, `x = y`.
#[mcp_fn(start = 1.0)]
fn exponentials<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [logsumexp([x, y], |t| t) - 1.0, x - y]
}

#[test]
fn logsumexp_is_enclosed() {
    let x = 1.0 - 2_f64.ln();
    let accuracy = certify_at(&Exponentials::new().unwrap(), &[x, x]);
    assert!(radius(&accuracy) < 1e-14, "{accuracy}");
    assert!(accuracy.enclosure[0].contains(x));
}

/// `F` is finite at the origin, the slope of its second equation, which must hold, is not.
#[mcp_fn(lower = [0.0, f64::NEG_INFINITY])]
fn root<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [1 + x, x.sqrt() + y]
}

#[test]
fn an_equation_without_finite_derivative_is_named() {
    let accuracy = certify_at(&Root::new().unwrap(), &[0.0, 0.0]);
    let Proof::Refused(Refusal::NotFinite { equation }) = &accuracy.proof else {
        panic!("{accuracy}");
    };
    assert_eq!(equation, "f[y]");
}

mcp! {
    model Separate {
        data { items: Set, target[items]: f64 }
        var x[i in items] free;
        eq balance[i in items]: x[i] - target[i] complements x[i];
    }
}

#[test]
fn more_variables_off_their_bounds_than_the_limit_are_refused_at_once() {
    let separate = |n: usize| {
        let names: Vec<String> = (0..n).map(|i| format!("i{i}")).collect();
        let model = Separate::builder().items(names).target(vec![1.0; n]).build().unwrap();
        certify_at(&model, &vec![1.0; n])
    };
    assert!(separate(20).is_proved());
    let refused = separate(MOST_OFF + 1);
    let expected = Refusal::TooLarge { off: MOST_OFF + 1, limit: MOST_OFF };
    assert_eq!(refused.proof, Proof::Refused(expected), "{refused}");
}

/// No bound is where it is infinite, whatever the sign of `F`.
#[test]
fn what_has_no_solution_is_not_proved_at_infinity() {
    #[mcp_fn]
    fn free<D: Scalar>([z]: [Real<D>; 1]) -> [Real<D>; 1] {
        [0.0 * z + 3.4]
    }
    #[mcp_fn(lower = 0.0)]
    fn pushed<D: Scalar>([z]: [Real<D>; 1]) -> [Real<D>; 1] {
        [0.0 * z - 1.0]
    }
    let free = certify_at(&Free::new().unwrap(), &[0.0]);
    let pushed = certify_at(&Pushed::new().unwrap(), &[0.0]);
    assert!(!free.is_proved() && !pushed.is_proved(), "{free} {pushed}");
}

/// `F(0) = +∞` has the right sign at a lower bound, but is no value.
#[test]
fn what_is_undefined_at_the_bound_is_not_proved_there() {
    #[mcp_fn(lower = 0.0)]
    fn logarithm<D: Scalar>([z]: [Real<D>; 1]) -> [Real<D>; 1] {
        [1.0 - z.ln() + z]
    }
    let accuracy = certify_at(&Logarithm::new().unwrap(), &[1e-13]);
    assert!(!accuracy.is_proved(), "{accuracy}");
}
