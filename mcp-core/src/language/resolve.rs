//! Sets, tables and numbers of the data, from what was given, while a model is built.

use super::assemble::{Assembly, Pieces};
use super::given::Input;
use super::input::{DataError, LabelMap, LabelPairs, LabelSubset, Labels, Table};
use super::layout::{Layout, Made};
use crate::error::ModelError;
use crate::model::Set;

impl Assembly {
    /// A field of a type of the user's own.
    ///
    /// # Errors
    /// The first that there was, or [`DataError::NotGiven`].
    pub fn required<T>(&mut self, name: &str, value: Option<T>) -> Result<T, ModelError> {
        match value {
            Some(value) => self.so_far().map(|()| value),
            None => Err(self.not_given(name)),
        }
    }

    fn not_given(&mut self, name: &str) -> ModelError {
        self.so_far().err().unwrap_or_else(|| not_given(name))
    }

    /// A set.
    pub fn set(&mut self, field: usize, name: &str) -> Set {
        let set =
            self.attempt(|pieces| Ok(pieces.required::<Labels>(field, name)?.into_set(name)?));
        set.unwrap_or_else(|| Set::count(name, 0))
    }

    /// A set of as many elements as the text says.
    pub fn count(&mut self, name: &str, elements: usize) -> Set {
        let set = self.attempt(|_| Ok(Labels::from(elements).into_set(name)?));
        set.unwrap_or_else(|| Set::count(name, 0))
    }

    /// A set with the labels of the text.
    pub fn labels(&mut self, name: &str, labels: &[&str]) -> Set {
        let set = self.attempt(|_| Set::new(name, labels.iter().copied()));
        set.unwrap_or_else(|| Set::count(name, 0))
    }

    /// A subset, and the positions of its elements in the larger set.
    pub fn subset(&mut self, field: usize, name: &str, larger: &Set) -> (Set, Vec<usize>) {
        let subset = self.attempt(|pieces| {
            let positions = pieces.required::<LabelSubset>(field, name)?.resolve(name, larger)?;
            let labels = positions.iter().map(|&position| larger.label(position));
            Ok((Set::new(name, labels)?, positions))
        });
        subset.unwrap_or_else(|| (Set::count(name, 0), Vec::new()))
    }

    /// A set of arcs, and the positions of their ends.
    pub fn pairs(
        &mut self,
        field: usize,
        name: &str,
        [from, to]: [&Set; 2],
    ) -> (Set, Vec<(usize, usize)>) {
        let pairs = self.attempt(|pieces| {
            Ok(pieces.required::<LabelPairs>(field, name)?.resolve(name, from, to)?)
        });
        pairs.unwrap_or_else(|| (Set::count(name, 0), Vec::new()))
    }

    /// A map, as the position to which every element is sent.
    pub fn map(&mut self, field: usize, name: &str, [from, to]: [&Set; 2]) -> Vec<usize> {
        let map = self.attempt(|pieces| {
            Ok(pieces.required::<LabelMap>(field, name)?.resolve(name, from, to)?)
        });
        map.unwrap_or_default()
    }

    /// A number.
    pub fn number(&mut self, field: usize, name: &str) -> f64 {
        let number = self.attempt(|pieces| {
            let number: f64 = pieces.required(field, name)?;
            if number.is_nan() {
                return Err(DataError::Nan { key: name.to_owned(), place: None }.into());
            }
            Ok(number)
        });
        number.unwrap_or(f64::NAN)
    }

    /// A table.
    pub fn table(&mut self, field: usize, name: &str, sets: &[&Set]) -> &mut Self {
        self.make(|pieces| {
            let values = pieces.required::<Table>(field, name)?.resolve(name, sets)?;
            Ok(Made { values, ..Layout::new(name, sets)?.into() })
        })
    }
}

impl Pieces {
    /// A field of the data.
    fn required<T: TryFrom<Input, Error = Input>>(
        &mut self,
        field: usize,
        name: &str,
    ) -> Result<T, ModelError> {
        self.given.take(field).ok_or_else(|| not_given(name))
    }
}

pub(super) fn not_given(name: &str) -> ModelError {
    DataError::NotGiven { name: name.to_owned() }.into()
}
