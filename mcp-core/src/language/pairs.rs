//! [`Pairs`] and [`Map`]: sets of arcs and assignments, with incidence lists built once.

use super::ix::{Domain, Element, Ix, Listed, Place, narrow};
use super::sets::{Indices, Members, Places};
use crate::model::Set;
use std::marker::PhantomData;

/// For every element of one set, a list of indices of another. Not generic, and so not compiled with
/// every model.
#[derive(Clone, Debug)]
struct Incidence {
    /// Where the list of each key begins.
    first: Vec<usize>,
    /// What the indices carry.
    numbers: Vec<u32>,
}

impl Incidence {
    /// Lists the index of every position under its key, in order.
    fn new(keys: &Set, key_of: &[usize], places: Places<'_>) -> Self {
        let mut first = vec![0; keys.len() + 1];
        for &key in key_of {
            first[key + 1] += places.numbers;
        }
        for key in 0..keys.len() {
            first[key + 1] += first[key];
        }
        let mut order: Vec<usize> = (0..key_of.len()).collect();
        order.sort_by_key(|&position| key_of[position]);
        Incidence { first, numbers: places.of(&order) }
    }

    #[inline]
    fn of(&self, key: usize) -> &[u32] {
        &self.numbers[self.first[key]..self.first[key + 1]]
    }
}

/// Arcs: a set each of whose elements goes from an element of `A` to one of `B`.
///
/// In a header, `l @ (i, j) in lines` names an arc and its ends.
#[derive(Clone, Debug)]
pub struct Pairs<S, A, B> {
    network: Network,
    set: Set,
    domains: PhantomData<(S, A, B)>,
}

/// [`Pairs`] without their types.
#[derive(Clone, Debug)]
struct Network {
    /// What the indices of both ends carry, arc by arc.
    ends: Vec<u32>,
    out_of: Incidence,
    into: Incidence,
}

impl Network {
    fn new([from, to]: [(&Set, Places<'_>); 2], ends: Vec<(usize, usize)>) -> Self {
        let (starts, stops): (Vec<usize>, Vec<usize>) = ends.into_iter().unzip();
        let mut numbers = Vec::with_capacity(starts.len() * (from.1.numbers + to.1.numbers));
        for (&start, &stop) in starts.iter().zip(&stops) {
            from.1.put(start, &mut numbers);
            to.1.put(stop, &mut numbers);
        }
        let arcs = Places::POSITIONS;
        Network {
            ends: numbers,
            out_of: Incidence::new(from.0, &starts, arcs),
            into: Incidence::new(to.0, &stops, arcs),
        }
    }
}

impl<S: Domain<Place = u32>, A: Domain, B: Domain> Pairs<S, A, B> {
    /// Arcs with these labels and ends, given by position.
    #[doc(hidden)]
    #[inline]
    pub fn new(
        set: Set,
        from: &impl Members<A>,
        to: &impl Members<B>,
        ends: Vec<(usize, usize)>,
    ) -> Self {
        let network = Network::new([(from.set(), from.places()), (to.set(), to.places())], ends);
        Pairs { network, set, domains: PhantomData }
    }
    /// Number of arcs.
    pub fn len(&self) -> usize {
        self.set.len()
    }
    /// Whether there are no arcs.
    pub fn is_empty(&self) -> bool {
        self.set.is_empty()
    }
    /// Label of an arc.
    pub fn label(&self, l: Ix<S>) -> String {
        self.set.label(l.position())
    }
    /// Where an arc starts and ends.
    #[inline]
    pub fn ends(&self, l: Ix<S>) -> (Ix<A>, Ix<B>) {
        let (from, to) = (A::Place::NUMBERS, B::Place::NUMBERS);
        let first = l.position() * (from + to);
        (Ix::at(&self.network.ends, first), Ix::at(&self.network.ends, first + from))
    }
    /// Arcs that end here.
    #[inline]
    pub fn into(&self, node: impl Element<B>) -> Listed<'_, S> {
        Listed::new(self.network.into.of(node.position_in()))
    }
    /// Arcs that start here.
    #[inline]
    pub fn out_of(&self, node: impl Element<A>) -> Listed<'_, S> {
        Listed::new(self.network.out_of.of(node.position_in()))
    }
    /// All arcs in order.
    pub fn iter(&self) -> Indices<S> {
        Indices::first(self.set.len())
    }
}

impl<S: Domain<Place = u32>, A: Domain, B: Domain> Members<S> for Pairs<S, A, B> {
    #[inline]
    fn set(&self) -> &Set {
        &self.set
    }
    #[inline]
    fn ix(&self, position: usize) -> Ix<S> {
        Ix::new(narrow(position))
    }
}

impl<S: Domain<Place = u32>, A: Domain, B: Domain> IntoIterator for &Pairs<S, A, B> {
    type Item = Ix<S>;
    type IntoIter = Indices<S>;
    fn into_iter(self) -> Indices<S> {
        self.iter()
    }
}

/// An assignment: every element of `A` has one of `B`.
#[derive(Clone, Debug)]
pub struct Map<A, B> {
    targets: Targets,
    domains: PhantomData<(A, B)>,
}

/// [`Map`] without its types.
#[derive(Clone, Debug)]
struct Targets {
    /// What the index carries that each element is sent to.
    to: Vec<u32>,
    of: Incidence,
}

impl Targets {
    #[allow(clippy::needless_pass_by_value, reason = "dropped here, not in every model")]
    fn new(from: Places<'_>, to: (&Set, Places<'_>), targets: Vec<usize>) -> Self {
        let of = Incidence::new(to.0, &targets, from);
        Targets { to: to.1.of(&targets), of }
    }
}

impl<A: Domain, B: Domain> Map<A, B> {
    /// Sends element `k` of `from` to the element of `to` at position `targets[k]`.
    #[doc(hidden)]
    #[inline]
    pub fn new(from: &impl Members<A>, to: &impl Members<B>, targets: Vec<usize>) -> Self {
        let targets = Targets::new(from.places(), (to.set(), to.places()), targets);
        Map { targets, domains: PhantomData }
    }
    /// What an element is sent to: `site[g]`.
    #[doc(hidden)]
    #[inline]
    pub fn get(&self, element: impl Element<A>) -> Ix<B> {
        Ix::at(&self.targets.to, element.position_in() * B::Place::NUMBERS)
    }
    /// All elements that are sent here.
    #[inline]
    pub fn of(&self, target: impl Element<B>) -> Listed<'_, A> {
        Listed::new(self.targets.of.of(target.position_in()))
    }
}

#[cfg(test)]
#[path = "pairs_tests.rs"]
mod tests;
