//! Systems of equations as problems with free variables, and two relatives.

use super::Instance;
use crate::error::ModelError;
use crate::mcp_fn;
use crate::model::{Equation, Model, Reader, Set, Shape, Variable};
use crate::scalar::{Real, Scalar, atan2, hypot, when};
use std::f64::consts::PI;

#[mcp_fn(start = [-1.2, 1.0])]
fn rosenbrock<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [10 * (y - x * x), 1 - x]
}

/// A local minimum of the merit near (11.4, −0.9).
#[mcp_fn(start = [0.5, -2.0])]
fn freudenstein_roth<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [-13 + x + ((5 - y) * y - 2) * y, -29 + x + ((y + 1) * y - 14) * y]
}

/// `J` has rank 2 at the root.
#[mcp_fn(start = [3.0, -1.0, 0.0, 1.0])]
fn powell_singular<D: Scalar>([a, b, c, d]: [Real<D>; 4]) -> [Real<D>; 4] {
    let (r5, r10) = (5_f64.sqrt(), 10_f64.sqrt());
    [a + 10 * b, r5 * (c - d), (b - 2 * c).powi(2), r10 * (a - d).powi(2)]
}

pub(crate) fn powell_singular_model() -> Result<impl Model + 'static, ModelError> {
    PowellSingular::new()
}

/// The root is near (1.098e-5, 9.106).
#[mcp_fn(start = [0.0, 1.0])]
fn powell_badly_scaled<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [1e4 * x * y - 1, (-x).exp() + (-y).exp() - 1.0001]
}

#[mcp_fn(start = [-1.0, 0.0, 0.0])]
fn helical_valley<D: Scalar>([x, y, z]: [Real<D>; 3]) -> [Real<D>; 3] {
    let turns = atan2(y, x) / (2.0 * PI);
    [10 * (z - 10 * turns), 10 * (hypot(x, y) - 1), z]
}

/// `F_i = (3 − 2 z_i) z_i − z_{i−1} − 2 z_{i+1} + 1`, `−½ <= z <= ½`.
struct Broyden(Shape);

impl Broyden {
    fn new(n: usize) -> Result<Self, ModelError> {
        let rows = Set::count("rows", n);
        let z = Variable::new("z").over(&[&rows]).lower(-0.5).upper(0.5).start(-0.4);
        let f = Equation::new("f").over(&[&rows]).complements("z");
        Ok(Broyden(Shape::builder().variable(z).equation(f).build()?))
    }
}

impl Model for Broyden {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let (z, n) = (read.var(i), self.0.n());
        (3 - 2 * z) * z - when(i > 0, || read.var(i - 1)) - when(i + 1 < n, || 2 * read.var(i + 1))
            + 1
    }
}

/// Ions in water with barium sulphate: products of concentrations are given.
#[mcp_fn(start = 1.0)]
fn wall<D: Scalar>([ba, so4, baoh, oh, hso4, h]: [Real<D>; 6]) -> [Real<D>; 6] {
    [
        ba * so4 - 1,
        baoh / ba / oh - 4.8,
        hso4 / so4 / h - 0.98,
        h * oh - 1,
        ba + 1e-7 * baoh - so4 - 1e-5 * hso4,
        2 * ba + 1e-7 * baoh + 1e-2 * h - 2 * so4 - 1e-5 * hso4 - 1e-2 * oh,
    ]
}

const MGH: &str = "Moré, Garbow & Hillstrom (1981), ACM TOMS 7";

pub(super) fn instances() -> Result<Vec<Instance>, ModelError> {
    Ok(vec![
        Instance::new("rosenbrock", MGH, Rosenbrock::new()?).solved_by([1.0, 1.0]),
        Instance::new("freudroth", MGH, FreudensteinRoth::new()?).solved_by([5.0, 4.0]),
        Instance::new("powellsing", MGH, PowellSingular::new()?).solved_by([0.0; 4]),
        Instance::new("powellbad", MGH, PowellBadlyScaled::new()?),
        Instance::new("helical", MGH, HelicalValley::new()?).solved_by([1.0, 0.0, 0.0]),
        Instance::new("broyden-box", "Broyden (1965), Math. Comp. 19, in a box", Broyden::new(30)?),
        Instance::new("wallmcp", "Wall; GAMS model library and MCPLIB", Wall::new()?),
    ])
}
