//! Regions that trade at the margin are one market: one unknown price, found by bisection.

#[path = "../../examples/spatial_price.rs"]
#[allow(dead_code, reason = "`main` is run as an example")]
mod example;

use crate::numbers::bisect;
use example::{DATA, PRICES, SpatialPrice};
use mcp_core::{Options, solve};

/// Region, intercept, slope, reference demand and price, elasticity, as in `regions.csv`.
const CURVES: [(&str, [f64; 5]); 5] = [
    ("plains", [80.0, 4.0, 10.0, 150.0, 0.4]),
    ("lakes", [110.0, 8.0, 14.0, 170.0, 0.5]),
    ("delta", [130.0, 10.0, 12.0, 180.0, 0.6]),
    ("coast", [160.0, 20.0, 25.0, 200.0, 0.8]),
    ("islands", [260.0, 40.0, 4.0, 240.0, 0.5]),
];

/// Arc, from, to, cost.
const ARCS: [(&str, &str, &str, f64); 6] = [
    ("rail", "plains", "lakes", 20.0),
    ("barge", "plains", "delta", 15.0),
    ("road", "lakes", "delta", 20.0),
    ("canal", "lakes", "coast", 25.0),
    ("train", "delta", "coast", 12.0),
    ("ship", "coast", "islands", 30.0),
];

/// Supply and demand of a region at the price `p`.
fn amounts(region: &str, p: f64) -> [f64; 2] {
    let (_, [a, b, demand, price, elasticity]) =
        *CURVES.iter().find(|(name, _)| *name == region).unwrap();
    [((p - a) / b).max(0.0), demand * (p / price).powf(-elasticity)]
}

/// The prices of regions that lie this freight above a common price.
fn one_market<const N: usize>(market: [(&'static str, f64); N]) -> [(&'static str, f64); N] {
    let excess = |p: f64| -> f64 {
        let of = |(region, freight): &(&str, f64)| amounts(region, p + freight);
        market.iter().map(of).map(|[supply, demand]| supply - demand).sum()
    };
    let common = bisect(excess, 1.0, 1000.0);
    market.map(|(region, freight)| (region, common + freight))
}

fn with_few_barges() -> Vec<(&'static str, f64)> {
    let freight = [("plains", 0.0), ("lakes", 20.0), ("delta", 33.0), ("coast", 45.0)];
    let [plains, lakes, delta, coast] = freight;
    one_market([plains, lakes, delta, coast, ("islands", 75.0)]).to_vec()
}

fn with_barges_enough() -> Vec<(&'static str, f64)> {
    let river = [("plains", 0.0), ("delta", 15.0), ("coast", 27.0), ("islands", 57.0)];
    let mut prices = one_market(river).to_vec();
    prices.extend(one_market([("lakes", 0.0)]));
    prices
}

#[test]
fn the_prices_of_the_example_are_those_of_bisection() {
    for (case, prices) in [with_few_barges(), with_barges_enough()].into_iter().enumerate() {
        for (region, asserted) in PRICES {
            let (_, price) = prices.iter().find(|(name, _)| *name == region).unwrap();
            assert!((price - asserted[case]).abs() < 5e-4, "{region}: {price}");
        }
    }
}

#[test]
fn prices_agree_with_bisection_and_no_arc_pays_more_than_its_cost() {
    let mut model = SpatialPrice::read(DATA.as_ref()).unwrap();
    for (capacity, prices) in [(8.0, with_few_barges()), (f64::INFINITY, with_barges_enough())] {
        model.set_upper("x[barge]", capacity).unwrap();
        let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
        let view = model.view(&solution).unwrap();
        for (region, price) in prices {
            assert!((view.p[region] - price).abs() < 1e-8, "{region}: {price}");
            let [supply, demand] = amounts(region, price);
            let net = |(arc, from, to, _): &(&str, &str, &str, f64)| {
                view.x[*arc] * (f64::from(*to == region) - f64::from(*from == region))
            };
            let imports: f64 = ARCS.iter().map(net).sum();
            assert!((supply + imports - demand).abs() < 1e-8, "{region}");
        }
        for (arc, from, to, cost) in ARCS {
            let gain = view.p[to] - view.p[from] - cost;
            assert!(gain < 1e-8 || view.x[arc] > capacity - 1e-8, "{arc} gains {gain}");
            assert!(gain > -1e-8 || view.x[arc] < 1e-8, "{arc} loses {gain}");
        }
    }
}
