//! Optimality conditions: a nonlinear program becomes its Karush–Kuhn–Tucker system.
//!
//! The program: minimise `f(x)` with `l <= x <= u` under constraints `g_k(x) >= b_k`, `<= b_k` or
//! `= b_k`. With the Lagrangian
//!
//! ```text
//! L(x, λ) = f(x) − Σ_k λ_k (g_k(x) − b_k)
//! ```
//!
//! its Karush–Kuhn–Tucker system is the mixed complementarity problem \[NW06, theorem 12.1\]
//!
//! ```text
//! ∂L/∂x_j      ⟂   l_j <= x_j <= u_j
//! g_k(x) − b_k ⟂   λ_k >= 0  for g_k >= b_k,    λ_k <= 0  for g_k <= b_k,    λ_k free  for g_k = b_k
//! ```
//!
//! To maximise, both families of rows change their signs, and the multipliers of inequalities theirs.
//! Then always, whatever the kind of the constraint and the sense of the program,
//!
//! ```text
//! λ_k = d f* / d b_k:
//! ```
//!
//! the multiplier is the *shadow price*, the change of the optimal value by the right-hand side,
//! where it is differentiable. For `x` at a bound, the marginal is the change of the optimal value by
//! that bound, with the other sign in a maximisation.
//!
//! [`Program`] holds objective and constraints as functions over [`Scalar`], [`Kkt`] is the model.
//! Its rows are derivatives of these functions by a [`Jet`](crate::Jet) of one lane over the engine's
//! arithmetic, so that its Jacobian has the exact second derivatives of `L`. Names: the rows are
//! `dL/dx[…]` and `constraint[…]`, the multipliers `lambda[…]`, the right-hand sides, a parameter to
//! [`sweep`](crate::study::sweep) over, `rhs[…]`; the report `objective` is `f(x)`.
//!
//! A solution of the system is a stationary point. It is a global minimum if `f` and the set of
//! feasible points are convex; a minimum where no multiplier exists (no constraint qualification
//! holds) is not a solution.
//!
//! ```
//! use mcp_core::kkt::{Constraint, Kkt, Program};
//! use mcp_core::{Options, Real, Scalar, Variable, solve};
//!
//! /// Bread at 3 and wine at 4 $ for a household with 24 $, which spends twice as much on wine.
//! struct Household;
//!
//! impl Program for Household {
//!     fn objective<D: Scalar>(&self, x: &[Real<D>]) -> Real<D> {
//!         x[0].ln() + 2 * x[1].ln()
//!     }
//!     fn constraint<D: Scalar>(&self, _k: usize, x: &[Real<D>]) -> Real<D> {
//!         3 * x[0] + 4 * x[1]
//!     }
//! }
//!
//! let goods = mcp_core::Set::new("goods", ["bread", "wine"])?;
//! let model = Kkt::maximise(Household)
//!     .variable(Variable::new("x").over(&[&goods]).lower(0.0).start(1.0))
//!     .constraint(Constraint::at_most("budget", 24.0).start(1.0))
//!     .build()?;
//! let solution = solve(&model, &Options::default())?.solved()?;
//! assert!((solution.level("x[wine]")? - 4.0).abs() < 1e-6);
//! // f*(b) = 3 ln b + const, so that λ = 3/b.
//! assert!((solution.level("lambda[budget]")? - 0.125).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod builder;
mod directional;
mod model;
#[cfg(test)]
mod tests;

pub use builder::{Constraint, KktBuilder};
pub use model::Kkt;

use crate::scalar::{Real, Scalar};

/// Objective and constraints of a nonlinear program, written once over any [`Scalar`].
///
/// `x` has all variables in the order of their declaration. Which of them a function uses is traced
/// once, when the model is built; **the others are NaN** when it is evaluated. The functions need
/// second derivatives: one that calls [`external`](crate::external()) has a Jacobian of NaN.
pub trait Program {
    /// `f(x)`.
    fn objective<D: Scalar>(&self, x: &[Real<D>]) -> Real<D>;

    /// `g_k(x)`, without its right-hand side; constraints are counted from 0 in the order of their
    /// declaration. Never called for a program without constraints; the default is NaN.
    fn constraint<D: Scalar>(&self, _k: usize, _x: &[Real<D>]) -> Real<D> {
        Real::from(f64::NAN)
    }
}
