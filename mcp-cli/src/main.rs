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
mod plot;
mod solve;
mod start;
mod style;

use args::{Cli, Command};
use clap::Parser;
use clap::error::ErrorKind;
use error::CliError;
use exit::Outcome;
use std::io::{self, BufWriter, IsTerminal, Write};
use std::process::ExitCode;

fn main() -> ExitCode {
    let given: Vec<String> =
        std::env::args_os().skip(1).map(|arg| arg.to_string_lossy().into_owned()).collect();
    // A person at a terminal wants to see every line when it is written.
    let stdout = io::stdout().lock();
    let mut out: Box<dyn Write> =
        if stdout.is_terminal() { Box::new(stdout) } else { Box::new(BufWriter::new(stdout)) };
    let outcome = match ampl::Call::parse(&given) {
        Some(call) => ampl::run(&call, &mut out),
        None => command(&mut out),
    };
    match outcome.and_then(|outcome| Ok(out.flush().map(|()| outcome)?)) {
        Ok(outcome) => outcome.into(),
        Err(error) => match error.code() {
            Some(code) => {
                // Nobody is left to tell if this fails too.
                let _ = writeln!(io::stderr(), "error: {error}");
                ExitCode::from(code)
            }
            None => ExitCode::SUCCESS,
        },
    }
}

fn command(out: &mut impl Write) -> Result<Outcome, CliError> {
    match parse()?.command {
        Command::Solve(args) => solve::run(&args, out),
        Command::Check(args) => check::run(&args, out),
        Command::Info(args) => info::run(&args, out),
        Command::Batch(args) => batch::run(&args, out),
    }
}

/// The command line; where it cannot be understood, or asks for help, clap answers and exits.
fn parse() -> Result<Cli, CliError> {
    Cli::try_parse().or_else(|error| match (error.kind(), std::env::args().nth(1)) {
        (ErrorKind::InvalidSubcommand, Some(model)) if files::is_model(&model) => {
            Err(CliError::NoCommand { model })
        }
        _ => error.exit(),
    })
}
