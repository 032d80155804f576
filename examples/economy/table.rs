//! Scenarios side by side, by name.

use mcp_core::{AdProblem, DerivedKind, Model, Problem, Report};
use std::collections::BTreeMap;
use std::fmt;

/// Which numbers are compared, in which order: by the place where a name first occurred.
#[derive(Default)]
pub(crate) struct Table {
    scenarios: Vec<String>,
    rows: Vec<Row>,
    /// Row of a name.
    row_of: BTreeMap<String, usize>,
}

/// One name in all scenarios.
struct Row {
    name: String,
    unit: String,
    /// Whether the text shows it; the CSV file has all.
    is_shown: bool,
    /// Its number in each scenario that has it.
    values: BTreeMap<usize, f64>,
}

impl Table {
    /// Adds a solved scenario: its sizes, reports and variables, and its definitions to the CSV file.
    pub(crate) fn add<M: Model>(&mut self, name: &str, problem: &AdProblem<M>, report: &Report) {
        self.scenarios.push(name.to_owned());
        let (shape, stats) = (problem.shape(), &report.solution().stats);
        self.set("unknowns", "", true, shape.n() as f64);
        self.set("nonzeros", "", true, problem.pattern().nnz() as f64);
        self.set("operations", "", true, problem.operations().total() as f64);
        self.set("iterations", "", true, stats.iterations as f64);
        for row in report.derived().filter(|row| row.kind == DerivedKind::Report) {
            self.set(&row.name, &row.unit, true, row.value);
        }
        for row in report.rows() {
            self.set(&row.variable, &row.unit, true, row.level);
        }
        for row in report.derived().filter(|row| row.kind == DerivedKind::Definition) {
            self.set(&row.name, &row.unit, false, row.value);
        }
    }

    /// A number of the scenario added last.
    fn set(&mut self, name: &str, unit: &str, is_shown: bool, value: f64) {
        let row = *self.row_of.entry(name.to_owned()).or_insert_with(|| {
            let (name, unit) = (name.to_owned(), unit.to_owned());
            self.rows.push(Row { name, unit, is_shown, values: BTreeMap::new() });
            self.rows.len() - 1
        });
        self.rows[row].values.insert(self.scenarios.len() - 1, value);
    }

    /// All numbers with every digit; a field is empty where a scenario does not have the name.
    pub(crate) fn csv(&self) -> String {
        let header = ["name", "unit"].into_iter().chain(self.scenarios.iter().map(String::as_str));
        let mut lines = vec![header.map(quoted).collect::<Vec<_>>().join(",")];
        for row in &self.rows {
            let value = |k| row.values.get(&k).map_or(String::new(), f64::to_string);
            let values = (0..self.scenarios.len()).map(value);
            let fields = [quoted(&row.name), quoted(&row.unit)].into_iter().chain(values);
            lines.push(fields.collect::<Vec<_>>().join(","));
        }
        lines.join("\n") + "\n"
    }
}

/// A field of a CSV file.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let shown = || self.rows.iter().filter(|row| row.is_shown);
        let name_width = shown().map(|row| row.name.len()).max().unwrap_or(0);
        write!(f, " {:name_width$}", "")?;
        let widths: Vec<usize> = self.scenarios.iter().map(|name| name.len().max(8) + 2).collect();
        for (name, &width) in self.scenarios.iter().zip(&widths) {
            write!(f, "{name:>width$}")?;
        }
        writeln!(f, "  unit")?;
        for row in shown() {
            write!(f, " {:name_width$}", row.name)?;
            for (k, &width) in widths.iter().enumerate() {
                let text = row.values.get(&k).map_or("-".to_owned(), |&value| number(value));
                write!(f, "{text:>width$}")?;
            }
            writeln!(f, "  {}", row.unit)?;
        }
        Ok(())
    }
}

/// Six significant digits; what is below a billionth is rounding.
fn number(x: f64) -> String {
    let decimals = match x.abs() {
        ..1e-9 => return "0".to_owned(),
        ..1.0 => 6,
        ..1e1 => 5,
        ..1e2 => 4,
        ..1e3 => 3,
        ..1e4 => 2,
        _ => 1,
    };
    let text = format!("{x:.decimals$}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
