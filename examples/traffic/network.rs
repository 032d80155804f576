//! The network in plain numbers, and traffic near equilibrium by the method of Frank & Wolfe (Naval
//! Research Logistics Quarterly 3 (1956) 95–110): everybody on the quickest route, then the step
//! towards these loads that makes `Σ_a ∫₀^v_a t_a` least, again and again.

use mcp_core::language::{LabelPairs, LabelSubset, Labels, Table};
use mcp_core::{ModelError, Set};
use std::path::Path;

/// What moves every flow of the start away from 0 [thousand/h].
const SPREAD: f64 = 1e-3;

/// Arcs with their times, and trips to zones; nodes, arcs and zones are positions.
pub(crate) struct Network {
    nodes: usize,
    /// Tail and head of an arc.
    ends: Vec<(usize, usize)>,
    /// Free time, rise, capacity and power of an arc.
    roads: Vec<f64>,
    /// The node of a zone.
    zones: Vec<usize>,
    /// Trips from a node to a zone, `nodes × zones`.
    trips: Vec<f64>,
}

impl Network {
    /// Reads the tables of [`Traffic::read`](super::Traffic::read).
    pub(crate) fn read(directory: &Path) -> Result<Self, ModelError> {
        let file = |name: &str| directory.join(name);
        let nodes = Labels::csv(file("trips.csv")).into_set("nodes")?;
        let (arcs, ends) = LabelPairs::csv(file("arcs.csv")).resolve("arcs", &nodes, &nodes)?;
        let law = Set::new("law", ["free_time", "rise", "capacity", "power"])?;
        let roads = Table::csv(file("roads.csv")).resolve("roads", &[&arcs, &law])?;
        let zones = LabelSubset::csv(file("zones.csv")).resolve("zones", &nodes)?;
        let labels = Set::new("zones", zones.iter().map(|&k| nodes.label(k)))?;
        let trips = Table::csv(file("trips.csv")).resolve("trips", &[&nodes, &labels])?;
        Ok(Network { nodes: nodes.len(), ends, roads, zones, trips })
    }

    /// Times of the arcs at the traffic `v`.
    pub(crate) fn times(&self, v: &[f64]) -> Vec<f64> {
        let time = |(road, v): (&[f64], &f64)| road[0] + road[1] * (v / road[2]).powf(road[3]);
        self.roads.chunks_exact(4).zip(v).map(time).collect()
    }

    /// Share of the total time that better routes would save, `1 − Σ d_ik u_ik / Σ v_a t_a`: 0 in
    /// equilibrium.
    pub(crate) fn relative_gap(&self, v: &[f64]) -> f64 {
        let time = self.times(v);
        let spent: f64 = v.iter().zip(&time).map(|(v, t)| v * t).sum();
        let mut least = 0.0;
        for k in 0..self.zones.len() {
            let (u, _) = self.quickest(k, &time);
            least += (0..self.nodes).map(|i| self.trips_from(i, k) * u[i]).sum::<f64>();
        }
        1.0 - least / spent
    }

    /// Traffic `x` to zones, `arcs × zones`, after some steps of Frank and Wolfe.
    pub(crate) fn frank_wolfe(&self, steps: usize) -> Vec<f64> {
        let mut x = self.all_or_nothing(&self.times(&vec![0.0; self.ends.len()]));
        for _ in 0..steps {
            let v = self.traffic(&x);
            let y = self.all_or_nothing(&self.times(&v));
            let d: Vec<f64> = self.traffic(&y).iter().zip(&v).map(|(w, v)| w - v).collect();
            let step = self.best_step(&v, &d);
            x.iter_mut().zip(&y).for_each(|(x, y)| *x += step * (y - *x));
        }
        x
    }

    /// All variables of the model in their order: `x`, moved away from its bound; the shortest
    /// times `u` to zones; the traffic `v`.
    pub(crate) fn start(&self, x: &[f64]) -> Vec<f64> {
        let mut z: Vec<f64> = x.iter().map(|x| x + SPREAD).collect();
        let v = self.traffic(&z);
        let time = self.times(&v);
        let u: Vec<_> = (0..self.zones.len()).map(|k| self.quickest(k, &time).0).collect();
        for i in 0..self.nodes {
            let elsewhere = (0..self.zones.len()).filter(|&k| self.zones[k] != i);
            z.extend(elsewhere.map(|k| u[k][i]));
        }
        z.extend(v);
        z
    }

    fn trips_from(&self, i: usize, k: usize) -> f64 {
        self.trips[i * self.zones.len() + k]
    }

    /// `v_a = Σ_k x_ak`.
    pub(crate) fn traffic(&self, x: &[f64]) -> Vec<f64> {
        x.chunks_exact(self.zones.len()).map(|x| x.iter().sum()).collect()
    }

    /// Shortest times to zone `k` and the arc to take at each node, by relaxing all arcs until
    /// nothing changes.
    fn quickest(&self, k: usize, time: &[f64]) -> (Vec<f64>, Vec<Option<usize>>) {
        let mut u = vec![f64::INFINITY; self.nodes];
        let mut first = vec![None; self.nodes];
        u[self.zones[k]] = 0.0;
        let mut changed = true;
        while changed {
            changed = false;
            for (a, &(i, j)) in self.ends.iter().enumerate() {
                if time[a] + u[j] < u[i] {
                    (u[i], first[i], changed) = (time[a] + u[j], Some(a), true);
                }
            }
        }
        (u, first)
    }

    /// Traffic to zones with everybody on a quickest route.
    fn all_or_nothing(&self, time: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; self.ends.len() * self.zones.len()];
        for k in 0..self.zones.len() {
            let (_, first) = self.quickest(k, time);
            for origin in 0..self.nodes {
                let mut node = origin;
                while let Some(a) = first[node] {
                    x[a * self.zones.len() + k] += self.trips_from(origin, k);
                    node = self.ends[a].1;
                }
            }
        }
        x
    }

    /// The step `s` in [0, 1] where `Σ_a d_a t_a(v + s d)` changes its sign, by bisection.
    fn best_step(&self, v: &[f64], d: &[f64]) -> f64 {
        let slope = |s: f64| -> f64 {
            let moved: Vec<f64> = v.iter().zip(d).map(|(v, d)| v + s * d).collect();
            self.times(&moved).iter().zip(d).map(|(t, d)| t * d).sum()
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..40 {
            let middle = f64::midpoint(low, high);
            if slope(middle) < 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        high
    }
}
