//! What a caller learns without reading text: exit codes, and AMPL's solve-result codes.
//!
//! | exit code | `mcp solve`, `check`, `info`, `batch` |
//! | --- | --- |
//! | 0 | solved; no fault; stated; every model solved |
//! | 1 | not solved; a fault; never; some model not solved |
//! | 2 | the command line cannot be understood |
//! | 3 | a file cannot be read, understood or written |
//!
//! In the AMPL convention 0 means that the `.sol` file is written, whatever it says; the others are
//! the same. Pyomo takes every other code for a crash.

use mcp_core::Status;
use std::process::ExitCode;

/// How a command ended, if not in an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// As asked for.
    Good,
    /// Done, but not with the answer that was hoped for.
    Bad,
}

impl Outcome {
    /// [`Good`](Outcome::Good) if it is.
    pub(crate) fn of(is_good: bool) -> Self {
        if is_good { Outcome::Good } else { Outcome::Bad }
    }
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Good => ExitCode::SUCCESS,
            Outcome::Bad => ExitCode::from(1),
        }
    }
}

/// The command line cannot be understood.
pub(crate) const USAGE: u8 = 2;
/// A file cannot be read, understood or written.
pub(crate) const FILE: u8 = 3;

/// AMPL's `solve_result_num`: the last line of a `.sol` file.
///
/// | code | AMPL's `solve_result` | when |
/// | --- | --- | --- |
/// | 0 | `solved` | `Solved`, nothing else |
/// | 200 | `infeasible` | not solved, and [proved](mcp_core::infeasible) to have no solution |
/// | 400 | `limit` | `IterationLimit`, `TimeLimit`, `Interrupted` |
/// | 500 | `failure` | all others, `SolvedAsymptotically` included |
///
/// AMPL's `solved?`, 100, would say that a point is a solution with a doubt; Pyomo loads it as
/// optimal. A point that the certificate does not accept is a failure.
pub(crate) fn solve_result(status: Status, is_infeasible: bool) -> u16 {
    match status {
        Status::Solved => 0,
        _ if is_infeasible => 200,
        Status::IterationLimit | Status::TimeLimit | Status::Interrupted => 400,
        _ => 500,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_solved_is_zero() {
        for status in Status::ALL {
            let code = solve_result(status, false);
            assert_eq!(code == 0, status == Status::Solved, "{status:?}");
            assert!([0, 400, 500].contains(&code));
        }
        assert_eq!(solve_result(Status::TimeLimit, false), 400);
        assert_eq!(solve_result(Status::Ray, false), 500);
    }

    #[test]
    fn infeasible_is_what_is_proved_and_not_solved() {
        assert_eq!(solve_result(Status::Stalled, true), 200);
        assert_eq!(solve_result(Status::TimeLimit, true), 200);
        assert_eq!(solve_result(Status::Solved, true), 0);
    }
}
