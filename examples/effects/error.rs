//! Errors of files, by file, line and key.

use std::error::Error;
use std::fmt;
use std::ops::Range;
use std::path::Path;

/// Why what a file describes cannot be read or run.
#[derive(thiserror::Error)]
pub(crate) enum FileError {
    /// The file cannot be read.
    #[error("{file}: {reason}")]
    File { file: String, reason: std::io::Error },
    /// Something in the file is wrong.
    #[error("{file}:{line}: `{key}`: {message}")]
    Entry { file: String, line: usize, key: String, message: String },
    /// The model or the system that the file describes is refused.
    #[error("{file}: {error}")]
    Refused { file: String, error: Box<dyn Error + Send + Sync> },
}

/// As [`Display`](fmt::Display): what `main` prints of an error it returns.
impl fmt::Debug for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// A file as text: turns places into lines.
pub(crate) struct Source<'a> {
    pub(crate) file: &'a str,
    pub(crate) text: &'a str,
}

impl Source<'_> {
    /// Reads a file and has its text parsed.
    pub(crate) fn read<T>(
        path: &Path,
        parse: impl FnOnce(&Source<'_>) -> Result<T, FileError>,
    ) -> Result<T, FileError> {
        let file = path.display().to_string();
        match std::fs::read_to_string(path) {
            Ok(text) => parse(&Source { file: &file, text: &text }),
            Err(reason) => Err(FileError::File { file, reason }),
        }
    }

    /// An error at a place of the text.
    pub(crate) fn error(
        &self,
        at: Range<usize>,
        key: impl Into<String>,
        message: impl Into<String>,
    ) -> FileError {
        let before = self.text.get(..at.start).unwrap_or(self.text);
        let line = 1 + before.matches('\n').count();
        let (key, message) = (key.into(), message.into());
        FileError::Entry { file: self.file.to_owned(), line, key, message }
    }

    /// An error of the syntax, of a key that does not exist or is missing, or of a value of the wrong kind.
    pub(crate) fn syntax(&self, error: &toml::de::Error) -> FileError {
        let (at, message) = (error.span().unwrap_or(0..0), error.message());
        let is_of_key = ["unknown field", "missing field"].iter().any(|of| message.starts_with(of));
        let quoted = message.split('`').nth(1).filter(|_| is_of_key);
        let key = quoted.unwrap_or_else(|| self.key_at(at.start)).to_owned();
        self.error(at, key, message)
    }

    /// The key of the line of a place, or of the last one before it that has a key: values may go over
    /// several lines.
    fn key_at(&self, at: usize) -> &str {
        let (before, after) = self.text.split_at_checked(at).unwrap_or((self.text, ""));
        let end = before.len() + after.find('\n').unwrap_or(after.len());
        let lines = self.text.get(..end).unwrap_or("").lines().rev();
        let key = lines.map(|line| line.split_once('=').map_or(line, |(key, _)| key).trim());
        let mut keys =
            key.filter(|key| key.trim_start_matches('[').starts_with(char::is_alphabetic));
        keys.next().unwrap_or("")
    }

    /// An error of the file as a whole.
    pub(crate) fn refused(&self, error: impl Error + Send + Sync + 'static) -> FileError {
        FileError::Refused { file: self.file.to_owned(), error: Box::new(error) }
    }
}
