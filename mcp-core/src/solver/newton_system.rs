//! [`NewtonSystem`]: the linear system of a Newton step, reduced where rows say what their variable
//! does, and symmetric where `J` is.
//!
//! ```text
//! a_i d_i + b_i (J d)_i = −r_i
//! known      b_i <= 10⁻¹² a_i:   d_i = −r_i / a_i                          min map: variables at a bound
//! reduced    T (J_FF + diag(a_F / b_F)) d_F = −T (r_F / b_F + J_FK d_K)    F the other variables
//! ```
//!
//! Where `T J` is symmetric with a diagonal `T`, so is the reduced matrix. `T = I` where `F` is a gradient,
//! another positive `T` where its equations or variables are in units of their own: the matrix is definite
//! for obstacle, contact and convex potential problems, and Cholesky takes a fifth to a third of the time
//! of LU. `T` has both signs for markets and Karush–Kuhn–Tucker systems, `J = [A −Bᵀ; B C]`: the matrix is
//! quasi-definite if prices and quantities both move their own equation, and `L D Lᵀ` in an order chosen
//! for its fill takes the place of LU, whose pivots may destroy that order. The reduced matrix keeps the
//! pattern of `J`: a known variable has the row and column of the identity, so that one symbolic
//! analysis serves all iterations.
//!
//! A direct solution is improved while its backward error
//! `max_i |H d + r|_i / (|H| |d| + |r|)_i` exceeds [`BACKWARD`] ([ADD89](crate#references)); one that cannot
//! be brought below [`ACCEPTABLE`], and every other matrix, is left to LU with pivoting, as it stands.

mod symmetric;

use super::options::Options;
use super::solution::Fill;
use crate::error::ModelError;
use crate::linalg::{FaerCholesky, Linear, LinearSolver};
use crate::problem::{Pattern, WithDiagonal};
use symmetric::Symmetric;

/// Backward error above which a solution is improved.
const BACKWARD: f64 = 1e-12;
/// Backward error of a solution that is good enough.
const ACCEPTABLE: f64 = 1e-9;
/// How often a solution is improved.
const CORRECTIONS: usize = 3;

/// Rows `a_i d_i + b_i (J d)_i`.
pub(super) type Rows<'a> = (&'a [f64], &'a [f64]);

/// The matrix `H = diag(a) + diag(b) J` of a Newton system and its factors.
pub(super) struct NewtonSystem {
    /// The pattern of `J`.
    source: Pattern,
    /// That of `H`.
    with_diagonal: WithDiagonal,
    /// Entries of `H` while it is factored. Where `J` has the diagonal, the memory the caller lends takes
    /// their place.
    values: Vec<f64>,
    general: General,
    symmetric: Option<Symmetric>,
    /// Whether there are factors, and whether they are those of the reduced matrix.
    is_factored: bool,
    is_reduced: bool,
}

/// LU of `H`.
struct General {
    linear: Box<dyn LinearSolver>,
    is_analysed: bool,
    /// A linear solver the caller brought is kept whatever the pattern.
    is_custom: bool,
}

impl NewtonSystem {
    /// For the pattern of `J`, with the solver the options choose or the caller brought. That one
    /// stays in `custom` if it refuses the pattern.
    pub(super) fn new(
        source: &Pattern,
        options: &Options,
        custom: &mut Option<Box<dyn LinearSolver>>,
    ) -> Result<Self, ModelError> {
        let with_diagonal = source.with_diagonal();
        let pattern = with_diagonal.pattern();
        if let Some(linear) = custom {
            linear.analyse(pattern)?;
        }
        let n = pattern.n();
        let may_be_symmetric = || source.is_symmetric();
        let symmetric = match custom {
            Some(linear) if linear.needs_symmetry() => {
                custom.take().map(|linear| Symmetric::new(n, linear, true))
            }
            None if options.linear == Linear::Auto
                && options.linear.resolve(pattern) == Linear::FaerSparse
                && may_be_symmetric() =>
            {
                let mut cholesky = FaerCholesky::new();
                cholesky.analyse(pattern)?;
                Some(Symmetric::new(n, Box::new(cholesky), false))
            }
            _ => None,
        };
        let is_custom = custom.is_some();
        let linear = match custom.take() {
            Some(linear) => linear,
            None => options.linear.solver_for(pattern)?,
        };
        let mut general = General { linear, is_analysed: is_custom, is_custom };
        if symmetric.is_none() && !is_custom {
            general.linear.analyse(pattern)?;
            general.is_analysed = true;
        }
        Ok(NewtonSystem {
            source: source.clone(),
            values: vec![0.0; if with_diagonal.is_unchanged() { 0 } else { pattern.nnz() }],
            with_diagonal,
            general,
            symmetric,
            is_factored: false,
            is_reduced: false,
        })
    }

    /// Whether this system was made for that pattern of `J`.
    pub(super) fn fits(&self, pattern: &Pattern) -> bool {
        self.source == *pattern
    }

    /// The linear solver the caller brought, if it was one.
    pub(super) fn into_custom(self) -> Option<Box<dyn LinearSolver>> {
        let reduced = self.symmetric.filter(|symmetric| symmetric.is_custom);
        let general = self.general.is_custom.then_some(self.general.linear);
        reduced.map(|symmetric| symmetric.linear).or(general)
    }

    /// Forgets the factors of the last solve.
    pub(super) fn begin(&mut self) {
        (self.is_factored, self.is_reduced) = (false, false);
    }

    /// Entries of `H`, and of the factors at hand.
    pub(super) fn fill(&self) -> Fill {
        let reduced = self.symmetric.as_ref().filter(|_| self.is_reduced);
        let linear = reduced.map_or(&self.general.linear, |symmetric| &symmetric.linear);
        let factors = if self.is_factored { linear.fill() } else { None };
        Fill { matrix: self.with_diagonal.pattern().nnz(), factors }
    }

    /// How far an iterative solver has to reduce the residual of the next system.
    pub(super) fn set_accuracy(&mut self, relative: f64) {
        self.general.linear.set_accuracy(relative);
        if let Some(symmetric) = &mut self.symmetric {
            symmetric.linear.set_accuracy(relative);
        }
    }

    /// Solves `H d = −r`; false if the matrix is singular or `d` not finite. `spare` is memory for as many
    /// numbers as `J` has entries.
    pub(super) fn solve(
        &mut self,
        jac: &[f64],
        spare: &mut [f64],
        rows: Rows<'_>,
        r: &[f64],
        d: &mut [f64],
    ) -> bool {
        self.factor(jac, spare, rows).is_some() && {
            self.back_solve(jac, spare, rows, r, d);
            d.iter().all(|d| d.is_finite())
        }
    }

    /// Factors `H` and returns its pivot ratio; `None` if it is singular.
    pub(super) fn factor(&mut self, jac: &[f64], spare: &mut [f64], rows: Rows<'_>) -> Option<f64> {
        if self.is_symmetric(jac, rows) {
            self.reduce(jac, spare, rows);
            let symmetric = self.symmetric.as_mut()?;
            let values = if self.with_diagonal.is_unchanged() { &*spare } else { &self.values[..] };
            if let Ok(info) = symmetric.linear.factor(values) {
                (self.is_factored, self.is_reduced) = (true, true);
                return Some(info.pivot_ratio);
            }
        }
        self.factor_general(jac, spare, rows)
    }

    /// LU of `H`.
    fn factor_general(&mut self, jac: &[f64], spare: &mut [f64], (a, b): Rows<'_>) -> Option<f64> {
        let General { linear, is_analysed, .. } = &mut self.general;
        let with_diagonal = &self.with_diagonal;
        (self.is_factored, self.is_reduced) = (false, false);
        if !*is_analysed {
            linear.analyse(with_diagonal.pattern()).ok()?;
            *is_analysed = true;
        }
        // H = diag(a) + diag(b) J.
        let values = if with_diagonal.is_unchanged() { spare } else { &mut self.values };
        values.fill(0.0);
        for (k, (i, &value)) in self.source.rows().zip(jac).enumerate() {
            values[with_diagonal.entry(k)] = b[i] * value;
        }
        for (j, &a) in a.iter().enumerate() {
            values[with_diagonal.diagonal(j)] += a;
        }
        let info = linear.factor(values).ok()?;
        self.is_factored = true;
        Some(info.pivot_ratio)
    }

    /// `d` of the system factored last, with the right-hand side `−r`; NaN if there is none.
    pub(super) fn back_solve(
        &mut self,
        jac: &[f64],
        spare: &mut [f64],
        rows: Rows<'_>,
        r: &[f64],
        d: &mut [f64],
    ) {
        if self.is_reduced && self.back_solve_reduced(jac, rows, r, d) {
            return;
        }
        if self.is_reduced && self.factor_general(jac, spare, rows).is_none() {
            d.fill(f64::NAN);
            return;
        }
        for (d, r) in d.iter_mut().zip(r) {
            *d = -r;
        }
        self.general.linear.solve(d);
    }

    /// Whether a symmetric solver is at hand and the reduced matrix is one for it.
    pub(super) fn is_symmetric(&mut self, jac: &[f64], rows: Rows<'_>) -> bool {
        let Some(symmetric) = &mut self.symmetric else { return false };
        symmetric.is_symmetric(&self.source, jac) && symmetric.find_known(rows)
    }

    /// Assembles the reduced matrix.
    fn reduce(&mut self, jac: &[f64], spare: &mut [f64], rows: Rows<'_>) {
        let with_diagonal = &self.with_diagonal;
        let Some(symmetric) = &self.symmetric else { return };
        let values = if with_diagonal.is_unchanged() {
            spare.copy_from_slice(jac);
            spare
        } else {
            self.values.fill(0.0);
            for (k, &value) in jac.iter().enumerate() {
                self.values[with_diagonal.entry(k)] = value;
            }
            &mut self.values
        };
        symmetric.reduce(with_diagonal, values, rows);
    }

    /// The reduced system: known variables, their share of the other rows, a solve, corrections. False
    /// if the solution is not accurate.
    fn back_solve_reduced(
        &mut self,
        jac: &[f64],
        rows: Rows<'_>,
        r: &[f64],
        d: &mut [f64],
    ) -> bool {
        let (a, b) = rows;
        let pattern = &self.source;
        let Some(symmetric) = &mut self.symmetric else { return false };
        symmetric.reduce_right(pattern, jac, rows, r, d);
        symmetric.linear.solve(d);
        if symmetric.linear.is_iterative() {
            // NaN where the matrix was not definite.
            return d.iter().all(|d| d.is_finite());
        }
        let mut before = f64::INFINITY;
        for k in 0..=CORRECTIONS {
            let Symmetric { residual, size, .. } = &mut *symmetric;
            residual_of(pattern, (jac, a, b), r, d, (residual, size));
            let error =
                residual.iter().zip(&*size).map(|(r, s)| if *r == 0.0 { 0.0 } else { r.abs() / s });
            // NaN stays.
            let error = error.fold(0.0, |most: f64, e| if e <= most { most } else { e });
            if error <= BACKWARD {
                return true;
            }
            if k == CORRECTIONS || !(error < before) {
                return error <= ACCEPTABLE;
            }
            before = error;
            let mut correction = std::mem::take(&mut symmetric.correction);
            symmetric.reduce_right(pattern, jac, rows, &symmetric.residual, &mut correction);
            symmetric.linear.solve(&mut correction);
            for (d, c) in d.iter_mut().zip(&correction) {
                *d += c;
            }
            symmetric.correction = correction;
        }
        false
    }

    /// Whether [`solve_in_place`](Self::solve_in_place) is possible: with an iterative solver, where `J` has
    /// the diagonal.
    pub(super) fn takes_place_of_jacobian(&self) -> bool {
        self.with_diagonal.is_unchanged()
            && self.symmetric.as_ref().is_some_and(|symmetric| symmetric.linear.is_iterative())
    }

    /// Solves the reduced system in the memory of `J`, after [`is_symmetric`](Self::is_symmetric): the matrix
    /// takes the place of `J`, the fields of the iteration that of the matrix. False if there is no solution.
    pub(super) fn solve_in_place(
        &mut self,
        jac: &mut [f64],
        rows: Rows<'_>,
        r: &[f64],
        d: &mut [f64],
    ) -> bool {
        let Some(symmetric) = &mut self.symmetric else { return false };
        symmetric.reduce_right(&self.source, jac, rows, r, d);
        symmetric.reduce(&self.with_diagonal, jac, rows);
        if symmetric.linear.factor(jac).is_err() {
            return false;
        }
        (self.is_factored, self.is_reduced) = (true, true);
        symmetric.linear.solve_with(d, jac);
        d.iter().all(|d| d.is_finite())
    }

    /// Gives back the memory of factors that cost little: another system has to be factored next.
    pub(super) fn release(&mut self) {
        self.begin();
        if let Some(symmetric) = &mut self.symmetric {
            symmetric.linear.release();
        }
        self.general.linear.release();
    }
}

/// `r + H d` and the size of its terms.
fn residual_of(
    pattern: &Pattern,
    (jac, a, b): (&[f64], &[f64], &[f64]),
    r: &[f64],
    d: &[f64],
    (residual, size): (&mut [f64], &mut [f64]),
) {
    for i in 0..d.len() {
        residual[i] = r[i] + a[i] * d[i];
        size[i] = r[i].abs() + a[i] * d[i].abs();
    }
    for (j, &d) in d.iter().enumerate() {
        for k in pattern.column(j) {
            let i = pattern.row(k);
            let term = b[i] * jac[k] * d;
            residual[i] += term;
            size[i] += term.abs();
        }
    }
}

#[cfg(test)]
#[path = "newton_system_tests.rs"]
mod tests;
