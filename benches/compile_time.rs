//! What a model written with `mcp!` costs the compiler: `cargo bench --bench compile_time`.
//!
//! Two libraries in a workspace of their own under `target/` share everything but their text: one
//! has a model of 12 equation families and solves it, the other is empty. Printed is the time that
//! the first takes beyond the second. On Linux it is CPU time of all processes, user and system, to
//! 10 ms; elsewhere wall time of a build with one job. The budget is stated in `BUDGET`.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

/// Builds of each kind; their median counts.
const REPETITIONS: usize = 7;

/// Seconds beyond the empty crate, for each way to build.
const BUDGET: [(&[&str], Option<f64>); 3] =
    [(&["check"], None), (&["build"], Some(0.5)), (&["build", "--release"], Some(1.0))];

/// Hourly power markets with a network, storage, investment and trade in permits.
const MODEL: &str = r"
use mcp_core::{ModelError, Options, Solution, mcp, solve};

mcp! {
    /// Power markets with storage, investment and permits.
    pub model Markets {
        data {
            nodes: Set, hours: Ordered, gens: Set, stores: Set, thermal: Subset(gens),
            lines: Pairs(nodes, nodes), site: Map(gens, nodes), place: Map(stores, nodes),
            load[nodes, hours]: f64, elasticity[nodes]: f64, price0[nodes]: f64,
            cap[gens]: f64, avail[gens, hours]: f64, fuel[gens]: f64, slope[gens]: f64, rate[gens]: f64,
            build_cost[gens]: f64, fmax[lines]: f64, smax[stores]: f64, pw[stores]: f64,
            eta: f64, voll: f64, permits: f64,
        }
        param tax[g in gens] = 0.0;
        /// Generation [MW]
        var q[g in gens, t in hours] >= 0.0;
        var rent[g in gens, t in hours] >= 0.0;
        var new[g in gens] >= 0.0;
        var f[l in lines, t in hours] in -fmax[l]..=fmax[l];
        var shed[n in nodes, t in hours] in 0.0..=load[n, t];
        var d[n in nodes, t in hours] >= 1e-6 start load[n, t];
        var p[n in nodes, t in hours] >= 0.0 start price0[n];
        var ch[k in stores, t in hours] in 0.0..=pw[k];
        var dis[k in stores, t in hours] in 0.0..=pw[k];
        var s[k in stores, t in hours] in 0.0..=smax[k];
        var v[k in stores, t in hours] free;
        var co2 >= 0.0;
        def mc[g in gens, t in hours]: fuel[g] * (1.0 + tax[g]) + slope[g] * q[g, t] + rate[g] * co2;
        def net[n in nodes, t in hours]: sum(lines.into(n), |l| f[l, t]) - sum(lines.out_of(n), |l| f[l, t]);
        eq run[g in gens, t in hours]: mc[g, t] + rent[g, t] - p[site[g], t]       complements q[g, t];
        eq limit[g in gens, t in hours]: (cap[g] + new[g]) * avail[g, t] - q[g, t] complements rent[g, t];
        eq invest[g in gens]: build_cost[g] - sum(hours, |t| avail[g, t] * rent[g, t]) complements new[g];
        eq flow[l @ (i, j) in lines, t in hours]: p[i, t] - p[j, t]                complements f[l, t];
        eq scarcity[n in nodes, t in hours]: voll - p[n, t]                        complements shed[n, t];
        eq demand[n in nodes, t in hours]:
            d[n, t] - load[n, t] * (max(p[n, t], 1e-3) / price0[n]).pow(-elasticity[n]) complements d[n, t];
        eq market[n in nodes, t in hours]: sum(site.of(n), |g| q[g, t])
            + sum(place.of(n), |k| dis[k, t] - ch[k, t]) + net[n, t] + shed[n, t] - d[n, t] complements p[n, t];
        eq charge[k in stores, t in hours]: p[place[k], t] - eta * v[k, t]         complements ch[k, t];
        eq discharge[k in stores, t in hours]: v[k, t] - p[place[k], t]            complements dis[k, t];
        eq hold[k in stores, t in hours]: v[k, t] - v[k, hours.wrap(t, 1)]         complements s[k, t];
        eq level[k in stores, t in hours]:
            s[k, hours.wrap(t, -1)] + eta * ch[k, t] - dis[k, t] - s[k, t]         complements v[k, t];
        eq trade: permits - sum(thermal, |g| sum(hours, |t| rate[g] * q[g, t]))    complements co2;
        report cost[g in gens]: sum(hours, |t| mc[g, t] * q[g, t]);
    }
}

/// Solves the model.
pub fn solution(model: &Markets) -> Result<Solution, ModelError> {
    let solution = solve(model, &Options::default())?;
    let _ = model.view(&solution)?;
    Ok(solution)
}
";

fn main() -> Result<(), Box<dyn Error>> {
    if std::env::args().any(|argument| argument == "--test") {
        return Ok(());
    }
    let workspace = workspace()?;
    let unit = if cpu_seconds().is_some() { "CPU s" } else { "wall s" };
    out(&format!(
        "{:<16} {:>9} {:>9} {:>9} {:>9}  [{unit}]",
        "", "model", "empty", "beyond", "budget"
    ));
    for (command, budget) in BUDGET {
        run(&workspace, command, &["-p", "with_model", "-p", "empty"])?;
        let [model, empty] =
            ["with_model", "empty"].map(|package| median_of(&workspace, command, package));
        let (model, empty) = (model?, empty?);
        let budget = budget.map(|budget: f64| format!("{budget:.2}")).unwrap_or_default();
        out(&format!(
            "{:<16} {model:>9.2} {empty:>9.2} {:>9.2} {budget:>9}",
            command.join(" "),
            model - empty
        ));
    }
    Ok(())
}

#[allow(clippy::print_stdout, reason = "the table is what the benchmark is for")]
fn out(line: &str) {
    println!("{line}");
}

/// Writes the two crates and returns their folder.
fn workspace() -> Result<PathBuf, Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("compile_time");
    fs::create_dir_all(&folder)?;
    fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock"))?;
    let members = "[workspace]\nmembers = [\"with_model\", \"empty\"]\nresolver = \"3\"\n";
    fs::write(folder.join("Cargo.toml"), members)?;
    for (package, text) in [("with_model", MODEL), ("empty", "")] {
        fs::create_dir_all(folder.join(package).join("src"))?;
        let manifest = format!(
            "[package]\nname = \"{package}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n\
             [dependencies]\nmcp-core = {{ path = \"{}\" }}\n",
            root.join("mcp-core").display()
        );
        fs::write(folder.join(package).join("Cargo.toml"), manifest)?;
        fs::write(folder.join(package).join("src/lib.rs"), text)?;
    }
    Ok(folder)
}

/// Seconds that one crate takes; everything below it is built already.
fn median_of(workspace: &Path, command: &[&str], package: &str) -> Result<f64, Box<dyn Error>> {
    let mut seconds = Vec::new();
    for _ in 0..REPETITIONS {
        let release = if command.contains(&"--release") { &["--release"][..] } else { &[] };
        run(workspace, &["clean"], &[release, &["-p", package]].concat())?;
        let (cpu, clock) = (cpu_seconds(), Instant::now());
        run(workspace, command, &["-p", package])?;
        let wall = clock.elapsed().as_secs_f64();
        seconds.push(cpu.zip(cpu_seconds()).map_or(wall, |(before, after)| after - before));
    }
    seconds.sort_by(f64::total_cmp);
    Ok(seconds[REPETITIONS / 2])
}

/// Runs cargo without network and without incremental state.
fn run(workspace: &Path, command: &[&str], arguments: &[&str]) -> Result<(), Box<dyn Error>> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(workspace).args(command).args(arguments).args(["--offline", "--quiet"]);
    if command != ["clean"] && cpu_seconds().is_none() {
        cargo.arg("-j1");
    }
    cargo.env("CARGO_INCREMENTAL", "0").env("CARGO_TARGET_DIR", workspace.join("target"));
    let output = cargo.stdin(Stdio::null()).output()?;
    if output.status.success() {
        return Ok(());
    }
    Err(format!("cargo {command:?}: {}", String::from_utf8_lossy(&output.stderr)).into())
}

/// CPU time of all processes that were waited for, where the system tells.
fn cpu_seconds() -> Option<f64> {
    /// Linux counts in hundredths of a second here, whatever its clock.
    const TICKS: f64 = 100.0;
    let stat = fs::read_to_string("/proc/self/stat").ok()?;
    // Behind the name in parentheses: state is field 3, time of children in fields 16 and 17.
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = |k: usize| fields.get(k - 3)?.parse::<f64>().ok();
    Some((ticks(16)? + ticks(17)?) / TICKS)
}
