//! # A day of a power market: network, storage and scarcity
//!
//! In every hour `t` power plants `g` at the nodes of a network produce `q` [GW] at the marginal
//! cost `c_g + h_g q` [$/kWh], as far as wind, sun and capacity allow. Lines carry a flow `f` of
//! either sign up to their limits; a reservoir is filled with `ch` and emptied with `dis`, with a
//! round-trip efficiency of `η`, and is as full after the day as before. What cannot be served is
//! shed at the value of lost load `V`. Prices `p` at the nodes and the value `v` of stored energy
//! clear all markets:
//!
//! ```text
//! c_g + h_g q_gt − p_nt                       ⟂   0 <= q_gt <= k_g a_gt      plant g at node n
//! p_it − p_jt                                 ⟂   −F_l <= f_lt <= F_l        line l from i to j
//! V − p_nt                                    ⟂   0 <= shed_nt <= load_nt
//! p_nt − η v_kt                               ⟂   0 <= ch_kt <= w_k          store k at node n
//! v_kt − p_nt                                 ⟂   0 <= dis_kt <= w_k
//! v_kt − v_k(t+1)                             ⟂   0 <= s_kt <= S_k
//! s_k(t−1) + η ch_kt − dis_kt − s_kt          ⟂   v_kt free
//! supply − demand at n in t                   ⟂   p_nt >= 0
//! ```
//!
//! These are the conditions of the convex program that serves the day at least cost, with its
//! shadow prices. At the upper bound of a line `−F` is its rent.
//!
//! Source of the model: Bohn, Caramanis & Schweppe, *Optimal pricing in electrical networks over
//! space and time*, RAND Journal of Economics 15 (1984) 360–376, without losses and loops. The
//! data, in `examples/data/power`, are invented. Prices in $/kWh keep the terms of all equations of
//! like size, which the methods need. Expected: wind is cheap in the north behind a full line, the
//! reservoir moves energy from the night and noon to the evening, where the calm leaves the south
//! short. `tests/gallery/power.rs` proves by duality that nothing costs less.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::language::{LabelMap, LabelPairs, Labels, Table};
use mcp_core::{ModelError, Options, mcp, solve};
use std::error::Error;
use std::path::Path;

mcp! {
    /// Power markets at nodes and hours.
    pub(crate) model Power {
        data {
            nodes: Set, hours: Ordered, gens: Set, stores: Set, lines: Pairs(nodes, nodes),
            site: Map(gens, nodes), place: Map(stores, nodes),
            terms: Set[capacity, fuel, slope],
            /// capacity [GW], marginal cost [$/kWh] and its slope [$/kWh per GW]
            plant[gens, terms]: f64,
            /// share of the capacity that can run
            avail[hours, gens]: f64,
            /// demand [GW]
            load[hours, nodes]: f64,
            /// most that a line carries [GW]
            limit[lines]: f64,
            /// energy a store holds [GWh], and power in and out [GW]
            volume[stores]: f64, turbine[stores]: f64,
            /// energy kept of energy stored
            eta: f64,
            /// value of lost load [$/kWh]
            voll: f64,
        }
        /// production [GW]
        var q[t in hours, g in gens] in 0.0..=plant[g, capacity] * avail[t, g]
            start 0.5 * plant[g, capacity] * avail[t, g];
        /// flow [GW]
        var f[t in hours, l in lines] in -limit[l]..=limit[l];
        /// load not served [GW]
        var shed[t in hours, n in nodes] in 0.0..=load[t, n];
        /// power into a store [GW]
        var ch[t in hours, k in stores] in 0.0..=turbine[k];
        /// power out of a store [GW]
        var dis[t in hours, k in stores] in 0.0..=turbine[k];
        /// energy in a store after the hour [GWh]
        var s[t in hours, k in stores] in 0.0..=volume[k] start 0.5 * volume[k];
        /// value of stored energy [$/kWh]
        var v[t in hours, k in stores] free start 0.05;
        /// price [$/kWh]
        var p[t in hours, n in nodes] >= 0.0 start 0.1;

        eq run[t in hours, g in gens]:
            plant[g, fuel] + plant[g, slope] * q[t, g] - p[t, site[g]]      complements q[t, g];
        eq arbitrage[t in hours, l @ (i, j) in lines]: p[t, i] - p[t, j]    complements f[t, l];
        eq scarcity[t in hours, n in nodes]: voll - p[t, n]                 complements shed[t, n];
        eq charge[t in hours, k in stores]: p[t, place[k]] - eta * v[t, k]  complements ch[t, k];
        eq discharge[t in hours, k in stores]: v[t, k] - p[t, place[k]]     complements dis[t, k];
        eq hold[t in hours, k in stores]: v[t, k] - v[hours.wrap(t, 1), k]  complements s[t, k];
        eq store[t in hours, k in stores]:
            s[hours.wrap(t, -1), k] + eta * ch[t, k] - dis[t, k] == s[t, k] complements v[t, k];
        eq market[t in hours, n in nodes]:
            sum(site.of(n), |g| q[t, g]) + sum(place.of(n), |k| dis[t, k] - ch[t, k])
                + sum(lines.into(n), |l| f[t, l]) - sum(lines.out_of(n), |l| f[t, l]) + shed[t, n]
            >= load[t, n]                                                   complements p[t, n];

        /// cost of the day, load not served included [M$]
        report cost: sum(hours, |t| voll * sum(nodes, |n| shed[t, n]) + sum(gens, |g|
            (plant[g, fuel] + 0.5 * plant[g, slope] * q[t, g]) * q[t, g]));
        /// rent of a line [M$]
        report rent[l @ (i, j) in lines]: sum(hours, |t| (p[t, j] - p[t, i]) * f[t, l]);
        /// what a store earns [M$]
        report earned[k in stores]: sum(hours, |t| p[t, place[k]] * (dis[t, k] - ch[t, k]));
    }
}

/// The invented data.
pub(crate) const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/power");

impl Power {
    /// Reads the files of a directory; the one store is a pumped reservoir in the middle.
    pub(crate) fn read(directory: &Path) -> Result<Self, ModelError> {
        let file = |name: &str| directory.join(name);
        Power::builder()
            .nodes(["north", "middle", "south"])
            .hours(Labels::csv(file("load.csv")))
            .load(Table::csv(file("load.csv")))
            .gens(Labels::csv(file("plants.csv")))
            .plant(Table::csv(file("plants.csv")))
            .site(LabelMap::csv(file("sites.csv")))
            .avail(Table::csv(file("availability.csv")))
            .lines(LabelPairs::csv(file("lines.csv")))
            .limit(Table::csv(file("limits.csv")))
            .stores(["reservoir"])
            .place([("reservoir", "south")])
            .volume(12.0)
            .turbine(2.5)
            .eta(0.75)
            .voll(3.0)
            .build()
    }
}

/// Cost of the day [M$].
pub(crate) const COST: f64 = 19.437;

fn main() -> Result<(), Box<dyn Error>> {
    let model = Power::read(DATA.as_ref())?;
    let solution = solve(&model, &Options::default())?.solved()?;
    let view = model.view(&solution)?;
    print_day(&view);
    println!("\ncost of the day {:.3} M$, {} iterations", view.cost, solution.stats.iterations);
    view.rent.iter().for_each(|([line], rent)| println!("rent of {line} {rent:.3} M$"));
    view.earned.iter().for_each(|([store], earned)| println!("the {store} earns {earned:.3} M$"));

    assert!((view.cost - COST).abs() < 1e-3);
    // Only the south goes short, in two hours in which all it has runs: gas, peakers, the reservoir
    // and the line give 6 + 3 + 2.5 + 3 GW.
    for (hour, short) in [("19", 14.8 - 14.5), ("20", 15.0 - 14.5)] {
        assert!((view.p[(hour, "south")] - 3.0).abs() < 1e-9);
        assert!((view.shed[(hour, "south")] - short).abs() < 1e-6);
        assert!(view.p[(hour, "middle")] < 0.2);
    }
    let unserved: f64 = view.shed.values().iter().sum();
    assert!((unserved - 0.8).abs() < 1e-6);
    // The reservoir buys at η of what it sells for.
    assert!((view.p[("12", "south")] - 0.75 * view.p[("17", "south")]).abs() < 1e-9);
    Ok(())
}

/// Production, flows, the reservoir, load not served [GW, GWh] and prices [$/kWh] of every hour.
fn print_day(view: &PowerView) {
    let gens = ["wind", "solar", "nuclear", "coal", "gas", "peaker"];
    let lines = ["north-middle", "middle-south"];
    let nodes = ["north", "middle", "south"];
    let names =
        [gens.map(|g| format!("{g:>8}")).concat(), nodes.map(|n| format!("{n:>8}")).concat()];
    let ends = lines.map(|l| format!("{l:>14}")).concat();
    println!("hour{}{ends}{:>7}{:>6}{}", names[0], "store", "shed", names[1]);
    for t in (0..24).map(|t| format!("{t:02}")) {
        let q = gens.map(|g| format!("{:>8.2}", view.q[(&t, g)] + 0.0)).concat();
        let f = lines.map(|l| format!("{:>14.2}", view.f[(&t, l)])).concat();
        let p = nodes.map(|n| format!("{:>8.4}", view.p[(&t, n)])).concat();
        let shed: f64 = nodes.iter().map(|n| view.shed[(&t, n)]).sum();
        println!("{t:>4}{q}{f}{:>7.2}{shed:>6.2}{p}", view.s[(&t, "reservoir")]);
    }
}
