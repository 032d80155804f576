//! The four figures of a study, as SVG (feature `plots`): logarithmic, and readable without colour
//! by marks and dashes.

mod canvas;
mod cost;
mod derivatives;
mod digits;
mod profiles;

pub use cost::{Measure, cost};
pub use derivatives::derivatives;
pub use digits::digits;
pub use profiles::profiles;

/// The exponents between which errors are drawn; others stand on the edge.
const ERRORS: (i32, i32) = (-18, 2);

/// `log₁₀`, and the lower edge for 0.
fn decimal(error: f64) -> f64 {
    if error == 0.0 { f64::from(ERRORS.0) } else { error.log10() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Method;
    use crate::accuracy::{Budget, Run, Setting, derivatives as jacobians, problems};

    /// Every text of a picture, and that nothing of it is no number.
    fn texts(svg: &str) -> String {
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        svg.lines().filter(|line| !line.contains('<')).collect::<Vec<_>>().join("|")
    }

    #[test]
    fn the_figure_of_costs_names_cases_and_methods() {
        let case = problems::kojima_shindo(true).unwrap();
        let runs: Vec<Run> = Setting::all(&case, &[1e-2, 1e-8])
            .into_iter()
            .map(|setting| Run::new(&case, setting, None).unwrap())
            .collect();
        let svg = texts(&cost(&[(&case, &runs[..])], Measure::Operations).unwrap());
        for text in ["kojima-shindo", "robust", "newton_fb", "old_fb", "1e-14"] {
            assert!(svg.contains(text), "{text} is missing in {svg}");
        }
        let digits = texts(&digits(&[(&case, &runs[..])]).unwrap());
        for text in ["naive", "stable", "min map", "no tail"] {
            assert!(digits.contains(text), "{text} is missing in {digits}");
        }
    }

    #[test]
    fn the_figure_of_derivatives_names_sources_and_sizes() {
        let case = problems::chain(12).unwrap();
        let runs = jacobians(&case, Budget::default()).unwrap();
        let svg = texts(&derivatives(&[("chain", &runs[..])]).unwrap());
        for text in ["jet", "one-sided", "central, best step", "12"] {
            assert!(svg.contains(text), "{text} is missing in {svg}");
        }
    }

    #[test]
    fn the_figure_of_profiles_names_the_methods() {
        let costs =
            [(Method::Robust, vec![Some(3.0), Some(9.0)]), (Method::OldFb, vec![Some(4.0), None])];
        let svg = texts(&profiles(&costs).unwrap());
        assert!(svg.contains("robust") && svg.contains("old_fb"), "{svg}");
    }
}
