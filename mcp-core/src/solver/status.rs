//! [`Status`]: how a solve ended.

use std::fmt;

/// How a solve ended. Not converging is a result, not an error; `Display` says what it means and
/// what to try.
///
/// | status | PATH | JuMP | Siconos `info` |
/// | --- | --- | --- | --- |
/// | `Solved` | `MCP_Solved` | `LOCALLY_SOLVED` | 0 |
/// | `SolvedAsymptotically` | | `ALMOST_LOCALLY_SOLVED` | 0 |
/// | `StationaryPoint` | `MCP_NoProgress` | `SLOW_PROGRESS` | 1 |
/// | `SingularSystem` | (basis singular) | `NUMERICAL_ERROR` | 2, overwritten by 1 |
/// | `LineSearchFailed` | `MCP_NoProgress` | `SLOW_PROGRESS` | 1 |
/// | `Stalled` | `MCP_NoProgress` | `SLOW_PROGRESS` | 1 |
/// | `IterationLimit` | `MCP_MajorIterationLimit` | `ITERATION_LIMIT` | 1 |
/// | `TimeLimit` | `MCP_TimeLimit` | `TIME_LIMIT` | |
/// | `DomainError` | `MCP_DomainError` | `NUMERICAL_ERROR` | 0 |
/// | `Interrupted` | `MCP_UserInterrupt` | `INTERRUPTED` | |
/// | `Diverged` | `MCP_NoProgress` | `NORM_LIMIT` | |
/// | `Ray` | | `INFEASIBLE_OR_UNBOUNDED` | |
/// | `NotAffine` | | `INVALID_MODEL` | |
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum Status {
    /// The certificate accepts the point: in the box, `F` and `J` finite, residuals below the
    /// tolerances.
    Solved,
    /// The residuals are below the tolerances, but an equation has lost all its derivatives or a
    /// variable has run away: a solution at infinity looks like this.
    SolvedAsymptotically,
    /// The gradient of the merit vanishes at a point that is no solution.
    StationaryPoint,
    /// The Newton system is singular and the gradient of the merit gives no direction either.
    SingularSystem,
    /// No step along the direction reduces the merit.
    LineSearchFailed,
    /// The merit has hardly fallen for many iterations: [`Stall`](crate::Stall).
    Stalled,
    /// The iteration limit was reached.
    IterationLimit,
    /// The time limit was reached.
    TimeLimit,
    /// `F` or `J` is not finite, or `F` too large to square, at the start or on every step that was
    /// tried.
    DomainError,
    /// The monitor asked to stop.
    Interrupted,
    /// Variables grow without bound while the residual falls or stays.
    Diverged,
    /// The path of [`Method::Lemke`](crate::Method::Lemke) ended on a ray.
    Ray,
    /// [`Method::Lemke`](crate::Method::Lemke) was asked to solve a problem that is not affine.
    NotAffine,
}

impl Status {
    /// All statuses.
    pub const ALL: [Status; 13] = [
        Status::Solved,
        Status::SolvedAsymptotically,
        Status::StationaryPoint,
        Status::SingularSystem,
        Status::LineSearchFailed,
        Status::Stalled,
        Status::IterationLimit,
        Status::TimeLimit,
        Status::DomainError,
        Status::Interrupted,
        Status::Diverged,
        Status::Ray,
        Status::NotAffine,
    ];

    /// Name for tables and files, such as `solved` or `stationary_point`.
    pub fn name(self) -> &'static str {
        match self {
            Status::Solved => "solved",
            Status::SolvedAsymptotically => "solved_asymptotically",
            Status::StationaryPoint => "stationary_point",
            Status::SingularSystem => "singular_system",
            Status::LineSearchFailed => "line_search_failed",
            Status::Stalled => "stalled",
            Status::IterationLimit => "iteration_limit",
            Status::TimeLimit => "time_limit",
            Status::DomainError => "domain_error",
            Status::Interrupted => "interrupted",
            Status::Diverged => "diverged",
            Status::Ray => "ray",
            Status::NotAffine => "not_affine",
        }
    }

    /// What happened, in one sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Status::Solved => "the certificate accepts the point as a solution",
            Status::SolvedAsymptotically => {
                "the residual is small, but an equation has lost all its derivatives or a variable \
                 has run away, as at a solution at infinity"
            }
            Status::StationaryPoint => {
                "the gradient of the merit function vanishes at a point that is no solution"
            }
            Status::SingularSystem => {
                "the Newton system is singular and the merit function has no descent direction"
            }
            Status::LineSearchFailed => "no step along the direction reduces the merit function",
            Status::Stalled => "the merit function has hardly fallen for many iterations",
            Status::IterationLimit => "the iteration limit was reached",
            Status::TimeLimit => "the time limit was reached",
            Status::DomainError => {
                "F or its Jacobian is not finite, or F too large to square, at the start or on every \
                 step that was tried"
            }
            Status::Interrupted => "the monitor asked to stop",
            Status::Diverged => "variables grow without bound, and no solution was met on the way",
            Status::Ray => {
                "pivoting ended on a ray: if the matrix is copositive-plus, such as positive \
                 semidefinite, the problem has no solution"
            }
            Status::NotAffine => {
                "the Jacobian differs between two points, and Lemke's method takes affine problems only"
            }
        }
    }

    /// What to try next; empty where there is nothing to try.
    pub fn advice(self) -> &'static str {
        match self {
            Status::Solved | Status::Interrupted => "",
            Status::SolvedAsymptotically => {
                "a `Report` names the equation and the variable: bound the variable, \
                 or check whether the model has a solution at a finite point"
            }
            Status::StationaryPoint => {
                "try another start or another method, and look at the worst equations in a \
                 `Report`: the problem may have no solution, or none nearby"
            }
            Status::SingularSystem => {
                "look for equations that repeat each other, variables no equation depends on (all \
                 prices free to move together: fix one), or an equation whose derivatives all \
                 vanish here; or start elsewhere"
            }
            Status::LineSearchFailed => {
                "if the residual is near rounding, loosen the tolerance; otherwise try another \
                 start, another method or better units, and look at the worst equations in a \
                 `Report`: the problem may have no solution"
            }
            Status::Stalled => {
                "try another start, another method or better units, and look at the worst \
                 equations in a `Report`: the problem may have no solution; if the residual was \
                 still falling, raise the stall limit"
            }
            Status::IterationLimit => {
                "allow more iterations (of `Robust`: `robust.jacobians`) if the residual was still \
                 falling, otherwise try another start or another method: the problem may have no \
                 solution"
            }
            Status::TimeLimit => "allow more time or start closer to the solution",
            Status::DomainError => {
                "a `Report` names the equation and the values: bound its variables \
                 away from where it is undefined, or start inside its domain"
            }
            Status::Diverged => {
                "bound the variables that a `Report` names, or check the signs of the equations \
                 they are in: the problem may have no solution, or only one at infinity"
            }
            Status::Ray => {
                "a `Report` names the variables that can grow together: look for a missing bound or \
                 a demand no supply can meet; for other matrices try Robust"
            }
            Status::NotAffine => "use Robust, which linearises",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.name(), self.meaning())?;
        if self.advice().is_empty() { Ok(()) } else { write!(f, "; {}", self.advice()) }
    }
}
