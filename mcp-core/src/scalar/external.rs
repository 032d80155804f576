//! Functions that bring their own gradient: tables, C code, functions written for other crates.

use super::{Real, Scalar};

/// Calls a function outside the model: it returns its value and writes its gradient.
///
/// `function` gets the values of the arguments and a zeroed gradient. First derivatives follow by
/// the chain rule; derivatives of second order are NaN, because nobody gave them, and
/// [`AdProblem::check_second_order`](crate::AdProblem::check_second_order) names the equations
/// that would need them. [`check_derivatives`](crate::check_derivatives) compares the gradient with
/// differences of the value.
///
/// ```
/// use mcp_core::{Jet, Real, Scalar, external};
/// fn area<D: Scalar>(x: Real<D>, y: Real<D>) -> Real<D> {
///     external(&[x, y], |v, gradient| {
///         *gradient = [v[1], v[0]];
///         v[0] * v[1]
///     })
/// }
/// let x = Real::from_scalar(Jet::<2>::seed(3.0, 0));
/// let y = Real::from_scalar(Jet::<2>::seed(5.0, 1));
/// assert_eq!(area(x, y).into_scalar(), Jet { v: 15.0, d: [5.0, 3.0] });
/// ```
pub fn external<D: Scalar, const K: usize>(
    arguments: &[Real<D>; K],
    function: impl FnOnce(&[f64; K], &mut [f64; K]) -> f64,
) -> Real<D> {
    let arguments = arguments.map(|a| a.0);
    let mut gradient = [0.0; K];
    let value = function(&arguments.map(|a| a.value()), &mut gradient);
    Real(D::linearised(value, &gradient, &arguments))
}
