//! The solver convention of AMPL, which Pyomo and others follow.
//!
//! ```text
//! mcp MODEL -AMPL [key=value …]    reads MODEL.nl, writes MODEL.sol; exit code 0 once that is written,
//!                                  so that a file of the keywords that fails is a warning
//! mcp -v                           version
//! mcp -=                           keywords
//! mcp -?                           usage
//! ```
//!
//! An old `MODEL.sol` is removed first: a caller must not take it for the answer of a call that failed.
//! `-e` before the model leaves out the echo of the assignments. Keywords also come from the
//! environment variable `mcp_options`, which `option mcp_options '…';` sets in AMPL.

use crate::error::CliError;
use crate::exit::{Outcome, solve_result};
use crate::files;
use crate::keywords::{self, Assigned, KeywordError};
use crate::output::warn;
use crate::solve::{Answer, solve};
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The first word of what `mcp` says about itself: name and version.
const VERSION: &str = concat!("mcp ", env!("CARGO_PKG_VERSION"));

const USAGE: &str = "\
usage: mcp [-e] MODEL -AMPL [key=value ...]   solve MODEL.nl and write MODEL.sol
       mcp -v | -= | -?                       version, keywords, this text
       mcp --help                             the other commands
";

/// A call by the convention.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Call {
    /// `-v`.
    Version,
    /// `-=`.
    Keywords,
    /// `-?`.
    Usage,
    /// `MODEL -AMPL`.
    Solve {
        /// The model, with or without `.nl`; `None` if it is missing.
        model: Option<PathBuf>,
        /// What stands behind `-AMPL`.
        assignments: Vec<OsString>,
        /// Whether assignments are echoed.
        echo: bool,
        /// An option before `-AMPL` that is not understood.
        unknown: Option<OsString>,
    },
}

impl Call {
    /// The call, if the command line follows the convention.
    pub(crate) fn parse(given: &[OsString]) -> Option<Self> {
        match given.first()?.to_str() {
            Some("-v") => return Some(Call::Version),
            Some("-=") => return Some(Call::Keywords),
            Some("-?") => return Some(Call::Usage),
            _ => {}
        }
        let place = given.iter().position(|word| word == "-AMPL")?;
        let (before, behind) = (&given[..place], &given[place + 1..]);
        let is_option = |word: &&OsString| word.as_encoded_bytes().starts_with(b"-");
        Some(Call::Solve {
            model: before.iter().find(|word| !is_option(word)).map(PathBuf::from),
            assignments: behind.to_vec(),
            echo: !before.iter().any(|word| word == "-e"),
            unknown: before.iter().find(|word| is_option(word) && *word != "-e").cloned(),
        })
    }
}

/// Carries out a call.
pub(crate) fn run(call: &Call, out: &mut impl Write) -> Result<Outcome, CliError> {
    match call {
        Call::Version => writeln!(out, "{VERSION} (mixed complementarity problems)")?,
        Call::Keywords => write!(out, "{}", keywords::listing())?,
        Call::Usage => write!(out, "{USAGE}")?,
        Call::Solve { unknown: Some(option), .. } => {
            return Err(
                KeywordError::Usage(format!("there is no option `{}`", option.display())).into()
            );
        }
        Call::Solve { model: None, .. } => {
            return Err(KeywordError::Usage("no model is named".to_owned()).into());
        }
        Call::Solve { model: Some(model), assignments, echo, .. } => {
            files::remove(&files::solution_path(model))?;
            let environment = std::env::var_os("mcp_options").unwrap_or_default();
            let assigned = Assigned::from(&environment.to_string_lossy(), assignments)?;
            if *echo {
                assigned.echo.iter().try_for_each(|line| writeln!(out, "{line}"))?;
            }
            write_solution(model, &assigned, out)?;
        }
    }
    Ok(Outcome::Good)
}

/// Solves the model and writes its `.sol` file, then the others.
fn write_solution(path: &Path, assigned: &Assigned, out: &mut impl Write) -> Result<(), CliError> {
    let solution_path = files::solution_path(path);
    let outputs = assigned.files.outputs().chain([solution_path.as_path()]);
    files::are_distinct([path], outputs)?;
    let model = files::model_with_warnings(path)?;
    let how = (&assigned.settings, &assigned.files, assigned.log);
    let answer = solve(&model, path, how, out)?;
    let (solution, message) = (answer.report.solution(), message(&answer));
    let result = solve_result(solution.status, answer.infeasible.is_some());
    files::write(&solution_path, |out| {
        model.write_sol(out, &solution.z, &solution.f, &message, result)
    })?;
    if let Err(error) = answer.write_files(&model, &assigned.settings, &assigned.files) {
        warn(error);
    }
    Ok(())
}

/// What AMPL prints when it has read the `.sol` file.
fn message(answer: &Answer) -> String {
    let solution = answer.report.solution();
    let stats = &solution.stats;
    let mut lines = vec![
        format!("{VERSION}: {}: {}", solution.status.name(), answer.reason()),
        format!(
            "{} iterations, {} evaluations of F, {} of J; natural residual {:.1e}, relative {:.1e}",
            stats.iterations,
            stats.residual_evaluations,
            stats.jacobian_evaluations,
            solution.certificate.natural_residual,
            solution.certificate.relative_residual,
        ),
    ];
    if !solution.is_solved() {
        lines.push(format!("advice: {}", solution.status.advice()));
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn call(line: &str) -> Option<Call> {
        let given: Vec<OsString> = line.split_whitespace().map(OsString::from).collect();
        Call::parse(&given)
    }

    #[test]
    fn only_what_follows_the_convention_is_a_call() {
        assert_eq!(call("-v"), Some(Call::Version));
        assert_eq!(call("-="), Some(Call::Keywords));
        assert_eq!(call("-?"), Some(Call::Usage));
        for line in ["", "solve a.nl", "--help", "a.nl"] {
            assert_eq!(call(line), None, "{line}");
        }
    }

    #[test]
    fn model_and_assignments_are_told_apart() {
        let solve = |model: Option<&str>, assignments: &[&str], echo, unknown: Option<&str>| {
            let assignments = assignments.iter().map(OsString::from).collect();
            let (model, unknown) = (model.map(PathBuf::from), unknown.map(OsString::from));
            Some(Call::Solve { model, assignments, echo, unknown })
        };
        assert_eq!(call("a.nl -AMPL tol=1"), solve(Some("a.nl"), &["tol=1"], true, None));
        assert_eq!(call("-e a -AMPL"), solve(Some("a"), &[], false, None));
        assert_eq!(call("-AMPL"), solve(None, &[], true, None));
        assert_eq!(call("-x a -AMPL"), solve(Some("a"), &[], true, Some("-x")));
    }
}
