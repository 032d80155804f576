//! [`Robust`]: what can be set for [`Method::Robust`](crate::Method::Robust).

use crate::error::ModelError;
use crate::globalise::Stall;

/// Budgets of the stages of [`Method::Robust`](crate::Method::Robust), in counts. **0 switches a
/// stage off.** No clock decides anything, so the same problem takes the same path every time.
///
/// ```
/// use mcp_core::Options;
/// let options = Options::default().with(|o| {
///     o.robust.smoothing = 0; // without smoothing
///     o.robust.jacobians = 5000; // more patience
/// });
/// assert_eq!(options.validate(), Ok(()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Robust {
    /// Evaluations of `J` in the whole solve. Default 1200.
    pub jacobians: usize,
    /// Whether equations and variables are scaled by powers of two, so that the path does not
    /// depend on binary units. Default true.
    pub equilibrate: bool,
    /// Steps of projected Newton at the start. Default 20.
    pub crash: usize,
    /// Steps of semismooth Newton. Default 200.
    pub semismooth: usize,
    /// Damping factors tried for a Levenberg–Marquardt step. Default 5.
    pub levenberg_marquardt: usize,
    /// Min-map steps that polish a point which is nearly a solution. Default 6.
    pub tail: usize,
    /// Linearisations solved by pivoting right after the crash, up to 500 variables. Default 15.
    pub josephy_first: usize,
    /// Linearisations solved by pivoting after the semismooth steps, from the start. Default 40.
    pub josephy: usize,
    /// Variables up to which the linearisations are solved by pivoting. Default 2000.
    pub josephy_size: usize,
    /// Steps of Newton's method alone, as short as it takes. Default 80.
    pub backtracking: usize,
    /// Steps of smoothing continuation. Default 70.
    pub smoothing: usize,
    /// Steps on the penalised equations. Default 120.
    pub penalised: usize,
    /// Weight `λ` of the Fischer–Burmeister function there, between 0 and 1. Default 0.9.
    pub penalty_weight: f64,
    /// Steps of semismooth Newton from the middle, the upper and the lower corner of the two-sided
    /// boxes. Default 60.
    pub boxes: usize,
    /// How often the scales may be measured again where they have changed. Default 12.
    pub rescale: usize,
    /// Steps of semismooth Newton in scales that give the sizes of the variables at the start more
    /// weight. Default 40.
    pub sized: usize,
    /// Proximal subproblems. Default 25.
    pub proximal: usize,
    /// Perturbed starts. Default 6.
    pub starts: usize,
    /// Merits the non-monotone search remembers; after as many steps without progress it is
    /// monotone. Default 8.
    pub memory: usize,
    /// When a Newton stage gives up. Default: 40 steps without the merit falling by 30 %.
    pub stall: Stall,
}

impl Default for Robust {
    fn default() -> Self {
        Robust {
            jacobians: 1200,
            equilibrate: true,
            crash: 20,
            semismooth: 200,
            levenberg_marquardt: 5,
            tail: 6,
            josephy_first: 15,
            josephy: 40,
            josephy_size: 2000,
            backtracking: 80,
            smoothing: 70,
            penalised: 120,
            penalty_weight: 0.9,
            boxes: 60,
            rescale: 12,
            sized: 40,
            proximal: 25,
            starts: 6,
            memory: 8,
            stall: Stall { iterations: 40, factor: 0.7 },
        }
    }
}

impl Robust {
    /// Checks every field.
    pub(crate) fn validate(&self) -> Result<(), ModelError> {
        let open_unit = |x: f64| x > 0.0 && x < 1.0;
        let fault = |option, value: String, rule| Err(ModelError::Option { option, value, rule });
        if !open_unit(self.penalty_weight) {
            let value = self.penalty_weight.to_string();
            return fault("robust.penalty_weight", value, "must lie between 0 and 1");
        }
        if !open_unit(self.stall.factor) {
            let value = self.stall.factor.to_string();
            return fault("robust.stall.factor", value, "must lie between 0 and 1");
        }
        if !(1..=10_000).contains(&self.memory) {
            let value = self.memory.to_string();
            return fault("robust.memory", value, "must lie between 1 and 10000");
        }
        if self.stall.iterations == 0 {
            return fault("robust.stall.iterations", "0".to_owned(), "must be at least 1");
        }
        Ok(())
    }
}
