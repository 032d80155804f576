//! [`Ix`]: an element of an index set, as a type of its own for each set.

use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::marker::PhantomData;
use std::ops::{Add, Sub};
use std::slice::Iter;

/// The name of an index set as a type. `mcp!` makes one for each set of a model.
pub trait Domain: Copy + fmt::Debug + 'static {
    /// What an index carries: its position, for a subset also the index it is in the larger set.
    type Place: Place;
}

/// Stands for a set that is not declared, in a model with errors.
#[doc(hidden)]
impl Domain for () {
    type Place = u32;
}

/// A set whose elements have neighbours: `Ordered` and counts.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an ordered set",
    label = "its elements have no neighbours",
    note = "declare it as `Ordered`, or as a count, in the data of the model"
)]
pub trait OrderedDomain: Domain {}

/// A position as an index carries it. Sets have at most 2³¹ elements: see
/// [`Layout::new`](super::Layout::new).
#[allow(clippy::cast_possible_truncation, reason = "sets have at most 2^31 elements")]
#[inline]
pub(super) fn narrow(position: usize) -> u32 {
    position as u32
}

/// A position that can be counted down from.
#[allow(clippy::cast_possible_wrap, reason = "sets have at most 2^31 elements")]
#[inline]
pub(super) fn signed(position: usize) -> i64 {
    position as i64
}

/// What an index carries, as numbers: its position, for a subset followed by those of the index in
/// the larger set. Sets keep lists of such numbers, whose code no model compiles for its own types.
pub trait Place: Copy + Eq + fmt::Debug {
    /// How many numbers.
    #[doc(hidden)]
    const NUMBERS: usize;
    /// Position in the set, counted from 0.
    fn position(self) -> usize;
    /// From the numbers that stand at `first`.
    #[doc(hidden)]
    fn at(numbers: &[u32], first: usize) -> Self;
    /// From the next numbers of a list.
    #[doc(hidden)]
    fn next(numbers: &mut Iter<'_, u32>) -> Option<Self>;
    /// From the last numbers of a list.
    #[doc(hidden)]
    fn next_back(numbers: &mut Iter<'_, u32>) -> Option<Self>;
}

impl Place for u32 {
    const NUMBERS: usize = 1;
    #[inline]
    fn position(self) -> usize {
        self as usize
    }
    #[inline]
    fn at(numbers: &[u32], first: usize) -> Self {
        numbers[first]
    }
    #[inline]
    fn next(numbers: &mut Iter<'_, u32>) -> Option<Self> {
        numbers.next().copied()
    }
    #[inline]
    fn next_back(numbers: &mut Iter<'_, u32>) -> Option<Self> {
        numbers.next_back().copied()
    }
}

impl<P: Domain> Place for (u32, Ix<P>) {
    const NUMBERS: usize = 1 + P::Place::NUMBERS;
    #[inline]
    fn position(self) -> usize {
        self.0 as usize
    }
    #[inline]
    fn at(numbers: &[u32], first: usize) -> Self {
        (numbers[first], Ix::at(numbers, first + 1))
    }
    #[inline]
    fn next(numbers: &mut Iter<'_, u32>) -> Option<Self> {
        let position = *numbers.next()?;
        Some((position, Ix { place: P::Place::next(numbers)? }))
    }
    #[inline]
    fn next_back(numbers: &mut Iter<'_, u32>) -> Option<Self> {
        let larger = Ix { place: P::Place::next_back(numbers)? };
        Some((*numbers.next_back()?, larger))
    }
}

/// An element of the set `S`: a position that no other set's families accept.
///
/// Indices come from headers (`i in plants`) and closures (`sum(plants, |i| …)`). They can be
/// compared, and where the set is ordered, `t - 1` is a neighbour that may not exist: see
/// [`Shifted`].
#[derive(Clone, Copy)]
pub struct Ix<S: Domain> {
    place: S::Place,
}

impl<S: Domain> Ix<S> {
    /// Position in the set, counted from 0.
    #[inline]
    pub fn position(self) -> usize {
        self.place.position()
    }

    /// From the numbers that stand at `first`.
    #[inline]
    pub(super) fn at(numbers: &[u32], first: usize) -> Self {
        Ix { place: S::Place::at(numbers, first) }
    }
}

impl<S: Domain<Place = u32>> Ix<S> {
    /// The element at this position.
    #[doc(hidden)]
    #[inline]
    pub const fn new(position: u32) -> Self {
        Ix { place: position }
    }
}

impl<P: Domain, S: Domain<Place = (u32, Ix<P>)>> Ix<S> {
    /// The same element as an index of the larger set.
    #[inline]
    pub fn of_larger_set(self) -> Ix<P> {
        self.place.1
    }
}

impl<S: Domain> PartialEq for Ix<S> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.position() == other.position()
    }
}
impl<S: Domain> Eq for Ix<S> {}
impl<S: Domain> PartialOrd for Ix<S> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl<S: Domain> Ord for Ix<S> {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        self.position().cmp(&other.position())
    }
}
impl<S: Domain> Hash for Ix<S> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.position().hash(state);
    }
}
impl<S: Domain> fmt::Debug for Ix<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Ix({})", self.position())
    }
}

/// Indices out of a list, in its order.
#[derive(Clone, Debug)]
pub struct Listed<'a, S> {
    numbers: Iter<'a, u32>,
    domain: PhantomData<fn() -> S>,
}

impl<'a, S: Domain> Listed<'a, S> {
    #[inline]
    pub(super) fn new(numbers: &'a [u32]) -> Self {
        Listed { numbers: numbers.iter(), domain: PhantomData }
    }
}

impl<S: Domain> Iterator for Listed<'_, S> {
    type Item = Ix<S>;
    #[inline]
    fn next(&mut self) -> Option<Ix<S>> {
        S::Place::next(&mut self.numbers).map(|place| Ix { place })
    }
    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        let count = self.numbers.len() / S::Place::NUMBERS;
        (count, Some(count))
    }
}

impl<S: Domain> DoubleEndedIterator for Listed<'_, S> {
    #[inline]
    fn next_back(&mut self) -> Option<Ix<S>> {
        S::Place::next_back(&mut self.numbers).map(|place| Ix { place })
    }
}

impl<S: Domain> ExactSizeIterator for Listed<'_, S> {}

/// A neighbour of an element of an ordered set, `t - 1`, which may not exist.
#[derive(Clone, Copy, Debug)]
pub struct Shifted<S> {
    position: i64,
    set: PhantomData<fn() -> S>,
}

macro_rules! shift {
    ($Op:ident $op:ident $sign:tt) => {
        impl<S: Domain> $Op<i32> for Ix<S> {
            type Output = Shifted<S>;
            #[inline]
            fn $op(self, by: i32) -> Shifted<S> {
                let position = signed(self.position()) $sign i64::from(by);
                Shifted { position, set: PhantomData }
            }
        }
        impl<S: Domain> $Op<i32> for Shifted<S> {
            type Output = Shifted<S>;
            #[inline]
            fn $op(self, by: i32) -> Shifted<S> {
                Shifted { position: self.position $sign i64::from(by), set: self.set }
            }
        }
    };
}

shift!(Add add +);
shift!(Sub sub -);

/// An index that picks an element of `S`: an [`Ix`] of `S` itself or of a subset of it.
#[diagnostic::on_unimplemented(
    message = "expected an index of `{S}`, found `{Self}`",
    label = "not an index of `{S}`"
)]
pub trait Element<S: Domain>: Copy {
    /// Position in `S`, counted from 0.
    fn position_in(self) -> usize;
}

#[diagnostic::do_not_recommend]
impl<S: Domain> Element<S> for Ix<S> {
    #[inline]
    fn position_in(self) -> usize {
        self.position()
    }
}

/// An index or a neighbour that may not exist.
#[diagnostic::on_unimplemented(
    message = "expected an index of `{S}`, such as `t` or `t - 1`, found `{Self}`",
    label = "not an index of `{S}`"
)]
pub trait Near<S: Domain>: Copy {
    /// Position in `S`, counted from 0, possibly outside.
    fn position_near(self) -> i64;
}

#[diagnostic::do_not_recommend]
impl<S: Domain> Near<S> for Ix<S> {
    #[inline]
    fn position_near(self) -> i64 {
        signed(self.position())
    }
}

#[diagnostic::do_not_recommend]
impl<S: OrderedDomain> Near<S> for Shifted<S> {
    #[inline]
    fn position_near(self) -> i64 {
        self.position
    }
}

/// A value that may not exist: what `load.at(t - 1)` reads before the first element.
#[must_use = "say what stands in for a value that does not exist: `.or(value)`"]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Maybe<T>(pub(super) Option<T>);

impl<T> Maybe<T> {
    /// The value, or this one where it does not exist.
    #[inline]
    pub fn or(self, other: impl Into<T>) -> T {
        match self.0 {
            Some(value) => value,
            None => other.into(),
        }
    }
    /// Whether the value exists.
    pub fn exists(&self) -> bool {
        self.0.is_some()
    }
}

#[cfg(test)]
#[path = "ix_tests.rs"]
mod tests;
