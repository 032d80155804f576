//! Step problems by hand, and their solution.

use mcp_core::dynamics::step_options;
use mcp_core::{
    AdProblem, Equation, Method, Model, Options, Problem, Reader, Real, Scalar, Set, Shape,
    Solution, Solver, Variable,
};

/// The equations of a step problem.
pub(super) trait Equations {
    /// Lower and upper bounds of the unknowns.
    fn bounds(&self) -> Vec<[f64; 2]>;

    fn row<D: Scalar>(&self, i: usize, read: &Reader<'_, D>) -> Real<D>;
}

/// No bounds, those of an impulse, of a relay.
pub(super) const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
pub(super) const PUSH: [f64; 2] = [0.0, f64::INFINITY];
pub(super) const RELAY: [f64; 2] = [-1.0, 1.0];

/// One unknown: `m λ + q`.
pub(super) struct One {
    pub(super) bounds: [f64; 2],
    pub(super) m: f64,
    pub(super) q: f64,
}

impl Equations for One {
    fn bounds(&self) -> Vec<[f64; 2]> {
        vec![self.bounds]
    }
    fn row<D: Scalar>(&self, _: usize, read: &Reader<'_, D>) -> Real<D> {
        self.m * read.var(0) + self.q
    }
}

/// Two unknowns in both equations.
pub(super) struct Two {
    pub(super) bounds: [[f64; 2]; 2],
    pub(super) m: [[f64; 2]; 2],
    pub(super) q: [f64; 2],
}

impl Equations for Two {
    fn bounds(&self) -> Vec<[f64; 2]> {
        self.bounds.to_vec()
    }
    fn row<D: Scalar>(&self, i: usize, read: &Reader<'_, D>) -> Real<D> {
        (self.m[i][0] * read.var(0) + self.m[i][1] * read.var(1)) + self.q[i]
    }
}

/// Normal and tangential impulse of one contact: `|r_t| <= μ r_n` against the slip.
pub(super) struct Coulomb {
    pub(super) mu: f64,
    pub(super) m: [[f64; 2]; 2],
    pub(super) q: [f64; 2],
}

impl Equations for Coulomb {
    fn bounds(&self) -> Vec<[f64; 2]> {
        vec![PUSH, FREE]
    }
    fn row<D: Scalar>(&self, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let (rn, rt) = (read.var(0), read.var(1));
        let rate = (self.m[i][0] * rn + self.m[i][1] * rt) + self.q[i];
        if i == 0 {
            return rate;
        }
        let limit = self.mu * rn;
        rt - (rt - 1.0 / self.m[1][1] * rate).clamp(-limit, limit)
    }
}

/// How a problem was solved, and what its functions cost.
pub(super) struct Solved {
    pub(super) z: Vec<f64>,
    pub(super) f: Vec<f64>,
    pub(super) iterations: usize,
    pub(super) residual: f64,
    pub(super) nonzeros: usize,
    /// Of one `F` and one `J`.
    pub(super) operations: u64,
}

/// Solves from `start`: by the min map, and where that fails by `Robust`.
pub(super) fn solve<E: Equations>(equations: E, start: &[f64]) -> Solved {
    let bounds = equations.bounds();
    let labels = Set::new("rows", (0..bounds.len()).map(|i| i.to_string())).unwrap();
    let of = |side: usize| bounds.iter().map(|bound| bound[side]).collect::<Vec<_>>();
    let unknown = Variable::new("r").over(&[&labels]).lower(of(0)).upper(of(1));
    let law = Equation::new("y").over(&[&labels]).complements("r");
    let shape = Shape::builder().variable(unknown).equation(law).build().unwrap();
    let mut problem = AdProblem::new(ByHand { shape, equations }).unwrap();
    let robust = Options::new(Method::Robust).with(|o| o.tol_relative = 1e-12);
    let (mut iterations, mut last) = (0, None);
    for options in [step_options(), robust] {
        let solution: Solution =
            Solver::new(options).unwrap().solve_from(&mut problem, start).unwrap().clone();
        iterations += solution.stats.iterations;
        let is_solved = solution.is_solved();
        last = Some(solution);
        if is_solved {
            break;
        }
    }
    let solution = last.unwrap();
    assert!(solution.is_solved(), "{}", solution.status);
    Solved {
        iterations,
        residual: solution.certificate.natural_residual,
        nonzeros: problem.pattern().nnz(),
        operations: problem.operations().total() + problem.jacobian_operations().unwrap(),
        z: solution.z,
        f: solution.f,
    }
}

struct ByHand<E> {
    shape: Shape,
    equations: E,
}

impl<E: Equations> Model for ByHand<E> {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        self.equations.row(i, read)
    }
}
