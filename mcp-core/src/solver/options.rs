//! [`Options`]: what can be set, with the defaults of each method.

use super::robust::Robust;
use crate::error::ModelError;
use crate::globalise::{Armijo, Nonmonotone, Stall};
use crate::linalg::Linear;
use std::fmt;
use std::str::FromStr;
use std::time::Duration;

/// Which algorithm solves the problem.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Method {
    /// Equilibration, projected Newton, semismooth Newton, and a cascade of other methods behind
    /// them: [`robust`](super::robust). The default.
    #[default]
    Robust,
    /// Newton on the Fischer–Burmeister equations with line search ([FP03](crate#references) VFBLSA, p. 834).
    /// Siconos: `SICONOS_MCP_NEWTON_FB_FBLSA`, id 700.
    NewtonFb,
    /// Newton direction of the min map, Fischer–Burmeister merit ([FP03](crate#references) minFBLSA, p. 855).
    /// Siconos: `SICONOS_MCP_NEWTON_MIN_FBLSA`, id 701.
    NewtonMinFb,
    /// The older semismooth Newton method ([KK98](crate#references) Algorithm 4.1). Siconos:
    /// `SICONOS_MCP_OLD_FB`, id 710.
    OldFb,
    /// Complementary pivoting, for affine problems only: [`pivot`](super::pivot).
    Lemke,
}

impl Method {
    /// All methods, the default first.
    pub const ALL: [Method; 5] =
        [Method::Robust, Method::NewtonFb, Method::NewtonMinFb, Method::OldFb, Method::Lemke];

    /// The three methods of the Siconos page on mixed complementarity problems.
    pub const CLASSICAL: [Method; 3] = [Method::NewtonFb, Method::NewtonMinFb, Method::OldFb];

    /// Name in commands and reports: `robust`, `newton_fb`, `newton_min_fb`, `old_fb`, `lemke`.
    pub fn name(self) -> &'static str {
        match self {
            Method::Robust => "robust",
            Method::NewtonFb => "newton_fb",
            Method::NewtonMinFb => "newton_min_fb",
            Method::OldFb => "old_fb",
            Method::Lemke => "lemke",
        }
    }

    /// Id of the method in Siconos, if it is one of its three.
    pub fn siconos_id(self) -> Option<u32> {
        match self {
            Method::NewtonFb => Some(700),
            Method::NewtonMinFb => Some(701),
            Method::OldFb => Some(710),
            Method::Robust | Method::Lemke => None,
        }
    }

    /// The method with this Siconos id.
    ///
    /// # Errors
    /// [`UnknownMethod`] for any other number.
    pub fn from_siconos_id(id: u32) -> Result<Self, UnknownMethod> {
        let found = Self::ALL.into_iter().find(|method| method.siconos_id() == Some(id));
        found.ok_or_else(|| UnknownMethod { given: id.to_string() })
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A method name or id that does not exist.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "there is no method `{given}`: choose robust, newton_fb (700), newton_min_fb (701), \
     old_fb (710), lemke"
)]
pub struct UnknownMethod {
    /// What was asked for.
    pub given: String,
}

impl FromStr for Method {
    type Err = UnknownMethod;

    /// A name in any case, with or without `_` and `-`, or a Siconos id.
    fn from_str(given: &str) -> Result<Self, UnknownMethod> {
        if let Ok(id) = given.parse() {
            return Self::from_siconos_id(id);
        }
        let plain = |name: &str| name.to_ascii_lowercase().replace(['-', '_'], "");
        let found = Self::ALL.into_iter().find(|method| plain(method.name()) == plain(given));
        found.ok_or_else(|| UnknownMethod { given: given.to_owned() })
    }
}

/// What a method compares with [`Options::tol`] to end its loop. It only ends the loop: whether the
/// point is a solution is decided by the [`Certificate`](crate::Certificate).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Criterion {
    /// `‖Φ(z)‖₂`. Siconos criterion 0, `RESIDU`.
    FbNorm,
    /// `‖∇θ(z)‖₂`, at the current point. Siconos criterion 1, `STATIONARITY`.
    Stationarity,
    /// The larger of the two. Siconos criterion 2.
    FbNormAndStationarity,
    /// The natural residual `max |mid(z−l, F, z−u)|` of the certificate. Default. Siconos
    /// criterion 3, `USER_ROUTINE`, its documented default.
    #[default]
    NaturalResidual,
}

impl Criterion {
    /// Whether the criterion looks at `∇θ`, which needs `J` at the point.
    pub(crate) fn needs_gradient(self) -> bool {
        matches!(self, Criterion::Stationarity | Criterion::FbNormAndStationarity)
    }
}

/// When a Newton direction counts as one of descent: `∇θ·d <= −ρ ‖d‖ᵖ`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Descent {
    /// `ρ`, default `1e-8`.
    pub rho: f64,
    /// `p`, default 2.1.
    pub p: f64,
}

impl Default for Descent {
    fn default() -> Self {
        Descent { rho: 1e-8, p: 2.1 }
    }
}

/// Merits a non-monotone search may remember; the memory is allocated at once.
const MOST_MEMORY: usize = 10_000;

/// Everything that can be set for a solve. [`Options::new`] gives the defaults of a method.
///
/// # Which tolerance, and what it costs
///
/// Measured against solutions known to 22 digits and more (`docs/accuracy.md`; regression values):
///
/// - **Keep the default.** `Robust` polishes whatever it returns: with any tolerance from `1e-2` to
///   `1e-8` it takes the same evaluations and ends within `1e-12` of a regular solution, mostly
///   within `1e-15`. `1e-12` costs at most one evaluation of `J` more and is the better choice where
///   the answer is differentiated or compared.
/// - **With the classical methods keep `1e-10`.** From `1e-4` to `1e-12` they take one to two more
///   evaluations of `J` at a regular solution; at `1e-4` the point can still be off by 3 %.
/// - **No absolute `tol` below the rounding errors of `F`**, `1e-16` times its largest term: it cannot
///   be met, and the line search fails after up to ten times the evaluations. `1e-14` is too small for
///   an economy in billions, `1e-12` for equations in units of `1e-4`.
/// - **At a singular solution every digit costs three iterations**, and the natural residual is the
///   square of the error: `1e-15` at an error of `3e-8`. `tol_relative`, which divides by the
///   derivatives, follows the error; `tol` does not.
/// - A variable far smaller than the others of its equations is known no better than the tolerance
///   relative to those. Where it matters, write its logarithm or its unit into the model.
///
/// ```
/// use mcp_core::{Method, Options};
/// let mut options = Options::new(Method::NewtonMinFb);
/// options.tol = Some(1e-12);
/// options.armijo.first_step = 2.0;
/// let same = Options::new(Method::NewtonMinFb).with(|o| {
///     o.tol = Some(1e-12);
///     o.armijo.first_step = 2.0;
/// });
/// assert_eq!(options, same);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// The algorithm.
    pub method: Method,
    /// Absolute tolerance: the [`criterion`](Self::criterion) ends the loop below it, and the
    /// natural residual of the certificate must not exceed it. Defaults: `1e-10` for the two Newton
    /// methods of Siconos, `1e-7` for `OldFb`, `None` for `Robust` and `Lemke`: only the relative
    /// tolerance. Siconos: `SICONOS_DPARAM_TOL`.
    pub tol: Option<f64>,
    /// Tolerance for the row-relative residual of the certificate, which does not depend on units.
    /// Default `1e-8`.
    pub tol_relative: f64,
    /// Iterations before giving up. Defaults: 1000, 10 for `OldFb`, 100 000 for `Robust`, whose own
    /// limits come first, and for the exchanges of `Lemke`. Siconos: `SICONOS_IPARAM_MAX_ITER`.
    pub max_iterations: usize,
    /// Time before giving up, checked between iterations. Default none. The only clock.
    pub time_limit: Option<Duration>,
    /// What ends the loop. Siconos: `SICONOS_IPARAM_STOPPING_CRITERION`.
    pub criterion: Criterion,
    /// Line search along the direction.
    pub armijo: Armijo,
    /// Reference value of the line search. Default off. Siconos:
    /// `SICONOS_IPARAM_LSA_NONMONOTONE_LS`.
    pub nonmonotone: Nonmonotone,
    /// Merits a non-monotone search remembers, 1 to 10000. Default 8. Siconos:
    /// `SICONOS_IPARAM_LSA_NONMONOTONE_LS_M`.
    pub memory: usize,
    /// Newton steps of the two Newton methods are taken without a search if they multiply the merit
    /// by at most this `σ`. Default 0.9.
    pub full_step: f64,
    /// Which Newton directions are used.
    pub descent: Descent,
    /// When to give up for lack of progress; `None`: never. Default: 100 iterations without
    /// the merit falling by a tenth.
    pub stall: Option<Stall>,
    /// Stages and budgets of [`Method::Robust`]; the fields from `criterion` to `stall` are for the
    /// classical methods.
    pub robust: Robust,
    /// The linear solver. Default: chosen by size and density.
    pub linear: Linear,
}

impl Options {
    /// The defaults of a method.
    pub fn new(method: Method) -> Self {
        let (tol, max_iterations, smallest_step) = match method {
            Method::Robust | Method::Lemke => (None, 100_000, 1e-16),
            Method::NewtonFb | Method::NewtonMinFb => (Some(1e-10), 1000, 1e-16),
            Method::OldFb => (Some(1e-7), 10, 1e-12),
        };
        Options {
            method,
            tol,
            tol_relative: 1e-8,
            max_iterations,
            time_limit: None,
            criterion: Criterion::default(),
            armijo: Armijo::with_smallest_step(smallest_step),
            nonmonotone: Nonmonotone::default(),
            memory: 8,
            full_step: 0.9,
            descent: Descent::default(),
            stall: Some(Stall::default()),
            robust: Robust::default(),
            linear: Linear::default(),
        }
    }

    /// These options after `edit`.
    #[must_use]
    pub fn with(mut self, edit: impl FnOnce(&mut Self)) -> Self {
        edit(&mut self);
        self
    }

    /// Checks every field.
    ///
    /// # Errors
    /// [`ModelError::Option`] names the first field out of range.
    pub fn validate(&self) -> Result<(), ModelError> {
        let open_unit = |x: f64| x > 0.0 && x < 1.0;
        let positive = |x: f64| x > 0.0 && x.is_finite();
        let Armijo { first_step, reduction, slope_share, smallest_step } = self.armijo;
        let tol = self.tol.unwrap_or(1.0);
        let stall = self.stall.unwrap_or_default();
        let rules = [
            ("tol", tol, positive(tol), "must be a positive number"),
            (
                "tol_relative",
                self.tol_relative,
                positive(self.tol_relative),
                "must be a positive number",
            ),
            ("armijo.first_step", first_step, positive(first_step), "must be a positive number"),
            ("armijo.reduction", reduction, open_unit(reduction), "must lie between 0 and 1"),
            ("armijo.slope_share", slope_share, open_unit(slope_share), "must lie between 0 and 1"),
            (
                "armijo.smallest_step",
                smallest_step,
                smallest_step > 0.0 && smallest_step <= first_step,
                "must be positive and at most armijo.first_step",
            ),
            ("full_step", self.full_step, open_unit(self.full_step), "must lie between 0 and 1"),
            (
                "descent.rho",
                self.descent.rho,
                positive(self.descent.rho),
                "must be a positive number",
            ),
            (
                "descent.p",
                self.descent.p,
                self.descent.p > 2.0 && self.descent.p.is_finite(),
                "must be a number above 2",
            ),
            ("stall.factor", stall.factor, open_unit(stall.factor), "must lie between 0 and 1"),
        ];
        for (option, value, holds, rule) in rules {
            if !holds {
                return Err(ModelError::Option { option, value: value.to_string(), rule });
            }
        }
        let counts = [
            ("memory", self.memory, 1..=MOST_MEMORY, "must lie between 1 and 10000"),
            ("stall.iterations", stall.iterations, 1..=usize::MAX, "must be at least 1"),
        ];
        for (option, value, range, rule) in counts {
            if !range.contains(&value) {
                return Err(ModelError::Option { option, value: value.to_string(), rule });
            }
        }
        self.robust.validate()
    }
}

impl Default for Options {
    fn default() -> Self {
        Options::new(Method::default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_are_found_by_name_and_siconos_id() {
        for method in Method::ALL {
            assert_eq!(method.name().parse(), Ok(method));
            let id = method.siconos_id();
            assert_eq!(id.is_some(), Method::CLASSICAL.contains(&method));
            if let Some(id) = id {
                assert_eq!(id.to_string().parse(), Ok(method));
                assert_eq!(Method::from_siconos_id(id), Ok(method));
            }
        }
        assert_eq!("Newton-Min-FB".parse(), Ok(Method::NewtonMinFb));
        assert_eq!("NewtonFb".parse(), Ok(Method::NewtonFb));
        assert_eq!(
            "path".parse::<Method>().unwrap_err().to_string(),
            "there is no method `path`: choose robust, newton_fb (700), newton_min_fb (701), \
             old_fb (710), lemke"
        );
        assert!(Method::from_siconos_id(702).is_err());
    }

    #[test]
    fn defaults_are_those_of_the_manual() {
        let newton = Options::new(Method::NewtonFb);
        assert_eq!((newton.tol, newton.max_iterations), (Some(1e-10), 1000));
        assert_eq!(
            (newton.armijo.smallest_step, newton.criterion),
            (1e-16, Criterion::NaturalResidual)
        );
        let old = Options::new(Method::OldFb);
        assert_eq!(
            (old.tol, old.max_iterations, old.armijo.smallest_step),
            (Some(1e-7), 10, 1e-12)
        );
    }

    #[test]
    fn every_option_out_of_range_is_named() {
        type Edit = fn(&mut Options);
        let edits: [(&str, Edit); 15] = [
            ("tol", |o| o.tol = Some(f64::NAN)),
            ("tol", |o| o.tol = Some(0.0)),
            ("tol_relative", |o| o.tol_relative = -1.0),
            ("armijo.first_step", |o| o.armijo.first_step = f64::INFINITY),
            ("armijo.reduction", |o| o.armijo.reduction = 1.0),
            ("armijo.slope_share", |o| o.armijo.slope_share = 0.0),
            // In Siconos alpha_min = 0 and a NaN merit never end.
            ("armijo.smallest_step", |o| o.armijo.smallest_step = 0.0),
            ("armijo.smallest_step", |o| o.armijo.smallest_step = 3.0),
            ("full_step", |o| o.full_step = 1.5),
            ("descent.rho", |o| o.descent.rho = f64::NAN),
            ("descent.p", |o| o.descent.p = 2.0),
            ("memory", |o| o.memory = 0),
            ("memory", |o| o.memory = usize::MAX),
            ("stall.factor", |o| o.stall = Some(Stall { factor: 1.0, ..Stall::default() })),
            ("stall.iterations", |o| o.stall = Some(Stall { iterations: 0, ..Stall::default() })),
        ];
        for (name, edit) in edits {
            match Options::default().with(edit).validate() {
                Err(ModelError::Option { option, .. }) => assert_eq!(option, name),
                other => panic!("{name}: {other:?}"),
            }
        }
        assert_eq!(Options::default().validate(), Ok(()));
    }
}
