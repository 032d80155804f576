//! [`Statistics`]: how far a point is from a solution, by six measures.

use super::State;
use super::format::{clean, size};
use crate::model::{BoundKind, Shape};
use crate::ncp::{Reformulation, mid};
use crate::problem::Problem;
use std::fmt;

/// The largest absolute value of some vector, and where it is.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Measure {
    /// The largest absolute value; NaN if any entry is.
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::export::number"))]
    pub value: f64,
    /// Variable number of the entry.
    pub index: usize,
    /// Name of the equation of the entry, for the gradient of its variable; empty if all entries
    /// are zero.
    pub at: String,
}

/// Final statistics: PATH's five norms and the error of Siconos.
///
/// With `l`, `u` the bounds, `x⁺ = max(x, 0)`, `x⁻ = max(−x, 0)` and maxima over all variables:
///
/// ```text
/// complementarity   max_i max( F_i⁺ (z_i − l_i),  F_i⁻ (u_i − z_i) )
///                   a product with an infinite distance is |F_i|; 0 for fixed variables
/// normal map        max_i dist( −F_i(y), N(y_i) ):  F_i⁻ at l_i,  F_i⁺ at u_i,  |F_i| between, 0 for
///                   fixed; y is z with every variable "at" a bound (see State) put onto it: the
///                   normal map F(π(x)) + x − π(x) at its best x with π(x) = y;
///                   F(z) where F(y) is undefined
/// minimum map       max_i | mid(z_i − l_i, F_i, z_i − u_i) |, the natural residual
/// Fischer function  max_i | Φ_i |, Φ as in Reformulation
/// Fischer gradient  max_j | ∇θ_j |,  θ = ½‖Φ‖²,  ∇θ = Da Φ + Jᵀ Db Φ
/// Siconos error     ‖ (mid(z − l, F, z − u))_bounded ‖₂ + ‖ F_free ‖₂, which for z >= 0 is Siconos'
///                   ‖ z − max(0, z − w) ‖₂ + ‖ w_e ‖₂
/// ```
///
/// All have the units of the model, products and gradients mixed ones: none is scale-free. Only the
/// [`Certificate`](crate::Certificate) decides what a solution is.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Statistics {
    /// Largest product of a residual and the distance to the bound that would allow it.
    pub complementarity: Measure,
    /// Normal map at the point put onto its bounds.
    pub normal_map: Measure,
    /// Minimum map: the natural residual.
    pub minimum_map: Measure,
    /// Fischer–Burmeister function of the box.
    pub fischer: Measure,
    /// Gradient of the Fischer merit.
    pub fischer_gradient: Measure,
    /// Siconos' error, a sum of 2-norms.
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::export::number"))]
    pub siconos_error: f64,
}

impl Statistics {
    /// Measures `z`, which has `n` entries. Cost: one pass of `F` and `J`, and one of `F` if some
    /// variable is near a bound but not on it.
    pub fn at(problem: &mut dyn Problem, z: &[f64]) -> Self {
        let n = z.len();
        let (mut f, mut jac) = (vec![0.0; n], vec![0.0; problem.pattern().nnz()]);
        problem.evaluate(z, Some(&mut f), Some(&mut jac));

        let bounds = problem.shape().bounds();
        let state: Vec<State> = (0..n).map(|i| State::new(bounds, i, z[i], f[i])).collect();
        let snapped: Vec<f64> = (0..n)
            .map(|i| match state[i] {
                State::AtLower => bounds.lower()[i],
                State::AtUpper => bounds.upper()[i],
                _ => z[i].clamp(bounds.lower()[i], bounds.upper()[i]),
            })
            .collect();
        let mut f_snapped = f.clone();
        if snapped != z {
            problem.evaluate(&snapped, Some(&mut f_snapped), None);
            // An equation may be undefined on the bound itself.
            let undefined = |(at_bound, _): &(&mut f64, &f64)| !at_bound.is_finite();
            f_snapped.iter_mut().zip(&f).filter(undefined).for_each(|(at_bound, f)| *at_bound = *f);
        }

        let (shape, pattern) = (problem.shape(), problem.pattern());
        let bounds = shape.bounds();
        let (lower, upper) = (bounds.lower(), bounds.upper());
        let minimum: Vec<f64> = (0..n).map(|i| mid(z[i], f[i], lower[i], upper[i]).0).collect();
        let rows: Vec<Reformulation> = (0..n).map(|i| Reformulation::new(bounds, i)).collect();
        // Where finite numbers make none, φ of φ has overflowed.
        let or_infinite = |value: f64, i: usize| {
            if value.is_nan() && f[i].is_finite() && z[i].is_finite() {
                f64::INFINITY
            } else {
                value
            }
        };
        let phi: Vec<f64> = (0..n).map(|i| or_infinite(rows[i].value(z[i], f[i]), i)).collect();
        let (da, db): (Vec<f64>, Vec<f64>) = (0..n).map(|i| rows[i].derivative(z[i], f[i])).unzip();
        let gradient = |j: usize| {
            let column = pattern.column(j);
            let terms = column.map(|k| {
                let i = pattern.row(k);
                // Equations of fixed variables are not part of the merit, whatever J holds.
                if db[i] == 0.0 { 0.0 } else { jac[k] * db[i] * phi[i] }
            });
            or_infinite(da[j] * phi[j] + terms.sum::<f64>(), j)
        };
        let equation = |i| shape.equation_name(i);
        let is_free = |i: usize| bounds.kind(i) == BoundKind::Free;
        let norm = |of: &dyn Fn(usize) -> bool| {
            (0..n).filter(|&i| of(i)).fold(0.0, |sum: f64, i| sum.hypot(minimum[i]))
        };
        Statistics {
            complementarity: largest(
                (0..n).map(|i| complementarity(shape, i, z[i], f[i])),
                equation,
            ),
            normal_map: largest((0..n).map(|i| normal(state[i], f_snapped[i])), equation),
            minimum_map: largest(minimum.iter().copied(), equation),
            fischer: largest(phi.iter().copied(), equation),
            fischer_gradient: largest((0..n).map(gradient), |j| shape.variable_name(j)),
            siconos_error: norm(&|i| !is_free(i)) + norm(&is_free),
        }
    }

    /// Words for tables, the measure, and whether it is named by variable.
    pub(super) fn lines(&self) -> [(&'static str, &Measure, &'static str); 5] {
        [
            ("complementarity", &self.complementarity, "equation"),
            ("normal map", &self.normal_map, "equation"),
            ("minimum map", &self.minimum_map, "equation"),
            ("Fischer function", &self.fischer, "equation"),
            ("Fischer gradient", &self.fischer_gradient, "variable"),
        ]
    }
}

impl fmt::Display for Statistics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (words, measure, kind) in self.lines() {
            write!(f, " {words:<17} {:>8}", size(measure.value))?;
            if measure.at.is_empty() {
                writeln!(f)?;
            } else {
                writeln!(f, "  {kind} `{}`", clean(&measure.at))?;
            }
        }
        writeln!(f, " {:<17} {:>8}  2-norm", "Siconos error", size(self.siconos_error))
    }
}

/// `max( F⁺ (z − l), F⁻ (u − z) )`, `|F|` for infinite distances.
fn complementarity(shape: &Shape, i: usize, z: f64, f: f64) -> f64 {
    let bounds = shape.bounds();
    if bounds.kind(i) == BoundKind::Fixed {
        return 0.0;
    }
    let distance = if f > 0.0 { z - bounds.lower()[i] } else { bounds.upper()[i] - z };
    if distance.is_infinite() || f == 0.0 { f.abs() } else { f.abs() * distance }
}

/// Distance of `−f` from the normal cone of the box at a variable in that state.
fn normal(state: State, f: f64) -> f64 {
    match state {
        _ if f.is_nan() => f,
        State::Fixed => 0.0,
        State::AtLower => (-f).max(0.0),
        State::AtUpper => f.max(0.0),
        State::Interior | State::Free | State::Outside => f.abs(),
    }
}

/// The largest absolute value; the first NaN counts as the largest.
fn largest(values: impl Iterator<Item = f64>, name: impl Fn(usize) -> String) -> Measure {
    let (mut value, mut index) = (0.0, 0);
    for (i, v) in values.enumerate() {
        if v.is_nan() || v.abs() > value {
            (value, index) = (v.abs(), i);
        }
        if v.is_nan() {
            break;
        }
    }
    let at = if value == 0.0 { String::new() } else { name(index) };
    Measure { value, index, at }
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "the values asserted are exact")]
mod tests {
    use super::super::samples::Linear;
    use super::*;

    const INF: f64 = f64::INFINITY;

    /// `F = z − c` with one variable of every kind.
    fn kinds(c: [f64; 5]) -> Linear {
        let lower = [-INF, 0.0, -INF, 0.0, 1.0];
        let upper = [INF, INF, 0.0, 4.0, 1.0];
        let shape = Shape::anonymous(&lower, &upper, &[1.0; 5]).unwrap();
        Linear::diagonal(shape, &[1.0; 5], &c.map(|c| -c))
    }

    #[test]
    fn all_measures_vanish_at_a_solution_up_to_snapping() {
        // Free: F = 0; lower bound with F = 3; upper bound with F = −2; box at 4 with F = −1.
        let mut problem = kinds([2.0, -3.0, 2.0, 5.0, 9.0]);
        let statistics = Statistics::at(&mut problem, &[2.0, 0.0, 0.0, 4.0, 1.0]);
        for (words, measure, _) in statistics.lines() {
            assert_eq!((measure.value, measure.at.as_str()), (0.0, ""), "{words}");
        }
        assert_eq!(statistics.siconos_error, 0.0);

        // A variable that almost stands on its bound does not count with its full F.
        let near = Statistics::at(&mut problem, &[2.0, 1e-13, 0.0, 4.0, 1.0]);
        assert_eq!(near.normal_map.value, 0.0);
        assert_eq!(near.minimum_map.value, 1e-13);
        assert!((near.complementarity.value - 3e-13).abs() < 1e-20);
        assert_eq!(near.complementarity.at, "F[2]");
    }

    #[test]
    fn every_measure_is_its_formula() {
        // z = 1 everywhere it may be; F = (−2, 3, −4, 1, −8).
        let mut problem = kinds([3.0, -2.0, 3.0, 0.0, 9.0]);
        let z = [1.0, 1.0, -1.0, 1.0, 1.0];
        let statistics = Statistics::at(&mut problem, &z);
        let phi = |a: f64, b: f64| a + b - a.hypot(b);
        let (f1, f2, f3) = (phi(1.0, 3.0), -phi(1.0, 4.0), phi(1.0, -phi(3.0, -1.0)));
        assert_eq!(statistics.complementarity.value, 4.0);
        assert_eq!(statistics.complementarity.at, "F[3]");
        assert_eq!(statistics.normal_map.value, 4.0);
        assert_eq!(statistics.minimum_map.value, 2.0);
        assert_eq!(statistics.minimum_map.at, "F[1]");
        let fischer = [2.0, f1, f2, f3].into_iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        assert!((statistics.fischer.value - fischer).abs() < 1e-15);
        assert!((statistics.siconos_error - (3.0_f64.sqrt() + 2.0)).abs() < 1e-15);

        // ∇θ against differences of θ = ½‖Φ‖².
        let theta = |z: &[f64]| {
            let f = [z[0] - 3.0, z[1] + 2.0, z[2] - 3.0, z[3]];
            let terms = [
                f[0],
                phi(z[1], f[1]),
                -phi(-z[2], -f[2]),
                phi(z[3], -phi(4.0 - z[3], -f[3])),
                z[4] - 1.0,
            ];
            0.5 * terms.iter().map(|t| t * t).sum::<f64>()
        };
        let h = 1e-6;
        let differences = (0..5).map(|j| {
            let (mut up, mut down) = (z, z);
            up[j] += h;
            down[j] -= h;
            ((theta(&up) - theta(&down)) / (2.0 * h)).abs()
        });
        let largest = differences.fold(0.0, f64::max);
        assert!((statistics.fischer_gradient.value - largest).abs() < 1e-8);
        assert_eq!(statistics.fischer_gradient.at, "z[1]");
    }

    #[test]
    fn a_nan_is_the_largest_and_named() {
        let mut problem = kinds([2.0, f64::NAN, 2.0, 5.0, 9.0]);
        let statistics = Statistics::at(&mut problem, &[2.0, 0.5, 0.0, 4.0, 1.0]);
        assert!(statistics.minimum_map.value.is_nan());
        assert_eq!(statistics.normal_map.at, "F[2]");
        assert!(statistics.siconos_error.is_nan());
        assert!(statistics.to_string().contains("minimum map            NaN  equation `F[2]`"));
    }
}
