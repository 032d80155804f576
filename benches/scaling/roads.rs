//! A grid of roads in plain numbers, and a start for its traffic: successive averages of everybody on the
//! quickest route.

/// Rounds of the averages.
const ROUNDS: usize = 30;
/// What moves every flow of the start away from 0.
const SPREAD: f64 = 1e-3;

/// Crossings, arcs both ways between neighbours, and trips to some of the crossings.
pub(crate) struct Roads {
    pub(crate) nodes: usize,
    pub(crate) places: usize,
    /// Tail and head of an arc.
    pub(crate) ends: Vec<(usize, usize)>,
    pub(crate) free_time: Vec<f64>,
    pub(crate) capacity: Vec<f64>,
    /// `nodes × places`.
    pub(crate) trips: Vec<f64>,
}

impl Roads {
    /// `rows × columns` crossings; everybody goes to `places` of them.
    pub(crate) fn grid(rows: usize, columns: usize, places: usize) -> Self {
        let nodes = rows * columns;
        let mut ends = Vec::new();
        for p in 0..nodes {
            let across = (p % columns + 1 < columns).then_some(p + 1);
            let down = (p + columns < nodes).then_some(p + columns);
            for q in across.into_iter().chain(down) {
                ends.extend([(p, q), (q, p)]);
            }
        }
        let wave = |k: usize| (2.1 * k as f64).sin();
        let mut roads = Roads {
            nodes,
            places,
            free_time: (0..ends.len()).map(|a| 1.0 + 0.3 * wave(a)).collect(),
            capacity: (0..ends.len()).map(|a| 4.0 + wave(a + 7)).collect(),
            ends,
            trips: Vec::new(),
        };
        let trips = |p: usize, k: usize| {
            if p == roads.place(k) { 0.0 } else { 0.02 * (1.5 + wave(p + 3 * k)) }
        };
        roads.trips = (0..nodes * places).map(|at| trips(at / places, at % places)).collect();
        roads
    }

    /// The crossing that trips of number `k` go to.
    pub(crate) fn place(&self, k: usize) -> usize {
        (2 * k + 1) * self.nodes / (2 * self.places)
    }

    /// All variables: flows `x`, `arcs × places`, and times `u` to the places, `nodes × places`.
    pub(crate) fn start(&self) -> Vec<f64> {
        let arcs = self.ends.len();
        let mut x = vec![0.0; arcs * self.places];
        let mut u = vec![0.0; self.nodes * self.places];
        for round in 0..=ROUNDS {
            let times = self.times(&x);
            for k in 0..self.places {
                let (reach, flow) = self.quickest(k, &times);
                let share = 1.0 / (round + 1) as f64;
                for a in 0..arcs {
                    x[a * self.places + k] += share * (flow[a] - x[a * self.places + k]);
                }
                for (p, time) in reach.into_iter().enumerate() {
                    u[p * self.places + k] = time;
                }
            }
        }
        x.into_iter().map(|x| x + SPREAD).chain(u).collect()
    }

    fn times(&self, x: &[f64]) -> Vec<f64> {
        let time = |(a, x): (usize, &[f64])| {
            let load = x.iter().sum::<f64>() / self.capacity[a];
            self.free_time[a] * (1.0 + 0.15 * load.powi(4))
        };
        x.chunks_exact(self.places).enumerate().map(time).collect()
    }

    /// Shortest times to place `k` by Bellman and Ford, and the flows if everybody takes them.
    fn quickest(&self, k: usize, times: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut reach = vec![f64::INFINITY; self.nodes];
        let mut next = vec![0; self.nodes];
        reach[self.place(k)] = 0.0;
        let mut improved = true;
        while improved {
            improved = false;
            for (a, &(i, j)) in self.ends.iter().enumerate() {
                if times[a] + reach[j] < reach[i] {
                    (reach[i], next[i], improved) = (times[a] + reach[j], a, true);
                }
            }
        }
        let mut order: Vec<usize> = (0..self.nodes).filter(|&p| p != self.place(k)).collect();
        order.sort_by(|&p, &q| reach[q].total_cmp(&reach[p]));
        let mut through: Vec<f64> =
            (0..self.nodes).map(|p| self.trips[p * self.places + k]).collect();
        let mut flow = vec![0.0; self.ends.len()];
        for p in order {
            flow[next[p]] += through[p];
            through[self.ends[next[p]].1] += through[p];
        }
        (reach, flow)
    }
}
