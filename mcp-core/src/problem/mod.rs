//! What solvers see: the box, a pattern, and `F` and `J` as plain numbers.
//!
//! [`AdProblem`] turns a [`Model`](crate::Model) into a [`Problem`] with exact derivatives. One
//! pass gives `F` and `J` together:
//!
//! - a model whose rows come from one function of fixed size is run once over all variables with
//!   one lane each (at most 16 at a time, an even number): cost `⌈n/16⌉` passes;
//! - a model given row by row is run row by row, and a row carries only the lanes of the variables
//!   and definitions by which its derivative is not the same at every point; the others are found
//!   once and copied. `J = ∂f/∂z + ∂f/∂d · ∂d/∂z` is assembled sparsely. Cost: one evaluation with 8
//!   lanes for up to 8, and above that one evaluation on a tape with one sweep back, whatever the
//!   number.
//!
//! A user's compiler meets every row once for each of these and once in plain numbers. The pattern
//! comes from the reads of every row, recorded once.

mod ad;
mod constants;
mod counting;
mod derivative_check;
mod derived;
mod lanes;
mod local;
mod operations;
mod packed;
mod pattern;
mod plan;
mod record;
mod rows;
mod runs;

pub use ad::{AdProblem, Engine};
pub use counting::{Counting, Passes};
pub use derivative_check::{Comparison, DerivativeReport, WrongDerivative, check_derivatives};
pub use derived::Derived;
#[doc(hidden)]
pub use derived::PlainModel;
pub(crate) use derived::plain_definitions;
pub(crate) use pattern::{Index, small};
pub use pattern::{Pattern, WithDiagonal};
pub(crate) use record::constants;

use crate::model::Shape;
use std::sync::Arc;

/// A mixed complementarity problem as numbers: object safe, the same for models, hand-coded
/// functions and files.
///
/// Implement it directly for functions that come with their own Jacobian.
pub trait Problem {
    /// Bounds, start, names; shared with every [`Solution`](crate::Solution).
    fn shape(&self) -> &Arc<Shape>;

    /// Structural nonzeros of the Jacobian; the same at every call.
    fn pattern(&self) -> &Pattern;

    /// Evaluates `F` and the Jacobian at `z` in one pass; `None` is not computed.
    ///
    /// `f[i]` is the equation paired with variable `i`; `jac` holds `∂F_i/∂z_j` in the order of
    /// the [`pattern`](Self::pattern). Lengths: `n`, `n`, `nnz`. Outside the domain of `F`, entries
    /// are NaN or infinite; that is an answer, not an error.
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>);

    /// Definitions and reports at `z`, for people to read; a problem that is no model has none.
    fn derived(&self, _z: &[f64]) -> Derived {
        Derived::default()
    }
}

macro_rules! forward {
    ($Pointer:ty) => {
        impl<P: Problem + ?Sized> Problem for $Pointer {
            fn shape(&self) -> &Arc<Shape> {
                (**self).shape()
            }
            fn pattern(&self) -> &Pattern {
                (**self).pattern()
            }
            fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
                (**self).evaluate(z, f, jac);
            }
            fn derived(&self, z: &[f64]) -> Derived {
                (**self).derived(z)
            }
        }
    };
}

forward!(&mut P);
forward!(Box<P>);
