//! Elastohydrodynamic lubrication of a line contact: the film pressure of a loaded bearing.

use super::Instance;
use crate::error::ModelError;
use crate::model::{Definition, Equation, Model, Reader, Set, Shape, Variable};
use crate::scalar::{Real, Scalar, sum, when};
use std::f64::consts::PI;

/// Ends of the interval of pressure.
const ENDS: (f64, f64) = (-3.0, 2.0);

/// Pressures `p_1, …, p_N >= 0` on a grid of width `Δx` with `p_0 = p_{N+1} = 0`, and a free
/// constant `k` of the film thickness. At the midpoints `x_j`, `j = 0, …, N`:
///
/// ```text
/// h_j    = x_j² + 1 + k + (A p)_j                           elastic film thickness
/// q_j    = h_j³ (p_{j+1} − p_j) / exp(α (p_{j+1} + p_j)/2)  flow, viscosity growing with pressure
/// force:     1 − (2 Δx/π) Σ w_i p_i = 0                      ⟂  k
/// Reynolds:  λ (h_i − h_{i−1})/Δx − (q_i − q_{i−1})/Δx² >= 0  ⟂  p_i >= 0
/// ```
struct LineContact {
    shape: Shape,
    points: usize,
    dx: f64,
    alpha: f64,
    lambda: f64,
    /// `A`, `N + 1` rows of `N` numbers.
    elasticity: Vec<f64>,
}

impl LineContact {
    fn new(points: usize, alpha: f64, lambda: f64) -> Result<Self, ModelError> {
        let dx = (ENDS.1 - ENDS.0) / points as f64;
        let start = |i: usize| (1.0 - ((ENDS.0 + 1.0 + i as f64 * dx) / 2.0).abs()).max(0.0);
        let start: Vec<f64> = (1..=points).map(start).collect();
        let (grid, midpoints) = (Set::count("grid", points), Set::count("midpoints", points + 1));
        let shape = Shape::builder()
            .variable(Variable::new("k").start(1.6))
            .variable(Variable::new("p").over(&[&grid]).lower(0.0).start(start))
            .definition(Definition::new("h").over(&[&midpoints]))
            .definition(Definition::new("q").over(&[&midpoints]))
            .equation(Equation::new("force").complements("k"))
            .equation(Equation::new("reynolds").over(&[&grid]).complements("p"))
            .build()?;
        let elasticity = elasticity(points, dx);
        Ok(LineContact { shape, points, dx, alpha, lambda, elasticity })
    }

    /// `p_i`, 0 at both ends.
    fn pressure<D: Scalar>(&self, i: usize, read: &Reader<'_, D>) -> Real<D> {
        when((1..=self.points).contains(&i), || read.var(i))
    }

    fn thickness<D: Scalar>(&self, j: usize, read: &Reader<'_, D>) -> Real<D> {
        let x = ENDS.0 + (j as f64 + 0.5) * self.dx;
        let a = &self.elasticity[j * self.points..(j + 1) * self.points];
        x * x + 1.0 + read.var(0) + sum(0..self.points, |l| a[l] * read.var(1 + l))
    }

    fn flow<D: Scalar>(&self, j: usize, read: &Reader<'_, D>) -> Real<D> {
        let (left, right) = (self.pressure(j, read), self.pressure(j + 1, read));
        read.def(j).powi(3) * (right - left) / (self.alpha * (right + left) * 0.5).exp()
    }
}

/// Weights of the trapezoidal rule on `0, …, N`.
fn weight(i: usize, points: usize) -> f64 {
    if i == 0 || i == points { 0.5 } else { 1.0 }
}

/// `∫ ln |x − s| p(s) ds / π` after integration by parts, with central differences for `p'`.
fn elasticity(points: usize, dx: f64) -> Vec<f64> {
    let mut a = vec![0.0; (points + 1) * points];
    for j in 0..=points {
        let row = &mut a[j * points..(j + 1) * points];
        for l in 0..=points {
            let distance = (l as f64 - j as f64 - 0.5) * dx;
            let term = weight(l, points) * distance * distance.abs().ln() / PI;
            if l < points {
                row[l] += term;
            }
            if l > 1 {
                row[l - 2] -= term;
            }
        }
    }
    a
}

impl Model for LineContact {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn def<D: Scalar>(&self, family: usize, j: usize, read: &Reader<'_, D>) -> Real<D> {
        if family == 0 { self.thickness(j, read) } else { self.flow(j, read) }
    }
    fn row<D: Scalar>(&self, family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let (dx, n) = (self.dx, self.points);
        if family == 0 {
            return 1.0 - dx * 2.0 / PI * sum(1..=n, |i| weight(i, n) * read.var(i));
        }
        let (h, q) = (|j| read.def(j), |j| read.def(n + 1 + j));
        self.lambda / dx * (h(i + 1) - h(i)) - (q(i + 1) - q(i)) / (dx * dx)
    }
}

/// Four loads; the first is that of MCPLIB.
pub(super) fn instances() -> Result<Vec<Instance>, ModelError> {
    let loads = [(100, 2.832, 6.057), (40, 2.832, 6.057), (100, 1.6, 2.0), (60, 4.0, 3.0)];
    let instance = |(points, alpha, lambda): (usize, f64, f64)| {
        let name = format!("ehl_kost-N{points}-a{alpha:?}");
        let model = LineContact::new(points, alpha, lambda)?;
        Ok(Instance::new(name, "Kostreva (1984), Int. J. Numer. Methods Fluids 4; MCPLIB", model))
    };
    loads.into_iter().map(instance).collect()
}
