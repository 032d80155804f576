//! Runs as a table for people and as CSV.

use super::study::Run;
use std::fmt::Write as _;

/// One line for each run of a case: what was set, what was reached, what it cost.
pub fn table(runs: &[Run]) -> String {
    let mut text = format!(
        "{:<20}{:>6}{:>10}{:>10}{:>6}{:>6}{:>6}{:>12}{:>12}  ended\n",
        "setting", "tol", "error", "residual", "F", "J", "LU", "operations", "median"
    );
    for run in runs {
        let cost = run.cost;
        let operations = cost.operations.map_or("·".to_owned(), |n| n.to_string());
        let median = run.timing.map_or("·".to_owned(), |timing| seconds(timing.median));
        let _ = writeln!(
            text,
            "{:<20}{:>6.0e}{:>10.1e}{:>10.1e}{:>6}{:>6}{:>6}{operations:>12}{median:>12}  {}",
            run.setting.name(),
            run.setting.tolerance,
            run.error,
            run.residual,
            cost.residual,
            cost.jacobian,
            cost.factorisations,
            run.status.name(),
        );
    }
    text
}

/// `12.3 µs`, `4.56 ms`, `7.89 s`.
fn seconds(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-3 => (1e6 * s, "µs"),
        s if s < 1.0 => (1e3 * s, "ms"),
        s => (s, "s"),
    };
    let decimals = if value < 10.0 { 2 } else { usize::from(value < 100.0) };
    format!("{value:.decimals$} {unit}")
}

/// The header of [`csv`].
const HEADER: &str = "problem,n,method,source,arithmetic,scaling,tail,warm,tolerance,status,error,\
                      residual,relative_residual,F,J,factorisations,operations,median_s,minimum_s,runs";

/// Runs of several cases, given with name and number of variables, as CSV with a header. What is
/// unknown is empty.
pub fn csv<'r>(cases: impl IntoIterator<Item = (&'r str, usize, &'r [Run])>) -> String {
    let mut text = format!("{HEADER}\n");
    for (name, n, runs) in cases {
        for run in runs {
            let (setting, cost) = (run.setting, run.cost);
            let [scaling, tail, warm] = [setting.scaling, setting.tail, setting.warm].map(u8::from);
            let operations = cost.operations.map_or(String::new(), |n| n.to_string());
            let timing = run.timing.map_or(",,".to_owned(), |timing| {
                format!("{:e},{:e},{}", timing.median, timing.minimum, timing.runs)
            });
            let _ = writeln!(
                text,
                "{name},{n},{},\"{}\",{:?},{scaling},{tail},{warm},{:e},{},{:e},{:e},{:e},{},{},{},{operations},{timing}",
                setting.method,
                setting.source,
                setting.arithmetic,
                setting.tolerance,
                run.status.name(),
                run.error,
                run.residual,
                run.relative_residual,
                cost.residual,
                cost.jacobian,
                cost.factorisations,
            );
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::{Setting, problems};

    fn runs() -> Vec<Run> {
        let case = problems::kojima_shindo(true).unwrap();
        vec![Run::new(&case, Setting::default(), None).unwrap()]
    }

    #[test]
    fn a_table_has_a_line_for_each_run() {
        let text = table(&runs());
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 2);
        assert!(lines[1].starts_with("robust") && lines[1].ends_with("solved"), "{text}");
    }

    #[test]
    fn every_line_of_the_csv_has_the_fields_of_the_header() {
        let runs = runs();
        let text = csv([("kojima-shindo", 4, &runs[..])]);
        let fields: Vec<usize> = text.lines().map(|line| line.split(',').count()).collect();
        assert_eq!(fields, [20, 20]);
    }

    #[test]
    fn seconds_have_three_digits_and_a_unit() {
        assert_eq!([2.5e-6, 1.25e-2, 3.0].map(seconds), ["2.50 µs", "12.5 ms", "3.00 s"]);
    }
}
