//! Random affine problems in integers, whose solution sets are known exactly, from starts of every
//! kind, by every method: no claim without a solution, no claim further from one than the residual
//! allows.

use super::check::check_sane;
use super::exact::{Exact, UNIT};
use super::random::Random;
use crate::common::{INF, affine};
use mcp_core::{Method, Options, Problem, Solver};
use std::collections::BTreeMap;

/// How `M` and `q` are made.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Family {
    /// Integers.
    Arbitrary,
    /// `M − D` skew, `D >= 0` diagonal.
    Skew,
    /// `c cᵀ`.
    RankOne,
    /// Most entries 0.
    Sparse,
    /// One row a multiple of another, the constants as they come.
    Contrary,
    /// Constants up to 2²⁰ times the coefficients.
    Lopsided,
    /// Two rows that differ by a part in 2⁸ to 2¹⁶.
    NearlyContrary,
}

const FAMILIES: [Family; 7] = [
    Family::Arbitrary,
    Family::Skew,
    Family::RankOne,
    Family::Sparse,
    Family::Contrary,
    Family::Lopsided,
    Family::NearlyContrary,
];

/// A problem in integers, and the units in which it is posed: `F'_i = 2^{r_i} F_i(2^{c_j} z'_j)`.
#[derive(Debug)]
struct Sample {
    #[expect(dead_code, reason = "shown where a claim is false")]
    family: Family,
    exact: Exact,
    rows: Vec<i32>,
    columns: Vec<i32>,
}

/// A multiple of `UNIT`: 0, a small integer, or one with eight binary digits more.
fn value(random: &mut Random) -> i128 {
    match random.below(4) {
        0 => 0,
        1 => random.integer(8 << 8) << 24,
        _ => random.integer(3) << 32,
    }
}

fn bounds(random: &mut Random) -> (Option<i128>, Option<i128>) {
    let (a, b) = (value(random), value(random));
    match random.below(7) {
        0 => (None, None),
        1 => (Some(a), None),
        2 => (None, Some(a)),
        3 => (Some(a), Some(a)),
        4 => (Some(a.min(b)), Some(a.max(b))),
        _ => (Some(0), None),
    }
}

impl Sample {
    /// A random problem of `n` variables, in units up to `2^±units`.
    fn new(random: &mut Random, n: usize, units: i32) -> Self {
        let family = FAMILIES[random.below(7)];
        let most = [3, 9, 100][random.below(3)];
        let mut m: Vec<Vec<i128>> =
            (0..n).map(|_| (0..n).map(|_| random.integer(most)).collect()).collect();
        let mut q: Vec<i128> = (0..n).map(|_| value(random)).collect();
        let c: Vec<i128> = (0..n).map(|_| random.integer(most)).collect();
        let (i, j) = (random.below(n), random.below(n));
        let mut rows = vec![0; n];
        match family {
            Family::Arbitrary => {}
            Family::Skew => {
                for i in 0..n {
                    for j in 0..=i {
                        m[i][j] = if i == j { m[i][j].abs() } else { -m[j][i] };
                    }
                }
            }
            Family::RankOne => {
                for i in 0..n {
                    for j in 0..n {
                        m[i][j] = c[i] * c[j];
                    }
                }
            }
            Family::Sparse => {
                for entry in m.iter_mut().flatten() {
                    *entry *= i128::from(random.once_in(3));
                }
            }
            Family::Contrary | Family::NearlyContrary => {
                let factor = random.integer(3);
                m[i] = m[j].iter().map(|a| factor * a).collect();
                if family == Family::NearlyContrary && n <= 2 {
                    let digits = 12 + random.exponent(4);
                    m[i] = m[i].iter().map(|a| a << digits).collect();
                    m[i][0] += random.integer(3);
                    q[i] = if random.once_in(2) { factor * q[j] } else { q[i] } << digits;
                    rows[i] = -digits;
                }
            }
            Family::Lopsided => {
                for q in &mut q {
                    *q <<= random.below(21);
                }
            }
        }
        let (lower, upper) = (0..n).map(|_| bounds(random)).unzip();
        let mut columns = vec![0; n];
        for exponent in rows.iter_mut().chain(&mut columns) {
            *exponent += random.exponent(units);
        }
        Sample { family, exact: Exact { m, q, lower, upper }, rows, columns }
    }

    fn problem(&self, start: &[f64]) -> impl Problem + use<> {
        let n = self.exact.n();
        let row = |i: usize| 2_f64.powi(self.rows[i]);
        let column = |j: usize| 2_f64.powi(self.columns[j]);
        let m = |i: usize, j: usize| self.exact.m[i][j] as f64 * row(i) * column(j);
        let level = |j: usize, bound: Option<i128>, none: f64| {
            bound.map_or(none, |b| b as f64 * UNIT / column(j))
        };
        let bounds: Vec<_> = (0..n)
            .map(|j| (level(j, self.exact.lower[j], -INF), level(j, self.exact.upper[j], INF)))
            .collect();
        affine(
            (0..n).map(|i| (0..n).map(|j| m(i, j)).collect()).collect(),
            (0..n).map(|i| self.exact.q[i] as f64 * UNIT * row(i)).collect(),
            &bounds,
            &self.posed(start),
        )
    }

    /// A point in the units in which the problem is posed.
    fn posed(&self, z: &[f64]) -> Vec<f64> {
        z.iter().zip(&self.columns).map(|(z, c)| z * 2_f64.powi(-c)).collect()
    }

    /// Starts: zeros, ones, random, far and near ones, bounds.
    fn starts(&self, random: &mut Random) -> [Vec<f64>; 7] {
        let n = self.exact.n();
        let mut spread = |size: f64| -> Vec<f64> { (0..n).map(|_| size * random.unit()).collect() };
        let on_bound = |first: &[Option<i128>], second: &[Option<i128>]| -> Vec<f64> {
            let bound = |j: usize| first[j].or(second[j]).map_or(0.0, |b| b as f64 * UNIT);
            (0..n).map(bound).collect()
        };
        [
            vec![0.0; n],
            vec![1.0; n],
            spread(10.0),
            spread(1e4),
            spread(1e-4),
            on_bound(&self.exact.lower, &self.exact.upper),
            on_bound(&self.exact.upper, &self.exact.lower),
        ]
    }

    /// The point in the units of the integers.
    fn in_integers(&self, z: &[f64]) -> Vec<f64> {
        z.iter().zip(&self.columns).map(|(z, c)| z * 2_f64.powi(*c)).collect()
    }

    /// Whether a solution is as near as the residual says, and no residual is larger than `1e-8` of its
    /// terms, with variables as large as the largest, 1 or `1e-4` of the start.
    fn is_near(&self, z: &[f64], start: &[f64]) -> bool {
        let exact = &self.exact;
        let n = exact.n();
        let largest = |values: &[f64]| values.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let size = largest(z).max(1e-4 * largest(start)).max(1.0);
        let (mut violation, mut is_exact) = (0.0_f64, true);
        for i in 0..n {
            let (m, q) = (&exact.m[i], exact.q[i] as f64 * UNIT);
            let dot = |of: &dyn Fn(i128, f64) -> f64| -> f64 {
                m.iter().zip(z).map(|(m, z)| of(*m, *z)).sum()
            };
            let f = q + dot(&|m, z| m as f64 * z);
            let above = exact.lower[i].map_or(INF, |l| z[i] - l as f64 * UNIT);
            let below = exact.upper[i].map_or(-INF, |u| z[i] - u as f64 * UNIT);
            let rho = above.min(below.max(f)).abs();
            let terms = q.abs() + z[i].abs() + dot(&|m, z| (m as f64 * z).abs());
            let rounding = (n + 1) as f64 * f64::EPSILON * terms;
            let weights = dot(&|m, z| m.abs() as f64 * (z.abs() + size)).max(z[i].abs() + size);
            if rho > 1e-8 * weights {
                return false;
            }
            violation = violation.max(rho + rounding);
            is_exact &= rho <= rounding;
        }
        let radius = n as f64 * exact.inverse_bound() * violation / UNIT;
        if !((radius + size / UNIT) * exact.growth() < 2_f64.powi(126)) {
            // Too far away for 128 bits.
            return is_exact;
        }
        #[expect(clippy::cast_possible_truncation, reason = "seen to fit above")]
        let at = |z: f64| (z / UNIT).floor() as i128;
        let low: Vec<i128> = z.iter().map(|z| at(z - radius * UNIT) - 1).collect();
        let high: Vec<i128> = z.iter().map(|z| at(z + radius * UNIT) + 2).collect();
        exact.meets(&low, &high)
    }
}

/// Kinds of starts, in the order of [`Sample::starts`].
const STARTS: [&str; 7] =
    ["zeros", "ones", "random", "far", "near 0", "lower bounds", "upper bounds"];

/// What `count` problems from all starts came to.
#[derive(Debug, Default)]
struct Tally {
    solvable: usize,
    unsolvable: usize,
    /// Of the solvable ones, from all starts, by `Robust`.
    solved: usize,
    /// False claims by method and start.
    false_claims: BTreeMap<String, usize>,
    /// The problems of the first ones.
    examples: Vec<String>,
}

fn tally(seed: u64, count: usize, units: i32) -> Tally {
    let mut random = Random(seed);
    let mut tally = Tally::default();
    let mut solvers = Method::ALL.map(|method| Solver::new(Options::new(method)).unwrap());
    for number in 0..count {
        let sample = Sample::new(&mut random, 1 + number % 4, units);
        let is_solvable = sample.exact.is_solvable();
        tally.solvable += usize::from(is_solvable);
        tally.unsolvable += usize::from(!is_solvable);
        for (kind, start) in STARTS.iter().zip(sample.starts(&mut random)) {
            let mut problem = sample.problem(&start);
            for solver in &mut solvers {
                let solution = solver.solve_from(&mut problem, &sample.posed(&start)).unwrap();
                let case = format!("{number} from {kind} by {}: {sample:?}", solution.method);
                check_sane(&mut problem, solution, &case);
                let is_solved = solution.is_solved();
                if is_solved
                    && !(is_solvable && sample.is_near(&sample.in_integers(&solution.z), &start))
                {
                    let key = format!("{} from {kind}", solution.method);
                    *tally.false_claims.entry(key).or_default() += 1;
                    tally.examples.push(format!("{case}: {:?}", solution.z));
                }
                let is_robust = solution.method == Method::Robust;
                tally.solved += usize::from(is_robust && is_solvable && is_solved);
            }
        }
    }
    tally
}

fn check(tally: &Tally) {
    let first: Vec<_> = tally.examples.iter().take(30).collect();
    assert!(first.is_empty(), "{:?} {first:#?}", tally.false_claims);
    assert!(tally.solvable > 500 && tally.unsolvable > 200, "{tally:?}");
    let share = tally.solved as f64 / (7 * tally.solvable) as f64;
    assert!(share > 0.98, "Robust solves {share} of the solvable ones");
}

#[test]
fn no_claim_on_an_affine_problem_is_false() {
    check(&tally(20_261_122, 1000, 0));
}

#[test]
fn no_claim_is_false_in_units_of_2_to_the_20() {
    check(&tally(7, 1000, 20));
}
