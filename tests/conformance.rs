//! Every method on every known problem, and on boxes of every kind in any order: judged by an
//! independent certificate. Failures are listed, so that an improvement shows as well as a
//! regression.

mod common;

use common::{FREE, INF, NONNEGATIVE, affine, check_honest, dense, siconos, solve, solve_from};
use mcp_core::testing::{self, Known};
use mcp_core::{
    AdProblem, Equation, Linear, Method, Model, ModelError, Options, Reader, Real, Scalar, Set,
    Shape, Status, Variable,
};

/// Defaults with the tolerance and the iterations of the Newton methods.
fn options(method: Method) -> Options {
    Options::new(method).with(|o| {
        o.tol = Some(1e-10);
        o.max_iterations = 1000;
    })
}

/// Runs that do not end in a solution: problem, start, method, status. Everything else is solved.
///
/// Billups from starts below 1 is built to trap descent on the merit. Josephy from (100, …) is solved
/// by the first method only with the first step 2 of Siconos. Hilbert matrices are nearly singular:
/// min-map directions turn into gradient steps.
const FAILURES: [(&str, usize, Method, Status); 12] = [
    ("josephy", 3, Method::NewtonFb, Status::Stalled),
    ("josephy", 3, Method::OldFb, Status::Stalled),
    ("hilbert-8", 0, Method::NewtonMinFb, Status::Stalled),
    ("billups", 0, Method::NewtonFb, Status::StationaryPoint),
    ("billups", 0, Method::NewtonMinFb, Status::StationaryPoint),
    ("billups", 0, Method::OldFb, Status::StationaryPoint),
    ("billups", 1, Method::NewtonFb, Status::StationaryPoint),
    ("billups", 1, Method::NewtonMinFb, Status::StationaryPoint),
    ("billups", 1, Method::OldFb, Status::StationaryPoint),
    ("billups", 2, Method::NewtonFb, Status::StationaryPoint),
    ("billups", 2, Method::NewtonMinFb, Status::StationaryPoint),
    ("billups", 2, Method::OldFb, Status::StationaryPoint),
];

/// Problems that are not affine: Lemke's method says so, from starts that are no solution.
const NONLINEAR: [&str; 6] =
    ["kojima-shindo", "josephy", "watson-4", "rosen-suzuki", "billups", "log-equation"];

fn problems() -> Result<Vec<Known>, ModelError> {
    let mut problems = testing::all()?;
    problems.extend([
        testing::billups()?,
        testing::log_equation()?,
        testing::murty(40)?,
        testing::fathi(40)?,
        testing::ahn(200)?,
        testing::obstacle(16)?,
    ]);
    Ok(problems)
}

#[test]
fn every_run_ends_as_listed_and_is_judged_independently() {
    let mut endings = Vec::new();
    for mut known in problems().unwrap() {
        for (k, start) in known.starts.clone().iter().enumerate() {
            for method in Method::ALL {
                let case = format!("{} start {k} {method}", known.name);
                let solution = solve_from(&mut known.problem, start, &options(method));
                check_honest(&mut known.problem, &solution, &options(method), &case);
                assert!(solution.certificate.is_finite, "{case}");
                if method == Method::Lemke && NONLINEAR.contains(&known.name.as_str()) {
                    assert_eq!(solution.status, Status::NotAffine, "{case}");
                } else if !solution.is_solved() {
                    endings.push((known.name.clone(), k, method, solution.status));
                }
            }
        }
    }
    let listed: Vec<_> = FAILURES
        .iter()
        .map(|&(name, k, method, status)| (name.to_owned(), k, method, status))
        .collect();
    assert_eq!(endings, listed);
}

/// An affine problem with a P-matrix, so with one solution: free, lower, upper, boxed and fixed
/// variables in turn.
#[derive(Clone)]
struct Mixed {
    m: Vec<Vec<f64>>,
    q: Vec<f64>,
    bounds: Vec<(f64, f64)>,
    start: Vec<f64>,
}

impl Mixed {
    /// `n` variables; `seed` varies the numbers.
    fn new(n: usize, seed: usize) -> Self {
        let noise = |k: usize| ((k * 7919 + seed * 104_729) % 1009) as f64 / 504.5 - 1.0;
        let entry = |i: usize, j: usize| if i == j { 1.0 + n as f64 } else { noise(i * n + j) };
        let bound = |i: usize| match i % 5 {
            0 => FREE,
            1 => (noise(i) - 0.5, INF),
            2 => (-INF, noise(i) + 0.5),
            3 => (noise(i) - 0.1, noise(i) + 0.2),
            _ => (noise(i), noise(i)),
        };
        Mixed {
            m: (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect(),
            q: (0..n).map(|i| 2.0 * n as f64 * noise(i + 31)).collect(),
            bounds: (0..n).map(bound).collect(),
            start: (0..n).map(|i| 5.0 * noise(i + 57)).collect(),
        }
    }

    fn solve(&self, method: Method) -> Vec<f64> {
        let mut problem = affine(self.m.clone(), self.q.clone(), &self.bounds, &self.start);
        let solution = solve_from(&mut problem, &self.start, &options(method));
        check_honest(&mut problem, &solution, &options(method), method.name());
        assert_eq!(solution.status, Status::Solved, "{method} {:?}", self.bounds);
        solution.z
    }

    /// Pair `order[i]` becomes pair `i`.
    fn permuted(&self, order: &[usize]) -> Self {
        let pick = |list: &[f64]| order.iter().map(|&i| list[i]).collect::<Vec<_>>();
        Mixed {
            m: order.iter().map(|&i| pick(&self.m[i])).collect(),
            q: pick(&self.q),
            bounds: order.iter().map(|&i| self.bounds[i]).collect(),
            start: pick(&self.start),
        }
    }

    /// `z_i → −z_i`, `F_i → −F_i`, bounds exchanged, where `sign` is −1.
    fn flipped(&self, sign: &[f64]) -> Self {
        let mut flipped = self.clone();
        for i in 0..self.q.len() {
            for j in 0..self.q.len() {
                flipped.m[i][j] *= sign[i] * sign[j];
            }
            flipped.q[i] *= sign[i];
            flipped.start[i] *= sign[i];
            if sign[i] < 0.0 {
                flipped.bounds[i] = (-self.bounds[i].1, -self.bounds[i].0);
            }
        }
        flipped
    }

    /// `z → z + c`.
    fn shifted(&self, c: &[f64]) -> Self {
        let mut shifted = self.clone();
        for i in 0..c.len() {
            shifted.q[i] -= self.m[i].iter().zip(c).map(|(m, c)| m * c).sum::<f64>();
            shifted.bounds[i] = (self.bounds[i].0 + c[i], self.bounds[i].1 + c[i]);
            shifted.start[i] += c[i];
        }
        shifted
    }

    /// Two copies that know nothing of each other, pair by pair.
    fn twice(&self) -> Self {
        let n = self.q.len();
        let double = |list: &[f64]| list.iter().flat_map(|&x| [x, x]).collect::<Vec<_>>();
        let entry = |i: usize, j: usize| if i % 2 == j % 2 { self.m[i / 2][j / 2] } else { 0.0 };
        Mixed {
            m: (0..2 * n).map(|i| (0..2 * n).map(|j| entry(i, j)).collect()).collect(),
            q: double(&self.q),
            bounds: self.bounds.iter().flat_map(|&b| [b, b]).collect(),
            start: double(&self.start),
        }
    }
}

fn assert_near(a: &[f64], b: &[f64], case: &str) {
    assert_eq!(a.len(), b.len());
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-9), "{case}: {a:?} {b:?}");
}

#[test]
fn bounds_of_every_kind_are_solved_in_any_order_sign_and_place() {
    for (n, seed) in [(5, 1), (7, 2), (13, 3), (24, 4), (50, 5)] {
        let problem = Mixed::new(n, seed);
        let reference = problem.solve(Method::NewtonFb);
        let active =
            reference.iter().zip(&problem.bounds).filter(|(z, b)| **z == b.0 || **z == b.1);
        assert!((n / 5 + 1..n).contains(&active.count()), "some bounds bind, some do not");
        for method in Method::ALL {
            let case = format!("{method} n = {n}");
            assert_near(&problem.solve(method), &reference, &case);

            let order: Vec<usize> = (0..n).map(|i| (i * 3 + 2) % n).collect();
            let order = if n % 3 == 0 { (0..n).rev().collect() } else { order };
            let expected: Vec<f64> = order.iter().map(|&i| reference[i]).collect();
            assert_near(&problem.permuted(&order).solve(method), &expected, &case);

            let sign: Vec<f64> = (0..n).map(|i| if i % 3 == 1 { 1.0 } else { -1.0 }).collect();
            let expected: Vec<f64> = reference.iter().zip(&sign).map(|(z, s)| z * s).collect();
            assert_near(&problem.flipped(&sign).solve(method), &expected, &case);

            let c: Vec<f64> = (0..n).map(|i| i as f64 - 3.0).collect();
            let expected: Vec<f64> = reference.iter().zip(&c).map(|(z, c)| z + c).collect();
            assert_near(&problem.shifted(&c).solve(method), &expected, &case);

            let expected: Vec<f64> = reference.iter().flat_map(|&z| [z, z]).collect();
            assert_near(&problem.twice().solve(method), &expected, &case);
        }
    }
}

#[test]
fn a_flipped_problem_without_boxes_takes_the_mirrored_path_bit_for_bit() {
    for method in Method::ALL {
        let mut problem = Mixed::new(14, 6);
        for bound in problem.bounds.iter_mut().skip(3).step_by(5) {
            bound.1 = INF;
        }
        let mirror = problem.flipped(&[-1.0; 14]);
        let mirrored: Vec<f64> = mirror.solve(method).iter().map(|z| -z).collect();
        assert_eq!(problem.solve(method), mirrored, "{method}");
    }
}

#[test]
fn starts_far_outside_the_box_are_moved_into_it_and_tiny_boxes_are_solved() {
    for method in Method::ALL {
        for width in [1e-3, 1e-9, 1e-15] {
            let mut problem = Mixed::new(6, 7);
            problem.bounds = (0..6).map(|i| (f64::from(i), f64::from(i) + width)).collect();
            let inside = problem.solve(method);
            problem.start = vec![-1e9, 1e9, -1e300, 1e300, 0.0, -1e9];
            assert_near(&problem.solve(method), &inside, method.name());
            // The corner, by the sign of F at it.
            for (i, &(l, u)) in problem.bounds.iter().enumerate() {
                assert!(inside[i] == l || inside[i] == u, "{method} {width}: {inside:?}");
            }
        }
    }
}

#[test]
fn one_variable_has_the_solution_its_bounds_say() {
    // F = z − 3 and F = 3 − z + … decide where the bounds bind.
    let cases = [
        (FREE, 3.0),
        (NONNEGATIVE, 3.0),
        ((4.0, INF), 4.0),
        ((-INF, 2.0), 2.0),
        ((-INF, 4.0), 3.0),
        ((0.0, 1.0), 1.0),
        ((5.0, 6.0), 5.0),
        ((2.0, 4.0), 3.0),
        ((7.0, 7.0), 7.0),
        ((3.0, 3.0), 3.0),
        ((3.0, INF), 3.0),
    ];
    for method in Method::ALL {
        for (bounds, expected) in cases {
            for start in [-100.0, 0.0, 3.0, 100.0] {
                let mut problem = affine(vec![vec![1.0]], vec![-3.0], &[bounds], &[start]);
                let solution = solve(&mut problem, &options(method));
                assert_eq!(solution.status, Status::Solved, "{method} {bounds:?} {start}");
                assert!((solution.z[0] - expected).abs() <= 1e-10, "{method} {bounds:?} {start}");
            }
        }
    }
}

#[test]
fn a_problem_without_variables_is_solved() {
    for method in Method::ALL {
        for linear in Linear::ALL {
            let mut problem = dense(&[], &[], |_, _, _| ());
            let o = siconos(method).with(|o| o.linear = linear);
            for o in [o.clone().with(|o| o.criterion = mcp_core::Criterion::Stationarity), o] {
                let solution = solve(&mut problem, &o);
                assert_eq!(solution.status, Status::Solved, "{method} {linear}");
                assert_eq!((solution.z.len(), solution.stats.iterations), (0, 0));
                assert_eq!(solution.certificate.natural_residual, 0.0);
            }
        }
    }
}

/// `x_i − p + i ⟂ x_i >= 0` with a price `p` that is fixed and has no equation.
struct Price(Shape);

impl Model for Price {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        read.var(i + 1) - read.var(0) + i as f64
    }
}

#[test]
fn a_fixed_variable_needs_no_equation() {
    let goods = Set::count("goods", 5);
    let shape = Shape::builder()
        .variable(Variable::new("p").fixed(2.5))
        .variable(Variable::new("x").over(&[&goods]).lower(0.0))
        .equation(Equation::new("supply").over(&[&goods]).complements("x"))
        .build()
        .unwrap();
    let mut problem = AdProblem::new(Price(shape)).unwrap();
    for method in Method::ALL {
        let solution = solve_from(&mut problem, &[7.0; 6], &options(method));
        assert_eq!(solution.status, Status::Solved, "{method}");
        assert_near(&solution.z, &[2.5, 2.5, 1.5, 0.5, 0.0, 0.0], method.name());
        assert_eq!((solution.z[0], solution.f[0]), (2.5, 0.0), "no equation counts as F = 0");
    }
}
