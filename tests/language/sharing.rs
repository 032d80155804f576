//! Several equations on one variable, and variables that exist only where a condition holds.

use mcp_core::{AdProblem, Model, Options, mcp, solve};

mcp! {
    /// Heat in a rod: the ends are held, the inside is in balance.
    pub model Rod {
        data { places: Ordered, left: f64, right: f64 }
        /// temperature [K]
        var u[i in places] free;
        eq held_left: u[places.first()] - left                              complements u[places.first()];
        eq held_right: u[places.last()] == right                            complements u[places.last()];
        eq balance[i in places] if !places.is_first(i) && !places.is_last(i):
            2.0 * u[i] - u.at(i - 1).or(0.0) - u.at(i, 1).or(0.0)           complements u[i];
    }
}

fn rod(places: usize) -> Rod {
    Rod::builder().places(places).left(300.0).right(400.0).build().unwrap()
}

#[test]
fn several_equations_share_a_variable() {
    let model = rod(11);
    assert_eq!(model.shape().equation_name(0), "held_left");
    assert_eq!(model.shape().equation_name(4), "balance[5]");
    assert_eq!(model.shape().equation_name(10), "held_right");
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    for ([place], u) in view.u.iter() {
        let k: f64 = place.parse().unwrap();
        assert!((u - (290.0 + 10.0 * k)).abs() < 1e-9);
    }
    // Only neighbours are read.
    assert_eq!(AdProblem::new(&model).unwrap().jacobian_pattern_size(), 2 + 9 * 3);
}

trait PatternSize {
    fn jacobian_pattern_size(&self) -> usize;
}
impl<M: Model> PatternSize for AdProblem<M> {
    fn jacobian_pattern_size(&self) -> usize {
        mcp_core::Problem::pattern(self).nnz()
    }
}

mcp! {
    /// A gap: nothing holds the last place.
    pub model Gap {
        data { places: Ordered }
        var u[i in places] free;
        eq first[i in places] if !places.is_last(i): u[i] - 1.0             complements u[i];
    }
}

mcp! {
    /// An overlap: the first place is held twice.
    pub model Overlap {
        data { places: Ordered }
        var u[i in places] free;
        eq all[i in places]: u[i] - 1.0                                     complements u[i];
        eq again[i in places] if places.is_first(i): u[i] - 2.0             complements u[i];
    }
}

#[test]
fn an_uncovered_element_is_named() {
    let error = Gap::builder().places(["a", "b", "c"]).build().unwrap_err();
    assert_eq!(error.to_string(), "variable `u[c]` has no equation: pair one with it or fix it");
}

#[test]
fn an_element_covered_twice_is_named_with_both_equations() {
    let error = Overlap::builder().places(["a", "b"]).build().unwrap_err();
    assert_eq!(
        error.to_string(),
        "variable `u[a]` is complementary to both `all[a]` and `again[a]`"
    );
}

mcp! {
    /// Trade between different regions only.
    pub model Trade {
        data { regions: Set, cost[regions, regions]: f64, supply[regions]: f64, demand[regions]: f64 }
        /// shipment [t]
        var x[i in regions, j in regions] in 0.0..=supply[i] + 1.0 if i != j;
        /// price [$/t]
        var p[i in regions] free;
        eq profit[i in regions, j in regions]: p[i] + cost[i, j] - p[j]     complements x[i, j];
        eq market[i in regions]:
            supply[i] + sum(regions, |j| x[j, i] - x[i, j]) == demand[i] - p[i] complements p[i];
    }
}

#[test]
fn elements_without_condition_do_not_exist() {
    let model = Trade::builder()
        .regions(["a", "b", "c"])
        .cost(0.5)
        .supply([3.0, 1.0, 2.0])
        .demand(10.0)
        .build()
        .unwrap();
    let shape = model.shape();
    assert_eq!(shape.n(), 6 + 3);
    assert_eq!(shape.variable_name(0), "x[a, b]");
    assert_eq!(shape.equation_name(2), "profit[b, a]");
    let error = shape.variable_index("x[a, a]").unwrap_err().to_string();
    assert!(error.contains("x[a, a]"), "{error}");
    assert_eq!(shape.bounds().upper()[..3], [4.0, 4.0, 2.0]);

    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    assert!(view.x.get(("b", "b")).is_err());
    // Alone, prices are 7, 9 and 8; a sends to b until they differ by the cost, c stays alone.
    for (region, price) in [("a", 7.75), ("b", 8.25), ("c", 8.0)] {
        assert!((view.p[region] - price).abs() < 1e-8);
    }
    assert!((view.x[("a", "b")] - 0.75).abs() < 1e-8);
}

mcp! {
    /// A matrix with a fixed edge and a normalised diagonal.
    pub model Square {
        data { s: Set, edge: f64 }
        var y[i in s, j in s] free if i != j;
        var d[i in s, j in s] free;
        fix y[i in s, j in s] = edge;
        eq off[i in s, j in s] if i != j: d[i, j] - y[i, j]                 complements d[i, j];
        eq on[i in s]: d[i, i] - 1.0                                        complements d[i, i];
    }
}

#[test]
fn a_diagonal_has_its_own_equation_and_a_fix_leaves_out_what_does_not_exist() {
    let model = Square::builder().s(["a", "b"]).edge(3).build().unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    assert_eq!(view.y.len(), 2);
    assert!((view.d[("a", "b")] - 3.0).abs() < 1e-9);
    assert!((view.d[("b", "b")] - 1.0).abs() < 1e-9);
}
