//! [`Directional`]: a number and its derivative along one variable, its operations behind calls.

use crate::scalar::{Jet, Scalar, behind_calls};

/// [`Jet<1, D>`](Jet) for the functions of programs. A user's compiler meets every function in every
/// arithmetic of a model, nested; of this one it compiles calls.
#[derive(Clone, Copy, Debug)]
pub(super) struct Directional<D: Scalar>(Jet<1, D>);

impl<D: Scalar> Directional<D> {
    /// A variable, and whether it is the one of the derivative.
    pub(super) fn new(v: D, along: bool) -> Self {
        Directional(Jet { v, d: [D::constant(if along { 1.0 } else { 0.0 })] })
    }
    pub(super) fn value_in_base(self) -> D {
        self.0.v
    }
    pub(super) fn derivative(self) -> D {
        self.0.d[0]
    }
}

behind_calls!([D: Scalar] Directional<D>, Jet<1, D>, {});

#[cfg(test)]
#[path = "directional_tests.rs"]
mod tests;
