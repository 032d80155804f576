//! [`Certificate`]: the one judge of solutions.
//!
//! It evaluates `F` and `J` itself, at the returned point, and shares no code with the solvers.
//!
//! ```text
//! natural residual    r = max_i | mid(z_i − l_i,  F_i,  z_i − u_i) |
//! relative residual   e = max_i | mid((z_i − l_i)/w_i,  F_i/s_i,  (z_i − u_i)/w_i) |
//!                     w_j = |z_j| + τ_j,    s_i = Σ_j |J_ij| w_j
//! ```
//!
//! `r` has the units of the model: it accepts wrong points where `F` is in small units and can
//! never accept right ones where it is in large units. `e` has none: `s_i` is the size of the terms
//! of `F_i`. Scaling equations by powers of two leaves `e` as it is, bit for bit; scaling variables
//! changes it only through `τ`, by a small factor.
//!
//! `τ_j` says what counts as small for variable `j`, and matters only where `z_j` is near 0. It is
//! the column scale of the equilibrated `J(z)`, in binary exponents, times one gauge for every block
//! of variables that `J` connects: the geometric mean of `|z_j|` over the block in these scales, at
//! least 10⁻⁴ of the same mean over the problem's start. A block that is 0 at both has the mean of
//! `|F_i|` in the scales of the rows instead, the size of a Newton step, at least √ε times a gauge that
//! makes no `τ_j` and no `s_i` larger than 1: there the rounding of numbers of order 1 is accepted.
//! Cost: one pass and a few sweeps over the nonzeros.
//!
//! What no test of this kind can tell: an equation that is satisfied because it no longer depends
//! on anything (`0 = 0`) looks like a solution at infinity and is called asymptotic; variables that are
//! 0 at the point and at the start have no scale but that of `F` and `J`.

use crate::error::ModelError;
use crate::problem::{Index, Pattern, Problem, small};

/// What was found at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Certificate {
    /// `max_i |mid(z_i − l_i, F_i, z_i − u_i)|`, in the units of the model; NaN if `F` is.
    pub natural_residual: f64,
    /// Variable of the largest natural residual; its equation is the worst one.
    pub worst: usize,
    /// Row-relative residual, without units; NaN if `F` or `J` is not finite.
    pub relative_residual: f64,
    /// Variable of the largest relative residual.
    pub worst_relative: usize,
    /// Largest violation of a bound; 0 for every point a solver returns.
    pub bound_violation: f64,
    /// Whether `F` and `J` are finite.
    pub is_finite: bool,
    /// An equation that must hold but no longer depends on any variable: all its derivatives are
    /// zero or subnormal.
    pub vanishing_row: Option<usize>,
    /// A variable beyond 10¹² times its start (or 1).
    pub diverging: Option<usize>,
}

/// What a certificate means for given tolerances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// A solution.
    Accepted,
    /// Small residuals at a point that looks like a solution at infinity.
    Asymptotic,
    /// Not a solution.
    Refused,
}

impl Certificate {
    /// Before anything was judged.
    pub(crate) fn nothing() -> Self {
        Certificate {
            natural_residual: f64::NAN,
            worst: 0,
            relative_residual: f64::NAN,
            worst_relative: 0,
            bound_violation: 0.0,
            is_finite: false,
            vanishing_row: None,
            diverging: None,
        }
    }

    /// The definition of a solution: in the box, `F` and `J` finite, `e <= tol_relative`, and
    /// `r <= tol` if an absolute tolerance is set.
    ///
    /// Where `r <= tol` but an equation has lost its derivatives, or `e` stays large while a
    /// variable runs away, it is asymptotic. Without an absolute tolerance `e` alone decides.
    pub fn verdict(&self, tol: Option<f64>, tol_relative: f64) -> Verdict {
        let in_box = self.bound_violation <= 0.0;
        let relative = self.relative_residual <= tol_relative;
        let small = tol.map_or(relative, |tol| self.natural_residual <= tol);
        if !(in_box && self.is_finite && small) {
            Verdict::Refused
        } else if self.vanishing_row.is_some() {
            Verdict::Asymptotic
        } else if relative {
            Verdict::Accepted
        } else if self.diverging.is_some() {
            Verdict::Asymptotic
        } else {
            Verdict::Refused
        }
    }
}

/// Examines `z`: computes `F` and `J` there and measures.
///
/// # Errors
/// [`ModelError::Length`] if `z` does not have one entry for each variable.
///
/// ```
/// use mcp_core::{AdProblem, Verdict, examine};
/// # use mcp_core::{Equation, Model, Reader, Real, Scalar, Shape, Variable};
/// # struct Line(Shape);
/// # impl Model for Line {
/// #     fn shape(&self) -> &Shape { &self.0 }
/// #     fn row<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
/// #         2.0 * read.var(0) - 4.0
/// #     }
/// # }
/// # let shape = Shape::builder().variable(Variable::new("x").lower(0.0))
/// #     .equation(Equation::new("f").complements("x")).build()?;
/// let mut problem = AdProblem::new(Line(shape))?; // 2x − 4 ⟂ x >= 0
/// assert_eq!(examine(&mut problem, &[2.0])?.verdict(None, 1e-8), Verdict::Accepted);
/// assert_eq!(examine(&mut problem, &[2.1])?.verdict(None, 1e-8), Verdict::Refused);
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
pub fn examine(problem: &mut dyn Problem, z: &[f64]) -> Result<Certificate, ModelError> {
    let n = problem.shape().n();
    if z.len() != n {
        return Err(ModelError::Length { what: "z".to_owned(), expected: n, found: z.len() });
    }
    let mut certifier = Certifier::default();
    certifier.resize(n, problem.pattern().nnz());
    Ok(certifier.judge(problem, z))
}

/// Workspace of the judge.
#[derive(Clone, Debug, Default)]
pub(crate) struct Certifier {
    f: Vec<f64>,
    jac: Vec<f64>,
    row_scale: Vec<i32>,
    column_scale: Vec<i32>,
    row_max: Vec<i32>,
    column_max: Vec<i32>,
    /// For every variable one further on the way to the representative of its block.
    block: Vec<Index>,
    /// By representative of a block: means at the point and at the start, and the gauge.
    mean_z: Vec<Mean>,
    mean_start: Vec<Mean>,
    gauge: Vec<i32>,
    weight: Vec<f64>,
    row_size: Vec<f64>,
}

/// Sum and number of binary exponents of the variables of a block, in column scales.
type Mean = [i64; 2];

/// Takes in `z`, unless it is 0.
fn add(mean: &mut Mean, z: f64, scale: i32) {
    if z != 0.0 && z.is_finite() {
        mean[0] += i64::from(exponent(z) - scale);
        mean[1] += 1;
    }
}

fn value([sum, count]: Mean) -> Option<i32> {
    let mean = (count > 0).then(|| sum / count)?;
    Some(i32::try_from(mean).expect("a mean of small exponents is small"))
}

/// The gauge of a block from its means at the point and at the start; none if all is 0. 2⁻¹³ is about
/// 10⁻⁴.
fn gauge(at_z: Mean, at_start: Mean) -> Option<i32> {
    match (value(at_z), value(at_start)) {
        (Some(at_z), Some(at_start)) => Some(at_z.max(at_start - 13)),
        (gauge, None) | (None, gauge) => gauge,
    }
}

/// Binary exponent of √ε.
const ROUNDING: i32 = -26;

/// Exponent for "no nonzero seen yet".
const NONE: i32 = i32::MIN / 4;

impl Certifier {
    pub(crate) fn resize(&mut self, n: usize, nnz: usize) {
        // Fresh zeros cost no memory before they are written.
        self.jac = vec![0.0; nnz];
        for list in [&mut self.f, &mut self.weight, &mut self.row_size] {
            *list = vec![0.0; n];
        }
        for scale in
            [&mut self.row_scale, &mut self.column_scale, &mut self.row_max, &mut self.column_max]
        {
            *scale = vec![0; n];
        }
        self.gauge = vec![0; n];
        self.block = vec![0; n];
        (self.mean_z, self.mean_start) = (vec![[0; 2]; n], vec![[0; 2]; n]);
    }

    /// `F` at the point judged last.
    pub(crate) fn f(&self) -> &[f64] {
        &self.f
    }

    /// The same, to be taken out; another list of `n` numbers has to take its place.
    pub(crate) fn f_mut(&mut self) -> &mut Vec<f64> {
        &mut self.f
    }

    /// `w_j`, what counts as the size of each variable at the point judged last.
    pub(crate) fn weight(&self) -> &[f64] {
        &self.weight
    }

    /// `s_i`, the size of the terms of each equation at the point judged last.
    pub(crate) fn row_size(&self) -> &[f64] {
        &self.row_size
    }

    /// `J` at the point judged last.
    pub(crate) fn jac(&self) -> &[f64] {
        &self.jac
    }

    /// The memory of `J`, for other use between two judgements.
    pub(crate) fn spare(&mut self) -> &mut Vec<f64> {
        &mut self.jac
    }

    pub(crate) fn judge(&mut self, problem: &mut dyn Problem, z: &[f64]) -> Certificate {
        problem.evaluate(z, Some(&mut self.f), Some(&mut self.jac));
        let (shape, pattern) = (problem.shape(), problem.pattern());
        let (lower, upper) = (shape.bounds().lower(), shape.bounds().upper());
        let is_finite = all_finite(&self.f) && all_finite(&self.jac) && all_finite(z);
        if is_finite {
            self.equilibrate(pattern);
            self.connect(pattern);
            self.weigh(z, shape.start());
            self.size_rows(pattern);
        }

        let relative_residual = if is_finite { 0.0 } else { f64::NAN };
        let mut certificate = Certificate {
            natural_residual: 0.0,
            relative_residual,
            is_finite,
            ..Certificate::nothing()
        };
        for i in 0..z.len() {
            let (above, below, f) = (z[i] - lower[i], z[i] - upper[i], self.f[i]);
            let natural = middle(above, f, below).abs();
            // `!(<=)` also takes NaN, which then stays the worst.
            if !(natural <= certificate.natural_residual) {
                certificate.natural_residual = natural;
                certificate.worst = i;
            }
            if natural.is_nan() {
                break;
            }
            certificate.bound_violation = certificate.bound_violation.max(-above).max(below);
            if z[i].abs() > 1e12 * shape.start()[i].abs().max(1.0) {
                certificate.diverging.get_or_insert(i);
            }
            if !is_finite {
                continue;
            }
            let (w, s) = (self.weight[i], self.row_size[i]);
            // A size that has overflowed must not make the residual 0.
            let f_relative = if f == 0.0 { 0.0 } else { f / s.min(f64::MAX) };
            let relative = middle(above / w, f_relative, below / w).abs();
            if !(relative <= certificate.relative_residual) {
                certificate.relative_residual = relative;
                certificate.worst_relative = i;
            }
            let must_hold = above > f && below < f;
            if must_hold && s == 0.0 {
                certificate.vanishing_row.get_or_insert(i);
            }
        }
        certificate
    }

    /// Binary exponents of row and column scales that bring the largest entry of every row and
    /// column of `J` near 1 ([Rui01](crate#references), in integers; at most ten sweeps).
    fn equilibrate(&mut self, pattern: &Pattern) {
        self.column_scale.fill(0);
        // Rows first: in whatever units an equation is, the columns see the same matrix.
        self.row_max.fill(NONE);
        for (i, &entry) in pattern.rows().zip(&self.jac) {
            if entry != 0.0 {
                self.row_max[i] = self.row_max[i].max(exponent(entry));
            }
        }
        for (scale, &max) in self.row_scale.iter_mut().zip(&self.row_max) {
            *scale = if max == NONE { 0 } else { -max };
        }
        for _ in 0..10 {
            self.row_max.fill(NONE);
            self.column_max.fill(NONE);
            for j in 0..pattern.n() {
                for k in pattern.column(j) {
                    let i = pattern.row(k);
                    if self.jac[k] != 0.0 {
                        let e = exponent(self.jac[k]) + self.row_scale[i] + self.column_scale[j];
                        self.row_max[i] = self.row_max[i].max(e);
                        self.column_max[j] = self.column_max[j].max(e);
                    }
                }
            }
            let mut balanced = true;
            let rows = self.row_scale.iter_mut().zip(&self.row_max);
            let columns = self.column_scale.iter_mut().zip(&self.column_max);
            for (scale, &max) in rows.chain(columns) {
                if max != NONE {
                    *scale -= max / 2;
                    balanced &= max.abs() <= 1;
                }
            }
            if balanced {
                break;
            }
        }
    }

    /// Blocks of variables that nonzeros of `J` connect, equation `i` going with variable `i`.
    fn connect(&mut self, pattern: &Pattern) {
        for (block, j) in self.block.iter_mut().zip(0..) {
            *block = j;
        }
        let mut blocks = pattern.n();
        for j in 0..pattern.n() {
            for k in pattern.column(j) {
                if blocks <= 1 {
                    return;
                }
                if self.jac[k] != 0.0 {
                    let (a, b) = (self.representative(pattern.row(k)), self.representative(j));
                    self.block[a.max(b)] = small(a.min(b));
                    blocks -= usize::from(a != b);
                }
            }
        }
    }

    /// The smallest variable known to be in the block, with the way there halved.
    fn representative(&mut self, mut j: usize) -> usize {
        while self.block[j] as usize != j {
            self.block[j] = self.block[self.block[j] as usize];
            j = self.block[j] as usize;
        }
        j
    }

    /// `w_j = |z_j| + τ_j`.
    fn weigh(&mut self, z: &[f64], start: &[f64]) {
        self.measure(z, start);
        for j in 0..z.len() {
            let block = self.representative(j);
            let exponent = (self.gauge[block] + self.column_scale[j]).clamp(-1000, 1000);
            self.weight[j] = z[j].abs() + 2_f64.powi(exponent);
        }
    }

    /// The gauges of all blocks.
    fn measure(&mut self, z: &[f64], start: &[f64]) {
        for j in (0..z.len()).filter(|&j| self.block[j] as usize == j) {
            (self.mean_z[j], self.mean_start[j]) = ([0; 2], [0; 2]);
        }
        for j in 0..z.len() {
            let block = self.representative(j);
            add(&mut self.mean_z[block], z[j], self.column_scale[j]);
            add(&mut self.mean_start[block], start[j], self.column_scale[j]);
        }
        let mut all_known = true;
        for j in (0..z.len()).filter(|&j| self.block[j] as usize == j) {
            let gauge = gauge(self.mean_z[j], self.mean_start[j]);
            self.gauge[j] = gauge.unwrap_or(NONE);
            all_known &= gauge.is_some();
        }
        if !all_known {
            self.measure_by_f();
        }
    }

    /// The gauges of the blocks that have none yet, from `F`.
    fn measure_by_f(&mut self) {
        // Means of `F` in place of those of `z`, which are empty, and the unit gauge in place of the
        // means of the start. The representative comes first.
        for i in 0..self.f.len() {
            let block = self.representative(i);
            if self.gauge[block] == NONE {
                add(&mut self.mean_z[block], self.f[i], -self.row_scale[i]);
                let unit = i64::from(self.row_scale[i].min(-self.column_scale[i]));
                let smallest = if i == block { unit } else { self.mean_start[block][0].min(unit) };
                self.mean_start[block] = [smallest, 1];
            }
        }
        for j in (0..self.f.len()).filter(|&j| self.block[j] as usize == j) {
            if self.gauge[j] == NONE {
                let unit = value(self.mean_start[j]).unwrap_or(0);
                let newton = value(self.mean_z[j]).unwrap_or(unit);
                self.gauge[j] = newton.max(unit + ROUNDING);
            }
        }
    }

    /// `s_i = Σ_j |J_ij| w_j`. Subnormal derivatives count as zero: no solver can divide by them.
    fn size_rows(&mut self, pattern: &Pattern) {
        self.row_size.fill(0.0);
        for j in 0..pattern.n() {
            for k in pattern.column(j) {
                let size = self.jac[k].abs();
                if size >= f64::MIN_POSITIVE {
                    self.row_size[pattern.row(k)] += size * self.weight[j];
                }
            }
        }
    }
}

/// The middle of three numbers with `below <= above`; NaN if any is.
pub(super) fn middle(above: f64, f: f64, below: f64) -> f64 {
    if f.is_nan() || above.is_nan() || below.is_nan() { f64::NAN } else { above.min(below.max(f)) }
}

fn all_finite(values: &[f64]) -> bool {
    values.iter().all(|v| v.is_finite())
}

/// `⌊log₂ |x|⌋` for a nonzero number.
fn exponent(x: f64) -> i32 {
    let biased = (x.to_bits() >> 52 & 0x7ff) as i32;
    if biased > 0 {
        biased - 1023
    } else {
        -1023 - (x.to_bits() << 12).leading_zeros().cast_signed()
    }
}

#[cfg(test)]
#[path = "certificate_tests.rs"]
mod tests;
