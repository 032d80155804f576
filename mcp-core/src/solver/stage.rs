//! [`Stage`]: the parts of [`Method::Robust`](crate::Method::Robust), and what became of them.

use std::fmt;

/// A stage of [`Method::Robust`](crate::Method::Robust), or the only one of another method.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Stage {
    /// A classical method: it has no stages.
    #[default]
    Newton,
    /// Projected Newton on the natural map.
    Crash,
    /// Semismooth Newton on the Fischer–Burmeister equations.
    Semismooth,
    /// Josephy–Newton: the linearised problem solved by pivoting.
    Josephy,
    /// Newton on the Fischer–Burmeister equations alone, with steps as short as it takes.
    Backtracking,
    /// Smoothing continuation.
    Smoothing,
    /// Semismooth Newton on the penalised Fischer–Burmeister equations.
    Penalised,
    /// Crash and semismooth Newton from the middle and the corners of the two-sided boxes.
    Boxes,
    /// New scales at the best point, and the Newton stages again.
    Rescaled,
    /// Full Newton steps to where the scales are others, and the crash there.
    Leap,
    /// Crash and semismooth Newton in scales by the sizes of the variables at the start.
    Sized,
    /// Proximal point iteration.
    Proximal,
    /// Crash, semismooth Newton and smoothing from perturbed starts.
    Starts,
    /// Complementary pivoting: [`Method::Lemke`](crate::Method::Lemke).
    Pivoting,
}

impl Stage {
    /// Name for tables: `newton`, `crash`, `semismooth`, …
    pub fn name(self) -> &'static str {
        match self {
            Stage::Newton => "newton",
            Stage::Crash => "crash",
            Stage::Semismooth => "semismooth",
            Stage::Josephy => "josephy",
            Stage::Backtracking => "backtracking",
            Stage::Smoothing => "smoothing",
            Stage::Penalised => "penalised",
            Stage::Boxes => "boxes",
            Stage::Rescaled => "rescaled",
            Stage::Leap => "leap",
            Stage::Sized => "sized",
            Stage::Proximal => "proximal",
            Stage::Starts => "starts",
            Stage::Pivoting => "pivoting",
        }
    }
}

impl fmt::Display for Stage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// How a stage ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum StageEnd {
    /// With the solve: at a solution, or at a limit of the whole solve.
    Ended,
    /// No step was accepted.
    NoStep,
    /// The merit hardly fell any more.
    Stalled,
    /// Its budget of iterations was spent.
    Budget,
    /// The scales of the Jacobian had drifted away.
    Drifted,
    /// The pivoting ended on a ray, also with a regularised matrix.
    Ray,
    /// A variable ran away.
    Diverged,
    /// `F` or `J` was not finite where the stage would have begun.
    NotFinite,
    /// It was not tried: the problem is too large for it.
    Skipped,
}

impl StageEnd {
    /// In a word or two, for tables.
    pub fn name(self) -> &'static str {
        match self {
            StageEnd::Ended => "ended",
            StageEnd::NoStep => "no step",
            StageEnd::Stalled => "stalled",
            StageEnd::Budget => "budget spent",
            StageEnd::Drifted => "scales drifted",
            StageEnd::Ray => "ray",
            StageEnd::Diverged => "diverged",
            StageEnd::NotFinite => "not finite",
            StageEnd::Skipped => "skipped",
        }
    }
}

impl fmt::Display for StageEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A stage that ran: what it cost, and how it ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct StageRecord {
    /// Which.
    pub stage: Stage,
    /// Steps it took.
    pub iterations: usize,
    /// Evaluations of `F` alone.
    pub residual_evaluations: usize,
    /// Evaluations of `J`.
    pub jacobian_evaluations: usize,
    /// How it ended.
    pub end: StageEnd,
}

impl fmt::Display for StageRecord {
    /// Such as `crash 5` or `semismooth 34 (stalled)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.end {
            StageEnd::Ended => write!(f, "{} {}", self.stage, self.iterations),
            end => write!(f, "{} {} ({end})", self.stage, self.iterations),
        }
    }
}
