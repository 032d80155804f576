//! [`Layout`]: a family without its index types. Not generic, so that it is compiled once and not
//! with every model.

use super::ix::narrow;
use crate::error::ModelError;
use crate::model::{Set, combinations};

/// Most index sets of one family.
pub(super) const MOST_SETS: usize = 6;

/// A combination of indices for which there is no element.
const ABSENT: u32 = u32::MAX;

/// The positions that make a combination, 0 behind the last.
pub type At = [usize; MOST_SETS];

/// Where the elements of a family stand, the last index running fastest, and what is known of them.
///
/// Dropped in a few instructions, none of which can fail, since a model has many.
#[derive(Clone, Debug)]
pub struct Layout {
    pub(super) lengths: At,
    /// Number of the first element among all of its kind.
    pub(super) offset: usize,
    /// Number of elements that exist.
    pub(super) count: usize,
    /// Whether some combinations have no element.
    pub(super) is_sparse: bool,
    /// Data: the value of every combination.
    values: Vec<f64>,
    /// For a family with conditions: the place of every combination, [`ABSENT`] where there is none,
    /// and behind them the combination of every element.
    places: Vec<u32>,
}

impl Layout {
    /// No element.
    pub(super) const EMPTY: Layout = Layout {
        lengths: [1; MOST_SETS],
        offset: 0,
        count: 0,
        is_sparse: false,
        values: Vec::new(),
        places: Vec::new(),
    };

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
            Some(count) => Ok(Layout { lengths, count, ..Layout::EMPTY }),
            None => Err(ModelError::TooManyElements { name: family.to_owned() }),
        }
    }

    /// Takes the place of an empty layout, so that a model need not drop that one itself.
    pub fn set(&mut self, made: Layout) {
        *self = made;
    }

    /// The same with only some of the combinations, in order.
    pub(super) fn only(mut self, members: &[usize]) -> Self {
        let mut places = vec![ABSENT; self.combinations()];
        for (place, &dense) in members.iter().enumerate() {
            places[dense] = narrow(place);
        }
        places.extend(members.iter().map(|&dense| narrow(dense)));
        (self.is_sparse, self.count, self.places) = (true, members.len(), places);
        self
    }

    /// The same with values of all combinations.
    pub(super) fn with_values(mut self, values: Vec<f64>) -> Self {
        self.values = values;
        self
    }

    /// Number of combinations, with an element or without.
    fn combinations(&self) -> usize {
        self.lengths.iter().product()
    }

    /// Combinations of the elements, unless there is an element for each.
    #[cfg(test)]
    pub(super) fn members(&self) -> Option<Vec<usize>> {
        let members = || self.places[self.combinations()..].iter();
        self.is_sparse.then(|| members().map(|&dense| dense as usize).collect())
    }

    /// Data: the value of every combination.
    #[inline]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// One value for each element.
    pub fn each(&self, value: &mut dyn FnMut(&At) -> f64) -> Vec<f64> {
        (0..self.count).map(|row| value(&self.split(row))).collect()
    }

    /// The positions of an element's indices in their sets.
    pub(super) fn split(&self, row: usize) -> At {
        let mut positions = [0; MOST_SETS];
        let mut rest = if self.is_sparse {
            self.places[self.places.len() - self.count + row] as usize
        } else {
            row
        };
        for (position, &length) in positions.iter_mut().zip(&self.lengths).rev() {
            if length > 1 {
                (*position, rest) = (rest % length, rest / length);
            }
        }
        positions
    }

    /// Place of a combination in the family, if it has one.
    #[inline]
    pub(super) fn place(&self, dense: usize) -> Option<usize> {
        if self.is_sparse { self.sparse_place(dense) } else { Some(dense) }
    }

    fn sparse_place(&self, dense: usize) -> Option<usize> {
        Some(self.places[dense]).filter(|&place| place != ABSENT).map(|place| place as usize)
    }
}
