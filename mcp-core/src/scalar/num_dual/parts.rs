//! The parts of num-dual's numbers and their chain rule.

use crate::scalar::{Jet, Scalar};
use nalgebra::SVector;
use num_dual::{Derivative, Dual2_64, Dual64, DualNum, DualSVec64, HyperDual64};
use std::array::from_fn;

/// The parts of a num-dual number, and how they compose.
pub(super) trait Parts: DualNum<Primitive = f64> + Copy {
    /// Number of first-order directions.
    const DIRECTIONS: usize;
    /// The number `v` whose first derivative is 1 in `lane < DIRECTIONS`.
    fn variable(v: f64, lane: usize) -> Self;
    /// First derivative in `lane < DIRECTIONS`.
    fn first_order(&self, lane: usize) -> f64;
    /// True if `test` holds for every derivative part; an absent part is 0.
    fn all_parts(&self, test: impl Fn(f64) -> bool) -> bool;
    /// The same derivatives at the value `v`.
    fn at(self, v: f64) -> Self;
    /// `f(a₁, …, a_K)` from its value, gradient and second derivatives.
    fn compose<const K: usize>(arguments: &[Self; K], f: &Expansion<K>) -> Self;
}

/// Value, gradient and second derivatives of a function of `K` arguments.
pub(super) struct Expansion<const K: usize> {
    value: f64,
    gradient: [f64; K],
    hessian: [[f64; K]; K],
}

impl<const K: usize> Expansion<K> {
    /// From nested jets: at the corners these are the limits.
    pub(super) fn of(x: [f64; K], f: impl Fn([Jet<K, Jet<K>>; K]) -> Jet<K, Jet<K>>) -> Self {
        let y = f(from_fn(|i| Jet::variable(Jet::seed(x[i], i), i)));
        Expansion { value: y.v.v, gradient: y.v.d, hessian: y.d.map(|row| row.d) }
    }

    /// Of a function known to first order only.
    pub(super) fn linear(value: f64, gradient: [f64; K]) -> Self {
        Expansion { value, gradient, hessian: [[f64::NAN; K]; K] }
    }

    /// `Σ fᵢ aᵢ`. A zero tangent stays zero where the slope is not finite.
    fn along(&self, a: [f64; K]) -> f64 {
        (0..K).filter(|&i| a[i] != 0.0).map(|i| self.gradient[i] * a[i]).sum()
    }

    /// `Σ fᵢⱼ aᵢ bⱼ`, zero tangents likewise.
    fn twice_along(&self, a: [f64; K], b: [f64; K]) -> f64 {
        let pairs = (0..K * K).map(|k| (k / K, k % K));
        pairs
            .filter(|&(i, j)| a[i] != 0.0 && b[j] != 0.0)
            .map(|(i, j)| self.hessian[i][j] * a[i] * b[j])
            .sum()
    }
}

impl Parts for Dual64 {
    const DIRECTIONS: usize = 1;
    fn variable(v: f64, _lane: usize) -> Self {
        Dual64::new(v, 1.0)
    }
    fn first_order(&self, _lane: usize) -> f64 {
        self.eps
    }
    fn all_parts(&self, test: impl Fn(f64) -> bool) -> bool {
        test(self.eps)
    }
    fn at(self, v: f64) -> Self {
        Dual64 { re: v, ..self }
    }
    fn compose<const K: usize>(arguments: &[Self; K], f: &Expansion<K>) -> Self {
        Dual64::new(f.value, f.along(arguments.map(|a| a.eps)))
    }
}

impl<const N: usize> Parts for DualSVec64<N> {
    const DIRECTIONS: usize = N;
    fn variable(v: f64, lane: usize) -> Self {
        Self::from_re(v).derivative(lane)
    }
    fn first_order(&self, lane: usize) -> f64 {
        self.eps.0.map_or(0.0, |eps| eps[lane])
    }
    fn all_parts(&self, test: impl Fn(f64) -> bool) -> bool {
        (0..N).all(|lane| test(self.first_order(lane)))
    }
    fn at(self, v: f64) -> Self {
        DualSVec64 { re: v, ..self }
    }
    fn compose<const K: usize>(arguments: &[Self; K], f: &Expansion<K>) -> Self {
        let along = |lane, _| f.along(arguments.map(|a| a.first_order(lane)));
        let constant = arguments.iter().all(|a| a.eps.0.is_none());
        let eps = (!constant).then(|| SVector::from_fn(along));
        DualSVec64::new(f.value, Derivative::new(eps))
    }
}

impl Parts for Dual2_64 {
    const DIRECTIONS: usize = 1;
    fn variable(v: f64, _lane: usize) -> Self {
        Dual2_64::new(v, 1.0, 0.0)
    }
    fn first_order(&self, _lane: usize) -> f64 {
        self.v1
    }
    fn all_parts(&self, test: impl Fn(f64) -> bool) -> bool {
        test(self.v1) && test(self.v2)
    }
    fn at(self, v: f64) -> Self {
        Dual2_64 { re: v, ..self }
    }
    fn compose<const K: usize>(arguments: &[Self; K], f: &Expansion<K>) -> Self {
        let v1 = arguments.map(|a| a.v1);
        let v2 = f.along(arguments.map(|a| a.v2)) + f.twice_along(v1, v1);
        Dual2_64::new(f.value, f.along(v1), v2)
    }
}

impl Parts for HyperDual64 {
    const DIRECTIONS: usize = 2;
    fn variable(v: f64, lane: usize) -> Self {
        let [eps1, eps2] = from_fn(|k| if k == lane { 1.0 } else { 0.0 });
        HyperDual64::new(v, eps1, eps2, 0.0)
    }
    fn first_order(&self, lane: usize) -> f64 {
        [self.eps1, self.eps2][lane]
    }
    fn all_parts(&self, test: impl Fn(f64) -> bool) -> bool {
        test(self.eps1) && test(self.eps2) && test(self.eps1eps2)
    }
    fn at(self, v: f64) -> Self {
        HyperDual64 { re: v, ..self }
    }
    fn compose<const K: usize>(arguments: &[Self; K], f: &Expansion<K>) -> Self {
        let (a, b) = (arguments.map(|a| a.eps1), arguments.map(|a| a.eps2));
        let mixed = f.along(arguments.map(|a| a.eps1eps2)) + f.twice_along(a, b);
        HyperDual64::new(f.value, f.along(a), f.along(b), mixed)
    }
}
