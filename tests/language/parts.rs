//! What a user meets of parts: answers by name, changes, errors.

use super::economy::full::{Cap, Economy, Quota, Tax, economy};
use super::economy::{DIRT, LIMIT, MOST};
use mcp_core::study::compare;
use mcp_core::{Model, ModelError, Options, Solution, mcp, solve};

fn solved(model: &Economy) -> Solution {
    solve(model, &Options::default()).unwrap().solved().unwrap()
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-9, "{found} instead of {expected}");
}

#[test]
fn each_part_moves_the_economy_as_its_closed_form() {
    // c + s y = p and y = d − p, per good.
    let base = economy();
    let view = base.view(&solved(&base)).unwrap();
    near(view.y["bread"], 6.0);
    near(view.y["steel"], 8.0);

    // y = d − (1 + t) p.
    let taxed = base.with(Tax).unwrap();
    let view = taxed.view(&solved(&taxed)).unwrap();
    near(view.y["bread"], (10.0 - 1.25 * 1.0) / (1.0 + 1.25 * 0.5));
    near(view.price["steel"], 1.25 * view.p["steel"]);

    // y = limit: the permit is p − c − s y.
    let capped = base.with(Cap { limit: 3, dirt: [("steel", DIRT)] }).unwrap();
    let view = capped.view(&solved(&capped)).unwrap();
    near(view.permit.unwrap(), 12.0 - 3.0 - 2.0 - 0.25 * 3.0);
    near(view.paid.unwrap(), 3.0 * view.permit.unwrap());
    near(view.unit_cost["bread"], 1.0 + 0.5 * 6.0);

    // The rent is p − c − s y: income is what labour and land are left with.
    let with_quota = base.with(Quota { most: [("steel", 100.0), ("bread", 2.0)] }).unwrap();
    let view = with_quota.view(&solved(&with_quota)).unwrap();
    near(view.rent["bread"], 10.0 - 2.0 - 1.0 - 0.5 * 2.0);
    near(view.rent["steel"], 0.0);
    near(view.income, 2.0 * 8.0 + 4.0 * 8.0 + 2.0 * view.rent["bread"]);
}

#[test]
fn names_of_a_part_that_is_off_do_not_exist() {
    let mut base = economy();
    let solution = solved(&base);
    let view = base.view(&solution).unwrap();
    assert!(base.parts().is_empty());
    assert_eq!((view.permit, view.paid), (None, None));
    assert!(view.rent.is_empty() && view.rate.is_empty() && view.most.is_empty());
    let off = "`rent` exists only with the part `quota`, which is off";
    assert_eq!(view.rent.get("bread").unwrap_err().to_string(), off);
    assert_eq!(view.rent.marginal("bread").unwrap_err().to_string(), off);
    assert_eq!(base.shape().variables().len(), 3);
    assert_eq!(
        base.set_parameter("rate", &[0.1, 0.1]).unwrap_err().to_string(),
        "`rate` exists only with the part `tax`, which is off"
    );
}

#[test]
fn a_comparison_has_dashes_where_a_name_is_absent() {
    let base = economy();
    let capped = base.with(Cap { limit: LIMIT, dirt: DIRT }).unwrap();
    let table = compare(&solved(&base), &solved(&capped)).to_string();
    let line = table.lines().find(|line| line.contains("permit")).unwrap();
    let cells: Vec<&str> = line.split_whitespace().collect();
    assert_eq!(cells, ["permit", "-", "6.25", "-", "-"]);
}

#[test]
fn a_solution_belongs_to_the_parts_that_are_on_and_starts_others_by_name() {
    let base = economy();
    let solution = solved(&base);
    let mut capped = base.with(Cap { limit: LIMIT, dirt: DIRT }).unwrap();
    assert!(matches!(capped.view(&solution), Err(ModelError::Length { .. })));
    assert_eq!(capped.start_from(&solution).unwrap(), 5);
    assert_eq!(capped.shape().start()[0], solution.z[0]);
    assert_eq!(capped.shape().start()[5], 0.0);
}

#[test]
fn what_was_changed_by_name_stays_changed() {
    let mut base = economy().with(Tax).unwrap();
    base.set_parameter("rate", &[0.5, 0.75]).unwrap();
    base.fix("p[bread]", 2.0).unwrap();
    base.set_upper("y[steel]", 7.0).unwrap();
    base.set_start_of("income", 3.0).unwrap();
    let all = base.with((Quota { most: MOST }, Cap { limit: LIMIT, dirt: DIRT })).unwrap();
    assert_eq!(all.parts(), ["tax", "cap", "quota"]);
    let shape = all.shape();
    assert_eq!(shape.parameter_values(), [0.5, 0.75]);
    assert_eq!(shape.bounds().lower(), [0.0, 0.0, 2.0, 0.0, f64::NEG_INFINITY, 0.0, 0.0, 0.0]);
    assert_eq!(shape.bounds().upper()[..4], [f64::INFINITY, 7.0, 2.0, f64::INFINITY]);
    assert_eq!(shape.start()[..5], [1.0, 1.0, 2.0, 1.0, 3.0]);
}

#[test]
fn wrong_data_of_a_part_are_answered_as_those_of_the_model() {
    let message = |error: Result<Economy, ModelError>| error.unwrap_err().to_string();
    let base = economy();
    assert_eq!(
        message(base.with(Cap { limit: LIMIT, dirt: [("steal", 1.0)] })),
        "`dirt` names `steal`, which is no label of `dirty`; did you mean `steel`?"
    );
    assert_eq!(
        message(base.with(Cap { limit: f64::NAN, dirt: 1.0 })),
        "`limit` is NaN: give a number"
    );
    assert_eq!(
        message(base.with(Quota { most: [("bread", 1.0)] })),
        "`most[steel]` has no value (missing: 1 of 2)"
    );
}

mcp! {
    /// A block on a slope: what holds it depends on the parts.
    model Block {
        data { directions: Set[normal, along], weight[directions]: f64, places: Ordered, more: Set }
        /// velocity
        var v[d in directions] free;
        var w[t in places] free;
        fix w[places.first()] = 1.0;
        def load[d in directions]: weight[d];
        def pull[d in directions] lifted: load[d];
        eq momentum[d in directions]: v[d] - pull[d]                    complements v[d];
        eq follow[t in places] if !places.is_first(t): w[t] - w.at(t, -1).or(0.0)   complements w[t];
        /// A wall that the block cannot enter.
        part contact {
            var rn >= 0.0;
            eq gap: v[normal]                                           complements rn;
            adds momentum[normal]: -rn;
        }
        part friction requires contact {
            data { mu: f64, grains: Set, size[grains]: f64 }
            var rt free;
            def bound: mu * rn;
            eq slip: rt + (-v[along] - rt).clamp(-bound, bound) + 0.0 * sum(grains, |g| size[g])   complements rt;
            adds momentum[along]: rt;
        }
        part stop { fix v[along] = 0.0; adds pull[normal]: 4.0; adds follow[t]: -1.0; }
        part glue excludes contact {
            param pull_back;
            fix v[along] = 0.5;
            def extra: 1.0 + v[along];
            def share: 2.0 * extra;
            adds load[along]: pull_back + share;
        }
    }
}

fn block() -> Block {
    Block::builder().weight([-1.0, 2.0]).places(["a", "b", "c"]).more(2).build().unwrap()
}

fn v(model: &Block) -> [f64; 2] {
    let solution = solve(model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    [view.v["normal"], view.v["along"]]
}

#[test]
fn friction_needs_its_contact_and_both_its_data() {
    assert_eq!(v(&block()), [-1.0, 2.0]);
    let friction = Friction { mu: 0.5, grains: ["sand", "silt"], size: 1 };
    assert_eq!(
        block().with(friction.clone()).unwrap_err().to_string(),
        "the part `friction` requires `contact`: switch both on, in one tuple"
    );
    let on = block().with((friction, Contact)).unwrap();
    let [normal, along] = v(&on);
    near(normal, 0.0);
    // v + rt = 2 with |rt| at most 0.5 rn = 0.5.
    near(along, 1.5);
}

#[test]
fn an_element_is_fixed_by_one_part() {
    let stopped = block().with(Stop).unwrap();
    assert_eq!(v(&stopped), [3.0, 0.0]);
    let solution = solve(&stopped, &Options::default()).unwrap();
    assert_eq!(stopped.view(&solution).unwrap().w.values(), [1.0, 2.0, 3.0]);
    assert_eq!(
        stopped.with(Glue { pull_back: 1.0 }).unwrap_err().to_string(),
        "`v[along]` is fixed twice, by the part `stop` and by the part `glue`"
    );
    let message = block().with((Contact, Glue { pull_back: 1.0 })).unwrap_err().to_string();
    assert_eq!(message, "the parts `glue` and `contact` exclude each other: switch one of them on");
}

#[test]
fn a_term_of_a_lifted_definition_belongs_to_its_start() {
    let start = |model: &Block, name: &str| {
        let shape = model.shape();
        shape.start()[shape.variable_index(name).unwrap()]
    };
    assert_eq!(start(&block(), "pull[normal]"), -1.0);
    assert_eq!(start(&block().with(Stop).unwrap(), "pull[normal]"), 3.0);
    // 2 + 3 + 2 (1 + 0.5): what the part defines is evaluated before what it is added to.
    let glued = block().with(Glue { pull_back: 3.0 }).unwrap();
    assert_eq!(start(&glued, "pull[along]"), 8.0);
    assert_eq!(v(&glued), [-1.0, 0.5]);
}

mcp! {
    /// Cities that trade by roads only where there are roads.
    model Cities {
        data { cities: Set, supply[cities]: f64 }
        var p[i in cities] >= 0.0 start 1.0;
        eq market[i in cities]: supply[i] + p[i] - 10.0     complements p[i];
        part roads {
            data {
                lines: Pairs(cities, cities), ports: Subset(cities), land: Map(cities, lands), lands: Set[north, south],
                hours: Ordered, n: usize, dof: 2, toll: f64, cost[lines]: f64,
            }
            param fee[l in lines] = 0.25 * cost[l];
            var f[l in lines] >= 0.0;
            var level[i in cities, t in hours] free;
            fix level[i in cities, hours.first()] = 0.0;
            eq trade[l @ (i, j) in lines]: p[i] + cost[l] + fee[l] - p[j]     complements f[l];
            eq next[i in cities, t in hours] if !hours.is_first(t):
                level[i, t] - level.at(i, t - 1).or(0.0) - toll              complements level[i, t];
            adds market[i]: sum(lines.into(i), |l| f[l]) - sum(lines.out_of(i), |l| f[l]);
            adds market[i in ports]: -1.0;
            report northern: sum(land.of(north), |i| p[i]);
            report more[k in dof, m in n]: (k.position() + m.position()) as f64 * toll;
        }
    }
}

#[test]
fn a_part_may_have_data_of_every_kind() {
    let base = Cities::builder().cities(["a", "b", "c"]).supply([8.0, 2.0, 4.0]).build().unwrap();
    let solution = solve(&base, &Options::default()).unwrap().solved().unwrap();
    let view = base.view(&solution).unwrap();
    assert_eq!((base.shape().n(), view.northern), (3, None));
    near(view.p["b"], 8.0);

    let linked = base
        .with(Roads {
            lines: [("a", "b")],
            ports: ["c"],
            land: [("a", "north"), ("b", "north"), ("c", "south")],
            hours: ["h1", "h2", "h3"],
            n: 2,
            toll: 0.5,
            cost: 0.8,
        })
        .unwrap();
    let solution = solve(&linked, &Options::default()).unwrap().solved().unwrap();
    let view = linked.view(&solution).unwrap();
    // p_a = 2 + f and p_b = 8 − f, apart by the cost and the fee.
    near(view.p["b"] - view.p["a"], 1.0);
    near(view.f["a->b"], 2.5);
    near(view.p["c"], 7.0);
    near(view.level[("c", "h3")], 1.0);
    near(view.northern.unwrap(), 4.5 + 5.5);
    assert_eq!(view.more.values(), [0.0, 0.5, 0.5, 1.0]);
    assert_eq!(linked.shape().n(), 3 + 1 + 9);
}
