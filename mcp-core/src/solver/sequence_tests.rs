use super::*;
use crate::linalg::{Grid, MultigridCg};
use crate::model::{Equation, Reader, Set, Shape, Variable};
use crate::scalar::{Real, Scalar};
use crate::solver::Method;

/// `−Δz + z³/2 + 10 ⟂ z >= 0` on the unit square, times `h²`; `z = 0.3` on the rim.
struct Membrane {
    shape: Shape,
    k: usize,
}

impl Membrane {
    fn on(k: usize) -> Result<Self, ModelError> {
        let nodes = Set::count("nodes", k * k);
        let shape = Shape::builder()
            .variable(Variable::new("z").over(&[&nodes]).lower(0.0).start(0.3))
            .equation(Equation::new("force").over(&[&nodes]).complements("z"))
            .build()?;
        Ok(Membrane { shape, k })
    }
}

impl Model for Membrane {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _: usize, p: usize, read: &Reader<'_, D>) -> Real<D> {
        let (k, h) = (self.k, 1.0 / (self.k as f64 + 1.0));
        let (i, j, z) = (p / k, p % k, read.var(p));
        let side = |inside: bool, q: usize| {
            if inside { read.var(q) } else { Real::from(0.3) }
        };
        4.0 * z
            - side(i > 0, p.wrapping_sub(k))
            - side(i + 1 < k, p + k)
            - side(j > 0, p.wrapping_sub(1))
            - side(j + 1 < k, p + 1)
            + h * h * (z * z * z * 0.5 + 10.0)
    }
}

fn prolong(coarse: &Solution, fine: &Membrane) -> Result<Vec<f64>, ModelError> {
    Grid::square(fine.k).interpolate(&coarse.z, Grid::square(coarse.z.len().isqrt()), 0.3)
}

const LEVELS: [usize; 4] = [7, 15, 31, 63];

#[test]
fn newton_counts_do_not_grow_with_the_grid() {
    for method in [Method::NewtonFb, Method::NewtonMinFb, Method::Robust] {
        let options = Options::new(method);
        let nested = solve_sequence(LEVELS.map(Membrane::on), prolong, &options).unwrap();
        for solution in &nested {
            assert!(solution.is_solved(), "{method}: {}", solution.status);
            let n = solution.z.len();
            assert!(solution.stats.iterations <= 9, "{method}, {n}: {:?}", solution.stats);
        }
        let cold = crate::solve(&Membrane::on(63).unwrap(), &options).unwrap();
        let difference = |(a, b): (&f64, &f64)| (a - b).abs();
        let worst = cold.z.iter().zip(&nested[3].z).map(difference).fold(0.0, f64::max);
        assert!(worst < 1e-7, "{method}: {worst:e}");
    }
}

#[test]
fn multigrid_and_cholesky_find_the_same_contact() {
    let options = Options::new(Method::NewtonMinFb).with(|o| o.tol = Some(1e-12));
    let multigrid = |fine: &Membrane| {
        let linear = Box::new(MultigridCg::new(Grid::square(fine.k)));
        Solver::with_linear_solver(options.clone(), linear)
    };
    let direct = solve_sequence(LEVELS.map(Membrane::on), prolong, &options).unwrap();
    let iterated = solve_sequence_with(LEVELS.map(Membrane::on), prolong, multigrid).unwrap();
    for (a, b) in direct.iter().zip(&iterated) {
        assert!(a.is_solved() && b.is_solved(), "{} {}", a.status, b.status);
        assert!(b.stats.iterations <= a.stats.iterations + 4, "{:?} {:?}", a.stats, b.stats);
        for (x, y) in a.z.iter().zip(&b.z) {
            assert!((x - y).abs() < 1e-8);
            assert_eq!(*x < 1e-9, *y < 1e-9);
        }
    }
}

#[test]
fn a_level_without_a_solution_gives_no_start() {
    let options = Options::new(Method::NewtonFb).with(|o| o.max_iterations = 3);
    let mut starts = 0;
    let count = |coarse: &Solution, fine: &Membrane| {
        starts += 1;
        prolong(coarse, fine)
    };
    let solutions = solve_sequence([15, 31].map(Membrane::on), count, &options).unwrap();
    assert_eq!(solutions.len(), 2);
    assert!(!solutions[0].is_solved());
    assert_eq!(starts, 0);
}

#[test]
fn a_start_of_another_length_is_an_error() {
    let options = Options::default();
    let solved =
        solve_sequence([7, 15].map(Membrane::on), |coarse, _| Ok(coarse.z.clone()), &options);
    assert!(matches!(solved, Err(ModelError::Length { .. })));
}
