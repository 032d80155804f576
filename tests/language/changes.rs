//! A built model changes by name, and starts from solutions of other models.

use mcp_core::{AdProblem, Method, Model, Options, Solver, mcp, solve};

mcp! {
    /// Plants supply markets.
    pub model Transport {
        data { plants: Set, markets: Set, capacity[plants]: f64, demand[markets]: f64, cost[plants, markets]: f64 }
        /// world price level
        param level = 1.0;
        /// shipment [cases]
        var x[i in plants, j in markets] >= 0.0;
        /// shadow price of capacity [$/case]
        var w[i in plants] >= 0.0;
        /// delivered price [$/case]
        var p[j in markets] >= 0.0 start 1.0;
        eq profit[i in plants, j in markets]: w[i] + level * cost[i, j] - p[j]       complements x[i, j];
        eq supply[i in plants]:  capacity[i] >= sum(markets, |j| x[i, j])            complements w[i];
        eq market[j in markets]: sum(plants, |i| x[i, j]) >= demand[j] / p[j]        complements p[j];
        report spending[j in markets]: p[j] * sum(plants, |i| x[i, j]);
    }
}

fn transport(markets: &[&str]) -> Transport {
    Transport::builder()
        .plants(["seattle", "san-diego"])
        .markets(markets.to_vec())
        .capacity([8.0, 9.0])
        .demand(3.0)
        .cost(
            markets
                .iter()
                .enumerate()
                .flat_map(|(j, &m)| {
                    [(("seattle", m), 1.0 + j as f64), (("san-diego", m), 2.5 - j as f64 * 0.5)]
                })
                .collect::<Vec<_>>(),
        )
        .build()
        .unwrap()
}

#[test]
fn a_parameter_changes_and_the_warm_solve_is_short() {
    let mut problem = AdProblem::new(transport(&["chicago", "topeka"])).unwrap();
    let mut solver = Solver::new(Options::new(Method::NewtonFb)).unwrap();
    let cold = solver.solve(&mut problem).unwrap().clone().solved().unwrap();
    problem.set_parameter("level", &[1.01]).unwrap();
    let warm = solver.solve_from(&mut problem, &cold.z).unwrap().clone().solved().unwrap();
    assert!(warm.stats.iterations < cold.stats.iterations);
    let view = problem.model().view(&warm).unwrap();
    assert_eq!(view.level, 1.01);
    assert!((view.p["chicago"] - 1.01).abs() < 1e-8);
    assert!((view.spending["topeka"] - 3.0).abs() < 1e-8);
}

#[test]
fn bounds_starts_and_fixings_change_by_name() {
    let mut model = transport(&["chicago", "topeka"]);
    model.set_upper("x[seattle, chicago]", 1.0).unwrap();
    model.fix("w[seattle]", 0.25).unwrap();
    model.set_lower("p", 0.5).unwrap();
    model.set_start_of("x", 0.75).unwrap();
    let shape = model.shape();
    assert_eq!(shape.bounds().upper()[0], 1.0);
    assert_eq!(shape.bounds().lower()[4], 0.25);
    assert_eq!(shape.start()[..4], [0.75; 4]);
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    assert_eq!(solution.level("w[seattle]").unwrap(), 0.25);
    assert!((solution.level("x[seattle, chicago]").unwrap() - 1.0).abs() < 1e-9);
    let error = model.fix("x[seatle, chicago]", 1.0).unwrap_err();
    assert_eq!(error.to_string(), "there is no label `seatle`; did you mean `seattle`?");
    assert!(model.set_lower("p[topeka]", f64::NAN).is_err());
}

#[test]
fn a_start_is_taken_from_a_solution_with_other_sets() {
    let small = transport(&["chicago", "topeka"]);
    let solution = solve(&small, &Options::default()).unwrap().solved().unwrap();
    let mut large = transport(&["topeka", "new-york", "chicago"]);
    let taken = large.start_from(&solution).unwrap();
    assert_eq!(taken, 4 + 2 + 2);
    let start = large.shape().start();
    let at = |name: &str| start[large.shape().variable_index(name).unwrap()];
    assert_eq!(at("p[chicago]"), solution.level("p[chicago]").unwrap());
    assert_eq!(at("x[seattle, topeka]"), solution.level("x[seattle, topeka]").unwrap());
    assert_eq!(at("p[new-york]"), 1.0, "what has no namesake keeps its own start");
}

#[test]
fn a_view_reads_by_label_and_offers_the_nearest() {
    let model = transport(&["chicago", "topeka"]);
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    assert_eq!(view.x[("seattle", "topeka")], solution.z[1]);
    assert_eq!(view.p["topeka"], solution.level("p[topeka]").unwrap());
    assert_eq!(view.x.marginal(("seattle", "topeka")).unwrap(), solution.f[1]);
    let labels: Vec<[String; 2]> = view.x.iter().map(|(labels, _)| labels).collect();
    assert_eq!(labels[2], ["san-diego", "chicago"]);
    let error = view.x.get(("seattle", "topekka")).unwrap_err();
    assert_eq!(error.to_string(), "there is no label `topekka`; did you mean `topeka`?");
    let other = solve(&transport(&["chicago"]), &Options::default()).unwrap();
    assert!(model.view(&other).is_err(), "a solution of a model with other sets");
}

#[test]
#[should_panic(expected = "p: there is no label `topekka`; did you mean `topeka`?")]
fn an_unknown_label_in_brackets_panics_with_the_nearest() {
    let model = transport(&["chicago", "topeka"]);
    let solution = solve(&model, &Options::default()).unwrap();
    let _ = model.view(&solution).unwrap().p["topekka"];
}

#[test]
fn names_texts_and_units_reach_the_shape() {
    let model = transport(&["chicago", "topeka"]);
    let w = model.shape().variable("w").unwrap();
    assert_eq!((w.about(), w.unit()), ("shadow price of capacity", "$/case"));
    assert_eq!(model.shape().variable_name(3), "x[san-diego, topeka]");
    assert_eq!(model.shape().equation_name(6), "market[chicago]");
}
