//! # What accuracy costs in time
//!
//! Every case is solved again and again with one thing changed: tolerance, method, source of
//! derivatives, arithmetic of `F`, scaling, tail, start. Errors are true errors, against solutions
//! known to more than 22 digits ([`mcp_core::accuracy`]), not residuals; costs are counts, which depend
//! on no clock, and seconds.
//!
//! `cargo run --release --example accuracy [MODEL]` prints a table for each case, or for those whose
//! name contains `MODEL`, and writes `accuracy.csv` and figures to `target/accuracy/`: `cost.svg` (and
//! `seconds.svg`, the same over time), `derivatives.svg`, `digits.svg`, `profiles.svg`; the second and
//! the fourth only without `MODEL`. `docs/accuracy.md` says what to read off them. `--counts` writes the counts that `tests/accuracy_counts.rs` compares, and nothing else.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

#[path = "accuracy/cases.rs"]
mod cases;

use mcp_core::Method;
use mcp_core::accuracy::figures::{self, Measure};
use mcp_core::accuracy::{
    Budget, Case, DerivativeRun, Run, Setting, TOLERANCES, csv, derivatives, evaluations, problems,
    table,
};
use mcp_core::testing::collection;
use std::error::Error;
use std::fs;
use std::path::Path;
use std::time::Duration;

/// Nodes of a side of the obstacle problem.
const NODES: usize = 100;
/// Cases with more variables are solved at few tolerances, timed once, and not with Lemke's method,
/// which would exchange thousands of them one by one.
const LARGE: usize = 1000;

fn main() -> Result<(), Box<dyn Error>> {
    let wanted = std::env::args().nth(1).unwrap_or_default();
    if wanted == "--counts" {
        fs::write(cases::counts_file(), cases::counts()?)?;
        return Ok(());
    }
    let all = cases::all(NODES)?;
    let chosen: Vec<&Case> = all.iter().filter(|case| case.name.contains(&wanted)).collect();
    if chosen.is_empty() {
        let names: Vec<&str> = all.iter().map(|case| case.name.as_str()).collect();
        return Err(format!("no case is called `{wanted}`; there are {}", names.join(", ")).into());
    }
    let target = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/accuracy");
    fs::create_dir_all(&target)?;

    let mut results = Vec::new();
    for case in chosen {
        let reference = &case.references[0];
        println!("{}: n = {}, reference {}", case.name, case.n(), reference.origin);
        let runs = study(case)?;
        println!("{}", table(&runs));
        results.push((case, runs));
    }
    let by_case = results.iter().map(|(case, runs)| (case.name.as_str(), case.n(), &runs[..]));
    fs::write(target.join("accuracy.csv"), csv(by_case))?;
    let runs: Vec<(&Case, &[Run])> =
        results.iter().map(|(case, runs)| (*case, &runs[..])).collect();
    fs::write(target.join("cost.svg"), figures::cost(&runs, Measure::Operations)?)?;
    fs::write(target.join("seconds.svg"), figures::cost(&runs, Measure::Seconds)?)?;
    fs::write(target.join("digits.svg"), figures::digits(&runs)?)?;
    if wanted.is_empty() {
        draw_derivatives(&target.join("derivatives.svg"))?;
        draw_profiles(&target.join("profiles.svg"))?;
    }
    println!("figures and accuracy.csv: target/accuracy");
    Ok(())
}

/// All runs of a case.
fn study(case: &Case) -> Result<Vec<Run>, Box<dyn Error>> {
    let (settings, budget) = if case.n() > LARGE {
        let mut settings = Setting::all(case, &[1e-4, 1e-8, 1e-12]);
        let default = Setting::default();
        let is_another_method = |s: &Setting| *s == Setting { method: s.method, ..default };
        let at_default = |s: &Setting| Setting { tolerance: default.tolerance, ..*s };
        settings.retain(|s| {
            s.method != Method::Lemke
                && (s.tolerance == default.tolerance || is_another_method(&at_default(s)))
        });
        (settings, Budget { runs: 1, time: Duration::ZERO })
    } else {
        (Setting::all(case, &TOLERANCES), Budget { runs: 15, time: Duration::from_millis(3) })
    };
    let run = |setting| Run::new(case, setting, Some(budget));
    Ok(settings.into_iter().map(run).collect::<Result<_, _>>()?)
}

/// Jacobians of dense economies and of chains with three diagonals, of several sizes.
fn draw_derivatives(path: &Path) -> Result<(), Box<dyn Error>> {
    let budget = Budget { runs: 30, time: Duration::from_millis(20) };
    let of = |make: fn(usize) -> Result<Case, mcp_core::accuracy::AccuracyError>,
              sizes: &[usize]| {
        let mut runs: Vec<DerivativeRun> = Vec::new();
        for &n in sizes {
            runs.extend(derivatives(&make(n)?, budget)?);
        }
        Ok::<_, Box<dyn Error>>(runs)
    };
    let walras = of(problems::walras, &[5, 10, 20, 50, 100])?;
    let chain = of(problems::chain, &[10, 100, 1000])?;
    println!("one Jacobian at the solution, in evaluations of F");
    println!("{:<14}{:>6}  {:<20}{:>10}{:>10}", "case", "n", "source", "J / F", "error");
    for run in walras.iter().chain(&chain) {
        let ratio = run.jacobian.median / run.residual.median;
        println!(
            "{:<14}{:>6}  {:<20}{ratio:>10.1}{:>10.0e}",
            run.case, run.n, run.source, run.error
        );
    }
    println!();
    let families = [
        ("exchange economy, dense", &walras[..]),
        ("chain of springs, three diagonals", &chain[..]),
    ];
    fs::write(path, figures::derivatives(&families)?)?;
    Ok(())
}

/// Every method on the collection.
fn draw_profiles(path: &Path) -> Result<(), Box<dyn Error>> {
    let mut instances = collection::all()?;
    instances.retain(|instance| instance.solvable);
    let mut costs = Vec::new();
    for method in Method::ALL {
        costs.push((method, evaluations(method, &instances)?));
    }
    fs::write(path, figures::profiles(&costs)?)?;
    Ok(())
}
