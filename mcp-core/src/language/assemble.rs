//! What the code that `mcp!` generates calls while a model is built.

use super::given::{Given, Input};
use super::input::{DataError, LabelMap, LabelPairs, LabelSubset, Labels, Table};
use super::layout::{At, Elements, Family, Layout, Made, Sparse};
use crate::apart::Apart;
use crate::error::ModelError;
use crate::model::{Definition, Equation, Parameter, Set, Shape, ShapeBuilder, Variable};
use std::fmt;
use std::mem::take;

/// What a family is called and described by: name, description and unit.
pub type Text<'a> = &'a [&'a str; 3];

/// A value for every element, by the positions of its indices: a closure, as an object of one
/// function where `dyn Fn` has three, which are compiled for each.
pub trait PerElement<T> {
    /// The value there.
    fn value(&self, at: &At) -> T;
}

impl<T, F: Fn(&At) -> T> PerElement<T> for F {
    fn value(&self, at: &At) -> T {
        self(at)
    }
}

/// A number for every element.
pub type Each<'a> = &'a dyn PerElement<f64>;

/// What a variable family has one of for each element.
#[derive(Clone, Copy, Debug)]
pub enum Side {
    /// Lower bound.
    Lower,
    /// Upper bound.
    Upper,
    /// Where a solve starts.
    Start,
}

/// Which combinations there are: [`Assembly::variables`].
pub type Condition<'a> = &'a dyn PerElement<bool>;

/// A model while it is put together: what was given, the shape so far, and the first thing that is
/// wrong.
///
/// Nothing here is generic: what a model compiles itself are the closures that read its data. They
/// are not called after an error, which is told at the end: no line of the model's own returns it.
pub struct Assembly(Apart<Parts>);

#[derive(Default)]
struct Parts {
    given: Given,
    shape: ShapeBuilder,
    variables: usize,
    definitions: usize,
    parameters: usize,
    /// The variable family at hand, its elements, and its bounds and starts.
    family: Option<(Variable, Sparse)>,
    values: FamilyValues,
    /// What was made last.
    made: Option<Made>,
    error: Option<ModelError>,
}

impl fmt::Debug for Assembly {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Assembly").finish_non_exhaustive()
    }
}

impl Default for Assembly {
    fn default() -> Self {
        Assembly(Apart::new(Parts::default()))
    }
}

impl Assembly {
    /// What stands for the shape until it is made.
    pub fn no_shape() -> Shape {
        Shape::default()
    }

    /// Takes a field of the data, by its number.
    pub fn give(&mut self, field: usize, input: impl Into<Input>) {
        self.put(field, input.into());
    }

    fn put(&mut self, field: usize, input: Input) {
        self.0.given.put(field, input);
    }

    /// The result, unless there was an error before.
    fn attempt<T>(&mut self, make: impl FnOnce(&mut Parts) -> Result<T, ModelError>) -> Option<T> {
        if self.0.error.is_some() {
            return None;
        }
        make(&mut self.0).map_err(|error| self.0.error = Some(error)).ok()
    }

    /// Makes a family, unless there was an error before.
    fn make<M: Into<Made>>(
        &mut self,
        make: impl FnOnce(&mut Parts) -> Result<M, ModelError>,
    ) -> &mut Self {
        self.0.made = self.attempt(make).map(Into::into);
        self
    }

    /// Puts the family that was made last where it belongs.
    pub fn fill(&mut self, family: &mut dyn Family) {
        family.take(self.0.made.take().unwrap_or(Made::EMPTY));
    }

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

    fn so_far(&mut self) -> Result<(), ModelError> {
        self.0.error.take().map_or(Ok(()), Err)
    }

    fn not_given(&mut self, name: &str) -> ModelError {
        self.so_far().err().unwrap_or_else(|| not_given(name))
    }

    /// A set.
    pub fn set(&mut self, field: usize, name: &str) -> Set {
        let set =
            self.attempt(|parts| Ok(parts.required::<Labels>(field, name)?.into_set(name)?));
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
        let subset = self.attempt(|parts| {
            let positions = parts.required::<LabelSubset>(field, name)?.resolve(name, larger)?;
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
        let pairs = self.attempt(|parts| {
            Ok(parts.required::<LabelPairs>(field, name)?.resolve(name, from, to)?)
        });
        pairs.unwrap_or_else(|| (Set::count(name, 0), Vec::new()))
    }

    /// A map, as the position to which every element is sent.
    pub fn map(&mut self, field: usize, name: &str, [from, to]: [&Set; 2]) -> Vec<usize> {
        let map = self.attempt(|parts| {
            Ok(parts.required::<LabelMap>(field, name)?.resolve(name, from, to)?)
        });
        map.unwrap_or_default()
    }

    /// A number.
    pub fn number(&mut self, field: usize, name: &str) -> f64 {
        let number = self.attempt(|parts| {
            let number: f64 = parts.required(field, name)?;
            if number.is_nan() {
                return Err(DataError::Nan { key: name.to_owned(), place: None }.into());
            }
            Ok(number)
        });
        number.unwrap_or(f64::NAN)
    }

    /// A table.
    pub fn table(&mut self, field: usize, name: &str, sets: &[&Set]) -> &mut Self {
        self.make(|parts| {
            let values = parts.required::<Table>(field, name)?.resolve(name, sets)?;
            Ok(Made { values, ..Layout::new(name, sets)?.into() })
        })
    }

    /// Lays a parameter family out and declares it, with what was given or else the values of the
    /// text.
    pub fn parameter(
        &mut self,
        field: usize,
        text: Text<'_>,
        sets: &[&Set],
        values: Option<Each<'_>>,
    ) -> &mut Self {
        let [name, about, unit] = *text;
        self.make(|parts| {
            let mut made = Made::EMPTY;
            made.values = match (parts.given.take::<Table>(field), values) {
                (Some(table), _) => table.resolve(name, sets)?,
                (None, Some(values)) => Sparse::new(Layout::new(name, sets)?, None).each(values),
                (None, None) => return Err(not_given(name)),
            };
            made.elements.layout = Layout::new(name, sets)?;
            made.elements.layout.offset = parts.parameters;
            parts.parameters += made.values.len();
            let family = Parameter::new(name, made.values.clone());
            let family = family.over(sets).about(about).unit(unit);
            parts.shape = take(&mut parts.shape).parameter(family);
            Ok(made)
        })
    }

    /// Lays a variable family out, with all combinations or those that a condition keeps, and
    /// declares it free.
    pub fn variables(
        &mut self,
        text: Text<'_>,
        sets: &[&Set],
        condition: Option<Condition<'_>>,
    ) -> &mut Self {
        let [name, about, unit] = *text;
        self.make(|parts| {
            let layout = Layout::new(name, sets)?;
            let mut family = Variable::new(name).about(about).unit(unit).over(sets);
            let mut elements = if let Some(condition) = condition {
                let holds = |&dense: &usize| condition.value(&layout.split(dense));
                let members: Vec<usize> = (0..layout.count).filter(holds).collect();
                let elements = Sparse::new(layout, Some(&members));
                family = family.only(members);
                elements
            } else {
                Sparse::new(layout, None)
            };
            elements.layout.offset = parts.variables;
            parts.variables += elements.layout.count;
            parts.declare();
            parts.values = FamilyValues::free(elements.layout.count);
            parts.family = Some((family, elements.clone()));
            Ok(elements)
        })
    }

    /// Bounds or starts of the variable family at hand: the same number for all.
    pub fn constant(&mut self, side: Side, number: f64) {
        self.values(side, &|_: &At| number);
    }

    /// Bounds or starts of the variable family at hand.
    pub fn values(&mut self, side: Side, each: Each<'_>) {
        self.attempt(|parts| {
            if let Some((_, elements)) = &parts.family {
                *parts.values.of(side) = elements.each(each);
            }
            Ok(())
        });
    }

    /// Fixes elements of the variable family at hand: for each combination of `sets` one, where there
    /// is one. Without `sets` it must exist.
    pub fn fix(&mut self, name: &str, sets: &[&Set], place: &dyn PerElement<(Option<usize>, f64)>) {
        self.attempt(|parts| {
            let layout = Layout::new(name, sets)?;
            for combination in 0..layout.count {
                let (place, value) = place.value(&layout.split(combination));
                if place.is_some() || sets.is_empty() {
                    parts.values.fix(place, value, name)?;
                }
            }
            Ok(())
        });
    }

    /// Lays a definition family out and declares it.
    pub fn definition(&mut self, text: Text<'_>, sets: &[&Set]) -> &mut Self {
        let [name, about, unit] = *text;
        self.make(|parts| {
            let mut layout = Layout::new(name, sets)?;
            layout.offset = parts.definitions;
            parts.definitions += layout.count;
            let family = Definition::new(name).about(about).unit(unit).over(sets);
            parts.shape = take(&mut parts.shape).definition(family);
            Ok(layout)
        })
    }

    /// Lays a report family out and declares it.
    pub fn report(&mut self, text: Text<'_>, sets: &[&Set]) -> &mut Self {
        let [name, about, unit] = *text;
        self.make(|parts| {
            let family = Definition::new(name).about(about).unit(unit).over(sets);
            parts.shape = take(&mut parts.shape).report(family);
            Layout::new(name, sets)
        })
    }

    /// Lays an equation family out and declares it: a row for each combination that `paired` gives
    /// an element of the variable family `variable`.
    pub fn equation(
        &mut self,
        text: Text<'_>,
        sets: &[&Set],
        variable: &str,
        paired: &dyn PerElement<Option<usize>>,
    ) -> &mut Self {
        self.make(|parts| {
            let layout = Layout::new(text[0], sets)?;
            let place = |combination| paired.value(&layout.split(combination));
            Ok(parts.equation(text, sets, variable, &layout, place))
        })
    }

    /// The same where each combination is paired with the element of the same combination, if
    /// there is one.
    pub fn equation_like(
        &mut self,
        text: Text<'_>,
        sets: &[&Set],
        variable: &str,
        like: Option<&Sparse>,
    ) -> &mut Self {
        self.make(|parts| {
            let layout = Layout::new(text[0], sets)?;
            let place =
                |combination| like.map_or(Some(combination), |like| like.place(combination));
            Ok(parts.equation(text, sets, variable, &layout, place))
        })
    }

    /// The equation family of a lifted definition.
    pub fn lifted(&mut self, text: Text<'_>, sets: &[&Set], variable: &str) -> &mut Self {
        let [name, about, unit] = *text;
        self.make(|parts| {
            let family = Equation::new(name).about(about).unit(unit).over(sets);
            parts.shape = take(&mut parts.shape).equation(family.complements(variable));
            Layout::new(variable, sets)
        })
    }

    /// The shape of everything that was declared.
    ///
    /// # Errors
    /// The first of what was wrong, or as [`ShapeBuilder::build`].
    pub fn finish(&mut self, shape: &mut Shape) -> Result<(), ModelError> {
        self.so_far()?;
        self.0.declare();
        *shape = take(&mut self.0.shape).build()?;
        Ok(())
    }
}

fn not_given(name: &str) -> ModelError {
    DataError::NotGiven { name: name.to_owned() }.into()
}

impl Parts {
    /// A field of the data.
    fn required<T: TryFrom<Input>>(&mut self, field: usize, name: &str) -> Result<T, ModelError> {
        self.given.take(field).ok_or_else(|| not_given(name))
    }

    /// Declares the variable family at hand, if there is one.
    fn declare(&mut self) {
        if let Some((family, _)) = self.family.take() {
            let FamilyValues { lower, upper, start } = take(&mut self.values);
            let family = family.lower(lower).upper(upper).start(start);
            self.shape = take(&mut self.shape).variable(family);
        }
    }

    /// Declares an equation family with a row for each combination that has a place.
    fn equation(
        &mut self,
        &[name, about, unit]: Text<'_>,
        sets: &[&Set],
        variable: &str,
        all: &Layout,
        mut place: impl FnMut(usize) -> Option<usize>,
    ) -> Sparse {
        let place = |combination| place(combination).map(|place| (combination, place));
        let (members, places): (Vec<_>, Vec<_>) = (0..all.count).filter_map(place).unzip();
        let some = (members.len() < all.count).then_some(&members[..]);
        let rows = Sparse::new(all.clone(), some);
        let mut family = Equation::new(name).about(about).unit(unit).over(sets);
        if members.len() < all.count {
            family = family.only(members);
        }
        self.shape = take(&mut self.shape).equation(family.complements_elements(variable, places));
        rows
    }
}

/// Bounds and starts of a variable family, one for each element, while it is declared.
#[derive(Default)]
struct FamilyValues {
    lower: Vec<f64>,
    upper: Vec<f64>,
    start: Vec<f64>,
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

    fn of(&mut self, side: Side) -> &mut Vec<f64> {
        match side {
            Side::Lower => &mut self.lower,
            Side::Upper => &mut self.upper,
            Side::Start => &mut self.start,
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
