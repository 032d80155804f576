//! `mcp check`: a model looked at, not solved.

use crate::args::Check;
use crate::error::CliError;
use crate::exit::Outcome;
use crate::files;
use crate::solve::set_start;
use crate::style::Style;
use mcp_cli::nl::maximum_matching;
use mcp_core::{
    AdProblem, BoundKind, DerivativeReport, PointCheck, Problem, Shape, Statement,
    check_derivatives,
};
use std::io::{self, Write};

/// Above so many variables derivatives are checked only if asked for: `24 n` evaluations of `F`.
const DERIVATIVES: usize = 1000;
/// Pairs that are listed.
const PAIRS: usize = 50;
/// Names that a finding lists.
const NAMES: usize = 10;
/// Norms of rows or columns that differ by more than this factor are worth a word.
const SCALE: f64 = 1e6;

/// What was found.
#[derive(Debug, Default)]
struct Findings {
    /// What stops a solve, or makes its answer wrong.
    faults: Vec<String>,
    /// What may make a solve hard.
    warnings: Vec<String>,
}

/// Carries out `mcp check`.
pub(crate) fn run(args: &Check, out: &mut impl Write) -> Result<Outcome, CliError> {
    let model = files::model(&args.model)?;
    let failed = CliError::problem(&args.model);
    let mut problem = AdProblem::new(&model).map_err(&failed)?;
    set_start(&mut problem, args.start.as_deref())?;
    let start = Problem::shape(&problem).start().to_vec();

    let statement = Statement::new(&mut problem).named(files::name(&args.model));
    write!(out, "{statement}")?;
    write_pairs(Problem::shape(&problem), out)?;
    let point = PointCheck::new(&mut problem, &start).map_err(&failed)?;
    writeln!(out, "\nat the start\n{point}")?;

    let mut findings = Findings::default();
    findings.of_structure(&statement);
    findings.warnings.extend_from_slice(model.warnings());
    findings.of_pattern(&problem);
    findings.of_matching(&problem);
    findings.of_scales(&statement);
    if start.len() <= DERIVATIVES || args.derivatives {
        let report = check_derivatives(&model, &start).map_err(&failed)?;
        writeln!(out, "\nderivatives at the start\n{report}")?;
        findings.of_derivatives(report);
    } else {
        writeln!(
            out,
            "\nderivatives are not checked: more than {DERIVATIVES} variables; ask with --derivatives"
        )?;
    }
    findings.write(out)?;
    Ok(Outcome::of(findings.faults.is_empty()))
}

/// Which equation belongs to which variable.
fn write_pairs(shape: &Shape, out: &mut impl Write) -> io::Result<()> {
    let (bounds, start) = (shape.bounds(), shape.start());
    let rows: Vec<[String; 5]> = (0..shape.n().min(PAIRS))
        .map(|i| {
            let equation = shape.row_of_variable(i).map(|_| shape.equation_name(i));
            let number = |x: f64| format!("{}", x + 0.0);
            [
                equation.unwrap_or_else(|| "(none)".to_owned()),
                shape.variable_name(i),
                number(bounds.lower()[i]),
                number(start[i]),
                number(bounds.upper()[i]),
            ]
        })
        .collect();
    let headers = ["equation", "⟂ variable", "lower", "start", "upper"].map(str::to_owned);
    let width = |k: usize| {
        std::iter::once(&headers).chain(&rows).map(|row| row[k].chars().count()).max().unwrap_or(0)
    };
    let widths = [0, 1, 2, 3, 4].map(width);
    writeln!(out, "\npairs")?;
    for row in std::iter::once(&headers).chain(&rows) {
        let [a, b, c, d, e] = widths;
        let [equation, variable, lower, start, upper] = row;
        writeln!(out, " {equation:<a$}  {variable:<b$}  {lower:>c$}  {start:>d$}  {upper:>e$}")?;
    }
    match shape.n().saturating_sub(PAIRS) {
        0 => Ok(()),
        more => writeln!(out, " … and {more} more"),
    }
}

impl Findings {
    fn of_structure(&mut self, statement: &Statement) {
        let list = |names: &mcp_core::report::Examples| {
            let more = if names.count > names.first.len() { ", …" } else { "" };
            format!("{}{more}", names.first.join(", "))
        };
        let found = |names: &mcp_core::report::Examples| names.count > 0;
        if found(&statement.non_finite) {
            let list = list(&statement.non_finite);
            self.faults.push(format!(
                "not finite at the start: {list}; start inside the domain, or bound the variables \
                 away from where it ends"
            ));
        }
        if found(&statement.zero_rows) {
            let list = list(&statement.zero_rows);
            self.warnings.push(format!(
                "all derivatives vanish at the start: {list}; another start may help"
            ));
        }
        if found(&statement.zero_columns) {
            let list = list(&statement.zero_columns);
            self.warnings.push(format!("no equation depends at the start on: {list}"));
        }
    }

    /// Pairs that have no part in the system. Fixed variables need none.
    fn of_pattern(&mut self, problem: &dyn Problem) {
        let (shape, pattern) = (problem.shape(), problem.pattern());
        let mut reads = vec![false; pattern.n()];
        pattern.rows().for_each(|i| reads[i] = true);
        let moves = |&i: &usize| shape.bounds().kind(i) != BoundKind::Fixed;
        let constant = (0..pattern.n()).filter(|&i| !reads[i]).filter(moves);
        let unread = (0..pattern.n()).filter(|&j| pattern.column(j).is_empty()).filter(moves);
        let kinds: [(&str, Vec<String>); 2] = [
            ("equations that read no variable", constant.map(|i| shape.equation_name(i)).collect()),
            ("variables in no equation", unread.map(|j| shape.variable_name(j)).collect()),
        ];
        for (what, names) in kinds {
            self.of_names(what, &names);
        }
    }

    /// Equations of free variables have to hold whatever the bounds are, so that each needs a variable
    /// of its own that moves: without, `J` is singular everywhere.
    fn of_matching(&mut self, problem: &dyn Problem) {
        let (shape, pattern) = (problem.shape(), problem.pattern());
        let kind = |i: usize| shape.bounds().kind(i);
        let mut reads: Vec<Vec<u32>> = vec![Vec::new(); pattern.n()];
        for j in (0..pattern.n()).filter(|&j| kind(j) != BoundKind::Fixed) {
            for i in pattern.column_rows(j) {
                reads[i].push(u32::try_from(j).expect("an index of the pattern"));
            }
        }
        let equations: Vec<usize> =
            (0..pattern.n()).filter(|&i| kind(i) == BoundKind::Free).collect();
        let found = maximum_matching(equations.len(), pattern.n(), |e| &reads[equations[e]]);
        let unmatched = equations.iter().zip(found).filter(|(_, variable)| variable.is_none());
        let names: Vec<String> = unmatched.map(|(&i, _)| shape.equation_name(i)).collect();
        self.of_names("equations that determine no variable of their own", &names);
    }

    /// A warning with the first names.
    fn of_names(&mut self, what: &str, names: &[String]) {
        if !names.is_empty() {
            let first = names[..names.len().min(NAMES)].join(", ");
            let more = if names.len() > NAMES { ", …" } else { "" };
            self.warnings.push(format!("{what} ({}): {first}{more}", names.len()));
        }
    }

    fn of_scales(&mut self, statement: &Statement) {
        if let (Some(small), Some(large)) = (&statement.smallest_row, &statement.largest_row) {
            let names = [large.equation.as_str(), &small.equation];
            self.of_sizes("rows", large.norm / small.norm, names);
        }
        if let (Some(small), Some(large)) = (&statement.smallest_column, &statement.largest_column)
        {
            let names = [large.variable.as_str(), &small.variable];
            self.of_sizes("columns", large.norm / small.norm, names);
        }
    }

    fn of_sizes(&mut self, what: &str, ratio: f64, [large, small]: [&str; 2]) {
        if ratio > SCALE {
            self.warnings.push(format!(
                "{what} of J differ in size by {ratio:.0e}: `{large}` and `{small}`; other units may help"
            ));
        }
    }

    fn of_derivatives(&mut self, report: DerivativeReport) {
        if let Err(wrong) = report.verdict() {
            self.faults.push(format!("wrong derivative: {wrong}"));
        }
    }

    fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let (faults, warnings) = (&self.faults, &self.warnings);
        writeln!(out)?;
        for fault in faults {
            writeln!(out, "fault: {fault}")?;
        }
        for warning in warnings {
            writeln!(out, "warning: {warning}")?;
        }
        let count = |list: &[String], noun: &str| match list.len() {
            0 => format!("no {noun}s"),
            1 => format!("1 {noun}"),
            more => format!("{more} {noun}s"),
        };
        let verdict = format!("{}, {}", count(faults, "fault"), count(warnings, "warning"));
        writeln!(out, "{}", Style::of_stdout().verdict(&verdict, faults.is_empty()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_found_is_said() {
        let mut out = Vec::new();
        Findings::default().write(&mut out).unwrap();
        assert_eq!(String::from_utf8(out).unwrap(), "\nno faults, no warnings\n");
    }

    #[test]
    fn equations_of_one_variable_are_one_too_many() {
        // x = 1, x = 2, x + y + z = 3, all free.
        let nl = b"g3 1 1 0
 3 3 0 0 3
 0 0
 0 0
 0 0 0
 0 0 0 1
 0 0 0 0 0
 5 0
 0 0
 0 0 0 0 0
r
4 1
4 2
4 3
b
3
3
3
J0 1
0 1
J1 1
0 1
J2 3
0 1
1 1
2 1
";
        let model = mcp_cli::nl::NlModel::parse(nl, mcp_cli::nl::Names::default()).unwrap();
        let mut findings = Findings::default();
        findings.of_matching(&AdProblem::new(&model).unwrap());
        let expected = "equations that determine no variable of their own (1): _scon[2]";
        assert_eq!(findings.warnings, [expected]);
    }
}
