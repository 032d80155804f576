//! [`Link`]s: springs and dampers.

use super::body::{Axis, BodyId};
use crate::scalar::Scalar;

/// A linear force along one axis, between two bodies or a body and the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// The axis.
    pub axis: Axis,
    /// The body.
    pub body: BodyId,
    /// The body it is linked to; `None`: the ground.
    pub to: Option<BodyId>,
    /// Stiffness \[N/m\] or damping \[N s/m\].
    pub coefficient: f64,
    /// Of a spring: the coordinate difference, or the coordinate, without force \[m\].
    pub rest: f64,
}

/// A link between coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    pub(super) i: usize,
    pub(super) j: Option<usize>,
    pub(super) coefficient: f64,
    pub(super) rest: f64,
}

impl Term {
    /// `x_i − x_j − rest`.
    pub(super) fn extension<D: Scalar>(self, x: impl Fn(usize) -> D) -> D {
        let difference = match self.j {
            Some(j) => x(self.i) - x(j),
            None => x(self.i),
        };
        if self.rest == 0.0 { difference } else { difference.shift(-self.rest) }
    }

    /// `f_i −= force`, `f_j += force`.
    pub(super) fn pull<D: Scalar>(self, force: D, f: &mut [D]) {
        f[self.i] = f[self.i] - force;
        if let Some(j) = self.j {
            f[j] = f[j] + force;
        }
    }

    /// Adds `scale ·` its matrix `±c` to `(i, j, value)` entries.
    pub(super) fn entries(self, scale: f64, put: &mut impl FnMut(usize, usize, f64)) {
        let c = scale * self.coefficient;
        put(self.i, self.i, c);
        if let Some(j) = self.j {
            put(j, j, c);
            put(self.i, j, -c);
            put(j, self.i, -c);
        }
    }
}
