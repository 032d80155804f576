//! [`Table`]: the lines of a batch as text and CSV.

use super::Listed;
use super::line::Line;
use crate::style::Style;
use mcp_core::report::Number;
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::time::Duration;

/// Columns of the CSV file.
const COLUMNS: [&str; 11] = [
    "file",
    "n",
    "nnz",
    "status",
    "residual",
    "relative_residual",
    "iterations",
    "residual_evaluations",
    "jacobian_evaluations",
    "seconds",
    "message",
];

/// Lines so far.
pub(super) struct Table {
    lines: Vec<Line>,
    /// Of the longest file name.
    width: usize,
    style: Style,
}

impl Table {
    /// For these models, none yet solved.
    pub(super) fn new(models: &[Listed]) -> Self {
        let widths = models.iter().map(|model| match model {
            Ok(path) => path.display().to_string().chars().count(),
            Err(line) => line.file.chars().count(),
        });
        let width = widths.max().unwrap_or(0).max("model".len());
        Table { lines: Vec::new(), width, style: Style::of_stdout() }
    }

    /// Whether every model so far was solved.
    pub(super) fn all_solved(&self) -> bool {
        self.lines.iter().all(Line::is_solved)
    }

    /// Writes the names of the columns.
    pub(super) fn write_header(&self, out: &mut impl Write) -> io::Result<()> {
        let width = self.width;
        writeln!(
            out,
            "{:<width$}  {:>7}  {:>8}  {:<21}  {:>8}  {:>5}  {:>5}  {:>5}  {:>8}",
            "model", "n", "nnz", "status", "residual", "iter", "F", "J", "seconds"
        )
    }

    /// Takes note of a line and writes it.
    pub(super) fn write_line(&mut self, line: Line, out: &mut impl Write) -> io::Result<()> {
        let (width, file, seconds) = (self.width, &line.file, line.seconds);
        let status = format!("{:<21}", line.status());
        let status = self.style.verdict(&status, line.is_solved());
        match &line.result {
            Ok(solved) => writeln!(
                out,
                "{file:<width$}  {:>7}  {:>8}  {status}  {:>8.1e}  {:>5}  {:>5}  {:>5}  {seconds:>8.3}",
                solved.n,
                solved.nonzeros,
                solved.residual,
                solved.iterations,
                solved.residual_evaluations,
                solved.jacobian_evaluations,
            )?,
            Err(failure) => {
                let message = failure.message.replace(char::is_control, " ");
                writeln!(out, "{file:<width$}  {:>7}  {:>8}  {status}  {message}", "-", "-")?;
            }
        }
        self.lines.push(line);
        Ok(())
    }

    /// Writes how many ended how, the commonest first, and the time of all.
    pub(super) fn write_summary(&self, time: Duration, out: &mut impl Write) -> io::Result<()> {
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        for line in &self.lines {
            *counts.entry(line.status()).or_default() += 1;
        }
        let mut counts: Vec<(&str, usize)> = counts.into_iter().collect();
        counts.sort_by_key(|&(_, count)| std::cmp::Reverse(count));
        let counts: Vec<String> =
            counts.iter().map(|(status, count)| format!("{count} {status}")).collect();
        let models = match self.lines.len() {
            1 => "1 model".to_owned(),
            many => format!("{many} models"),
        };
        let (counts, seconds) = (counts.join(", "), time.as_secs_f64());
        writeln!(out, "\n{models}: {counts}; {seconds:.1} s")
    }

    /// Writes all lines with every digit; what there is not is empty.
    pub(super) fn write_csv(&self, out: impl Write) -> Result<(), csv::Error> {
        let mut csv = csv::Writer::from_writer(out);
        csv.write_record(COLUMNS)?;
        for line in &self.lines {
            let (status, seconds) = (line.status().to_owned(), format!("{:.6}", line.seconds));
            let none = String::new;
            let cells = match &line.result {
                Ok(solved) => [
                    line.file.clone(),
                    solved.n.to_string(),
                    solved.nonzeros.to_string(),
                    status,
                    Number(solved.residual).to_string(),
                    Number(solved.relative_residual).to_string(),
                    solved.iterations.to_string(),
                    solved.residual_evaluations.to_string(),
                    solved.jacobian_evaluations.to_string(),
                    seconds,
                    none(),
                ],
                Err(failure) => [
                    line.file.clone(),
                    none(),
                    none(),
                    status,
                    none(),
                    none(),
                    none(),
                    none(),
                    none(),
                    seconds,
                    failure.message.clone(),
                ],
            };
            csv.write_record(cells)?;
        }
        csv.flush()?;
        Ok(())
    }
}
