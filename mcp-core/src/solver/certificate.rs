//! [`Certificate`]: the one judge of solutions.
//!
//! It evaluates `F` and `J` itself, at the returned point, and shares no code with the solvers.
//!
//! ```text
//! natural residual    r = max_i | mid(z_i − l_i,  F_i,  z_i − u_i) |
//! relative residual   e = max_i | mid((z_i − l_i)/w_i,  F_i/s_i,  (z_i − u_i)/w_i) |
//!                     s_i = Σ_j |J_ij| k_j,    w_j = max(k_j, min_i s_i / |J_ij|)
//! ```
//!
//! `r` has the units of the model: it accepts wrong points where `F` is in small units and can
//! never accept right ones where it is in large units. `e` has none. `s_i` is the size of the terms
//! of `F_i`, and `w_j` the change of `z_j` that would be one of the terms in some equation, but no more than
//! the width of its box, unless `|z_j|` is, and no more than its start (or 1) where that is not 0. Scaling
//! equations by powers of two changes no bit of them; scaling variables neither, but for these numbers 1.
//!
//! `k_j` is `|z_j|`, at least 2⁻¹³ (about 10⁻⁴) of what is known of the size of the variable: its start,
//! or, where that is 0, `s_i / |J_ij|` over the variables that start elsewhere, in the equation where this is
//! nearest to 1; an equation whose variables all start at 0 says `2⁻⁷`. So a variable that starts at 0
//! among others that do has `k_j >= 2⁻²⁰` (about 10⁻⁶) in the units of the model, and the rounding of
//! numbers of order 1 to 10 is accepted.
//!
//! Where `z_i` stands on a bound and `F_i` has the sign that keeps it there, the equation is met whatever
//! its derivatives: they need not be finite (`√z + 1` at 0).
//!
//! Two more looks follow where a point might be accepted. `s_i` is no larger than with `J` at
//! `z ± 10⁻⁸ w`, where rows would be excused by more than `|z|`: beside a wall with an infinite slope `J(z)` says
//! nothing about the way to a root. And `F` must not be infinite where variables next to a bound are
//! put onto it.
//!
//! A variable whose term fades in all equations that must hold, and with it their residuals, is on its way to
//! infinity: `F_i = z^-p` is `1/p` of its term `J_ij z_j`, `e^-z` `1/z` of it, and `F_i` at `2 z_j` a part of
//! both; next to a root `F_i` is a small share of the term, or it changes its sign or grows on the way to `2 z_j`.
//! Cost of all: one pass, a few sweeps over the nonzeros, rarely three passes more, or an `F` for each variable
//! that may fade.
//!
//! What no test of this kind can tell: an equation that is satisfied because it no longer depends
//! on anything (`0 = 0`) looks like a solution at infinity and is called asymptotic; steps below 10⁻¹⁴
//! count as rounding in whatever units a problem with a start of 0 is.

mod looks;
mod sizes;

use crate::error::ModelError;
use crate::model::Shape;
use crate::problem::Problem;
use crate::solver::workspace::resize;
use sizes::Sizes;

/// Relative residual of a point that deserves a second look.
const PROMISING: f64 = 1e-2;

/// What was found at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Certificate {
    /// `max_i |mid(z_i − l_i, F_i, z_i − u_i)|`, in the units of the model; NaN if `F` is.
    pub natural_residual: f64,
    /// Variable of the largest natural residual; its equation is the worst one.
    pub worst: usize,
    /// Row-relative residual, without units; NaN if `F` or a `J` that matters is not finite.
    pub relative_residual: f64,
    /// Variable of the largest relative residual.
    pub worst_relative: usize,
    /// Largest violation of a bound; 0 for every point a solver returns.
    pub bound_violation: f64,
    /// Whether `F` is finite, `J` too but for equations met by a variable on its bound, and `F` is not
    /// infinite on the bounds next to the point.
    pub is_finite: bool,
    /// An equation that must hold but no longer depends on any variable: all its derivatives are
    /// zero or subnormal.
    pub vanishing_row: Option<usize>,
    /// A variable beyond 10¹² times its start (or 1).
    pub diverging: Option<usize>,
    /// A variable beyond 2²⁶ times its start (or 1) while every equation with such variables that must
    /// hold is their terms alone, but for `8ε s_i`: whatever else is in it has been lost in rounding.
    pub constants_lost: Option<usize>,
    /// A variable between its bounds, beyond its start (or 1, if that is 0), that fades out of all equations
    /// that must hold (`v = e^-z`, `v = 0`): its terms are below 10⁻⁵ of their sizes; where it is largest, the
    /// residual is at least 0.003 of its term, also with other variables on their bounds, and at most 3/4 of
    /// that, with the same sign, where it is twice as far. At most eight variables are looked at.
    pub fading: Option<usize>,
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
    /// The variable that makes the point look like a solution at infinity, if one does.
    pub fn runaway(&self) -> Option<usize> {
        self.diverging.or(self.constants_lost).or(self.fading)
    }

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
            constants_lost: None,
            fading: None,
        }
    }

    /// The definition of a solution: in the box, [finite](Self::is_finite), `e <= tol_relative`, and
    /// `r <= tol` if an absolute tolerance is set.
    ///
    /// Where `r <= tol` but an equation has lost its derivatives or its constants, or a variable fades out of all
    /// of them, or `e` stays large while a variable runs away, it is asymptotic. Without an absolute tolerance `e`
    /// alone decides.
    pub fn verdict(&self, tol: Option<f64>, tol_relative: f64) -> Verdict {
        let in_box = self.bound_violation <= 0.0;
        let relative = self.relative_residual <= tol_relative;
        let small = tol.map_or(relative, |tol| self.natural_residual <= tol);
        let is_lost = self.vanishing_row.or(self.constants_lost).is_some();
        if !(in_box && self.is_finite && small) {
            Verdict::Refused
        } else if is_lost || relative && self.fading.is_some() {
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
    Ok(Certifier::default().judge(problem, z))
}

/// Workspace of the judge.
#[derive(Clone, Debug, Default)]
pub(crate) struct Certifier {
    f: Vec<f64>,
    jac: Vec<f64>,
    sizes: Sizes,
    /// Whether an equation that must hold does so only by what `k` adds to its size, or a variable between its
    /// bounds is in no equation.
    leans: bool,
    /// A point beside the one judged, and `F` there.
    beside: Vec<f64>,
    f_beside: Vec<f64>,
}

impl Certifier {
    /// For `n` variables and as many nonzeros; lists of the right length stay as they are.
    pub(crate) fn resize(&mut self, n: usize, nnz: usize) {
        resize(&mut self.jac, nnz);
        for list in [&mut self.f, &mut self.beside, &mut self.f_beside] {
            resize(list, n);
        }
        self.sizes.resize(n);
    }

    /// Exchanges memory with the caller, who lends it for the time of a judgement: for `J`, a point beside and
    /// `F` there, and the sizes of variables and equations.
    pub(crate) fn exchange(&mut self, jac: &mut Vec<f64>, lists: [&mut Vec<f64>; 4]) {
        let Sizes { weight, of_row, .. } = &mut self.sizes;
        let own = [&mut self.beside, &mut self.f_beside, weight, of_row];
        for (own, lent) in own.into_iter().zip(lists) {
            std::mem::swap(own, lent);
        }
        std::mem::swap(&mut self.jac, jac);
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
        &self.sizes.weight
    }

    /// `s_i`, the size of the terms of each equation at the point judged last.
    pub(crate) fn row_size(&self) -> &[f64] {
        &self.sizes.of_row
    }

    /// Whether, at the point judged last, an equation that must hold does so only by what is known of the
    /// sizes of variables beside their values, or a variable between its bounds is in no equation.
    pub(crate) fn leans(&self) -> bool {
        self.leans
    }

    /// Where, at the point judged last, `F` is infinite with variables put onto the bounds next to them: the
    /// equation, its value and that point. Only where residuals are small and the certificate is not finite.
    pub(crate) fn infinite_on_bounds(&self) -> Option<(usize, f64, &[f64])> {
        let i = self.f_beside.iter().position(|f| f.is_infinite())?;
        Some((i, self.f_beside[i], &self.beside))
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
        self.resize(z.len(), problem.pattern().nnz());
        problem.evaluate(z, Some(&mut self.f), Some(&mut self.jac));
        let is_finite = self.forgive(problem, z) && all_finite(&self.f) && all_finite(z);
        if is_finite {
            self.sizes.measure(problem.shape(), problem.pattern(), z, &self.jac);
        }
        let mut certificate = self.compare(problem.shape(), z, is_finite);
        self.leans = false;
        if certificate.relative_residual <= PROMISING {
            let leans = self.leans_on_known(problem, z);
            self.leans = leans || self.has_free_variable(problem, z);
            if leans {
                self.look_beside(problem, z);
                certificate = self.compare(problem.shape(), z, is_finite);
            }
            certificate.constants_lost = self.lost_constants(problem, z);
            certificate.fading = self.fading_variable(problem, z);
            certificate.is_finite = !self.is_infinite_on_bounds(problem, z);
        }
        certificate
    }

    /// Zeros in `J` where it is not finite and need not be: in equations met by a variable on its bound.
    /// Whether it is finite then.
    fn forgive(&mut self, problem: &dyn Problem, z: &[f64]) -> bool {
        if all_finite(&self.jac) {
            return true;
        }
        let bounds = problem.shape().bounds();
        for (entry, i) in self.jac.iter_mut().zip(problem.pattern().rows()) {
            let (l, u, f) = (bounds.lower()[i], bounds.upper()[i], self.f[i]);
            let is_met = z[i] == l && f >= 0.0 || z[i] == u && f <= 0.0;
            if is_met && !entry.is_finite() {
                *entry = 0.0;
            }
        }
        all_finite(&self.jac)
    }

    /// The residuals, from `F` and the sizes.
    fn compare(&self, shape: &Shape, z: &[f64], is_finite: bool) -> Certificate {
        let (lower, upper) = (shape.bounds().lower(), shape.bounds().upper());
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
            let relative = self.relative_residual(shape, z, i);
            if !(relative <= certificate.relative_residual) {
                certificate.relative_residual = relative;
                certificate.worst_relative = i;
            }
            if self.sizes.of_row[i] == 0.0 && above > f && below < f {
                certificate.vanishing_row.get_or_insert(i);
            }
        }
        certificate
    }

    /// `|mid((z_i − l_i)/w_i,  F_i/s_i,  (z_i − u_i)/w_i)|` at the point judged last, where `F` and `J` are
    /// finite.
    pub(crate) fn relative_residual(&self, shape: &Shape, z: &[f64], i: usize) -> f64 {
        let [above, f, below] = self.sizes.relative(shape.bounds(), i, z[i], self.f[i]);
        middle(above, f, below).abs()
    }
}

/// The middle of three numbers with `below <= above`; NaN if any is.
pub(super) fn middle(above: f64, f: f64, below: f64) -> f64 {
    if f.is_nan() || above.is_nan() || below.is_nan() { f64::NAN } else { above.min(below.max(f)) }
}

fn all_finite(values: &[f64]) -> bool {
    values.iter().all(|v| v.is_finite())
}

#[cfg(test)]
#[path = "certificate_tests.rs"]
mod tests;
