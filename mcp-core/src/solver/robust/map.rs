//! The equations whose merit a stage reduces: Fischer–Burmeister, penalised or smoothed.

use crate::model::BoundKind;
use crate::ncp::Reformulation;

/// A complementarity function on the box, nested as in [`Reformulation`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Map {
    /// `φ(a, b) = a + b − √(a² + b²)`.
    #[default]
    FischerBurmeister,
    /// `λ φ(a, b) + (1 − λ) a⁺ b⁺` ([CCK00](crate#references)): its level sets are bounded where
    /// those of `φ` need not be.
    Penalised {
        /// `λ`.
        weight: f64,
    },
    /// `φ_μ(a, b) = a + b − √(a² + b² + 2μ)` ([Kan96](crate#references)): zero exactly where
    /// `a, b > 0` and `ab = μ`.
    Smoothed {
        /// `μ`.
        mu: f64,
    },
}

impl Map {
    /// `Φ_i(y, g)`.
    #[inline]
    pub(super) fn value(self, row: &Reformulation, y: f64, g: f64) -> f64 {
        match self {
            Map::FischerBurmeister => row.value(y, g),
            Map::Penalised { weight } => {
                weight * row.value(y, g) + (1.0 - weight) * penalty(row, y, g)
            }
            Map::Smoothed { mu } => smoothed(row, y, g, mu),
        }
    }

    /// `(Da_i, Db_i)` away from a kink.
    #[inline]
    pub(super) fn derivative(self, row: &Reformulation, y: f64, g: f64) -> (f64, f64) {
        match self {
            Map::FischerBurmeister => row.derivative(y, g),
            Map::Penalised { weight } => {
                let (a, b) = row.derivative(y, g);
                let (pa, pb) = penalty_derivative(row, y, g);
                (weight * a + (1.0 - weight) * pa, weight * b + (1.0 - weight) * pb)
            }
            Map::Smoothed { mu } => smoothed_derivative(row, y, g, mu),
        }
    }
}

/// `(y−l)⁺ g⁺ − (u−y)⁺ (−g)⁺`, without the terms of infinite bounds; 0 for free and fixed.
fn penalty(row: &Reformulation, y: f64, g: f64) -> f64 {
    match row.kind {
        BoundKind::Free | BoundKind::Fixed => 0.0,
        _ if g >= 0.0 => above(row, y) * g,
        _ => below(row, y) * g,
    }
}

/// `(y − l)⁺`, 0 without a bound.
fn above(row: &Reformulation, y: f64) -> f64 {
    if row.lower.is_finite() { (y - row.lower).max(0.0) } else { 0.0 }
}

/// `(u − y)⁺`, 0 without a bound.
fn below(row: &Reformulation, y: f64) -> f64 {
    if row.upper.is_finite() { (row.upper - y).max(0.0) } else { 0.0 }
}

fn penalty_derivative(row: &Reformulation, y: f64, g: f64) -> (f64, f64) {
    let (above, below) = (above(row, y), below(row, y));
    match row.kind {
        BoundKind::Free | BoundKind::Fixed => (0.0, 0.0),
        _ if g >= 0.0 => (if above > 0.0 { g } else { 0.0 }, above),
        _ => (if below > 0.0 { -g } else { 0.0 }, below),
    }
}

/// `φ_μ`, its cancellation removed where `a + b > 0`.
fn phi(a: f64, b: f64, mu: f64) -> f64 {
    let r = (a * a + b * b + 2.0 * mu).sqrt();
    let sum = a + b;
    if sum > 0.0 { (2.0 * a * b - 2.0 * mu) / (sum + r) } else { sum - r }
}

fn phi_derivative(a: f64, b: f64, mu: f64) -> (f64, f64) {
    let r = (a * a + b * b + 2.0 * mu).sqrt();
    (1.0 - a / r, 1.0 - b / r)
}

fn smoothed(row: &Reformulation, y: f64, g: f64, mu: f64) -> f64 {
    match row.kind {
        BoundKind::Free => g,
        BoundKind::Fixed => y - row.lower,
        BoundKind::Lower => phi(y - row.lower, g, mu),
        BoundKind::Upper => -phi(row.upper - y, -g, mu),
        BoundKind::Boxed => phi(y - row.lower, -phi(row.upper - y, -g, mu), mu),
    }
}

fn smoothed_derivative(row: &Reformulation, y: f64, g: f64, mu: f64) -> (f64, f64) {
    match row.kind {
        BoundKind::Free => (0.0, 1.0),
        BoundKind::Fixed => (1.0, 0.0),
        BoundKind::Lower => phi_derivative(y - row.lower, g, mu),
        BoundKind::Upper => phi_derivative(row.upper - y, -g, mu),
        BoundKind::Boxed => {
            let (p1, q1) = phi_derivative(row.upper - y, -g, mu);
            let inner = -phi(row.upper - y, -g, mu);
            let (p2, q2) = phi_derivative(y - row.lower, inner, mu);
            (p2 + q2 * p1, q2 * q1)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Bounds;
    use proptest::prelude::*;

    const INF: f64 = f64::INFINITY;
    const BOXES: [(f64, f64); 5] = [(-INF, INF), (0.0, INF), (-INF, 1.0), (0.0, 1.0), (0.5, 0.5)];

    fn rows() -> impl Iterator<Item = Reformulation> {
        BOXES.iter().map(|&(l, u)| {
            Reformulation::new(&Bounds::new(vec![l], vec![u]).expect("well formed"), 0)
        })
    }

    proptest! {
        #[test]
        fn derivatives_are_those_of_the_values(y in 0.01..0.99, g in -3.0..3.0_f64) {
            prop_assume!(g.abs() > 1e-3);
            for row in rows() {
                for map in [Map::Penalised { weight: 0.9 }, Map::Smoothed { mu: 0.1 }] {
                    let h = 1e-6;
                    let slope = |dy: f64, dg: f64| {
                        let at = |t: f64| map.value(&row, y + t * dy, g + t * dg);
                        (at(h) - at(-h)) / (2.0 * h)
                    };
                    let (a, b) = map.derivative(&row, y, g);
                    prop_assert!((a - slope(1.0, 0.0)).abs() < 1e-6, "{map:?} {row:?}");
                    prop_assert!((b - slope(0.0, 1.0)).abs() < 1e-6, "{map:?} {row:?}");
                    prop_assert!(a >= 0.0 && b >= 0.0);
                }
            }
        }

        #[test]
        fn the_penalised_map_vanishes_exactly_at_solutions(y in 0.0..1.0, g in 0.1..3.0) {
            let map = Map::Penalised { weight: 0.9 };
            for row in rows().skip(1).step_by(2).take(1).chain(rows().skip(3).take(1)) {
                prop_assert_eq!(map.value(&row, 0.0, g), 0.0);
                prop_assert_eq!(map.value(&row, y, 0.0), 0.0);
                prop_assert!(y == 0.0 || map.value(&row, y, g) > 0.0);
            }
        }

        #[test]
        fn the_smoothed_map_vanishes_on_the_central_path(a in 0.01..3.0, mu in 1e-6..1.0) {
            let row = rows().nth(1).expect("there are five");
            let value = Map::Smoothed { mu }.value(&row, a, mu / a);
            prop_assert!(value.abs() < 1e-12, "{value:e}");
        }
    }
}
