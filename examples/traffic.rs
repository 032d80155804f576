//! # Everybody takes the quickest road: Wardrop equilibrium, Braess's paradox, a town
//!
//! From node `i` to zone `k` go `d_ik` [thousand/h] drivers. An arc with the traffic `v_a` takes
//! `t_a = free_a + rise_a (v_a / capacity_a)^power_a` [min]; the law of the Bureau of Public Roads
//! has the power 4 and rises by 15 % of the free time at capacity. Nobody arrives earlier on another
//! road. With `x_ak` for the traffic to `k` and `u_ik` for the time from `i` to `k`:
//!
//! ```text
//! t_a + u_jk − u_ik                    >= 0   ⟂   x_ak >= 0   for an arc a from i to j
//! Σ_{a from i} x_ak − Σ_{a into i} x_ak = d_ik    u_ik free   v_a = Σ_k x_ak
//! ```
//!
//! A driver who adds to `v_a` delays the others by `v_a t_a′`. Charged as a toll (`charged = 1`),
//! the equilibrium is the assignment of least total time.
//!
//! Sources: the principle is Wardrop's (Proc. Institution of Civil Engineers II 1, 1952),
//! the form that of Aashtiani & Magnanti, SIAM J. Alg. Disc. Meth. 2 (1981) 213–226.
//!
//! * **Braess's paradox** (Unternehmensforschung 12 (1968) 258–268): six thousand drivers, arcs of
//!   `10 v`, `50 + v` and `10 + v` minutes. By hand: without the arc from top to bottom three
//!   thousand take each side, 30 + 53 = 83 min. With it two thousand take each of three routes,
//!   40 + 52 = 40 + 12 + 40 = 92 min: worse for everybody. With the toll the arc stays empty: 83.
//! * **A town** of 5 × 5 crossings, all of them zones, with 80 arcs, and morning traffic from the
//!   outskirts to the centre. It is made up, by formulas that `tests/gallery_flows/town.rs` has. The
//!   relative gap is the share of the total time that better routes would save.
//!
//! `v` is unique; its split `x` by zones is not, so that `J` is singular at solutions and Newton
//! steps fail there. So problems with `pull (x − near)` added to `t_a` are solved, `near` being the
//! last solution (the proximal point method, Rockafellar, SIAM J. Control Optim. 14 (1976) 877–898),
//! from a start by twenty steps of Frank and Wolfe. The answer is that of the problem without pull.
//!
//! `cargo run --release --example traffic -- DIRECTORY` reads another network, and compares its
//! traffic with `flows.csv` (arcs, traffic) if there is one. The 24 nodes, 76 arcs and 528 pairs of
//! Sioux Falls, with the best known traffic, are at
//! <https://github.com/bstabler/TransportationNetworks>; they are for academic research only, hence
//! not part of this. Written as such tables they took 47 iterations, and the traffic was within
//! `2e-11` thousand/h of that published.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

#[path = "traffic/network.rs"]
pub(crate) mod network;

use mcp_core::language::{LabelPairs, LabelSubset, Labels, Table};
use mcp_core::{AdProblem, Method, Model, ModelError, Options, Set, Solution, Solver, mcp};
use network::Network;
use std::error::Error;
use std::path::{Path, PathBuf};

mcp! {
    /// Drivers choose the quickest roads to their zones.
    pub(crate) model Traffic {
        data {
            nodes: Set, zones: Subset(nodes), arcs: Pairs(nodes, nodes),
            /// numbers of an arc: times [min], capacity [thousand/h], power
            law: Set[free_time, rise, capacity, power],
            roads[arcs, law]: f64,
        }
        /// trips [thousand/h]
        param trips[i in nodes, k in zones];
        /// share of the delay of others that is charged
        param charged = 0.0;
        /// traffic of the last solution [thousand/h]
        param near[a in arcs, k in zones] = 0.0;
        /// time for leaving it [min h/thousand]
        param pull = 0.0;

        /// traffic to a zone [thousand/h]
        var x[a in arcs, k in zones] >= 0.0;
        /// time to a zone [min]
        var u[i in nodes, k in zones] free if i != k.of_larger_set();

        /// traffic [thousand/h]
        def v[a in arcs] lifted: sum(zones, |k| x[a, k]);
        /// rise of the time over that of the empty road [min]
        def delay[a in arcs]:
            roads[a, rise] * (max(v[a], 0.0) / roads[a, capacity]).pow(roads[a, power]);
        /// time [min]
        def time[a in arcs]: roads[a, free_time] + delay[a];
        /// delay of others, v t′ [min]
        def imposed[a in arcs]: roads[a, power] * delay[a];

        eq choice[a @ (i, j) in arcs, k in zones]:
            time[a] + charged * imposed[a] + pull * (x[a, k] - near[a, k]) + u[j, k] >= u[i, k]
            complements x[a, k];
        eq conservation[i in nodes, k in zones] if i != k.of_larger_set():
            sum(arcs.out_of(i), |a| x[a, k]) - sum(arcs.into(i), |a| x[a, k]) == trips[i, k]
            complements u[i, k];

        /// time of all drivers [thousand min/h]
        report total_time: sum(arcs, |a| v[a] * time[a]);
    }
}

impl Traffic {
    /// Reads `arcs.csv` (from, to or arc, from, to), `roads.csv` (arc and its numbers), `zones.csv`
    /// (zone) and `trips.csv` (from, one column for each zone) of a directory.
    pub(crate) fn read(directory: &Path) -> Result<Self, ModelError> {
        let file = |name: &str| directory.join(name);
        Traffic::builder()
            .nodes(Labels::csv(file("trips.csv")))
            .zones(LabelSubset::csv(file("zones.csv")))
            .arcs(LabelPairs::csv(file("arcs.csv")))
            .roads(Table::csv(file("roads.csv")))
            .trips(Table::csv(file("trips.csv")))
            .build()
    }
}

/// The equilibrium by proximal points, and the iterations it took.
pub(crate) fn equilibrium(
    model: &Traffic,
    start: &[f64],
) -> Result<(Solution, usize), Box<dyn Error>> {
    let mut problem = AdProblem::new(model)?;
    let mut solver = Solver::new(Options::new(Method::NewtonFb))?;
    let flows = model.shape().variable("x")?.len();
    let (mut z, mut iterations) = (start.to_vec(), 0);
    for pull in [1e-2, 1e-3, 1e-4, 1e-5] {
        problem.set_parameter("pull", &[pull])?;
        problem.set_parameter("near", &z[..flows])?;
        let step = solver.solve_from(&mut problem, &z)?;
        z.clone_from(&step.z);
        iterations += step.stats.iterations;
    }
    problem.set_parameter("pull", &[0.0])?;
    let solution = solver.solve_from(&mut problem, &z)?.clone().solved()?;
    Ok((solution, iterations))
}

/// The tables that come with the example.
pub(crate) fn tables(network: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/data/traffic").join(network)
}

fn main() -> Result<(), Box<dyn Error>> {
    match std::env::args().nth(1) {
        Some(directory) => assign(directory.as_ref()),
        None => braess().and_then(|()| assign(&tables("town"))),
    }
}

/// Braess's network without and with the arc from top to bottom, and with tolls.
fn braess() -> Result<(), Box<dyn Error>> {
    let directory = tables("braess");
    let network = Network::read(&directory)?;
    let start = network.start(&network.frank_wolfe(20));
    println!(
        "{:<18}{:>11}{:>10}{:>13}{:>14}",
        "", "start->top", "top->end", "top->bottom", "min a trip"
    );
    let cases =
        [("without the arc", 0.0, 83.0), ("with the arc", 0.0, 92.0), ("with tolls", 1.0, 83.0)];
    for (case, charged, minutes) in cases {
        let mut model = Traffic::read(&directory)?;
        model.set_parameter("charged", &[charged])?;
        if case == "without the arc" {
            model.fix("x[top->bottom, end]", 0.0)?;
        }
        let (solution, _) = equilibrium(&model, &start)?;
        let view = model.view(&solution)?;
        let [left, right, across] = ["start->top", "top->end", "top->bottom"].map(|a| view.v[a]);
        let trip = view.total_time / 6.0;
        println!("{case:<18}{left:>11.3}{right:>10.3}{across:>13.3}{trip:>14.6}");
        assert!((trip - minutes).abs() < 1e-8, "{trip} is not {minutes}");
    }
    Ok(())
}

/// The equilibrium of a network, and what tolls would save.
fn assign(directory: &Path) -> Result<(), Box<dyn Error>> {
    let network = Network::read(directory)?;
    let mut model = Traffic::read(directory)?;
    let near = network.frank_wolfe(20);
    let start = network.start(&near);
    let (solution, iterations) = equilibrium(&model, &start)?;
    let view = model.view(&solution)?;
    let gap = network.relative_gap(view.v.values());
    println!(
        "\n{}: {} arcs, {} variables, {iterations} iterations",
        directory.display(),
        view.v.len(),
        solution.z.len()
    );
    let gap_of_start = network.relative_gap(&network.traffic(&near));
    println!("relative gap {gap:.0e}, after Frank and Wolfe {gap_of_start:.0e}");
    assert!(gap < 1e-10);
    print_busiest(&view);
    compare(&view, directory)?;

    model.set_parameter("charged", &[1.0])?;
    let (tolled, _) = equilibrium(&model, &start)?;
    let least = model.view(&tolled)?.total_time;
    println!(
        "all drivers: {:.2} thousand h an hour, with tolls {:.2} ({:.2} % less)",
        view.total_time / 60.0,
        least / 60.0,
        100.0 * (1.0 - least / view.total_time)
    );
    assert!(least <= view.total_time);
    Ok(())
}

/// The arcs with the longest delays.
fn print_busiest(view: &TrafficView) {
    let mut arcs: Vec<String> = view.delay.iter().map(|([arc], _)| arc).collect();
    arcs.sort_by(|a, b| view.delay[b].total_cmp(&view.delay[a]));
    println!("{:<12}{:>14}{:>10}{:>12}", "arc", "thousand/h", "minutes", "of delay");
    for arc in &arcs[..arcs.len().min(8)] {
        println!("{arc:<12}{:>14.3}{:>10.2}{:>12.2}", view.v[arc], view.time[arc], view.delay[arc]);
    }
}

/// The largest difference from the traffic in `flows.csv`, if there is one.
fn compare(view: &TrafficView, directory: &Path) -> Result<(), Box<dyn Error>> {
    let file = directory.join("flows.csv");
    if file.exists() {
        let arcs = Set::new("arcs", view.v.iter().map(|([arc], _)| arc))?;
        let flows = Table::csv(file).resolve("flows", &[&arcs])?;
        let largest = view.v.values().iter().zip(&flows).map(|(v, w)| (v - w).abs());
        println!("largest difference from flows.csv: {:.1e}", largest.fold(0.0, f64::max));
    }
    Ok(())
}
