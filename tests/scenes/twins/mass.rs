//! The bouncing mass of Zhuravlev and Ivanov, which is one effect.

use super::{Facts, On, Twin, bits};
use mcp_core::{
    AdProblem, Equation, Method, Model, Options, Problem, Reader, Real, Scalar, Set, Shape, Solver,
    Variable,
};

const H: f64 = 1e-3;
const KAPPA: f64 = 0.7;
const G: f64 = 9.81;

/// A step from position `x` and velocity `v`.
struct Step {
    shape: Shape,
    x: f64,
    v: f64,
}

impl Model for Step {
    const WHOLE: Option<usize> = Some(4);

    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let mut f = [Real::from(0.0); 4];
        self.whole(read, &mut f);
        f[i]
    }
    fn whole<D: Scalar>(&self, read: &Reader<'_, D>, f: &mut [Real<D>]) {
        let [p0, s0, p1, s1] = read.first();
        let [side, sign] = [p0, p1].map(|p| 2.0 * p - 1.0);
        let weight = G * side / (1.0 - KAPPA * side * sign);
        let loss = -KAPPA * side * sign * (self.v + H * weight);
        f[0] = self.x + H * (self.v + H * weight) + H * loss + s0;
        f[1] = 1.0 - p0;
        f[2] = self.v + H * weight + s1;
        f[3] = 1.0 - p1;
    }
}

pub(super) struct Mass {
    x: f64,
    v: f64,
    z: Vec<f64>,
}

impl Mass {
    pub(super) fn new(on: On<'_>) -> Self {
        assert!(on.has("zhuravlev_ivanov"));
        Mass { x: 1.0, v: 10.0, z: vec![0.0; 4] }
    }
}

impl Twin for Mass {
    fn step(&mut self) -> Facts {
        let rows = Set::new("rows", ["0", "1", "2", "3"]).unwrap();
        let shape = Shape::builder()
            .variable(Variable::new("z").over(&[&rows]).lower(0.0))
            .equation(Equation::new("f").over(&[&rows]).complements("z"))
            .build()
            .unwrap();
        let mut problem = AdProblem::new(Step { shape, x: self.x, v: self.v }).unwrap();
        let mut solver = Solver::new(Options::new(Method::Robust)).unwrap();
        let solution = solver.solve_from(&mut problem, &self.z).unwrap();
        assert!(solution.is_solved(), "{}", solution.status);
        let (z, f) = (&solution.z, &solution.f);
        (self.x, self.v) = (f[0] - z[1], f[2] - z[3]);
        self.z.clone_from(z);
        let state = [self.x, self.v, z[0], z[1], z[2], z[3]];
        let (iterations, residual) =
            (solution.stats.iterations, solution.certificate.natural_residual);
        Facts {
            unknowns: 4,
            active: 1,
            iterations,
            residual: residual.to_bits(),
            nonzeros: problem.pattern().nnz(),
            // And the two subtractions for the state.
            operations: problem.operations().total() + problem.jacobian_operations().unwrap() + 2,
            state: bits(&state),
        }
    }
}
