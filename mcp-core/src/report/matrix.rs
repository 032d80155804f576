//! Families with two index sets as tables with row and column labels.

use super::format::{Align, Grid, clean, number, width};
use super::{Report, ReportError};
use crate::error::{ModelError, nearest};
use crate::model::Family;
use std::io::Write;

/// Widest block of columns before the rest goes below.
const LINE: usize = 100;

impl Report {
    /// Writes a family with two index sets as a table, the first set down, the second across: levels
    /// of a variable family, values of `F` of an equation family, values of reports or definitions.
    /// Wide tables are cut into blocks of about 100 characters; combinations that a sparse family does
    /// not have stay blank.
    ///
    /// # Errors
    /// [`ReportError::Model`] for a name that no family has, [`ReportError::NotTwoDimensional`],
    /// [`ReportError::Io`].
    pub fn write_matrix(&self, family: &str, out: &mut impl Write) -> Result<(), ReportError> {
        let (shape, derived) = (&self.shape, &self.derived);
        let named = |f: &&Family| f.name() == family;
        let columns = [
            (shape.variables(), "level", &self.solution.z),
            (shape.reports(), "value", &derived.reports),
            (shape.definitions(), "value", &derived.definitions),
        ];
        for (families, what, values) in columns {
            if let Some(family) = families.iter().find(named) {
                return write_blocks(family, what, |k| values[family.offset() + k], out);
            }
        }
        if let Some(family) = shape.equations().find(named) {
            let value = |k| self.solution.f[shape.variable_of_row(family.offset() + k)];
            return write_blocks(family, "F", value, out);
        }
        let names = shape.variables().iter().chain(shape.equations());
        let names = names.chain(shape.reports()).chain(shape.definitions()).map(Family::name);
        let (name, nearest) = (family.to_owned(), nearest(family, names));
        let unknown = ModelError::UnknownName { kind: "family", name, nearest };
        Err(ReportError::Model(shape.unknown_or_off(unknown)))
    }
}

fn write_blocks(
    family: &Family,
    what: &str,
    value: impl Fn(usize) -> f64,
    out: &mut impl Write,
) -> Result<(), ReportError> {
    let [down, across] = family.sets() else {
        let (family, indices) = (family.name().to_owned(), family.sets().len());
        return Err(ReportError::NotTwoDimensional { family, indices });
    };
    let unit =
        if family.unit().is_empty() { String::new() } else { format!(" [{}]", family.unit()) };
    let (name, down_name, across_name) =
        (clean(family.name()), clean(down.name()), clean(across.name()));
    writeln!(out, "{name}[{down_name}, {across_name}]: {what}{}", clean(&unit))?;
    let labels: Vec<String> = down.labels().collect();
    let label_width = labels.iter().map(|label| width(label)).max().unwrap_or(0);
    let mut column = 0;
    while column < across.len() {
        let mut used = 1 + label_width.max(width(&down_name));
        let mut block = Vec::new();
        while column < across.len() {
            let label = across.label(column);
            let cell = |i| match family.position(i * across.len() + column) {
                Some(k) => number(value(k)),
                None => String::new(),
            };
            let cells: Vec<String> = (0..down.len()).map(cell).collect();
            let widest = cells.iter().map(|cell| width(cell)).max().unwrap_or(0);
            used += 2 + widest.max(width(&label));
            if used > LINE && !block.is_empty() {
                break;
            }
            block.push((label, cells));
            column += 1;
        }
        let headers = block.iter().map(|(label, _)| (label.as_str(), Align::Point));
        let mut grid = Grid::new([("", Align::Left)].into_iter().chain(headers));
        for (i, label) in labels.iter().enumerate() {
            let cells = block.iter().map(|(_, cells)| cells[i].clone());
            grid.row([label.clone()].into_iter().chain(cells));
        }
        grid.write(out)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::samples::{Broken, Linear};
    use super::*;
    use crate::model::{Equation, Set, Shape, Variable};
    use crate::solver::Status;

    fn report(markets: &[&str]) -> Report {
        let plants = Set::new("plants", ["seattle", "san-diego"]).unwrap();
        let markets = Set::new("markets", markets.iter().copied()).unwrap();
        let shape = Shape::builder()
            .variable(Variable::new("x").over(&[&plants, &markets]).lower(0.0).unit("cases"))
            .variable(Variable::new("w").over(&[&plants]))
            .equation(Equation::new("profit").over(&[&plants, &markets]).complements("x"))
            .equation(Equation::new("supply").over(&[&plants]).complements("w"))
            .build()
            .unwrap();
        let n = shape.n();
        let z: Vec<f64> = (0..n).map(|i| if i == 1 { -0.0 } else { i as f64 * 12.5 }).collect();
        let mut problem = Linear::diagonal(shape, &vec![1.0; n], &vec![0.0; n]);
        let solution = problem.ended(&z, Status::IterationLimit);
        Report::new(&mut problem, &solution).unwrap()
    }

    fn matrix(report: &Report, family: &str) -> String {
        let mut out = Vec::new();
        report.write_matrix(family, &mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn a_family_over_two_sets_has_row_and_column_labels() {
        let report = report(&["new-york", "chicago", "東京"]);
        let expected = "\
x[plants, markets]: level [cases]
            new-york  chicago  東京
 seattle         0          0  25
 san-diego      37.5       50  62.5
";
        assert_eq!(matrix(&report, "x"), expected);
        assert!(matrix(&report, "profit").starts_with("profit[plants, markets]: F\n"));
    }

    #[test]
    fn absent_combinations_are_blank() {
        let cities = Set::new("cities", ["a", "b", "c"]).unwrap();
        let roads = [1, 3, 6];
        let over = [&cities, &cities];
        let shape = Shape::builder()
            .variable(Variable::new("flow").over(&over).only(roads))
            .equation(Equation::new("cost").over(&over).only(roads).complements("flow"))
            .build()
            .unwrap();
        let mut problem = Linear::diagonal(shape, &[1.0; 3], &[0.0, 0.0, 0.5]);
        let solution = problem.ended(&[1.5, 20.0, 3.0], Status::IterationLimit);
        let report = Report::new(&mut problem, &solution).unwrap();
        let levels = "\
flow[cities, cities]: level
     a    b  c
 a      1.5
 b  20
 c   3
";
        assert_eq!(matrix(&report, "flow"), levels);
        let values = "\
cost[cities, cities]: F
       a    b  c
 a        1.5
 b  20
 c   3.5
";
        assert_eq!(matrix(&report, "cost"), values);
        assert_eq!(report.row_count(), 3);
        assert_eq!(report.row(2).variable, "flow[c, a]");
    }

    #[test]
    fn wide_families_are_cut_into_blocks() {
        let labels: Vec<String> = (0..30).map(|k| format!("market{k}")).collect();
        let labels: Vec<&str> = labels.iter().map(String::as_str).collect();
        let text = matrix(&report(&labels), "x");
        assert!(text.lines().all(|line| width(line) <= LINE), "{text}");
        assert!(labels.iter().all(|label| text.contains(label)));
        assert_eq!(text.lines().filter(|line| line.starts_with(" seattle")).count(), 4);
    }

    #[test]
    fn other_families_are_refused_by_name() {
        let report = report(&["a"]);
        let refused = |family| report.write_matrix(family, &mut Vec::new()).unwrap_err();
        assert_eq!(
            refused("w").to_string(),
            "`w` has 1 index sets; a table of rows and columns needs 2"
        );
        assert_eq!(
            refused("profti").to_string(),
            "there is no family `profti`; did you mean `profit`?"
        );
        let error = report.write_matrix("x", &mut Broken { lines: 1 }).unwrap_err();
        assert!(matches!(error, ReportError::Io(_)));
    }
}
