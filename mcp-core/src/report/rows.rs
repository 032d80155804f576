//! [`ReportRow`]: one line of a solution table, and the [`State`] of its variable.

use crate::model::{BoundKind, Bounds};
use std::fmt;

#[cfg(feature = "serde")]
use super::export::{number, optional_number};

/// Where a variable stands between its bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum State {
    /// At its lower bound.
    AtLower,
    /// At its upper bound.
    AtUpper,
    /// Between its bounds.
    Interior,
    /// Both bounds are equal.
    Fixed,
    /// No bounds.
    Free,
    /// Outside its bounds or NaN. No solver returns such a point.
    Outside,
}

impl State {
    /// The state of variable `i` at `z_i` with `F_i = f`.
    ///
    /// At its lower bound is what equals it, and what the min map puts there, if it is close:
    ///
    /// ```text
    /// z_i − l_i <= min(F_i, 10⁻⁶ max(1, |l_i|))
    /// ```
    ///
    /// Newton methods end near bounds, not on them. At the upper bound likewise, with `−F_i`.
    pub fn new(bounds: &Bounds, i: usize, z: f64, f: f64) -> Self {
        let (lower, upper) = (bounds.lower()[i], bounds.upper()[i]);
        let close = |gap: f64, force: f64, bound: f64| {
            let near = gap <= force && gap <= 1e-6 * bound.abs().max(1.0);
            bound.is_finite() && (gap == 0.0 || near)
        };
        if !(lower <= z && z <= upper) {
            return State::Outside;
        }
        match bounds.kind(i) {
            BoundKind::Free => State::Free,
            BoundKind::Fixed => State::Fixed,
            _ if close(z - lower, f, lower) => State::AtLower,
            _ if close(upper - z, -f, upper) => State::AtUpper,
            _ => State::Interior,
        }
    }

    /// Words for tables: `at lower`, `at upper`, `interior`, `fixed`, `free`, `outside`.
    pub fn name(self) -> &'static str {
        match self {
            State::AtLower => "at lower",
            State::AtUpper => "at upper",
            State::Interior => "interior",
            State::Fixed => "fixed",
            State::Free => "free",
            State::Outside => "outside",
        }
    }
}

impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// One line of a solution table. Zeros have no sign.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct ReportRow {
    /// Name of the variable.
    pub variable: String,
    /// `l_i`, in the unit of the variable; `-inf` for none.
    #[cfg_attr(feature = "serde", serde(serialize_with = "number"))]
    pub lower: f64,
    /// `z_i`, in the unit of the variable.
    #[cfg_attr(feature = "serde", serde(serialize_with = "number"))]
    pub level: f64,
    /// `u_i`, in the unit of the variable; `inf` for none.
    #[cfg_attr(feature = "serde", serde(serialize_with = "number"))]
    pub upper: f64,
    /// `F_i`, in the unit of the equation; GAMS's `.m`. At a lower bound it is the slack
    /// `max(F_i, 0)`. `None` for a fixed variable without equation.
    #[cfg_attr(feature = "serde", serde(serialize_with = "optional_number"))]
    pub marginal: Option<f64>,
    /// `max(−F_i, 0)` at an upper bound, what one more unit of the bound would be worth, in the unit
    /// of the equation; 0 elsewhere. `None` without upper bound and for fixed variables.
    #[cfg_attr(feature = "serde", serde(serialize_with = "optional_number"))]
    pub rent: Option<f64>,
    /// Where the variable stands between its bounds.
    pub state: State,
    /// Unit of the variable, possibly empty.
    pub unit: String,
    /// The paired equation; `None` for a fixed variable without one.
    pub equation: Option<String>,
}

#[cfg(test)]
mod tests {
    use super::*;

    const INF: f64 = f64::INFINITY;

    #[test]
    fn states_follow_from_level_and_marginal() {
        let bounds = Bounds::new(vec![0.0, -INF, 0.0, 1.0, 1e9], vec![INF, INF, 1.0, 1.0, INF]);
        let bounds = bounds.unwrap();
        let cases = [
            (0, 0.0, 0.4, State::AtLower),
            (0, 1e-13, 0.4, State::AtLower),
            (0, 1e-13, 1e-15, State::Interior),
            (0, 3.0, 5.0, State::Interior),
            (0, 1.0, f64::NEG_INFINITY, State::Interior),
            (0, 0.0, -1e-14, State::AtLower),
            (0, -1.0, 0.0, State::Outside),
            (0, f64::NAN, 0.0, State::Outside),
            (0, 1.0, f64::NAN, State::Interior),
            (1, 0.0, 0.0, State::Free),
            (2, 1.0, -3.0, State::AtUpper),
            (2, 1.0 - 1e-12, -3.0, State::AtUpper),
            (2, 0.5, -1e-12, State::Interior),
            (3, 1.0, 7.0, State::Fixed),
            (4, 1e9 + 1.0, 2.0, State::AtLower),
        ];
        for (i, z, f, state) in cases {
            assert_eq!(State::new(&bounds, i, z, f), state, "{i} {z} {f}");
        }
    }
}
