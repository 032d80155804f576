//! What the code that `mcp!` generates calls while a model is built.

use super::given::{Given, Input};
use super::input::{DataError, Table};
use super::layout::{At, Elements, Family, Layout, Made, Sparse};
use super::parts::Switches;
use super::resolve::not_given;
use super::values::{FamilyValues, Side};
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

/// Which combinations there are: [`Assembly::variables`].
pub type Condition<'a> = &'a dyn PerElement<bool>;

/// A model while it is put together: what was given, the shape so far, and the first thing that is
/// wrong.
///
/// Nothing here is generic: what a model compiles itself are the closures that read its data. They
/// are not called after an error, which is told at the end: no line of the model's own returns it.
pub struct Assembly(pub(super) Apart<Pieces>);

#[derive(Default)]
pub(super) struct Pieces {
    pub(super) given: Given,
    pub(super) shape: ShapeBuilder,
    variables: usize,
    definitions: usize,
    parameters: usize,
    /// The variable family at hand, its elements, and its bounds and starts.
    family: Option<(Variable, Sparse)>,
    values: FamilyValues,
    /// What was made last.
    made: Option<Made>,
    pub(super) error: Option<ModelError>,
    /// Families so far, of each kind, whether they are on or not.
    entries: [usize; 4],
    pub(super) switches: Switches,
}

/// Families that the model is asked for by their entry.
#[derive(Clone, Copy)]
enum Entered {
    Variable,
    Equation,
    Definition,
    Report,
}

impl fmt::Debug for Assembly {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Assembly").finish_non_exhaustive()
    }
}

impl Default for Assembly {
    fn default() -> Self {
        Assembly(Apart::new(Pieces::default()))
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

    /// The result, unless there was an error before or the part at hand is off.
    pub(super) fn attempt<T>(
        &mut self,
        make: impl FnOnce(&mut Pieces) -> Result<T, ModelError>,
    ) -> Option<T> {
        if self.0.error.is_some() || self.0.switches.is_off() {
            return None;
        }
        make(&mut self.0).map_err(|error| self.0.error = Some(error)).ok()
    }

    /// The number of the next family of a kind, called `name`.
    fn entry(&mut self, of: Entered, name: &str) -> usize {
        self.0.switches.meet(name);
        let entry = &mut self.0.entries[of as usize];
        *entry += 1;
        *entry - 1
    }

    /// Makes a family, unless there was an error before.
    pub(super) fn make<M: Into<Made>>(
        &mut self,
        make: impl FnOnce(&mut Pieces) -> Result<M, ModelError>,
    ) -> &mut Self {
        self.0.made = self.attempt(make).map(Into::into);
        self
    }

    /// Puts the family that was made last where it belongs.
    pub fn fill(&mut self, family: &mut dyn Family) {
        family.take(self.0.made.take().unwrap_or(Made::EMPTY));
    }

    pub(super) fn so_far(&mut self) -> Result<(), ModelError> {
        self.0.error.take().map_or(Ok(()), Err)
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
        self.0.switches.meet(name);
        self.make(|pieces| {
            let mut made = Made::EMPTY;
            let kept: Option<Vec<f64>> = pieces.given.take(field);
            made.values = match (pieces.given.take::<Table>(field), values) {
                (Some(table), _) => table.resolve(name, sets)?,
                (None, _) if kept.is_some() => kept.unwrap_or_default(),
                (None, Some(values)) => Sparse::new(Layout::new(name, sets)?, None).each(values),
                (None, None) => return Err(not_given(name)),
            };
            made.elements.layout = Layout::new(name, sets)?;
            made.elements.layout.offset = pieces.parameters;
            pieces.parameters += made.values.len();
            let family = Parameter::new(name, made.values.clone());
            let family = family.over(sets).about(about).unit(unit);
            pieces.shape = take(&mut pieces.shape).parameter(family);
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
        let entry = self.entry(Entered::Variable, name);
        self.make(|pieces| {
            let layout = Layout::new(name, sets)?;
            let mut family = Variable::new(name).entered(entry).about(about).unit(unit).over(sets);
            let mut elements = if let Some(condition) = condition {
                let holds = |&dense: &usize| condition.value(&layout.split(dense));
                let members: Vec<usize> = (0..layout.count).filter(holds).collect();
                let elements = Sparse::new(layout, Some(&members));
                family = family.only(members);
                elements
            } else {
                Sparse::new(layout, None)
            };
            elements.layout.offset = pieces.variables;
            pieces.variables += elements.layout.count;
            pieces.declare();
            pieces.values = FamilyValues::free(elements.layout.count);
            pieces.family = Some((family, elements.clone()));
            Ok(elements)
        })
    }

    /// Bounds or starts of the variable family at hand: the same number for all.
    pub fn constant(&mut self, side: Side, number: f64) {
        self.values(side, &|_: &At| number);
    }

    /// Bounds or starts of the variable family at hand.
    pub fn values(&mut self, side: Side, each: Each<'_>) {
        self.attempt(|pieces| {
            if let Some((_, elements)) = &pieces.family {
                *pieces.values.of(side) = elements.each(each);
            }
            Ok(())
        });
    }

    /// Fixes elements of the variable family at hand: for each combination of `sets` one, where there
    /// is one. Without `sets` it must exist.
    pub fn fix(&mut self, name: &str, sets: &[&Set], place: &dyn PerElement<(Option<usize>, f64)>) {
        self.attempt(|pieces| {
            let layout = Layout::new(name, sets)?;
            for combination in 0..layout.count {
                let (place, value) = place.value(&layout.split(combination));
                if place.is_some() || sets.is_empty() {
                    pieces.fix(place, value, name)?;
                }
            }
            Ok(())
        });
    }

    /// Lays a definition family out and declares it.
    pub fn definition(&mut self, text: Text<'_>, sets: &[&Set]) -> &mut Self {
        let [name, about, unit] = *text;
        let entry = self.entry(Entered::Definition, name);
        self.make(|pieces| {
            let mut layout = Layout::new(name, sets)?;
            layout.offset = pieces.definitions;
            pieces.definitions += layout.count;
            let family = Definition::new(name).entered(entry).about(about).unit(unit).over(sets);
            pieces.shape = take(&mut pieces.shape).definition(family);
            Ok(layout)
        })
    }

    /// Lays a report family out and declares it.
    pub fn report(&mut self, text: Text<'_>, sets: &[&Set]) -> &mut Self {
        let [name, about, unit] = *text;
        let entry = self.entry(Entered::Report, name);
        self.make(|pieces| {
            let family = Definition::new(name).entered(entry).about(about).unit(unit).over(sets);
            pieces.shape = take(&mut pieces.shape).report(family);
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
        let entry = self.entry(Entered::Equation, text[0]);
        self.make(|pieces| {
            let layout = Layout::new(text[0], sets)?;
            let place = |combination| paired.value(&layout.split(combination));
            Ok(pieces.equation((text, entry), sets, variable, &layout, place))
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
        let entry = self.entry(Entered::Equation, text[0]);
        self.make(|pieces| {
            let layout = Layout::new(text[0], sets)?;
            let place =
                |combination| like.map_or(Some(combination), |like| like.place(combination));
            Ok(pieces.equation((text, entry), sets, variable, &layout, place))
        })
    }

    /// The equation family of a lifted definition.
    pub fn lifted(&mut self, text: Text<'_>, sets: &[&Set], variable: &str) -> &mut Self {
        let [name, about, unit] = *text;
        let entry = self.entry(Entered::Equation, name);
        self.make(|pieces| {
            let family = Equation::new(name).entered(entry).about(about).unit(unit).over(sets);
            pieces.shape = take(&mut pieces.shape).equation(family.complements(variable));
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

impl Pieces {
    /// Fixes an element of the variable family at hand; `None` is a combination without element.
    fn fix(&mut self, place: Option<usize>, value: f64, name: &str) -> Result<(), ModelError> {
        let Some(place) = place else {
            return Err(DataError::FixedAbsent { name: name.to_owned() }.into());
        };
        let element = || match &self.family {
            Some((family, _)) => family.element_name(place),
            None => name.to_owned(),
        };
        let first = self.family.as_ref().map_or(0, |(_, elements)| elements.layout.offset);
        self.switches.fixes(first + place, element)?;
        self.values.fix(place, value);
        Ok(())
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
        (&[name, about, unit], entry): (Text<'_>, usize),
        sets: &[&Set],
        variable: &str,
        all: &Layout,
        mut place: impl FnMut(usize) -> Option<usize>,
    ) -> Sparse {
        let place = |combination| place(combination).map(|place| (combination, place));
        let (members, places): (Vec<_>, Vec<_>) = (0..all.count).filter_map(place).unzip();
        let some = (members.len() < all.count).then_some(&members[..]);
        let rows = Sparse::new(all.clone(), some);
        let mut family = Equation::new(name).entered(entry).about(about).unit(unit).over(sets);
        if members.len() < all.count {
            family = family.only(members);
        }
        self.shape = take(&mut self.shape).equation(family.complements_elements(variable, places));
        rows
    }
}

#[cfg(test)]
#[path = "assemble_tests.rs"]
mod tests;
