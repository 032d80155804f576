//! [`Line`]: one model of a batch.

use crate::files;
use mcp_cli::nl::NlModel;
use mcp_core::{AdProblem, Options, Problem, Solver, Status};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::Instant;

/// What became of one model.
#[derive(Clone, Debug)]
pub(super) struct Line {
    /// Its file, as given.
    pub(super) file: String,
    /// How it went, or why not.
    pub(super) result: Result<Solved, Failure>,
    /// Time for reading, preparing and solving.
    pub(super) seconds: f64,
}

/// How a solve went.
#[derive(Clone, Debug)]
pub(super) struct Solved {
    pub(super) n: usize,
    pub(super) nonzeros: usize,
    pub(super) status: Status,
    /// Natural residual, in the units of the model.
    pub(super) residual: f64,
    pub(super) relative_residual: f64,
    pub(super) iterations: usize,
    pub(super) residual_evaluations: usize,
    pub(super) jacobian_evaluations: usize,
}

/// Why a model was not solved at all.
#[derive(Clone, Debug)]
pub(super) struct Failure {
    /// In a word: `unreadable`, `refused` or `crashed`.
    pub(super) kind: &'static str,
    /// In a sentence.
    pub(super) message: String,
}

impl Line {
    /// Reads and solves the model.
    pub(super) fn of(path: &Path, options: &Options) -> Self {
        let began = Instant::now();
        // A defect that one model shows is no reason to lose the answers of the others.
        let result = catch_unwind(AssertUnwindSafe(|| solved(path, options)));
        let crashed = |_| {
            let message = "the solver panicked: please report this model".to_owned();
            Err(Failure { kind: "crashed", message })
        };
        Line {
            file: path.display().to_string(),
            result: result.unwrap_or_else(crashed),
            seconds: began.elapsed().as_secs_f64(),
        }
    }

    /// Of a folder that gives no model.
    pub(super) fn unreadable(path: &Path, message: String) -> Self {
        let result = Err(Failure { kind: "unreadable", message });
        Line { file: path.display().to_string(), result, seconds: 0.0 }
    }

    /// Whether it was solved.
    pub(super) fn is_solved(&self) -> bool {
        self.result.as_ref().is_ok_and(|solved| solved.status == Status::Solved)
    }

    /// Status or kind of failure.
    pub(super) fn status(&self) -> &'static str {
        match &self.result {
            Ok(solved) => solved.status.name(),
            Err(failure) => failure.kind,
        }
    }
}

fn solved(path: &Path, options: &Options) -> Result<Solved, Failure> {
    let refused =
        |error: mcp_core::ModelError| Failure { kind: "refused", message: error.to_string() };
    let model = NlModel::read(path)
        .map_err(|error| Failure { kind: "unreadable", message: files::reason(path, &error) })?;
    let mut problem = AdProblem::new(&model).map_err(refused)?;
    let mut solver = Solver::new(options.clone()).map_err(refused)?;
    let solution = solver.solve(&mut problem).map_err(refused)?;
    Ok(Solved {
        n: solution.z.len(),
        nonzeros: problem.pattern().nnz(),
        status: solution.status,
        residual: solution.certificate.natural_residual,
        relative_residual: solution.certificate.relative_residual,
        iterations: solution.stats.iterations,
        residual_evaluations: solution.stats.residual_evaluations,
        jacobian_evaluations: solution.stats.jacobian_evaluations,
    })
}
