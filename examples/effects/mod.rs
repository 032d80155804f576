//! Files that name effects: their faults by file, line and key, and the list of effects. For scenes
//! and economies alike.

mod error;
mod named;

pub(crate) use error::{FileError, Source};
pub(crate) use named::{Effect, named};

use std::path::{Path, PathBuf};

/// A number, a name, … with the place where it stands.
pub(crate) type At<T> = toml::Spanned<T>;

/// The TOML files of a folder by name.
pub(crate) fn files_in(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let entries = std::fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path()));
    let mut paths: Vec<PathBuf> = entries.collect::<Result<_, _>>()?;
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    Ok(paths)
}
