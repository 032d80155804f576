//! Families: variables, equations, definitions and parameters that share a name and index sets.

use super::Set;

/// One value for all elements of a family, or one for each.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// The same value for every element.
    Same(f64),
    /// One value for each element, in the family's order (last index fastest).
    Each(Vec<f64>),
}

impl From<f64> for Values {
    fn from(value: f64) -> Self {
        Values::Same(value)
    }
}

impl From<Vec<f64>> for Values {
    fn from(values: Vec<f64>) -> Self {
        Values::Each(values)
    }
}

impl From<&[f64]> for Values {
    fn from(values: &[f64]) -> Self {
        Values::Each(values.to_vec())
    }
}

impl<const N: usize> From<[f64; N]> for Values {
    fn from(values: [f64; N]) -> Self {
        Values::Each(values.to_vec())
    }
}

/// A name, the sets its elements are indexed by, and where they stand among their kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Family {
    pub(super) name: String,
    pub(super) sets: Vec<Set>,
    pub(super) offset: usize,
    pub(super) len: usize,
    pub(super) about: String,
    pub(super) unit: String,
}

impl Family {
    pub(super) fn new(name: String) -> Self {
        let (about, unit) = (String::new(), String::new());
        Family { name, sets: Vec::new(), offset: 0, len: 1, about, unit }
    }

    pub(super) fn over(&mut self, sets: &[&Set]) {
        self.sets = sets.iter().map(|&set| set.clone()).collect();
        // Too many elements are an error when the shape is built.
        self.len =
            self.sets.iter().fold(1, |product: usize, set| product.saturating_mul(set.len()));
    }

    /// Name of the family.
    pub fn name(&self) -> &str {
        &self.name
    }
    /// Index sets; empty for a single element.
    pub fn sets(&self) -> &[Set] {
        &self.sets
    }
    /// Number of the first element among all of its kind.
    pub fn offset(&self) -> usize {
        self.offset
    }
    /// Number of elements.
    pub fn len(&self) -> usize {
        self.len
    }
    /// Whether there are no elements.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }
    /// One line of explanation, possibly empty.
    pub fn about(&self) -> &str {
        &self.about
    }
    /// Unit of measure, possibly empty.
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// Name of element `index` of the family, such as `x[seattle, topeka]`, made on demand.
    pub fn element_name(&self, index: usize) -> String {
        if self.sets.is_empty() {
            return self.name.clone();
        }
        let mut labels = Vec::with_capacity(self.sets.len());
        let mut rest = index;
        for set in self.sets.iter().rev() {
            labels.push(set.label(rest % set.len()));
            rest /= set.len();
        }
        labels.reverse();
        format!("{}[{}]", self.name, labels.join(", "))
    }

    /// Where the elements stand, for reading them by index: see [`Block`].
    ///
    /// # Panics
    /// If the family does not have `R` index sets.
    pub fn block<const R: usize>(&self) -> Block<R> {
        let lengths: Vec<usize> = self.sets.iter().map(Set::len).collect();
        let lengths = <[usize; R]>::try_from(lengths)
            .unwrap_or_else(|found| panic!("`{}` has {} indices, not {R}", self.name, found.len()));
        Block { offset: self.offset, lengths }
    }
}

/// Position arithmetic of a family with `R` index sets; the last index runs fastest.
///
/// ```
/// # use mcp_core::{Block};
/// let x = Block::new(10, [2, 3]);
/// assert_eq!(x.at([1, 2]), 15);
/// assert_eq!(x.split(5), [1, 2]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block<const R: usize> {
    offset: usize,
    lengths: [usize; R],
}

impl<const R: usize> Block<R> {
    /// A block that starts at `offset`.
    pub fn new(offset: usize, lengths: [usize; R]) -> Self {
        Block { offset, lengths }
    }

    /// Number of the element with these indices among all of its kind.
    #[inline]
    pub fn at(&self, index: [usize; R]) -> usize {
        let mut position = 0;
        for (&i, &len) in index.iter().zip(&self.lengths) {
            debug_assert!(i < len, "index {i} of a set with {len} elements");
            position = position * len + i;
        }
        self.offset + position
    }

    /// The indices of element `index` of the family.
    #[inline]
    pub fn split(&self, index: usize) -> [usize; R] {
        let mut split = [0; R];
        let mut rest = index;
        for (i, &len) in split.iter_mut().zip(&self.lengths).rev() {
            *i = rest % len;
            rest /= len;
        }
        split
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn element_names_show_all_labels() {
        let plants = Set::new("plants", ["seattle", "san-diego"]).unwrap();
        let mut family = Family::new("x".to_owned());
        family.over(&[&plants, &Set::count("markets", 3)]);
        assert_eq!(family.element_name(4), "x[san-diego, 2]");
        assert_eq!(Family::new("p".to_owned()).element_name(0), "p");
    }

    #[test]
    fn at_and_split_are_inverse() {
        let block = Block::new(7, [3, 4, 5]);
        for index in 0..60 {
            assert_eq!(block.at(block.split(index)), 7 + index);
        }
    }
}
