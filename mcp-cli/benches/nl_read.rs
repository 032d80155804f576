//! How long a file of 10^5 rows takes from bytes to a problem that can be solved.
//!
//! `cargo bench -p mcp-cli --bench nl_read` prints seconds and rows per second for a chain with
//! `c_i + e^{z_i / 10} + z_i² − z_{i−1} − z_{i+1} ⟂ z_i >= 0`, read as text, as text with names, as
//! binary, and with one defined variable in each row.
#![allow(clippy::print_stdout, reason = "a benchmark prints its results")]

use mcp_cli::nl::{Names, NlModel};
use mcp_core::{AdProblem, Problem};
use std::error::Error;
use std::time::Instant;
use support::node::{many, n, op, power, v};
use support::{File, Form, INF, Kind, Row};

#[path = "../tests/support/mod.rs"]
mod support;

const ROWS: usize = 100_000;

fn main() -> Result<(), Box<dyn Error>> {
    let names = || Names {
        columns: Some((0..ROWS).map(|j| format!("z['node',{j}]")).collect()),
        rows: Some((0..ROWS).map(|j| format!("balance['node',{j}]")).collect()),
    };
    let (plain, defined) = (chain(false), chain(true));
    measure("text", &plain.write(Form::Text), Names::default)?;
    measure("text, names", &plain.write(Form::Text), names)?;
    measure("text, defined", &defined.write(Form::Text), Names::default)?;
    measure("binary", &plain.write(Form::LittleEndian), Names::default)?;
    Ok(())
}

/// The best of five.
fn measure(what: &str, bytes: &[u8], names: impl Fn() -> Names) -> Result<(), Box<dyn Error>> {
    let (mut read, mut prepared, mut evaluated) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
    for _ in 0..5 {
        let names = names();
        let clock = Instant::now();
        let model = NlModel::parse(bytes, names)?;
        let seconds = clock.elapsed().as_secs_f64();
        read = read.min(seconds);
        let mut problem = AdProblem::new(&model)?;
        prepared = prepared.min(clock.elapsed().as_secs_f64());
        let z = vec![1.0; model.variables()];
        let (mut f, mut jac) = (vec![0.0; z.len()], vec![0.0; problem.pattern().nnz()]);
        let clock = Instant::now();
        problem.evaluate(&z, Some(&mut f), Some(&mut jac));
        evaluated = evaluated.min(clock.elapsed().as_secs_f64());
    }
    println!(
        "{what:<14} {:>5.1} MB  read {read:.3} s  read and prepared {prepared:.3} s, {:.0} rows/s  \
         F and J {evaluated:.3} s",
        bytes.len() as f64 / 1e6,
        ROWS as f64 / prepared
    );
    Ok(())
}

/// The chain; the exponential may be a defined variable.
fn chain(defined: bool) -> File {
    let mut file = File { variables: vec![(0.0, INF, 0.0); ROWS], ..File::default() };
    for i in 0..ROWS {
        let mut exponential = op(44, [op(3, [v(i), n(10.0)])]);
        if defined {
            file.definitions.push((Vec::new(), exponential));
            exponential = v(ROWS + i);
        }
        let constant = n(i as f64 / ROWS as f64 - 2.5);
        let body = many(54, [constant, exponential, power(v(i), 2.0)]);
        let neighbours = [i.checked_sub(1), Some(i + 1).filter(|&i| i < ROWS)];
        let linear = neighbours.into_iter().flatten().map(|j| (j, -1.0)).collect();
        file.rows.push(Row(Kind::Complements(1, i), linear, body));
    }
    file
}
