//! # Which power plants pay for themselves
//!
//! Technology `i` costs `f_i` [$/kW a] in capital, whether it runs or not, and `c_i` [$/MWh] when
//! it runs. A year has segments `s` of `τ_s` hours at the load `d_s` [GW]; not to be served costs a
//! consumer the value of lost load `V` [$/MWh]. Nobody plans: plants run where the price `p_s` pays
//! their variable cost, and are built where the rents `r_is` of a year pay their capital:
//!
//! ```text
//! c_i + r_is − p_s         >= 0   ⟂   q_is >= 0           no gain by running
//! k_i − q_is               >= 0   ⟂   r_is >= 0           a rent only at full capacity
//! f_i − Σ_s τ_s r_is       >= 0   ⟂   k_i  >= 0           no gain by building (all in $/kW a)
//! V − p_s                         ⟂   0 <= u_s <= d_s     nobody pays more than V
//! Σ_i q_is + u_s − d_s     >= 0   ⟂   p_s  >= 0           the market clears
//! ```
//!
//! Source: M. Boiteux, *Peak-load pricing*, Journal of Business 33 (1960) 157–179; screening curves
//! as in S. Stoft, *Power System Economics*, IEEE Press 2002, part 2. The data, in
//! `examples/data/electricity`, are invented.
//!
//! In closed form: a slice of load that lasts `H` hours of the year is served at the least cost
//!
//! ```text
//! C(H) = min(V H, min_i (f_i + c_i H)),
//! ```
//!
//! which says who is built for it, or that it is shed. With `H_s` the hours of at least the load
//! `d_s`, the price is the slope of that screening curve, `p_s = (C(H_s) − C(H_(s−1))) / τ_s`.
//! Expected: the needle of 5 hours is shed, as `5 V` is less than a peaker's capital; every plant
//! earns exactly its cost. With prices capped at 300 $/MWh nobody builds for 250 hours of the year.
//! `tests/gallery/electricity.rs` computes the curve and checks the duality of least cost and
//! prices.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::language::{Labels, Table};
use mcp_core::{ModelError, Options, mcp, solve};
use std::error::Error;
use std::path::Path;

mcp! {
    /// Power plants are built and run at market prices.
    pub(crate) model Electricity {
        data {
            technologies: Set, segments: Set,
            costs: Set[fixed, variable], durations: Set[hours, load],
            /// capital [$/kW a] and variable cost [$/MWh]
            cost[technologies, costs]: f64,
            /// hours of a year [h/a] and load [GW]
            year[segments, durations]: f64,
        }
        /// value of lost load, or a cap on prices [$/MWh]
        param voll = 5000.0;

        /// power produced [GW]
        var q[i in technologies, s in segments] >= 0.0 start 20.0;
        /// rent of capacity [$/MWh]
        var r[i in technologies, s in segments] >= 0.0 start 100.0;
        /// capacity [GW]
        var k[i in technologies] >= 0.0;
        /// load not served [GW]
        var u[s in segments] in 0.0..=year[s, load];
        /// price [$/MWh]
        var p[s in segments] >= 0.0 start 100.0;

        eq run[i in technologies, s in segments]:
            cost[i, variable] + r[i, s] >= p[s]                              complements q[i, s];
        eq limit[i in technologies, s in segments]: k[i] >= q[i, s]          complements r[i, s];
        eq invest[i in technologies]:
            cost[i, fixed] >= sum(segments, |s| year[s, hours] * r[i, s]) / 1000.0
            complements k[i];
        eq scarcity[s in segments]: voll - p[s]                              complements u[s];
        eq market[s in segments]:
            sum(technologies, |i| q[i, s]) + u[s] >= year[s, load]           complements p[s];

        /// revenue less all costs [M$/a]
        report profit[i in technologies]:
            sum(segments, |s| year[s, hours] * (p[s] - cost[i, variable]) * q[i, s]) / 1000.0
                - cost[i, fixed] * k[i];
        /// what consumers pay [M$/a]
        report bill: sum(segments, |s| year[s, hours] * p[s] * (year[s, load] - u[s])) / 1000.0;
        /// energy not served [GWh/a]
        report unserved: sum(segments, |s| year[s, hours] * u[s]);
    }
}

/// The invented data.
pub(crate) const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/electricity");

impl Electricity {
    /// Reads `technologies.csv` and `segments.csv` of a directory.
    pub(crate) fn read(directory: &Path) -> Result<Self, ModelError> {
        let [technologies, segments] =
            ["technologies.csv", "segments.csv"].map(|file| directory.join(file));
        Electricity::builder()
            .technologies(Labels::csv(&technologies))
            .cost(Table::csv(&technologies))
            .segments(Labels::csv(&segments))
            .year(Table::csv(&segments))
            .build()
    }
}

/// What the screening curve says of each segment: price [$/MWh] and load not served [GW].
pub(crate) type Segments = [(&'static str, f64, f64); 7];

pub(crate) const SCARCITY: Segments = [
    ("needle", 5000.0, 4.0),
    ("peak", 788.889, 0.0),
    ("high", 110.0, 0.0),
    ("day", 110.0, 0.0),
    ("shoulder", 72.0, 0.0),
    ("night", 51.474, 0.0),
    ("base", 26.36, 0.0),
];

pub(crate) const CAPPED: Segments = [
    ("needle", 300.0, 20.0),
    ("peak", 300.0, 16.0),
    ("high", 300.0, 8.0),
    ("day", 117.5, 0.0),
    ("shoulder", 72.0, 0.0),
    ("night", 51.474, 0.0),
    ("base", 26.36, 0.0),
];

/// Capacity [GW] without and with the cap.
pub(crate) const CAPACITY: [(&str, [f64; 2]); 4] = [
    ("nuclear", [35.0, 35.0]),
    ("coal", [7.0, 7.0]),
    ("combined", [8.0, 8.0]),
    ("peaker", [26.0, 10.0]),
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut model = Electricity::read(DATA.as_ref())?;
    let scarcity = solve(&model, &Options::default())?.solved()?;
    let view = model.view(&scarcity)?;
    println!("prices up to the value of lost load, {} $/MWh", view.voll);
    print_year(&view);
    check(&view, &SCARCITY, 0);

    model.set_parameter("voll", &[300.0])?;
    model.start_from(&scarcity)?;
    let capped = solve(&model, &Options::default())?.solved()?;
    let view = model.view(&capped)?;
    println!("\nprices capped at {} $/MWh", view.voll);
    print_year(&view);
    check(&view, &CAPPED, 1);
    Ok(())
}

fn check(view: &ElectricityView, segments: &Segments, case: usize) {
    for (segment, price, shed) in segments {
        assert!((view.p[*segment] - price).abs() < 1e-3, "{segment}: {}", view.p[*segment]);
        assert!((view.u[*segment] - shed).abs() < 1e-6, "{segment}: {}", view.u[*segment]);
    }
    for (technology, capacity) in CAPACITY {
        assert!((view.k[technology] - capacity[case]).abs() < 1e-6, "{technology}");
        assert!(view.profit[technology].abs() < 1e-6, "{technology} earns its cost");
    }
}

/// Production, load not served [GW] and price of every segment; below, what was built.
fn print_year(view: &ElectricityView) {
    print!("{:<10}{:>7}{:>7}", "", "hours", "load");
    view.k.iter().for_each(|([technology], _)| print!("{technology:>10}"));
    println!("{:>8}{:>10}", "shed", "$/MWh");
    for ([segment], price) in view.p.iter() {
        let [hours, load] = ["hours", "load"].map(|column| view.year[(&segment, column)]);
        print!("{segment:<10}{hours:>7}{load:>7}");
        view.k.iter().for_each(|([i], _)| print!("{:>10.1}", view.q[(&i, &segment)]));
        println!("{:>8.1}{price:>10.2}", view.u[&segment]);
    }
    print!("{:<24}", "capacity [GW]");
    view.k.iter().for_each(|(_, capacity)| print!("{capacity:>10.1}"));
    println!("\nconsumers pay {:.0} M$/a; {:.0} GWh/a are not served", view.bill, view.unserved);
}
