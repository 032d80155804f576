//! The parts of a model as its shape knows them: which are on, and what would come with the others.

use super::Shape;
use crate::error::ModelError;

/// A part of a model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Part {
    pub(crate) name: &'static str,
    pub(crate) is_on: bool,
    /// Names of its families, where it is off.
    pub(crate) absent: Vec<String>,
}

impl Shape {
    /// The names of the parts that are on, in the order of the text; none for a model without parts.
    /// See [`mcp!`](crate::mcp), Parts.
    pub fn parts(&self) -> Vec<&'static str> {
        self.all_parts().iter().filter(|part| part.is_on).map(|part| part.name).collect()
    }

    /// All parts, in the order of the text.
    pub(crate) fn all_parts(&self) -> &[Part] {
        &self.structure.parts
    }

    /// The same error, or [`ModelError::PartOff`] where the unknown name is one of a part that is off.
    pub(crate) fn unknown_or_off(&self, error: ModelError) -> ModelError {
        let ModelError::UnknownName { name, .. } = &error else { return error };
        let head = name.split('[').next().unwrap_or(name).trim();
        let has_name = |part: &&Part| part.absent.iter().any(|absent| absent == head);
        match self.all_parts().iter().find(has_name) {
            Some(part) => ModelError::PartOff { name: head.to_owned(), part: part.name.to_owned() },
            None => error,
        }
    }
}
