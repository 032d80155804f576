//! [`Setting`] and [`Run`]: a solve with one thing changed, and what it reached and cost.

use super::AccuracyError;
use super::case::{Arithmetic, Case};
use super::cost::Cost;
use super::source::Source;
use super::timing::{Budget, Timing};
use crate::solver::{Method, Options, Solver, Status};

/// Tolerances of a study: 1e-2, 1e-4, …, 1e-14.
pub const TOLERANCES: [f64; 7] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14];

/// Share by which warm starts are off the solution, up and down in turn.
const WARM: f64 = 1e-2;

/// How a solve is made. The default is that of [`Options`], with exact derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// [`Options::tol_relative`], and [`Options::tol`] for the classical methods. Default 1e-8.
    pub tolerance: f64,
    /// The method.
    pub method: Method,
    /// Where derivatives come from.
    pub source: Source,
    /// The arithmetic of `F`, with derivatives by jets.
    pub arithmetic: Arithmetic,
    /// Whether `Robust` equilibrates. Default true.
    pub scaling: bool,
    /// Whether `Robust` polishes with min-map steps. Default true.
    pub tail: bool,
    /// Whether the solve starts 1 % off the solution. Default false.
    pub warm: bool,
}

impl Default for Setting {
    fn default() -> Self {
        Setting {
            tolerance: 1e-8,
            method: Method::default(),
            source: Source::default(),
            arithmetic: Arithmetic::default(),
            scaling: true,
            tail: true,
            warm: false,
        }
    }
}

impl Setting {
    /// What differs from the default beside the tolerance, such as `newton_fb` or `central, warm`;
    /// `robust` if nothing does.
    pub fn name(&self) -> String {
        let default = Setting::default();
        let words = [
            (self.method != default.method, self.method.name()),
            (self.source != default.source, self.source.name()),
            (self.arithmetic != default.arithmetic, "F in double-double"),
            (!self.scaling, "no scaling"),
            (!self.tail, "no tail"),
            (self.warm, "warm"),
        ];
        let words: Vec<&str> = words.iter().filter(|word| word.0).map(|word| word.1).collect();
        if words.is_empty() { default.method.name().to_owned() } else { words.join(", ") }
    }

    /// The settings of a study of `case`, each at every one of the tolerances: all methods that apply;
    /// all sources with `Robust`; and, with `Robust`, `F` in double-double, without scaling, without
    /// tail, warm.
    pub fn all(case: &Case, tolerances: &[f64]) -> Vec<Setting> {
        let default = Setting::default();
        let methods = Method::ALL.into_iter().filter(|&m| m != Method::Lemke || case.is_affine);
        let sources = Source::ALL
            .into_iter()
            .filter(|&s| s != default.source && (s != Source::ByHand || case.has_by_hand()));
        let mut all: Vec<Setting> = methods.map(|method| Setting { method, ..default }).collect();
        all.extend(sources.map(|source| Setting { source, ..default }));
        all.extend([
            Setting { arithmetic: Arithmetic::DoubleDouble, ..default },
            Setting { scaling: false, ..default },
            Setting { tail: false, ..default },
            Setting { warm: true, ..default },
        ]);
        let at = |setting: Setting| {
            tolerances.iter().map(move |&tolerance| Setting { tolerance, ..setting })
        };
        all.into_iter().flat_map(at).collect()
    }

    /// The options of this setting. `OldFb` gets 300 iterations instead of its 10, which would end
    /// solves before their tolerance does.
    pub fn options(&self) -> Options {
        let is_classical = Method::CLASSICAL.contains(&self.method);
        Options::new(self.method).with(|o| {
            o.tol = is_classical.then_some(self.tolerance);
            o.tol_relative = self.tolerance;
            o.robust.equilibrate = self.scaling;
            if is_classical {
                o.max_iterations = 300;
            }
            if !self.tail {
                o.robust.tail = 0;
            }
        })
    }
}

/// A solve: what it reached and what it cost.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// How it was made.
    pub setting: Setting,
    /// How it ended.
    pub status: Status,
    /// The true error: [`Case::error`].
    pub error: f64,
    /// Natural residual, in the units of the model.
    pub residual: f64,
    /// Relative residual, which the tolerance is compared with.
    pub relative_residual: f64,
    /// In counts.
    pub cost: Cost,
    /// In seconds, if asked for.
    pub timing: Option<Timing>,
}

impl Run {
    /// Whether the certificate accepts the point at the tolerance of the setting.
    pub fn is_solved(&self) -> bool {
        self.status == Status::Solved
    }

    /// Solves `case` in this setting; `budget` says how often for the clock.
    ///
    /// # Errors
    /// As [`Case::problem`] and [`Case::error`].
    pub fn new(
        case: &Case,
        setting: Setting,
        budget: Option<Budget>,
    ) -> Result<Self, AccuracyError> {
        let mut problem = match setting.arithmetic {
            Arithmetic::F64 => case.problem(setting.source)?,
            Arithmetic::DoubleDouble => case.in_arithmetic(setting.arithmetic)?,
        };
        let start = if setting.warm { warm(case)? } else { case.start.clone() };
        let mut solver = Solver::new(setting.options())?;
        let solution = solver.solve_from(&mut problem, &start)?;
        let run = Run {
            setting,
            status: solution.status,
            error: case.error(&solution.z)?,
            residual: solution.certificate.natural_residual,
            relative_residual: solution.certificate.relative_residual,
            cost: Cost::of(solution.stats, problem.pattern(), case.operations(setting.source)?),
            timing: None,
        };
        let timing = budget.map(|budget| {
            Timing::measure(budget, || {
                // It has been solved from there before: there is no error to handle.
                let _ = solver.solve_from(&mut problem, &start);
            })
        });
        Ok(Run { timing, ..run })
    }
}

/// The solution, each variable 1 % off, up and down in turn.
fn warm(case: &Case) -> Result<Vec<f64>, AccuracyError> {
    let moved =
        |(j, z): (usize, f64)| z * if j.is_multiple_of(2) { 1.0 + WARM } else { 1.0 - WARM };
    Ok(case.solution()?.into_iter().enumerate().map(moved).collect())
}

#[cfg(test)]
#[path = "study_tests.rs"]
mod tests;
