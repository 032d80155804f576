//! Nonlinear problems in another order, place, sign or company: the same answers. Affine ones are in
//! `tests/conformance.rs`, binary units in `tests/invariance.rs`, units of
//! any kind in `scaling`.

use crate::common::{INF, dense, evaluate, solve, solve_from};
use mcp_core::testing::{self, Known};
use mcp_core::{AdProblem, Engine, Method, Model, Options, Problem, Reader, Real, Scalar, Shape};

/// Pair `i` of the result is pair `order[i]`, as `y_i = sign_i z − shift_i`.
struct Change {
    order: Vec<usize>,
    sign: Vec<f64>,
    shift: Vec<f64>,
}

impl Change {
    fn none(n: usize) -> Self {
        Change { order: (0..n).collect(), sign: vec![1.0; n], shift: vec![0.0; n] }
    }

    fn there(&self, z: &[f64]) -> Vec<f64> {
        (0..z.len()).map(|i| self.sign[i] * z[self.order[i]] - self.shift[i]).collect()
    }

    fn back(&self, y: &[f64]) -> Vec<f64> {
        let mut z = vec![0.0; y.len()];
        for i in 0..y.len() {
            z[self.order[i]] = self.sign[i] * (y[i] + self.shift[i]);
        }
        z
    }

    /// Solves the changed problem; the answer in the old variables.
    fn solve(&self, known: &mut Known, start: &[f64], options: &Options) -> Option<Vec<f64>> {
        let n = start.len();
        let bounds = known.problem.shape().bounds();
        let bounds: Vec<_> = (0..n)
            .map(|i| {
                let (l, u) = (bounds.lower()[self.order[i]], bounds.upper()[self.order[i]]);
                let (l, u) = if self.sign[i] > 0.0 { (l, u) } else { (-u, -l) };
                (l - self.shift[i], u - self.shift[i])
            })
            .collect();
        let start = self.there(start);
        let mut changed = dense(&bounds, &start, |y, f, jac| {
            let (g, h) = evaluate(&mut *known.problem, &self.back(y));
            for i in 0..n {
                f[i] = self.sign[i] * g[self.order[i]];
                for j in 0..n {
                    let entry = h[self.order[i] + n * self.order[j]];
                    jac[i + n * j] = self.sign[i] * self.sign[j] * entry;
                }
            }
        });
        let solution = solve(&mut changed, options);
        solution.is_solved().then(|| self.back(&solution.z))
    }
}

fn problems() -> Vec<Known> {
    let make = [testing::kojima_shindo, testing::josephy, testing::watson4, testing::rosen_suzuki];
    make.iter().map(|make| make().unwrap()).collect()
}

fn is_known(known: &Known, z: &[f64]) -> bool {
    let near =
        |s: &Vec<f64>| z.iter().zip(s).all(|(z, s)| (z - s).abs() <= 1e-6 * s.abs().max(1.0));
    known.solutions.iter().any(near)
}

#[test]
fn order_place_and_sign_do_not_matter() {
    let options = Options::new(Method::Robust);
    for mut known in problems() {
        for start in known.starts.clone() {
            let n = start.len();
            let mut reversed = Change::none(n);
            reversed.order.reverse();
            let mut mirrored = Change::none(n);
            mirrored.sign = (0..n).map(|i| if i % 2 == 0 { -1.0 } else { 1.0 }).collect();
            let mut moved = Change::none(n);
            moved.shift = (0..n).map(|i| 3.0 - i as f64).collect();
            for (what, change) in [("order", reversed), ("sign", mirrored), ("place", moved)] {
                let case = format!("{} from {start:?}: {what}", known.name);
                let z = change.solve(&mut known, &start, &options);
                assert!(z.is_some_and(|z| is_known(&known, &z)), "{case}");
            }
        }
    }
}

#[test]
fn a_decoupled_pair_does_not_matter() {
    let options = Options::new(Method::Robust);
    for mut known in problems() {
        for start in known.starts.clone() {
            let n = start.len();
            let bounds = known.problem.shape().bounds();
            let mut pairs: Vec<_> =
                bounds.lower().iter().copied().zip(bounds.upper().iter().copied()).collect();
            pairs.push((0.0, INF));
            let mut joined = dense(&pairs, &[&start[..], &[7.0]].concat(), |z, f, jac| {
                let (g, h) = evaluate(&mut *known.problem, &z[..n]);
                f[..n].copy_from_slice(&g);
                f[n] = z[n] * z[n] - 4.0;
                jac.fill(0.0);
                for j in 0..n {
                    jac[(n + 1) * j..(n + 1) * j + n].copy_from_slice(&h[n * j..n * (j + 1)]);
                }
                jac[(n + 1) * (n + 1) - 1] = 2.0 * z[n];
            });
            let solution = solve(&mut joined, &options);
            assert!(solution.is_solved(), "{} {start:?}", known.name);
            assert!((solution.z[n] - 2.0).abs() < 1e-8);
            assert!(is_known(&known, &solution.z[..n]), "{} {:?}", known.name, solution.z);
        }
    }
}

/// `F ⟂ l <= z <= u` is `F + λ ⟂ z >= l` with `u − z ⟂ λ >= 0`.
#[test]
fn a_double_bound_is_two_single_ones() {
    let options = Options::new(Method::Robust);
    for (l, u) in [(0.0, 1.0), (-2.0, 0.5), (1.5, 4.0), (2.5, 3.5), (0.0, 100.0)] {
        for start in [l, 0.5 * (l + u), u] {
            // z³ − z − 6: one root, 2, and increasing beyond 1/√3.
            let f = |z: f64| (z * z * z - z - 6.0, 3.0 * z * z - 1.0);
            let mut boxed = crate::common::scalar((l, u), start, f);
            let boxed = solve(&mut boxed, &options);
            let mut split = dense(&[(l, INF), (0.0, INF)], &[start, 0.0], |z, g, jac| {
                let (value, slope) = f(z[0]);
                g.copy_from_slice(&[value + z[1], u - z[0]]);
                jac.copy_from_slice(&[slope, -1.0, 1.0, 0.0]);
            });
            let split = solve(&mut split, &options);
            let exact = 2_f64.clamp(l, u);
            for solution in [&boxed, &split] {
                assert!(solution.is_solved(), "[{l}, {u}] {start}");
                assert!((solution.z[0] - exact).abs() < 1e-8, "[{l}, {u}] {start}");
            }
            assert!((split.z[1] - (-f(exact).0).max(0.0)).abs() < 1e-7, "λ is the rent");
        }
    }
}

/// `z_i² + ½ z_{i+1} − c_i ⟂ z_i >= 0` as one function: 1, 2, 4, 8 or 16 lanes by its size.
struct Ring<const N: usize>(Shape);

impl<const N: usize> Model for Ring<N> {
    const WHOLE: Option<usize> = Some(N);

    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let z = read.var(i);
        z * z + 0.5 * read.var((i + 1) % N) - (i as f64 - 1.0)
    }
    fn whole<D: Scalar>(&self, read: &Reader<'_, D>, f: &mut [Real<D>]) {
        for i in 0..N {
            f[i] = self.row(0, i, read);
        }
    }
}

/// The same row by row.
struct ByRows<const N: usize>(Ring<N>);

impl<const N: usize> Model for ByRows<N> {
    fn shape(&self) -> &Shape {
        self.0.shape()
    }
    fn row<D: Scalar>(&self, family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        self.0.row(family, i, read)
    }
}

fn ring_answers<const N: usize>() {
    let ring = || Ring::<N>(Shape::anonymous(&[0.0; N], &[INF; N], &[1.0; N]).unwrap());
    let options = Options::new(Method::Robust);
    let mut answers = Vec::new();
    for engine in [Engine::Jet, Engine::NumDual] {
        let mut lanes = AdProblem::with_engine(ring(), engine).unwrap();
        let mut rows = AdProblem::with_engine(ByRows(ring()), engine).unwrap();
        answers.push(solve_from(&mut lanes, &[1.0; N], &options));
        answers.push(solve_from(&mut rows, &[1.0; N], &options));
    }
    for answer in &answers {
        assert!(answer.is_solved(), "{N}: {}", answer.status);
        assert_eq!(answer.stats.iterations, answers[0].stats.iterations, "{N}");
        let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-14 * b.abs().max(1.0);
        assert!(answer.z.iter().zip(&answers[0].z).all(close), "{N}: {:?}", answer.z);
    }
}

#[test]
fn lanes_rows_and_engines_do_not_matter() {
    ring_answers::<1>();
    ring_answers::<2>();
    ring_answers::<3>();
    ring_answers::<4>();
    ring_answers::<7>();
    ring_answers::<8>();
    ring_answers::<13>();
    ring_answers::<16>();
    ring_answers::<17>();
}
