//! [`Positions`]: from labels to their places in a set, and names of elements.

use super::{DataError, Place};
use crate::Set;
use crate::error::nearest;
use crate::model::Family;
use std::collections::HashMap;

/// Where each label of a set stands: made once, then each look-up takes constant time. A numbered set
/// knows by itself.
pub(super) struct Positions<'a> {
    set: &'a Set,
    of: Option<HashMap<String, usize>>,
}

impl<'a> Positions<'a> {
    pub(super) fn new(set: &'a Set) -> Self {
        let of = (!set.is_numbered()).then(|| set.labels().zip(0..).collect());
        Positions { set, of }
    }

    /// Number of labels.
    pub(super) fn len(&self) -> usize {
        self.set.len()
    }

    pub(super) fn get(&self, label: &str) -> Option<usize> {
        match &self.of {
            Some(of) => of.get(label).copied(),
            None => self.set.find(label),
        }
    }

    /// Position of a label that `data` names in a line of a file, or in the program.
    pub(super) fn find(
        &self,
        data: &str,
        label: &str,
        file: Option<&str>,
        line: Option<u64>,
    ) -> Result<usize, DataError> {
        self.get(label).ok_or_else(|| self.unknown(data, label, Place::of(file, line)))
    }

    fn unknown(&self, data: &str, label: &str, place: Option<Box<Place>>) -> DataError {
        let named = self.of.as_ref().map(|_| self.set.labels().collect());
        let labels: Vec<String> = named.unwrap_or_default();
        DataError::UnknownLabel {
            data: data.to_owned(),
            set: self.set.name().to_owned(),
            label: label.to_owned(),
            nearest: nearest(label, labels.iter().map(String::as_str)),
            place,
        }
    }
}

/// Name of an element, such as `cost[seattle, topeka]`.
pub(super) fn key_name<L: AsRef<str>>(data: &str, labels: &[L]) -> String {
    if labels.is_empty() {
        return data.to_owned();
    }
    let labels: Vec<&str> = labels.iter().map(AsRef::as_ref).collect();
    format!("{data}[{}]", labels.join(", "))
}

/// Name of the element at a position, the last index running fastest.
pub(super) fn element_name(data: &str, sets: &[&Set], position: usize) -> String {
    Family::of_table(data, sets).element_name(position)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_are_named_by_their_labels() {
        let plants = Set::new("plants", ["seattle", "san-diego"]).unwrap();
        let markets = Set::count("markets", 3);
        assert_eq!(element_name("x", &[&plants, &markets], 4), "x[san-diego, 2]");
        assert_eq!(element_name("eta", &[], 0), "eta");
    }

    #[test]
    fn an_unknown_label_is_answered_with_the_nearest() {
        let plants = Set::new("plants", ["seattle", "san-diego"]).unwrap();
        let positions = Positions::new(&plants);
        assert_eq!(positions.find("cost", "san-diego", None, None), Ok(1));
        let told = |label| positions.find("cost", label, None, None).unwrap_err().to_string();
        assert_eq!(
            told("seatle"),
            "`cost` names `seatle`, which is no label of `plants`; did you mean `seattle`?"
        );
        assert_eq!(told("berlin"), "`cost` names `berlin`, which is no label of `plants`");
    }
}
