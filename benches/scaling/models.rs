//! The problems of the table, written with `mcp!`.

use crate::roads::Roads;
use mcp_core::{ModelError, Real, Scalar, mcp};

mcp! {
    /// A membrane under the load −10 above two hills: `−Δu = −10 ⟂ u >= ψ` on the unit square, times
    /// `h²`, five points.
    pub(crate) model Membrane {
        data { nodes: usize, h: f64, psi[nodes, nodes]: f64 }
        var u[i in nodes, j in nodes] >= psi[i, j] start psi[i, j];

        eq force[i in nodes, j in nodes]:
            4.0 * u[i, j] - u.at(i - 1, j).or(0.0) - u.at(i + 1, j).or(0.0)
                - u.at(i, j - 1).or(0.0) - u.at(i, j + 1).or(0.0) + 10.0 * h * h
            complements u[i, j];
    }
}

mcp! {
    /// The same with a spring: `−Δz + z³/2 + 10 ⟂ z >= 0`, `z = 0.3` on the rim.
    pub(crate) model Spring {
        data { nodes: usize, h: f64 }
        var z[i in nodes, j in nodes] >= 0.0 start 0.3;

        eq force[i in nodes, j in nodes]:
            4.0 * z[i, j] - z.at(i - 1, j).or(0.3) - z.at(i + 1, j).or(0.3)
                - z.at(i, j - 1).or(0.3) - z.at(i, j + 1).or(0.3)
                + h * h * (z[i, j] * z[i, j] * z[i, j] * 0.5 + 10.0)
            complements z[i, j];
    }
}

mcp! {
    /// Soap film pulled down above a floor, whose five reads are all nonlinear:
    /// `Σ d/√(1 + d²/h²) + 10 h² ⟂ z >= 0` over the differences `d` to the four neighbours, `z = 0.3` on the rim.
    pub(crate) model Film {
        data { nodes: usize, h: f64 }
        var z[i in nodes, j in nodes] >= 0.0 start 0.3;

        eq force[i in nodes, j in nodes]:
            pull(z[i, j] - z.at(i - 1, j).or(0.3), h) + pull(z[i, j] - z.at(i + 1, j).or(0.3), h)
                + pull(z[i, j] - z.at(i, j - 1).or(0.3), h) + pull(z[i, j] - z.at(i, j + 1).or(0.3), h)
                + 10.0 * h * h
            complements z[i, j];
    }
}

/// Of an edge whose ends differ by `d`.
fn pull<D: Scalar>(d: Real<D>, h: f64) -> Real<D> {
    d / (1.0 + (d / h) * (d / h)).sqrt()
}

mcp! {
    /// A cheap row with five nonlinear reads: `5 z² − Σ w² + 10 h² ⟂ z >= 0` over the four neighbours `w`.
    pub(crate) model Squares {
        data { nodes: usize, h: f64 }
        var z[i in nodes, j in nodes] >= 0.0 start 0.3;

        eq force[i in nodes, j in nodes]:
            5.0 * z[i, j] * z[i, j] - square(z.at(i - 1, j).or(0.3)) - square(z.at(i + 1, j).or(0.3))
                - square(z.at(i, j - 1).or(0.3)) - square(z.at(i, j + 1).or(0.3)) + 10.0 * h * h
            complements z[i, j];
    }
}

fn square<D: Scalar>(z: Real<D>) -> Real<D> {
    z * z
}

impl Film {
    /// On `k × k` inner nodes.
    pub(crate) fn on(k: usize) -> Result<Self, ModelError> {
        Film::builder().nodes(k).h(1.0 / (k as f64 + 1.0)).build()
    }
}

impl Squares {
    /// On `k × k` inner nodes.
    pub(crate) fn on(k: usize) -> Result<Self, ModelError> {
        Squares::builder().nodes(k).h(1.0 / (k as f64 + 1.0)).build()
    }
}

impl Membrane {
    /// On `k × k` inner nodes, with `ψ = −0.3 + 0.15 sin 3πx sin 3πy`.
    pub(crate) fn on(k: usize) -> Result<Self, ModelError> {
        let h = 1.0 / (k as f64 + 1.0);
        let sine = |i: usize| (3.0 * std::f64::consts::PI * h * (i as f64 + 1.0)).sin();
        let psi: Vec<f64> = (0..k * k).map(|p| -0.3 + 0.15 * sine(p / k) * sine(p % k)).collect();
        Membrane::builder().nodes(k).h(h).psi(psi).build()
    }
}

impl Spring {
    /// On `k × k` inner nodes.
    pub(crate) fn on(k: usize) -> Result<Self, ModelError> {
        Spring::builder().nodes(k).h(1.0 / (k as f64 + 1.0)).build()
    }
}

mcp! {
    /// Goods go from every region to every other: `c_ij + s x_ij + π_i − ρ_j ⟂ x_ij >= 0`; supply
    /// `π = a + b · sent`, demand `ρ = d − e · received`.
    pub(crate) model Transport {
        data { regions: usize, cost[regions, regions]: f64, slope: f64, size[regions]: f64 }
        var x[i in regions, j in regions] >= 0.0;
        var supply[i in regions] >= 0.0 start 1.0;
        var demand[j in regions] >= 0.0 start 10.0;

        eq profit[i in regions, j in regions]:
            cost[i, j] + slope * x[i, j] + supply[i] - demand[j]
            complements x[i, j];
        eq sent[i in regions]:
            size[i] * (supply[i] - 1.0) - sum(regions, |j| x[i, j])
            complements supply[i];
        eq received[j in regions]:
            sum(regions, |i| x[i, j]) - size[j] * (20.0 - demand[j])
            complements demand[j];
    }
}

impl Transport {
    /// `k` regions on a spiral in the plane; cost is distance.
    pub(crate) fn between(k: usize) -> Result<Self, ModelError> {
        let at = |i: usize| {
            let (r, angle) = ((i as f64 + 0.5).sqrt(), 2.399_963 * i as f64);
            (r * angle.cos(), r * angle.sin())
        };
        let distance = |i: usize, j: usize| {
            let ((a, b), (c, d)) = (at(i), at(j));
            (a - c).hypot(b - d)
        };
        let cost: Vec<f64> = (0..k * k).map(|p| distance(p / k, p % k)).collect();
        let size: Vec<f64> = (0..k).map(|i| 1.0 + 0.5 * (1.7 * i as f64).sin()).collect();
        Transport::builder().regions(k).cost(cost).slope(0.1).size(size).build()
    }
}

mcp! {
    /// Traffic to several places on a network: `time_a(v) + u_(head, k) − u_(tail, k) ⟂ x_ak >= 0`.
    pub(crate) model Traffic {
        data {
            nodes: Set, places: usize, arcs: Pairs(nodes, nodes),
            free_time[arcs]: f64, capacity[arcs]: f64,
            trips[nodes, places]: f64, longest[nodes, places]: f64,
        }
        var x[a in arcs, k in places] >= 0.0;
        var u[n in nodes, k in places] in 0.0..=longest[n, k];
        def time[a in arcs]:
            free_time[a] * (1.0 + 0.15 * (sum(places, |k| x[a, k]) / capacity[a]).powi(4));

        eq quickest[a @ (i, j) in arcs, k in places]: time[a] + u[j, k] - u[i, k]
            complements x[a, k];
        eq arrive[n in nodes, k in places]:
            sum(arcs.out_of(n), |a| x[a, k]) - sum(arcs.into(n), |a| x[a, k]) - trips[n, k]
            complements u[n, k];
    }
}

impl Traffic {
    /// The roads in the language.
    pub(crate) fn on(roads: &Roads) -> Result<Self, ModelError> {
        let Roads { nodes, places, .. } = *roads;
        let name = |p: usize| format!("n{p}");
        let arcs: Vec<_> = roads.ends.iter().map(|&(p, q)| (name(p), name(q))).collect();
        let longest = |(at, _)| {
            let (p, k) = (at / places, at % places);
            if p == roads.place(k) { 0.0 } else { f64::INFINITY }
        };
        Traffic::builder()
            .nodes((0..nodes).map(name).collect::<Vec<_>>())
            .places(places)
            .arcs(arcs)
            .free_time(roads.free_time.clone())
            .capacity(roads.capacity.clone())
            .trips(roads.trips.clone())
            .longest(roads.trips.iter().enumerate().map(longest).collect::<Vec<f64>>())
            .build()
    }
}
