//! The day of the power market against the dual of its convex program, in plain numbers.

#[path = "../../examples/power.rs"]
#[allow(dead_code, reason = "`main` is run as an example")]
mod example;

use example::{COST, DATA, Power, PowerView};
use mcp_core::{Options, solve};
use std::fs;
use std::path::Path;

/// Hours of the day.
const HOURS: usize = 24;
const VOLUME: f64 = 12.0;
const TURBINE: f64 = 2.5;
const ETA: f64 = 0.75;
const VOLL: f64 = 3.0;
/// Nodes of the plants in the order of `plants.csv`: north 0, middle 1, south 2, which has the
/// store.
const SITE: [usize; 6] = [0, 1, 1, 2, 2, 2];
const LIMIT: [f64; 2] = [4.0, 3.0];

/// The numbers of a file, without header, comments and labels.
fn numbers<const N: usize>(file: &str) -> Vec<[f64; N]> {
    let text = fs::read_to_string(Path::new(DATA).join(file)).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let row = |line: &str| line.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect();
    lines.map(|line| -> Vec<f64> { row(line) }).map(|row| row.try_into().unwrap()).collect()
}

/// The data, and what can be chosen: production, flows, load not served, the store.
struct Day {
    load: Vec<[f64; 3]>,
    avail: Vec<[f64; 6]>,
    /// Capacity, marginal cost, its slope.
    plant: Vec<[f64; 3]>,
}

impl Day {
    fn read() -> Self {
        Day {
            load: numbers("load.csv"),
            avail: numbers("availability.csv"),
            plant: numbers("plants.csv"),
        }
    }

    /// Cost of what the view does, after a check that it can be done.
    fn cost(&self, view: &PowerView) -> f64 {
        let (q, f, shed) = (view.q.values(), view.f.values(), view.shed.values());
        let (ch, dis, s) = (view.ch.values(), view.dis.values(), view.s.values());
        let within = |x: f64, low: f64, high: f64| assert!((low - 1e-9..=high + 1e-9).contains(&x));
        let mut cost = 0.0;
        for t in 0..HOURS {
            let mut supply = [-f[2 * t], f[2 * t] - f[2 * t + 1], f[2 * t + 1] + dis[t] - ch[t]];
            within(f[2 * t], -LIMIT[0], LIMIT[0]);
            within(f[2 * t + 1], -LIMIT[1], LIMIT[1]);
            within(ch[t], 0.0, TURBINE);
            within(dis[t], 0.0, TURBINE);
            within(s[t], 0.0, VOLUME);
            within(s[(t + HOURS - 1) % HOURS] + ETA * ch[t] - dis[t] - s[t], 0.0, 0.0);
            for (g, [capacity, fuel, slope]) in self.plant.iter().enumerate() {
                let q = q[6 * t + g];
                within(q, 0.0, capacity * self.avail[t][g]);
                supply[SITE[g]] += q;
                cost += (fuel + 0.5 * slope * q) * q;
            }
            for n in 0..3 {
                within(shed[3 * t + n], 0.0, self.load[t][n]);
                within(supply[n] + shed[3 * t + n] - self.load[t][n], 0.0, f64::INFINITY);
                cost += VOLL * shed[3 * t + n];
            }
        }
        cost
    }

    /// What every way to serve the day costs at least, by prices `p` and values `v`: with all
    /// balances priced, each choice is best on its own.
    fn bound(&self, p: &[f64], v: &[f64]) -> f64 {
        assert!(p.iter().all(|price| *price >= 0.0));
        // least of c x + ½ h x² on [0, u]
        let least = |c: f64, h: f64, u: f64| {
            let x = if c >= 0.0 {
                0.0
            } else if h == 0.0 {
                u
            } else {
                (-c / h).min(u)
            };
            (c + 0.5 * h * x) * x
        };
        let mut bound = 0.0;
        for t in 0..HOURS {
            let price = &p[3 * t..][..3];
            for n in 0..3 {
                bound += price[n] * self.load[t][n];
                bound += least(VOLL - price[n], 0.0, self.load[t][n]);
            }
            for (g, [capacity, fuel, slope]) in self.plant.iter().enumerate() {
                bound += least(fuel - price[SITE[g]], *slope, capacity * self.avail[t][g]);
            }
            for (l, limit) in LIMIT.iter().enumerate() {
                bound -= limit * (price[l + 1] - price[l]).abs();
            }
            bound += least(price[2] - ETA * v[t], 0.0, TURBINE);
            bound += least(v[t] - price[2], 0.0, TURBINE);
            bound += least(v[t] - v[(t + 1) % HOURS], 0.0, VOLUME);
        }
        bound
    }
}

#[test]
fn the_day_costs_as_little_as_its_prices_prove() {
    let model = Power::read(DATA.as_ref()).unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    let day = Day::read();
    let (cost, bound) = (day.cost(&view), day.bound(view.p.values(), view.v.values()));
    assert!((cost - bound).abs() < 1e-8 * cost, "{cost} against {bound}");
    assert!((cost - view.cost).abs() < 1e-9, "{cost}");
    assert!((cost - COST).abs() < 5e-4, "{cost}");
}

#[test]
fn other_prices_prove_less() {
    let model = Power::read(DATA.as_ref()).unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    let day = Day::read();
    let best = day.bound(view.p.values(), view.v.values());
    for k in 0..view.p.len() {
        for factor in [0.9, 1.1] {
            let mut p = view.p.values().to_vec();
            p[k] *= factor;
            assert!(day.bound(&p, view.v.values()) < best, "price {k} times {factor}");
        }
    }
}

/// What consumers pay goes to plants, lines and the store.
#[test]
fn payments_add_up() {
    let model = Power::read(DATA.as_ref()).unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    let day = Day::read();
    let (p, q, shed) = (view.p.values(), view.q.values(), view.shed.values());
    let (mut paid, mut produced) = (0.0, 0.0);
    for t in 0..HOURS {
        paid += (0..3).map(|n| p[3 * t + n] * (day.load[t][n] - shed[3 * t + n])).sum::<f64>();
        produced += (0..6).map(|g| p[3 * t + SITE[g]] * q[6 * t + g]).sum::<f64>();
    }
    let rents: f64 = view.rent.values().iter().sum();
    let earned: f64 = view.earned.values().iter().sum();
    assert!((paid - produced - rents - earned).abs() < 1e-8, "{paid}");
    // At its limit the rent of a line is −F, hour by hour.
    let marginals = |l: usize| (0..HOURS).map(move |t| (2 * t + l, LIMIT[l]));
    for l in 0..2 {
        let at_bounds = |(k, limit): (usize, f64)| view.f.marginals()[k].abs() * limit;
        let rent: f64 = marginals(l).map(at_bounds).sum();
        assert!((rent - view.rent.values()[l]).abs() < 1e-8, "{rent}");
    }
}
