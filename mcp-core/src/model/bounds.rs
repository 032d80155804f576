//! [`Bounds`]: the box `l <= z <= u`.

use crate::error::ModelError;

/// What a pair of bounds means for one variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundKind {
    /// No bound: `F_i = 0`, `z_i` anything.
    Free,
    /// `z_i >= l_i`.
    Lower,
    /// `z_i <= u_i`.
    Upper,
    /// `l_i <= z_i <= u_i` with `l_i < u_i`.
    Boxed,
    /// `z_i = l_i = u_i`: `F_i` may be anything.
    Fixed,
}

impl BoundKind {
    /// What these bounds mean.
    #[inline]
    pub(crate) fn of(l: f64, u: f64) -> Self {
        match (l > f64::NEG_INFINITY, u < f64::INFINITY) {
            (false, false) => BoundKind::Free,
            (true, false) => BoundKind::Lower,
            (false, true) => BoundKind::Upper,
            (true, true) if l < u => BoundKind::Boxed,
            (true, true) => BoundKind::Fixed,
        }
    }
}

/// Lower and upper bounds of all variables, infinite where there is none.
///
/// Invariant, checked where bounds are made: no NaN, `l_i <= u_i`, `l_i < +inf`, `u_i > -inf`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bounds {
    lower: Vec<f64>,
    upper: Vec<f64>,
}

/// Why a pair of bounds is refused: kind of fault, index, lower and upper bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum BadBounds {
    /// NaN, lower `+inf` or upper `-inf`.
    Unusable(usize, f64, f64),
    /// Lower above upper.
    Crossed(usize, f64, f64),
}

impl Bounds {
    /// Checks the invariant. Both lists have the same length.
    pub(crate) fn new(lower: Vec<f64>, upper: Vec<f64>) -> Result<Self, BadBounds> {
        debug_assert_eq!(lower.len(), upper.len());
        for (i, (&l, &u)) in lower.iter().zip(&upper).enumerate() {
            if l.is_nan() || u.is_nan() || l == f64::INFINITY || u == f64::NEG_INFINITY {
                return Err(BadBounds::Unusable(i, l, u));
            }
            if l > u {
                return Err(BadBounds::Crossed(i, l, u));
            }
        }
        Ok(Bounds { lower, upper })
    }

    /// Number of variables.
    pub fn n(&self) -> usize {
        self.lower.len()
    }

    /// All lower bounds.
    pub fn lower(&self) -> &[f64] {
        &self.lower
    }

    /// All upper bounds.
    pub fn upper(&self) -> &[f64] {
        &self.upper
    }

    /// What the bounds of variable `i` mean.
    #[inline]
    pub fn kind(&self, i: usize) -> BoundKind {
        BoundKind::of(self.lower[i], self.upper[i])
    }

    /// Moves `z` into the box; NaN stays NaN.
    #[inline]
    pub fn project(&self, z: &mut [f64]) {
        for ((z, &l), &u) in z.iter_mut().zip(&self.lower).zip(&self.upper) {
            if *z < l {
                *z = l;
            } else if *z > u {
                *z = u;
            }
        }
    }

    /// Whether `z` lies in the box; false for NaN.
    pub fn contain(&self, z: &[f64]) -> bool {
        z.iter().zip(&self.lower).zip(&self.upper).all(|((z, l), u)| l <= z && z <= u)
    }
}

/// Bounds that satisfy their invariant, or the variable that does not.
pub(super) fn checked_bounds(
    lower: Vec<f64>,
    upper: Vec<f64>,
    name: impl Fn(usize) -> String,
) -> Result<Bounds, ModelError> {
    Bounds::new(lower, upper).map_err(|bad| match bad {
        BadBounds::Unusable(j, lower, upper) => {
            ModelError::UnusableBounds { variable: name(j), lower, upper }
        }
        BadBounds::Crossed(j, lower, upper) => {
            ModelError::CrossedBounds { variable: name(j), lower, upper }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::BoundKind::{Boxed, Fixed, Free, Lower, Upper};
    use super::*;

    const INF: f64 = f64::INFINITY;

    #[test]
    fn kinds_follow_from_the_bounds() {
        let bounds = Bounds::new(vec![-INF, 0.0, -INF, 0.0, 1.0], vec![INF, INF, 1.0, 1.0, 1.0]);
        let bounds = bounds.unwrap();
        let kinds: Vec<_> = (0..5).map(|i| bounds.kind(i)).collect();
        assert_eq!(kinds, [Free, Lower, Upper, Boxed, Fixed]);
    }

    #[test]
    fn senseless_bounds_are_refused() {
        let crossed = Bounds::new(vec![0.0, 2.0], vec![1.0, 1.0]);
        assert_eq!(crossed, Err(BadBounds::Crossed(1, 2.0, 1.0)));
        for (l, u) in [(f64::NAN, 1.0), (0.0, f64::NAN), (INF, INF), (-INF, -INF)] {
            let refused = Bounds::new(vec![l], vec![u]);
            assert!(matches!(refused, Err(BadBounds::Unusable(0, ..))));
        }
    }

    #[test]
    fn projection_is_exact_and_keeps_nan() {
        let bounds = Bounds::new(vec![0.0, 0.0, 0.0], vec![1.0, 1.0, 1.0]).unwrap();
        let mut z = [-1e-300, 1.0 + f64::EPSILON, f64::NAN];
        bounds.project(&mut z);
        assert_eq!(z[..2], [0.0, 1.0]);
        assert!(z[2].is_nan());
        assert!(!bounds.contain(&z));
        assert!(bounds.contain(&[0.0, 1.0, 0.5]));
    }
}
