//! Small problems for the tests of this module.

use crate::model::{Equation, Model, Reader, Set, Shape, Variable};
use crate::problem::{AdProblem, Pattern, Problem};
use crate::scalar::{Real, Scalar};
use crate::solver::{DomainFault, Fill, Method, Solution, Stats, Status, examine};
use std::io::{self, Write};
use std::sync::Arc;

/// `F = M z + q` with any entries, NaN included.
pub(super) struct Linear {
    pub(super) shape: Arc<Shape>,
    pattern: Pattern,
    m: Vec<f64>,
    q: Vec<f64>,
}

impl Linear {
    /// From the entries `(row, column, value)`.
    pub(super) fn new(
        shape: impl Into<Arc<Shape>>,
        entries: &[(usize, usize, f64)],
        q: &[f64],
    ) -> Self {
        let shape = shape.into();
        let mut columns = vec![Vec::new(); shape.n()];
        for &(i, j, _) in entries {
            columns[j].push(i);
        }
        let pattern = Pattern::from_columns(columns);
        let mut m = vec![0.0; pattern.nnz()];
        for &(i, j, value) in entries {
            m[pattern.position(i, j).unwrap()] += value;
        }
        Linear { shape, pattern, m, q: q.to_vec() }
    }

    pub(super) fn diagonal(shape: Shape, m: &[f64], q: &[f64]) -> Self {
        let entries: Vec<_> = m.iter().enumerate().map(|(i, &m)| (i, i, m)).collect();
        Self::new(shape, &entries, q)
    }

    /// As if a solve had ended at `z` with this status.
    pub(super) fn ended(&mut self, z: &[f64], status: Status) -> Solution {
        let mut f = vec![0.0; z.len()];
        self.evaluate(z, Some(&mut f), None);
        let mut stats = Stats::default();
        (stats.iterations, stats.residual_evaluations, stats.jacobian_evaluations) = (1, 3, 2);
        (stats.factorisations, stats.certificate_evaluations) = (1, 1);
        Solution {
            shape: Arc::clone(&self.shape),
            z: z.to_vec(),
            f,
            status,
            certificate: examine(self, z).unwrap(),
            stats,
            fill: Fill::default(),
            method: Method::NewtonFb,
            fault: None,
            start_was_moved: false,
            stages: Vec::new(),
            diagnosis: None,
        }
    }
}

impl Problem for Linear {
    fn shape(&self) -> &Arc<Shape> {
        &self.shape
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        if let Some(f) = f {
            f.copy_from_slice(&self.q);
            self.pattern.entries().for_each(|(k, i, j)| f[i] += self.m[k] * z[j]);
        }
        if let Some(jac) = jac {
            jac.copy_from_slice(&self.m);
        }
    }
}

/// `z_i − i ⟂ z_i >= 0`: the first ones at their bound.
pub(super) fn linear(n: usize) -> Linear {
    let shape = Shape::anonymous(&vec![0.0; n], &vec![f64::INFINITY; n], &vec![0.5; n]).unwrap();
    let q: Vec<f64> = (0..n).map(|i| 1.0 - i as f64).collect();
    Linear::diagonal(shape, &vec![1.0; n], &q)
}

/// One plant, two markets, with shipments, a capacity, prices, and money fixed at 1:
///
/// `w + c_j − p_j ⟂ x_j >= 0`, `k − Σx ⟂ 0 <= w <= 1`, `x_j − d_j ⟂ p_j` free.
pub(super) fn transport() -> Linear {
    let markets = Set::new("markets", ["new-york", "topeka"]).unwrap();
    let shipment = Variable::new("x").over(&[&markets]).lower(0.0).start(1.0);
    let shape = Shape::builder()
        .variable(shipment.unit("cases").about("shipment"))
        .variable(Variable::new("w").lower(0.0).upper(1.0).unit("$/case"))
        .variable(Variable::new("p").over(&[&markets]).unit("$/case").about("price"))
        .variable(Variable::new("money").fixed(1.0))
        .equation(Equation::new("profit").over(&[&markets]).complements("x"))
        .equation(Equation::new("supply").complements("w"))
        .equation(Equation::new("demand").over(&[&markets]).complements("p"))
        .build()
        .unwrap();
    let entries = [
        (0, 2, 1.0),
        (0, 3, -1.0),
        (1, 2, 1.0),
        (1, 4, -1.0),
        (2, 0, -1.0),
        (2, 1, -1.0),
        (3, 0, 1.0),
        (4, 1, 1.0),
    ];
    Linear::new(shape, &entries, &[0.25, 0.5, 300.0, -325.0, 0.0, 0.0])
}

/// `x³ − 8 = 0` from 1, over one label.
pub(super) fn cubic(label: &str) -> AdProblem<impl Model> {
    struct Cubic(Shape);
    impl Model for Cubic {
        fn shape(&self) -> &Shape {
            &self.0
        }
        fn row<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
            read.var(0).powi(3) - 8.0
        }
    }
    let set = Set::new("s", [label]).unwrap();
    let shape = Shape::builder()
        .variable(Variable::new("x").over(&[&set]).lower(0.0).start(1.0))
        .equation(Equation::new("f").over(&[&set]).complements("x"))
        .build()
        .unwrap();
    AdProblem::new(Cubic(shape)).unwrap()
}

/// A fault of equation `equation` at `z`.
pub(super) fn fault(
    equation: usize,
    variable: Option<usize>,
    value: f64,
    z: &[f64],
) -> DomainFault {
    DomainFault { equation, variable, value, z: z.to_vec() }
}

/// A writer that takes some lines, then fails.
#[derive(Debug)]
pub(super) struct Broken {
    pub(super) lines: usize,
}

impl Write for Broken {
    fn write(&mut self, text: &[u8]) -> io::Result<usize> {
        let ends = text.split(|byte| *byte == b'\n').count() - 1;
        if self.lines == 0 {
            return Err(io::Error::other("disk full"));
        }
        self.lines -= ends.min(self.lines);
        Ok(text.len())
    }
    fn flush(&mut self) -> io::Result<()> {
        if self.lines == 0 { Err(io::Error::other("disk full")) } else { Ok(()) }
    }
}
