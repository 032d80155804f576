//! Figure 2: the error of a Jacobian against its time, by source and size.

use super::canvas::{Axis, Panel, Point, Series, draw_legend, draw_note, picture};
use super::{ERRORS, decimal};
use crate::accuracy::{AccuracyError, DerivativeRun, Source};

/// Pixels.
const SIZE: (u32, u32) = (1000, 450);
/// Pixels above the panels.
const HEAD: u32 = 54;

/// One panel for each family of problems, given by name and runs of all sizes: a line for each source
/// through its sizes, from the smallest to the largest.
///
/// # Errors
/// [`AccuracyError::Drawing`].
pub fn derivatives(families: &[(&str, &[DerivativeRun])]) -> Result<String, AccuracyError> {
    picture(SIZE, |area| {
        let names: Vec<(usize, &str)> =
            Source::ALL.iter().enumerate().map(|(k, source)| (k, source.name())).collect();
        draw_legend(area, (12, 16), &names, true)?;
        draw_note(
            area,
            (12, 40),
            "error of J, relative to the largest entry of each row, over the shortest time of one J; numbers: n",
        )?;
        let (_, below) = area.split_vertically(HEAD);
        let parts = below.split_evenly((1, families.len().max(1)));
        for ((name, runs), part) in families.iter().zip(parts) {
            let x = Axis::around(
                "seconds for one J",
                runs.iter().map(|run| run.jacobian.minimum.log10()),
            );
            let y = Axis::decades("error of J", ERRORS.0, -2, 2);
            let panel = Panel::new(*name, x, y);
            let mut series = Vec::new();
            for (style, &source) in Source::ALL.iter().enumerate() {
                let of_source = || runs.iter().filter(|run| run.source == source);
                let at = |run: &DerivativeRun| (run.jacobian.minimum.log10(), decimal(run.error));
                let points = of_source().map(at).map(|(x, y)| Point::new(x, y)).collect();
                series.push(Series { style, points, has_line: true, has_marks: true });
                if matches!(source, Source::Jet | Source::OneSided) {
                    for run in of_source() {
                        panel.note(&part, at(run), &run.n.to_string())?;
                    }
                }
            }
            panel.draw(&part, &series)?;
        }
        Ok(())
    })
}
