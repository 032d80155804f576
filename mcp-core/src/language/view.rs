//! [`Levels`]: the numbers of a solution, read by the labels of the model's sets.

use crate::error::ModelError;
use crate::model::{Family, Set};
use crate::problem::{Derived, PlainModel};
use crate::solver::Solution;
use std::array::from_fn;
use std::ops::{Deref, Index};
use std::sync::Arc;

/// One label for each of `R` index sets: `"topeka"`, or `("seattle", "topeka")`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not name an element of a family with {R} index sets",
    label = "expected one label for each index set",
    note = "one index set: `view.p[\"topeka\"]`; two: `view.x[(\"seattle\", \"topeka\")]`"
)]
pub trait Key<const R: usize> {
    /// The labels in the order of the sets.
    fn labels(&self) -> [&str; R];
}

impl Key<1> for &str {
    fn labels(&self) -> [&str; 1] {
        [self]
    }
}

impl Key<1> for &String {
    fn labels(&self) -> [&str; 1] {
        [self]
    }
}

macro_rules! key {
    ($($rank:literal: $($L:ident $label:ident),*;)*) => { $(
        impl<$($L: AsRef<str>),*> Key<$rank> for ($($L,)*) {
            fn labels(&self) -> [&str; $rank] {
                let ($($label,)*) = self;
                [$($label.as_ref()),*]
            }
        }
    )* };
}

key! {
    1: A a;
    2: A a, B b;
    3: A a, B b, C c;
    4: A a, B b, C c, D d;
    5: A a, B b, C c, D d, E e;
    6: A a, B b, C c, D d, E e, F f;
}

impl<const R: usize, L: AsRef<str>> Key<R> for [L; R] {
    fn labels(&self) -> [&str; R] {
        from_fn(|k| self[k].as_ref())
    }
}

/// Numbers of a family with `R` index sets, one for each element.
///
/// Read one with brackets, `view.p["topeka"]`, or all with their labels:
///
/// ```
/// # use mcp_core::language::Levels;
/// fn total(x: &Levels<2>) -> f64 {
///     x.iter().filter(|([_plant, market], _)| market == "topeka").map(|(_, level)| level).sum()
/// }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Levels<const R: usize>(#[doc(hidden)] pub Arc<Numbers>);

/// What [`Levels`] and [`VariableLevels`] show; shared, so that a view is dropped in a few
/// instructions for each family.
#[doc(hidden)]
#[derive(Debug, PartialEq)]
pub struct Numbers {
    family: Family,
    values: Vec<f64>,
    /// Of a variable family.
    marginals: Vec<f64>,
    /// The part that it belongs to, where that is off.
    off: Option<String>,
}

impl<const R: usize> Levels<R> {
    /// Number of elements.
    pub fn len(&self) -> usize {
        self.0.values.len()
    }
    /// Whether there are no elements.
    pub fn is_empty(&self) -> bool {
        self.0.values.is_empty()
    }
    /// All values in the order of the sets, last index fastest.
    pub fn values(&self) -> &[f64] {
        &self.0.values
    }
    /// The value of the element with these labels.
    ///
    /// # Errors
    /// [`ModelError::UnknownName`] with the nearest label, or for a combination that does not
    /// exist; [`ModelError::PartOff`] for a family of a part that is off.
    #[allow(clippy::needless_pass_by_value, reason = "labels are written in place")]
    pub fn get(&self, key: impl Key<R>) -> Result<f64, ModelError> {
        Ok(self.0.values[self.0.index_of(&key.labels())?])
    }
    /// Labels and value of every element.
    pub fn iter(&self) -> impl Iterator<Item = ([String; R], f64)> + '_ {
        let labels = |k| {
            let mut labels = self.0.family.labels_of(k).into_iter();
            from_fn(|_| labels.next().unwrap_or_default())
        };
        self.0.values.iter().enumerate().map(move |(k, &value)| (labels(k), value))
    }
}

impl<const R: usize, K: Key<R>> Index<K> for Levels<R> {
    type Output = f64;

    /// # Panics
    /// If there is no element with these labels; [`get`](Levels::get) returns an error instead.
    fn index(&self, key: K) -> &f64 {
        match self.0.index_of(&key.labels()) {
            Ok(index) => &self.0.values[index],
            Err(error) => panic!("{}: {error}", self.0.family.name()),
        }
    }
}

/// Levels of a variable family, and its marginals: `F` of the paired equations.
#[derive(Clone, Debug, PartialEq)]
pub struct VariableLevels<const R: usize>(#[doc(hidden)] pub Levels<R>);

impl<const R: usize> VariableLevels<R> {
    /// `F` of the equation paired with the element with these labels; 0 between the bounds.
    ///
    /// # Errors
    /// As [`Levels::get`].
    #[allow(clippy::needless_pass_by_value, reason = "labels are written in place")]
    pub fn marginal(&self, key: impl Key<R>) -> Result<f64, ModelError> {
        Ok(self.0.0.marginals[self.0.0.index_of(&key.labels())?])
    }
    /// All marginals in the order of the elements.
    pub fn marginals(&self) -> &[f64] {
        &self.0.0.marginals
    }
}

impl<const R: usize> Deref for VariableLevels<R> {
    type Target = Levels<R>;
    fn deref(&self) -> &Levels<R> {
        &self.0
    }
}

impl Numbers {
    /// The single value of a family without index sets; 0 if its condition does not hold.
    pub fn single(&self) -> f64 {
        self.values.first().copied().unwrap_or(0.0)
    }

    /// The single value of a family without index sets, `None` if its part is off.
    pub fn single_if_on(&self) -> Option<f64> {
        self.off.is_none().then(|| self.single())
    }

    /// A family of a part that is off.
    fn off(name: &str, part: &str) -> Arc<Self> {
        let family = Family::of_table(name, &[]);
        Arc::new(Numbers {
            family,
            values: Vec::new(),
            marginals: Vec::new(),
            off: Some(part.to_owned()),
        })
    }

    fn index_of(&self, labels: &[&str]) -> Result<usize, ModelError> {
        match &self.off {
            None => self.family.index_of(labels),
            Some(part) => {
                Err(ModelError::PartOff { name: self.family.name().to_owned(), part: part.clone() })
            }
        }
    }
}

/// A table of the data: its name, its sets and its values.
#[doc(hidden)]
pub type ViewedTable<'a> = (&'a str, &'a [&'a Set], &'a [f64]);

/// The numbers of a solution, all `N` families in order: variables, definitions, parameters,
/// reports, tables.
///
/// # Errors
/// [`ModelError::Length`] for a solution with another number of variables,
/// [`ModelError::OtherModel`] for one whose families have other names or labels.
#[doc(hidden)]
#[inline]
pub fn viewed<const N: usize>(
    model: &dyn PlainModel,
    solution: &Solution,
    tables: &[ViewedTable<'_>],
) -> Result<[Arc<Numbers>; N], ModelError> {
    let numbers = all_numbers(model, solution, tables)?;
    Ok(numbers.try_into().unwrap_or_else(|_| unreachable!("the model was checked")))
}

/// The same of a model with parts. `apart` are the families and tables of parts in order: place
/// among all, name and part.
///
/// # Errors
/// As [`viewed`].
#[doc(hidden)]
pub fn viewed_with_parts<const N: usize>(
    model: &dyn PlainModel,
    solution: &Solution,
    tables: &[ViewedTable<'_>],
    apart: &[(usize, &str, usize)],
) -> Result<[Arc<Numbers>; N], ModelError> {
    let parts = model.plain_shape().all_parts();
    let off: Vec<_> = apart.iter().filter(|(.., part)| !parts[*part].is_on).collect();
    let tables = tables.iter().enumerate().filter(|(k, _)| {
        let place = N - tables.len() + k;
        !off.iter().any(|(absent, ..)| *absent == place)
    });
    let tables: Vec<ViewedTable<'_>> = tables.map(|(_, table)| *table).collect();
    let mut numbers = all_numbers(model, solution, &tables)?;
    for &&(place, name, part) in &off {
        numbers.insert(place, Numbers::off(name, parts[part].name));
    }
    Ok(numbers.try_into().unwrap_or_else(|_| unreachable!("the model was checked")))
}

fn all_numbers(
    model: &dyn PlainModel,
    solution: &Solution,
    tables: &[ViewedTable<'_>],
) -> Result<Vec<Arc<Numbers>>, ModelError> {
    model.plain_shape().check_solution(solution)?;
    let solved = &solution.shape;
    let parameters = solved.parameter_values();
    let derived = Derived::at(model, &solution.z, parameters);
    let mut all = Vec::new();
    for (families, values, marginals) in [
        (solved.variables(), &solution.z[..], &solution.f[..]),
        (solved.definitions(), &derived.definitions, &[]),
        (solved.parameters(), parameters, &[]),
        (solved.reports(), &derived.reports, &[]),
    ] {
        all.extend(families.iter().map(|family| numbers(family, values, marginals)));
    }
    let table = |&(name, sets, values): &ViewedTable<'_>| {
        numbers(&Family::of_table(name, sets), values, &[])
    };
    all.extend(tables.iter().map(table));
    Ok(all)
}

/// The elements of a family among all of its kind; without `marginals` it has none.
fn numbers(family: &Family, all: &[f64], marginals: &[f64]) -> Arc<Numbers> {
    let range = family.offset()..family.offset() + family.len();
    let values = all[range.clone()].to_vec();
    let marginals = marginals.get(range).unwrap_or_default().to_vec();
    Arc::new(Numbers { family: family.clone(), values, marginals, off: None })
}

#[cfg(test)]
#[path = "view_tests.rs"]
mod tests;
