//! Families: variables, equations, definitions and parameters that share a name and index sets.

use super::Set;
use crate::error::ModelError;
use std::sync::Arc;

/// Elements a family may have: places of structural nonzeros are 32-bit numbers.
pub(crate) const MOST_ELEMENTS: usize = 1 << 31;

/// Number of combinations of these sets, unless there are more than a family may have.
pub(crate) fn combinations(sets: &[&Set]) -> Option<usize> {
    let count = sets.iter().try_fold(1_usize, |count, set| count.checked_mul(set.len()));
    count.filter(|&count| count <= MOST_ELEMENTS)
}

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
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Family {
    pub(super) name: String,
    pub(super) sets: Vec<Set>,
    pub(super) offset: usize,
    /// Number under which the model computes the elements; chosen when the shape is built.
    pub(super) entry: Option<usize>,
    pub(super) len: usize,
    /// Combinations of the sets' elements, `usize::MAX` if they are too many to count.
    pub(super) combinations: usize,
    /// The combinations that exist, increasing; `None` if all do.
    pub(super) elements: Option<Arc<[usize]>>,
    /// Whether an element is called by its label alone.
    pub(super) is_labelled: bool,
    pub(super) about: String,
    pub(super) unit: String,
}

impl Family {
    pub(super) fn new(name: String) -> Self {
        let (about, unit) = (String::new(), String::new());
        let (sets, elements, entry, is_labelled) = (Vec::new(), None, None, false);
        let (offset, len, combinations) = (0, 1, 1);
        Family { name, sets, offset, entry, len, combinations, elements, is_labelled, about, unit }
    }

    /// The family of element `k` of all elements of the families, and its index there.
    pub(crate) fn of_element(families: &[Family], k: usize) -> (&Family, usize) {
        let family = &families[families.partition_point(|f| f.offset + f.len <= k)];
        (family, k - family.offset)
    }

    /// The elements of a table.
    pub(crate) fn of_table(name: &str, sets: &[&Set]) -> Self {
        let mut family = Family::new(name.to_owned());
        family.over(sets);
        family
    }

    /// Whether both have the same name and the same elements, under the same labels.
    pub(crate) fn has_elements_of(&self, other: &Family) -> bool {
        self.name == other.name && self.sets == other.sets && self.elements == other.elements
    }

    pub(super) fn over(&mut self, sets: &[&Set]) {
        self.sets = sets.iter().map(|&set| set.clone()).collect();
        // Too many elements are an error when the shape is built.
        self.combinations =
            self.sets.iter().fold(1, |product: usize, set| product.saturating_mul(set.len()));
        self.count();
    }

    pub(super) fn labelled(&mut self, set: &Set) {
        self.over(&[set]);
        self.is_labelled = true;
    }

    pub(super) fn only(&mut self, elements: Vec<usize>) {
        self.elements = Some(elements.into());
        self.count();
    }

    fn count(&mut self) {
        self.len = self.elements.as_ref().map_or(self.combinations, |elements| elements.len());
    }

    /// Checks the number of elements and which of them exist; a list of all is no list.
    pub(super) fn check_elements(&mut self) -> Result<(), ModelError> {
        if self.len > MOST_ELEMENTS || self.combinations == usize::MAX {
            return Err(ModelError::TooManyElements { name: self.name.clone() });
        }
        let Some(elements) = &self.elements else { return Ok(()) };
        let count = self.combinations;
        if let Some(&element) = elements.iter().find(|&&element| element >= count) {
            return Err(ModelError::ElementOutOfRange { name: self.name.clone(), element, count });
        }
        if let Some(pair) = elements.windows(2).find(|pair| pair[0] >= pair[1]) {
            let (name, element, before) = (self.name.clone(), pair[1], pair[0]);
            return Err(ModelError::ElementOrder { name, element, before });
        }
        if elements.len() == count {
            self.elements = None;
        }
        Ok(())
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
    /// The number that stands for the family in calls of [`Model::row`](crate::Model::row),
    /// [`def`](crate::Model::def) and [`report`](crate::Model::report): its place in the order of
    /// declaration, unless parts of a model are off or add terms to it.
    pub fn entry(&self) -> usize {
        self.entry.unwrap_or_default()
    }
    /// Number of elements that exist.
    pub fn len(&self) -> usize {
        self.len
    }
    /// Whether only some of the combinations of the index sets exist.
    pub fn is_sparse(&self) -> bool {
        self.elements.is_some()
    }
    /// The combinations that exist, increasing, where not all do.
    pub fn elements(&self) -> Option<&[usize]> {
        self.elements.as_deref()
    }
    /// Number of combinations of the elements of the index sets, existing or not.
    pub fn combinations(&self) -> usize {
        self.combinations
    }
    /// Number in the family of combination `k` of the index sets, counted with the last index
    /// fastest; `None` if it does not exist. Takes a binary search where the family is sparse.
    ///
    /// ```
    /// # use mcp_core::{Block, Equation, Set, Shape, Variable};
    /// let cities = Set::new("cities", ["a", "b", "c"])?;
    /// let roads = [1, 5]; // a–b and b–c of the nine pairs
    /// let shape = Shape::builder()
    ///     .variable(Variable::new("flow").over(&[&cities, &cities]).only(roads))
    ///     .equation(Equation::new("cost").over(&[&cities, &cities]).only(roads).complements("flow"))
    ///     .build()?;
    /// let flow = shape.variable("flow")?;
    /// let pairs = Block::new(0, [3, 3]);
    /// assert_eq!((flow.len(), flow.element_name(1)), (2, "flow[b, c]".to_owned()));
    /// assert_eq!(flow.position(pairs.at([1, 2])), Some(1));
    /// assert_eq!(flow.position(pairs.at([0, 2])), None);
    /// assert_eq!(pairs.split(flow.combination(1)), [1, 2]);
    /// # Ok::<(), mcp_core::ModelError>(())
    /// ```
    pub fn position(&self, k: usize) -> Option<usize> {
        match &self.elements {
            None => (k < self.len).then_some(k),
            Some(elements) => elements.binary_search(&k).ok(),
        }
    }
    /// The combination of the index sets that element `index` stands for, counted with the last
    /// index fastest: the inverse of [`position`](Self::position).
    ///
    /// # Panics
    /// If the family is sparse and has no element `index`.
    pub fn combination(&self, index: usize) -> usize {
        self.elements.as_ref().map_or(index, |elements| elements[index])
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

    /// Name of element `index` of the family, such as `x[seattle, topeka]`, made on demand; in a
    /// [labelled](crate::Variable::labelled) family the label.
    ///
    /// # Panics
    /// If the family is sparse and has no element `index`.
    pub fn element_name(&self, index: usize) -> String {
        self.combination_name(self.combination(index))
    }

    /// Name of a combination, existing or not.
    pub(super) fn combination_name(&self, k: usize) -> String {
        if self.sets.is_empty() {
            return self.name.clone();
        }
        if self.is_labelled {
            return self.sets[0].label(k);
        }
        format!("{}[{}]", self.name, self.labels_of_combination(k).join(", "))
    }

    /// Labels of element `index`, one for each index set.
    pub fn labels_of(&self, index: usize) -> Vec<String> {
        self.labels_of_combination(self.combination(index))
    }

    fn labels_of_combination(&self, k: usize) -> Vec<String> {
        let mut labels = Vec::with_capacity(self.sets.len());
        let mut rest = k;
        for set in self.sets.iter().rev() {
            labels.push(set.label(rest % set.len()));
            rest /= set.len();
        }
        labels.reverse();
        labels
    }

    /// Where the elements stand, for reading them by index: see [`Block`]. For families with all
    /// combinations of their sets; a sparse one is read through [`position`](Self::position).
    ///
    /// # Panics
    /// If the family does not have `R` index sets or is sparse.
    pub fn block<const R: usize>(&self) -> Block<R> {
        assert!(!self.is_sparse(), "`{}` has only some elements: a block needs all", self.name);
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
    pub const fn new(offset: usize, lengths: [usize; R]) -> Self {
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

    /// A family over 2 plants and 3 numbered markets with these elements.
    fn sparse(elements: &[usize]) -> Family {
        let plants = Set::new("plants", ["seattle", "san-diego"]).unwrap();
        let mut family = Family::new("x".to_owned());
        family.only(elements.to_vec());
        family.over(&[&plants, &Set::count("markets", 3)]);
        family
    }

    #[test]
    fn a_sparse_family_counts_names_and_finds_only_what_exists() {
        let mut family = sparse(&[0, 2, 4]);
        family.check_elements().unwrap();
        assert_eq!((family.len(), family.combinations(), family.is_sparse()), (3, 6, true));
        let names: Vec<String> = (0..3).map(|k| family.element_name(k)).collect();
        assert_eq!(names, ["x[seattle, 1]", "x[seattle, 3]", "x[san-diego, 2]"]);
        let positions: Vec<_> = (0..7).map(|k| family.position(k)).collect();
        assert_eq!(positions, [Some(0), None, Some(1), None, Some(2), None, None]);
        assert!((0..3).all(|k| family.position(family.combination(k)) == Some(k)));
    }

    #[test]
    fn a_list_of_all_elements_is_no_list_and_one_of_none_is_empty() {
        let mut all = sparse(&[0, 1, 2, 3, 4, 5]);
        all.check_elements().unwrap();
        assert!(!all.is_sparse());
        assert_eq!(all.block::<2>().at([1, 2]), 5);
        let mut none = sparse(&[]);
        none.check_elements().unwrap();
        assert!(none.is_empty() && none.is_sparse() && none.position(0).is_none());
    }

    #[test]
    fn elements_of_a_labelled_family_are_called_as_their_labels() {
        let columns = Set::new("columns", ["x['a','b']", "p"]).unwrap();
        let mut family = Family::new("column".to_owned());
        family.labelled(&columns);
        family.only(vec![1]);
        assert_eq!((family.len(), family.element_name(0)), (1, "p".to_owned()));
    }

    #[test]
    #[should_panic(expected = "`x` has only some elements: a block needs all")]
    fn a_sparse_family_has_no_block() {
        let _ = sparse(&[0]).block::<2>();
    }

    #[test]
    fn lists_out_of_range_out_of_order_or_with_repetitions_are_refused() {
        let message =
            |elements: &[usize]| sparse(elements).check_elements().unwrap_err().to_string();
        assert_eq!(message(&[0, 6]), "`x` is to have element 6, but its sets combine to only 6");
        assert_eq!(message(&[2, 1]), "the elements of `x` do not increase: 1 follows 2");
        assert_eq!(message(&[0, 3, 3]), "the elements of `x` do not increase: 3 follows 3");
    }

    #[test]
    fn sets_with_too_many_combinations_to_count_are_refused_whatever_exists() {
        let many = Set::count("many", usize::MAX / 2);
        let mut family = Family::new("x".to_owned());
        family.over(&[&many, &many]);
        family.only(vec![0]);
        assert_eq!(
            family.check_elements().unwrap_err().to_string(),
            "`x` has more than 2^31 elements"
        );
    }

    #[test]
    fn at_and_split_are_inverse() {
        let block = Block::new(7, [3, 4, 5]);
        for index in 0..60 {
            assert_eq!(block.at(block.split(index)), 7 + index);
        }
    }
}
