//! Followers and leader against the formulas of linear demand, and against best answers.

#[path = "../../examples/stackelberg_cournot.rs"]
#[allow(dead_code, reason = "`main` is run as an example")]
mod example;

use example::{COST, Market};

/// Unit costs of the followers, least first.
const COSTS: [f64; 3] = [10.0, 20.0, 40.0];

/// The price at which the `m` cheapest followers, and no others, would sell: every active follower
/// sells `p − c_i`, hence `p = 100 − x − Σ (p − c_i)`.
fn price_with(m: usize, x: f64) -> f64 {
    (100.0 - x + COSTS[..m].iter().sum::<f64>()) / (m as f64 + 1.0)
}

/// The price with the followers that gain by selling.
fn price(x: f64) -> f64 {
    let gain = |m: &usize| *m == 0 || price_with(*m, x) > COSTS[m - 1];
    (0..=3).rev().find(gain).map(|m| price_with(m, x)).unwrap()
}

#[test]
fn followers_answer_as_the_formulas_say() {
    let mut market = Market::new().unwrap();
    for step in 0..=100 {
        let x = f64::from(step);
        let view = market.answer(x).unwrap();
        assert!((view.p - price(x)).abs() < 1e-9, "price {} at {x}", view.p);
        for (firm, cost) in ["large", "middle", "small"].into_iter().zip(COSTS) {
            let expected = (price(x) - cost).max(0.0);
            assert!((view.q[firm] - expected).abs() < 1e-9, "{firm} at {x}: {}", view.q[firm]);
        }
    }
}

#[test]
fn no_follower_gains_by_another_output() {
    let mut market = Market::new().unwrap();
    let view = market.answer(42.5).unwrap();
    for (firm, cost) in ["large", "middle", "small"].into_iter().zip(COSTS) {
        let profit = |q: f64| (view.p + view.q[firm] - q - cost) * q;
        for step in 0..=400 {
            let q = 0.1 * f64::from(step);
            assert!(profit(q) <= profit(view.q[firm]) + 1e-9, "{firm} would rather sell {q}");
        }
    }
}

/// On each piece the profit is a parabola, so that its peak is at a vertex or at the end of a
/// piece.
#[test]
fn the_leader_finds_the_best_vertex() {
    let vertex = |m: usize| (price_with(m, 0.0) - COST) * (m as f64 + 1.0) / 2.0;
    let leaves = |m: usize| (price_with(m, 0.0) - COSTS[m - 1]) * (m as f64 + 1.0);
    let candidates = (0..=3).map(vertex).chain((1..=3).map(leaves));
    let profit = |x: f64| (price(x) - COST) * x;
    let best = candidates.max_by(|x, y| profit(*x).total_cmp(&profit(*y))).unwrap();
    assert_eq!(best, 42.5);
    let led = Market::new().unwrap().lead(0.0, 100.0).unwrap();
    assert!((led - best).abs() < 1e-3, "{led}");
}

/// In Cournot equilibrium the leader's marginal revenue, the followers' answer taken as given, is
/// its cost.
#[test]
fn without_a_leader_nobody_gains_by_another_output() {
    let view = Market::new().unwrap().answer(21.25).unwrap();
    assert!((view.p - 21.25 - COST).abs() < 1e-9);
}
