//! Figure 4: performance and data profiles.

use super::canvas::{Area, Axis, Panel, Point, Series, draw_legend, draw_note, picture};
use crate::accuracy::{AccuracyError, Steps, data_profile, performance_profile};
use crate::solver::Method;

/// Pixels.
const SIZE: (u32, u32) = (1000, 470);
/// Pixels above the panels.
const HEAD: u32 = 54;
/// `log₂` of the largest ratio shown.
const WIDEST: f64 = 6.0;

/// The performance and the data profile of methods, given with the cost of every problem they solve.
///
/// # Errors
/// [`AccuracyError::Drawing`].
pub fn profiles(costs: &[(Method, Vec<Option<f64>>)]) -> Result<String, AccuracyError> {
    let all: Vec<Vec<Option<f64>>> = costs.iter().map(|(_, costs)| costs.clone()).collect();
    picture(SIZE, |area| {
        let names: Vec<(usize, &str)> =
            costs.iter().enumerate().map(|(k, (method, _))| (k, method.name())).collect();
        draw_legend(area, (12, 16), &names, false)?;
        let failures: Vec<String> = costs
            .iter()
            .map(|(method, costs)| {
                format!("{method} {}", costs.iter().filter(|cost| cost.is_none()).count())
            })
            .collect();
        let number = all.first().map_or(0, Vec::len);
        let note = format!("{number} problems; not solved: {}", failures.join(", "));
        draw_note(area, (12, 40), &note)?;
        let (_, below) = area.split_vertically(HEAD);
        let (left, right) = below.split_horizontally(SIZE.0 / 2);
        let ticks = (0..=6).map(|k| (f64::from(k), (1 << k).to_string()));
        let x = Axis {
            title: "evaluations of F and J, relative to the best method",
            from: 0.0,
            to: WIDEST,
            ticks: ticks.collect(),
        };
        draw(&left, "performance profile", x, &performance_profile(&all))?;
        let x = Axis::decades("evaluations of F and J", 0, 4, 1);
        let decimal =
            |steps: Steps| steps.into_iter().map(|(x, share)| (x.log10(), share)).collect();
        let data: Vec<Steps> = data_profile(&all).into_iter().map(decimal).collect();
        draw(&right, "data profile", x, &data)
    })
}

fn draw(area: &Area<'_>, title: &str, x: Axis, profiles: &[Steps]) -> Result<(), AccuracyError> {
    let ticks = (0..=5).map(|k| (f64::from(k) / 5.0, format!("{} %", 20 * k)));
    let y = Axis { title: "share of problems solved", from: 0.0, to: 1.0, ticks: ticks.collect() };
    let widest = x.to;
    let series = profiles.iter().enumerate().map(|(style, steps)| {
        let (mut points, mut share) = (vec![Point::new(0.0, 0.0)], 0.0);
        for &(x, next) in steps.iter().filter(|step| step.0 <= widest) {
            points.push(Point::new(x, share));
            points.push(Point::new(x, next));
            share = next;
        }
        points.push(Point::new(widest, share));
        Series { style, points, has_line: true, has_marks: false }
    });
    Panel::new(title, x, y).draw(area, &series.collect::<Vec<_>>())
}
