//! Reading models and writing files: every error says which file it is about.

use crate::error::{CliError, WriteError};
use mcp_cli::nl::NlModel;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

/// Reads a model.
pub(crate) fn model(path: &Path) -> Result<NlModel, CliError> {
    NlModel::read(path)
        .map_err(|reason| CliError::Model { path: path.to_owned(), reason: Box::new(reason) })
}

/// Whether a word of the command line is a model: a file, with or without `.nl`.
pub(crate) fn is_model(word: &str) -> bool {
    let is_file = |path: &Path| path.is_file();
    is_file(Path::new(word)) || is_file(Path::new(&format!("{word}.nl")))
}

/// Name of a model in headlines: its file without folder and `.nl`.
pub(crate) fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    name.strip_suffix(".nl").unwrap_or(&name).to_owned()
}

/// `MODEL.sol` beside `MODEL.nl`, whether the stub `MODEL` is given or its file.
pub(crate) fn solution_path(path: &Path) -> PathBuf {
    let stub = if path.extension().is_some_and(|end| end == "nl") {
        path.with_extension("")
    } else {
        path.to_owned()
    };
    let mut name = stub.into_os_string();
    name.push(".sol");
    name.into()
}

/// Writes a file.
pub(crate) fn write<E: Into<WriteError>>(
    path: &Path,
    content: impl FnOnce(&mut BufWriter<File>) -> Result<(), E>,
) -> Result<(), CliError> {
    let failed = |reason| CliError::Write { path: path.to_owned(), reason: Box::new(reason) };
    let mut out = BufWriter::new(File::create(path).map_err(|e| failed(e.into()))?);
    content(&mut out).map_err(|e| failed(e.into()))?;
    // Dropping the buffer would hide a full disk.
    out.into_inner().map(drop).map_err(|e| failed(e.into_error().into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_solution_stands_beside_the_model() {
        for (model, solution) in [
            ("a/model.nl", "a/model.sol"),
            ("a/model", "a/model.sol"),
            ("tmp.v1.2", "tmp.v1.2.sol"),
            ("tmp.v1.nl", "tmp.v1.sol"),
        ] {
            assert_eq!(solution_path(Path::new(model)), Path::new(solution));
        }
    }

    #[test]
    fn a_model_is_called_by_its_file() {
        assert_eq!(name(Path::new("a/b/model.nl")), "model");
        assert_eq!(name(Path::new("model.v2")), "model.v2");
    }
}
