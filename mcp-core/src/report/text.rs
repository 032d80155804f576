//! A [`Report`] as text.

use super::format::{Align, Grid, clean, count, number, size};
use super::{Fault, Report, SIGN_CONVENTION};
use crate::model::{BoundKind, Family};
use std::fmt;
use std::io::{self, Write};

/// Up to this many rows a solution table is complete.
const SHORT_TABLE: usize = 50;
/// Rows a longer table shows of each family.
pub(super) const ROWS_OF_A_FAMILY: usize = 50;
/// Variables shown with a fault.
const READS: usize = 8;
/// Equations listed for a solve that did not end in a solution.
const WORST: usize = 5;

impl Report {
    /// Writes the report as text: sign convention, parts that are on, status and advice, both residuals, costs, what
    /// went wrong where, final statistics, solution table, reports and definitions.
    ///
    /// The table has all rows if there are at most 50. A longer one leaves out variables at their
    /// lower bound, fixed ones and zeros not at their upper bound, and shows at most 50 of a
    /// family; it says how many are missing. The column `rent` stands only where some variable has
    /// an upper bound, `unit` where some has a unit.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_text(&self, out: &mut impl Write) -> io::Result<()> {
        self.write_head(out)?;
        self.write_outcome(out)?;
        self.write_worst(out)?;
        writeln!(out, "\nfinal statistics (largest absolute value)")?;
        write!(out, "{}", self.statistics)?;
        self.write_table(out)?;
        self.write_derived(out)
    }

    fn write_head(&self, out: &mut impl Write) -> io::Result<()> {
        let name = if self.name.is_empty() { String::new() } else { clean(&self.name) + ": " };
        let variables = count(self.row_count(), "variable");
        writeln!(out, "{name}mixed complementarity problem, {variables}")?;
        writeln!(out, "sign convention: {SIGN_CONVENTION}; the marginal is F")?;
        match &self.shape.parts()[..] {
            [] => Ok(()),
            parts => writeln!(out, "parts: {}", parts.join(", ")),
        }
    }

    fn write_outcome(&self, out: &mut impl Write) -> io::Result<()> {
        let (solution, certificate) = (&self.solution, self.certificate());
        writeln!(out)?;
        let mut line = |label: &str, text: String| writeln!(out, " {label:<17}  {text}");
        let status = solution.status;
        line("status", format!("{}: {}", status.name(), status.meaning()))?;
        if !status.advice().is_empty() {
            line("advice", status.advice().to_owned())?;
        }
        let at = |residual, i| match self.worst_equation(residual, i) {
            Some(name) => format!("worst equation `{}`", clean(&name)),
            None => "in every equation".to_owned(),
        };
        let (natural, relative) = (certificate.natural_residual, certificate.relative_residual);
        let worst = at(natural, certificate.worst);
        line("natural residual", format!("{} (units of the model), {worst}", size(natural)))?;
        let relative_text = if relative.is_nan() && !certificate.is_finite {
            "NaN (no units): F or J is not finite".to_owned()
        } else {
            format!("{} (no units), {}", size(relative), at(relative, certificate.worst_relative))
        };
        line("relative residual", relative_text)?;
        line("method", solution.method.name().to_owned())?;
        let stats = &solution.stats;
        let work = [
            count(stats.iterations, "iteration"),
            count(stats.residual_evaluations, "evaluation") + " of F",
            format!("{} of J", stats.jacobian_evaluations),
            count(stats.factorisations, "factorisation"),
            count(stats.gradient_steps, "gradient step"),
            format!("{} of both by the certificate", stats.certificate_evaluations),
        ];
        line("work", work.join(", "))?;
        if !solution.stages.is_empty() {
            let stages: Vec<String> = solution.stages.iter().map(ToString::to_string).collect();
            line("stages", stages.join(", "))?;
        }
        if let Some(diagnosis) = &solution.diagnosis {
            line("found", clean(&diagnosis.describe(&self.shape)))?;
        }
        if solution.start_was_moved {
            let why = "variables at a bound were moved inside: F or J was not finite at the start";
            line("start", why.to_owned())?;
        }
        if certificate.bound_violation > 0.0 {
            line("bounds", format!("violated by up to {}", size(certificate.bound_violation)))?;
        }
        if let Some(i) = certificate.vanishing_row.filter(|&i| i < self.row_count()) {
            let name = clean(&self.shape.equation_name(i));
            line("vanishing", format!("equation `{name}` has lost all its derivatives"))?;
        }
        if let Some(j) = certificate.runaway().filter(|&j| j < self.row_count()) {
            let name = clean(&self.shape.variable_name(j));
            let level = number(self.solution.z[j]);
            line("diverging", format!("variable `{name}` has run away to {level}"))?;
        }
        if let Some(fault) = &self.fault {
            line("not finite", fault.to_string())?;
        }
        Ok(())
    }

    /// The worst equations of a point that is no solution.
    fn write_worst(&self, out: &mut impl Write) -> io::Result<()> {
        let worst = if self.solution.is_solved() { Vec::new() } else { self.worst(WORST) };
        if worst.is_empty() {
            return Ok(());
        }
        writeln!(out, "\nworst equations (natural residual)")?;
        let mut grid = Grid::new([
            ("equation", Align::Left),
            ("residual", Align::Point),
            ("F", Align::Point),
            ("⟂ variable", Align::Left),
            ("level", Align::Point),
        ]);
        for (i, residual) in worst {
            grid.row([
                self.shape.equation_name(i),
                size(residual),
                number(self.solution.f[i]),
                self.shape.variable_name(i),
                number(self.solution.z[i]),
            ]);
        }
        grid.write(out)
    }

    fn write_table(&self, out: &mut impl Write) -> io::Result<()> {
        let n = self.row_count();
        let bounds = self.shape.bounds();
        let rents = (0..n).any(|i| matches!(bounds.kind(i), BoundKind::Upper | BoundKind::Boxed));
        let units = self.shape.variables().iter().any(|family| !family.unit().is_empty());
        let columns = [
            ("variable", Align::Left, true),
            ("lower", Align::Point, true),
            ("level", Align::Point, true),
            ("upper", Align::Point, true),
            ("unit", Align::Left, units),
            ("marginal", Align::Point, true),
            ("rent", Align::Point, rents),
            ("state", Align::Left, true),
            ("⟂ equation", Align::Left, true),
        ];
        let mut grid = Grid::with_shown(columns);
        let all = n <= SHORT_TABLE;
        let mut missing = 0;
        for family in self.shape.variables() {
            let listed = self.listed(family, all);
            for &i in &listed {
                let row = self.row(i);
                let optional = |x: Option<f64>| x.map(number).unwrap_or_default();
                grid.row([
                    row.variable,
                    number(row.lower),
                    number(row.level),
                    number(row.upper),
                    row.unit,
                    optional(row.marginal),
                    optional(row.rent),
                    row.state.name().to_owned(),
                    row.equation.unwrap_or_default(),
                ]);
            }
            if listed.len() < family.len() {
                let left_out = family.len() - listed.len();
                missing += left_out;
                grid.note(format!("… {left_out} of {} `{}`", family.len(), clean(family.name())));
            }
        }
        writeln!(out, "\nsolution")?;
        grid.write(out)?;
        if missing > 0 {
            writeln!(
                out,
                "left out: {missing} of {n} variables (at a lower bound, fixed, zero, or beyond \
                 {ROWS_OF_A_FAMILY} of a family); the CSV has all"
            )?;
        }
        Ok(())
    }

    /// Variables of a family that a table lists.
    fn listed(&self, family: &Family, all: bool) -> Vec<usize> {
        let elements = family.offset()..family.offset() + family.len();
        if all {
            elements.collect()
        } else {
            elements.filter(|&i| !self.is_default(i)).take(ROWS_OF_A_FAMILY).collect()
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = Vec::new();
        self.write_text(&mut text).map_err(|_| fmt::Error)?;
        f.write_str(&String::from_utf8_lossy(&text))
    }
}

/// Such as ``equation `demand[topeka]`: F = NaN at p[topeka] = -0.3``.
impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "equation `{}`: ", clean(&self.equation))?;
        match &self.derivative_by {
            None => write!(f, "F = {}", number(self.value))?,
            Some(by) => write!(f, "derivative by `{}` = {}", clean(by), number(self.value))?,
        }
        for (k, (variable, value)) in self.reads.iter().take(READS).enumerate() {
            let joint = if k == 0 { " at " } else { ", " };
            write!(f, "{joint}{} = {}", clean(variable), number(*value))?;
        }
        match self.reads.len().saturating_sub(READS) {
            0 => Ok(()),
            more => write!(f, ", and {} more", count(more, "variable")),
        }
    }
}

#[cfg(test)]
#[path = "text_tests.rs"]
mod tests;
