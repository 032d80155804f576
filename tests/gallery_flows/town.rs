//! The town: its tables from their formulas, its equilibrium by Dijkstra's algorithm.

use crate::sheet::{numbers, rows};
use crate::traffic::{Traffic, TrafficView, equilibrium, network, tables};
use network::Network;
use std::sync::OnceLock;

const SIDE: usize = 5;
const NODES: usize = SIDE * SIDE;

fn label(m: usize) -> String {
    format!("{}{}", ["a", "b", "c", "d", "e"][m / SIDE], m % SIDE + 1)
}

/// Blocks between two crossings.
fn blocks(m: usize, n: usize) -> usize {
    (m / SIDE).abs_diff(n / SIDE) + (m % SIDE).abs_diff(n % SIDE)
}

/// 5 in the centre, 1 in the corners.
fn centrality(m: usize) -> usize {
    5 - blocks(m, NODES / 2)
}

/// An arc of the files: tail, head, free time, rise, capacity and power.
struct Arc {
    tail: usize,
    head: usize,
    law: Vec<f64>,
}

fn arcs() -> Vec<Arc> {
    let node = |cell: &String| (0..NODES).find(|&m| label(m) == *cell).unwrap();
    let ends = rows("traffic/town/arcs.csv");
    let laws = numbers("traffic/town/roads.csv");
    let arc = |(ends, law): (&Vec<String>, Vec<f64>)| Arc {
        tail: node(&ends[0]),
        head: node(&ends[1]),
        law,
    };
    ends[1..].iter().zip(laws).map(arc).collect()
}

/// Thousand trips an hour, row by origin.
fn trips() -> Vec<Vec<f64>> {
    numbers("traffic/town/trips.csv")
}

#[test]
fn the_tables_are_those_of_the_formulas() {
    let pairs = (0..NODES).flat_map(|m| (0..NODES).map(move |n| (m, n)));
    let streets: Vec<_> = pairs.filter(|&(m, n)| blocks(m, n) == 1).collect();
    let arcs = arcs();
    assert_eq!(arcs.len(), 80);
    let names = rows("traffic/town/roads.csv");
    for ((arc, &(m, n)), name) in arcs.iter().zip(&streets).zip(&names[1..]) {
        assert_eq!((arc.tail, arc.head), (m, n));
        assert_eq!(name[0], format!("{}->{}", label(m), label(n)));
        // 2 to 5 minutes, 15 % more at a capacity of 2 to 4 thousand an hour.
        let free = (2 + m * n % 4) as f64;
        assert_eq!([arc.law[0], arc.law[2], arc.law[3]], [free, (2 + (m + n) % 3) as f64, 4.0]);
        assert!((arc.law[1] - 0.15 * free).abs() < 1e-15);
    }
    for (m, row) in trips().iter().enumerate() {
        for (n, &given) in row.iter().enumerate() {
            // Morning traffic: from the outskirts to the centre, less the farther it is.
            let tens = match blocks(m, n) {
                0 => 0,
                d => 4 * (6 - centrality(m)) * centrality(n) / d,
            };
            assert_eq!(given, tens as f64 / 100.0);
        }
    }
}

/// The solved town without tolls, and with those that charge all delay.
fn solved() -> &'static [TrafficView; 2] {
    static SOLVED: OnceLock<[TrafficView; 2]> = OnceLock::new();
    SOLVED.get_or_init(|| {
        let directory = tables("town");
        let network = Network::read(&directory).unwrap();
        let start = network.start(&network.frank_wolfe(20));
        [0.0, 1.0].map(|charged| {
            let mut model = Traffic::read(&directory).unwrap();
            model.set_parameter("charged", &[charged]).unwrap();
            let (solution, _) = equilibrium(&model, &start).unwrap();
            model.view(&solution).unwrap()
        })
    })
}

/// Shortest times from every node to `zone`, by Dijkstra's algorithm.
fn dijkstra(arcs: &[Arc], time: &[f64], zone: usize) -> Vec<f64> {
    let mut best = vec![f64::INFINITY; NODES];
    best[zone] = 0.0;
    let mut open: Vec<usize> = (0..NODES).collect();
    while let Some(k) = (0..open.len()).min_by(|&a, &b| best[open[a]].total_cmp(&best[open[b]])) {
        let node = open.swap_remove(k);
        for (arc, time) in arcs.iter().zip(time).filter(|(arc, _)| arc.head == node) {
            best[arc.tail] = best[arc.tail].min(time + best[node]);
        }
    }
    best
}

/// What an arc costs a driver: `t_a`, and with tolls the delay of the others, `v_a t_a′`.
fn costs(arcs: &[Arc], v: &[f64], tolls: bool) -> Vec<f64> {
    let cost = |(arc, v): (&Arc, &f64)| {
        let delay = arc.law[1] * (v / arc.law[2]).powi(4);
        arc.law[0] + if tolls { 5.0 * delay } else { delay }
    };
    arcs.iter().zip(v).map(cost).collect()
}

/// Every arc in use to a zone lies on a cheapest route to it; the cost of all trips, and how much of
/// it the cheapest routes would save.
fn cheapest_routes_only(view: &TrafficView, tolls: bool) -> (f64, f64) {
    let (arcs, trips, x) = (arcs(), trips(), view.x.values());
    let traffic: Vec<f64> = x.chunks(NODES).map(|x| x.iter().sum()).collect();
    let cost = costs(&arcs, &traffic, tolls);
    let (mut spent, mut least) = (0.0, 0.0);
    for zone in 0..NODES {
        let u = dijkstra(&arcs, &cost, zone);
        for (a, arc) in arcs.iter().enumerate() {
            let detour = cost[a] + u[arc.head] - u[arc.tail];
            let x = x[a * NODES + zone];
            assert!(x >= 0.0 && x.min(detour) < 1e-8, "{x} on a detour of {detour}");
            spent += x * cost[a];
        }
        least += trips.iter().zip(&u).map(|(row, u)| row[zone] * u).sum::<f64>();
    }
    (spent, 1.0 - least / spent)
}

#[test]
fn no_driver_has_a_quicker_road() {
    let (spent, gap) = cheapest_routes_only(&solved()[0], false);
    assert!(gap.abs() < 1e-11, "relative gap {gap:e}");
    assert!((solved()[0].total_time / spent - 1.0).abs() < 1e-11);
}

#[test]
fn u_is_the_time_of_the_quickest_road() {
    let (arcs, trips, view) = (arcs(), trips(), &solved()[0]);
    let time = costs(&arcs, view.v.values(), false);
    for zone in 0..NODES {
        let quickest = dijkstra(&arcs, &time, zone);
        for node in (0..NODES).filter(|&node| trips[node][zone] > 0.0) {
            let u = view.u[(label(node), label(zone))];
            assert!((u - quickest[node]).abs() < 1e-8, "{u} is not {}", quickest[node]);
        }
    }
}

#[test]
fn with_tolls_the_total_time_is_least() {
    // It is convex in the traffic, and the toll makes a cost its derivative: nobody can choose a
    // cheaper road, so no change of the traffic shortens it.
    let (_, gap) = cheapest_routes_only(&solved()[1], true);
    assert!(gap.abs() < 1e-11, "relative gap {gap:e}");
    assert!(solved()[1].total_time < solved()[0].total_time);
}

#[test]
fn everybody_arrives() {
    let (arcs, trips) = (arcs(), trips());
    for (view, zone) in solved().iter().flat_map(|view| (0..NODES).map(move |zone| (view, zone))) {
        let x = view.x.values();
        let mut balance: Vec<f64> = trips.iter().map(|row| row[zone]).collect();
        let coming: f64 = balance.iter().sum();
        for (a, arc) in arcs.iter().enumerate() {
            balance[arc.tail] -= x[a * NODES + zone];
            balance[arc.head] += x[a * NODES + zone];
        }
        for (node, left) in balance.iter().enumerate() {
            let expected = if node == zone { coming } else { 0.0 };
            assert!((left - expected).abs() < 1e-8, "{left} is left at {}", label(node));
        }
    }
}

#[test]
fn frank_and_wolfe_come_near_the_same_traffic() {
    let network = Network::read(&tables("town")).unwrap();
    let slow = network.traffic(&network.frank_wolfe(300));
    let off = slow.iter().zip(solved()[0].v.values()).map(|(slow, v)| (slow - v).abs());
    let off = off.fold(0.0, f64::max);
    assert!(off < 0.02, "{off} thousand an hour");
}

#[test]
fn the_total_times_are_as_they_were() {
    // Regression values [thousand hours an hour].
    for (view, expected) in solved().iter().zip([12.939_999_796, 12.536_699_835]) {
        let found = view.total_time / 60.0;
        assert!((found - expected).abs() < 1e-8, "{found} is not {expected}");
    }
}
