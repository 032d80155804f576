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
//! The numbers come from `examples/data/transport`, or from the directory given:
//! `cargo run --example transport -- DIRECTORY`.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

mod data;
mod model;

use data::TransportData;
use mcp_core::{
    AdProblem, IterationTable, Method, Options, Report, Solution, Solver, Statement, solve_from,
};
use model::Transport;
use std::error::Error;
use std::fmt;
use std::io::stdout;
use std::path::PathBuf;

fn main() -> Result<(), Told> {
    let published = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/transport");
    let given = std::env::args().nth(1).map(PathBuf::from);
    let directory = given.clone().unwrap_or_else(|| published.into());
    let model = Transport::new(TransportData::read(&directory)?)?;

    let mut problem = AdProblem::new(&model)?;
    println!("{}", Statement::new(&mut problem).named("transport"));
    let mut solver = Solver::new(Options::default())?;
    let mut iterations = IterationTable::new(stdout());
    let solution = solver.solve_monitored(&mut problem, None, &mut iterations)?.clone();
    iterations.finish()?;
    println!("\n{}", Report::new(&mut problem, &solution)?.named("transport"));
    let solution = solution.solved()?;

    print_tables(&model, &solution.z);
    check_feasible(&model, &solution.z);
    if given.is_none() {
        check_published(&model, &solution.z);
    }

    println!("\nthe three methods from z = 0, which is hard for them (no shipments, no prices):");
    for method in Method::ALL {
        let cold = solve_from(&model, &vec![0.0; solution.z.len()], &Options::new(method))?;
        print_ending(&cold);
        if cold.is_solved() {
            assert!(relative(model.total_cost(&cold.z), model.total_cost(&solution.z)) < 1e-8);
        }
    }
    println!("\ntotal transport cost: {:.3} thousand dollars", model.total_cost(&solution.z));
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
fn check_published(model: &Transport, z: &[f64]) {
    assert!((model.total_cost(z) - 153.675).abs() < 1e-6);
    for (j, price) in [0.225, 0.153, 0.126].into_iter().enumerate() {
        assert!((z[model.p.at([j])] - price).abs() < 1e-9);
    }
    for i in model.plants() {
        assert!(z[model.w.at([i])] < 1e-9);
    }
}

/// Capacities are kept and demands are met, to a millionth.
fn check_feasible(model: &Transport, z: &[f64]) {
    for (i, capacity) in model.data.capacity.iter().enumerate() {
        let shipped: f64 = model.markets().map(|j| z[model.x.at([i, j])]).sum();
        assert!(shipped <= capacity + 1e-6 * capacity.max(1.0));
    }
    for (j, demand) in model.data.demand.iter().enumerate() {
        let received: f64 = model.plants().map(|i| z[model.x.at([i, j])]).sum();
        assert!(received >= demand - 1e-6 * demand.max(1.0));
    }
}

fn relative(a: f64, b: f64) -> f64 {
    (a - b).abs() / b.abs().max(1.0)
}

/// Shipments with the prices at their margins.
fn print_tables(model: &Transport, z: &[f64]) {
    print!("{:<16}", "shipments");
    model.data.markets.labels().for_each(|market| print!("{market:>10}"));
    println!("{:>10}{:>16}", "capacity", "capacity price");
    for (i, plant) in model.data.plants.labels().enumerate() {
        print!("{plant:<16}");
        model.markets().for_each(|j| print!("{:>10.1}", z[model.x.at([i, j])]));
        println!("{:>10.1}{:>16.3}", model.data.capacity[i], z[model.w.at([i])]);
    }
    print!("{:<16}", "demand");
    model.data.demand.iter().for_each(|demand| print!("{demand:>10.1}"));
    print!("\n{:<16}", "delivered price");
    model.markets().for_each(|j| print!("{:>10.3}", z[model.p.at([j])]));
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
