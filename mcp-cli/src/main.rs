//! `mcp`: mixed complementarity problems from AMPL `.nl` files.
//!
//! | command | file |
//! | --- | --- |
//! | `mcp solve MODEL.nl` | `solve` |
//! | `mcp check MODEL.nl` | `check` |
//! | `mcp info MODEL.nl` | `info` |
//! | `mcp batch FILES…` | `batch` |
//! | `mcp MODEL -AMPL [key=value …]`, `mcp -v`, `mcp -=` | `ampl`, `keywords` |

mod ampl;
mod args;
mod batch;
mod check;
mod document;
mod error;
mod exit;
mod files;
mod history;
mod info;
mod keywords;
mod output;
mod plot;
mod solve;
mod start;
mod style;

use args::{Cli, Command};
use clap::Parser;
use clap::error::ErrorKind;
use error::CliError;
use exit::Outcome;
use output::Output;
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    let given: Vec<OsString> = std::env::args_os().skip(1).collect();
    let mut out = Output::stdout();
    let outcome = match ampl::Call::parse(&given) {
        Some(call) => ampl::run(&call, &mut out),
        None => command(&given, &mut out),
    };
    let printed = out.finish().map_err(CliError::from);
    match outcome.and_then(|outcome| printed.map(|()| outcome)) {
        Ok(outcome) => outcome.into(),
        Err(error) => {
            // Nobody is left to tell if this fails too.
            let _ = writeln!(io::stderr(), "error: {error}");
            ExitCode::from(error.code())
        }
    }
}

fn command(given: &[OsString], out: &mut impl Write) -> Result<Outcome, CliError> {
    match parse(given)?.command {
        Command::Solve(args) => solve::run(&args, out),
        Command::Check(args) => check::run(&args, out),
        Command::Info(args) => info::run(&args, out),
        Command::Batch(args) => batch::run(&args, out),
    }
}

/// The command line; where it cannot be understood, or asks for help, clap answers and exits.
fn parse(given: &[OsString]) -> Result<Cli, CliError> {
    Cli::try_parse().or_else(|error| match (error.kind(), given.first().map(PathBuf::from)) {
        (ErrorKind::InvalidSubcommand, Some(model)) if files::is_model(&model) => {
            Err(CliError::NoCommand { model })
        }
        _ => error.exit(),
    })
}
