//! [`Layout`]: a family without its index types. Not generic, so that it is compiled once and not
//! with every model.

use super::assemble::Each;
use super::ix::narrow;
use crate::error::ModelError;
use crate::model::{Asked, Reader, Set, combinations};
use crate::scalar::{Real, Scalar};

/// Most index sets of one family.
pub(super) const MOST_SETS: usize = 6;

/// A combination of indices for which there is no element.
const ABSENT: u32 = u32::MAX;

/// The positions that make a combination, 0 behind the last.
pub type At = [usize; MOST_SETS];

/// Where the elements of a family stand, one for each combination, the last index running fastest.
///
/// There is nothing to drop: a model has many.
#[derive(Clone, Debug)]
pub struct Layout {
    pub(super) lengths: At,
    /// Number of the first element among all of its kind.
    pub(super) offset: usize,
    /// Number of elements.
    pub(super) count: usize,
}

/// A family of which some combinations may have no element.
#[derive(Clone, Debug)]
pub struct Sparse {
    pub(super) layout: Layout,
    /// The place of every combination, [`ABSENT`] where there is none, and behind them the
    /// combination of every element; nothing if every combination has one.
    places: Vec<u32>,
}

/// A family with a value for every combination.
#[derive(Clone, Debug)]
pub struct Filled {
    pub(super) layout: Layout,
    values: Vec<f64>,
}

/// What [`Assembly`](super::Assembly) makes of a family: its elements, and data with their values.
#[derive(Clone, Debug)]
pub struct Made {
    pub(super) elements: Sparse,
    pub(super) values: Vec<f64>,
}

/// A family of a model, which takes what was made in the place of an empty one.
pub trait Family {
    /// Takes it.
    fn take(&mut self, made: Made);
}

impl Family for Layout {
    fn take(&mut self, made: Made) {
        debug_assert!(!made.elements.is_sparse(), "without condition every combination exists");
        *self = made.elements.layout;
    }
}
impl Family for Sparse {
    fn take(&mut self, made: Made) {
        *self = made.elements;
    }
}
impl Family for Filled {
    fn take(&mut self, made: Made) {
        *self = Filled { layout: made.elements.layout, values: made.values };
    }
}

/// A family of variables or rows, with all combinations or some.
pub trait Elements {
    /// No element.
    const EMPTY: Self;
    /// All combinations.
    fn layout(&self) -> &Layout;
    /// Number of elements.
    fn count(&self) -> usize {
        self.layout().count
    }
    /// Place of a combination in the family, if it has one.
    fn place(&self, dense: usize) -> Option<usize>;
    /// The positions of an element's indices in their sets.
    fn split(&self, row: usize) -> At;
    /// The variable of a combination; 0 if its condition does not hold. With lanes by a call, as
    /// every place that reads a variable would otherwise be compiled with all sources.
    fn variable<D: Scalar>(&self, read: &Reader<'_, D>, dense: usize) -> Real<D>;
}

impl Layout {
    /// A family with all combinations of its sets.
    ///
    /// # Errors
    /// [`ModelError::TooManyElements`] for more than 2³¹ combinations.
    pub fn new(family: &str, sets: &[&Set]) -> Result<Self, ModelError> {
        let mut lengths = [1; MOST_SETS];
        for (length, set) in lengths.iter_mut().zip(sets) {
            *length = set.len();
        }
        match combinations(sets) {
            Some(count) => Ok(Layout { lengths, offset: 0, count }),
            None => Err(ModelError::TooManyElements { name: family.to_owned() }),
        }
    }
}

impl Elements for Layout {
    const EMPTY: Self = Layout { lengths: [1; MOST_SETS], offset: 0, count: 0 };

    #[inline]
    fn layout(&self) -> &Layout {
        self
    }
    #[inline]
    fn place(&self, dense: usize) -> Option<usize> {
        Some(dense)
    }
    fn split(&self, row: usize) -> At {
        let (mut positions, mut rest) = ([0; MOST_SETS], row);
        for (position, &length) in positions.iter_mut().zip(&self.lengths).rev() {
            if length > 1 {
                (*position, rest) = (rest % length, rest / length);
            }
        }
        positions
    }
    #[inline]
    fn variable<D: Scalar>(&self, read: &Reader<'_, D>, dense: usize) -> Real<D> {
        read.row(Asked::Variable, self.offset + dense)
    }
}

impl Sparse {
    /// All combinations, or only some of them, in order.
    pub(super) fn new(layout: Layout, members: Option<&[usize]>) -> Self {
        let mut sparse = Sparse { layout, places: Vec::new() };
        if let Some(members) = members {
            sparse.places = vec![ABSENT; sparse.layout.count];
            for (place, &dense) in members.iter().enumerate() {
                sparse.places[dense] = narrow(place);
            }
            sparse.places.extend(members.iter().map(|&dense| narrow(dense)));
            sparse.layout.count = members.len();
        }
        sparse
    }

    fn is_sparse(&self) -> bool {
        !self.places.is_empty()
    }

    /// Combinations of the elements, unless there is an element for each.
    #[cfg(test)]
    pub(super) fn members(&self) -> Option<Vec<usize>> {
        let members = || self.places[self.places.len() - self.layout.count..].iter();
        self.is_sparse().then(|| members().map(|&dense| dense as usize).collect())
    }

    /// One value for each element.
    pub(super) fn each(&self, each: Each<'_>) -> Vec<f64> {
        (0..self.layout.count).map(|row| each.value(&self.split(row))).collect()
    }

    #[inline(never)]
    pub(super) fn variable_apart<D: Scalar>(&self, read: &Reader<'_, D>, dense: usize) -> Real<D> {
        match self.place(dense) {
            Some(place) => read.var(self.layout.offset + place),
            None => Real::from(0.0),
        }
    }
}

impl Elements for Sparse {
    const EMPTY: Self = Sparse { layout: Layout::EMPTY, places: Vec::new() };

    #[inline]
    fn layout(&self) -> &Layout {
        &self.layout
    }
    fn place(&self, dense: usize) -> Option<usize> {
        if !self.is_sparse() {
            return Some(dense);
        }
        Some(self.places[dense]).filter(|&place| place != ABSENT).map(|place| place as usize)
    }
    fn split(&self, row: usize) -> At {
        let dense = if self.is_sparse() {
            self.places[self.places.len() - self.layout.count + row] as usize
        } else {
            row
        };
        self.layout.split(dense)
    }
    #[inline]
    fn variable<D: Scalar>(&self, read: &Reader<'_, D>, dense: usize) -> Real<D> {
        self.variable_apart(read, dense)
    }
}

impl Filled {
    /// No element.
    pub(super) const EMPTY: Self = Filled { layout: Layout::EMPTY, values: Vec::new() };

    /// The value of every combination.
    #[inline]
    pub fn values(&self) -> &[f64] {
        &self.values
    }
}

impl Made {
    pub(super) const EMPTY: Self = Made { elements: Sparse::EMPTY, values: Vec::new() };
}

impl From<Layout> for Made {
    fn from(layout: Layout) -> Self {
        Sparse::new(layout, None).into()
    }
}

impl From<Sparse> for Made {
    fn from(elements: Sparse) -> Self {
        Made { elements, values: Vec::new() }
    }
}
