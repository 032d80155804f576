//! The symmetric matrix of a reduced system: whether there is one, and what it is.

use super::Rows;
use crate::linalg::LinearSolver;
use crate::problem::{Index, Pattern, WithDiagonal};

/// `b_i / a_i` up to which row `i` says what `d_i` is.
const KNOWN: f64 = 1e-12;
/// Difference of `t_i J_ij` and `t_j J_ji`, relative to the larger one, that is rounding.
const ASYMMETRY: f64 = 1e-12;

/// The reduced matrix and its solver.
pub(super) struct Symmetric {
    pub(super) linear: Box<dyn LinearSolver>,
    pub(super) is_custom: bool,
    /// Variables whose row says what they do.
    known: Vec<bool>,
    /// Row scales that make `J` symmetric, where it is not as it stands.
    t: Vec<f64>,
    is_scaled: bool,
    /// Residual of the last solution, and its correction.
    pub(super) residual: Vec<f64>,
    pub(super) correction: Vec<f64>,
    pub(super) size: Vec<f64>,
    /// Next entry of each column while symmetry is tested.
    next: Vec<Index>,
}

impl Symmetric {
    /// Of a pattern, with a solver that has been analysed. Solutions of iterative ones are not improved.
    pub(super) fn new(n: usize, linear: Box<dyn LinearSolver>, is_custom: bool) -> Self {
        let improved = if linear.is_iterative() { 0 } else { n };
        let zeros = || vec![0.0; improved];
        Symmetric {
            linear,
            is_custom,
            known: vec![false; n],
            t: zeros(),
            is_scaled: false,
            residual: zeros(),
            correction: zeros(),
            size: zeros(),
            next: Vec::with_capacity(n),
        }
    }

    fn t(&self, i: usize) -> f64 {
        if self.is_scaled { self.t[i] } else { 1.0 }
    }

    /// Whether `diag(t) J` is symmetric up to rounding with some `t ≠ 0`: with 1, or else one that a sweep
    /// finds.
    pub(super) fn is_symmetric(&mut self, pattern: &Pattern, jac: &[f64]) -> bool {
        self.is_scaled = false;
        let mut is_symmetric = self.sweep(pattern, jac);
        if !is_symmetric {
            self.is_scaled = true;
            self.t.clear();
            self.t.resize(pattern.n(), 0.0);
            is_symmetric = self.sweep(pattern, jac);
        }
        if self.linear.is_iterative() {
            // Little work beside that of factors, much memory beside that of none.
            self.next = Vec::new();
        }
        is_symmetric
    }

    /// Compares `t_i J_ij` and `t_j J_ji`. Scales yet to be found are `t_i = t_j J_ji / J_ij` for the first
    /// neighbour `j` of `i`.
    fn sweep(&mut self, pattern: &Pattern, jac: &[f64]) -> bool {
        self.next.clear();
        self.next.extend_from_slice(&pattern.stored().0[..pattern.n()]);
        for j in 0..pattern.n() {
            if self.is_scaled && self.t[j] == 0.0 {
                self.t[j] = 1.0;
            }
            for k in pattern.column(j) {
                let i = pattern.row(k);
                // Columns are swept in order, so the partners in column i come in order too.
                let partner = self.next[i] as usize;
                self.next[i] += 1;
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
                if self.is_scaled && self.t[i] == 0.0 {
                    self.t[i] = self.t[j] * upper / lower;
                    if !self.t[i].is_normal() {
                        return false;
                    }
                }
                let (lower, upper) = (self.t(i) * lower, self.t(j) * upper);
                if !((lower - upper).abs() <= ASYMMETRY * lower.abs().max(upper.abs())) {
                    return false;
                }
            }
        }
        true
    }

    /// Sees which variables are known; false if a row is not of its kind.
    pub(super) fn find_known(&mut self, (a, b): Rows<'_>) -> bool {
        for (known, (&a, &b)) in self.known.iter_mut().zip(a.iter().zip(b)) {
            if !(a >= 0.0 && b >= 0.0) {
                return false;
            }
            *known = b <= KNOWN * a;
        }
        true
    }

    /// The reduced matrix in the place of `J`, whose pattern has the diagonal.
    pub(super) fn reduce(&self, of: &WithDiagonal, values: &mut [f64], (a, b): Rows<'_>) {
        let (known, pattern) = (&self.known, of.pattern());
        for j in 0..pattern.n() {
            for k in pattern.column(j) {
                let i = pattern.row(k);
                values[k] = if known[i] || known[j] { 0.0 } else { self.t(i) * values[k] };
            }
        }
        for (j, &known) in known.iter().enumerate() {
            let diagonal = &mut values[of.diagonal(j)];
            *diagonal = if known { 1.0 } else { *diagonal + self.t(j) * a[j] / b[j] };
        }
    }

    /// The right-hand side of the reduced system, and the solution where it is known.
    pub(super) fn reduce_right(
        &self,
        pattern: &Pattern,
        jac: &[f64],
        (a, b): Rows<'_>,
        r: &[f64],
        d: &mut [f64],
    ) {
        let known = &self.known;
        for (i, d) in d.iter_mut().enumerate() {
            *d = if known[i] { -r[i] / a[i] } else { -self.t(i) * r[i] / b[i] };
        }
        for j in (0..known.len()).filter(|&j| known[j]) {
            if d[j] != 0.0 {
                for k in pattern.column(j) {
                    let i = pattern.row(k);
                    if !known[i] {
                        d[i] -= self.t(i) * jac[k] * d[j];
                    }
                }
            }
        }
    }
}
