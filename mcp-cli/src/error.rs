//! [`CliError`]: why a command could not be carried out.

use crate::exit;
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
    #[error("{}: {reason}", .path.display())]
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
    /// A folder has no model in it, or cannot be listed.
    #[error("{}: {reason}", .path.display())]
    Folder {
        /// The folder.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// A model is named, but not what to do with it.
    #[error(
        "what is to be done with {model}? mcp solve {model}, or as AMPL does, mcp {model} -AMPL"
    )]
    NoCommand {
        /// The model.
        model: String,
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

    /// The exit code; `None` if whoever reads the output has closed it, as `head` does, which is no
    /// error.
    pub(crate) fn code(&self) -> Option<u8> {
        match self {
            CliError::Keyword(_) | CliError::NoCommand { .. } => Some(exit::USAGE),
            CliError::Output(reason) if reason.kind() == io::ErrorKind::BrokenPipe => None,
            _ => Some(exit::FILE),
        }
    }
}
