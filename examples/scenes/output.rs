//! What a run leaves behind: table, CSV, picture.

use mcp_core::dynamics::{StepReport, TimeStepper};
use mcp_core::study::COLORS;
use plotters::prelude::*;
use std::error::Error;
use std::fmt;
use std::path::Path;

/// Columns of the step table.
pub(crate) const HEADER: &str =
    "      time  unknowns  active  iterations  residual          energy";

/// Most points of a line in a picture.
const MOST_POINTS: usize = 2000;

/// A step and the state after it.
pub(crate) struct Row {
    report: StepReport,
    energy: Option<f64>,
    state: Vec<f64>,
}

impl Row {
    pub(crate) fn of(report: StepReport, stepper: &dyn TimeStepper) -> Self {
        Row { report, energy: stepper.energy(), state: stepper.state() }
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let StepReport { time, unknowns, active, iterations, residual, .. } = self.report;
        write!(f, "{time:>10.4}{unknowns:>10}{active:>8}{iterations:>12}{residual:>10.1e}")?;
        match self.energy {
            Some(energy) => write!(f, "{energy:>16.9}"),
            None => write!(f, "{:>16}", "-"),
        }
    }
}

/// All steps of a run.
pub(crate) struct Output {
    names: Vec<String>,
    rows: Vec<Row>,
}

impl Output {
    pub(crate) fn new(names: Vec<String>) -> Self {
        Output { names, rows: Vec::new() }
    }

    pub(crate) fn push(&mut self, row: Row) {
        self.rows.push(row);
    }

    /// `final t=… state=…`, 12 significant digits.
    pub(crate) fn last_line(&self) -> String {
        let Some(row) = self.rows.last() else { return String::new() };
        let state: Vec<String> = row.state.iter().map(|x| format!("{x:.11e}")).collect();
        format!("final t={:.11e} state={}", row.report.time, state.join(","))
    }

    /// All steps as CSV; names are quoted where they need it.
    pub(crate) fn write_csv(&self, path: &Path) -> csv::Result<()> {
        let mut csv = csv::Writer::from_path(path)?;
        let columns = ["time", "unknowns", "active", "iterations", "residual", "energy"];
        csv.write_record(columns.into_iter().chain(self.names.iter().map(String::as_str)))?;
        for row in &self.rows {
            let StepReport { time, unknowns, active, iterations, residual, .. } = row.report;
            let energy = row.energy.map_or(String::new(), |energy| energy.to_string());
            let counts = [unknowns, active, iterations].map(|count| count.to_string());
            let step = [time.to_string()].into_iter().chain(counts);
            let step = step.chain([format!("{residual:e}"), energy]);
            csv.write_record(step.chain(row.state.iter().map(f64::to_string)))?;
        }
        csv.flush()?;
        Ok(())
    }

    /// Numbers that are neither velocities nor multipliers, at most seven.
    fn shown(&self) -> Vec<usize> {
        let is_multiplier = |name: &String| name.starts_with("r[") || name.starts_with("rt[");
        let is_shown = |name: &String| !name.ends_with('\'') && !is_multiplier(name);
        let shown = (0..self.names.len()).filter(|&k| is_shown(&self.names[k]));
        shown.take(COLORS.len()).collect()
    }

    /// The trajectory over time.
    pub(crate) fn write_svg(&self, title: &str, path: &Path) -> Result<(), Box<dyn Error>> {
        let every = self.rows.len().div_ceil(MOST_POINTS).max(1);
        let line = |k: usize| {
            let point = move |row: &Row| (row.report.time, row.state[k]);
            self.rows.iter().step_by(every).map(point).filter(|point| point.1.is_finite())
        };
        let shown = self.shown();
        let values = shown.iter().flat_map(|&k| line(k).map(|point| point.1));
        let (low, high) = values
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let margin = 0.05 * (high - low).max(1e-9);
        let end = self.rows.last().map_or(1.0, |row| row.report.time).max(f64::MIN_POSITIVE);
        let area = SVGBackend::new(path, (900, 540)).into_drawing_area();
        area.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&area)
            .margin(12)
            .caption(title, ("sans-serif", 18))
            .x_label_area_size(44)
            .y_label_area_size(76)
            .build_cartesian_2d(0.0..end, low - margin..high + margin)?;
        // Without the last digits, which are rounding, and without −0.
        let label = |x: &f64| ((x * 1e9).round() / 1e9 + 0.0).to_string();
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.1))
            .label_style(("sans-serif", 15))
            .x_desc("time [s]")
            .x_label_formatter(&label)
            .y_label_formatter(&label)
            .draw()?;
        for (color, &k) in COLORS.iter().zip(&shown) {
            let style = color.stroke_width(2);
            chart
                .draw_series(LineSeries::new(line(k), style))?
                .label(&self.names[k])
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], style));
        }
        chart
            .configure_series_labels()
            .label_font(("sans-serif", 15))
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3))
            .position(SeriesLabelPosition::UpperRight)
            .draw()?;
        area.present()?;
        Ok(())
    }
}
