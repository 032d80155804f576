//! Where digits are lost: the textbook form of the Fischer–Burmeister function against the stable
//! one, and what either leaves of a solution.

use super::{AccuracyError, Case, DoubleDouble};
use crate::linalg::Linear;
use crate::model::BoundKind;
use crate::ncp::{Branch, fischer_burmeister, fischer_burmeister_derivative, mid};
use crate::problem::Problem;
use crate::scalar::Scalar;

/// A function whose zeros are complementary pairs, with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// `φ = (a + b) − √(a² + b²)`, `∂φ/∂a = 1 − a/√(a² + b²)`, as written in the books.
    Naive,
    /// The same without cancellation: [`fischer_burmeister`].
    Stable,
    /// `min(a, b)`, the map of the tail of [`Method::Robust`](crate::Method::Robust).
    MinMap,
}

impl Form {
    /// All of them.
    pub const ALL: [Form; 3] = [Form::Naive, Form::Stable, Form::MinMap];

    /// Name in tables: `naive`, `stable`, `min map`.
    pub fn name(self) -> &'static str {
        match self {
            Form::Naive => "naive",
            Form::Stable => "stable",
            Form::MinMap => "min map",
        }
    }

    /// Value and derivatives by `a` and `b`.
    pub fn at(self, a: f64, b: f64) -> (f64, [f64; 2]) {
        match self {
            Form::Naive => {
                let r = (a * a + b * b).sqrt();
                ((a + b) - r, [1.0 - a / r, 1.0 - b / r])
            }
            Form::Stable => (fischer_burmeister(a, b), fischer_burmeister_derivative(a, b)),
            Form::MinMap => match mid(a, b, 0.0, f64::INFINITY) {
                (value, Branch::Equation) => (value, [0.0, 1.0]),
                (value, _) => (value, [1.0, 0.0]),
            },
        }
    }
}

/// Relative errors of `φ(a, b)` and of its derivative by `b` in a form of the Fischer–Burmeister
/// function, against double-double.
///
/// Against `2ab/(a + b + r)` and `(a/r) · (a/(r + b))`, for `a, b > 0`.
pub fn phi_errors(form: Form, a: f64, b: f64) -> [f64; 2] {
    let (x, y) = (DoubleDouble::from(a), DoubleDouble::from(b));
    let r = x.hypot(y);
    let value = (x * y).scale(2.0) / (x + y + r);
    let slope = x / r * (x / (r + y));
    let (found, [_, by_b]) = form.at(a, b);
    let error = |found: f64, exact: DoubleDouble| {
        ((DoubleDouble::from(found) - exact) / exact).to_f64().abs()
    };
    [error(found, value), error(by_b, slope)]
}

/// `Φ_i` of a variable in its box and its derivatives by `z_i` and `F_i`, nested as in
/// [`Reformulation`](crate::ncp::Reformulation).
fn in_box(form: Form, kind: BoundKind, (l, z, u): (f64, f64, f64), f: f64) -> (f64, [f64; 2]) {
    // −φ(u − z, −F): its derivatives are those of φ.
    let above = || {
        let (value, slopes) = form.at(u - z, -f);
        (-value, slopes)
    };
    match kind {
        BoundKind::Free => (f, [0.0, 1.0]),
        BoundKind::Fixed => (z - l, [1.0, 0.0]),
        BoundKind::Lower => form.at(z - l, f),
        BoundKind::Upper => above(),
        BoundKind::Boxed => {
            let (inner, [by_z, by_f]) = above();
            let (value, [a, b]) = form.at(z - l, inner);
            (value, [a + b * by_z, b * by_f])
        }
    }
}

/// Newton steps of [`floor`].
const STEPS: usize = 30;
/// Relative distance at which they begin, up and down in turn.
const NEAR: f64 = 1e-4;

/// The error that full Newton steps on `Φ = 0` leave, begun near a solution: the smallest of 30
/// iterates; `None` if the linear systems are singular or no iterate is finite.
///
/// # Errors
/// As [`Case::problem`] and [`Case::error`].
pub fn floor(case: &Case, form: Form) -> Result<Option<f64>, AccuracyError> {
    let mut problem = case.problem(super::Source::Jet)?;
    let shape = std::sync::Arc::clone(problem.shape());
    let (n, bounds) = (shape.n(), shape.bounds());
    let mut z = near(&case.solution()?);
    let with = problem.pattern().with_diagonal();
    let mut solver = Linear::Auto.solver_for(with.pattern())?;
    solver.analyse(with.pattern())?;
    let (mut f, mut jac) = (vec![0.0; n], vec![0.0; problem.pattern().nnz()]);
    let mut least = f64::INFINITY;
    for _ in 0..STEPS {
        problem.evaluate(&z, Some(&mut f), Some(&mut jac));
        let boxed = |i: usize| (bounds.lower()[i], z[i], bounds.upper()[i]);
        let phi: Vec<(f64, [f64; 2])> =
            (0..n).map(|i| in_box(form, bounds.kind(i), boxed(i), f[i])).collect();
        let mut values = vec![0.0; with.pattern().nnz()];
        for (k, i, _) in problem.pattern().entries() {
            values[with.entry(k)] += phi[i].1[1] * jac[k];
        }
        for (i, phi) in phi.iter().enumerate() {
            values[with.diagonal(i)] += phi.1[0];
        }
        let mut step: Vec<f64> = phi.iter().map(|phi| -phi.0).collect();
        if solver.factor(&values).is_err() {
            break;
        }
        solver.solve(&mut step);
        for (z, d) in z.iter_mut().zip(&step) {
            *z += d;
        }
        let error = case.error(&z)?;
        if !error.is_finite() {
            break;
        }
        least = least.min(error);
    }
    Ok(least.is_finite().then_some(least))
}

/// A point near `z`, off by `1e-4` or `−0.5e-4` of each variable, or of the largest where one is 0.
fn near(z: &[f64]) -> Vec<f64> {
    let largest = z.iter().fold(0.0, |largest: f64, z| largest.max(z.abs()));
    let size = |z: f64| match (z.abs(), largest) {
        (0.0, 0.0) => 1.0,
        (0.0, largest) => largest,
        (size, _) => size,
    };
    let off = |j: usize| NEAR * if j.is_multiple_of(2) { 1.0 } else { -0.5 };
    z.iter().enumerate().map(|(j, &z)| z + off(j) * size(z)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_naive_form_loses_what_the_stable_one_keeps() {
        for k in 0..20 {
            let b = 10_f64.powi(k - 10);
            assert!(phi_errors(Form::Stable, 1e3, b).iter().all(|&e| e < 1e-15));
        }
        // algorithms of the naive form: 1.1e-5 at (1e3, 1e-9).
        let [value, slope] = phi_errors(Form::Naive, 1e3, 1e-9);
        assert!(value > 1e-6 && value < 1e-4 && slope < 1e-15);
        // The other derivative, b/r near 1, cancels as well.
        let [_, slope] = phi_errors(Form::Naive, 1e-9, 1e3);
        assert!(slope > 0.1);
    }

    #[test]
    fn every_form_reaches_the_last_digits_where_f_is_of_the_size_of_z() {
        let case = crate::accuracy::problems::chain(12).unwrap();
        for form in Form::ALL {
            let floor = floor(&case, form).unwrap().unwrap();
            assert!(floor < 1e-14, "{}: {floor:e}", form.name());
        }
    }

    #[test]
    fn the_min_map_takes_the_smaller_and_its_derivative() {
        assert_eq!(Form::MinMap.at(1.0, 2.0), (1.0, [1.0, 0.0]));
        assert_eq!(Form::MinMap.at(2.0, 1.0), (1.0, [0.0, 1.0]));
    }
}
