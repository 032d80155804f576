//! [`Quantity`]: whatever has a name and, at a solution, a number.

use super::{Family, Shape};
use crate::error::{ModelError, nearest};
use crate::problem::Derived;

/// One number of an answer, by its place among all of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    Variable(usize),
    Definition(usize),
    Report(usize),
}

impl Quantity {
    /// Its value in an answer, if it was computed.
    pub(crate) fn value(self, z: &[f64], derived: &Derived) -> Option<f64> {
        match self {
            Quantity::Variable(j) => z.get(j).copied(),
            Quantity::Definition(k) => derived.definitions.get(k).copied(),
            Quantity::Report(k) => derived.reports.get(k).copied(),
        }
    }

    /// Its family, and its place there.
    pub(crate) fn family(self, shape: &Shape) -> (&Family, usize) {
        let (families, k) = match self {
            Quantity::Variable(k) => (shape.variables(), k),
            Quantity::Definition(k) => (shape.definitions(), k),
            Quantity::Report(k) => (shape.reports(), k),
        };
        Family::of_element(families, k)
    }

    /// Its name, such as `p[iron]`.
    pub(crate) fn name(self, shape: &Shape) -> String {
        let (family, index) = self.family(shape);
        family.element_name(index)
    }
}

/// Makes a quantity of its place among all of its kind.
type Kind = fn(usize) -> Quantity;

impl Shape {
    fn kinds(&self) -> [(Kind, &[Family]); 3] {
        [
            (Quantity::Variable, self.variables()),
            (Quantity::Report, self.reports()),
            (Quantity::Definition, self.definitions()),
        ]
    }

    /// Variables, then reports, then definitions.
    pub(crate) fn all_quantities(&self) -> impl Iterator<Item = Quantity> + '_ {
        let count = |families: &[Family]| families.iter().map(Family::len).sum();
        self.kinds().into_iter().flat_map(move |(kind, families)| (0..count(families)).map(kind))
    }

    /// What a name stands for: one variable, definition or report, or all of a family.
    ///
    /// # Errors
    /// [`ModelError::UnknownName`] with the nearest name, [`ModelError::PartOff`], and those of a wrong
    /// label.
    pub(crate) fn quantities(&self, name: &str) -> Result<Vec<Quantity>, ModelError> {
        let head = name.split('[').next().unwrap_or(name).trim();
        for (kind, families) in self.kinds() {
            if families.iter().any(|family| family.name() == head || family.name() == name) {
                return Ok(self.elements("element", families, name)?.map(kind).collect());
            }
        }
        let families = self.kinds().into_iter().flat_map(|(_, families)| families);
        Err(self.unknown_or_off(ModelError::UnknownName {
            kind: "variable, report or definition",
            name: name.to_owned(),
            nearest: nearest(head, families.map(Family::name)),
        }))
    }
}
