//! From a scenario file to an economy with its effects.

use super::effect::Effect;
use super::effects::{FileError, Source};
use super::file::ScenarioFile;
use super::model::Economy;
use std::path::Path;

/// A scenario, read and checked.
pub(crate) struct Scenario {
    pub(crate) title: String,
    pub(crate) effects: Vec<Effect>,
    pub(crate) economy: Economy,
}

impl Scenario {
    /// Reads a scenario file.
    pub(crate) fn read(path: &Path) -> Result<Self, FileError> {
        Source::read(path, Self::parse)
    }

    /// The scenario of a text.
    pub(crate) fn parse(source: &Source<'_>) -> Result<Self, FileError> {
        let file: ScenarioFile =
            toml::from_str(source.text).map_err(|error| source.syntax(&error))?;
        let effects = Effect::of_file(&file, source)?;
        let economy = Economy::with_effects(&effects).map_err(|error| source.refused(error))?;
        Ok(Scenario { title: file.title, effects, economy })
    }
}
