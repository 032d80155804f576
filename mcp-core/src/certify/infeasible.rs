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
/// By interval arithmetic ([`Interval`] states the assumption; [Moo66](crate#references)), with `X` the
/// box `l <= z <= u`:
///
/// ```text
/// F_i > 0 on X   ⇒   z_i = l_i in every solution:  none if l_i = −inf, otherwise X_i := {l_i}
/// F_i < 0 on X   ⇒   z_i = u_i in every solution:  none if u_i = +inf, otherwise X_i := {u_i}
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
/// let proof = infeasible(&AdProblem::new(Circle::new()?)?).expect("1 + x² is positive");
/// assert_eq!(
///     proof.to_string(),
///     "proved: `f[x]` is positive wherever its variables may be, but `x` has no lower bound to be at"
/// );
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
pub fn infeasible<M: Model>(problem: &AdProblem<M>) -> Option<Infeasible> {
    let shape = problem.shape();
    let (lower, upper) = (shape.bounds().lower(), shape.bounds().upper());
    let mut x: Vec<Interval> =
        lower.iter().zip(upper).map(|(&l, &u)| Interval::new(l, u)).collect();
    for _ in 0..PASSES {
        let at: Vec<Real<Interval>> = x.iter().map(|&x| Real(x)).collect();
        let mut changed = false;
        for (row, range) in problem.rows_at(&at).into_iter().map(|f| f.0).enumerate() {
            let i = shape.variable_of_row(row);
            let bound = match () {
                // The equation of a fixed variable may have any value.
                () if lower[i] == upper[i] => continue,
                () if range.lower() > 0.0 => lower[i],
                () if range.upper() < 0.0 => upper[i],
                () => continue,
            };
            if bound.is_infinite() {
                let (equation, variable) = (shape.equation_name(i), shape.variable_name(i));
                return Some(Infeasible { equation, variable, range });
            }
            changed |= x[i] != Interval::point(bound);
            x[i] = Interval::point(bound);
        }
        if !changed {
            break;
        }
    }
    None
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
        let proof = infeasible(&signs([0.0, -INF], [INF, 5.0])).unwrap();
        assert_eq!((proof.equation.as_str(), proof.range.upper() < 0.0), ("F[1]", true));
    }

    #[test]
    fn a_sign_with_its_bound_is_no_proof() {
        assert_eq!(infeasible(&signs([0.0, -INF], [1.0, INF])), None);
    }

    #[test]
    fn the_bounds_that_signs_imply_are_used() {
        // x = 1 follows; then −y − e < 0 for y >= 0, which has no upper bound.
        let proof = infeasible(&signs([0.0, 0.0], [1.0, INF])).unwrap();
        assert_eq!(proof.variable, "z[2]");
    }

    #[test]
    fn equations_of_fixed_variables_prove_nothing() {
        assert_eq!(infeasible(&signs([2.0, -INF], [2.0, INF])), None);
    }
}
