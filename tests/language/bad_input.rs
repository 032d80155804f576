//! Wrong data and senseless models are answered before iteration 0, by name.

use mcp_core::{AdProblem, Statement, mcp};

mcp! {
    /// A small market with every kind of data.
    pub model Market {
        data {
            regions: Set, big: Subset(regions), arcs: Pairs(regions, regions), home: Map(big, regions),
            cost[arcs]: f64, floor[regions]: f64, cap[regions]: f64, scale: f64,
        }
        param tax[i in regions];
        var p[i in regions] in floor[i]..=cap[i];
        var x[a in arcs] >= 0.0;
        eq balance[i in regions]: scale * p[i] + tax[i] - 1.0       complements p[i];
        eq trade[a @ (i, j) in arcs]: cost[a] + p[i] - p[j]         complements x[a];
    }
}

/// Right data, which each test spoils in one place.
fn market() -> MarketBuilder {
    Market::builder()
        .regions(["north", "south"])
        .big(["south"])
        .arcs([("north", "south")])
        .home([("south", "north")])
        .cost(1.0)
        .floor(0.0)
        .cap(10.0)
        .scale(1.0)
        .tax(0.1)
}

/// What `build` says.
fn fault(market: MarketBuilder) -> String {
    market.build().map_or_else(|error| error.to_string(), |_| "nothing".to_owned())
}

#[test]
fn right_data_are_taken() {
    assert_eq!(fault(market()), "nothing");
}

#[test]
fn every_fault_names_its_offender() {
    let cases = [
        (Market::builder(), "`regions` is not given: call `.regions(…)` before `.build()`"),
        (market().regions(Vec::<String>::new()), "set `regions` is empty: give at least one label"),
        (
            market().big(["soth"]),
            "`big` names `soth`, which is no label of `regions`; did you mean `south`?",
        ),
        (market().floor([("north", 1.0)]), "`floor[south]` has no value (missing: 1 of 2)"),
        (market().floor([1.0, f64::NAN]), "`floor[south]` is NaN"),
        (market().cap([1.0, 2.0, 3.0]), "`cap[regions]` has the wrong shape: expected 2, found 3"),
        (market().cap(-1.0), "variable `p[north]` has crossed bounds: lower 0 is above upper -1"),
        (
            market().cap([("north", 1.0), ("south", 2.0), ("north", 3.0)]),
            "`cap[north]` is given twice",
        ),
        (market().scale(f64::NAN), "`scale` is NaN: give a number"),
        (market().tax(f64::INFINITY), "parameter `tax[north]` is inf: give a finite number"),
    ];
    for (market, message) in cases {
        let found = fault(market);
        assert!(found.starts_with(message), "{found}\ninstead of\n{message}");
    }
}

mcp! {
    /// An equation without variables, and a variable that nothing reads.
    pub model Senseless {
        data { a: f64 }
        var x >= 0.0;
        var y >= 0.0;
        eq constant: a                complements x;
        eq other: x - 1.0             complements y;
    }
}

#[test]
fn a_constant_equation_and_a_variable_nobody_reads_are_shown_by_name() {
    let model = Senseless::builder().a(1.0).build().unwrap();
    let statement = Statement::new(&mut AdProblem::new(model).unwrap());
    assert_eq!(statement.constant_equations.first, ["constant"]);
    assert_eq!(statement.unread_variables.first, ["y"]);
}
