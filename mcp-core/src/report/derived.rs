//! [`DerivedRow`]: definitions and reports of a model at a solution.

use super::Report;
use super::format::{Align, Grid, clean, number};
use super::text::ROWS_OF_A_FAMILY;
use crate::model::{Family, Quantity};
use std::fmt;
use std::io::{self, Write};

#[cfg(feature = "serde")]
use super::export::number as serialize_number;

/// What a model computes beside `F`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum DerivedKind {
    /// A sub-expression that equations read.
    Definition,
    /// A number for people, evaluated at the solution only.
    Report,
}

impl fmt::Display for DerivedKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            DerivedKind::Definition => "definition",
            DerivedKind::Report => "report",
        })
    }
}

/// One definition or report at a solution.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct DerivedRow {
    /// Which of the two it is.
    pub kind: DerivedKind,
    /// Its name, such as `trade[north, south]`.
    pub name: String,
    /// Its value, in its unit.
    #[cfg_attr(feature = "serde", serde(serialize_with = "serialize_number"))]
    pub value: f64,
    /// Unit of measure, possibly empty.
    pub unit: String,
}

impl Report {
    /// Reports and then definitions of the model at the solution, in the order of declaration.
    pub fn derived(&self) -> impl Iterator<Item = DerivedRow> + '_ {
        self.shape.all_quantities().filter_map(|quantity| {
            let kind = match quantity {
                Quantity::Variable(_) => return None,
                Quantity::Report(_) => DerivedKind::Report,
                Quantity::Definition(_) => DerivedKind::Definition,
            };
            let (family, index) = quantity.family(&self.shape);
            let value = quantity.value(&self.solution.z, &self.derived)? + 0.0;
            let (name, unit) = (family.element_name(index), family.unit().to_owned());
            Some(DerivedRow { kind, name, value, unit })
        })
    }

    /// Reports and definitions as text, each in a table of its own; at most 50 of a family.
    pub(super) fn write_derived(&self, out: &mut impl Write) -> io::Result<()> {
        let (shape, derived) = (&self.shape, &self.derived);
        write_families(out, "reports", shape.reports(), &derived.reports)?;
        write_families(out, "definitions", shape.definitions(), &derived.definitions)
    }
}

fn write_families(
    out: &mut impl Write,
    title: &str,
    families: &[Family],
    values: &[f64],
) -> io::Result<()> {
    if values.is_empty() {
        return Ok(());
    }
    let units = families.iter().any(|family| !family.unit().is_empty());
    let columns =
        [("name", Align::Left, true), ("value", Align::Point, true), ("unit", Align::Left, units)];
    let mut grid = Grid::with_shown(columns);
    for family in families {
        let values = &values[family.offset()..family.offset() + family.len()];
        for (index, &value) in values.iter().enumerate().take(ROWS_OF_A_FAMILY) {
            grid.row([family.element_name(index), number(value), family.unit().to_owned()]);
        }
        let left_out = values.len().saturating_sub(ROWS_OF_A_FAMILY);
        if left_out > 0 {
            grid.note(format!("… {left_out} of {} `{}`", family.len(), clean(family.name())));
        }
    }
    writeln!(out, "\n{title}")?;
    grid.write(out)
}

#[cfg(test)]
#[path = "derived_tests.rs"]
mod tests;
