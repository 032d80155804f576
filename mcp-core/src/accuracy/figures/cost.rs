//! Figure 1: error against cost, by tolerance and method.

use super::canvas::{Axis, Panel, Point, Series, draw_legend, draw_note, picture};
use super::{ERRORS, decimal};
use crate::accuracy::{AccuracyError, Case, Run, Setting};
use crate::solver::Method;

/// Panels in a row.
const COLUMNS: usize = 4;
/// Pixels of a panel.
const PANEL: (u32, u32) = (290, 250);
/// Pixels above the panels.
const HEAD: u32 = 54;

/// What a solve costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Scalar operations, which depend on no clock.
    Operations,
    /// Seconds, the median of the timed runs.
    Seconds,
}

impl Measure {
    fn name(self) -> &'static str {
        match self {
            Measure::Operations => "scalar operations",
            Measure::Seconds => "seconds",
        }
    }

    fn of(self, run: &Run) -> Option<f64> {
        match self {
            Measure::Operations => Some(run.cost.operations?.max(1) as f64),
            Measure::Seconds => Some(run.timing?.median),
        }
    }
}

/// One panel for each case: the true error over the cost, a line for each method, a mark for each
/// tolerance; hollow where the solve did not end in a solution.
///
/// # Errors
/// [`AccuracyError::Drawing`].
pub fn cost(cases: &[(&Case, &[Run])], measure: Measure) -> Result<String, AccuracyError> {
    let columns = cases.len().clamp(2, COLUMNS);
    let rows = cases.len().div_ceil(columns);
    #[allow(clippy::cast_possible_truncation, reason = "a page of panels")]
    let size = (PANEL.0 * columns as u32, HEAD + PANEL.1 * rows as u32);
    picture(size, |area| {
        let names: Vec<(usize, &str)> =
            Method::ALL.iter().enumerate().map(|(k, method)| (k, method.name())).collect();
        draw_legend(area, (12, 16), &names, true)?;
        let note = format!(
            "true error over {}; a mark for each tolerance, 1e-2 to 1e-14; hollow: not solved; \
             below 1e-18 at the edge",
            measure.name()
        );
        draw_note(area, (12, 40), &note)?;
        let (_, below) = area.split_vertically(HEAD);
        for ((case, runs), part) in cases.iter().zip(below.split_evenly((rows, columns))) {
            let series: Vec<Series> = Method::ALL
                .iter()
                .enumerate()
                .map(|(style, &method)| Series {
                    style,
                    points: points(runs, method, measure),
                    has_line: true,
                    has_marks: true,
                })
                .collect();
            let costs = series.iter().flat_map(|series| series.points.iter().map(|point| point.x));
            let x = Axis::around(measure.name(), costs);
            let y = Axis::decades("true error", ERRORS.0, ERRORS.1, 4);
            Panel::new(format!("{} (n = {})", case.name, case.n()), x, y).draw(&part, &series)?;
        }
        Ok(())
    })
}

/// The runs of a method that differ from the default in nothing else.
fn points(runs: &[Run], method: Method, measure: Measure) -> Vec<Point> {
    let of_method = |run: &&Run| {
        let tolerance = run.setting.tolerance;
        run.setting == Setting { tolerance, method, ..Setting::default() }
    };
    let point = |run: &Run| {
        let (x, y) = (measure.of(run)?.log10(), decimal(run.error));
        Some(Point { x, y, is_hollow: !run.is_solved() })
    };
    runs.iter().filter(of_method).filter_map(point).collect()
}
