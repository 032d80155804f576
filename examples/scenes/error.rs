//! Errors of scene files, by file, line and key.

use mcp_core::ModelError;
use mcp_core::dynamics::DynamicsError;
use std::ops::Range;

/// Why a scene cannot be read or run.
#[derive(Debug, thiserror::Error)]
pub(crate) enum SceneError {
    /// The file cannot be read.
    #[error("{file}: {reason}")]
    File { file: String, reason: std::io::Error },
    /// Something in the file is wrong.
    #[error("{file}:{line}: `{key}`: {message}")]
    Entry { file: String, line: usize, key: String, message: String },
    /// The system the scene describes is refused.
    #[error("{file}: {error}")]
    System { file: String, error: Box<DynamicsError> },
    /// The model behind the scene is not well formed.
    #[error("{file}: {error}")]
    Model { file: String, error: Box<ModelError> },
}

/// A scene file as text: turns places into lines.
pub(crate) struct Source<'a> {
    pub(crate) file: &'a str,
    pub(crate) text: &'a str,
}

impl Source<'_> {
    /// An error at a place of the text.
    pub(crate) fn error(
        &self,
        at: Range<usize>,
        key: impl Into<String>,
        message: impl Into<String>,
    ) -> SceneError {
        let before = self.text.get(..at.start).unwrap_or(self.text);
        let line = 1 + before.matches('\n').count();
        let (key, message) = (key.into(), message.into());
        SceneError::Entry { file: self.file.to_owned(), line, key, message }
    }

    /// An error of the syntax, or of a key that does not exist or is missing.
    pub(crate) fn syntax(&self, error: &toml::de::Error) -> SceneError {
        let at = error.span().unwrap_or(0..0);
        let quoted = error.message().split('`').nth(1);
        let written = self.text.get(at.clone()).and_then(|text| text.lines().next()).unwrap_or("");
        let key = quoted.unwrap_or(written).to_owned();
        self.error(at, key, error.message())
    }

    /// An error of the system as a whole.
    pub(crate) fn system(&self, error: DynamicsError) -> SceneError {
        SceneError::System { file: self.file.to_owned(), error: Box::new(error) }
    }
}
