//! Panels with logarithmic axes, and series with marks and dashes of their own.

use crate::accuracy::AccuracyError;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::collections::BTreeSet;

pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Okabe and Ito's colors, which also the color-blind can tell apart; the darkest first.
const COLORS: [RGBColor; 6] = [
    RGBColor(0, 0, 0),
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(150, 110, 0),
];

/// Lengths of strokes and gaps in pixels, in turn; none for an unbroken line.
const DASHES: [&[f64]; 6] =
    [&[], &[9.0, 4.0], &[2.0, 3.0], &[9.0, 3.0, 2.0, 3.0], &[5.0, 3.0], &[14.0, 4.0]];

const GREY: RGBColor = RGBColor(110, 110, 110);
const LIGHT: RGBColor = RGBColor(228, 228, 228);

/// Half the size of a mark in pixels; later styles have larger ones and are drawn before, so that
/// marks at one place can be told apart.
fn size_of(style: usize) -> i32 {
    3 + i32::try_from(style % COLORS.len()).unwrap_or(0)
}

/// A text style: size in pixels and which of its points is placed.
fn text(size: u32, horizontal: HPos, vertical: VPos) -> TextStyle<'static> {
    TextStyle::from(("sans-serif", size).into_font())
        .color(&BLACK)
        .pos(Pos::new(horizontal, vertical))
}

#[allow(clippy::needless_pass_by_value, reason = "it is given to map_err")]
pub(super) fn failed<E: std::error::Error + Send + Sync>(
    error: DrawingAreaErrorKind<E>,
) -> AccuracyError {
    AccuracyError::Drawing { reason: error.to_string() }
}

/// Points in the units of the axes, drawn in the style of a number.
pub(super) struct Series {
    pub(super) style: usize,
    pub(super) points: Vec<Point>,
    pub(super) has_line: bool,
    pub(super) has_marks: bool,
}

pub(super) struct Point {
    pub(super) x: f64,
    pub(super) y: f64,
    /// Drawn as an outline.
    pub(super) is_hollow: bool,
}

impl Point {
    pub(super) fn new(x: f64, y: f64) -> Self {
        Point { x, y, is_hollow: false }
    }
}

/// An axis: numbers are logarithms where `decades`.
#[derive(Clone)]
pub(super) struct Axis {
    pub(super) title: &'static str,
    pub(super) from: f64,
    pub(super) to: f64,
    /// Where a mark stands, with its text.
    pub(super) ticks: Vec<(f64, String)>,
}

impl Axis {
    /// Decades from `10^from` to `10^to`, a mark at every `step`-th.
    pub(super) fn decades(title: &'static str, from: i32, to: i32, step: usize) -> Self {
        let ticks = (from..=to).step_by(step).map(|k| (f64::from(k), format!("1e{k}")));
        Axis { title, from: from.into(), to: to.into(), ticks: ticks.collect() }
    }

    /// The decades that hold all numbers, given by their logarithms.
    pub(super) fn around(title: &'static str, logarithms: impl Iterator<Item = f64>) -> Self {
        let ends =
            logarithms.filter(|x| x.is_finite()).fold(None, |ends: Option<(f64, f64)>, x| {
                Some(ends.map_or((x, x), |(low, high)| (low.min(x), high.max(x))))
            });
        let (low, high) = ends.unwrap_or((0.0, 1.0));
        #[allow(clippy::cast_possible_truncation, reason = "logarithms of finite numbers")]
        let (from, to) = (low.floor() as i32, high.ceil() as i32);
        let to = to.max(from + 1);
        let step = (to - from).unsigned_abs().div_ceil(6) as usize;
        Self::decades(title, from, to, step)
    }
}

/// A rectangle with two axes.
pub(super) struct Panel {
    pub(super) title: String,
    pub(super) x: Axis,
    pub(super) y: Axis,
    /// Pixels left of and below the rectangle for the texts of the axes.
    pub(super) left: i32,
    pub(super) below: i32,
}

/// The pixels of the rectangle.
struct Frame {
    left: i32,
    right: i32,
    top: i32,
    bottom: i32,
}

impl Panel {
    pub(super) fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Panel { title: title.into(), x, y, left: 58, below: 44 }
    }

    fn frame(&self, area: &Area<'_>) -> Frame {
        let (width, height) = area.dim_in_pixel();
        #[allow(clippy::cast_possible_wrap, reason = "pictures have few pixels")]
        let (width, height) = (width as i32, height as i32);
        Frame { left: self.left, right: width - 12, top: 24, bottom: height - self.below }
    }

    /// Where a point is, in pixels, moved onto the edge if it lies outside.
    fn pixel(&self, frame: &Frame, x: f64, y: f64) -> (i32, i32) {
        let part =
            |value: f64, axis: &Axis| ((value - axis.from) / (axis.to - axis.from)).clamp(0.0, 1.0);
        let along = |from: i32, to: i32, part: f64| {
            #[allow(clippy::cast_possible_truncation, reason = "between two pixels")]
            let pixels = (f64::from(to - from) * part).round() as i32;
            from + pixels
        };
        (
            along(frame.left, frame.right, part(x, &self.x)),
            along(frame.bottom, frame.top, part(y, &self.y)),
        )
    }

    /// Draws axes and series.
    pub(super) fn draw(&self, area: &Area<'_>, series: &[Series]) -> Result<(), AccuracyError> {
        let frame = self.frame(area);
        self.draw_axes(area, &frame)?;
        for series in series.iter().rev() {
            let style = series.style;
            let inside =
                series.points.iter().filter(|point| point.x.is_finite() && point.y.is_finite());
            let points: Vec<((i32, i32), bool)> = inside
                .map(|point| (self.pixel(&frame, point.x, point.y), point.is_hollow))
                .collect();
            if series.has_line {
                let mut path: Vec<(i32, i32)> = points.iter().map(|point| point.0).collect();
                path.dedup();
                draw_line(area, style, &path)?;
            }
            if series.has_marks {
                let different: BTreeSet<((i32, i32), bool)> = points.into_iter().collect();
                for (at, is_hollow) in different {
                    draw_mark(area, style, at, is_hollow)?;
                }
            }
        }
        Ok(())
    }

    fn draw_axes(&self, area: &Area<'_>, frame: &Frame) -> Result<(), AccuracyError> {
        let &Frame { left, right, top, bottom } = frame;
        for (value, label) in &self.x.ticks {
            let (x, _) = self.pixel(frame, *value, self.y.from);
            area.draw(&PathElement::new([(x, top), (x, bottom)], LIGHT)).map_err(failed)?;
            let style = text(11, HPos::Center, VPos::Top);
            area.draw(&Text::new(label.clone(), (x, bottom + 5), style)).map_err(failed)?;
        }
        for (value, label) in &self.y.ticks {
            let (_, y) = self.pixel(frame, self.x.from, *value);
            area.draw(&PathElement::new([(left, y), (right, y)], LIGHT)).map_err(failed)?;
            let style = text(11, HPos::Right, VPos::Center);
            area.draw(&Text::new(label.clone(), (left - 5, y), style)).map_err(failed)?;
        }
        area.draw(&Rectangle::new([(left, top), (right, bottom)], GREY)).map_err(failed)?;
        let title = Text::new(self.title.clone(), (left, 4), text(13, HPos::Left, VPos::Top));
        area.draw(&title).map_err(failed)?;
        let x = (i32::midpoint(left, right), bottom + 22);
        area.draw(&Text::new(self.x.title, x, text(12, HPos::Center, VPos::Top)))
            .map_err(failed)?;
        let style = text(12, HPos::Center, VPos::Top).transform(FontTransform::Rotate270);
        let y = (2, i32::midpoint(top, bottom));
        area.draw(&Text::new(self.y.title, y, style)).map_err(failed)
    }

    /// A small text above a point.
    pub(super) fn note(
        &self,
        area: &Area<'_>,
        (x, y): (f64, f64),
        note: &str,
    ) -> Result<(), AccuracyError> {
        let (x, y) = self.pixel(&self.frame(area), x, y);
        let style = text(11, HPos::Center, VPos::Bottom);
        area.draw(&Text::new(note.to_owned(), (x, y - 8), style)).map_err(failed)
    }

    /// A line between two points without marks, for comparison.
    pub(super) fn guide(
        &self,
        area: &Area<'_>,
        from: (f64, f64),
        to: (f64, f64),
    ) -> Result<(), AccuracyError> {
        let frame = self.frame(area);
        let ends = [from, to].map(|(x, y)| self.pixel(&frame, x, y));
        area.draw(&PathElement::new(ends, GREY)).map_err(failed)
    }
}

/// Names of styles in one row, from `left` on; each name has its style's number.
pub(super) fn draw_legend(
    area: &Area<'_>,
    (left, y): (i32, i32),
    names: &[(usize, &str)],
    marks: bool,
) -> Result<(), AccuracyError> {
    let mut x = left;
    for &(style, name) in names {
        draw_line(area, style, &[(x, y), (x + 34, y)])?;
        if marks {
            draw_mark(area, style, (x + 17, y), false)?;
        }
        let label = Text::new(name.to_owned(), (x + 40, y), text(13, HPos::Left, VPos::Center));
        area.draw(&label).map_err(failed)?;
        x += 60 + 7 * i32::try_from(name.chars().count()).unwrap_or(0);
    }
    Ok(())
}

/// A line of text.
pub(super) fn draw_note(area: &Area<'_>, at: (i32, i32), note: &str) -> Result<(), AccuracyError> {
    area.draw(&Text::new(note.to_owned(), at, text(12, HPos::Left, VPos::Center))).map_err(failed)
}

/// The path in strokes and gaps.
fn draw_line(area: &Area<'_>, style: usize, path: &[(i32, i32)]) -> Result<(), AccuracyError> {
    let (dashes, stroke) =
        (DASHES[style % DASHES.len()], COLORS[style % COLORS.len()].stroke_width(2));
    if dashes.is_empty() {
        return area.draw(&PathElement::new(path.to_vec(), stroke)).map_err(failed);
    }
    let (mut k, mut left) = (0, dashes[0]);
    for two in path.windows(2) {
        let (from, to) = (two[0], two[1]);
        let (dx, dy) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
        let length = dx.hypot(dy);
        let mut done = 0.0;
        while done < length {
            let next = (done + left).min(length);
            if k % 2 == 0 {
                let at = |part: f64| {
                    #[allow(clippy::cast_possible_truncation, reason = "between two pixels")]
                    let pixel = |from: i32, d: f64| from + (d * part / length).round() as i32;
                    (pixel(from.0, dx), pixel(from.1, dy))
                };
                area.draw(&PathElement::new([at(done), at(next)], stroke)).map_err(failed)?;
            }
            left -= next - done;
            done = next;
            // Rounding may leave a stroke too short to move on.
            if left <= 1e-6 {
                k = (k + 1) % dashes.len();
                left = dashes[k];
            }
        }
    }
    Ok(())
}

/// A circle, square, triangle, diamond, triangle downwards or cross.
fn draw_mark(
    area: &Area<'_>,
    style: usize,
    (x, y): (i32, i32),
    is_hollow: bool,
) -> Result<(), AccuracyError> {
    let color = COLORS[style % COLORS.len()];
    let r = size_of(style);
    let corners = match style % 6 {
        0 => {
            let inner = if is_hollow { WHITE } else { color };
            area.draw(&Circle::new((x, y), r, inner.filled())).map_err(failed)?;
            return area.draw(&Circle::new((x, y), r, color)).map_err(failed);
        }
        1 => vec![(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)],
        2 => vec![(x - r - 1, y + r), (x + r + 1, y + r), (x, y - r - 1)],
        3 => vec![(x - r - 1, y), (x, y - r - 1), (x + r + 1, y), (x, y + r + 1)],
        4 => vec![(x - r - 1, y - r), (x + r + 1, y - r), (x, y + r + 1)],
        _ => {
            for end in [(r, r), (r, -r)] {
                let line = [(x - end.0, y - end.1), (x + end.0, y + end.1)];
                area.draw(&PathElement::new(line, color.stroke_width(2))).map_err(failed)?;
            }
            return Ok(());
        }
    };
    let inner = if is_hollow { WHITE } else { color };
    area.draw(&Polygon::new(corners.clone(), inner)).map_err(failed)?;
    let outline = [corners.clone(), vec![corners[0]]].concat();
    area.draw(&PathElement::new(outline, color)).map_err(failed)
}

/// The picture as text.
pub(super) fn picture(
    size: (u32, u32),
    draw: impl FnOnce(&Area<'_>) -> Result<(), AccuracyError>,
) -> Result<String, AccuracyError> {
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        area.fill(&WHITE).map_err(failed)?;
        draw(&area)?;
        area.present().map_err(failed)?;
    }
    Ok(svg)
}
