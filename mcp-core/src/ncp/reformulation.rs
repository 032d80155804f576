//! The box as equations: `Φ(z) = 0` by the nested Fischer–Burmeister function ([Bil95](crate#references)).

use super::fischer_burmeister::{
    fischer_burmeister as phi, fischer_burmeister_derivative as derivative, kink_element,
};
use crate::model::{BoundKind, Bounds};

/// `Φ_i` of one variable, with its kind of bound looked up once.
///
/// ```text
/// free    F                       lower   φ(z−l, F)
/// fixed   z − l                   upper   −φ(u−z, −F)
/// boxed   φ(z−l, −φ(u−z, −F))
/// ```
///
/// An element of the generalised derivative is `H = diag(Da) + diag(Db) J` with `Da, Db >= 0`.
#[derive(Clone, Copy, Debug)]
pub struct Reformulation {
    pub(crate) kind: BoundKind,
    pub(crate) lower: f64,
    pub(crate) upper: f64,
}

impl Reformulation {
    /// Of variable `i`.
    #[inline]
    pub fn new(bounds: &Bounds, i: usize) -> Self {
        Reformulation { kind: bounds.kind(i), lower: bounds.lower()[i], upper: bounds.upper()[i] }
    }

    /// Of variable `i`, whose bounds are known to be of that kind.
    #[inline]
    pub(crate) fn of_kind(kind: BoundKind, bounds: &Bounds, i: usize) -> Self {
        Reformulation { kind, lower: bounds.lower()[i], upper: bounds.upper()[i] }
    }

    /// `Φ_i(z, f)`.
    #[inline]
    pub fn value(&self, z: f64, f: f64) -> f64 {
        match self.kind {
            BoundKind::Free => f,
            BoundKind::Fixed => z - self.lower,
            BoundKind::Lower => phi(z - self.lower, f),
            BoundKind::Upper => -phi(self.upper - z, -f),
            BoundKind::Boxed => phi(z - self.lower, -phi(self.upper - z, -f)),
        }
    }

    /// `(Da_i, Db_i)` away from a kink.
    #[inline]
    pub fn derivative(&self, z: f64, f: f64) -> (f64, f64) {
        match self.kind {
            BoundKind::Free => (0.0, 1.0),
            BoundKind::Fixed => (1.0, 0.0),
            BoundKind::Lower => derivative(z - self.lower, f).into(),
            // −φ(u−z, −F): both inner signs and the outer one cancel.
            BoundKind::Upper => derivative(self.upper - z, -f).into(),
            BoundKind::Boxed => {
                // w = −φ(u−z, −F): ∂w/∂z = p1, ∂w/∂F = q1.
                let w = -phi(self.upper - z, -f);
                let [p1, q1] = derivative(self.upper - z, -f);
                let [p2, q2] = derivative(z - self.lower, w);
                (p2 + q2 * p1, q2 * q1)
            }
        }
    }

    /// The direction into the box if `(z, f)` is at a kink: `1` at the lower bound, `−1` at the
    /// upper. `f_scale` says how large the terms of `f` are: smaller values of `f` are rounding.
    #[inline]
    pub fn kink(&self, z: f64, f: f64, f_scale: impl FnOnce() -> f64) -> Option<f64> {
        let at = |bound: f64| (z - bound).abs() <= f64::EPSILON * bound.abs();
        let direction = match self.kind {
            BoundKind::Lower | BoundKind::Boxed if at(self.lower) => 1.0,
            BoundKind::Upper | BoundKind::Boxed if at(self.upper) => -1.0,
            _ => return None,
        };
        (f == 0.0 || f.abs() <= f64::EPSILON * f_scale()).then_some(direction)
    }

    /// `(Da_i, Db_i)` at a kink, the limit along `z + tζ`: `direction = ζ_i`, `slope = (Jζ)_i`
    /// ([FP03](crate#references) p. 808: `J ζ`, not `Jᵀ ζ`).
    #[inline]
    pub fn kink_derivative(&self, direction: f64, slope: f64) -> (f64, f64) {
        // Into the box both kinks look alike: the distance to the bound grows with 1, the
        // residual, counted away from it, with direction · slope.
        kink_element(1.0, direction * slope).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Jet, Real, Scalar};
    use proptest::prelude::*;

    const INF: f64 = f64::INFINITY;

    fn of(lower: f64, upper: f64) -> Reformulation {
        Reformulation::new(&Bounds::new(vec![lower], vec![upper]).unwrap(), 0)
    }

    /// The formulas of the table, over any scalar.
    fn textbook<D: Scalar>(z: Real<D>, f: Real<D>, l: f64, u: f64) -> Real<D> {
        let phi = |a: Real<D>, b: Real<D>| a + b - (a * a + b * b).sqrt();
        match (l.is_finite(), u.is_finite()) {
            (false, false) => f,
            (true, false) => phi(z - l, f),
            (false, true) => -phi(u - z, -f),
            (true, true) => phi(z - l, -phi(u - z, -f)),
        }
    }

    const BOXES: [(f64, f64); 5] = [(-INF, INF), (0.0, INF), (-INF, 1.0), (0.0, 1.0), (-2.0, 0.5)];

    proptest! {
        #[test]
        fn values_and_derivatives_are_those_of_the_formulas(z in -3.0..3.0, f in -3.0..3.0) {
            for (l, u) in BOXES {
                let row = of(l, u);
                let jet = |v, lane| Real::from_scalar(Jet::<2>::seed(v, lane));
                let reference = textbook(jet(z, 0), jet(f, 1), l, u).into_scalar();
                let (da, db) = row.derivative(z, f);
                prop_assert!((row.value(z, f) - reference.v).abs() <= 1e-13);
                prop_assert!((da - reference.d[0]).abs() <= 1e-8, "{da} {reference:?}");
                prop_assert!((db - reference.d[1]).abs() <= 1e-8, "{db} {reference:?}");
                prop_assert!(da >= 0.0 && db >= 0.0);
            }
        }

        #[test]
        fn phi_vanishes_exactly_at_solutions(t in 0.0..1.0, f in 0.0..3.0) {
            let boxed = of(0.0, 1.0);
            prop_assert_eq!(boxed.value(0.0, f), 0.0);
            prop_assert_eq!(boxed.value(1.0, -f), 0.0);
            prop_assert_eq!(boxed.value(t, 0.0), 0.0);
            prop_assert!(f == 0.0 || boxed.value(1.0, f) != 0.0);
            prop_assert!(f == 0.0 || boxed.value(0.0, -f) != 0.0);
        }

        #[test]
        fn a_kink_element_is_a_limit_of_derivatives(slope in -3.0..3.0_f64) {
            for ((l, u), z, direction) in
                [((0.0, INF), 0.0, 1.0), ((0.0, 1.0), 0.0, 1.0), ((0.0, 1.0), 1.0, -1.0),
                 ((-INF, 1.0), 1.0, -1.0)]
            {
                let row = of(l, u);
                prop_assert_eq!(row.kink(z, 0.0, || 1.0), Some(direction));
                let t = 1e-7;
                // z + tζ with ζ = direction; slope is (Jζ)_i.
                let (da, db) = row.derivative(z + t * direction, t * slope);
                let element = row.kink_derivative(direction, slope);
                prop_assert!((da - element.0).abs() < 1e-5, "{da} {element:?} {l} {u}");
                prop_assert!((db - element.1).abs() < 1e-5, "{db} {element:?} {l} {u}");
            }
        }

        #[test]
        fn flipping_a_pair_flips_phi(z in -3.0..3.0, f in -3.0..3.0) {
            // z → −z, F → −F, bounds exchanged: the same problem.
            let (one, other) = (of(-0.5, INF), of(-INF, 0.5));
            prop_assert_eq!(one.value(z, f), -other.value(-z, -f));
            prop_assert_eq!(one.derivative(z, f), other.derivative(-z, -f));
        }
    }

    #[test]
    fn rounding_in_f_counts_as_a_kink_relative_to_its_terms() {
        let row = of(0.0, INF);
        assert_eq!(row.kink(0.0, 1e-10, || 1e7), Some(1.0));
        assert_eq!(row.kink(0.0, 1e-10, || 1.0), None);
        assert_eq!(row.kink(1e-300, 0.0, || 1.0), None);
    }
}
