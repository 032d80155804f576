//! [`Pairs`] and [`Map`]: sets of arcs and assignments, with incidence lists built once.

use super::ix::{Domain, Element, Ix, narrow};
use super::sets::{Indices, Members, listed};
use crate::model::Set;

/// For every element of one set, a list of indices of another.
#[derive(Clone, Debug)]
struct Incidence<S: Domain> {
    first: Vec<usize>,
    indices: Vec<Ix<S>>,
}

impl<S: Domain> Incidence<S> {
    /// Lists the index of every position under its key, in order.
    #[inline]
    fn new(keys: usize, key_of: &[usize], index: impl Fn(usize) -> Ix<S>) -> Self {
        let (first, order) = by_key(keys, key_of);
        Incidence { first, indices: listed(order.len(), |k| index(order[k])) }
    }

    #[inline]
    fn of(&self, key: usize) -> std::iter::Copied<std::slice::Iter<'_, Ix<S>>> {
        self.indices[self.first[key]..self.first[key + 1]].iter().copied()
    }
}

/// Where each key's positions begin, and all positions by their keys, in order. Not generic, so that
/// a model does not compile a sort of its own for every set.
fn by_key(keys: usize, key_of: &[usize]) -> (Vec<usize>, Vec<usize>) {
    let mut first = vec![0; keys + 1];
    for &key in key_of {
        first[key + 1] += 1;
    }
    for key in 0..keys {
        first[key + 1] += first[key];
    }
    let mut order: Vec<usize> = (0..key_of.len()).collect();
    order.sort_by_key(|&position| key_of[position]);
    (first, order)
}

/// Where arcs start, and where they end. Not generic, as [`by_key`].
fn apart(ends: &[(usize, usize)]) -> (Vec<usize>, Vec<usize>) {
    ends.iter().copied().unzip()
}

/// Arcs: a set each of whose elements goes from an element of `A` to one of `B`.
///
/// In a header, `l @ (i, j) in lines` names an arc and its ends.
#[derive(Clone, Debug)]
pub struct Pairs<S: Domain, A: Domain, B: Domain> {
    ends: Vec<(Ix<A>, Ix<B>)>,
    out_of: Incidence<S>,
    into: Incidence<S>,
    set: Set,
}

impl<S: Domain<Place = u32>, A: Domain, B: Domain> Pairs<S, A, B> {
    /// Arcs with these labels and ends, given by position.
    #[doc(hidden)]
    #[inline]
    pub fn new(
        set: Set,
        from: &impl Members<A>,
        to: &impl Members<B>,
        ends: &[(usize, usize)],
    ) -> Self {
        let (starts, stops) = apart(ends);
        let arc = |k| Ix::new(narrow(k));
        let out_of = Incidence::new(from.count(), &starts, arc);
        let into = Incidence::new(to.count(), &stops, arc);
        let ends = listed(ends.len(), |k| (from.ix(ends[k].0), to.ix(ends[k].1)));
        Pairs { ends, out_of, into, set }
    }
    /// Number of arcs.
    pub fn len(&self) -> usize {
        self.ends.len()
    }
    /// Whether there are no arcs.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }
    /// Label of an arc.
    pub fn label(&self, l: Ix<S>) -> String {
        self.set.label(l.position())
    }
    /// Where an arc starts and ends.
    #[inline]
    pub fn ends(&self, l: Ix<S>) -> (Ix<A>, Ix<B>) {
        self.ends[l.position()]
    }
    /// Arcs that end here.
    #[inline]
    pub fn into(&self, node: impl Element<B>) -> std::iter::Copied<std::slice::Iter<'_, Ix<S>>> {
        self.into.of(node.position_in())
    }
    /// Arcs that start here.
    #[inline]
    pub fn out_of(&self, node: impl Element<A>) -> std::iter::Copied<std::slice::Iter<'_, Ix<S>>> {
        self.out_of.of(node.position_in())
    }
    /// All arcs in order.
    pub fn iter(&self) -> Indices<S> {
        Indices::first(self.ends.len())
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
pub struct Map<A: Domain, B: Domain> {
    to: Vec<Ix<B>>,
    of: Incidence<A>,
}

impl<A: Domain, B: Domain> Map<A, B> {
    /// Sends element `k` of `from` to the element of `to` at position `targets[k]`.
    #[doc(hidden)]
    #[inline]
    pub fn new(from: &impl Members<A>, to: &impl Members<B>, targets: &[usize]) -> Self {
        Map {
            of: Incidence::new(to.count(), targets, |k| from.ix(k)),
            to: listed(targets.len(), |k| to.ix(targets[k])),
        }
    }
    /// What an element is sent to: `site[g]`.
    #[doc(hidden)]
    #[inline]
    pub fn get(&self, element: impl Element<A>) -> Ix<B> {
        self.to[element.position_in()]
    }
    /// All elements that are sent here.
    #[inline]
    pub fn of(&self, target: impl Element<B>) -> std::iter::Copied<std::slice::Iter<'_, Ix<A>>> {
        self.of.of(target.position_in())
    }
}

#[cfg(test)]
#[path = "pairs_tests.rs"]
mod tests;
