//! Problems in other units: rows and columns multiplied by random powers of ten.

use super::archive::RANDOM;
use super::{Instance, economics, lcps, small};
use crate::error::ModelError;
use crate::model::Shape;
use crate::problem::{Derived, Pattern, Problem};
use std::sync::Arc;

/// Units of the equations and of the variables: `G(y) = R F(C y)` for the solution `y = C⁻¹ z`,
/// with positive diagonal `R` and `C`.
#[derive(Debug)]
pub(super) struct Scaling {
    rows: Vec<f64>,
    columns: Vec<f64>,
}

impl Scaling {
    /// `C y`.
    pub(super) fn to_original(&self, y: &[f64]) -> Vec<f64> {
        y.iter().zip(&self.columns).map(|(y, c)| c * y).collect()
    }

    /// `C⁻¹ z`.
    pub(super) fn to_scaled(&self, z: &[f64]) -> Vec<f64> {
        z.iter().zip(&self.columns).map(|(z, c)| z / c).collect()
    }
}

/// A problem in the units of a [`Scaling`].
pub(super) struct Rescaled<'a> {
    original: Box<dyn Problem + 'a>,
    scaling: Arc<Scaling>,
    shape: Arc<Shape>,
    /// `C y`.
    z: Vec<f64>,
}

impl<'a> Rescaled<'a> {
    /// Starting at `start`, in the new units.
    pub(super) fn new(
        original: Box<dyn Problem + 'a>,
        scaling: Arc<Scaling>,
        start: &[f64],
    ) -> Result<Self, ModelError> {
        let mut shape = Shape::clone(original.shape());
        let lower = scaling.to_scaled(shape.bounds().lower());
        let upper = scaling.to_scaled(shape.bounds().upper());
        shape.set_bounds(&lower, &upper)?;
        shape.set_start(start)?;
        Ok(Rescaled { original, scaling, shape: Arc::new(shape), z: vec![0.0; start.len()] })
    }
}

impl Problem for Rescaled<'_> {
    fn shape(&self) -> &Arc<Shape> {
        &self.shape
    }
    fn pattern(&self) -> &Pattern {
        self.original.pattern()
    }
    /// `G = R F(C y)`, `G' = R F'(C y) C`.
    fn evaluate(&mut self, y: &[f64], mut f: Option<&mut [f64]>, mut jac: Option<&mut [f64]>) {
        let Scaling { rows, columns } = &*self.scaling;
        for (z, (y, c)) in self.z.iter_mut().zip(y.iter().zip(columns)) {
            *z = c * y;
        }
        self.original.evaluate(&self.z, f.as_deref_mut(), jac.as_deref_mut());
        for (f, r) in f.into_iter().flatten().zip(rows) {
            *f *= r;
        }
        if let Some(jac) = jac {
            for (k, i, j) in self.original.pattern().entries() {
                jac[k] = rows[i] * jac[k] * columns[j];
            }
        }
    }
    fn derived(&self, y: &[f64]) -> Derived {
        self.original.derived(&self.scaling.to_original(y))
    }
}

/// The problems that are scaled.
const ORIGINALS: [&str; 23] = [
    "kojshin-1",
    "kojshin-3",
    "josephy-1",
    "mathinum-1",
    "nash10-2",
    "nash5-2",
    "oligomcp",
    "powell-kkt-1",
    "powellsing",
    "watson4-3",
    "scarfmcp-1",
    "hansmcp-1",
    "munson1",
    "broyden-box",
    "murty-16",
    "fathi-16",
    "ahn-32",
    "rnd-spd-30-deg",
    "rnd-psd-skew-30",
    "rnd-psd-lowrank-30",
    "rnl-mono-20",
    "rnl-nonmono-60",
    "rosenbrock",
];

/// Each of them with factors `10^U(−4, 4)` (`~rc4`) and `10^U(−8, 8)` (`~rc8`).
pub(super) fn instances() -> Result<Vec<Instance>, ModelError> {
    let originals = [small::instances()?, economics::instances()?, lcps::instances()?].concat();
    let mut all = Vec::new();
    for name in ORIGINALS {
        for original in originals.iter().filter(|original| original.name == name) {
            for exponent in [4, 8] {
                let name = format!("{name}~rc{exponent}");
                let get = |what| RANDOM.get(&format!("{name}/{what}"));
                let scaling = Scaling { rows: get("rows"), columns: get("columns") };
                all.push(original.scaled(name, scaling));
            }
        }
    }
    Ok(all)
}
