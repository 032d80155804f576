//! The scaled problem: `y = z / C`, `G(y) = R F(C y)`, with powers of two in `R` and `C`.

use super::equilibrate::{Equilibration, power_of_two};
use super::map::Map;
use super::measured::Sample;
use crate::model::{BoundKind, Bounds, Shape};
use crate::ncp::{Branch, Reformulation, mid};
use crate::problem::{Pattern, Problem};
use crate::solver::workspace::Point;

/// Scales and the scaled box. Products with powers of two are exact, so `z` and `y` hold the same
/// digits, and `y` lies in its box exactly when `z` does.
#[derive(Clone, Debug, Default)]
pub(in crate::solver) struct View {
    equilibration: Equilibration,
    row: Vec<f64>,
    column: Vec<f64>,
    pub(in crate::solver) lower: Vec<f64>,
    pub(in crate::solver) upper: Vec<f64>,
    kinds: Vec<BoundKind>,
    /// `C y`, the argument of `F`.
    z: Vec<f64>,
}

impl View {
    pub(in crate::solver) fn resize(&mut self, n: usize) {
        self.equilibration.resize(n);
        for list in [&mut self.row, &mut self.column, &mut self.lower, &mut self.upper, &mut self.z]
        {
            list.resize(n, 1.0);
        }
        self.kinds.clear();
        self.kinds.reserve(n);
    }

    /// The equations of all variables.
    pub(in crate::solver) fn rows(&self) -> impl Iterator<Item = Reformulation> + '_ {
        let sides = self.lower.iter().zip(&self.upper);
        let row = |(&kind, (&lower, &upper))| Reformulation { kind, lower, upper };
        self.kinds.iter().zip(sides).map(row)
    }

    /// The problem as it is.
    pub(in crate::solver) fn unscaled(&mut self, bounds: &Bounds) {
        self.equilibration.clear();
        self.apply(bounds);
    }

    /// Scales measured at a point where `F` and `J`, in the units of the model, are finite.
    pub(in crate::solver) fn measure(
        &mut self,
        shape: &Shape,
        pattern: &Pattern,
        sample: Sample<'_>,
    ) {
        self.equilibration.measure(pattern, shape.bounds(), sample);
        self.apply(shape.bounds());
    }

    fn apply(&mut self, bounds: &Bounds) {
        self.kinds.clear();
        for j in 0..self.row.len() {
            self.row[j] = power_of_two(self.equilibration.r[j]);
            self.column[j] = power_of_two(self.equilibration.c[j]);
            let inverse = power_of_two(-self.equilibration.c[j]);
            self.lower[j] = bounds.lower()[j] * inverse;
            self.upper[j] = bounds.upper()[j] * inverse;
            self.kinds.push(BoundKind::of(self.lower[j], self.upper[j]));
        }
    }

    /// `y = z / C`.
    pub(in crate::solver) fn scale(&self, z: &[f64], y: &mut [f64]) {
        for ((y, z), c) in y.iter_mut().zip(z).zip(&self.column) {
            *y = z / c;
        }
    }

    /// `z = C y`, in the box of the model.
    pub(in crate::solver) fn unscale(&self, y: &[f64], bounds: &Bounds, z: &mut [f64]) {
        for ((z, y), c) in z.iter_mut().zip(y).zip(&self.column) {
            *z = y * c;
        }
        bounds.project(z);
    }

    /// `C d`: a direction in the units of the model.
    pub(in crate::solver) fn unscale_direction(&self, d: &[f64], z: &mut [f64]) {
        for ((z, d), c) in z.iter_mut().zip(d).zip(&self.column) {
            *z = d * c;
        }
    }

    /// `C`: the units of `y` in those of the model.
    pub(in crate::solver) fn units(&self) -> &[f64] {
        &self.column
    }

    /// `F = G / R`.
    pub(in crate::solver) fn unscale_residual(&self, g: &[f64], f: &mut [f64]) {
        for ((f, g), r) in f.iter_mut().zip(g).zip(&self.row) {
            *f = g / r;
        }
    }

    /// `R F` and `R J C` from `F` and `J`, in place.
    pub(in crate::solver) fn scale_residual(&self, f: &mut [f64]) {
        for (f, r) in f.iter_mut().zip(&self.row) {
            *f *= r;
        }
    }

    /// `R J C` from `J`, in place.
    pub(in crate::solver) fn scale_jacobian(&self, pattern: &Pattern, jac: &mut [f64]) {
        for j in 0..pattern.n() {
            for k in pattern.column(j) {
                jac[k] = jac[k] * self.row[pattern.row(k)] * self.column[j];
            }
        }
    }

    /// `J` from `R J C`, in place.
    pub(in crate::solver) fn unscale_jacobian(&self, pattern: &Pattern, jac: &mut [f64]) {
        for j in 0..pattern.n() {
            for k in pattern.column(j) {
                jac[k] = jac[k] / self.row[pattern.row(k)] / self.column[j];
            }
        }
    }

    /// `G`, without merit, at `point.z`, NaN where that has overflowed; its argument stays in
    /// [`argument`](Self::argument).
    pub(in crate::solver) fn residual(&mut self, problem: &mut dyn Problem, point: &mut Point) {
        self.set_argument(problem, &point.z);
        if self.z.iter().all(|z| z.is_finite()) {
            problem.evaluate(&self.z, Some(&mut point.f), None);
            self.scale_residual(&mut point.f);
        } else {
            // `e^z` would be finite at −∞.
            point.f.fill(f64::NAN);
        }
    }

    /// `R J C` at `y`.
    pub(in crate::solver) fn jacobian(
        &mut self,
        problem: &mut dyn Problem,
        y: &[f64],
        jac: &mut [f64],
    ) {
        self.set_argument(problem, y);
        problem.evaluate(&self.z, None, Some(jac));
        self.scale_jacobian(problem.pattern(), jac);
    }

    /// `z` of the last evaluation.
    pub(in crate::solver) fn argument(&self) -> &[f64] {
        &self.z
    }

    fn set_argument(&mut self, problem: &dyn Problem, y: &[f64]) {
        for ((z, y), c) in self.z.iter_mut().zip(y).zip(&self.column) {
            *z = y * c;
        }
        problem.shape().bounds().project(&mut self.z);
    }

    /// Moves `y` into the box.
    pub(in crate::solver) fn project(&self, y: &mut [f64]) {
        for ((y, &l), &u) in y.iter_mut().zip(&self.lower).zip(&self.upper) {
            *y = y.max(l).min(u);
        }
    }

    /// `Φ` and the merit `½‖Φ‖²` of a point whose `G` is known; NaN where that is not finite.
    pub(super) fn weigh(&self, map: Map, point: &mut Point) {
        let mut square = 0.0;
        for (i, row) in self.rows().enumerate() {
            point.phi[i] = map.value(&row, point.z[i], point.f[i]);
            square += point.phi[i] * point.phi[i];
        }
        point.merit = 0.5 * square;
        if !(point.merit.is_finite() && point.f.iter().all(|g| g.is_finite())) {
            point.merit = f64::NAN;
        }
    }

    /// The natural map at a point: `mid(y − l, G, y − u)`.
    pub(in crate::solver) fn natural(&self, point: &Point, i: usize) -> (f64, Branch) {
        mid(point.z[i], point.f[i], self.lower[i], self.upper[i])
    }

    /// `‖mid(y − l, G, y − u)‖₂`.
    pub(in crate::solver) fn natural_norm(&self, point: &Point) -> f64 {
        let square = |i| {
            let value = self.natural(point, i).0;
            value * value
        };
        (0..point.z.len()).map(square).sum::<f64>().sqrt()
    }

    /// The least violation `max |mid|`; NaN stays.
    pub(in crate::solver) fn natural_max(&self, point: &Point) -> f64 {
        (0..point.z.len()).fold(0.0, |max: f64, i| {
            let value = self.natural(point, i).0.abs();
            if value <= max || max.is_nan() { max } else { value }
        })
    }
}
