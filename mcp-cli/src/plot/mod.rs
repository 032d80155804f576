//! The picture of `--plot`: how a solve went.
//!
//! Three panels over the iterations: the natural residual, the step length, both logarithmic, and the
//! number of variables that came to a bound or left one. Shapes differ, not only colours: circles,
//! squares, bars.

mod panel;

use crate::history::Moment;
use panel::Panel;
use plotters::prelude::*;

/// Size of the picture in pixels.
const SIZE: (u32, u32) = (900, 700);

/// Heights of the title and of the panels; the last takes the rest.
const TITLE: u32 = 36;
const RESIDUAL: u32 = 330;
const STEP: u32 = 140;

/// Why a picture could not be drawn.
#[derive(Debug, thiserror::Error)]
pub(crate) enum PlotError {
    /// Nothing was iterated.
    #[error("there is nothing to plot: no iterate has a finite residual")]
    Nothing,
    /// The drawing library.
    #[error("the plot cannot be drawn: {reason}")]
    Drawing {
        /// What it says.
        reason: String,
    },
}

/// Draws a solve as SVG, with a line at the absolute tolerance if there is one.
///
/// # Errors
/// [`PlotError::Nothing`], [`PlotError::Drawing`].
pub(crate) fn svg(moments: &[Moment], title: &str, tol: Option<f64>) -> Result<String, PlotError> {
    if !moments.iter().any(|moment| moment.residual.is_finite()) {
        return Err(PlotError::Nothing);
    }
    let mut text = String::new();
    draw(moments, title, tol, SVGBackend::with_string(&mut text, SIZE))
        .map_err(|error| PlotError::Drawing { reason: error.to_string() })?;
    Ok(text)
}

type Drawing<'a> = Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

fn draw<'a>(
    moments: &[Moment],
    title: &str,
    tol: Option<f64>,
    backend: SVGBackend<'a>,
) -> Drawing<'a> {
    let area = backend.into_drawing_area();
    area.fill(&WHITE)?;
    let (head, body) = area.split_vertically(TITLE);
    let font = ("sans-serif", 18).into_font().color(&BLACK);
    head.draw_text(title, &font, (20, 14))?;
    let (residual, rest) = body.split_vertically(RESIDUAL);
    let (step, changes) = rest.split_vertically(STEP);

    let panel = Panel::new(moments);
    panel.residual(&residual, tol)?;
    panel.step(&step)?;
    panel.changes(&changes)?;
    area.present()
}

#[cfg(test)]
mod tests {
    use super::*;
    use mcp_core::Stage;

    fn moments(residuals: &[f64]) -> Vec<Moment> {
        let moment = |(k, &residual): (usize, &f64)| Moment {
            residual,
            step: (k > 0).then_some(1.0),
            stage: Stage::Newton,
            changes: k,
        };
        residuals.iter().enumerate().map(moment).collect()
    }

    #[test]
    fn a_picture_has_three_panels_and_the_tolerance() {
        let text = svg(&moments(&[6.0, 0.3, 1e-9]), "small: solved", Some(1e-6)).unwrap();
        for label in
            ["small: solved", "natural residual", "step", "active set: changes", "tol 1e-6"]
        {
            assert!(text.contains(label), "{label}");
        }
    }

    #[test]
    fn zeros_and_what_is_not_finite_are_drawn() {
        for residuals in [&[0.0][..], &[1.0, 0.0], &[f64::NAN, 1e300, 1e-300], &[1e-5; 500]] {
            svg(&moments(residuals), "hard", None).unwrap();
        }
    }

    #[test]
    fn nothing_finite_is_nothing_to_plot() {
        assert!(matches!(svg(&[], "empty", None), Err(PlotError::Nothing)));
        assert!(matches!(svg(&moments(&[f64::NAN]), "nan", None), Err(PlotError::Nothing)));
    }
}
