//! [`IndexSet`] and [`Subset`]: sets that hand out typed indices.

use super::ix::{Domain, Element, Ix, Listed, OrderedDomain, Place, narrow, signed};
use crate::model::Set;

/// Something whose elements are indices of `S`.
pub trait Members<S: Domain> {
    /// Labels.
    fn set(&self) -> &Set;
    /// The element at a position below the length.
    fn ix(&self, position: usize) -> Ix<S>;
    /// Number of elements.
    #[inline]
    fn count(&self) -> usize {
        self.set().len()
    }
    /// What its indices carry, without their type.
    #[doc(hidden)]
    #[inline]
    fn places(&self) -> Places<'_> {
        Places::POSITIONS
    }
}

/// What the indices of a set carry: the [`Place`] of every element.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Places<'a> {
    /// One after the other; nothing where they are the positions.
    listed: Option<&'a [u32]>,
    /// How many for each element.
    pub(super) numbers: usize,
}

impl Places<'_> {
    /// Where an index carries its position alone.
    pub(super) const POSITIONS: Self = Places { listed: None, numbers: 1 };

    /// Appends those of the element at a position.
    pub(super) fn put(self, position: usize, numbers: &mut Vec<u32>) {
        match self.listed {
            None => numbers.push(narrow(position)),
            Some(listed) => {
                numbers.extend_from_slice(&listed[position * self.numbers..][..self.numbers]);
            }
        }
    }

    /// Those of the elements at these positions.
    pub(super) fn of(self, positions: &[usize]) -> Vec<u32> {
        let mut numbers = Vec::with_capacity(positions.len() * self.numbers);
        for &position in positions {
            self.put(position, &mut numbers);
        }
        numbers
    }

    /// Those of the elements of a subset that are at these positions.
    fn within(self, positions: Vec<usize>) -> Vec<u32> {
        let mut numbers = Vec::with_capacity(positions.len() * (1 + self.numbers));
        for (k, position) in positions.into_iter().enumerate() {
            numbers.push(narrow(k));
            self.put(position, &mut numbers);
        }
        numbers
    }
}

/// A set of labels, or a count. `for i in &set` yields its indices.
#[derive(Clone, Debug)]
pub struct IndexSet<S> {
    set: Set,
    domain: std::marker::PhantomData<fn() -> S>,
}

impl<S: Domain<Place = u32>> IndexSet<S> {
    /// Typed indices for these labels.
    #[doc(hidden)]
    #[inline]
    pub fn new(set: Set) -> Self {
        IndexSet { set, domain: std::marker::PhantomData }
    }
    /// Number of elements.
    #[inline]
    pub fn len(&self) -> usize {
        self.set.len()
    }
    /// Whether there are no elements.
    pub fn is_empty(&self) -> bool {
        self.set.is_empty()
    }
    /// Label of an element.
    pub fn label(&self, i: impl Element<S>) -> String {
        self.set.label(i.position_in())
    }
    /// All indices in order.
    #[inline]
    pub fn iter(&self) -> Indices<S> {
        Indices::first(self.set.len())
    }
}

impl<S: OrderedDomain<Place = u32>> IndexSet<S> {
    /// The neighbour `by` places on, around the end: the last hour of the day is one before the
    /// first.
    #[inline]
    pub fn wrap(&self, t: impl Element<S>, by: i32) -> Ix<S> {
        let n = signed(self.set.len());
        let position = (signed(t.position_in()) + i64::from(by)).rem_euclid(n.max(1));
        Ix::new(u32::try_from(position).unwrap_or(0))
    }
    /// The first element. The set of a built model has one.
    pub fn first(&self) -> Ix<S> {
        Ix::new(0)
    }
    /// The last element.
    pub fn last(&self) -> Ix<S> {
        Ix::new(narrow(self.set.len().saturating_sub(1)))
    }
    /// Whether `t` is the first element.
    pub fn is_first(&self, t: impl Element<S>) -> bool {
        t.position_in() == self.first().position()
    }
    /// Whether `t` is the last element.
    pub fn is_last(&self, t: impl Element<S>) -> bool {
        t.position_in() == self.last().position()
    }
}

impl<S: Domain<Place = u32>> Members<S> for IndexSet<S> {
    #[inline]
    fn set(&self) -> &Set {
        &self.set
    }
    #[inline]
    fn ix(&self, position: usize) -> Ix<S> {
        Ix::new(narrow(position))
    }
}

/// The indices of a set in order.
#[derive(Clone, Debug)]
pub struct Indices<S> {
    positions: std::ops::Range<u32>,
    domain: std::marker::PhantomData<fn() -> S>,
}

impl<S: Domain<Place = u32>> Indices<S> {
    /// The first `count` indices.
    pub(super) fn first(count: usize) -> Self {
        Indices { positions: 0..narrow(count), domain: std::marker::PhantomData }
    }
}

impl<S: Domain<Place = u32>> Iterator for Indices<S> {
    type Item = Ix<S>;
    #[inline]
    fn next(&mut self) -> Option<Ix<S>> {
        self.positions.next().map(Ix::new)
    }
    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        self.positions.size_hint()
    }
}

impl<S: Domain<Place = u32>> ExactSizeIterator for Indices<S> {}

impl<S: Domain<Place = u32>> IntoIterator for &IndexSet<S> {
    type Item = Ix<S>;
    type IntoIter = Indices<S>;
    #[inline]
    fn into_iter(self) -> Indices<S> {
        self.iter()
    }
}

/// Some elements of another set, in its order. An index of the subset is also one of the larger
/// set.
#[derive(Clone, Debug)]
pub struct Subset<S> {
    places: Vec<u32>,
    set: Set,
    domain: std::marker::PhantomData<fn() -> S>,
}

impl<S: Domain<Place = (u32, Ix<P>)>, P: Domain> Subset<S> {
    /// The elements of `larger` at these positions, called as in `set`.
    #[doc(hidden)]
    #[inline]
    pub fn new(set: Set, larger: &impl Members<P>, positions: Vec<usize>) -> Self {
        let places = larger.places().within(positions);
        Subset { places, set, domain: std::marker::PhantomData }
    }
    /// Number of elements.
    pub fn len(&self) -> usize {
        self.set.len()
    }
    /// Whether there are no elements.
    pub fn is_empty(&self) -> bool {
        self.set.is_empty()
    }
    /// Label of an element.
    pub fn label(&self, i: impl Element<S>) -> String {
        self.set.label(i.position_in())
    }
    /// All indices in order.
    #[inline]
    pub fn iter(&self) -> Listed<'_, S> {
        Listed::new(&self.places)
    }
    /// Whether an element of the larger set is in the subset.
    pub fn contains(&self, i: impl Element<P>) -> bool {
        let position = i.position_in();
        let larger = |k| Members::<S>::ix(self, k).of_larger_set().position();
        let (mut low, mut high) = (0, self.len());
        while low < high {
            let middle = low.midpoint(high);
            if larger(middle) < position { low = middle + 1 } else { high = middle }
        }
        low < self.len() && larger(low) == position
    }
}

impl<S: Domain> Members<S> for Subset<S> {
    #[inline]
    fn set(&self) -> &Set {
        &self.set
    }
    #[inline]
    fn ix(&self, position: usize) -> Ix<S> {
        Ix::at(&self.places, position * S::Place::NUMBERS)
    }
    #[inline]
    fn places(&self) -> Places<'_> {
        Places { listed: Some(&self.places), numbers: S::Place::NUMBERS }
    }
}

impl<'a, S: Domain> IntoIterator for &'a Subset<S> {
    type Item = Ix<S>;
    type IntoIter = Listed<'a, S>;
    #[inline]
    fn into_iter(self) -> Listed<'a, S> {
        Listed::new(&self.places)
    }
}

#[cfg(test)]
#[path = "sets_tests.rs"]
mod tests;
