//! [`Reference`]: a solution known to more digits than any solver returns.

use super::{AccuracyError, DoubleDouble};
use crate::linalg::Linear;
use crate::model::{BoundKind, Model};
use crate::ncp::{Branch, mid};
use crate::problem::{AdProblem, Problem};
use crate::scalar::Real;
use std::fmt;

/// Where a reference comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A formula.
    ClosedForm,
    /// The problem was made for it: [`Manufactured`](super::Manufactured).
    Manufactured,
    /// Newton's method with `F` in double-double.
    Refined,
}

impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Origin::ClosedForm => "closed form",
            Origin::Manufactured => "manufactured",
            Origin::Refined => "refined",
        })
    }
}

/// A solution in double-double.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// The solution, `n` numbers.
    pub z: Vec<DoubleDouble>,
    /// Relative size of the last step of Newton's method, which has stopped converging at rounding
    /// errors of double-double; 0 for others.
    pub error: f64,
    /// Where it comes from.
    pub origin: Origin,
}

/// Refinement has succeeded once steps are this small, relative to the variables.
const ENOUGH: f64 = 1e-22;
/// Further steps are made down to this size.
const SMALLEST: f64 = 1e-30;
/// Most steps.
const STEPS: usize = 60;
/// What `F` may violate its sign by at a degenerate pair, relative to the rows' sizes.
const SIGN: f64 = 1e-20;

impl Reference {
    /// A solution by a formula, evaluated in double-double.
    pub fn closed_form(z: impl IntoIterator<Item = impl Into<DoubleDouble>>) -> Self {
        let z = z.into_iter().map(Into::into).collect();
        Reference { z, error: 0.0, origin: Origin::ClosedForm }
    }

    /// The solution that a manufactured problem was made for.
    pub fn manufactured(z: &[f64]) -> Self {
        let z = z.iter().map(|&z| z.into()).collect();
        Reference { z, error: 0.0, origin: Origin::Manufactured }
    }

    /// The solution near a given one, by Newton's method with `F` in double-double and `J` in `f64`:
    ///
    /// ```text
    /// z_i = l_i or u_i  where mid(z − l, F, z − u) is at the bound,   J d = −F elsewhere,   z ← z + d.
    /// ```
    ///
    /// Every step gains the digits that the condition of the active equations leaves of `f64`, down
    /// to rounding errors of double-double. The active set is that of the given point, and is
    /// verified at the end.
    ///
    /// # Errors
    /// [`AccuracyError::NotSettled`] where steps do not become smaller than `1e-22`, as at singular
    /// solutions; [`AccuracyError::NoSolution`] if the result violates a bound or a sign;
    /// [`ModelError`](crate::ModelError) for a point of another length and for singular equations.
    pub fn refined<M: Model>(model: &M, near: &[f64]) -> Result<Self, AccuracyError> {
        let mut problem = AdProblem::new(model)?;
        problem.shape().check_start(near)?;
        let shape = std::sync::Arc::clone(problem.shape());
        let (n, bounds) = (shape.n(), shape.bounds());
        let (mut f, mut jac) = (vec![0.0; n], vec![0.0; problem.pattern().nnz()]);
        problem.evaluate(near, Some(&mut f), None);

        let mut z: Vec<Real<DoubleDouble>> = near.iter().map(|&z| Real::from(z)).collect();
        let mut is_active = vec![false; n];
        for i in 0..n {
            let (l, u) = (bounds.lower()[i], bounds.upper()[i]);
            let bound = match mid(near[i], f[i], l, u).1 {
                Branch::Lower => l,
                Branch::Upper => u,
                Branch::Equation if bounds.kind(i) == BoundKind::Fixed => l,
                Branch::Equation => continue,
            };
            (is_active[i], z[i]) = (true, Real::from(bound));
        }

        let with = problem.pattern().with_diagonal();
        let mut solver = Linear::Auto.solver_for(with.pattern())?;
        solver.analyse(with.pattern())?;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let plain: Vec<f64> = z.iter().map(|z| z.into_scalar().to_f64()).collect();
            problem.evaluate(&plain, None, Some(&mut jac));
            let mut values = vec![0.0; with.pattern().nnz()];
            for (k, i, _) in problem.pattern().entries() {
                values[with.entry(k)] = if is_active[i] { 0.0 } else { jac[k] };
            }
            let mut step = vec![0.0; n];
            for (row, f) in problem.rows_at(&z).into_iter().enumerate() {
                let i = shape.variable_of_row(row);
                step[i] = if is_active[i] { 0.0 } else { -f.into_scalar().to_f64() };
            }
            for i in (0..n).filter(|&i| is_active[i]) {
                values[with.diagonal(i)] = 1.0;
            }
            solver.factor(&values)?;
            solver.solve(&mut step);
            for i in (0..n).filter(|&i| is_active[i]) {
                step[i] = 0.0; // and not a rounding error
            }
            let sizes = sizes(plain.iter().copied());
            let size = step.iter().zip(&sizes).map(|(d, s)| (d / s).abs()).fold(0.0, worse);
            for (z, d) in z.iter_mut().zip(&step) {
                *z += *d;
            }
            if size <= SMALLEST || size <= ENOUGH && !(size < 0.5 * last) {
                let z = z.into_iter().map(Real::into_scalar).collect();
                let reference = Reference { z, error: size, origin: Origin::Refined };
                return reference.verified(&problem, &jac);
            }
            if !size.is_finite() {
                break;
            }
            last = size;
        }
        Err(AccuracyError::NotSettled { step: last })
    }

    /// The reference if it lies in the box and every equation has the sign of its case.
    fn verified<M: Model>(
        self,
        problem: &AdProblem<M>,
        jac: &[f64],
    ) -> Result<Self, AccuracyError> {
        let (shape, z) = (problem.shape(), &self.z);
        let mut terms = vec![0.0; shape.n()];
        for (k, i, j) in problem.pattern().entries() {
            terms[i] += (jac[k] * z[j].to_f64()).abs();
        }
        let point: Vec<Real<DoubleDouble>> = z.iter().map(|&z| Real::from_scalar(z)).collect();
        for (row, f) in problem.rows_at(&point).into_iter().enumerate() {
            let i = shape.variable_of_row(row);
            let (l, u) = (shape.bounds().lower()[i], shape.bounds().upper()[i]);
            let above = (z[i] - l.into()).to_f64();
            let below = (z[i] - u.into()).to_f64();
            let size = 1.0 + terms[i] + z[i].to_f64().abs();
            let violation = (mid(0.0, f.into_scalar().to_f64(), -above, -below).0 / size).abs();
            if !(violation <= SIGN) {
                return Err(AccuracyError::NoSolution {
                    variable: shape.variable_name(i),
                    violation,
                });
            }
        }
        Ok(self)
    }

    /// `max_j |z_j − z*_j| / |z*_j|`; variables that are 0 at the solution are measured by the
    /// largest one, or by 1 if all are 0. NaN for a point that is not finite.
    ///
    /// # Panics
    /// If `z` has another length.
    pub fn distance(&self, z: &[f64]) -> f64 {
        assert_eq!(z.len(), self.z.len(), "as many numbers as the solution has");
        let sizes = sizes(self.z.iter().map(|z| z.to_f64()));
        let apart = |((&z, exact), size): ((&f64, &DoubleDouble), f64)| {
            (DoubleDouble::from(z) - *exact).to_f64().abs() / size
        };
        z.iter().zip(&self.z).zip(sizes).map(apart).fold(0.0, worse)
    }
}

/// The larger of two numbers; NaN if the second is or the first was.
pub(super) fn worse(most: f64, x: f64) -> f64 {
    if x <= most || most.is_nan() { most } else { x }
}

/// `|z_j|`, for 0 the largest of them, or 1 if all are 0.
fn sizes(z: impl Iterator<Item = f64>) -> Vec<f64> {
    let z: Vec<f64> = z.map(f64::abs).collect();
    let largest = z.iter().copied().fold(0.0, f64::max);
    let instead = if largest > 0.0 { largest } else { 1.0 };
    z.into_iter().map(|z| if z > 0.0 { z } else { instead }).collect()
}

#[cfg(test)]
#[path = "reference_tests.rs"]
mod tests;
