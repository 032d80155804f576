//! Braess's network: closed forms.

use crate::traffic::{Traffic, equilibrium, network, tables};
use mcp_core::Model;
use network::Network;

/// Traffic of the five arcs and the minutes of a trip, charged as given.
fn solved(demand: f64, charged: f64, close: bool) -> ([f64; 5], f64) {
    let directory = tables("braess");
    let network = Network::read(&directory).unwrap();
    let mut model = Traffic::read(&directory).unwrap();
    model.set_parameter("trips", &[demand, 0.0, 0.0, 0.0]).unwrap();
    model.set_parameter("charged", &[charged]).unwrap();
    if close {
        model.fix("x[top->bottom, end]", 0.0).unwrap();
    }
    let start = network.start(&network.frank_wolfe(20));
    assert_eq!(start.len(), model.shape().n());
    let (solution, _) = equilibrium(&model, &start).unwrap();
    let view = model.view(&solution).unwrap();
    let arcs = ["start->top", "start->bottom", "top->end", "bottom->end", "top->bottom"];
    (arcs.map(|arc| view.v[arc]), view.total_time / demand)
}

fn near(found: ([f64; 5], f64), traffic: [f64; 5], minutes: f64) {
    for (found, expected) in found.0.into_iter().zip(traffic) {
        assert!((found - expected).abs() < 1e-8, "{found} is not {expected}");
    }
    assert!((found.1 - minutes).abs() < 1e-7, "{} is not {minutes}", found.1);
}

#[test]
fn the_extra_arc_makes_every_trip_longer() {
    near(solved(6.0, 0.0, true), [3.0, 3.0, 3.0, 3.0, 0.0], 83.0);
    near(solved(6.0, 0.0, false), [4.0, 2.0, 2.0, 4.0, 2.0], 92.0);
}

#[test]
fn the_toll_empties_the_extra_arc() {
    near(solved(6.0, 1.0, false), [3.0, 3.0, 3.0, 3.0, 0.0], 83.0);
}

#[test]
fn the_extra_arc_is_used_alone_at_low_demand_and_not_at_all_at_high() {
    // A route over the arc takes 10 v_st + 10 + v_tb + 10 v_be, one beside it 50 + v + 10 v. With
    // all d on the arc: 21 d + 10 <= 10 d + 50, d <= 40/11. With none: 20 d/2 + 10 >= 50 + 11 d/2,
    // d >= 80/9. In between w on the arc and (d − w)/2 on each side, of equal times:
    // 10 (d + w) + 10 + w = 50 + (d − w)/2 + 5 (d + w), hence w = (80 − 9 d)/13.
    near(solved(3.0, 0.0, false), [3.0, 0.0, 0.0, 3.0, 3.0], 73.0);
    near(solved(10.0, 0.0, false), [5.0, 5.0, 5.0, 5.0, 0.0], 105.0);
    for d in [4.0, 5.0, 8.0] {
        let w = (80.0 - 9.0 * d) / 13.0;
        let (inner, outer) = (f64::midpoint(d, w), (d - w) / 2.0);
        near(solved(d, 0.0, false), [inner, outer, outer, inner, w], 50.0 + outer + 10.0 * inner);
    }
}
