//! Figure 3: where digits are lost.

use super::canvas::{Area, Axis, Panel, Point, Series, draw_legend, draw_note, picture};
use super::{ERRORS, decimal};
use crate::accuracy::phi::{Form, floor, phi_errors};
use crate::accuracy::{AccuracyError, Case, Run, Setting};

/// Pixels.
const SIZE: (u32, u32) = (1180, 560);
/// Pixels above the panels.
const HEAD: u32 = 54;
/// The larger argument of `φ` in the first panel.
const LARGER: f64 = 1e3;

/// Three panels: the relative error of `φ(1000, b)` and its derivative over `b` in both forms; the
/// smallest error that Newton's method reaches on each case by either form and by the min map, and
/// what `Robust` returns with its default tolerance, with and without tail; and, for all runs that
/// ended in a solution, the error over the natural residual.
///
/// # Errors
/// As [`floor`], and [`AccuracyError::Drawing`].
pub fn digits(cases: &[(&Case, &[Run])]) -> Result<String, AccuracyError> {
    let mut floors = Vec::new();
    for (case, runs) in cases {
        let mut reached = Vec::new();
        for form in Form::ALL {
            reached.push(floor(case, form)?);
        }
        let of = |setting: Setting| {
            let run = runs.iter().find(|run| run.setting == setting);
            run.filter(|run| run.is_solved()).map(|run| run.error)
        };
        reached.push(of(Setting::default()));
        reached.push(of(Setting { tail: false, ..Setting::default() }));
        floors.push(reached);
    }
    picture(SIZE, |area| {
        let names = ["naive", "stable", "min map", "robust", "robust, no tail", "other methods"];
        let names: Vec<(usize, &str)> = names.into_iter().enumerate().collect();
        draw_legend(area, (12, 16), &names, true)?;
        draw_note(
            area,
            (12, 40),
            "left: hollow is the derivative by b; middle: smallest error reached; right: every run that ended as solved, by robust or others",
        )?;
        let (_, below) = area.split_vertically(HEAD);
        let (left, rest) = below.split_horizontally(360);
        let (middle, right) = rest.split_horizontally(460);
        phi_panel(&left)?;
        floor_panel(&middle, cases, &floors)?;
        residual_panel(&right, cases)
    })
}

fn phi_panel(area: &Area<'_>) -> Result<(), AccuracyError> {
    let x = Axis::decades("b", -12, 12, 4);
    let y = Axis::decades("relative error", ERRORS.0, ERRORS.1, 2);
    let mut series = Vec::new();
    for (style, form) in [Form::Naive, Form::Stable].into_iter().enumerate() {
        for which in [0, 1] {
            let point = |k: i32| {
                // Beside the powers of ten, where errors may vanish by chance.
                let b = 1.37 * 10_f64.powi(k);
                let y = decimal(phi_errors(form, LARGER, b)[which]);
                Point { x: b.log10(), y, is_hollow: which == 1 }
            };
            let points = (-12..12).map(point).collect();
            series.push(Series { style, points, has_line: true, has_marks: true });
        }
    }
    Panel::new("φ(1000, b)", x, y).draw(area, &series)
}

fn floor_panel(
    area: &Area<'_>,
    cases: &[(&Case, &[Run])],
    floors: &[Vec<Option<f64>>],
) -> Result<(), AccuracyError> {
    let rows = cases.len() as f64;
    let row = |k: usize| rows - k as f64 - 0.5;
    let ticks = cases.iter().enumerate().map(|(k, (case, _))| (row(k), case.name.clone()));
    let y = Axis { title: "", from: 0.0, to: rows, ticks: ticks.collect() };
    let x = Axis::decades("true error", ERRORS.0, ERRORS.1, 4);
    let mut panel = Panel::new("what each form leaves of a solution", x, y);
    panel.left = 150;
    let series: Vec<Series> = (0..5)
        .map(|style| {
            let reached = floors.iter().enumerate().filter_map(|(k, of)| Some((k, of[style]?)));
            // A little apart, so that equal ones can be seen.
            let shift = 0.15 * (2.0 - style as f64);
            let points = reached.map(|(k, error)| Point::new(decimal(error), row(k) + shift));
            Series { style, points: points.collect(), has_line: false, has_marks: true }
        })
        .collect();
    panel.draw(area, &series)
}

fn residual_panel(area: &Area<'_>, cases: &[(&Case, &[Run])]) -> Result<(), AccuracyError> {
    let x = Axis::decades("natural residual", ERRORS.0, 0, 4);
    let y = Axis::decades("true error", ERRORS.0, ERRORS.1, 2);
    let panel = Panel::new("a small residual is not a small error", x, y);
    let runs = || cases.iter().flat_map(|(_, runs)| runs.iter()).filter(|run| run.is_solved());
    let series = [true, false].map(|by_robust| {
        let of = |run: &&Run| (run.setting.method == crate::Method::Robust) == by_robust;
        let at = |run: &Run| Point::new(decimal(run.residual), decimal(run.error));
        let style = if by_robust { 3 } else { 5 };
        Series {
            style,
            points: runs().filter(of).map(at).collect(),
            has_line: false,
            has_marks: true,
        }
    });
    let [low, high] = [ERRORS.0, 0].map(f64::from);
    panel.guide(area, (low, low), (high, high))?;
    panel.guide(area, (low, low / 2.0), (high, high))?;
    panel.draw(area, &series)?;
    panel.note(area, (-4.5, -9.5), "error = residual")?;
    panel.note(area, (-12.5, -4.8), "error = √residual")
}
