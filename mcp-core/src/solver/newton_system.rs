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

use super::options::Options;
use super::solution::Fill;
use crate::error::ModelError;
use crate::linalg::{FaerCholesky, Linear, LinearSolver};
use crate::problem::{Index, Pattern, WithDiagonal};

/// `b_i / a_i` up to which row `i` says what `d_i` is.
const KNOWN: f64 = 1e-12;
/// Difference of `t_i J_ij` and `t_j J_ji`, relative to the larger one, that is rounding.
const ASYMMETRY: f64 = 1e-12;
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

/// The reduced matrix and its solver.
struct Symmetric {
    linear: Box<dyn LinearSolver>,
    is_custom: bool,
    /// Variables whose row says what they do.
    known: Vec<bool>,
    /// Row scales that make `J` symmetric.
    t: Vec<f64>,
    /// Residual of the last solution, and its correction.
    residual: Vec<f64>,
    correction: Vec<f64>,
    size: Vec<f64>,
    /// Next entry of each column while symmetry is tested.
    next: Vec<Index>,
}

impl Symmetric {
    /// Of a pattern, with a solver that has been analysed.
    fn new(n: usize, linear: Box<dyn LinearSolver>, is_custom: bool) -> Self {
        let zeros = || vec![0.0; n];
        Symmetric {
            linear,
            is_custom,
            known: vec![false; n],
            t: zeros(),
            residual: zeros(),
            correction: zeros(),
            size: zeros(),
            next: Vec::with_capacity(n),
        }
    }
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
        if self.is_symmetric(jac) && self.reduce(jac, spare, rows) {
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

    /// Whether a symmetric solver is at hand and `diag(t) J` is symmetric up to rounding with some
    /// `t ≠ 0`, which it finds in one sweep: `t_i = t_j J_ji / J_ij` for the first neighbour `j` of `i`.
    fn is_symmetric(&mut self, jac: &[f64]) -> bool {
        let Some(Symmetric { next, t, .. }) = &mut self.symmetric else { return false };
        let pattern = &self.source;
        next.clear();
        next.extend_from_slice(&pattern.stored().0[..pattern.n()]);
        t.fill(0.0);
        for j in 0..pattern.n() {
            if t[j] == 0.0 {
                t[j] = 1.0;
            }
            for k in pattern.column(j) {
                let i = pattern.row(k);
                // Columns are swept in order, so the partners in column i come in order too.
                let partner = next[i] as usize;
                next[i] += 1;
                if i <= j {
                    continue;
                }
                let is_partner = partner < pattern.column(i).end && pattern.row(partner) == j;
                if !is_partner {
                    return false;
                }
                let (lower, upper) = (jac[k], jac[partner]);
                if lower == 0.0 && upper == 0.0 {
                    continue;
                }
                if t[i] == 0.0 {
                    t[i] = t[j] * upper / lower;
                    if !t[i].is_normal() {
                        return false;
                    }
                }
                let (lower, upper) = (t[i] * lower, t[j] * upper);
                if !((lower - upper).abs() <= ASYMMETRY * lower.abs().max(upper.abs())) {
                    return false;
                }
            }
        }
        true
    }

    /// Assembles the reduced matrix; false if a row is not of its kind.
    fn reduce(&mut self, jac: &[f64], spare: &mut [f64], (a, b): Rows<'_>) -> bool {
        let with_diagonal = &self.with_diagonal;
        let Some(Symmetric { known, t, .. }) = &mut self.symmetric else { return false };
        for (known, (&a, &b)) in known.iter_mut().zip(a.iter().zip(b)) {
            if !(a >= 0.0 && b >= 0.0) {
                return false;
            }
            *known = b <= KNOWN * a;
        }
        let values = if with_diagonal.is_unchanged() { spare } else { &mut self.values };
        values.fill(0.0);
        for j in 0..self.source.n() {
            for k in self.source.column(j) {
                let i = self.source.row(k);
                if !(known[i] || known[j]) {
                    values[with_diagonal.entry(k)] = t[i] * jac[k];
                }
            }
        }
        for (j, &known) in known.iter().enumerate() {
            let to = with_diagonal.diagonal(j);
            if known {
                values[to] = 1.0;
            } else {
                values[to] += t[j] * a[j] / b[j];
            }
        }
        true
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
        let Symmetric { linear, known, t, residual, correction, size, .. } = symmetric;
        let solve = |linear: &mut dyn LinearSolver, r: &[f64], d: &mut [f64]| {
            for (i, d) in d.iter_mut().enumerate() {
                *d = if known[i] { -r[i] / a[i] } else { -t[i] * r[i] / b[i] };
            }
            for j in (0..known.len()).filter(|&j| known[j]) {
                if d[j] != 0.0 {
                    for k in pattern.column(j) {
                        let i = pattern.row(k);
                        if !known[i] {
                            d[i] -= t[i] * jac[k] * d[j];
                        }
                    }
                }
            }
            linear.solve(d);
        };
        solve(&mut **linear, r, d);
        if linear.is_iterative() {
            // NaN where the matrix was not definite.
            return d.iter().all(|d| d.is_finite());
        }
        let mut before = f64::INFINITY;
        for k in 0..=CORRECTIONS {
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
            solve(&mut **linear, residual, correction);
            for (d, c) in d.iter_mut().zip(&*correction) {
                *d += c;
            }
        }
        false
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
