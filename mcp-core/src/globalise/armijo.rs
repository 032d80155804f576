//! The Armijo condition on the merit along a direction.

/// Sufficient decrease: `θ(z + t d) <= θ_ref + γ t s`, with slope `s = ∇θ·d < 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Armijo {
    /// First step `t`. Default 1; Siconos uses 2, which costs an evaluation in every search
    /// because the full step has been tried already.
    pub first_step: f64,
    /// Factor from one step to the next. Default ½.
    pub reduction: f64,
    /// Share `γ` of the slope that must be gained. Default `1e-4`.
    pub slope_share: f64,
    /// Smallest step tried; below it the search has failed. Defaults: `1e-16`, `1e-12` for
    /// [`OldFb`](crate::Method::OldFb). Siconos: `SICONOS_DPARAM_LSA_ALPHA_MIN`.
    pub smallest_step: f64,
}

impl Armijo {
    /// The defaults with the given smallest step.
    pub(crate) fn with_smallest_step(smallest_step: f64) -> Self {
        Armijo { first_step: 1.0, reduction: 0.5, slope_share: 1e-4, smallest_step }
    }

    /// Whether the trial merit is acceptable. False for NaN, and for a step so short that rounding
    /// swallows the decrease.
    #[inline]
    pub fn accepts(&self, trial: f64, reference: f64, step: f64, slope: f64) -> bool {
        trial < reference && trial <= reference + self.slope_share * step * slope
    }

    /// The steps to try, from the first to the smallest.
    pub fn steps(self) -> impl Iterator<Item = f64> {
        std::iter::successors(Some(self.first_step), move |t| Some(t * self.reduction))
            .take_while(move |&t| t >= self.smallest_step && t > 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_halve_down_to_the_smallest_and_end() {
        let armijo = Armijo { first_step: 2.0, ..Armijo::with_smallest_step(0.25) };
        assert_eq!(armijo.steps().collect::<Vec<_>>(), [2.0, 1.0, 0.5, 0.25]);
        // In Siconos a smallest step of 0 makes the search endless.
        let endless = Armijo::with_smallest_step(0.0);
        assert!(endless.steps().count() < 1100, "the steps underflow to 0 and end");
    }

    #[test]
    fn a_nan_merit_is_never_accepted() {
        let armijo = Armijo::with_smallest_step(1e-16);
        assert!(!armijo.accepts(f64::NAN, 1.0, 1.0, -1.0));
        assert!(armijo.accepts(0.5, 1.0, 1.0, -1.0));
    }
}
