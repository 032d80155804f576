//! [`compare`]: two answers side by side.

use crate::error::ModelError;
use crate::model::{Quantity, Shape};
use crate::problem::Derived;
use crate::report::Report;
use crate::report::format::{Align, Grid, number};
use crate::solver::Solution;
use crate::study::SweepPoint;
use std::collections::HashMap;
use std::fmt;

/// Changes, and names of one answer only, before the rest of them is only counted.
const ROWS: usize = 50;

/// Changes below this part of the largest number of a family are those of two solves of one problem.
const UNCHANGED: f64 = 1e-9;

/// An answer whose numbers have names: a [`Solution`] has those of its variables, a [`Report`] and a
/// [`SweepPoint`] also those of definitions and reports.
pub trait Outcome {
    /// The solution.
    fn solution(&self) -> &Solution;
    /// Definitions and reports, if they were evaluated.
    fn derived(&self) -> Option<&Derived> {
        None
    }
}

impl Outcome for Solution {
    fn solution(&self) -> &Solution {
        self
    }
}

impl Outcome for Report {
    fn solution(&self) -> &Solution {
        self.solution()
    }
    fn derived(&self) -> Option<&Derived> {
        Some(self.derived_values())
    }
}

impl Outcome for SweepPoint {
    fn solution(&self) -> &Solution {
        &self.solution
    }
    fn derived(&self) -> Option<&Derived> {
        Some(&self.derived)
    }
}

/// One number in two answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Its name, such as `p[iron]`.
    pub name: String,
    /// In the first answer.
    pub before: f64,
    /// In the second.
    pub after: f64,
    /// Unit of measure, possibly empty.
    pub unit: String,
    /// The largest absolute value of its family in either answer.
    pub size: f64,
}

impl Change {
    /// `after − before`, in the unit of the number.
    pub fn absolute(&self) -> f64 {
        self.after - self.before
    }
    /// `100 (after − before) / |before|`; 0 for what is [no change](Self::is_change), `±inf` for a
    /// change from 0.
    pub fn percent(&self) -> f64 {
        if self.is_change() { 100.0 * self.absolute() / self.before.abs() } else { 0.0 }
    }
    /// Whether the two differ by more than `1e-9` of the largest number of their family: less is the
    /// rounding of a solve.
    pub fn is_change(&self) -> bool {
        let slack = UNCHANGED * self.size;
        let is_near = slack.is_finite() && self.absolute().abs() <= slack;
        self.after != self.before && !is_near
    }
}

/// One number that only one of two answers has.
#[derive(Clone, Debug, PartialEq)]
pub struct Lone {
    /// Its name, such as `q[coal]`.
    pub name: String,
    /// Its value.
    pub value: f64,
    /// Unit of measure, possibly empty.
    pub unit: String,
}

/// What [`compare`] found. `Display` is a table of what changed, the largest changes in percent first,
/// then of what only one answer has, with `-` where the other has nothing: at most 50 lines of each, and
/// how many there are more.
#[derive(Clone, Debug, PartialEq)]
pub struct Changes {
    /// All numbers that both answers have, the largest change in percent first.
    pub rows: Vec<Change>,
    /// Numbers that only the first answer has.
    pub only_before: Vec<Lone>,
    /// Numbers that only the second has.
    pub only_after: Vec<Lone>,
    /// [Parts](Shape::parts) that are on in the first model.
    pub parts_before: Vec<&'static str>,
    /// Parts that are on in the second.
    pub parts_after: Vec<&'static str>,
}

/// Compares two answers number by number: variables, and definitions and reports where both have
/// them. They may be of different models; numbers of the same name belong together.
///
/// ```
/// use mcp_core::{Options, mcp, solve};
/// use mcp_core::study::compare;
/// mcp! {
///     model Market {
///         data { a: f64 }
///         param tax = 0.0;
///         var p >= 0.0 start 1.0;
///         var q >= 0.0 start 1.0;
///         eq supply: 2.0 + q - p                complements q;
///         eq demand: q + p + tax - a            complements p;
///     }
/// }
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let mut model = Market::builder().a(10.0).build()?;
/// let benchmark = solve(&model, &Options::default())?.solved()?;
/// model.set_parameter("tax", &[2.0])?;
/// let taxed = solve(&model, &Options::default())?.solved()?;
/// let changes = compare(&benchmark, &taxed);
/// assert_eq!(changes.rows[0].name, "q"); // from 4 to 3
/// assert!((changes.rows[0].percent() + 25.0).abs() < 1e-7);
/// assert!((changes.get("p")?.percent() + 100.0 / 6.0).abs() < 1e-7);
/// # Ok(())
/// # }
/// ```
pub fn compare(before: &impl Outcome, after: &impl Outcome) -> Changes {
    let (first, second) = (numbers(before), numbers(after));
    let has_derived = |outcome: &dyn Outcome| outcome.derived().is_some();
    let both = has_derived(before) && has_derived(after);
    let counted = |numbers: Vec<Number>| -> Vec<Number> {
        numbers.into_iter().filter(|number| both || number.is_variable).collect()
    };
    let (first, second) = (counted(first), counted(second));
    let levels: HashMap<&str, f64> =
        second.iter().map(|number| (number.name.as_str(), number.value)).collect();
    let mut sizes: HashMap<&str, f64> = HashMap::new();
    for Number { family, value, .. } in first.iter().chain(&second) {
        let size = sizes.entry(family).or_default();
        *size = size.max(value.abs());
    }
    let (mut rows, mut only_before) = (Vec::new(), Vec::new());
    for number in &first {
        let Number { name, family, value: before, unit, .. } = number;
        match levels.get(name.as_str()) {
            Some(&after) => {
                let (name, unit, size) = (name.clone(), unit.clone(), sizes[family.as_str()]);
                rows.push(Change { name, before: *before, after, unit, size });
            }
            None => only_before.push(number.alone()),
        }
    }
    let names: std::collections::HashSet<&str> =
        first.iter().map(|number| number.name.as_str()).collect();
    let is_new = |number: &&Number| !names.contains(number.name.as_str());
    let only_after = second.iter().filter(is_new).map(Number::alone).collect();
    rows.sort_by(|a, b| b.percent().abs().total_cmp(&a.percent().abs()));
    let [parts_before, parts_after] =
        [before.solution(), after.solution()].map(|solution| solution.shape.parts());
    Changes { rows, only_before, only_after, parts_before, parts_after }
}

struct Number {
    name: String,
    family: String,
    value: f64,
    unit: String,
    is_variable: bool,
}

impl Number {
    fn alone(&self) -> Lone {
        Lone { name: self.name.clone(), value: self.value, unit: self.unit.clone() }
    }
}

/// All numbers of an answer with their names.
fn numbers(outcome: &dyn Outcome) -> Vec<Number> {
    let (shape, z): (&Shape, _) = (&outcome.solution().shape, &outcome.solution().z);
    let nothing = Derived::default();
    let derived = outcome.derived().unwrap_or(&nothing);
    let number = |quantity: Quantity| {
        quantity.value(z, derived).map(|value| Number {
            name: quantity.name(shape),
            family: quantity.family(shape).0.name().to_owned(),
            value: value + 0.0,
            unit: quantity.family(shape).0.unit().to_owned(),
            is_variable: matches!(quantity, Quantity::Variable(_)),
        })
    };
    shape.all_quantities().filter_map(number).collect()
}

impl Changes {
    /// The number of this name.
    ///
    /// # Errors
    /// [`ModelError::UnknownName`] with the nearest name.
    pub fn get(&self, name: &str) -> Result<&Change, ModelError> {
        self.rows.iter().find(|row| row.name == name).ok_or_else(|| ModelError::UnknownName {
            kind: "number",
            name: name.to_owned(),
            nearest: crate::error::nearest(name, self.rows.iter().map(|row| row.name.as_str())),
        })
    }

    /// What only one answer has: its name, its unit, and `texts` of before and after, `none` where
    /// there is nothing.
    fn alone(&self, text: fn(f64) -> String, none: &str) -> Vec<(&Lone, [String; 2])> {
        let none = || none.to_owned();
        let before = self.only_before.iter().map(|lone| (lone, [text(lone.value), none()]));
        let after = self.only_after.iter().map(|lone| (lone, [none(), text(lone.value)]));
        before.chain(after).collect()
    }

    /// Writes all rows as CSV: `name, before, after, change, percent, unit`, with every digit; cells of
    /// what only one answer has are empty.
    ///
    /// # Errors
    /// [`ReportError`](crate::ReportError) of the writer.
    #[cfg(feature = "serde")]
    pub fn write_csv(&self, out: impl std::io::Write) -> Result<(), crate::ReportError> {
        use crate::report::format::exact;
        let mut csv = csv::Writer::from_writer(out);
        csv.write_record(["name", "before", "after", "change", "percent", "unit"])?;
        for row in &self.rows {
            let numbers = [row.before, row.after, row.absolute(), row.percent()].map(exact);
            let [before, after, change, percent] = &numbers;
            csv.write_record([&row.name, before, after, change, percent, &row.unit])?;
        }
        for (Lone { name, unit, .. }, [before, after]) in self.alone(exact, "") {
            csv.write_record([name, &before, &after, "", "", unit])?;
        }
        Ok(csv.flush()?)
    }
}

impl fmt::Display for Changes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let changed: Vec<&Change> = self.rows.iter().filter(|row| row.is_change()).collect();
        let alone = self.alone(number, "-");
        let mut units = changed.iter().map(|row| &row.unit);
        let units = units.any(|unit| !unit.is_empty())
            || alone.iter().any(|(lone, _)| !lone.unit.is_empty());
        let mut grid = Grid::with_shown([
            ("name", Align::Left, true),
            ("before", Align::Point, true),
            ("after", Align::Point, true),
            ("change", Align::Point, true),
            ("%", Align::Point, true),
            ("unit", Align::Left, units),
        ]);
        for row in changed.iter().take(ROWS) {
            let percent = if row.before == 0.0 { "new".to_owned() } else { percent(row.percent()) };
            let [before, after, change] = [row.before, row.after, row.absolute()].map(number);
            grid.row([row.name.clone(), before, after, change, percent, row.unit.clone()]);
        }
        if changed.len() > ROWS {
            grid.note(format!("… and {} more that changed", changed.len() - ROWS));
        }
        for (Lone { name, unit, .. }, [before, after]) in alone.iter().take(ROWS) {
            let none = || "-".to_owned();
            let [name, before, after, unit] = [name, before, after, unit].map(String::clone);
            grid.row([name, before, after, none(), none(), unit]);
        }
        if alone.len() > ROWS {
            grid.note(format!("… and {} more that only one has", alone.len() - ROWS));
        }
        let unchanged = self.rows.len() - changed.len();
        if unchanged > 0 {
            grid.note(format!("unchanged: {unchanged}"));
        }
        if self.parts_before != self.parts_after {
            let [before, after] = [&self.parts_before, &self.parts_after].map(|parts| list(parts));
            grid.note(format!("parts: {before} → {after}"));
        }
        grid.fmt(f)
    }
}

/// Names of parts.
fn list(parts: &[&str]) -> String {
    if parts.is_empty() { "-".to_owned() } else { parts.join(", ") }
}

/// Percent with sign and two decimals.
pub(super) fn percent(x: f64) -> String {
    if x.is_finite() { format!("{x:+.2}") } else { number(x) }
}

#[cfg(test)]
#[path = "compare_tests.rs"]
mod tests;
