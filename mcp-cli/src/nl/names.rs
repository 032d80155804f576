//! Names of variables and rows: from files beside the `.nl` file, or AMPL's generic ones.

use super::complement::NameOf;
use super::error::NlError;
use mcp_core::Set;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Names from `.col` and `.row` files, used as they are, in UTF-8 or Latin-1; without them, variables
/// are called `_svar[1]`, … and rows `_scon[1]`, …, as AMPL does. Names that do not fit the file or stand
/// twice are not used either, see [`NlModel::warnings`](super::NlModel::warnings).
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

    /// Drops names that do not fit the file, so that generic ones take their place, and those of
    /// objectives; says what was dropped and why. Names are decoration: a solve can do without.
    pub(super) fn drop_misfits(&mut self, columns: usize, rows: usize) -> Vec<String> {
        if let Some(names) = &mut self.rows {
            names.truncate(names.len().min(rows));
        }
        let kinds = [
            (&mut self.columns, columns, "columns", ".col", "_svar"),
            (&mut self.rows, rows, "rows", ".row", "_scon"),
        ];
        let mut warnings = Vec::new();
        for (names, expected, what, file, generic) in kinds {
            let Some(given) = names else { continue };
            let reason = if given.len() == expected {
                repeated(given).map(|name| format!("`{name}` stands there twice"))
            } else {
                Some(format!("{} for {expected} {what}", given.len()))
            };
            if let Some(reason) = reason {
                warnings.push(format!(
                    "the names in {file} are not used, {reason}: {what} are called {generic}[1], …"
                ));
                *names = None;
            }
        }
        warnings
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

/// A name that stands twice.
fn repeated(names: &[String]) -> Option<&str> {
    let mut sorted: Vec<&str> = names.iter().map(String::as_str).collect();
    sorted.sort_unstable();
    sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
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

/// The lines of a file without blank ones at its end; `None` if there is no such file.
fn lines(path: &Path) -> Result<Option<Vec<String>>, NlError> {
    match fs::read(path) {
        Ok(bytes) => {
            let text = String::from_utf8(bytes).unwrap_or_else(|e| from_latin_1(e.as_bytes()));
            let mut lines: Vec<String> = text.lines().map(|line| line.trim().to_owned()).collect();
            while lines.last().is_some_and(String::is_empty) {
                lines.pop();
            }
            Ok(Some(lines))
        }
        Err(source) if source.kind() == ErrorKind::NotFound => Ok(None),
        Err(source) => Err(NlError::Io { path: path.to_owned(), source }),
    }
}

/// The text of a file that is not UTF-8: each byte a character, so that names that differ stay so.
fn from_latin_1(bytes: &[u8]) -> String {
    bytes.iter().map(|&byte| char::from(byte)).collect()
}
