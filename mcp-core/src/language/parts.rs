//! Parts of a model: variables, equations and terms that exist only where they are switched on.

use super::assemble::{Assembly, PerElement};
use super::input::DataError;
use super::layout::{Added, Elements, Filled, Layout};
use crate::error::ModelError;
use crate::model::{Set, Shape};
use std::collections::HashMap;

/// What can be switched on in the model `M`: one of its parts with its data, a tuple of such, in any
/// order, or an [`Option`], where `None` is a part that stays off.
///
/// ```
/// use mcp_core::{Model, mcp};
///
/// mcp! {
///     model Market {
///         data { a: f64 }
///         var p >= 0.0;
///         eq clearing: p - a                            complements p;
///         part tax { param rate = 1.0; adds clearing: -rate; }
///         part cap { data { limit: f64 } var rent >= 0.0;
///             eq below: limit - p                       complements rent;
///             adds clearing: rent; }
///     }
/// }
/// let base = Market::builder().a(3.0).build()?;
/// let no_cap: Option<Cap> = None;
/// assert_eq!(base.with((no_cap, Tax))?.parts(), ["tax"]);
/// assert_eq!(base.with((Cap { limit: 2 }, Tax))?.parts(), ["tax", "cap"]);
/// assert_eq!(base.shape().n(), 1);
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no part of `{M}`",
    label = "expected a part of the model, or a tuple of parts"
)]
pub trait PartsOf<M> {
    /// Switches them on and hands their data over.
    #[doc(hidden)]
    fn give(self, assembly: &mut Assembly);
}

impl<M, P: PartsOf<M>> PartsOf<M> for Option<P> {
    fn give(self, assembly: &mut Assembly) {
        if let Some(parts) = self {
            parts.give(assembly);
        }
    }
}

impl<M> PartsOf<M> for () {
    fn give(self, _: &mut Assembly) {}
}

macro_rules! tuples {
    ($($($P:ident $part:ident),*;)*) => { $(
        impl<M, $($P: PartsOf<M>),*> PartsOf<M> for ($($P,)*) {
            fn give(self, assembly: &mut Assembly) {
                let ($($part,)*) = self;
                $($part.give(assembly);)*
            }
        }
    )* };
}

tuples! {
    A a;
    A a, B b;
    A a, B b, C c;
    A a, B b, C c, D d;
    A a, B b, C c, D d, E e;
    A a, B b, C c, D d, E e, F f;
    A a, B b, C c, D d, E e, F f, G g;
    A a, B b, C c, D d, E e, F f, G g, H h;
}

/// A part as the text declares it; other parts by their place in the text.
#[doc(hidden)]
#[derive(Debug)]
pub struct PartText {
    /// Its name.
    pub name: &'static str,
    /// Parts that have to be on with it.
    pub requires: &'static [usize],
    /// Parts that cannot be on with it.
    pub excludes: &'static [usize],
}

/// All parts of a model, and which are on.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct Parts {
    texts: &'static [PartText],
    on: Vec<bool>,
    /// For each family that several parts add terms to, the additions that are on, in the order of
    /// the text.
    added: Vec<Vec<usize>>,
    /// The shape before anything was changed by name.
    built: Shape,
}

impl Parts {
    /// All off.
    pub fn off(texts: &'static [PartText]) -> Self {
        let on = vec![false; texts.len()];
        Parts { texts, on, added: Vec::new(), built: Shape::default() }
    }

    /// Whether a part is on.
    pub fn is_on(&self, part: usize) -> bool {
        self.on[part]
    }

    /// The name of a part.
    pub(super) fn name(&self, part: usize) -> &'static str {
        self.texts[part].name
    }

    /// The names of the parts that are on, in the order of the text.
    pub fn names(&self) -> Vec<&'static str> {
        let on = self.texts.iter().zip(&self.on).filter(|(_, on)| **on);
        on.map(|(text, _)| text.name).collect()
    }

    /// What is added to a family that several parts add to.
    #[inline]
    pub fn added(&self, target: usize) -> &[usize] {
        &self.added[target]
    }

    /// These parts are switched on beside those that are on.
    ///
    /// # Errors
    /// [`ModelError::PartTwice`], [`ModelError::PartRequired`], [`ModelError::PartExcluded`].
    pub fn with<M>(&self, parts: impl PartsOf<M>) -> Result<Assembly, ModelError> {
        let mut assembly = Assembly::default();
        let (texts, before) = (self.texts, self.on.clone());
        assembly.0.switches = Switches { texts, before, ..Switches::default() };
        parts.give(&mut assembly);
        self.check(&mut assembly)?;
        Ok(assembly)
    }

    /// Whether the parts that are on fit together.
    fn check(&self, assembly: &mut Assembly) -> Result<(), ModelError> {
        assembly.so_far()?;
        let switches = &assembly.0.switches;
        let is_on = |part: usize| switches.is_on(part);
        let name = |part: usize| self.texts[part].name.to_owned();
        for part in (0..self.texts.len()).filter(|&part| is_on(part)) {
            let PartText { requires, excludes, .. } = &self.texts[part];
            if let Some(&missing) = requires.iter().find(|&&other| !is_on(other)) {
                return Err(ModelError::PartRequired { part: name(part), missing: name(missing) });
            }
            if let Some(&other) = excludes.iter().find(|&&other| is_on(other)) {
                return Err(ModelError::PartExcluded { part: name(part), other: name(other) });
            }
        }
        Ok(())
    }

    /// The model is put together.
    ///
    /// # Errors
    /// As [`Assembly::finish`], and those of a change by name that the parts do not admit.
    pub fn finish(&mut self, assembly: &mut Assembly, shape: &mut Shape) -> Result<(), ModelError> {
        let Switches { new, added, .. } = std::mem::take(&mut assembly.0.switches);
        assembly.finish(shape)?;
        for part in new {
            self.on[part] = true;
        }
        self.added = added;
        Ok(())
    }

    /// Remembers the shape as it was built, and takes over what was changed by name in `before`.
    ///
    /// # Errors
    /// As [`Shape::set_bounds`].
    pub fn keep_changes(&mut self, before: &Shape, shape: &mut Shape) -> Result<(), ModelError> {
        let built = std::mem::replace(&mut self.built, shape.clone());
        shape.take_changes(&built, before)
    }
}

/// Where an [`Assembly`] stands among the parts of its model.
#[derive(Default)]
pub(super) struct Switches {
    /// All parts; none while a model is built, where all are off.
    texts: &'static [PartText],
    /// Whether each is on in the model in which others are switched on.
    before: Vec<bool>,
    /// Parts that are switched on now.
    new: Vec<usize>,
    /// The part at hand.
    part: Option<usize>,
    /// [`Parts::added`].
    added: Vec<Vec<usize>>,
    /// Elements of the variable family at hand that are fixed, with the part that does.
    fixed: HashMap<usize, Option<usize>>,
}

impl Switches {
    fn is_on(&self, part: usize) -> bool {
        self.before.get(part) == Some(&true) || self.new.contains(&part)
    }

    /// Whether the part at hand is off.
    pub(super) fn is_off(&self) -> bool {
        self.part.is_some_and(|part| !self.is_on(part))
    }

    fn name(&self, part: Option<usize>) -> Option<String> {
        Some(self.texts[part?].name.to_owned())
    }

    /// Another variable family is at hand.
    pub(super) fn next_variable(&mut self) {
        self.fixed.clear();
    }

    /// The part at hand fixes an element of the variable family at hand.
    ///
    /// # Errors
    /// [`ModelError::FixedTwice`] if another part does, or the model without parts.
    pub(super) fn fixes(
        &mut self,
        place: usize,
        element: impl FnOnce() -> String,
    ) -> Result<(), ModelError> {
        if self.texts.is_empty() {
            return Ok(());
        }
        match self.fixed.insert(place, self.part) {
            Some(first) if first != self.part => {
                let [first, second] = [self.name(first), self.name(self.part)];
                Err(ModelError::FixedTwice { variable: element(), first, second })
            }
            _ => Ok(()),
        }
    }
}

impl Assembly {
    /// Switches a part on.
    pub fn switch_on(&mut self, part: usize) {
        let switches = &mut self.0.switches;
        if switches.is_on(part) {
            let twice = switches.name(Some(part)).unwrap_or_default();
            self.0.error.get_or_insert(ModelError::PartTwice { part: twice });
        } else {
            switches.new.push(part);
        }
    }

    /// Whether a part is switched on now.
    pub fn is_new(&self, part: usize) -> bool {
        self.0.switches.new.contains(&part)
    }

    /// What follows belongs to this part: where it is off, nothing is made.
    pub fn enter(&mut self, part: usize) {
        self.0.switches.part = Some(part);
    }

    /// What follows belongs to the model without parts.
    pub fn leave(&mut self) {
        self.0.switches.part = None;
    }

    /// Keeps the values of a parameter in the data.
    pub fn keep(&mut self, field: usize, values: &Filled) {
        if !values.values().is_empty() {
            self.give(field, values.values().to_vec());
        }
    }

    /// Finds the rows of the family `target` to which a part adds terms: one for each combination of
    /// `sets` that has one; without `sets` it must exist. `entry` computes the target of `rows` rows
    /// with what is added.
    pub fn addition(
        &mut self,
        (target, rows, entry): (&str, usize, usize),
        sets: &[&Set],
        row: &dyn PerElement<Option<usize>>,
    ) -> Added {
        let added = self.attempt(|pieces| {
            let layout = Layout::new(target, sets)?;
            let row = |combination| row.value(&layout.split(combination));
            let found: Vec<Option<usize>> = (0..layout.count).map(row).collect();
            if sets.is_empty() && found == [None] {
                return Err(DataError::AddedToAbsent { name: target.to_owned() }.into());
            }
            pieces.shape.enter(target, entry);
            Ok(Added::new(layout, rows, &found))
        });
        added.unwrap_or(Added::EMPTY)
    }

    /// Notes, of the additions to the family number `target`, that `addition` is on if its part is.
    pub fn adds(&mut self, target: usize, addition: usize) {
        let switches = &mut self.0.switches;
        if switches.added.len() <= target {
            switches.added.resize(target + 1, Vec::new());
        }
        if !switches.is_off() {
            switches.added[target].push(addition);
        }
    }
}

#[cfg(test)]
#[path = "parts_tests.rs"]
mod tests;
