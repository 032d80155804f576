//! Names of variables and rows: from files beside the `.nl` file, or AMPL's generic ones.

use super::complement::NameOf;
use super::error::NlError;
use mcp_core::Set;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Names from `.col` and `.row` files, used as they are; without them, variables are called
/// `_svar[1]`, … and rows `_scon[1]`, …, as AMPL does.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Names {
    /// One for each variable of the file.
    pub columns: Option<Vec<String>>,
    /// One for each row of the file; those of objectives may follow.
    pub rows: Option<Vec<String>>,
}

impl Names {
    /// Names beside a stub: `stub.col` and `stub.row`, where they exist.
    pub(super) fn beside(stub: &Path) -> Result<Self, NlError> {
        let columns = lines(&with_suffix(stub, ".col"))?;
        Ok(Names { columns, rows: lines(&with_suffix(stub, ".row"))? })
    }

    /// Checks their numbers and drops those of objectives.
    pub(super) fn check(&mut self, columns: usize, rows: usize) -> Result<(), NlError> {
        if let Some(names) = &self.columns
            && names.len() != columns
        {
            let (file, expected, found) = (".col", columns, names.len());
            return Err(NlError::NameCount { file, expected, found });
        }
        if let Some(names) = &mut self.rows {
            if names.len() < rows {
                let (file, expected, found) = (".row", rows, names.len());
                return Err(NlError::NameCount { file, expected, found });
            }
            names.truncate(rows);
        }
        Ok(())
    }

    /// Labels of the variables, if they have names.
    pub(super) fn column_set(&self) -> Result<Option<Set>, NlError> {
        let set = |names: &Vec<String>| Set::new("columns", names.iter().map(String::as_str));
        Ok(self.columns.as_ref().map(set).transpose()?)
    }

    /// Labels of the rows, if they have names.
    pub(super) fn row_set(&self) -> Result<Option<Set>, NlError> {
        let set = |names: &Vec<String>| Set::new("rows", names.iter().map(String::as_str));
        Ok(self.rows.as_ref().map(set).transpose()?)
    }
}

impl NameOf for Names {
    fn row(&self, i: usize) -> String {
        name(self.rows.as_deref(), "_scon", i)
    }
    fn variable(&self, j: usize) -> String {
        name(self.columns.as_deref(), "_svar", j)
    }
}

fn name(names: Option<&[String]>, generic: &str, index: usize) -> String {
    let given = names.and_then(|names| names.get(index)).cloned();
    given.unwrap_or_else(|| format!("{generic}[{}]", index + 1))
}

/// The stub of a path and the `.nl` file it stands for: AMPL leaves out the suffix.
///
/// ```
/// use mcp_cli::nl::stub_and_file;
/// let of_stub = stub_and_file("folder/model".as_ref());
/// assert_eq!(of_stub, ("folder/model".into(), "folder/model.nl".into()));
/// assert_eq!(stub_and_file("folder/model.nl".as_ref()), of_stub);
/// ```
pub fn stub_and_file(path: &Path) -> (PathBuf, PathBuf) {
    if path.extension().is_some_and(|extension| extension == "nl") {
        return (path.with_extension(""), path.to_owned());
    }
    let file = with_suffix(path, ".nl");
    let file = if file.exists() || !path.exists() { file } else { path.to_owned() };
    (path.to_owned(), file)
}

/// The path with a suffix appended: a stub may contain dots.
///
/// ```
/// use mcp_cli::nl::with_suffix;
/// assert_eq!(with_suffix("tmp.v1".as_ref(), ".sol"), std::path::Path::new("tmp.v1.sol"));
/// ```
pub fn with_suffix(stub: &Path, suffix: &str) -> PathBuf {
    let mut path = stub.as_os_str().to_owned();
    path.push(suffix);
    path.into()
}

/// The lines of a file; `None` if there is no such file.
fn lines(path: &Path) -> Result<Option<Vec<String>>, NlError> {
    match fs::read(path) {
        Ok(bytes) => {
            let text = String::from_utf8_lossy(&bytes);
            Ok(Some(text.lines().map(|line| line.trim().to_owned()).collect()))
        }
        Err(source) if source.kind() == ErrorKind::NotFound => Ok(None),
        Err(source) => Err(NlError::Io { path: path.to_owned(), source }),
    }
}
