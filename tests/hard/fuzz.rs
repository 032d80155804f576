//! Random problems whose solutions are known by enumeration, and random starts of problems with
//! published solutions: no panic, no endless loop, no false claim. One seed, the same every run.

use super::check::check_sane;
use crate::common::{INF, affine, solve_from};
use mcp_core::testing::{self, Known, enumerate_affine};
use mcp_core::{Method, Options, Problem, Solver};

/// `splitmix64` ([SLF14], references in `mcp_core`).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in `[−1, 1)`.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / 2_f64.powi(52) - 1.0
    }

    /// One of `n`.
    fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    /// A small integer or a number with all its digits, over six orders of magnitude.
    fn entry(&mut self) -> f64 {
        match self.below(4) {
            0 => 0.0,
            1 => self.below(7) as f64 - 3.0,
            2 => self.unit() * 10_f64.powf(3.0 * self.unit()),
            _ => self.unit(),
        }
    }

    /// Bounds of every kind.
    fn bounds(&mut self) -> (f64, f64) {
        let (a, b) = (self.entry(), self.entry());
        match self.below(6) {
            0 => (-INF, INF),
            1 => (a, INF),
            2 => (-INF, a),
            3 => (a, a),
            4 => (0.0, INF),
            _ => (a.min(b), a.max(b)),
        }
    }
}

/// `M` of four kinds: arbitrary, skew plus diagonal, of rank one (in integers, so exactly), sparse.
fn matrix(random: &mut Random, n: usize) -> Vec<Vec<f64>> {
    let kind = random.below(4);
    let c: Vec<f64> = (0..n).map(|_| random.below(19) as f64 - 9.0).collect();
    let mut m: Vec<Vec<f64>> = (0..n).map(|_| (0..n).map(|_| random.entry()).collect()).collect();
    for i in 0..n {
        for j in 0..n {
            match kind {
                1 if i == j => m[i][j] = m[i][j].abs(),
                1 if i > j => m[i][j] = -m[j][i],
                2 => m[i][j] = c[i] * c[j],
                3 if random.below(2) == 0 => m[i][j] = 0.0,
                _ => {}
            }
        }
    }
    m
}

fn is_near(z: &[f64], solution: &[f64]) -> bool {
    z.iter().zip(solution).all(|(z, s)| (z - s).abs() <= 1e-4 * s.abs().max(1.0))
}

/// Whether every equation holds to `1e-8` of its terms with the certificate's weights `|z| + τ`, here
/// at most four times `|z|`, none of them counted as larger than where
/// `z = 10⁶`: what the tolerance allows, which may be far from every solution of a problem that is
/// nearly singular.
fn is_small(problem: &mut dyn Problem, z: &[f64], m: &[Vec<f64>]) -> bool {
    let mut f = vec![0.0; z.len()];
    problem.evaluate(z, Some(&mut f), None);
    let bounds = problem.shape().bounds();
    (0..z.len()).all(|i| {
        let terms: f64 = m[i].iter().zip(z).map(|(m, z)| m.abs() * z.abs().clamp(1.0, 1e6)).sum();
        let residual = (z[i] - bounds.lower()[i]).min(f[i].max(z[i] - bounds.upper()[i]));
        residual.abs() <= 4e-8 * terms
    })
}

/// Counts over all problems, so that the test cannot become empty unnoticed.
#[derive(Debug, Default)]
struct Tally {
    decided: usize,
    solvable: usize,
    solved: usize,
    unsolvable: usize,
}

#[test]
fn no_claim_is_false_on_random_affine_problems() {
    let mut random = Random(20_261_122);
    let mut tally = Tally::default();
    let mut solver = Solver::new(Options::new(Method::Robust)).unwrap();
    let mut lemke = Solver::new(Options::new(Method::Lemke)).unwrap();
    for number in 0..3000 {
        let n = [1, 2, 3, 4][number % 4];
        let m = matrix(&mut random, n);
        let q: Vec<f64> = (0..n).map(|_| random.entry()).collect();
        let bounds: Vec<_> = (0..n).map(|_| random.bounds()).collect();
        let start: Vec<f64> = (0..n).map(|_| 10.0 * random.unit()).collect();
        let mut problem = affine(m.clone(), q.clone(), &bounds, &start);
        let all = enumerate_affine(&mut problem).expect("affine, at most four variables");
        for solver in [&mut solver, &mut lemke] {
            let solution = solver.solve_from(&mut problem, &start).unwrap().clone();
            let case = format!("{number} by {}: {m:?} {q:?} {bounds:?}", solution.method);
            check_sane(&mut problem, &solution, &case);
            if all.undecided > 0 {
                continue;
            }
            let known = all.solutions.iter().any(|s| is_near(&solution.z, s))
                || is_small(&mut problem, &solution.z, &m);
            assert!(!solution.is_solved() || known, "{case}: {:?}", solution.z);
            if solution.method == Method::Robust {
                tally.decided += 1;
                tally.solvable += usize::from(!all.solutions.is_empty());
                tally.unsolvable += usize::from(all.solutions.is_empty());
                tally.solved += usize::from(solution.is_solved());
            }
        }
    }
    assert!(tally.unsolvable > 100 && tally.solvable > 1000, "{tally:?}");
}

/// Nonlinear problems all of whose solutions are published.
fn published() -> Vec<Known> {
    let make = [testing::kojima_shindo, testing::josephy, testing::watson4, testing::billups];
    make.iter().map(|make| make().expect("the problems are well formed")).collect()
}

#[test]
fn random_starts_of_published_problems_end_at_their_solutions_or_say_so() {
    let mut random = Random(42);
    for mut known in published() {
        let mut solved = 0;
        for number in 0..1750 {
            let n = known.starts[0].len();
            let start: Vec<f64> =
                (0..n).map(|_| random.unit() * 10_f64.powf(2.0 * random.unit())).collect();
            let options = Options::new(Method::Robust);
            let solution = solve_from(&mut *known.problem, &start, &options);
            let case = format!("{} {number} from {start:?}", known.name);
            check_sane(&mut *known.problem, &solution, &case);
            let right = known.solutions.iter().any(|s| is_near(&solution.z, s));
            assert!(!solution.is_solved() || right, "{case}: {:?}", solution.z);
            solved += usize::from(solution.is_solved());
        }
        assert!(solved >= 1300, "{}: {solved} of 1750", known.name);
    }
}
