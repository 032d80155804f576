//! The numbers of the base: illustrative, none is measured. Quantities are in millions of tons or of
//! visits a year, labor in millions of hours a year [Mh], prices in dollars, incomes in millions.

pub(crate) const HOUSEHOLDS: [&str; 2] = ["workers", "merchants"];
pub(crate) const SECTORS: [&str; 3] = ["food", "tools", "services"];
pub(crate) const TRADED: [&str; 2] = ["food", "tools"];

/// Labor of the households [Mh].
pub(crate) const LABOR: [f64; 2] = [800.0, 200.0];

/// What the households spend on the goods, as parts of their means.
pub(crate) const SHARE: [[f64; 3]; 2] = [[0.3, 0.2, 0.5], [0.1, 0.3, 0.6]];

/// Labor in a ton of food, a ton of tools, a visit [h].
pub(crate) const HOURS: [f64; 3] = [100.0, 200.0, 1.0];

/// What a ton costs on its way into the country [$/t].
pub(crate) const CIF: [f64; 2] = [2000.0, 5600.0];

/// What a ton brings on its way out of the country [$/t].
pub(crate) const FOB: [f64; 2] = [1700.0, 5000.0];

/// Prices at which welfare is measured, those without any effect [$].
pub(crate) const REFERENCE: [f64; 3] = [2000.0, 5000.0, 25.0];
