//! [`Input`]: what a user gives a model, until it is built.

use super::input::{LabelMap, LabelPairs, LabelSubset, Labels, Table};

/// One field of the data as it was given.
#[derive(Debug)]
pub enum Input {
    /// A set.
    Labels(Labels),
    /// A subset.
    Subset(LabelSubset),
    /// A set of arcs.
    Pairs(LabelPairs),
    /// A map.
    Map(LabelMap),
    /// A table or a parameter.
    Table(Table),
    /// A number.
    Number(f64),
    /// The values of a parameter in a model that is built already.
    Kept(Vec<f64>),
}

/// The way into [`Input`] and out of it.
macro_rules! input {
    ($($kind:ident($Type:ty))*) => { $(
        impl From<$Type> for Input {
            fn from(given: $Type) -> Self {
                Input::$kind(given)
            }
        }
        impl TryFrom<Input> for $Type {
            type Error = Input;
            fn try_from(input: Input) -> Result<Self, Input> {
                match input {
                    Input::$kind(given) => Ok(given),
                    other => Err(other),
                }
            }
        }
    )* };
}

input! {
    Labels(Labels)
    Subset(LabelSubset)
    Pairs(LabelPairs)
    Map(LabelMap)
    Table(Table)
    Number(f64)
    Kept(Vec<f64>)
}

/// All fields of the data, by number.
#[derive(Debug, Default)]
pub(super) struct Given(Vec<Option<Input>>);

impl Given {
    pub(super) fn put(&mut self, field: usize, input: Input) {
        if field >= self.0.len() {
            self.0.resize_with(field + 1, || None);
        }
        self.0[field] = Some(input);
    }

    /// What was given for a field, if it is of this type.
    pub(super) fn take<T: TryFrom<Input, Error = Input>>(&mut self, field: usize) -> Option<T> {
        let place = self.0.get_mut(field)?;
        T::try_from(place.take()?).map_err(|other| *place = Some(other)).ok()
    }
}
