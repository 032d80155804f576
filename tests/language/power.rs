//! Hourly dispatch with a network, storage and scarcity.

use mcp_core::{Options, mcp, solve};

mcp! {
    /// Power markets at nodes and hours.
    pub model Power {
        data {
            nodes: Set, hours: Ordered, gens: Set, stores: Set, thermal: Subset(gens),
            lines: Pairs(nodes, nodes), site: Map(gens, nodes), place: Map(stores, nodes),
            load[nodes, hours]: f64, cap[gens]: f64, avail[gens, hours]: f64, fuel[gens]: f64,
            fmax[lines]: f64, smax[stores]: f64, pw[stores]: f64, eta: f64, voll: f64,
        }
        var q[g in gens, t in hours] in 0.0..=cap[g] * avail[g, t];
        var f[l in lines, t in hours] in -fmax[l]..=fmax[l];
        var shed[n in nodes, t in hours] in 0.0..=load[n, t];    var p[n in nodes, t in hours] >= 0.0;
        var ch[k in stores, t in hours] in 0.0..=pw[k];          var dis[k in stores, t in hours] in 0.0..=pw[k];
        var s[k in stores, t in hours] in 0.0..=smax[k];         var v[k in stores, t in hours] free;
        def mc[g in gens]: fuel[g];
        eq run[g in gens, t in hours]: mc[g] - p[site[g], t]                           complements q[g, t];
        eq flow[l @ (i, j) in lines, t in hours]: p[i, t] - p[j, t]                    complements f[l, t];
        eq scarcity[n in nodes, t in hours]: voll - p[n, t]                            complements shed[n, t];
        eq market[n in nodes, t in hours]: sum(site.of(n), |g| q[g, t]) + sum(place.of(n), |k| dis[k, t] - ch[k, t])
           + sum(lines.into(n), |l| f[l, t]) - sum(lines.out_of(n), |l| f[l, t]) + shed[n, t] - load[n, t]   complements p[n, t];
        eq charge[k in stores, t in hours]: p[place[k], t] - eta * v[k, t]             complements ch[k, t];
        eq discharge[k in stores, t in hours]: v[k, t] - p[place[k], t]                complements dis[k, t];
        eq hold[k in stores, t in hours]: v[k, t] - v[k, hours.wrap(t, 1)]             complements s[k, t];
        eq level[k in stores, t in hours]: s[k, hours.wrap(t, -1)] + eta*ch[k, t] - dis[k, t] - s[k, t]   complements v[k, t];
        report emissions: sum(thermal, |g| sum(hours, |t| q[g, t]));
        part co2 { data { limit: f64, ef[thermal]: f64 }  var pc >= 0.0;
          eq cap_co2: limit - sum(thermal, |g| ef[g] * sum(hours, |t| q[g, t]))        complements pc;
          adds mc[g in thermal]: ef[g] * pc; }
    }
}

/// Cheap coal in the west, gas and a battery in the east, a line of 10 MW between them. In the
/// evening the east is short: gas runs at its limit, the line is full, the battery is empty.
#[test]
fn scarcity_in_the_evening_sets_the_price_and_the_value_of_water() {
    let model = day();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    assert_eq!(view.pc, None);
    for hour in ["noon", "evening"] {
        near(view.p[("west", hour)], 20.0);
        near(view.q[("coal", hour)], 60.0);
        near(view.f[("west->east", hour)], 10.0);
    }
    // Filling 4 MWh at noon takes 5 MWh of gas; the evening lacks 60 − 10 − 40 − 4.
    near(view.q[("gas", "noon")], 25.0);
    near(view.q[("gas", "evening")], 40.0);
    near(view.shed[("east", "evening")], 6.0);
    near(view.p[("east", "noon")], 50.0);
    near(view.p[("east", "evening")], 1000.0);
    near(view.v[("battery", "noon")], 50.0 / 0.8);
    near(view.v[("battery", "evening")], 1000.0);
    near(view.s[("battery", "noon")], 4.0);
    near(view.s[("battery", "evening")], 0.0);
    near(view.emissions, 120.0);
    // Scarcity rents are −F at the upper bounds: gas in the evening, the line.
    near(-view.q.marginal(("gas", "evening")).unwrap(), 950.0);
    near(-view.f.marginal(("west->east", "evening")).unwrap(), 980.0);
}

/// Two nodes at noon and in the evening.
fn day() -> Power {
    let mut model = Power::builder()
        .nodes(["west", "east"])
        .hours(["noon", "evening"])
        .gens(["coal", "gas"])
        .stores(["battery"])
        .thermal(["coal"])
        .lines([("west", "east")])
        .site([("gas", "east"), ("coal", "west")])
        .place([("battery", "east")])
        .load([[50.0, 50.0], [30.0, 60.0]])
        .cap([("gas", 40.0), ("coal", 100.0)])
        .avail(1.0)
        .fuel([20.0, 50.0])
        .fmax(10.0)
        .smax(4.0)
        .pw(10.0)
        .eta(0.8)
        .voll(1000.0)
        .build()
        .unwrap();
    // From 0 the classical methods stall; from the highest prices that can be they do not.
    model.set_start_of("p", 1000.0).unwrap();
    model.set_start_of("v", 1000.0).unwrap();
    model.set_start_of("q", 20.0).unwrap();
    model
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-6, "{found} instead of {expected}");
}

/// A cap of 110 t takes 10 MWh of coal out, at noon, when gas is not short: it costs 50 − 20 more.
#[test]
fn a_cap_on_emissions_costs_what_gas_costs_beyond_coal() {
    let without = day();
    let solution = solve(&without, &Options::default()).unwrap().solved().unwrap();
    let mut model = without.with(Co2 { limit: 110.0, ef: [("coal", 1.0)] }).unwrap();
    model.start_from(&solution).unwrap();
    let capped = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&capped).unwrap();
    near(view.pc.unwrap(), 30.0);
    near(view.mc["coal"], 50.0);
    near(view.mc["gas"], 50.0);
    near(view.emissions, 110.0);
    near(view.q[("coal", "noon")], 50.0);
    near(view.q[("gas", "noon")], 35.0);
    near(view.f[("west->east", "noon")], 0.0);
    near(view.p[("west", "evening")], 50.0);
    near(view.p[("east", "evening")], 1000.0);

    // Far from binding, it changes nothing.
    let loose = without.with(Co2 { limit: 1e3, ef: 1.0 }).unwrap();
    let free = solve(&loose, &Options::default()).unwrap().solved().unwrap();
    let view = loose.view(&free).unwrap();
    assert_eq!(view.pc, Some(0.0));
    for (level, expected) in free.z.iter().zip(&solution.z) {
        assert!((level - expected).abs() <= 1e-12 * expected.abs().max(1.0));
    }
}
