//! Equilibrium of a weak acid in water.

use super::super::{AccuracyError, Case};
use crate::mcp_fn;
use crate::scalar::{Real, Scalar};

/// Concentrations of H⁺, OH⁻, A⁻ and HA [mol/l] in acetic acid of 0.001 mol/l at 25 °C: mass action
/// in logarithms, amount of acid, charge.
#[mcp_fn(lower = 1e-30, start = [1e-4, 1e-10, 1e-4, 1e-3])]
fn weak_acid_laws<D: Scalar>([h, oh, a, ha]: [Real<D>; 4]) -> [Real<D>; 4] {
    let (water, acid) = (1e-14_f64, 1.75e-5_f64);
    [
        h.ln() + oh.ln() - water.ln(),
        h.ln() + a.ln() - ha.ln() - acid.ln(),
        a + ha - 1e-3,
        h - a - oh,
    ]
}

/// Acetic acid of 0.001 mol/l: about 1.2e-4 mol/l of H⁺ and 8e-11 of OH⁻. A step of differences
/// that suits the one is far too long for the other, `ln` of which it differentiates.
///
/// # Errors
/// As [`Case::refined`].
pub fn weak_acid() -> Result<Case, AccuracyError> {
    Case::new("weak acid", WeakAcidLaws::new()?).refined()
}
