//! [`Set`]: labels that index variables, equations and data.

use crate::error::{ModelError, nearest};
use std::collections::HashMap;
use std::sync::Arc;

/// An ordered set of labels with a name, cheap to clone.
///
/// ```
/// use mcp_core::Set;
/// let plants = Set::new("plants", ["seattle", "san-diego"])?;
/// assert_eq!(plants.len(), 2);
/// assert_eq!(plants.index_of("san-diego")?, 1);
/// assert_eq!(Set::count("firms", 3).label(0), "1");
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Set(Arc<SetData>);

#[derive(Debug, PartialEq, Eq)]
struct SetData {
    name: String,
    labels: Labels,
}

#[derive(Debug, PartialEq, Eq)]
enum Labels {
    Named(Vec<String>),
    /// `1`, `2`, …: a million elements need no million strings.
    Numbered(usize),
}

impl Set {
    /// A set with the given labels, in this order.
    ///
    /// # Errors
    /// [`ModelError::DuplicateLabel`].
    pub fn new<L: Into<String>>(
        name: impl Into<String>,
        labels: impl IntoIterator<Item = L>,
    ) -> Result<Self, ModelError> {
        let name = name.into();
        let labels: Vec<String> = labels.into_iter().map(Into::into).collect();
        let mut sorted: Vec<&str> = labels.iter().map(String::as_str).collect();
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(ModelError::DuplicateLabel { set: name, label: pair[0].to_owned() });
        }
        Ok(Set(Arc::new(SetData { name, labels: Labels::Named(labels) })))
    }

    /// The set `1, 2, …, n`.
    pub fn count(name: impl Into<String>, n: usize) -> Self {
        Set(Arc::new(SetData { name: name.into(), labels: Labels::Numbered(n) }))
    }

    /// Name of the set.
    pub fn name(&self) -> &str {
        &self.0.name
    }

    /// Whether the labels are `1`, `2`, ….
    pub(crate) fn is_numbered(&self) -> bool {
        matches!(self.0.labels, Labels::Numbered(_))
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        match &self.0.labels {
            Labels::Named(labels) => labels.len(),
            Labels::Numbered(n) => *n,
        }
    }

    /// Whether there are no elements.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether a label shows nothing.
    pub(crate) fn has_blank_label(&self) -> bool {
        match &self.0.labels {
            Labels::Named(labels) => labels.iter().any(|label| label.trim().is_empty()),
            Labels::Numbered(_) => false,
        }
    }

    /// Label of element `i`, counted from 0.
    ///
    /// # Panics
    /// If there is no element `i`.
    pub fn label(&self, i: usize) -> String {
        assert!(i < self.len(), "set `{}` has no element number {i}", self.name());
        match &self.0.labels {
            Labels::Named(labels) => labels[i].clone(),
            Labels::Numbered(_) => (i + 1).to_string(),
        }
    }

    /// All labels in order.
    pub fn labels(&self) -> impl Iterator<Item = String> + '_ {
        (0..self.len()).map(|i| self.label(i))
    }

    /// Position of a label, counted from 0. Searches a set of names from the front; among numbers
    /// the label says its position.
    ///
    /// # Errors
    /// [`ModelError::UnknownName`] with the nearest label.
    pub fn index_of(&self, label: &str) -> Result<usize, ModelError> {
        self.find(label).ok_or_else(|| ModelError::UnknownName {
            kind: "label",
            name: label.to_owned(),
            nearest: match &self.0.labels {
                Labels::Named(labels) => nearest(label, labels.iter().map(String::as_str)),
                Labels::Numbered(_) => None,
            },
        })
    }

    /// Position of a label, if the set has it.
    pub(crate) fn find(&self, label: &str) -> Option<usize> {
        match &self.0.labels {
            Labels::Named(labels) => labels.iter().position(|l| l == label),
            Labels::Numbered(n) => numbered(label, *n),
        }
    }

    /// For every element of this set its position in `other`, if it is there. Takes time
    /// proportional to both.
    pub(super) fn positions_in(&self, other: &Set) -> Vec<Option<usize>> {
        match (&self.0.labels, &other.0.labels) {
            (Labels::Named(own), Labels::Named(others)) => {
                let place: HashMap<&str, usize> =
                    others.iter().enumerate().map(|(k, label)| (label.as_str(), k)).collect();
                own.iter().map(|label| place.get(label.as_str()).copied()).collect()
            }
            (Labels::Named(own), Labels::Numbered(n)) => {
                own.iter().map(|label| numbered(label, *n)).collect()
            }
            (Labels::Numbered(n), Labels::Numbered(others)) => {
                (0..*n).map(|k| (k < *others).then_some(k)).collect()
            }
            (Labels::Numbered(n), Labels::Named(_)) => {
                let mut positions = vec![None; *n];
                for (k, own) in other.positions_in(self).into_iter().enumerate() {
                    if let Some(own) = own {
                        positions[own] = Some(k);
                    }
                }
                positions
            }
        }
    }
}

/// Position of a label among `1`, …, `n`. Only the way a number is written counts: not `01` or `+1`.
fn numbered(label: &str, n: usize) -> Option<usize> {
    let number: usize = label.parse().ok()?;
    let is_label = label.starts_with(|first: char| matches!(first, '1'..='9')) && number <= n;
    is_label.then(|| number - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_must_differ() {
        let error = Set::new("plants", ["a", "b", "a"]).unwrap_err();
        assert_eq!(error.to_string(), "set `plants` has the label `a` twice");
    }

    #[test]
    fn an_unknown_label_is_answered_with_the_nearest() {
        let set = Set::new("plants", ["seattle", "san-diego"]).unwrap();
        let error = set.index_of("seatle").unwrap_err();
        assert_eq!(error.to_string(), "there is no label `seatle`; did you mean `seattle`?");
    }

    #[test]
    fn numbered_labels_are_found_only_as_they_are_written() {
        let set = Set::count("firms", 12);
        for (i, label) in set.labels().enumerate() {
            assert_eq!(set.index_of(&label), Ok(i));
        }
        for label in ["0", "13", "01", "+1", "-1", "", "one", "1.0", "99999999999999999999999"] {
            let error = set.index_of(label).unwrap_err();
            assert_eq!(error.to_string(), format!("there is no label `{label}`"));
        }
        let many = Set::count("points", 1_000_000_000);
        assert_eq!(many.index_of("1000000000"), Ok(999_999_999));
    }

    #[test]
    fn positions_in_another_set_follow_the_labels() {
        let named = Set::new("a", ["3", "x", "1", "01"]).unwrap();
        let other = Set::new("b", ["x", "y", "3"]).unwrap();
        let numbered = Set::count("c", 3);
        assert_eq!(named.positions_in(&other), [Some(2), Some(0), None, None]);
        assert_eq!(named.positions_in(&numbered), [Some(2), None, Some(0), None]);
        assert_eq!(numbered.positions_in(&named), [Some(2), None, Some(0)]);
        assert_eq!(Set::count("d", 4).positions_in(&numbered), [Some(0), Some(1), Some(2), None]);
    }
}
