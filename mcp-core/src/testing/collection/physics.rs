//! Problems of mechanics on grids, and contacts.

use super::super::affine::Affine;
use super::{Instance, lcps, lubrication};
use crate::error::ModelError;
use crate::model::{Model, Reader, Shape};
use crate::scalar::{Real, Scalar, sum};
use std::f64::consts::PI;

/// Interior grid points of one side of the unit square.
const SIDE: usize = 16;
const WIDTH: f64 = 1.0 / (SIDE + 1) as f64;

/// `f(x, y)` at the interior grid points, `y` fastest.
fn on_grid(f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let at = |i: usize| WIDTH * (i + 1) as f64;
    (0..SIDE * SIDE).map(|k| f(at(k / SIDE), at(k % SIDE))).collect()
}

/// Neighbours of point `k` on a grid of `rows × columns`.
fn neighbours(k: usize, rows: usize, columns: usize) -> [Option<usize>; 4] {
    let (i, j) = (k / columns, k % columns);
    [
        (i + 1 < rows).then(|| k + columns),
        (i > 0).then(|| k - columns),
        (j + 1 < columns).then(|| k + 1),
        (j > 0).then(|| k - 1),
    ]
}

/// Row `k` of the five-point stencil of `−h² Δ`.
fn laplacian(k: usize) -> Vec<(usize, f64)> {
    let around = neighbours(k, SIDE, SIDE).into_iter().flatten().map(|j| (j, -1.0));
    std::iter::once((k, 4.0)).chain(around).collect()
}

/// `−h² Δ u − load ⟂ lower <= u <= upper`.
fn membrane(lower: &[f64], upper: &[f64], start: &[f64], load: f64) -> Result<Affine, ModelError> {
    let rows = (0..SIDE * SIDE).map(laplacian).collect();
    Affine::boxed((lower, upper), start, vec![-load * WIDTH * WIDTH; SIDE * SIDE], rows)
}

fn membranes() -> Result<Vec<Instance>, ModelError> {
    let wave = |x: f64, y: f64| (9.2 * x).sin() * (9.3 * y).sin();
    let lower = on_grid(|x, y| wave(x, y).powi(3));
    let upper = on_grid(|x, y| wave(x, y).powi(2) + 0.2);
    let start: Vec<f64> = lower.iter().map(|l| l.max(0.0)).collect();
    let n = start.len();
    let between = membrane(&lower, &upper, &start, 1.0)?;
    let above = membrane(&lower, &vec![f64::INFINITY; n], &start, 1.0)?;
    let wall = on_grid(|x, y| x.min(1.0 - x).min(y.min(1.0 - y)));
    let outside: Vec<f64> = wall.iter().map(|d| -d).collect();
    let torsion = membrane(&outside, &wall, &vec![0.0; n], 20.0)?;
    let source = "Dembo & Tulowitzki (1983), obstacle problem B; Moré & Toraldo (1991)";
    Ok(vec![
        Instance::new("obstacle-box", source, between),
        Instance::new("obstacle-low", source, above),
        Instance::new("torsion", "elastic-plastic torsion, Moré & Toraldo (1991)", torsion),
    ])
}

/// Bratu's problem: `−h² Δ u − λ h² exp u ⟂ 0 <= u <= 4`.
struct Bratu {
    shape: Shape,
    lambda: f64,
}

impl Model for Bratu {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        sum(laplacian(i), |(j, a)| a * read.var(j))
            - self.lambda * WIDTH * WIDTH * read.var(i).exp()
    }
}

fn bratu(lambda: f64) -> Result<Instance, ModelError> {
    let n = SIDE * SIDE;
    let shape = Shape::anonymous(&vec![0.0; n], &vec![4.0; n], &vec![0.0; n])?;
    let source = "Bratu's problem with obstacles; MCPLIB";
    Ok(Instance::new(format!("bratu-{lambda}"), source, Bratu { shape, lambda }))
}

/// Journal bearing with cavitation: `−∇·(h³ ∇p) + h' ⟂ p >= 0` for the film `h = 1 + e cos θ`,
/// eccentricity `e = 0.8`, on 24 × 8 points.
fn journal() -> Result<Instance, ModelError> {
    let (around, along, eccentricity) = (24, 8, 0.8);
    let (dt, dy) = (2.0 * PI / (around + 1) as f64, 10.0 / 9.0);
    let theta = |i: usize| 2.0 * PI * (i + 1) as f64 / (around + 1) as f64;
    let film = |t: f64| (1.0 + eccentricity * t.cos()).powi(3);
    let row = |k: usize| {
        let t = theta(k / along);
        let side = film(t) * dt / dy;
        let weights = [film(t + dt / 2.0) * dy / dt, film(t - dt / 2.0) * dy / dt, side, side];
        let neighbours = neighbours(k, around, along);
        let beside = neighbours.into_iter().zip(weights);
        let beside = beside.filter_map(|(j, weight)| j.map(|j| (j, -weight)));
        std::iter::once((k, weights.iter().sum())).chain(beside).collect()
    };
    let q = |k: usize| -eccentricity * theta(k / along).sin() * dt * dy;
    let n = around * along;
    let model = Affine::sparse((0..n).map(q).collect(), (0..n).map(row).collect())?;
    Ok(Instance::new("journal", "journal bearing, Cryer (1971); Moré & Toraldo (1991)", model))
}

/// Frictionless contacts, a third of them twice: `M = G Gᵀ` of rank 6 and 12.
fn contacts() -> Result<Vec<Instance>, ModelError> {
    ["contact-r6-n30", "contact-r12-n90"]
        .map(|name| lcps::stored(name.into(), 0.0))
        .into_iter()
        .collect()
}

pub(super) fn instances() -> Result<Vec<Instance>, ModelError> {
    let grids = vec![bratu(6.0)?, bratu(20.0)?, journal()?];
    Ok([lubrication::instances()?, membranes()?, grids, contacts()?].concat())
}
