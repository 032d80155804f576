//! # Who ships how much where, and at what prices
//!
//! Canning plants `i` with capacities `a_i` [cases] serve markets `j` with demands `b_j` [cases].
//! Shipping costs `c_ij = 90 d_ij / 1000` [thousand dollars per case], with `d_ij` in thousand
//! miles. Prices are variables like shipments, and every equation says who gives way:
//!
//! ```text
//! w_i + c_ij − p_j    >= 0   ⟂   x_ij >= 0   no shipment at a loss, none at a profit
//! a_i − Σ_j x_ij      >= 0   ⟂   w_i  >= 0   capacity has a price only where it is used up
//! Σ_i x_ij − b_j      >= 0   ⟂   p_j  >= 0   demand is met, exactly where the price is positive
//! ```
//!
//! These are the optimality conditions of the linear program that ships at least cost, and `w`, `p`
//! its shadow prices.
//!
//! Source: Dantzig, *Linear Programming and Extensions*, Princeton 1963, chapter 3.3; the data are
//! those of GAMS model library `trnsport` and `transmcp`. Expected: cost 153.675 thousand dollars;
//! prices 0.225, 0.153, 0.126; capacity prices 0. **Shipments are not unique**: New York is as far
//! from Seattle as from San Diego, so only cost and prices are asserted.
//!
//! The numbers come from three CSV files in `examples/data/transport`, or in the directory given:
//! `cargo run --example transport -- DIRECTORY`.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::language::{Labels, Table};
use mcp_core::{
    AdProblem, IterationTable, Method, Model, ModelError, Options, Report, Solution, Solver,
    Statement, mcp, solve_from,
};
use std::error::Error;
use std::fmt;
use std::io::stdout;
use std::path::{Path, PathBuf};

mcp! {
    /// Plants ship to markets at least cost, with prices.
    pub(crate) model Transport {
        data { plants: Set, markets: Set }
        /// capacity of a plant [cases]
        param capacity[i in plants];
        /// demand of a market [cases]
        param demand[j in markets];
        /// distance [thousand miles]
        param distance[i in plants, j in markets];
        /// freight [dollars per case and thousand miles]
        param freight = 90.0;

        /// shipment [cases]
        var x[i in plants, j in markets] >= 0.0 start 100.0;
        /// capacity price [thousand dollars per case]
        var w[i in plants] >= 0.0;
        /// delivered price [thousand dollars per case]
        var p[j in markets] >= 0.0 start 0.2;

        /// transport cost [thousand dollars per case]
        def cost[i in plants, j in markets]: freight * distance[i, j] / 1000.0;

        eq profit[i in plants, j in markets]: w[i] + cost[i, j] >= p[j]      complements x[i, j];
        eq supply[i in plants]: capacity[i] >= sum(markets, |j| x[i, j])     complements w[i];
        eq market[j in markets]: sum(plants, |i| x[i, j]) >= demand[j]       complements p[j];

        /// total transport cost [thousand dollars]
        report total_cost: sum(plants, |i| sum(markets, |j| cost[i, j] * x[i, j]));
    }
}

impl Transport {
    /// Reads `plants.csv`, `markets.csv` and `distances.csv` of a directory.
    pub(crate) fn read(directory: &Path) -> Result<Self, TransportError> {
        let [plants, markets, distances] =
            ["plants.csv", "markets.csv", "distances.csv"].map(|file| directory.join(file));
        let model = Transport::builder()
            .plants(Labels::csv(&plants))
            .capacity(Table::csv(&plants))
            .markets(Labels::csv(&markets))
            .demand(Table::csv(&markets))
            .distance(Table::csv(&distances))
            .build()?;
        model.check_amounts()?;
        Ok(model)
    }

    /// No capacity, demand or distance is negative. That they are finite numbers, and that none is
    /// missing, `build` has seen to.
    fn check_amounts(&self) -> Result<(), TransportError> {
        let shape = self.shape();
        for family in shape.parameters() {
            let values = &shape.parameter_values()[family.offset()..][..family.len()];
            if let Some(k) = values.iter().position(|value| *value < 0.0) {
                let (amount, found) = (family.element_name(k), values[k]);
                return Err(TransportError::Negative { amount, found });
            }
        }
        Ok(())
    }
}

/// What is wrong with the files.
#[derive(Debug, thiserror::Error)]
pub(crate) enum TransportError {
    /// The language could not use them.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A capacity, a demand or a distance is negative.
    #[error("`{amount}` is {found}: give a number that is not negative")]
    Negative { amount: String, found: f64 },
}

fn main() -> Result<(), Told> {
    let published = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/transport");
    let given = std::env::args().nth(1).map(PathBuf::from);
    let model = Transport::read(given.as_deref().unwrap_or(published.as_ref()))?;

    let mut problem = AdProblem::new(&model)?;
    println!("{}", Statement::new(&mut problem).named("transport"));
    let mut solver = Solver::new(Options::default())?;
    let mut iterations = IterationTable::new(stdout());
    let solution = solver.solve_monitored(&mut problem, None, &mut iterations)?.clone();
    iterations.finish()?;
    println!("\n{}", Report::new(&mut problem, &solution)?.named("transport"));

    let view = model.view(&solution.solved()?)?;
    print_tables(&view);
    check_feasible(&view);
    if given.is_none() {
        check_published(&view);
    }

    println!("\nthe three methods from z = 0, which is hard for them (no shipments, no prices):");
    let zero = vec![0.0; model.shape().n()];
    for method in Method::CLASSICAL {
        let cold = solve_from(&model, &zero, &Options::new(method))?;
        print_ending(&cold);
        if cold.is_solved() {
            assert!(relative(model.view(&cold)?.total_cost, view.total_cost) < 1e-8);
        }
    }
    println!("\ntotal transport cost: {:.3} thousand dollars", view.total_cost);
    Ok(())
}

/// An error that `main` tells in its own words.
struct Told(Box<dyn Error>);

impl<E: Error + 'static> From<E> for Told {
    fn from(error: E) -> Self {
        Told(Box::new(error))
    }
}

impl fmt::Debug for Told {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

/// Cost, prices and capacity prices as published.
fn check_published(view: &TransportView) {
    assert!((view.total_cost - 153.675).abs() < 1e-6);
    for (market, price) in [("new-york", 0.225), ("chicago", 0.153), ("topeka", 0.126)] {
        assert!((view.p[market] - price).abs() < 1e-9);
    }
    for price in view.w.values() {
        assert!(*price < 1e-9);
    }
}

/// Capacities are kept and demands are met, to a millionth.
fn check_feasible(view: &TransportView) {
    for ([plant], capacity) in view.capacity.iter() {
        let shipped: f64 = view.x.iter().filter(|([i, _], _)| *i == plant).map(|(_, x)| x).sum();
        assert!(shipped <= capacity + 1e-6 * capacity.max(1.0));
    }
    for ([market], demand) in view.demand.iter() {
        let received: f64 = view.x.iter().filter(|([_, j], _)| *j == market).map(|(_, x)| x).sum();
        assert!(received >= demand - 1e-6 * demand.max(1.0));
    }
}

fn relative(a: f64, b: f64) -> f64 {
    (a - b).abs() / b.abs().max(1.0)
}

/// Shipments with the prices at their margins.
fn print_tables(view: &TransportView) {
    print!("{:<16}", "shipments");
    view.demand.iter().for_each(|([market], _)| print!("{market:>10}"));
    println!("{:>10}{:>16}", "capacity", "capacity price");
    for ([plant], capacity) in view.capacity.iter() {
        print!("{plant:<16}");
        for ([market], _) in view.demand.iter() {
            print!("{:>10.1}", view.x[[&plant, &market]]);
        }
        println!("{capacity:>10.1}{:>16.3}", view.w[[&plant]]);
    }
    print!("{:<16}", "demand");
    view.demand.values().iter().for_each(|demand| print!("{demand:>10.1}"));
    print!("\n{:<16}", "delivered price");
    view.p.values().iter().for_each(|price| print!("{price:>10.3}"));
    println!("    thousand dollars per case");
}

fn print_ending(solution: &Solution) {
    println!(
        "  {:<14}{:>5} iterations, residual {:>7.1e}: {}",
        solution.method,
        solution.stats.iterations,
        solution.certificate.natural_residual,
        solution.status.name(),
    );
}
