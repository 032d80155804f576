//! [`Panel`]: the parts of the picture, over a common axis of iterations.

use super::Drawing;
use crate::history::Moment;
use mcp_core::Stage;
use mcp_core::study::COLORS;
use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::ops::Range;

const BLUE: RGBColor = COLORS[0];
const VERMILION: RGBColor = COLORS[1];
const GREEN: RGBColor = COLORS[2];

/// Up to so many iterates each has its own mark, and each bar its number.
const MARKED: usize = 40;

/// Width of a letter of a stage's name in pixels, about.
const LETTER: f64 = 7.0;

/// Sizes around a chart in pixels.
const LEFT: u32 = 14;
const RIGHT: u32 = 20;
const LABELS: u32 = 70;
const BELOW: u32 = 14;
/// Below the last chart, with the name of its axis.
const BELOW_LAST: u32 = 48;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Chart<'c, 'a> = ChartContext<'c, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;
type Failure<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;

/// A vertical axis.
struct Axis {
    name: &'static str,
    range: Range<f64>,
    /// About how many labels.
    labels: usize,
    label: fn(f64) -> String,
}

/// What all panels share.
pub(super) struct Panel<'m> {
    moments: &'m [Moment],
}

impl<'m> Panel<'m> {
    pub(super) fn new(moments: &'m [Moment]) -> Self {
        Panel { moments }
    }

    fn horizontal(&self) -> Range<f64> {
        -0.5..self.moments.len().max(2) as f64 - 0.5
    }

    /// Radius of marks; small where there are many.
    fn mark(&self) -> i32 {
        if self.moments.len() <= MARKED { 4 } else { 1 }
    }

    /// Axes and grid; the horizontal axis has numbers and its name only in the last panel.
    fn chart<'c, 'a>(
        &self,
        area: &'c Area<'a>,
        axis: &Axis,
        is_last: bool,
    ) -> Result<Chart<'c, 'a>, Failure<'a>> {
        let mut chart = ChartBuilder::on(area)
            .margin_left(LEFT)
            .margin_right(RIGHT)
            .margin_top(4)
            .x_label_area_size(if is_last { BELOW_LAST } else { BELOW })
            .y_label_area_size(LABELS)
            .build_cartesian_2d(self.horizontal(), axis.range.clone())?;
        let numbers = |x: &f64| if is_last { whole(*x) } else { String::new() };
        let label = |y: &f64| (axis.label)(*y);
        let mut mesh = chart.configure_mesh();
        mesh.light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.1))
            .label_style(font())
            .axis_desc_style(font())
            .x_labels(self.moments.len().clamp(2, 12))
            .y_labels(axis.labels)
            .x_label_formatter(&numbers)
            .y_label_formatter(&label)
            .y_desc(axis.name);
        if is_last {
            mesh.x_desc("iteration");
        }
        mesh.draw()?;
        Ok(chart)
    }

    /// The natural residual, a line at the tolerance, and where stages begin.
    pub(super) fn residual<'a>(&self, area: &Area<'a>, tol: Option<f64>) -> Drawing<'a> {
        let values = || self.moments.iter().map(|moment| moment.residual);
        let mut range = decades(values().chain(tol));
        if values().any(|value| value == 0.0) {
            range.start -= 1.0;
        }
        let stages = self.stages();
        if !stages.is_empty() {
            // Two lines of names stand above the curve.
            range.end += (range.end - range.start) / 8.0;
        }
        let (low, high) = (range.start, range.end);
        let axis = Axis { name: "natural residual", range, labels: 9, label: power };
        let mut chart = self.chart(area, &axis, false)?;
        for Label { k, name, line } in stages {
            let left = k as f64 - 0.5;
            if k > 0 {
                let line = [(left, low), (left, high)];
                chart.draw_series(DashedLineSeries::new(line, 3, 4, BLACK.mix(0.45).into()))?;
            }
            let style = small().pos(Pos::new(HPos::Left, VPos::Top));
            let text = Text::new(name, (4, 2 + 15 * line), style);
            chart.plotting_area().draw(&(EmptyElement::at((left, high)) + text))?;
        }
        if let Some(tol) = tol {
            let height = tol.log10();
            let ends = [(self.horizontal().start, height), (self.horizontal().end, height)];
            let style = VERMILION.stroke_width(2);
            chart.draw_series(DashedLineSeries::new(ends, 8, 5, style))?;
            let style = small().color(&VERMILION).pos(Pos::new(HPos::Left, VPos::Bottom));
            let text = Text::new(format!("tol {tol:e}"), (6, -3), style);
            chart.plotting_area().draw(&(EmptyElement::at(ends[0]) + text))?;
        }
        for piece in pieces(values(), low) {
            chart.draw_series(LineSeries::new(piece.iter().copied(), BLUE.stroke_width(2)))?;
            let circle = |&point| Circle::new(point, self.mark(), BLUE.filled());
            chart.draw_series(piece.iter().map(circle))?;
        }
        for (k, _) in values().enumerate().filter(|(_, value)| *value == 0.0) {
            let style = small().pos(Pos::new(HPos::Left, VPos::Bottom));
            let zero = EmptyElement::at((k as f64, low)) + Text::new("0", (8, -2), style);
            chart.plotting_area().draw(&zero)?;
        }
        Ok(())
    }

    /// The step length.
    pub(super) fn step<'a>(&self, area: &Area<'a>) -> Drawing<'a> {
        let values = || self.moments.iter().map(|moment| moment.step.unwrap_or(f64::NAN));
        let range = decades(values().chain([1.0]));
        // Full steps stand a little below the upper edge.
        let range = range.start..range.end.max(0.0) + 0.2;
        // No labels but those of whole powers.
        let labels = if range.end - range.start < 2.0 { 2 } else { 5 };
        let low = range.start;
        let mut chart =
            self.chart(area, &Axis { name: "step", range, labels, label: power }, false)?;
        for piece in pieces(values(), low) {
            chart.draw_series(LineSeries::new(piece.iter().copied(), GREEN.stroke_width(1)))?;
            let half = self.mark();
            let square = |&point| {
                EmptyElement::at(point)
                    + Rectangle::new([(-half, -half), (half, half)], WHITE.filled())
                    + Rectangle::new([(-half, -half), (half, half)], GREEN.stroke_width(2))
            };
            chart.draw_series(piece.iter().map(square))?;
        }
        Ok(())
    }

    /// Variables that came to a bound or left one.
    pub(super) fn changes<'a>(&self, area: &Area<'a>) -> Drawing<'a> {
        let most = self.moments.iter().map(|moment| moment.changes).max().unwrap_or(0);
        let range = 0.0..most.max(1) as f64 * 1.3;
        let axis = Axis { name: "active set: changes", range, labels: 4, label: whole };
        let mut chart = self.chart(area, &axis, true)?;
        if most == 0 {
            let style = small().pos(Pos::new(HPos::Center, VPos::Center));
            let middle = (self.moments.len().max(2) as f64 / 2.0 - 0.5, 0.5);
            let text = Text::new("no variable came to a bound or left one", (0, 0), style);
            chart.plotting_area().draw(&(EmptyElement::at(middle) + text))?;
        }
        for (k, moment) in self.moments.iter().enumerate().filter(|(_, m)| m.changes > 0) {
            let (k, height) = (k as f64, moment.changes as f64);
            let bar = [(k - 0.3, 0.0), (k + 0.3, height)];
            chart.draw_series([Rectangle::new(bar, BLACK.mix(0.55).filled())])?;
            if self.moments.len() <= MARKED {
                let style = small().pos(Pos::new(HPos::Center, VPos::Bottom));
                let number = Text::new(moment.changes.to_string(), (0, -2), style);
                chart.plotting_area().draw(&(EmptyElement::at((k, height)) + number))?;
            }
        }
        Ok(())
    }

    /// Where stages begin, and their names; nothing for methods without stages. The start belongs to
    /// the stage of the first step. A name that does not fit beside the one before it goes a line
    /// lower, and one that fits nowhere is left out.
    fn stages(&self) -> Vec<Label> {
        let stage = |k: usize| self.moments.get(k.max(1)).map(|moment| moment.stage);
        let range = self.horizontal();
        let pixels = f64::from(super::SIZE.0 - LEFT - LABELS - RIGHT) / (range.end - range.start);
        let (mut labels, mut ends) = (Vec::new(), [0.0; 2]);
        for k in 0..self.moments.len() {
            let Some(now) = stage(k).filter(|&now| now != Stage::Newton) else { continue };
            if k > 0 && stage(k - 1) == Some(now) {
                continue;
            }
            let (left, name) = (k as f64 * pixels, now.name());
            let (line, name) = match ends.iter().position(|end| *end <= left) {
                Some(line) => (line, name),
                None => (0, ""),
            };
            if !name.is_empty() {
                ends[line] = left + LETTER * name.len() as f64 + 12.0;
            }
            labels.push(Label { k, name, line: i32::from(line == 1) });
        }
        labels
    }
}

/// Where a stage begins.
struct Label {
    /// Its first iterate.
    k: usize,
    name: &'static str,
    /// 0 or 1.
    line: i32,
}

fn font() -> TextStyle<'static> {
    ("sans-serif", 14).into_font().color(&BLACK)
}

fn small() -> TextStyle<'static> {
    ("sans-serif", 13).into_font().color(&BLACK.mix(0.8))
}

/// Whole powers of ten around the positive finite values, as exponents: at least one decade, and room
/// below the smallest.
fn decades(values: impl Iterator<Item = f64>) -> Range<f64> {
    let positive = values.filter(|value| value.is_finite() && *value > 0.0).map(f64::log10);
    let (low, high) = positive
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    if low > high {
        return -1.0..1.0;
    }
    let low = if low - low.floor() < 0.2 { low.floor() - 1.0 } else { low.floor() };
    low..high.ceil().max(low + 1.0)
}

/// Runs of iterates whose value is a number, and its exponent of ten; `low` for 0.
fn pieces(values: impl Iterator<Item = f64>, low: f64) -> Vec<Vec<(f64, f64)>> {
    let mut pieces = vec![Vec::new()];
    for (k, value) in values.enumerate() {
        if !value.is_finite() {
            pieces.push(Vec::new());
        } else if let Some(piece) = pieces.last_mut() {
            piece.push((k as f64, if value > 0.0 { value.log10() } else { low }));
        }
    }
    pieces
}

/// Labels of whole numbers only.
fn whole(x: f64) -> String {
    if (x - x.round()).abs() < 1e-9 { format!("{}", x.round()) } else { String::new() }
}

/// `1e-6` for −6; whole exponents only.
fn power(exponent: f64) -> String {
    match whole(exponent).as_str() {
        "" => String::new(),
        "0" | "-0" => "1".to_owned(),
        "1" => "10".to_owned(),
        "-1" => "0.1".to_owned(),
        exponent => format!("1e{exponent}"),
    }
}
