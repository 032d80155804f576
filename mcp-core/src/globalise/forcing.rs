//! [`Forcing`]: how accurately an iterative linear solver has to solve a Newton system.

/// Largest and smallest residual asked for, relative to the right-hand side.
const COARSEST: f64 = 1e-2;
const FINEST: f64 = 1e-8;
/// `γ` of choice 2.
const SHARE: f64 = 0.9;

/// `η_k = γ θ_k / θ_(k−1)` with `γ = 0.9`, between 10⁻⁸ and 10⁻²: choice 2 of [EW96](crate#references) with
/// `α = 2`, for `θ = ½‖Φ‖²`. As long as Newton's steps gain little, so does accuracy.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Forcing {
    merit: Option<f64>,
}

impl Forcing {
    /// `η` of the step from an iterate with this merit.
    pub(crate) fn next(&mut self, merit: f64) -> f64 {
        let before = self.merit.replace(merit);
        before.map_or(COARSEST, |before| (SHARE * merit / before).clamp(FINEST, COARSEST))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn accuracy_follows_the_decrease_of_the_merit() {
        let mut forcing = Forcing::default();
        assert_eq!(forcing.next(8.0), COARSEST);
        assert_eq!(forcing.next(4.0), COARSEST);
        assert_eq!(forcing.next(4e-4), SHARE * 1e-4);
        assert_eq!(forcing.next(4e-20), FINEST);
    }
}
