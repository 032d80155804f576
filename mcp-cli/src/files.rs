//! Reading models and writing files: every error says which file it is about.

use crate::error::{CliError, WriteError};
use crate::output::warn;
use mcp_cli::nl::{NlError, NlModel, stub_and_file, with_suffix};
use std::collections::HashMap;
use std::fs::{self, File, OpenOptions};
use std::io::{BufWriter, ErrorKind};
use std::path::{Path, PathBuf};

/// Reads a model.
pub(crate) fn model(path: &Path) -> Result<NlModel, CliError> {
    let failed = |reason| CliError::Model { path: stub_and_file(path).1, reason: Box::new(reason) };
    NlModel::read(path).map_err(failed)
}

/// Reads a model and tells on standard error what was put right in it.
pub(crate) fn model_with_warnings(path: &Path) -> Result<NlModel, CliError> {
    let model = model(path)?;
    model.warnings().iter().for_each(warn);
    Ok(model)
}

/// What is wrong with a model, in a line that begins with its path.
pub(crate) fn reason(path: &Path, error: &NlError) -> String {
    match error {
        NlError::Io { path: unreadable, source } if *unreadable == stub_and_file(path).1 => {
            source.to_string()
        }
        _ => error.to_string(),
    }
}

/// Whether a word of the command line is a model: a file, with or without `.nl`.
pub(crate) fn is_model(word: &Path) -> bool {
    stub_and_file(word).1.is_file()
}

/// Name of a model in headlines: its file without folder and `.nl`.
pub(crate) fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    name.strip_suffix(".nl").unwrap_or(&name).to_owned()
}

/// `MODEL.sol` beside `MODEL.nl`, whether the stub `MODEL` is given or its file.
pub(crate) fn solution_path(path: &Path) -> PathBuf {
    with_suffix(&stub_and_file(path).0, ".sol")
}

/// Checks that no output is a model or another output. Devices may be written twice.
pub(crate) fn are_distinct<'a>(
    models: impl IntoIterator<Item = &'a Path>,
    outputs: impl IntoIterator<Item = &'a Path>,
) -> Result<(), CliError> {
    let outputs: Vec<&Path> = outputs.into_iter().collect();
    if outputs.is_empty() {
        return Ok(());
    }
    let models = models.into_iter().filter_map(|path| identity(&stub_and_file(path).1));
    let mut taken: HashMap<PathBuf, &str> = models.map(|path| (path, "the model")).collect();
    for path in outputs {
        let Some(identity) = identity(path) else { continue };
        if let Some(over) = taken.insert(identity, "another file of this call") {
            return Err(CliError::Overwrites { path: path.to_owned(), over });
        }
    }
    Ok(())
}

/// The same for all paths of one file, whether it exists or not; `None` for what is no file, such
/// as `/dev/null`.
fn identity(path: &Path) -> Option<PathBuf> {
    if path.exists() {
        return path.is_file().then(|| path.canonicalize().unwrap_or_else(|_| path.to_owned()));
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new(".")).canonicalize();
    Some(
        folder
            .ok()
            .zip(path.file_name())
            .map_or(path.to_owned(), |(folder, name)| folder.join(name)),
    )
}

/// Checks that a file can be written; what is in it stays.
pub(crate) fn can_be_written(path: &Path) -> Result<(), CliError> {
    let opened = OpenOptions::new().write(true).create(true).truncate(false).open(path);
    opened.map(drop).map_err(failed(path))
}

/// Removes a file if it exists.
pub(crate) fn remove(path: &Path) -> Result<(), CliError> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(failed(path)(error)),
        _ => Ok(()),
    }
}

/// For `map_err`: this file cannot be written.
pub(crate) fn failed<E: Into<WriteError>>(path: &Path) -> impl Fn(E) -> CliError + '_ {
    |reason| CliError::Write { path: path.to_owned(), reason: Box::new(reason.into()) }
}

/// Writes a file.
pub(crate) fn write<E: Into<WriteError>>(
    path: &Path,
    content: impl FnOnce(&mut BufWriter<File>) -> Result<(), E>,
) -> Result<(), CliError> {
    let mut out = BufWriter::new(File::create(path).map_err(failed(path))?);
    content(&mut out).map_err(failed(path))?;
    // Dropping the buffer would hide a full disk.
    out.into_inner().map(drop).map_err(|error| failed(path)(error.into_error()))
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
