//! Where the numbers of an entry stand, so that what the library refuses is named by line and key.

use super::effects::{At, FileError, Source};
use mcp_core::dynamics::DynamicsError;
use std::ops::Range;

/// An entry of a scene file: its key, and under the word by which an error names a number, name or
/// direction, the key and the place where it stands.
pub(crate) struct Entry<'a> {
    source: &'a Source<'a>,
    key: &'static str,
    at: Range<usize>,
    words: Vec<(&'static str, &'static str, Range<usize>)>,
}

impl<'a> Entry<'a> {
    /// The entry `key` at this place.
    pub(crate) fn new(source: &'a Source<'a>, key: &'static str, at: Range<usize>) -> Self {
        Entry { source, key, at, words: Vec::new() }
    }

    /// What errors call `word` is this value of `key`.
    pub(crate) fn has<T>(mut self, word: &'static str, key: &'static str, value: &At<T>) -> Self {
        self.words.push((word, key, value.span()));
        self
    }

    /// As [`has`](Self::has), for a value that may be left out.
    pub(crate) fn may<T>(
        self,
        word: &'static str,
        key: &'static str,
        value: Option<&At<T>>,
    ) -> Self {
        match value {
            Some(value) => self.has(word, key, value),
            None => self,
        }
    }

    /// The fault at its place; at the entry where it has no other.
    pub(crate) fn fault(&self, error: &DynamicsError) -> FileError {
        let word = match error {
            DynamicsError::OutOfRange { quantity, .. } | DynamicsError::Length { quantity, .. } => {
                quantity
            }
            DynamicsError::NoMotion { direction, .. } => direction,
            DynamicsError::NameTwice { .. } => "name",
            DynamicsError::SameBody { .. } => "other",
            DynamicsError::NoCoordinate { .. } => "coordinate",
            DynamicsError::Linear(_) => "matrix",
            _ => "",
        };
        let place = self.words.iter().find(|place| place.0 == word);
        let (key, at) = match place {
            Some((_, key, at)) => (format!("{}.{key}", self.key), at.clone()),
            None => (self.key.to_owned(), self.at.clone()),
        };
        self.source.error(at, key, error.to_string())
    }
}

/// A finite number of a scene file.
pub(crate) fn finite(source: &Source<'_>, key: &str, value: &At<f64>) -> Result<f64, FileError> {
    let number = *value.get_ref();
    if number.is_finite() {
        return Ok(number);
    }
    Err(source.error(value.span(), key, format!("is {number}, but must be finite")))
}
