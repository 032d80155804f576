//! What the code that `mcp!` generates calls while a model is built.

use super::input::{DataError, Labels, Table};
use super::layout::{At, Layout};
use crate::error::ModelError;
use crate::model::{Definition, Equation, Parameter, Set, Shape, ShapeBuilder, Variable};
use crate::scalar::{Real, Scalar};
use std::mem::take;

/// What an equation, a definition or a report may be.
#[diagnostic::on_unimplemented(
    message = "expected a number, found `{Self}`",
    label = "not a number",
    note = "an equation, a definition or a report is one number: an expression of variables and data"
)]
pub trait Expression<D: Scalar> {
    /// The number in the engine's arithmetic.
    fn real(self) -> Real<D>;
}

macro_rules! expression {
    ($($T:ty),*) => { $(
        #[diagnostic::do_not_recommend]
        impl<D: Scalar> Expression<D> for $T {
            #[inline]
            fn real(self) -> Real<D> {
                Real::from(self)
            }
        }
    )* };
}

expression!(f64, &f64, i32);

/// Counts and positions.
#[diagnostic::do_not_recommend]
impl<D: Scalar> Expression<D> for usize {
    #[inline]
    fn real(self) -> Real<D> {
        Real::from(self as f64)
    }
}

#[diagnostic::do_not_recommend]
impl<D: Scalar> Expression<D> for Real<D> {
    #[inline]
    fn real(self) -> Real<D> {
        self
    }
}

/// The value of an expression.
#[inline]
pub fn expression<D: Scalar>(value: impl Expression<D>) -> Real<D> {
    value.real()
}

/// A field of the data.
///
/// # Errors
/// [`DataError::NotGiven`] names it.
pub fn required<T>(name: &str, value: Option<T>) -> Result<T, ModelError> {
    value.ok_or_else(|| DataError::NotGiven { name: name.to_owned() }.into())
}

/// A number of the data.
///
/// # Errors
/// [`DataError::NotGiven`], [`DataError::Nan`].
pub fn scalar(name: &str, value: Option<f64>) -> Result<f64, ModelError> {
    let value = required(name, value)?;
    if value.is_nan() {
        return Err(DataError::Nan { key: name.to_owned(), place: None }.into());
    }
    Ok(value)
}

/// A table of the data.
///
/// # Errors
/// [`DataError::NotGiven`] and those of [`Table::resolve`].
pub fn table(name: &str, sets: &[&Set], given: &Option<Table>) -> Result<Layout, ModelError> {
    let values = required(name, given.as_ref())?.resolve(name, sets)?;
    Ok(Layout::new(name, sets)?.with_values(values))
}

/// The labels of a set.
///
/// # Errors
/// [`DataError::NotGiven`] and those of [`Labels::into_set`].
pub fn labels(name: &str, given: Option<Labels>) -> Result<Set, ModelError> {
    Ok(required(name, given)?.into_set(name)?)
}

/// What a family is called and described by: name, description and unit.
pub type Text<'a> = [&'a str; 3];

/// Which combinations there are: [`Assembly::variables`].
pub type Condition<'a> = &'a mut dyn FnMut(&At) -> bool;

/// A model while it is put together: the shape so far, and how many elements it has.
///
/// Nothing here is generic: what a model compiles itself are the closures that read its data.
#[derive(Debug, Default)]
pub struct Assembly {
    shape: ShapeBuilder,
    variables: usize,
    definitions: usize,
    parameters: usize,
    /// Bounds and starts of the variable family at hand.
    pub values: FamilyValues,
}

impl Assembly {
    /// Lays a parameter family out and declares it; `values` are one for each combination.
    ///
    /// # Errors
    /// [`ModelError::TooManyElements`].
    pub fn parameter(
        &mut self,
        [name, about, unit]: Text<'_>,
        sets: &[&Set],
        values: Vec<f64>,
    ) -> Result<Layout, ModelError> {
        let mut layout = Layout::new(name, sets)?;
        layout.offset = self.parameters;
        self.parameters += values.len();
        let family = Parameter::new(name, values.clone()).over(sets).about(about).unit(unit);
        self.shape = take(&mut self.shape).parameter(family);
        Ok(layout.with_values(values))
    }

    /// Lays a variable family out, with all combinations or those that a condition keeps, and makes
    /// its values free.
    ///
    /// # Errors
    /// [`ModelError::TooManyElements`].
    pub fn variables(
        &mut self,
        name: &str,
        sets: &[&Set],
        condition: Option<Condition<'_>>,
    ) -> Result<Layout, ModelError> {
        let mut layout = Layout::new(name, sets)?;
        if let Some(condition) = condition {
            let holds = |&dense: &usize| condition(&layout.split(dense));
            let members: Vec<usize> = (0..layout.count).filter(holds).collect();
            layout = layout.only(&members);
        }
        layout.offset = self.variables;
        self.variables += layout.count;
        self.values = FamilyValues::free(layout.count);
        Ok(layout)
    }

    /// Declares the variable family that was laid out last, with the values at hand.
    pub fn declare(&mut self, [name, about, unit]: Text<'_>, sets: &[&Set], layout: &Layout) {
        let FamilyValues { lower, upper, start } = take(&mut self.values);
        let mut family = Variable::new(name).about(about).unit(unit).over(sets);
        if let Some(members) = layout.members() {
            family = family.only(members.to_vec());
        }
        self.shape = take(&mut self.shape).variable(family.lower(lower).upper(upper).start(start));
    }

    /// Fixes elements of the variable family at hand: for each combination of `sets` one, where there
    /// is one. Without `sets` it must exist.
    ///
    /// # Errors
    /// [`DataError::FixedAbsent`].
    pub fn fix(
        &mut self,
        name: &str,
        sets: &[&Set],
        place: &mut dyn FnMut(&At) -> (Option<usize>, f64),
    ) -> Result<(), ModelError> {
        let layout = Layout::new(name, sets)?;
        for combination in 0..layout.count {
            let (place, value) = place(&layout.split(combination));
            if place.is_some() || sets.is_empty() {
                self.values.fix(place, value, name)?;
            }
        }
        Ok(())
    }

    /// Lays a definition family out and declares it.
    ///
    /// # Errors
    /// [`ModelError::TooManyElements`].
    pub fn definition(
        &mut self,
        [name, about, unit]: Text<'_>,
        sets: &[&Set],
    ) -> Result<Layout, ModelError> {
        let mut layout = Layout::new(name, sets)?;
        layout.offset = self.definitions;
        self.definitions += layout.count;
        let family = Definition::new(name).about(about).unit(unit).over(sets);
        self.shape = take(&mut self.shape).definition(family);
        Ok(layout)
    }

    /// Lays a report family out and declares it.
    ///
    /// # Errors
    /// [`ModelError::TooManyElements`].
    pub fn report(
        &mut self,
        [name, about, unit]: Text<'_>,
        sets: &[&Set],
    ) -> Result<Layout, ModelError> {
        let family = Definition::new(name).about(about).unit(unit).over(sets);
        self.shape = take(&mut self.shape).report(family);
        Layout::new(name, sets)
    }

    /// Lays an equation family out and declares it: a row for each combination that `paired` gives
    /// an element of the variable family `variable`.
    ///
    /// # Errors
    /// [`ModelError::TooManyElements`].
    pub fn equation(
        &mut self,
        [name, about, unit]: Text<'_>,
        sets: &[&Set],
        variable: &str,
        paired: &mut dyn FnMut(&At) -> Option<usize>,
    ) -> Result<Layout, ModelError> {
        let mut layout = Layout::new(name, sets)?;
        let (mut members, mut places) = (Vec::new(), Vec::new());
        for combination in 0..layout.count {
            if let Some(place) = paired(&layout.split(combination)) {
                members.push(combination);
                places.push(place);
            }
        }
        let mut family = Equation::new(name).about(about).unit(unit).over(sets);
        if members.len() < layout.count {
            layout = layout.only(&members);
            family = family.only(members);
        }
        self.shape = take(&mut self.shape).equation(family.complements_elements(variable, places));
        Ok(layout)
    }

    /// The equation family of a lifted definition.
    ///
    /// # Errors
    /// [`ModelError::TooManyElements`].
    pub fn lifted(
        &mut self,
        [name, about, unit]: Text<'_>,
        sets: &[&Set],
        variable: &str,
    ) -> Result<Layout, ModelError> {
        let family = Equation::new(name).about(about).unit(unit).over(sets);
        self.shape = take(&mut self.shape).equation(family.complements(variable));
        Layout::new(variable, sets)
    }

    /// The shape of everything that was declared.
    ///
    /// # Errors
    /// As [`ShapeBuilder::build`].
    pub fn build(self) -> Result<Shape, ModelError> {
        self.shape.build()
    }
}

/// Bounds and starts of a variable family, one for each element, while it is declared.
#[derive(Debug, Default)]
pub struct FamilyValues {
    /// Lower bounds.
    pub lower: Vec<f64>,
    /// Upper bounds.
    pub upper: Vec<f64>,
    /// Starts.
    pub start: Vec<f64>,
}

impl FamilyValues {
    /// Free variables starting at 0.
    fn free(count: usize) -> Self {
        FamilyValues {
            lower: vec![f64::NEG_INFINITY; count],
            upper: vec![f64::INFINITY; count],
            start: vec![0.0; count],
        }
    }

    /// Fixes an element of the family; `None` is a combination without element.
    fn fix(&mut self, place: Option<usize>, value: f64, variable: &str) -> Result<(), ModelError> {
        let Some(place) = place else {
            return Err(DataError::FixedAbsent { name: variable.to_owned() }.into());
        };
        (self.lower[place], self.upper[place], self.start[place]) = (value, value, value);
        Ok(())
    }
}

#[cfg(test)]
#[path = "assemble_tests.rs"]
mod tests;
