//! [`Set`]: labels that index variables, equations and data.

use crate::error::{ModelError, nearest};
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

    /// Position of a label, counted from 0.
    ///
    /// # Errors
    /// [`ModelError::UnknownName`] with the nearest label.
    pub fn index_of(&self, label: &str) -> Result<usize, ModelError> {
        self.labels().position(|l| l == label).ok_or_else(|| {
            let labels: Vec<String> = self.labels().collect();
            ModelError::UnknownName {
                kind: "label",
                name: label.to_owned(),
                nearest: nearest(label, labels.iter().map(String::as_str)),
            }
        })
    }
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
}
