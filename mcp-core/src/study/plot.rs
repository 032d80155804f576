//! A sweep as a picture: one line for each number, a mark where the active set changes.

use super::SweepTable;
use crate::report::format::number;
use plotters::prelude::*;
use std::path::Path;

/// Size of the picture in pixels.
const SIZE: (u32, u32) = (900, 540);

/// Font and its size in pixels.
const FONT: (&str, u32) = ("sans-serif", 15);

/// Colors of lines that also the color-blind can tell apart, after Okabe and Ito: blue, vermilion,
/// green, purple, orange, sky blue, black. Feature `plots`.
pub const COLORS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
];

/// Part of the range that is left free above and below the lines.
const MARGIN: f64 = 0.05;

/// Why a picture could not be drawn.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PlotError {
    /// No column has two finite numbers to draw a line through.
    #[error("there is nothing to plot: no number has two finite values")]
    Nothing,
    /// The numbers are so large that their range overflows.
    #[error("the numbers are too large to plot: their range is no number")]
    TooWide,
    /// The picture could not be made or its file not be written.
    #[error("the plot cannot be drawn: {reason}")]
    Drawing {
        /// What the drawing library says.
        reason: String,
    },
}

impl SweepTable {
    /// Draws the numbers over the parameter as an SVG of 900 × 540 pixels: one line for each, in points
    /// that are solutions, and a thin vertical line wherever a variable came to a bound or left one.
    ///
    /// # Errors
    /// [`PlotError`].
    pub fn write_svg(&self, path: impl AsRef<Path>) -> Result<(), PlotError> {
        self.draw(SVGBackend::new(path.as_ref(), SIZE))
    }

    /// The picture of [`write_svg`](Self::write_svg) as text.
    ///
    /// # Errors
    /// [`PlotError`].
    pub fn svg(&self) -> Result<String, PlotError> {
        let mut text = String::new();
        self.draw(SVGBackend::with_string(&mut text, SIZE))?;
        Ok(text)
    }

    fn draw(&self, backend: SVGBackend<'_>) -> Result<(), PlotError> {
        let lines: Vec<(String, Vec<(f64, f64)>)> = self.lines();
        let points = || lines.iter().flat_map(|(_, points)| points.iter());
        if !lines.iter().any(|(_, points)| points.len() > 1) {
            return Err(PlotError::Nothing);
        }
        let (left, right) = range(points().map(|point| point.0), 0.0);
        let (low, high) = range(points().map(|point| point.1), MARGIN);
        // Of endless axes the marks would never end.
        if ![right - left, high - low].into_iter().all(f64::is_finite) {
            return Err(PlotError::TooWide);
        }
        let area = backend.into_drawing_area();
        area.fill(&WHITE).map_err(failed)?;
        let mut chart = ChartBuilder::on(&area)
            .margin(12)
            .x_label_area_size(44)
            .y_label_area_size(76)
            .build_cartesian_2d(left..right, low..high)
            .map_err(failed)?;
        let label = |x: &f64| number(*x);
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.1))
            .label_style(FONT)
            .axis_desc_style(FONT)
            .x_desc(&self.parameter)
            .y_desc(self.vertical_axis())
            .x_label_formatter(&label)
            .y_label_formatter(&label)
            .draw()
            .map_err(failed)?;
        for point in self.points.iter().filter(|point| !point.changes.is_empty()) {
            let mark = [(point.value, low), (point.value, high)];
            chart.draw_series(LineSeries::new(mark, BLACK.mix(0.35))).map_err(failed)?;
        }
        for (k, (name, points)) in lines.into_iter().enumerate() {
            let style = COLORS[k % COLORS.len()].stroke_width(2);
            chart
                .draw_series(LineSeries::new(points, style))
                .map_err(failed)?
                .label(name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], style));
        }
        chart
            .configure_series_labels()
            .label_font(FONT)
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3))
            .position(SeriesLabelPosition::UpperLeft)
            .draw()
            .map_err(failed)?;
        area.present().map_err(failed)
    }

    /// Name and finite points of each column.
    fn lines(&self) -> Vec<(String, Vec<(f64, f64)>)> {
        let line = |column: &super::SweepColumn| {
            let points = self.points.iter().zip(&column.values);
            let points = points.map(|(point, &value)| (point.value, value));
            (column.name.clone(), points.filter(|point| point.1.is_finite()).collect())
        };
        self.columns.iter().map(line).collect()
    }

    /// The unit that all columns have.
    fn vertical_axis(&self) -> String {
        if self.is_percent {
            return "change [%]".to_owned();
        }
        let unit = self.columns.first().map_or("", |column| column.unit.as_str());
        let is_common = self.columns.iter().all(|column| column.unit == unit);
        if is_common { unit.to_owned() } else { String::new() }
    }
}

/// Smallest and largest number with a margin; never empty.
fn range(numbers: impl Iterator<Item = f64>, margin: f64) -> (f64, f64) {
    let (low, high) = numbers
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    let width = high - low;
    let around = if width > 0.0 { margin * width } else { low.abs().max(1.0) / 2.0 };
    (low - around, high + around)
}

#[allow(clippy::needless_pass_by_value, reason = "it is given to map_err")]
fn failed(error: impl std::error::Error) -> PlotError {
    PlotError::Drawing { reason: error.to_string() }
}
