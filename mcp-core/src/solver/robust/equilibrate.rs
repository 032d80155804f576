//! Equilibration in integers: powers of two for equations and variables, equivariant under powers
//! of two.
//!
//! ```text
//! min over r, c, g, h of  Σ (e(J_ij) + r_i + c_j)² + Σ (c_j − e(z_j) − g)² + Σ (e(F_i) + r_i − h)²
//! over the J_ij, the z_j known, and F_i ≠ 0 if none is;  e(x) = ⌊log₂ |x|⌋
//! ```
//!
//! Least squares on the logarithms ([CR72](crate#references)): entries of `J` near 1, the variables
//! that are known all of one size, or else the equations. `J` alone would scale `n` variables in a
//! chain by `1, 2, 4, …, 2ⁿ` where that makes it symmetric. A `z_j` is known if it is not 0, was not
//! at the start, and one of its terms `J_ij z_j` is not below `2⁻³⁰` of the largest of an equation:
//! a flow of 1e-60 that an earlier solve has left says nothing.
//!
//! Four steps keep every bit when `F_i` is multiplied by `2^k_i` and `z_j` by `2^k_j` (`e_ij` then
//! grows by `k_i − k_j`):
//!
//! 1. A spanning forest of the bipartite graph of nonzeros gives integers `r, c` with
//!    `e + r + c = 0` on its edges. What remains on the other edges are sums around cycles, in which
//!    `k` cancels: from here on the numbers are the same in all units.
//! 2. Conjugate gradients solve the least-squares problem for the remainder, [`PASSES`] times:
//!    entries below `2⁻³⁰` in the scales found are negligible and left out of the next.
//! 3. Rounding, at an offset where fractions with small denominators do not tie. For `J` symmetric
//!    up to such scales, the fractions of `r_j` and `c_j` are made equal first, so that one vector
//!    scales rows and columns and the scaled `J` is symmetric.
//! 4. `(r − g, c + g)` gives the same matrix for every `g`: in every block of connected rows and
//!    columns `g` is the mean exponent of the known `z_j` or of `F` there, the larger one, in the
//!    scales found; of the finite bounds, if both vanish; of any `z_j`, where there are none. What the
//!    point says nothing about keeps the scales it had.
//!
//! Rows and columns of fixed variables take no part; they get scales that bring their largest entry
//! near 1. Cost: one sweep over the nonzeros for each step of step 2, at most [`SWEEPS`].

use super::measured::{Measured, Sample, Sizes};
use crate::model::Bounds;
use crate::problem::Pattern;

/// Steps of conjugate gradients at most.
const SWEEPS: usize = 60;
/// Residual, in binary digits, at which they stop: the solution is rounded to integers.
const ACCURACY: f64 = 1e-3;
/// How often step 2 is done: entries that turn out negligible are left out of the next.
const PASSES: usize = 3;
/// Binary exponent of an entry that is negligible in the scales found.
pub(super) const NEGLIGIBLE: i32 = -30;
/// `⌊x + 0.59⌋`: least-squares solutions have small denominators, and none of them ties here.
const OFFSET: f64 = 0.59;
/// Largest exponent of a scale: larger ones come from exponentials and hold nowhere else.
const LARGEST: i32 = 100;

/// Largest exponent of a scaled variable.
const FARTHEST: i32 = 900;

/// Exponent of a zero.
pub(super) const NONE: i32 = i32::MIN / 4;

/// `⌊log₂ |x|⌋` for finite `x ≠ 0`, exactly.
pub(super) fn exponent(x: f64) -> i32 {
    let biased = (x.to_bits() >> 52 & 0x7ff) as i32;
    if biased > 0 {
        biased - 1023
    } else {
        -1023 - (x.to_bits() << 12).leading_zeros().cast_signed()
    }
}

/// `2^k`, `|k| <= 1000`.
pub(super) fn power_of_two(k: i32) -> f64 {
    f64::from_bits(u64::from((1023 + k.clamp(-1000, 1000)).unsigned_abs()) << 52)
}

/// Exponents of the scales, and the memory to find them. Nodes `0..n` are rows, `n..2n` columns, `2n`
/// is the row of the start, `2n + 1` the column of `F`.
#[derive(Clone, Debug, Default)]
pub(super) struct Equilibration {
    n: usize,
    /// Towards the root of the node's tree, and the node's potential relative to that node: `r_i`
    /// of a row, `−c_j` of a column.
    parent: Vec<usize>,
    potential: Vec<i32>,
    /// The least-squares problem: solution, residual, direction, its image, degrees.
    x: Vec<f64>,
    residual: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
    degree: Vec<f64>,
    /// Weights of the edges: 0 of a negligible one.
    weight: Vec<f64>,
    known: Vec<bool>,
    /// Potential of the row of the start, and minus that of the column of `F`.
    anchors: [i32; 2],
    /// By root of a block: half the difference of fractions of the first pair; sums and numbers of
    /// exponents of the known `z`, of `F`, of the bounds, of all `z`, and of the old scales in the new.
    shift: Vec<Option<f64>>,
    gauge: Vec<[(i64, i64); 5]>,
    /// The scales before.
    old_r: Vec<i32>,
    old_c: Vec<i32>,
    /// The result: `F_i 2^{r_i}` and `z_j = y_j 2^{c_j}`.
    pub(super) r: Vec<i32>,
    pub(super) c: Vec<i32>,
}

impl Equilibration {
    pub(super) fn resize(&mut self, n: usize) {
        self.n = n;
        self.parent.resize(2 * n + 2, 0);
        self.potential.resize(2 * n + 2, 0);
        for list in [
            &mut self.x,
            &mut self.residual,
            &mut self.direction,
            &mut self.image,
            &mut self.degree,
        ] {
            list.resize(2 * n + 2, 0.0);
        }
        self.shift.resize(2 * n + 2, None);
        self.gauge.resize(2 * n + 2, [(0, 0); 5]);
        self.known.resize(n, false);
        for list in [&mut self.r, &mut self.c, &mut self.old_r, &mut self.old_c] {
            list.resize(n, 0);
        }
    }

    /// No scaling.
    pub(super) fn clear(&mut self) {
        self.r.fill(0);
        self.c.fill(0);
    }

    /// The scales of a point where `F` and `J` are finite.
    pub(super) fn measure(&mut self, pattern: &Pattern, bounds: &Bounds, sample: Sample<'_>) {
        self.old_r.copy_from_slice(&self.r);
        self.old_c.copy_from_slice(&self.c);
        let mut known = std::mem::take(&mut self.known);
        sample.mark_known(pattern, bounds, &mut self.r, &mut known);
        let at = Measured { pattern, bounds, sample, known: &known };
        self.span(at);
        self.least_squares(at);
        self.round(at);
        self.set_gauge(at);
        self.scale_fixed(at);
        for scale in self.r.iter_mut().chain(&mut self.c) {
            *scale = (*scale).clamp(-LARGEST, LARGEST);
        }
        // A start of 10³⁰⁰ beside a bound of 10⁻³⁰⁰ must not overflow.
        for (c, &z) in self.c.iter_mut().zip(sample.z) {
            *c = (*c).max(exponent(z) - FARTHEST);
        }
        self.known = known;
    }

    /// Root of a node's tree and the node's potential relative to it; halves the way there.
    fn find(&mut self, mut node: usize) -> (usize, i32) {
        let mut potential = 0;
        while self.parent[node] != node {
            let up = self.parent[node];
            if self.parent[up] != up {
                self.potential[node] += self.potential[up];
                self.parent[node] = self.parent[up];
            }
            potential += self.potential[node];
            node = self.parent[node];
        }
        (node, potential)
    }

    /// Step 1: `r_i + c_j = −e_ij` on a spanning forest, by union of trees with potentials.
    fn span(&mut self, at: Measured<'_>) {
        for (node, parent) in self.parent.iter_mut().enumerate() {
            *parent = node;
        }
        self.potential.fill(0);
        let mut trees = 2 * self.n + 2;
        for (row, column, e) in at.edges() {
            if trees == 1 {
                break;
            }
            let ((row_root, r), (column_root, minus_c)) = (self.find(row), self.find(column));
            if row_root != column_root {
                // r_i − (−c_j) = −e_ij, with the row's tree hung under the column's.
                self.parent[row_root] = column_root;
                self.potential[row_root] = minus_c - e - r;
                trees -= 1;
            }
        }
        for i in 0..self.n {
            self.r[i] = self.find(i).1;
            self.c[i] = -self.find(self.n + i).1;
        }
        self.anchors = [self.find(2 * self.n).1, -self.find(2 * self.n + 1).1];
    }

    /// Step 2, and again without the entries that are negligible in the scales found.
    fn least_squares(&mut self, at: Measured<'_>) {
        self.x.fill(0.0);
        self.weight.clear();
        let mut is_accurate = false;
        for _ in 0..PASSES {
            let is_new = self.weigh_edges(at);
            if is_accurate && !is_new {
                break;
            }
            is_accurate = self.conjugate_gradients(at);
        }
    }

    /// What remains of an edge in the scales at hand: `e + r + c`.
    fn remainder(&self, (row, column, e): (usize, usize, i32)) -> f64 {
        let n = self.n;
        let r = if row < n { self.r[row] } else { self.anchors[0] };
        let c = if column < 2 * n { self.c[column - n] } else { self.anchors[1] };
        f64::from(e + r + c) + self.x[row] + self.x[column]
    }

    /// Weights of the edges, residuals and degrees of the nodes at the `x` at hand; whether a weight is
    /// new.
    fn weigh_edges(&mut self, at: Measured<'_>) -> bool {
        let n = self.n;
        self.residual.fill(0.0);
        self.degree.fill(0.0);
        let mut is_new = false;
        for (k, edge) in at.edges().enumerate() {
            let (row, column, _) = edge;
            let remainder = self.remainder(edge);
            let weight = match at.sample.sizes {
                Sizes::AsAllEntries if row == 2 * n => at.pattern.column(column - n).len() as f64,
                _ if row < 2 * n && remainder < f64::from(NEGLIGIBLE) => 0.0,
                _ => 1.0,
            };
            if k == self.weight.len() {
                self.weight.push(weight);
                is_new = true;
            } else {
                is_new |= self.weight[k] != weight;
                self.weight[k] = weight;
            }
            for node in [row, column] {
                self.residual[node] -= weight * remainder;
                self.degree[node] += weight;
            }
        }
        is_new
    }

    /// `(D + B) x = −b` by conjugate gradients with the diagonal as preconditioner, every edge with its
    /// weight, from the `x` at hand; whether it is accurate.
    fn conjugate_gradients(&mut self, at: Measured<'_>) -> bool {
        let n = self.n;
        let mut rho = 0.0;
        for node in 0..2 * n + 2 {
            let d = self.residual[node] / self.degree[node].max(1.0);
            self.direction[node] = d;
            rho += self.residual[node] * d;
        }
        for _ in 0..SWEEPS {
            self.image.fill(0.0);
            for ((row, column, _), &weight) in at.edges().zip(&self.weight) {
                let sum = weight * (self.direction[row] + self.direction[column]);
                self.image[row] += sum;
                self.image[column] += sum;
            }
            let curvature: f64 = self.direction.iter().zip(&self.image).map(|(d, a)| d * a).sum();
            if !(curvature > 0.0) {
                return true;
            }
            let (step, before) = (rho / curvature, rho);
            let mut largest = 0.0_f64;
            rho = 0.0;
            for node in 0..2 * n + 2 {
                self.x[node] += step * self.direction[node];
                self.residual[node] -= step * self.image[node];
                let scaled = self.residual[node] / self.degree[node].max(1.0);
                rho += self.residual[node] * scaled;
                largest = largest.max(scaled.abs());
            }
            if largest <= ACCURACY {
                return true;
            }
            for node in 0..2 * n + 2 {
                let scaled = self.residual[node] / self.degree[node].max(1.0);
                self.direction[node] = scaled + rho / before * self.direction[node];
            }
        }
        false
    }

    /// Step 3.
    fn round(&mut self, at: Measured<'_>) {
        let n = self.n;
        self.shift.fill(None);
        for j in (0..n).filter(|&j| !at.is_fixed(j)) {
            let (root, other) = (self.find(j).0, self.find(n + j).0);
            if root == other {
                let half = 0.5 * (self.x[n + j] - self.x[j]);
                self.shift[root].get_or_insert(half);
            }
        }
        for j in 0..n {
            let (row, column) = (self.find(j).0, self.find(n + j).0);
            let row_shift = self.shift[row].unwrap_or(0.0);
            let column_shift = self.shift[column].unwrap_or(0.0);
            self.r[j] += rounded(self.x[j] + row_shift);
            self.c[j] += rounded(self.x[n + j] - column_shift);
        }
    }

    /// Step 4.
    fn set_gauge(&mut self, at: Measured<'_>) {
        let n = self.n;
        self.gauge.fill([(0, 0); 5]);
        for j in (0..n).filter(|&j| !at.is_fixed(j)) {
            let (row, column) = (self.find(j).0, self.find(n + j).0);
            let (r, c) = (self.r[j], self.c[j]);
            let mut add = |root: usize, kind: usize, exponent: i32| {
                let (sum, count) = &mut self.gauge[root][kind];
                *sum += i64::from(exponent);
                *count += 1;
            };
            let numbers = [
                (column, 0, if at.known[j] { at.sample.z[j] } else { 0.0 }, -c),
                (row, 1, at.sample.f[j], r),
                (column, 2, at.bounds.lower()[j], -c),
                (column, 2, at.bounds.upper()[j], -c),
                (column, 3, at.sample.z[j], -c),
            ];
            for (root, kind, x, scale) in numbers {
                if x != 0.0 && x.is_finite() {
                    add(root, kind, exponent(x) + scale);
                }
            }
            add(row, 4, r - self.old_r[j]);
            add(column, 4, self.old_c[j] - c);
        }
        for j in 0..n {
            let (row, column) = (self.find(j).0, self.find(n + j).0);
            self.r[j] -= gauge(&self.gauge[row]);
            self.c[j] += gauge(&self.gauge[column]);
        }
    }

    /// Rows and columns of fixed variables: the largest entry near 1.
    fn scale_fixed(&mut self, at: Measured<'_>) {
        for j in (0..self.n).filter(|&j| at.is_fixed(j)) {
            (self.r[j], self.c[j]) = (NONE, NONE);
        }
        // Columns first, against rows that have a scale; then rows, against all columns.
        for (k, i, j) in at.pattern.entries() {
            if at.sample.jac[k] != 0.0 && at.is_fixed(j) && !at.is_fixed(i) {
                self.c[j] = self.c[j].max(exponent(at.sample.jac[k]) + self.r[i]);
            }
        }
        for j in (0..self.n).filter(|&j| at.is_fixed(j)) {
            self.c[j] = if self.c[j] == NONE { 0 } else { -self.c[j] };
        }
        for (k, i, j) in at.pattern.entries() {
            if at.sample.jac[k] != 0.0 && at.is_fixed(i) {
                self.r[i] = self.r[i].max(exponent(at.sample.jac[k]) + self.c[j]);
            }
        }
        for i in (0..self.n).filter(|&i| at.is_fixed(i)) {
            self.r[i] = if self.r[i] == NONE { 0 } else { -self.r[i] };
        }
    }
}

/// `⌊x + 0.59⌋`.
#[expect(
    clippy::cast_possible_truncation,
    reason = "exponents and their sums over cycles are small"
)]
fn rounded(x: f64) -> i32 {
    (x + OFFSET).floor() as i32
}

/// The larger mean of the exponents of the known `z` and of `F`, else that of the bounds, else of any
/// `z`, else what keeps the old scales. Rounded downwards, so that it moves with its terms.
fn gauge(sums: &[(i64, i64); 5]) -> i32 {
    let mean = |(sum, count): (i64, i64)| (count > 0).then(|| sum.div_euclid(count));
    let [known, f, bounds, z, old] = sums.map(mean);
    let gauge = known.max(f).or(bounds).or(z).or(old).unwrap_or(0);
    i32::try_from(gauge).expect("a mean of exponents is one")
}

#[cfg(test)]
#[path = "equilibrate_tests.rs"]
mod tests;
