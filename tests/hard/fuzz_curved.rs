//! Random nonlinear problems whose truth is known by construction: one solution, or none.
//!
//! ```text
//! one    F(z) = A (G(z) − G(z*)) + s,  A integer, diagonally dominant by rows, G increasing, s and z* complementary
//! none   such rows, and one that cannot hold: of one sign, out of the range of its functions, or one
//!        that contradicts another
//! ```
//!
//! `F` of the first kind is a P-function. Let `i` be the variable with the largest `|G_i(z_i) − G_i(z*_i)|`
//! and `α` the smallest excess of a diagonal entry of `A`: then `|F_i(z) − F_i(z*)|` is at least `α` times as
//! large, with the sign that moves `z_i` back. So `z*` is the only solution, and where each residual is at
//! most `1e-8` of its terms,
//!
//! ```text
//! max_j |G_j(z_j) − G_j(z*_j)| <= 1e-8 max_i max(Σ_j |a_ij| G'_j(z_j) w_j / α,  G'_i w_i),   w_j = |z_j| + τ_j
//! ```

use super::check::check_sane;
use super::random::Random;
use crate::common::{FREE, INF, dense, solve_from};
use mcp_core::{Method, Options, Problem, Solution};

/// An increasing function.
#[derive(Clone, Copy, Debug)]
enum Curve {
    Line,
    Exponential,
    Cubic,
    Arctangent,
    /// These for `z >= 0`.
    Logarithm,
    Root,
    Square,
}

impl Curve {
    /// `(g, g')`.
    fn at(self, z: f64) -> (f64, f64) {
        match self {
            Curve::Line => (z, 1.0),
            Curve::Exponential => (z.exp(), z.exp()),
            Curve::Cubic => (z + z * z * z, 1.0 + 3.0 * z * z),
            Curve::Arctangent => (z.atan(), 1.0 / (1.0 + z * z)),
            Curve::Logarithm => (z.ln_1p(), 1.0 / (1.0 + z)),
            Curve::Root => ((z + STEEP).sqrt(), 0.5 / (z + STEEP).sqrt()),
            Curve::Square => (z * z, 2.0 * z),
        }
    }

    fn is_for_positive(self) -> bool {
        matches!(self, Curve::Logarithm | Curve::Root | Curve::Square)
    }
}

/// How far left of 0 the root begins: its slope at 0 is 16.
const STEEP: f64 = 1.0 / 1024.0;

const CURVES: [Curve; 7] = [
    Curve::Line,
    Curve::Exponential,
    Curve::Cubic,
    Curve::Arctangent,
    Curve::Logarithm,
    Curve::Root,
    Curve::Square,
];

/// `F(z) = A (G(z) − G(z*)) + s`.
#[derive(Clone, Debug)]
struct Manufactured {
    a: Vec<Vec<f64>>,
    curves: Vec<Curve>,
    bounds: Vec<(f64, f64)>,
    solution: Vec<f64>,
    slack: Vec<f64>,
}

impl Manufactured {
    fn new(random: &mut Random, n: usize) -> Self {
        let mut a: Vec<Vec<f64>> =
            (0..n).map(|_| (0..n).map(|_| random.integer(2) as f64).collect()).collect();
        let mut m = Manufactured {
            a: Vec::new(),
            curves: Vec::new(),
            bounds: Vec::new(),
            solution: Vec::new(),
            slack: Vec::new(),
        };
        for (i, row) in a.iter_mut().enumerate() {
            row[i] = 0.0;
            row[i] = 1.0 + row.iter().map(|a| a.abs()).sum::<f64>() + random.below(3) as f64;
            let curve = CURVES[random.below(7)];
            let lower = if curve.is_for_positive() { 0.0 } else { random.unit() - 1.0 };
            let between = lower + 0.5 * (1.0 + random.unit());
            let slack = if random.once_in(3) { 0.0 } else { 1.0 + random.unit() };
            let is_free = !curve.is_for_positive() && random.once_in(3);
            let (bounds, solution, slack) = match random.below(3) {
                _ if is_free => (FREE, between, 0.0),
                0 => ((lower, INF), lower, slack),
                1 => ((lower, between), between, -slack),
                _ => ((lower, INF), between, 0.0),
            };
            m.curves.push(curve);
            m.bounds.push(bounds);
            m.solution.push(solution);
            m.slack.push(slack);
        }
        m.a = a;
        m
    }

    /// `F` and `J`, column by column.
    fn evaluate(&self, z: &[f64], f: &mut [f64], jac: &mut [f64]) {
        let n = z.len();
        f.copy_from_slice(&self.slack);
        for j in 0..n {
            let (g, slope) = self.curves[j].at(z[j]);
            let by = g - self.curves[j].at(self.solution[j]).0;
            for i in 0..n {
                f[i] += self.a[i][j] * by;
                jac[i + n * j] = self.a[i][j] * slope;
            }
        }
    }

    /// Whether the point is as near to the solution as the tolerance says, variables counted as large as
    /// the largest, 1 or `1e-4` of the start.
    fn is_near(&self, z: &[f64], start: &[f64]) -> bool {
        let largest = |values: &[f64]| values.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let size = largest(z).max(1e-4 * largest(start)).max(1.0);
        let (mut error, mut allowed) = (0.0_f64, 0.0_f64);
        for i in 0..z.len() {
            let change = |j: usize| self.curves[j].at(z[j]).1 * (z[j].abs() + size);
            let row = &self.a[i];
            let terms: f64 = (0..z.len()).map(|j| row[j].abs() * change(j)).sum();
            let excess = 2.0 * row[i] - row.iter().map(|a| a.abs()).sum::<f64>();
            allowed = allowed.max(terms / excess).max(change(i));
            let g = |z: f64| self.curves[i].at(z).0;
            error = error.max((g(z[i]) - g(self.solution[i])).abs());
        }
        error <= 1e-8 * allowed
    }
}

/// Starts: zeros, ones, random, far and near ones, lower bounds or 0.
fn starts(random: &mut Random, bounds: &[(f64, f64)]) -> [Vec<f64>; 6] {
    let n = bounds.len();
    let mut spread = |size: f64| -> Vec<f64> { (0..n).map(|_| size * random.unit()).collect() };
    [
        vec![0.0; n],
        vec![1.0; n],
        spread(10.0),
        spread(1e4),
        spread(1e-4),
        bounds.iter().map(|(l, _)| if l.is_finite() { *l } else { 0.0 }).collect(),
    ]
}

const NONLINEAR: [Method; 4] =
    [Method::Robust, Method::NewtonFb, Method::NewtonMinFb, Method::OldFb];

#[test]
fn claims_on_problems_with_one_solution_are_near_it() {
    let mut random = Random(11);
    let (mut solved, mut tried) = (0, 0);
    let mut wrong = Vec::new();
    for number in 0..1000 {
        let m = Manufactured::new(&mut random, 1 + number % 4);
        for start in starts(&mut random, &m.bounds) {
            for method in NONLINEAR {
                let of = m.clone();
                let evaluate = move |z: &[f64], f: &mut [f64], j: &mut [f64]| of.evaluate(z, f, j);
                let mut problem = dense(&m.bounds, &start, evaluate);
                let solution = solve_from(&mut problem, &start, &Options::new(method));
                let case = format!("{number} from {start:?} by {method}: {m:?}");
                check_sane(&mut problem, &solution, &case);
                if solution.is_solved() && !m.is_near(&solution.z, &start) {
                    wrong.push(format!("{case}: {:?}", solution.z));
                }
                tried += usize::from(method == Method::Robust);
                solved += usize::from(method == Method::Robust && solution.is_solved());
            }
        }
    }
    assert!(wrong.is_empty(), "{} {:#?}", wrong.len(), &wrong[..wrong.len().min(10)]);
    assert!(10 * solved > 9 * tried, "Robust solves {solved} of {tried}");
}

/// Why no point satisfies the first equations.
#[derive(Clone, Copy, Debug)]
enum Absurd {
    /// `Σ h_j(z_j) + c = 0` with `h_j >= 0`, `c > 0`.
    Positive,
    /// `Σ e^{z_j} = 0`: only at infinity.
    Vanishing,
    /// `−Σ h_j(z_j) − c ⟂ z₁ >= 0`.
    Pushed,
    /// `Σ arctan z_j = n π/2 + c`.
    OutOfRange,
    /// `F₁ = 0` and `k F₁ + c = 0`; for one variable `z₁² + c = 0`.
    Contrary,
}

const ABSURD: [Absurd; 5] =
    [Absurd::Positive, Absurd::Vanishing, Absurd::Pushed, Absurd::OutOfRange, Absurd::Contrary];

/// `(h, h')`, `h >= 0`, of four kinds.
fn nonnegative(kind: usize, z: f64) -> (f64, f64) {
    match kind {
        0 => (z * z, 2.0 * z),
        1 => (z.exp(), z.exp()),
        2 => (z.hypot(1.0) - 1.0, z / z.hypot(1.0)),
        _ => (z.powi(4), 4.0 * z.powi(3)),
    }
}

/// A problem of one solution with its first equation, or first two, replaced: why it has none now, all
/// its numbers, its bounds.
fn unsolvable(
    random: &mut Random,
    n: usize,
) -> (Absurd, String, Vec<(f64, f64)>, impl Problem + use<>) {
    let m = Manufactured::new(random, n);
    let kind = ABSURD[random.below(5)];
    let c = 10_f64.powf(3.0 * random.unit());
    let h: Vec<usize> = (0..n).map(|_| random.below(4)).collect();
    let mut bounds = m.bounds.clone();
    bounds[0] = if matches!(kind, Absurd::Pushed) { (0.0, INF) } else { FREE };
    if matches!(kind, Absurd::Contrary) {
        bounds[n.min(2) - 1] = FREE;
    }
    let factor = 1.0 + random.below(3) as f64;
    let mut of = m;
    for (curve, &(l, _)) in of.curves.iter_mut().zip(&bounds) {
        if curve.is_for_positive() && l < 0.0 {
            *curve = Curve::Cubic;
        }
    }
    let text = format!("c = {c:e}, h = {h:?}, k = {factor}, {bounds:?}, {of:?}");
    let problem =
        dense(&bounds, &vec![0.0; n], move |z: &[f64], f: &mut [f64], jac: &mut [f64]| {
            of.evaluate(z, f, jac);
            let mut replace = |row: usize, sign: f64, c: f64, g: &dyn Fn(usize) -> (f64, f64)| {
                f[row] = sign * c;
                for j in 0..n {
                    f[row] += sign * g(j).0;
                    jac[row + n * j] = sign * g(j).1;
                }
            };
            let sum = |j: usize| nonnegative(h[j], z[j]);
            let limit = std::f64::consts::FRAC_PI_2 * n as f64;
            match kind {
                Absurd::Positive => replace(0, 1.0, c, &sum),
                Absurd::Vanishing => replace(0, 1.0, 0.0, &|j| nonnegative(1, z[j])),
                Absurd::Pushed => replace(0, -1.0, c, &sum),
                Absurd::OutOfRange => {
                    replace(0, 1.0, -limit - c, &|j| (z[j].atan(), 1.0 / (1.0 + z[j] * z[j])));
                }
                Absurd::Contrary if n == 1 => replace(0, 1.0, c, &|j| nonnegative(0, z[j])),
                Absurd::Contrary => {
                    f[1] = factor * f[0] + c;
                    for j in 0..n {
                        jac[1 + n * j] = factor * jac[n * j];
                    }
                }
            }
        });
    (kind, text, bounds, problem)
}

/// Share of the terms of an equation that its rounding can hide: 64 units in the last place.
const HIDDEN: f64 = 64.0 * f64::EPSILON;

/// Whether all residuals are lost in the rounding of the terms `Σ_j |J_ij z_j|` at a point, as `x³ = 0` and
/// `x³ + 1 = 0` are from `10⁵` on: there the problem cannot be told from one with a solution.
fn is_hidden_by_rounding(problem: &mut impl Problem, solution: &Solution) -> bool {
    let (z, f) = (&solution.z, &solution.f);
    let mut jac = vec![0.0; problem.pattern().nnz()];
    problem.evaluate(z, None, Some(&mut jac));
    let mut terms = vec![0.0; z.len()];
    for (k, i, j) in problem.pattern().entries() {
        terms[i] += (jac[k] * z[j]).abs();
    }
    let bounds = problem.shape().bounds();
    (0..z.len()).all(|i| {
        let residual = (z[i] - bounds.lower()[i]).min((z[i] - bounds.upper()[i]).max(f[i]));
        residual.abs() <= HIDDEN * terms[i]
    })
}

#[test]
fn nothing_is_claimed_where_there_is_no_solution() {
    let mut random = Random(12);
    let mut wrong = Vec::new();
    let mut hidden = 0;
    for number in 0..400 {
        let (kind, text, bounds, mut problem) = unsolvable(&mut random, 1 + number % 4);
        for start in starts(&mut random, &bounds) {
            for method in NONLINEAR {
                let solution = solve_from(&mut problem, &start, &Options::new(method));
                let case = format!("{number} from {start:?} by {method}: {kind:?}, {text}");
                check_sane(&mut problem, &solution, &case);
                if !solution.is_solved() {
                    continue;
                }
                if is_hidden_by_rounding(&mut problem, &solution) {
                    hidden += 1;
                } else {
                    wrong.push(format!("{case}: {:?} {:?}", solution.z, solution.f));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} {:#?}", wrong.len(), &wrong[..wrong.len().min(10)]);
    assert!(hidden <= 11, "{hidden} claims of 9600");
}
