//! A [`Statement`] as text.

use super::format::{Align, Grid, clean, count, number};
use super::{Examples, SIGN_CONVENTION, Statement};
use std::fmt;

impl fmt::Display for Statement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.headline(f)?;
        writeln!(f, "sign convention: {SIGN_CONVENTION}")?;
        if !self.parts.is_empty() {
            writeln!(f, "parts: {}", self.parts.join(", "))?;
        }
        write_grid(f, &self.families())?;
        write_grid(f, &self.pairs())?;
        if let (Some(smallest), Some(largest)) = (&self.smallest_row, &self.largest_row) {
            let ends = [smallest, largest].map(|row| (row.norm, row.equation.as_str()));
            range(f, "row norms at the start", ends)?;
        }
        if let (Some(smallest), Some(largest)) = (&self.smallest_column, &self.largest_column) {
            let ends = [smallest, largest].map(|column| (column.norm, column.variable.as_str()));
            range(f, "column norms at the start", ends)?;
        }
        list(f, "fixed variables without equation", &self.without_equation, true)?;
        list(f, "equations that read no variable", &self.constant_equations, true)?;
        list(f, "variables in no equation", &self.unread_variables, true)?;
        list(f, "equations without any derivative at the start", &self.zero_rows, true)?;
        list(f, "variables no equation depends on at the start", &self.zero_columns, true)?;
        list(f, "not finite at the start", &self.non_finite, false)
    }
}

impl Statement {
    fn headline(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.name.is_empty() {
            write!(f, "{}: ", clean(&self.name))?;
        }
        write!(f, "{}", count(self.variables, "variable"))?;
        let kinds = [
            (self.kinds.free, "free"),
            (self.kinds.lower, "lower"),
            (self.kinds.upper, "upper"),
            (self.kinds.boxed, "boxed"),
            (self.kinds.fixed, "fixed"),
        ];
        let kinds = kinds.iter().filter(|kind| kind.0 > 0);
        let kinds: Vec<String> = kinds.map(|(count, kind)| format!("{count} {kind}")).collect();
        if !kinds.is_empty() {
            write!(f, " ({})", kinds.join(", "))?;
        }
        writeln!(
            f,
            ", {}, {} of {} ({:.1} %)",
            count(self.equations, "equation"),
            count(self.nonzeros, "nonzero"),
            // May exceed the range of integers; exact as long as that matters.
            number(self.variables as f64 * self.variables as f64),
            100.0 * self.density,
        )
    }

    fn families(&self) -> Grid {
        let units = self.families.iter().any(|family| !family.unit.is_empty());
        let abouts = self.families.iter().any(|family| !family.about.is_empty());
        let columns = [
            ("variable", Align::Left, true),
            ("size", Align::Right, true),
            ("unit", Align::Left, units),
            ("about", Align::Left, abouts),
        ];
        table(
            &columns,
            self.families.iter().map(|family| {
                let sets = family.sets.join(", ");
                let name = if sets.is_empty() {
                    family.name.clone()
                } else {
                    format!("{}[{sets}]", family.name)
                };
                [name, family.size.to_string(), family.unit.clone(), family.about.clone()]
            }),
        )
    }

    fn pairs(&self) -> Grid {
        let units = self.pairs.iter().any(|pair| !pair.unit.is_empty());
        let abouts = self.pairs.iter().any(|pair| !pair.about.is_empty());
        let columns = [
            ("equation ⟂ variable", Align::Left, true),
            ("pairs", Align::Right, true),
            ("unit", Align::Left, units),
            ("about", Align::Left, abouts),
        ];
        table(
            &columns,
            self.pairs.iter().map(|pair| {
                let name = format!("{} ⟂ {}", pair.equation, pair.variable);
                [name, pair.size.to_string(), pair.unit.clone(), pair.about.clone()]
            }),
        )
    }
}

/// A table of the columns that are wanted.
fn table(columns: &[(&str, Align, bool); 4], rows: impl Iterator<Item = [String; 4]>) -> Grid {
    let mut grid = Grid::with_shown(columns.iter().copied());
    rows.for_each(|row| grid.row(row));
    grid
}

fn write_grid(f: &mut fmt::Formatter<'_>, grid: &Grid) -> fmt::Result {
    let mut text = Vec::new();
    grid.write(&mut text).map_err(|_| fmt::Error)?;
    f.write_str(&String::from_utf8_lossy(&text))
}

/// The smallest and the largest of some norms, with what has them.
fn range(f: &mut fmt::Formatter<'_>, what: &str, ends: [(f64, &str); 2]) -> fmt::Result {
    let [(low, low_name), (high, high_name)] = ends;
    if low < high {
        let (low_name, high_name) = (clean(low_name), clean(high_name));
        let (low, high) = (number(low), number(high));
        writeln!(f, "{what}: {low} (`{low_name}`) to {high} (`{high_name}`)")
    } else {
        writeln!(f, "{what}: {} everywhere", number(low))
    }
}

fn list(f: &mut fmt::Formatter<'_>, what: &str, examples: &Examples, quote: bool) -> fmt::Result {
    if examples.count == 0 {
        return Ok(());
    }
    let quoted = |name: &String| {
        if quote { format!("`{}`", clean(name)) } else { clean(name) }
    };
    let names: Vec<String> = examples.first.iter().map(quoted).collect();
    write!(f, "{what} ({}): {}", examples.count, names.join(", "))?;
    if examples.count > names.len() {
        write!(f, ", …")?;
    }
    writeln!(f)
}

#[cfg(test)]
mod tests {
    use super::super::samples::{Linear, linear, transport};
    use super::*;
    use crate::model::Shape;

    #[test]
    fn a_statement_names_families_pairs_units_and_extremes() {
        let expected = "\
transport: 6 variables (2 free, 2 lower, 1 boxed, 1 fixed), 5 equations, 8 nonzeros of 36 (22.2 %)
sign convention: at a lower bound F >= 0, at an upper bound F <= 0, in between F = 0
 variable    size  unit    about
 x[markets]     2  cases   shipment
 w              1  $/case
 p[markets]     2  $/case  price
 money          1
 equation ⟂ variable  pairs
 profit ⟂ x               2
 supply ⟂ w               1
 demand ⟂ p               2
row norms at the start: 1 everywhere
column norms at the start: 1 everywhere
fixed variables without equation (1): `money`
variables in no equation (1): `money`
";
        assert_eq!(Statement::new(&mut transport()).named("transport").to_string(), expected);
    }

    #[test]
    fn zero_rows_zero_columns_and_nan_are_named() {
        let shape = Shape::anonymous(&[0.0; 4], &[f64::INFINITY; 4], &[1.0; 4]).unwrap();
        let entries =
            [(0, 0, 2.0), (1, 0, 0.0), (2, 2, f64::NAN), (3, 2, 1e-9), (3, 3, 5.0), (0, 1, 0.0)];
        let mut problem = Linear::new(shape, &entries, &[0.0, 1.0, 0.0, 0.0]);
        let statement = Statement::new(&mut problem);
        assert_eq!(statement.zero_rows.first, ["F[2]"]);
        assert_eq!(statement.zero_columns.first, ["z[2]"]);
        assert_eq!(
            statement.non_finite.first,
            ["F of `F[3]` = NaN", "derivative of `F[3]` by `z[3]` = NaN"]
        );
        let text = statement.to_string();
        assert!(text.contains("row norms at the start: 2 (`F[1]`) to 5 (`F[4]`)\n"), "{text}");
        assert!(text.contains("column norms at the start: 2 (`z[1]`) to 5 (`z[4]`)\n"), "{text}");
        assert!(text.contains("equations without any derivative at the start (1): `F[2]`\n"));
        assert!(text.contains("not finite at the start (2): F of `F[3]` = NaN, "));
    }

    #[test]
    fn what_depends_on_nothing_is_listed_apart_from_what_is_zero_at_the_start() {
        let rows = crate::model::Set::count("rows", 4);
        let shape = Shape::builder()
            .variable(crate::Variable::new("z").over(&[&rows]).fixed(1.0))
            .equation(crate::Equation::new("F").over(&[&rows]).complements("z"))
            .variable(crate::Variable::new("alone").fixed(1.0))
            .build()
            .unwrap();
        let entries = [(0, 0, 2.0), (0, 1, 0.0), (2, 0, 0.0), (3, 0, 1.0)];
        let statement = Statement::new(&mut Linear::new(shape, &entries, &[1.0; 5]));
        // The bounds do not matter: these are facts of the formulas.
        assert_eq!(statement.constant_equations.first, ["F[2]"]);
        assert_eq!(statement.unread_variables.first, ["z[3]", "z[4]", "alone"]);
        assert_eq!((statement.zero_rows.count, statement.zero_columns.count), (0, 0));
        assert_eq!(
            (statement.smallest_row.as_ref(), statement.largest_column.as_ref()),
            (None, None)
        );
        let text = statement.to_string();
        assert!(text.contains("equations that read no variable (1): `F[2]`\n"), "{text}");
        assert!(text.contains("variables in no equation (3): `z[3]`, `z[4]`, `alone`\n"), "{text}");
    }

    #[test]
    fn norms_leave_out_fixed_variables_and_their_equations() {
        let (inf, mut upper) = (f64::INFINITY, [f64::INFINITY; 3]);
        upper[1] = 0.0;
        let shape = Shape::anonymous(&[0.0; 3], &upper, &[0.0; 3]).unwrap();
        let entries =
            [(0, 0, -3.0), (1, 1, 1e9), (1, 2, 1e9), (0, 1, 1e7), (2, 0, 0.5), (2, 2, inf)];
        let statement = Statement::new(&mut Linear::new(shape, &entries, &[0.0; 3]));
        let row = statement.largest_row.unwrap();
        assert_eq!((row.norm, row.equation.as_str()), (1e7, "F[1]"));
        let column = statement.largest_column.unwrap();
        assert_eq!((column.norm, column.variable.as_str()), (3.0, "z[1]"));
        assert_eq!(statement.smallest_column.unwrap().norm, 3.0);
    }

    #[test]
    fn long_lists_of_names_are_cut() {
        let mut problem = linear(30);
        let entries: Vec<(usize, usize, f64)> = (0..30).map(|i| (i, i, 0.0)).collect();
        problem = Linear::new(problem.shape, &entries, &[1.0; 30]);
        let statement = Statement::new(&mut problem);
        assert_eq!((statement.zero_rows.count, statement.zero_rows.first.len()), (30, 10));
        assert!(statement.to_string().contains("`F[10]`, …\n"));
        assert_eq!(statement.smallest_row, None);
    }

    #[cfg(feature = "serde")]
    #[test]
    fn a_statement_is_json() {
        let json = serde_json::to_value(Statement::new(&mut transport())).unwrap();
        assert_eq!(json["kinds"]["boxed"], 1);
        assert_eq!(json["families"][0]["sets"][0], "markets");
        assert_eq!(json["pairs"][2]["variable"], "p");
        assert_eq!(json["largest_row"]["norm"], 1.0);
        assert_eq!(json["largest_column"]["norm"], 1.0);
        assert_eq!(json["smallest_column"]["variable"], "x[new-york]");
        assert_eq!(json["constant_equations"]["count"], 0);
        assert_eq!(json["unread_variables"]["first"][0], "money");
    }
}
