//! Time and memory against the number of unknowns, with their slopes.

use crate::Line;
use crate::cases::{Kind, Way};
use plotters::prelude::*;
use std::error::Error;

/// A series of the picture.
struct Series<'a> {
    name: String,
    points: Vec<(f64, f64)>,
    color: &'a RGBColor,
}

const COLORS: [RGBColor; 6] = [
    RGBColor(0, 90, 160),
    RGBColor(200, 80, 0),
    RGBColor(0, 130, 70),
    RGBColor(140, 60, 150),
    RGBColor(120, 120, 120),
    RGBColor(180, 150, 0),
];

/// Draws series of at least two sizes.
pub(crate) fn draw(lines: &[Line], path: &str) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::new(path, (1000, 480)).into_drawing_area();
    root.fill(&WHITE)?;
    let halves = root.split_evenly((1, 2));
    panel(&halves[0], "processor time [s]", &series(lines, |line| line.cpu))?;
    panel(&halves[1], "peak memory [MB]", &series(lines, |line| line.megabytes))?;
    root.present()?;
    Ok(())
}

fn series<'a>(lines: &[Line], of: impl Fn(&Line) -> f64) -> Vec<Series<'a>> {
    let mut found: Vec<(Kind, Way)> = Vec::new();
    for Line { case, .. } in lines {
        if !found.contains(&(case.kind, case.way)) {
            found.push((case.kind, case.way));
        }
    }
    let mut all = Vec::new();
    for (kind, way) in found {
        let same = lines.iter().filter(|line| (line.case.kind, line.case.way) == (kind, way));
        let mut points: Vec<(f64, f64)> = same.map(|line| (line.n as f64, of(line))).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        if let (Some(first), Some(last)) = (points.first(), points.last())
            && last.0 > first.0
        {
            let slope = (last.1 / first.1).ln() / (last.0 / first.0).ln();
            let name = format!("{kind:?} {way:?}, slope {slope:.2}");
            all.push(Series { name, points, color: &COLORS[all.len() % COLORS.len()] });
        }
    }
    all
}

fn panel<B: DrawingBackend>(
    area: &DrawingArea<B, plotters::coord::Shift>,
    title: &str,
    all: &[Series<'_>],
) -> Result<(), Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    let values = all.iter().flat_map(|series| &series.points);
    let (mut low, mut high) = ((f64::MAX, f64::MAX), (0.0_f64, 0.0_f64));
    for point in values {
        low = (low.0.min(point.0), low.1.min(point.1));
        high = (high.0.max(point.0), high.1.max(point.1));
    }
    if high.0 == 0.0 {
        return Ok(());
    }
    let x = (low.0 / 1.5..high.0 * 1.5).log_scale();
    let y = (low.1 / 1.5..high.1 * 4.0).log_scale();
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .caption(title, ("sans-serif", 16))
        .x_label_area_size(36)
        .y_label_area_size(56)
        .build_cartesian_2d(x, y)?;
    chart.configure_mesh().x_desc("unknowns").light_line_style(WHITE).draw()?;
    for series in all {
        let points = series.points.iter().copied();
        let style = series.color.stroke_width(2);
        chart
            .draw_series(LineSeries::new(points, style).point_size(3))?
            .label(&series.name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], style));
    }
    chart.configure_series_labels().position(SeriesLabelPosition::UpperLeft).draw()?;
    Ok(())
}
