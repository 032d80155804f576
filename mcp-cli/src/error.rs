//! [`CliError`]: why a command could not be carried out.

use crate::exit;
use crate::files;
use crate::keywords::KeywordError;
use crate::plot::PlotError;
use crate::start::StartError;
use mcp_cli::nl::NlError;
use mcp_core::{ModelError, ReportError};
use std::io;
use std::path::{Path, PathBuf};

/// Why a command could not be carried out. A solve that ends without a solution is not an error.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CliError {
    /// The model cannot be read.
    #[error("{}: {}", .path.display(), files::reason(.path, .reason))]
    Model {
        /// Its file.
        path: PathBuf,
        /// What is wrong.
        reason: Box<NlError>,
    },
    /// The model is read, but it is no problem a solver can take.
    #[error("{}: {reason}", .path.display())]
    Problem {
        /// Its file.
        path: PathBuf,
        /// What is wrong.
        reason: Box<ModelError>,
    },
    /// The start cannot be read, or does not fit the model.
    #[error("{}: {reason}", .path.display())]
    Start {
        /// Its file.
        path: PathBuf,
        /// What is wrong.
        reason: Box<StartError>,
    },
    /// A file cannot be written.
    #[error("{} cannot be written: {reason}", .path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: Box<WriteError>,
    },
    /// A keyword of the AMPL convention.
    #[error(transparent)]
    Keyword(#[from] KeywordError),
    /// A file would be written over the model or over another file of the same call.
    #[error("{} would be written over {over}: name another file", .path.display())]
    Overwrites {
        /// The file.
        path: PathBuf,
        /// What would be lost.
        over: &'static str,
    },
    /// A model is named, but not what to do with it.
    #[error(
        "what is to be done with {0}? mcp solve {0}, or as AMPL does, mcp {0} -AMPL",
        .model.display()
    )]
    NoCommand {
        /// The model.
        model: PathBuf,
    },
    /// Standard output cannot be written.
    #[error("the output cannot be written: {0}")]
    Output(#[from] io::Error),
}

/// Why a file cannot be written.
#[derive(Debug, thiserror::Error)]
pub(crate) enum WriteError {
    /// The file system.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// A table or report.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// A JSON document.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
    /// A CSV table.
    #[error(transparent)]
    Csv(#[from] csv::Error),
    /// A picture.
    #[error(transparent)]
    Plot(#[from] PlotError),
}

impl CliError {
    /// For `map_err`: what is wrong with the problem of this file.
    pub(crate) fn problem(path: &Path) -> impl Fn(ModelError) -> Self + '_ {
        |reason| CliError::Problem { path: path.to_owned(), reason: Box::new(reason) }
    }

    /// The exit code.
    pub(crate) fn code(&self) -> u8 {
        match self {
            CliError::Keyword(_) | CliError::NoCommand { .. } | CliError::Overwrites { .. } => {
                exit::USAGE
            }
            _ => exit::FILE,
        }
    }
}
