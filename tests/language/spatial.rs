//! Spatial price equilibrium on the arcs that exist.

use mcp_core::{Options, mcp, solve};

mcp! {
    /// Regions trade a good along arcs of limited capacity.
    pub model Spatial {
        data {
            regions: Set, arcs: Pairs(regions, regions), cost[arcs]: f64, cap[arcs]: f64,
            a[regions]: f64, b[regions]: f64, d0[regions]: f64, p0[regions]: f64, eps[regions]: f64,
        }
        var x[r in arcs] in 0.0..=cap[r];
        var y[i in regions] >= 0.0;
        var p[i in regions] >= 1e-9 start p0[i];
        eq arbitrage[r @ (i, j) in arcs]: p[i] + cost[r] - p[j]               complements x[r];
        eq supply[i in regions]: a[i] + b[i] * y[i] - p[i]                    complements y[i];
        eq market[i in regions]:
            y[i] + sum(arcs.into(i), |r| x[r]) - sum(arcs.out_of(i), |r| x[r])
                - d0[i] * (p[i] / p0[i]).pow(-eps[i])                         complements p[i];
        report trade[r @ (i, j) in arcs]: p[i] * x[r];
    }
}

const A: [f64; 2] = [1.0, 4.0];
const B: [f64; 2] = [0.5, 1.0];
const D0: [f64; 2] = [6.0, 8.0];
const EPS: [f64; 2] = [0.5, 1.5];
const COST: f64 = 0.7;

fn spatial(capacity: f64) -> Spatial {
    Spatial::builder()
        .regions(["north", "south"])
        .arcs([("north", "south"), ("south", "north")])
        .cost(COST)
        .cap(capacity)
        .a(A)
        .b(B)
        .d0(D0)
        .p0(5.0)
        .eps(EPS)
        .build()
        .unwrap()
}

/// Supply minus demand of a region at price `p`.
fn excess(i: usize, p: f64) -> f64 {
    ((p - A[i]) / B[i]).max(0.0) - D0[i] * (p / 5.0).powf(-EPS[i])
}

/// Zero of an increasing function.
fn bisect(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle) < 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[test]
fn with_free_arcs_prices_differ_by_the_cost() {
    let model = spatial(100.0);
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    // North is cheaper: it exports, and the two regions are one market.
    let north = bisect(|p| excess(0, p) + excess(1, p + COST), 0.1, 50.0);
    assert!((view.p["north"] - north).abs() < 1e-8);
    assert!((view.p["south"] - north - COST).abs() < 1e-8);
    assert!((view.x["north->south"] - excess(0, north)).abs() < 1e-7);
    assert!(view.x["south->north"].abs() < 1e-8);
    assert!((view.trade["north->south"] - north * excess(0, north)).abs() < 1e-6);
}

#[test]
fn an_arc_at_capacity_separates_the_markets() {
    let model = spatial(0.5);
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    let north = bisect(|p| excess(0, p) - 0.5, 0.1, 50.0);
    let south = bisect(|p| excess(1, p) + 0.5, 0.1, 50.0);
    assert!(south - north > COST);
    assert!((view.p["north"] - north).abs() < 1e-8);
    assert!((view.p["south"] - south).abs() < 1e-8);
    // The rent of the arc is what the price difference leaves after the cost.
    let rent = -view.x.marginal("north->south").unwrap();
    assert!((rent - (south - north - COST)).abs() < 1e-7);
}
