//! Lemke's path through complementary bases, for variables with bounds.
//!
//! ```text
//! M y − s + t g = −q,   l <= y <= u;   s_i >= 0 at l_i, s_i <= 0 at u_i, s_i = 0 between
//! ```
//!
//! At `t = 1` the basis at hand is feasible, which defines the covering column `g`; `t` falls. What
//! reaches its bound first leaves the basis, and its partner enters ([CPS92](crate#references)
//! section 4.4). A level that can reach its other bound flips there without an exchange. The path
//! ends at `t = 0`, in a solution, or on a ray.
//!
//! Cycling: the covering numbers are distinct and generic, so that no two variables reach their
//! bounds together before the end, except on a null set of data; ties by rounding go to the larger
//! pivot, and the number of exchanges is limited.

use super::basis::{Basis, Side, Variable};
use crate::generic::generic;

/// How a path ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::solver) enum PathEnd {
    /// `t = 0`: `y` solves the affine problem.
    Solved,
    /// Nothing blocks: `ray` is the direction of `y`.
    Ray,
    /// Too many exchanges.
    Limit,
    /// The first basis is singular, or one on the way numerically so.
    Singular,
}

/// Entries of a column this small relative to the largest count as zero.
const ZERO: f64 = 1e-11;
/// Relative slack of the ratio test: among the candidates within it the largest pivot is taken.
const TIE: f64 = 1e-12;

/// An affine problem: `q` and the box; the matrix is in the [`Basis`].
#[derive(Clone, Copy)]
pub(in crate::solver) struct Affine<'a> {
    pub(in crate::solver) q: &'a [f64],
    pub(in crate::solver) lower: &'a [f64],
    pub(in crate::solver) upper: &'a [f64],
}

impl Affine<'_> {
    fn is_free(&self, i: usize) -> bool {
        self.lower[i] == f64::NEG_INFINITY && self.upper[i] == f64::INFINITY
    }

    /// The range of a basic variable whose pair stands at `side`.
    fn range(&self, variable: Variable, side: &[Side]) -> (f64, f64) {
        match variable {
            Variable::Cover => (0.0, f64::INFINITY),
            Variable::Level(i) => (self.lower[i], self.upper[i]),
            Variable::Slack(i) if self.lower[i] >= self.upper[i] => {
                (f64::NEG_INFINITY, f64::INFINITY)
            }
            Variable::Slack(i) if side[i] == Side::Lower => (0.0, f64::INFINITY),
            Variable::Slack(_) => (f64::NEG_INFINITY, 0.0),
        }
    }

    fn bound(&self, i: usize, side: Side) -> f64 {
        if side == Side::Lower { self.lower[i] } else { self.upper[i] }
    }
}

/// What changes along an edge of the path: a variable, from `value`, upwards or downwards.
#[derive(Clone, Copy, Debug)]
struct Entering {
    variable: Variable,
    value: f64,
    sign: f64,
}

/// What ends an edge.
enum Blocking {
    /// The entering variable itself, at its other end.
    Entering,
    /// The basic variable at a position, at its upper bound or not.
    Basic { position: usize, at_upper: bool },
}

impl Basis {
    /// Starts at the basis of a point: levels strictly between their bounds that the min map takes
    /// by their equation are basic.
    pub(in crate::solver) fn start_at(&mut self, problem: Affine<'_>, y: &[f64], s: &[f64]) {
        for i in 0..y.len() {
            let (above, below) = (y[i] - problem.lower[i], y[i] - problem.upper[i]);
            let at_lower = above <= s[i];
            let at_bound = at_lower || below >= s[i];
            self.basic[i] = if at_bound { Variable::Slack(i) } else { Variable::Level(i) };
            self.side[i] = if at_lower { Side::Lower } else { Side::Upper };
        }
    }

    /// Starts with free levels basic and all others at a bound, the lower if there is one.
    pub(in crate::solver) fn start_at_bounds(&mut self, problem: Affine<'_>) {
        for i in 0..self.basic.len() {
            let free = problem.is_free(i);
            self.basic[i] = if free { Variable::Level(i) } else { Variable::Slack(i) };
            let has_lower = problem.lower[i] > f64::NEG_INFINITY;
            self.side[i] = if has_lower { Side::Lower } else { Side::Upper };
        }
    }

    /// Follows the path from the basis that is set, for at most `limit` exchanges.
    pub(in crate::solver) fn follow(&mut self, problem: Affine<'_>, limit: usize) -> PathEnd {
        (self.exchanges, self.factorisations) = (0, 0);
        if !self.factor() || !self.values_of_basics(problem) {
            return PathEnd::Singular;
        }
        if !self.set_cover(problem) {
            self.read_levels(problem);
            return PathEnd::Solved;
        }
        let mut entering = Entering { variable: Variable::Cover, value: 1.0, sign: -1.0 };
        let renew = (self.x.len() / 4).clamp(40, 400);
        for _ in 0..limit {
            self.load(entering.variable);
            self.solve();
            let Some((step, blocking)) = self.ratio_test(problem, entering) else {
                self.read_ray(entering);
                return PathEnd::Ray;
            };
            for (x, alpha) in self.x.iter_mut().zip(&self.column) {
                *x -= entering.sign * step * alpha;
            }
            let value = entering.value + entering.sign * step;
            let leaving = match blocking {
                Blocking::Entering if entering.variable == Variable::Cover => {
                    return self.end(problem);
                }
                Blocking::Entering => {
                    let up = entering.sign > 0.0;
                    self.leave(entering.variable, up);
                    entering.variable
                }
                Blocking::Basic { position, at_upper } => {
                    let leaving = self.basic[position];
                    if leaving == Variable::Cover {
                        self.exchange(position, entering.variable);
                        return self.end(problem);
                    }
                    self.exchange(position, entering.variable);
                    self.x[position] = value;
                    self.leave(leaving, at_upper);
                    leaving
                }
            };
            self.exchanges += 1;
            entering = self.partner(problem, leaving);
            if self.age() >= renew && !(self.factor() && self.values_of_basics(problem)) {
                return PathEnd::Singular;
            }
        }
        PathEnd::Limit
    }

    /// Values of the basic variables: `B x = −q − Σ M_·j y_j` over levels at a bound. False if they
    /// are not finite.
    fn values_of_basics(&mut self, problem: Affine<'_>) -> bool {
        for (to, q) in self.column.iter_mut().zip(problem.q) {
            *to = -q;
        }
        for i in 0..self.basic.len() {
            self.y[i] = 1.0;
        }
        for &variable in &self.basic {
            if let Variable::Level(j) = variable {
                self.y[j] = 0.0;
            }
        }
        for j in 0..self.y.len() {
            let bound = problem.bound(j, self.side[j]);
            if self.y[j] != 0.0 && bound != 0.0 {
                self.add_level(j, -bound);
            }
        }
        self.solve();
        self.x.copy_from_slice(&self.column);
        self.x.iter().all(|x| x.is_finite())
    }

    /// Chooses `g = −B h` so that `x + t h` is strictly feasible at `t = 1`, and goes there. False
    /// if `x` is feasible as it is.
    fn set_cover(&mut self, problem: Affine<'_>) -> bool {
        let mut violation = 0.0_f64;
        for (&variable, &x) in self.basic.iter().zip(&self.x) {
            let (lower, upper) = problem.range(variable, &self.side);
            violation = violation.max(lower - x).max(x - upper);
        }
        if violation <= 0.0 {
            return false;
        }
        // h in y, for the moment.
        for position in 0..self.x.len() {
            let (lower, upper) = problem.range(self.basic[position], &self.side);
            let (x, part) = (self.x[position], 0.3 + 0.4 * generic(position));
            let up = (1.0 + part) * violation;
            self.y[position] = match (lower.is_finite(), upper.is_finite()) {
                (false, false) => 0.0,
                (true, false) => up,
                (false, true) => -up,
                (true, true) if lower <= x && x <= upper => 0.0,
                (true, true) => lower + part * (upper - lower) - x,
            };
        }
        self.column.fill(0.0);
        for position in 0..self.x.len() {
            let h = self.y[position];
            match self.basic[position] {
                _ if h == 0.0 => {}
                Variable::Level(j) => self.add_level(j, -h),
                Variable::Slack(i) => self.column[i] += h,
                Variable::Cover => unreachable!("the covering variable is not basic at the start"),
            }
            self.x[position] += h;
        }
        self.cover.copy_from_slice(&self.column);
        true
    }

    /// How far the entering variable can go, and what stops it; `None`: nothing.
    fn ratio_test(&self, problem: Affine<'_>, entering: Entering) -> Option<(f64, Blocking)> {
        let largest = self.column.iter().fold(0.0_f64, |m, a| m.max(a.abs()));
        let zero = ZERO * largest;
        // Distance to the bound and speed towards it, of the basic variable at a position.
        let candidate = |position: usize| {
            let rate = -entering.sign * self.column[position];
            if !(rate.abs() > zero) {
                return None;
            }
            let (lower, upper) = problem.range(self.basic[position], &self.side);
            let x = self.x[position];
            let distance = if rate < 0.0 { x - lower } else { upper - x };
            distance.is_finite().then(|| (distance.max(0.0), rate))
        };
        let own = match entering.variable {
            Variable::Cover => entering.value,
            Variable::Level(i) => problem.upper[i] - problem.lower[i],
            Variable::Slack(_) => f64::INFINITY,
        };
        let mut longest = own;
        for position in 0..self.x.len() {
            if let Some((distance, rate)) = candidate(position) {
                let slack = TIE * (1.0 + self.x[position].abs());
                longest = longest.min((distance + slack) / rate.abs());
            }
        }
        if longest == f64::INFINITY {
            return None;
        }
        let (mut chosen, mut pivot) = (None, 0.0);
        for position in 0..self.x.len() {
            let Some((distance, rate)) = candidate(position) else { continue };
            if distance / rate.abs() > longest {
                continue;
            }
            let is_cover = self.basic[position] == Variable::Cover;
            let size = if is_cover { f64::INFINITY } else { rate.abs() };
            if size > pivot {
                pivot = size;
                let at_upper = rate > 0.0;
                chosen = Some((distance / rate.abs(), Blocking::Basic { position, at_upper }));
            }
        }
        Some(chosen.unwrap_or((own, Blocking::Entering)))
    }

    /// Notes at which bound a level that leaves, or flips, now stands.
    fn leave(&mut self, variable: Variable, at_upper: bool) {
        if let Variable::Level(i) = variable {
            self.side[i] = if at_upper { Side::Upper } else { Side::Lower };
        }
    }

    /// What enters after a variable has left.
    fn partner(&self, problem: Affine<'_>, left: Variable) -> Entering {
        let (i, variable) = match left {
            Variable::Level(i) => (i, Variable::Slack(i)),
            Variable::Slack(i) => (i, Variable::Level(i)),
            Variable::Cover => unreachable!("the path ends where the covering variable leaves"),
        };
        let sign = if self.side[i] == Side::Lower { 1.0 } else { -1.0 };
        let value = match variable {
            Variable::Level(_) => problem.bound(i, self.side[i]),
            _ => 0.0,
        };
        Entering { variable, value, sign }
    }

    /// The solution, from fresh factors.
    fn end(&mut self, problem: Affine<'_>) -> PathEnd {
        if !(self.factor() && self.values_of_basics(problem)) {
            return PathEnd::Singular;
        }
        self.read_levels(problem);
        PathEnd::Solved
    }

    fn read_levels(&mut self, problem: Affine<'_>) {
        for i in 0..self.y.len() {
            self.y[i] = problem.bound(i, self.side[i]);
        }
        for (&variable, &x) in self.basic.iter().zip(&self.x) {
            if let Variable::Level(i) = variable {
                self.y[i] = x.max(problem.lower[i]).min(problem.upper[i]);
            }
        }
    }

    fn read_ray(&mut self, entering: Entering) {
        self.ray.fill(0.0);
        for (&variable, &alpha) in self.basic.iter().zip(&self.column) {
            if let Variable::Level(i) = variable {
                self.ray[i] = -entering.sign * alpha;
            }
        }
        if let Variable::Level(i) = entering.variable {
            self.ray[i] = entering.sign;
        }
    }
}
