//! Parts of a model: variables, equations and terms that exist only where they are switched on.

use super::additions::{Additions, Found, Term};
use super::assemble::Assembly;
use super::layout::Filled;
use super::lifted::{LiftedStart, start_beside};
use crate::error::ModelError;
use crate::model::{Part, Shape};
use crate::problem::PlainModel;
use std::collections::HashMap;
use std::mem::{replace, take};

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

/// The parts of a model; which are on is known to its [`Shape`].
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct Parts {
    texts: &'static [PartText],
    /// What is added to each family that the text adds to.
    additions: Vec<Additions>,
    /// The shape before anything was changed by name.
    built: Shape,
    /// Variables whose start was changed by name.
    started: Vec<usize>,
}

impl Parts {
    /// All off.
    pub fn off(texts: &'static [PartText]) -> Self {
        Parts { texts, additions: Vec::new(), built: Shape::default(), started: Vec::new() }
    }

    /// The terms that are added to a row of a family that the text adds to.
    #[inline]
    pub fn added(&self, target: usize, row: usize) -> &[Term] {
        self.additions[target].of(row)
    }

    /// These parts are switched on beside those that are on in the model of this shape.
    ///
    /// # Errors
    /// [`ModelError::PartTwice`], [`ModelError::PartRequired`], [`ModelError::PartExcluded`].
    pub fn with<M>(&self, shape: &Shape, parts: impl PartsOf<M>) -> Result<Assembly, ModelError> {
        let mut assembly = Assembly::default();
        let before = shape.all_parts().iter().map(|part| part.is_on).collect();
        assembly.0.switches = Switches { texts: self.texts, before, ..Switches::default() };
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

    /// The model is put together, with what was changed by name in `before`.
    ///
    /// # Errors
    /// As [`Assembly::finish`], and those of a change by name that the parts do not admit.
    pub fn finish(
        &mut self,
        assembly: &mut Assembly,
        before: &Shape,
        shape: &mut Shape,
    ) -> Result<(), ModelError> {
        assembly.so_far()?;
        let switches = take(&mut assembly.0.switches);
        assembly.0.shape = take(&mut assembly.0.shape).parts(switches.parts(self.texts));
        assembly.finish(shape)?;
        self.additions = switches.found.iter().map(Found::additions).collect();
        let built = replace(&mut self.built, shape.clone());
        let fixed = switches.fixed.iter().filter_map(|(&variable, &part)| {
            let part = part.filter(|part| switches.new.contains(part))?;
            Some((variable, self.texts[part].name))
        });
        self.started = shape.take_changes(&built, before, &fixed.collect())?;
        Ok(())
    }

    /// A start at which lifted definitions hold, but for those whose start was changed by name.
    pub fn start_of_lifted(
        &self,
        model: &dyn PlainModel,
        lifted: &[(usize, usize)],
    ) -> LiftedStart {
        start_beside(model, lifted, &self.started)
    }

    /// Lifted definitions start there; only another start is a change by name.
    ///
    /// # Errors
    /// As [`Shape::set_start`].
    pub fn start_at(&mut self, lifted: &LiftedStart, shape: &mut Shape) -> Result<(), ModelError> {
        let mut built = self.built.start().to_vec();
        for &(j, value) in &lifted.values {
            built[j] = value;
        }
        self.built.set_start(&built)?;
        shape.set_start(&lifted.start)
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
    /// Names of families of parts that are off, with their parts.
    absent: Vec<(usize, String)>,
    /// What is added to each family that the text adds to.
    found: Vec<Found>,
    /// Variables that are fixed, with the part that does.
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
        Some(self.texts.get(part?)?.name.to_owned())
    }

    /// The name of the part at hand.
    pub(super) fn at_hand(&self) -> String {
        self.name(self.part).unwrap_or_default()
    }

    /// A family of the part at hand: where it is off, its name is all that is known.
    pub(super) fn meet(&mut self, family: &str) {
        if let Some(part) = self.part.filter(|&part| !self.is_on(part)) {
            self.absent.push((part, family.to_owned()));
        }
    }

    /// The parts as the shape knows them.
    fn parts(&self, texts: &'static [PartText]) -> Vec<Part> {
        let part = |(k, text): (usize, &PartText)| {
            let absent = self.absent.iter().filter(|(part, _)| *part == k);
            let absent = absent.map(|(_, name)| name.clone()).collect();
            Part { name: text.name, is_on: self.is_on(k), absent }
        };
        texts.iter().enumerate().map(part).collect()
    }

    /// The part at hand fixes a variable.
    ///
    /// # Errors
    /// [`ModelError::FixedTwice`] if another part does, or the model without parts.
    pub(super) fn fixes(
        &mut self,
        variable: usize,
        name: impl FnOnce() -> String,
    ) -> Result<(), ModelError> {
        if self.texts.is_empty() {
            return Ok(());
        }
        match self.fixed.insert(variable, self.part) {
            Some(first) if first != self.part => {
                let [first, second] = [self.name(first), self.name(self.part)];
                Err(ModelError::FixedTwice { variable: name(), first, second })
            }
            _ => Ok(()),
        }
    }

    /// The part at hand adds to a family of `rows` rows: the number of the addition, and the row of
    /// every combination.
    pub(super) fn adds(&mut self, target: usize, rows: usize, addition: (u32, Vec<Option<usize>>)) {
        if self.found.len() <= target {
            self.found.resize_with(target + 1, Found::default);
        }
        self.found[target].push(rows, addition);
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
}

#[cfg(test)]
#[path = "parts_tests.rs"]
mod tests;
