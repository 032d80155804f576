//! Proofs that a problem has no solution, from the signs of `F` on the whole box.

use crate::model::Model;
use crate::problem::AdProblem;
use crate::scalar::{Interval, Real};
use std::fmt;

/// Passes over all equations: each uses the bounds at which the ones before have put variables.
const PASSES: usize = 50;

/// Why a problem has no solution: an equation of one sign, whose variable has no bound on the side
/// where that sign is allowed. `Display` is the proof in a sentence.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Infeasible {
    /// Name of the equation.
    pub equation: String,
    /// Name of the variable it is paired with.
    pub variable: String,
    /// Contains `F_i(z)` for all `z` in the bounds that can be a solution; without 0.
    pub range: Interval,
}

impl fmt::Display for Infeasible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Infeasible { equation, variable, range } = self;
        let (sign, side) =
            if range.lower() > 0.0 { ("positive", "lower") } else { ("negative", "upper") };
        write!(
            f,
            "proved: `{equation}` is {sign} wherever its variables may be, but `{variable}` has no \
             {side} bound to be at"
        )
    }
}

/// Proves that the problem has no solution, if the signs of its equations over the box do so.
///
/// What is proved is more: that no `z` within the bounds has a natural residual
/// `max_i |mid(z_i − l_i, F_i, z_i − u_i)| <= margin`. Data are rounded decimals, and a difference of
/// one unit in the last place (`0.3 − 0.1 − 0.2 = −2.8e−17`) is no reason to call a problem unsolvable
/// that a solver may call solved: `margin` is the tolerance `tol` of the solve, in the units of the
/// model. For the same reason bounds are widened by 4 units in the last place, which allows for
/// as much in every term of `F` that has a variable.
///
/// By interval arithmetic ([`Interval`] states the assumption; [Moo66](crate#references)), with `X` the
/// box `l <= z <= u` and `m` the margin:
///
/// ```text
/// F_i >  m on X   ⇒   z_i <= l_i + m:  for no z if l_i = −inf, otherwise X_i := X_i ∩ [l_i, l_i + m]
/// F_i < −m on X   ⇒   z_i >= u_i − m:  for no z if u_i = +inf, otherwise X_i := X_i ∩ [u_i − m, u_i]
/// ```
///
/// repeated on the smaller box until nothing changes, at most 50 times; a pass is one evaluation of
/// `F`. `None` says nothing: most problems without solution are not seen to be so.
///
/// ```
/// use mcp_core::{AdProblem, Real, Scalar, certify::infeasible, mcp_fn};
/// /// 1 + x² = 0, x free.
/// #[mcp_fn]
/// fn circle<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
///     [1.0 + x.powi(2)]
/// }
/// let problem = AdProblem::new(Circle::new()?)?;
/// let proof = infeasible(&problem, 1e-6).expect("1 + x² is positive");
/// assert_eq!(
///     proof.to_string(),
///     "proved: `f[x]` is positive wherever its variables may be, but `x` has no lower bound to be at"
/// );
/// assert_eq!(infeasible(&problem, 1.0), None); // x = 0 is good enough then
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
pub fn infeasible<M: Model>(problem: &AdProblem<M>, margin: f64) -> Option<Infeasible> {
    let shape = problem.shape();
    let (lower, upper) = (shape.bounds().lower(), shape.bounds().upper());
    let mut x: Vec<Interval> =
        lower.iter().zip(upper).map(|(&l, &u)| Interval::new(l, u)).collect();
    for _ in 0..PASSES {
        let at: Vec<Real<Interval>> = x.iter().map(|&x| Real(widened(x))).collect();
        let mut changed = false;
        for (row, range) in problem.rows_at(&at).into_iter().map(|f| f.0).enumerate() {
            let i = shape.variable_of_row(row);
            let (l, u) = (lower[i], upper[i]);
            let (bound, near) = match () {
                // The equation of a fixed variable may have any value.
                () if l == u => continue,
                () if range.lower() > margin => (l, (l, x[i].upper().min(l + margin))),
                () if range.upper() < -margin => (u, (x[i].lower().max(u - margin), u)),
                () => continue,
            };
            let near = Interval::new(near.0, near.1);
            if bound.is_infinite() {
                let (equation, variable) = (shape.equation_name(i), shape.variable_name(i));
                return Some(Infeasible { equation, variable, range });
            }
            changed |= x[i] != near;
            x[i] = near;
        }
        if !changed {
            break;
        }
    }
    None
}

/// The interval with 4 units in the last place more at both ends.
fn widened(x: Interval) -> Interval {
    let by = |end: f64| 4.0 * f64::EPSILON * end.abs();
    Interval::new(x.lower() - by(x.lower()), x.upper() + by(x.upper()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Reader, Shape};
    use crate::scalar::Scalar;

    const INF: f64 = f64::INFINITY;

    /// `−1 − x²` and `−y − exp(x)`.
    struct Signs(Shape);

    impl Model for Signs {
        fn shape(&self) -> &Shape {
            &self.0
        }
        fn row<D: Scalar>(&self, _: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
            let (x, y) = (read.var(0), read.var(1));
            if i == 0 { -1.0 - x.powi(2) } else { -y - x.exp() }
        }
    }

    fn signs(lower: [f64; 2], upper: [f64; 2]) -> AdProblem<Signs> {
        AdProblem::new(Signs(Shape::anonymous(&lower, &upper, &[0.0; 2]).unwrap())).unwrap()
    }

    #[test]
    fn a_sign_without_its_bound_has_no_solution() {
        // F_1 < 0, so x must be at an upper bound.
        let proof = infeasible(&signs([0.0, -INF], [INF, 5.0]), 0.0).unwrap();
        assert_eq!((proof.equation.as_str(), proof.range.upper() < 0.0), ("F[1]", true));
    }

    #[test]
    fn a_sign_with_its_bound_is_no_proof() {
        assert_eq!(infeasible(&signs([0.0, -INF], [1.0, INF]), 0.0), None);
    }

    #[test]
    fn the_bounds_that_signs_imply_are_used() {
        // x = 1 follows; then −y − e < 0 for y >= 0, which has no upper bound.
        let proof = infeasible(&signs([0.0, 0.0], [1.0, INF]), 0.1).unwrap();
        assert_eq!(proof.variable, "z[2]");
    }

    #[test]
    fn equations_of_fixed_variables_prove_nothing() {
        assert_eq!(infeasible(&signs([2.0, -INF], [2.0, INF]), 0.0), None);
    }

    #[test]
    fn a_sign_within_the_margin_is_no_proof() {
        // F_1 <= −1.
        let problem = signs([0.0, -INF], [INF, 5.0]);
        assert_eq!(infeasible(&problem, 1.0), None);
        assert!(infeasible(&problem, 0.99).is_some());
    }

    /// `c − x − d` and `y`.
    struct Difference(Shape, [f64; 2]);

    impl Model for Difference {
        fn shape(&self) -> &Shape {
            &self.0
        }
        fn row<D: Scalar>(&self, _: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
            if i == 0 { self.1[0] - read.var(1) - self.1[1] } else { read.var(1) - 1.0 }
        }
    }

    #[test]
    fn units_in_the_last_place_of_terms_are_no_proof() {
        let difference = |c: f64| {
            let shape = Shape::anonymous(&[0.0, 0.1], &[INF, 0.1], &[0.0, 0.1]).unwrap();
            AdProblem::new(Difference(shape, [c, 0.2])).unwrap()
        };
        // 0.3 − 0.1 − 0.2 = −2.8e−17 in plain numbers; 0.29 − 0.1 − 0.2 = −0.01.
        assert_eq!(infeasible(&difference(0.3), 0.0), None);
        assert!(infeasible(&difference(0.29), 0.0).is_some());
    }
}
