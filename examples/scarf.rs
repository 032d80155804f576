//! # An economy that chooses its technology: Scarf's activity analysis
//!
//! Eight activities `s` turn capital and labour into goods: at level `y_s` the quantity
//! `a_sc y_s` of good `c` comes out, or goes in where `a_sc < 0`. Several make the same good, and
//! prices decide which are used. Five consumers `h` own `e_hc` and spend their income on a basket of
//! constant elasticity `σ_h`:
//!
//! ```text
//! −Σ_c a_sc p_c                       >= 0   ⟂   y_s >= 0   no activity makes a profit
//! Σ_s a_sc y_s + Σ_h (e_hc − x_hc)    >= 0   ⟂   p_c >= 0   what is in excess supply is free
//! I_h − Σ_c p_c e_hc                   = 0       I_h free
//! x_hc = α_hc p_c^−σ_h I_h / Σ_g α_hg p_g^(1−σ_h)           Cobb–Douglas where σ_h = 1
//! ```
//!
//! `α_h` is a reference demand, of which only proportions count. Only relative prices matter, so the income of the
//! first consumer is fixed at the worth of what it owns at prices of 1; its equation is not imposed
//! and holds all the same (Walras' law).
//!
//! Source: Scarf with Hansen, *The Computation of Economic Equilibria*, Yale University Press 1973;
//! the data are those of GAMS model library `scarfmcp`, with outputs and inputs in one table. No
//! solution comes with them, so `tests/gallery_flows/scarf.rs` checks every condition in plain
//! numbers, from the tables alone.
//!
//! Then everybody gets 1 more of skilled labour. The activity that makes nondurable goods, n1, gives
//! way to n2 and n3, and the example prints who gains.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::language::{Labels, Table};
use mcp_core::{Method, Model, ModelError, Options, mcp, solve};
use std::error::Error;
use std::path::Path;

mcp! {
    /// Activities, consumers and prices.
    pub(crate) model Scarf {
        data {
            goods: Set, consumers: Set, activities: Set,
            /// output, or input below 0, at level 1
            output[activities, goods]: f64,
            /// demand at reference prices
            reference[consumers, goods]: f64,
            /// elasticity of substitution
            sigma[consumers]: f64,
        }
        /// what consumers own
        param endowment[h in consumers, c in goods];

        /// level of an activity
        var y[s in activities] >= 0.0 start 1.0;
        /// price
        var p[c in goods] >= 1e-5 start 1.0;
        /// income
        var income[h in consumers] free start sum(goods, |c| endowment.base(h, c));

        /// index of the prices of a basket, `Σ_g α p^(1−σ)`
        def index[h in consumers]: sum(goods, |c|
            when(reference[h, c] > 0.0, || reference[h, c] * p[c].pow(1.0 - sigma[h])));
        def demand[h in consumers, c in goods]: when(reference[h, c] > 0.0, ||
            reference[h, c] * p[c].pow(-sigma[h]) * income[h] / index[h]);

        eq profit[s in activities]: 0.0 >= sum(goods, |c| output[s, c] * p[c])   complements y[s];
        eq market[c in goods]:
            sum(activities, |s| output[s, c] * y[s]) + sum(consumers, |h| endowment[h, c])
                >= sum(consumers, |h| demand[h, c])                              complements p[c];
        eq budget[h in consumers]:
            income[h] == sum(goods, |c| p[c] * endowment[h, c])                  complements income[h];

        /// income over the price index of the basket (σ other than 1)
        report real_income[h in consumers]: income[h] * index[h].pow(1.0 / (sigma[h] - 1.0));
    }
}

/// What the prices are measured in: the income of the first consumer.
pub(crate) const NUMERAIRE: &str = "income[agent1]";

impl Scarf {
    /// Reads the tables that come with the example.
    pub(crate) fn read() -> Result<Self, ModelError> {
        let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/data/scarf");
        let file = |name: &str| directory.join(name);
        let mut model = Scarf::builder()
            .goods(Labels::csv(file("goods.csv")))
            .consumers(Labels::csv(file("endowments.csv")))
            .activities(Labels::csv(file("activities.csv")))
            .output(Table::csv(file("activities.csv")))
            .reference(Table::csv(file("demands.csv")))
            .sigma(Table::csv(file("elasticities.csv")))
            .endowment(Table::csv(file("endowments.csv")))
            .build()?;
        let shape = model.shape();
        let worth = shape.start()[shape.variable_index(NUMERAIRE)?];
        model.fix(NUMERAIRE, worth)?;
        Ok(model)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut model = Scarf::read()?;
    for method in [Method::Robust].into_iter().chain(Method::CLASSICAL) {
        let stats = solve(&model, &Options::new(method))?.solved()?.stats;
        println!("{method:<14}{:>3} iterations", stats.iterations);
    }
    let solution = solve(&model, &Options::default())?.solved()?;
    let before = model.view(&solution)?;
    // Walras' law: the budget that is not imposed is kept.
    assert!(before.income.marginal("agent1")?.abs() < 1e-9);
    // Where an activity is used, it earns nothing; no other would earn anything.
    for (level, loss) in before.y.values().iter().zip(before.y.marginals()) {
        assert!(*loss > -1e-9 && (level * loss).abs() < 1e-9);
    }

    let more = before.endowment.iter();
    let more = more.map(|([_, good], owned)| if good == "skillab" { owned + 1.0 } else { owned });
    model.set_parameter("endowment", &more.collect::<Vec<_>>())?;
    model.start_from(&solution)?;
    let after = model.view(&solve(&model, &Options::default())?.solved()?)?;
    print_changes(&before, &after);
    assert!(price(&after, "skillab") < price(&before, "skillab"));
    Ok(())
}

/// Price in units of nondurable consumption.
fn price(view: &ScarfView, good: &str) -> f64 {
    view.p[good] / view.p["nondurbl"]
}

fn print_changes(before: &ScarfView, after: &ScarfView) {
    let change = |a: f64, b: f64| 100.0 * (b / a - 1.0);
    println!("\nwith 1 more of skilled labour for everybody");
    println!("{:<16}{:>9}{:>9}{:>12}{:>9}", "activity", "level", "then", "unit loss", "then");
    for (s, ([activity], level)) in before.y.iter().enumerate() {
        let [loss, then] = [before, after].map(|view| view.y.marginals()[s].abs());
        println!("{activity:<16}{level:>9.4}{:>9.4}{loss:>12.4}{then:>9.4}", after.y[&activity]);
    }
    println!("{:<16}{:>9}{:>9}{:>12}", "good", "price", "then", "change");
    for ([good], _) in before.p.iter() {
        let [a, b] = [before, after].map(|view| price(view, &good));
        println!("{good:<16}{a:>9.4}{b:>9.4}{:>10.2} %", change(a, b));
    }
    println!("real income");
    for ([consumer], a) in before.real_income.iter() {
        println!("{consumer:<34}{:>10.2} %", change(a, after.real_income[&consumer]));
    }
}
