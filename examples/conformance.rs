//! # Every method on every problem of the collection
//!
//! 237 problems, 231 of them solvable, by every method: what is solved, what is claimed falsely,
//! and at what cost. The judge is code apart from the solvers and their certificate
//! ([`mcp_core::testing::judge`]): a solve counts if the method says `Solved`, a solution exists,
//! and the judge accepts the point; `Solved` in any other case is a false claim.
//!
//! Costs are counts, not times. The classical methods get 300 iterations, as in the study the
//! collection comes from; other methods their own defaults. Writes `target/conformance.csv`, one
//! line for each run, and `target/conformance.svg`, a performance profile of the evaluations of
//! `F`: the share of problems a method solves within `τ` times the evaluations of the best method
//! on each ([DM02], see the references of `mcp_core`).
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::accuracy::performance_profile;
use mcp_core::testing::collection::{self, Instance, families};
use mcp_core::testing::judge;
use mcp_core::{Method, ModelError, Options, Solver};
use plotters::prelude::*;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// One method on one problem.
struct Run {
    family: &'static str,
    name: String,
    n: usize,
    solvable: bool,
    /// The method says that it is a solution.
    claimed: bool,
    /// The judge says so.
    accepted: bool,
    status: &'static str,
    iterations: usize,
    f: usize,
    j: usize,
    absolute: f64,
    relative: f64,
}

impl Run {
    fn new(method: Method, instance: &Instance) -> Result<Self, ModelError> {
        let mut solver = Solver::new(budget(method))?;
        let solution = solver.solve(&mut *instance.problem()?)?;
        let judgement = judge(instance, &solution.z)?;
        Ok(Run {
            family: instance.family,
            name: instance.name.clone(),
            n: instance.n(),
            solvable: instance.solvable,
            claimed: solution.is_solved(),
            accepted: judgement.accepts(),
            status: solution.status.name(),
            iterations: solution.stats.iterations,
            f: solution.stats.residual_evaluations,
            j: solution.stats.jacobian_evaluations,
            absolute: judgement.absolute,
            relative: judgement.relative,
        })
    }

    fn solved(&self) -> bool {
        self.claimed && self.accepted && self.solvable
    }

    fn false_claim(&self) -> bool {
        self.claimed && !self.solved()
    }
}

fn is_classical(method: Method) -> bool {
    matches!(method, Method::NewtonFb | Method::NewtonMinFb | Method::OldFb)
}

/// Limits are counts.
fn budget(method: Method) -> Options {
    Options::new(method).with(|o| {
        if is_classical(method) {
            o.max_iterations = 300;
        }
    })
}

/// All runs of one method, in the order of the collection.
struct Results {
    method: Method,
    runs: Vec<Run>,
}

impl Results {
    fn solved(&self, family: Option<&str>) -> usize {
        let runs = self.runs.iter().filter(|run| family.is_none_or(|family| run.family == family));
        runs.filter(|run| run.solved()).count()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let instances = collection::all()?;
    let mut all = Vec::new();
    for method in Method::ALL {
        let runs = instances.iter().map(|instance| Run::new(method, instance));
        all.push(Results { method, runs: runs.collect::<Result<_, _>>()? });
    }

    let target = Path::new(env!("CARGO_MANIFEST_DIR")).join("target");
    fs::create_dir_all(&target)?;
    fs::write(target.join("conformance.csv"), csv(&all)?)?;
    draw_profile(&target.join("conformance.svg"), &all)?;

    print_families(&all);
    print_costs("on all it solves", &all, |_| true);
    let classical = || all.iter().filter(|results| is_classical(results.method));
    let common: Vec<bool> =
        (0..instances.len()).map(|p| classical().all(|r| r.runs[p].solved())).collect();
    let number = common.iter().filter(|&&common| common).count();
    print_costs(&format!("on {number} all classical ones solve"), &all, |p| common[p]);
    print_unclaimed(&all);
    print_false_claims(&all);
    let solvable = instances.iter().filter(|instance| instance.solvable).count();
    println!();
    for results in &all {
        let claims = results.runs.iter().filter(|run| run.false_claim()).count();
        let (method, solved) = (results.method, results.solved(None));
        println!("{method:?}: solved {solved} of {solvable}, false claims {claims}");
    }
    Ok(())
}

fn print_header(first: &str, all: &[Results]) {
    print!("{first:<34}");
    for results in all {
        print!("{:>15}", results.method.name());
    }
    println!();
}

fn print_families(all: &[Results]) {
    print_header("solved of the solvable", all);
    for family in families() {
        let members = || all[0].runs.iter().filter(|run| run.family == family);
        let solvable = members().filter(|run| run.solvable).count();
        print!("{:<34}", format!("{family} ({} problems)", members().count()));
        for results in all {
            print!("{:>15}", format!("{}/{solvable}", results.solved(Some(family))));
        }
        println!();
    }
}

/// The smallest number that at least `percent` of the sorted numbers do not exceed.
fn quantile(sorted: &[usize], percent: usize) -> usize {
    let rank = (percent * sorted.len()).div_ceil(100);
    sorted.get(rank.saturating_sub(1)).copied().unwrap_or(0)
}

/// Evaluations of `F` and of `J` on the solved problems among those that `counts` lets pass.
fn print_costs(title: &str, all: &[Results], counts: impl Fn(usize) -> bool) {
    let sorted = |results: &Results, cost: fn(&Run) -> usize| {
        let solved = results.runs.iter().enumerate().filter(|(p, run)| counts(*p) && run.solved());
        let mut costs: Vec<usize> = solved.map(|(_, run)| cost(run)).collect();
        costs.sort_unstable();
        costs
    };
    let costs: Vec<[Vec<usize>; 2]> = all
        .iter()
        .map(|results| [sorted(results, |run| run.f), sorted(results, |run| run.j)])
        .collect();
    let print_line = |name: &str, statistic: &dyn Fn(&[usize]) -> usize| {
        print!("{name:<34}");
        for [f, j] in &costs {
            print!("{:>15}", format!("{} / {}", statistic(f), statistic(j)));
        }
        println!();
    };
    println!();
    print_header(title, all);
    print_line("median of F / J", &|costs| quantile(costs, 50));
    print_line("90th percentile of F / J", &|costs| quantile(costs, 90));
    print_line("total of F / J", &|costs| costs.iter().sum());
}

/// Points the judge accepts although the method does not call them solved.
fn print_unclaimed(all: &[Results]) {
    println!();
    for Results { method, runs } in all {
        let missed = runs.iter().filter(|run| run.solvable && run.accepted && !run.claimed);
        let names: Vec<String> =
            missed.map(|run| format!("{} ({})", run.name, run.status)).collect();
        println!("{method}, accepted by the judge but not claimed: {}", names.join(", "));
    }
}

fn print_false_claims(all: &[Results]) {
    for Results { method, runs } in all {
        for run in runs.iter().filter(|run| run.false_claim()) {
            println!("{method}, false claim: {} (residual {:.0e})", run.name, run.absolute);
        }
    }
}

fn csv(all: &[Results]) -> Result<String, std::fmt::Error> {
    let mut text = String::from(
        "method,family,problem,n,solvable,status,claimed,accepted,iterations,F,J,absolute,relative\n",
    );
    for Results { method, runs } in all {
        for run in runs {
            let Run { family, name, n, status, iterations, f, j, absolute, relative, .. } = run;
            let [solvable, claimed, accepted] =
                [run.solvable, run.claimed, run.accepted].map(u8::from);
            writeln!(
                text,
                "{method},{family},{name},{n},{solvable},{status},{claimed},{accepted},\
                 {iterations},{f},{j},{absolute:e},{relative:e}"
            )?;
        }
    }
    Ok(text)
}

/// A method's evaluations of `F` on every solvable problem that it solves.
fn evaluations(results: &Results) -> Vec<Option<f64>> {
    let solvable = results.runs.iter().filter(|run| run.solvable);
    solvable.map(|run| run.solved().then(|| run.f.max(1) as f64)).collect()
}

/// The profile shows costs up to `2⁶` times that of the best method.
const WIDEST: f64 = 6.0;

/// `ρ(τ)`: the share of the solvable problems that a method solves within `τ` times the cost of
/// the best.
fn draw_profile(path: &Path, all: &[Results]) -> Result<(), Box<dyn Error>> {
    let profiles = performance_profile(&all.iter().map(evaluations).collect::<Vec<_>>());
    let area = SVGBackend::new(path, (900, 560)).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .caption("Performance profile: evaluations of F", ("sans-serif", 20))
        .margin(16)
        .x_label_area_size(44)
        .y_label_area_size(52)
        .build_cartesian_2d(0.0..WIDEST, 0.0..1.0)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc("evaluations relative to the best method, log2")
        .y_desc("share of solvable problems solved")
        .draw()?;
    for (k, (results, profile)) in all.iter().zip(profiles).enumerate() {
        let (mut steps, mut share) = (vec![(0.0, 0.0)], 0.0);
        for (ratio, next) in profile.into_iter().filter(|step| step.0 <= WIDEST) {
            steps.extend([(ratio, share), (ratio, next)]);
            share = next;
        }
        steps.push((WIDEST, share));
        let style = Palette99::pick(k).stroke_width(2);
        chart
            .draw_series(LineSeries::new(steps, style))?
            .label(results.method.name())
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 24, y)], style));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerRight)
        .background_style(WHITE)
        .border_style(BLACK)
        .draw()?;
    area.present()?;
    Ok(())
}
