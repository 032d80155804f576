//! The command line of `mcp solve`, `check`, `info` and `batch`.

use clap::builder::{PathBufValueParser, PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Args, Parser, Subcommand, ValueEnum};
use mcp_core::{Method, Options, UnknownMethod};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Absolute tolerance of the natural residual unless told otherwise, in the units of the model.
pub(crate) const TOL: f64 = 1e-6;

const EXAMPLES: &str = "\
Examples:
  mcp solve transport.nl                        solve, and show the solution by name
  mcp check transport.nl                        why does it not solve?
  mcp batch models/ --jobs 4 --csv summary.csv  a line for every model of a folder
  mcp transport.nl -AMPL                        what AMPL and Pyomo call; writes transport.sol

AMPL writes MODEL.nl and the names MODEL.col, MODEL.row with
  option auxfiles rc; write gMODEL;
Pyomo with
  model.write('MODEL.nl', io_options={'symbolic_solver_labels': True})

In AMPL:   option solver mcp; option mcp_options 'tol=1e-9 time_limit=60'; solve;
In Pyomo:  SolverFactory('asl:mcp').solve(model, options={'tol': 1e-9})
Their keywords: mcp -=

Exit codes: 0 solved, or nothing to report; 1 not solved, or something found;
2 the command line cannot be understood; 3 a file cannot be read or written.";

/// Mixed complementarity problems from AMPL .nl files.
///
/// Find z with l <= z <= u such that every F is >= 0 where its variable is at its lower bound, <= 0
/// where it is at its upper bound, and 0 in between: economic equilibria, games, contact, optimality
/// conditions. Every answer is judged by code apart from the solvers.
#[derive(Debug, Parser)]
#[command(name = "mcp", version, after_help = EXAMPLES)]
pub(crate) struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What to do with a model.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Solve a model and report the solution by name
    Solve(Solve),
    /// Look at a model without solving it: structure, pairs, start, derivatives, scaling
    Check(Check),
    /// State sizes, kinds of bounds, nonzeros, operations
    Info(Info),
    /// Solve many models, a line for each
    Batch(Batch),
}

const SOLVE_EXAMPLES: &str = "\
Examples:
  mcp solve transport.nl
  mcp solve transport.nl --log final --csv solution.csv --plot path.svg
  mcp solve transport.nl --method newton_min_fb --tol 1e-10 --time-limit 60
  mcp solve transport.nl --json first.json; mcp solve changed.nl --start first.json

A point is a solution if it lies in the bounds, every equation holds to 1e-8 relative to its own
terms, and the natural residual is at most --tol. Exit code 0 means solved, nothing else does.";

/// Arguments of `mcp solve`.
#[derive(Debug, Args)]
#[command(after_help = SOLVE_EXAMPLES)]
pub(crate) struct Solve {
    /// The model: an AMPL .nl file, text or binary; names from .col and .row beside it
    pub(crate) model: PathBuf,
    /// How it is solved.
    #[command(flatten)]
    pub(crate) settings: Settings,
    /// What else is read and written.
    #[command(flatten)]
    pub(crate) files: Files,
    /// What is printed: model statement, iterations and report; the report alone; nothing
    #[arg(long, value_enum, default_value_t = Log::Iterations, value_name = "WHAT")]
    pub(crate) log: Log,
}

/// How a model is solved.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Solving")]
pub(crate) struct Settings {
    /// The algorithm; `lemke` is for affine models only
    #[arg(long, value_parser = MethodParser, default_value = "robust", value_name = "NAME")]
    pub(crate) method: Method,
    /// Largest natural residual of a solution, in the units of the model; `none`: only relative
    #[arg(long, value_parser = tolerance, default_value = "1e-6", value_name = "T", allow_negative_numbers = true)]
    pub(crate) tol: Tolerance,
    /// Iterations before giving up [default: by method, 100000 for robust]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub(crate) max_iterations: Option<usize>,
    /// Seconds before giving up, checked between iterations [default: none]
    #[arg(long, value_parser = seconds, value_name = "S", allow_negative_numbers = true)]
    pub(crate) time_limit: Option<Duration>,
}

/// An absolute tolerance, or none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tolerance(pub(crate) Option<f64>);

impl Default for Tolerance {
    fn default() -> Self {
        Tolerance(Some(TOL))
    }
}

impl Files {
    /// All that are written.
    pub(crate) fn outputs(&self) -> impl Iterator<Item = &Path> {
        [&self.json, &self.csv, &self.plot].into_iter().flatten().map(PathBuf::as_path)
    }
}

impl Settings {
    /// The options of the core.
    pub(crate) fn options(&self) -> Options {
        Options::new(self.method).with(|options| {
            options.tol = self.tol.0;
            options.time_limit = self.time_limit;
            if let Some(limit) = self.max_iterations {
                options.max_iterations = limit;
            }
        })
    }
}

/// Files beside the model.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Files")]
pub(crate) struct Files {
    /// Start from levels by name: CSV with name,level, or what --json or --csv wrote
    #[arg(long, value_name = "FILE")]
    pub(crate) start: Option<PathBuf>,
    /// Write status, point, residuals, costs and all variables as one JSON object
    #[arg(long, value_name = "FILE", value_parser = output_parser())]
    pub(crate) json: Option<PathBuf>,
    /// Write all variables as CSV, every digit
    #[arg(long, value_name = "FILE", value_parser = output_parser())]
    pub(crate) csv: Option<PathBuf>,
    /// Draw residual, steps and changes of the active set over the iterations
    #[arg(long, value_name = "FILE.svg", value_parser = output_parser())]
    pub(crate) plot: Option<PathBuf>,
}

/// What `mcp solve` prints.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Log {
    /// Model statement, iteration table, report
    #[default]
    Iterations,
    /// The report alone
    Final,
    /// Nothing
    None,
}

/// Arguments of `mcp check`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  mcp check transport.nl\n  mcp check large.nl --derivatives")]
pub(crate) struct Check {
    /// The model: an AMPL .nl file, text or binary
    pub(crate) model: PathBuf,
    /// Check at these levels instead of the model's start: as in mcp solve
    #[arg(long, value_name = "FILE")]
    pub(crate) start: Option<PathBuf>,
    /// Check derivatives of large models too, at the cost of 24 n evaluations of F
    #[arg(long)]
    pub(crate) derivatives: bool,
}

/// Arguments of `mcp info`.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  mcp info transport.nl")]
pub(crate) struct Info {
    /// The model: an AMPL .nl file, text or binary
    pub(crate) model: PathBuf,
}

const BATCH_EXAMPLES: &str = "\
Examples:
  mcp batch models/*.nl
  mcp batch models/ --jobs 4 --time-limit 30 --csv summary.csv

A file that cannot be read, or a folder without a model, is a line like any other, and the rest
goes on. Exit code 0 means that every model is solved.";

/// Arguments of `mcp batch`.
#[derive(Debug, Args)]
#[command(after_help = BATCH_EXAMPLES)]
pub(crate) struct Batch {
    /// Models, and folders of which every .nl file is taken
    #[arg(required = true, value_name = "FILES")]
    pub(crate) models: Vec<PathBuf>,
    /// Models solved at the same time [default: one for each processor]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) jobs: Option<u16>,
    /// Write the lines as CSV, every digit
    #[arg(long, value_name = "FILE", value_parser = output_parser())]
    pub(crate) csv: Option<PathBuf>,
    /// How each is solved; the time limit is for each.
    #[command(flatten)]
    pub(crate) settings: Settings,
}

/// Whatever [`Method`] understands: names with `_` or `-`, Siconos' numbers. Clap knows the names, for
/// the help and for the nearest one.
#[derive(Clone, Copy, Debug)]
struct MethodParser;

impl MethodParser {
    fn names() -> PossibleValuesParser {
        PossibleValuesParser::new(Method::ALL.map(Method::name))
    }
}

impl TypedValueParser for MethodParser {
    type Value = Method;

    fn parse_ref(
        &self,
        command: &clap::Command,
        arg: Option<&clap::Arg>,
        value: &OsStr,
    ) -> Result<Method, clap::Error> {
        let given = value.to_string_lossy();
        given.parse().or_else(|unknown: UnknownMethod| {
            Self::names().parse_ref(command, arg, value)?;
            Err(clap::Error::raw(ErrorKind::InvalidValue, unknown))
        })
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(Method::ALL.map(|method| PossibleValue::new(method.name())).into_iter()))
    }
}

fn output_parser() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(output)
}

/// A file to be written; not `-`, since standard output is for what is printed.
pub(crate) fn output(path: PathBuf) -> Result<PathBuf, String> {
    if path.as_os_str() == "-" {
        return Err("expected a file: standard output is for what is printed".to_owned());
    }
    Ok(path)
}

/// A positive number, or `none`.
pub(crate) fn tolerance(text: &str) -> Result<Tolerance, String> {
    if text == "none" {
        return Ok(Tolerance(None));
    }
    match text.parse::<f64>() {
        Ok(tol) if tol > 0.0 && tol.is_finite() => Ok(Tolerance(Some(tol))),
        _ => Err("expected a positive number, or none".to_owned()),
    }
}

/// A positive number of seconds.
pub(crate) fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse::<f64>().ok().filter(|seconds| *seconds > 0.0);
    let duration = seconds.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    duration.ok_or_else(|| "expected a positive number of seconds".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_well_formed() {
        Cli::command().debug_assert();
    }

    #[test]
    fn defaults_are_those_of_the_help() {
        let cli = Cli::try_parse_from(["mcp", "solve", "a.nl"]).unwrap();
        let Command::Solve(solve) = cli.command else { panic!("solve was asked for") };
        let options = solve.settings.options();
        assert_eq!(options, Options::default().with(|o| o.tol = Some(TOL)));
        assert_eq!(solve.log, Log::Iterations);
    }

    #[test]
    fn methods_go_by_name_hyphens_and_siconos_number() {
        for (given, method) in [
            ("newton-fb", Method::NewtonFb),
            ("701", Method::NewtonMinFb),
            ("lemke", Method::Lemke),
        ] {
            let cli = Cli::try_parse_from(["mcp", "solve", "a.nl", "--method", given]).unwrap();
            let Command::Solve(solve) = cli.command else { panic!("solve was asked for") };
            assert_eq!(solve.settings.method, method);
        }
    }

    #[test]
    fn numbers_that_mean_nothing_are_refused() {
        assert_eq!(tolerance("none"), Ok(Tolerance(None)));
        assert_eq!(tolerance("1e-9"), Ok(Tolerance(Some(1e-9))));
        for text in ["0", "-1", "NaN", "inf", "tight"] {
            assert!(tolerance(text).is_err(), "{text}");
        }
        assert_eq!(seconds("0.5"), Ok(Duration::from_millis(500)));
        for text in ["0", "-1", "NaN", "inf", "1e300", "soon"] {
            assert!(seconds(text).is_err(), "{text}");
        }
    }
}
