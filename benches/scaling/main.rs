//! Growth from a thousand to a million unknowns: `cargo bench --bench scaling`, or
//! `cargo bench --bench scaling -- 1023` for the cases whose name contains a word.
//!
//! Every case runs in a process of its own, so that its peak memory is its own. Printed are wall time,
//! processor time (the one to trust beside other work) and memory of the whole case, coarse levels and
//! derivatives included, the evaluations and factorisations of the last level, its fill (entries of the
//! factors by those of the matrix; multigrid has no factors), and the iterations of every level; then
//! how time per unknown grows. The picture is `target/scaling.svg`. `-- phases spring 300` prints the time
//! of each phase instead, `-- phases derivatives 1000` what `F + J` costs by the kind of row, `-- siconos`
//! what Siconos takes (`SICONOS_HARNESS`).

#![allow(clippy::print_stdout, reason = "a benchmark prints its results")]

mod cases;
mod chart;
mod doubled;
mod models;
mod phases;
mod roads;
mod siconos;

use cases::{CASES, Case, Kind, Way};
use std::error::Error;
use std::process::Command;

/// Where Siconos is run on the membrane.
const SIDES: [usize; 3] = [40, 150, 300];

/// A line as it comes from the process of its case.
#[derive(Clone, Debug)]
struct Line {
    case: Case,
    n: usize,
    seconds: f64,
    cpu: f64,
    megabytes: f64,
    text: String,
    is_solved: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words[..] {
        ["case", index] => one(&CASES[index.parse::<usize>()?]),
        ["phases", kind, k] => phases::print(kind, k.parse()?),
        ["siconos"] => siconos::print(&SIDES),
        [] => table(""),
        [word, ..] => table(word),
    }
}

/// In the process of a case.
fn one(case: &Case) -> Result<(), Box<dyn Error>> {
    let run = case.run()?;
    let solution = run.solutions.last().ok_or("no level")?;
    let stats = solution.stats;
    let levels: Vec<String> =
        run.solutions.iter().map(|level| level.stats.iterations.to_string()).collect();
    let is_solved = run.solutions.iter().all(mcp_core::Solution::is_solved);
    let end = if is_solved { "solved" } else { solution.status.name() };
    let ratio = |factors: usize| format!("{:.1}", factors as f64 / solution.fill.matrix as f64);
    let fill = solution.fill.factors.map_or("-".to_owned(), ratio);
    println!(
        "{}\t{}\t{}\t{}\t{:>5}{:>5}{:>6}{fill:>6}  {end:<8} {}",
        solution.z.len(),
        run.seconds,
        run.cpu,
        run.megabytes,
        stats.residual_evaluations,
        stats.jacobian_evaluations,
        stats.factorisations,
        levels.join(" "),
    );
    Ok(())
}

fn table(word: &str) -> Result<(), Box<dyn Error>> {
    println!(
        "{:<34}{:>8}{:>9}{:>9}{:>7}{:>7}{:>7}{:>5}{:>5}{:>6}{:>6}  end      iterations by level",
        "case", "n", "wall s", "CPU s", "reach", "MB", "reach", "F", "J", "fact.", "fill"
    );
    let mut lines = Vec::new();
    for (index, case) in CASES.iter().enumerate().filter(|(_, case)| case.name().contains(word)) {
        let line = child(index, case)?;
        let reach = |limit: Option<f64>| limit.map_or(String::new(), |limit| limit.to_string());
        println!(
            "{:<34}{:>8}{:>9.3}{:>9.3}{:>7}{:>7.0}{:>7}{}",
            case.name(),
            line.n,
            line.seconds,
            line.cpu,
            reach(case.reach.0),
            line.megabytes,
            reach(case.reach.1),
            line.text
        );
        lines.push(line);
    }
    print_growth(&lines);
    if "membrane cold".contains(word) {
        siconos::print(&SIDES)?;
    }
    chart::draw(&lines, "target/scaling.svg")?;
    let failed: Vec<String> =
        lines.iter().filter(|line| !line.is_solved).map(|line| line.case.name()).collect();
    if !failed.is_empty() {
        println!("not solved: {}", failed.join(", "));
    }
    Ok(())
}

/// Runs a case in a process of its own.
fn child(index: usize, case: &Case) -> Result<Line, Box<dyn Error>> {
    let output =
        Command::new(std::env::current_exe()?).args(["case", &index.to_string()]).output()?;
    let text = String::from_utf8(output.stdout)?;
    let fields: Vec<&str> = text.trim_end().split('\t').collect();
    let [n, seconds, cpu, megabytes, rest] = fields[..] else {
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(format!("{}: {error}", case.name()).into());
    };
    Ok(Line {
        case: *case,
        n: n.parse()?,
        seconds: seconds.parse()?,
        cpu: cpu.parse()?,
        megabytes: megabytes.parse()?,
        text: rest.to_owned(),
        is_solved: rest.contains("solved"),
    })
}

/// Time per unknown, relative to the smallest grid.
fn print_growth(lines: &[Line]) {
    for way in [Way::Multigrid, Way::Nested(mcp_core::Method::NewtonMinFb)] {
        let mut series: Vec<&Line> = lines
            .iter()
            .filter(|line| line.case.kind == Kind::Spring && line.case.way == way)
            .collect();
        series.sort_by_key(|line| line.n);
        let Some(first) = series.first() else { continue };
        println!("\nprocessor time per unknown, {way:?}:");
        for line in &series {
            let each = |line: &Line| line.cpu / line.n as f64 * 1e6;
            println!("{:>9}{:>9.2} µs{:>8.2}x", line.n, each(line), each(line) / each(first));
        }
    }
}
