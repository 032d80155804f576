//! [`ModelError`]: input that is wrong before iteration 0.

use crate::language::input::DataError;
use crate::linalg::LinearError;
use std::fmt;

/// What is wrong with a model, a start or an option. Every message names the offender.
///
/// A solve that does not converge is *not* an error: it is a [`Status`](crate::Status).
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ModelError {
    /// A list has the wrong number of entries.
    #[error("the length of `{what}` is {found}, expected {expected}")]
    Length {
        /// The list.
        what: String,
        /// Entries it should have.
        expected: usize,
        /// Entries it has.
        found: usize,
    },
    /// A name was given twice.
    #[error("the name `{name}` is used twice")]
    DuplicateName {
        /// The name.
        name: String,
    },
    /// A part of a model is switched on that is on already.
    #[error("the part `{part}` is on already: switch it on from the model without it")]
    PartTwice {
        /// The part.
        part: String,
    },
    /// A part of a model is on without one that it requires.
    #[error("the part `{part}` requires `{missing}`: switch both on, in one tuple")]
    PartRequired {
        /// The part that is on.
        part: String,
        /// The part that is off.
        missing: String,
    },
    /// Two parts of a model are on that exclude each other.
    #[error("the parts `{part}` and `{other}` exclude each other: switch one of them on")]
    PartExcluded {
        /// The part that says so.
        part: String,
        /// The other.
        other: String,
    },
    /// A name of a part of a model that is off is read or changed.
    #[error("`{name}` exists only with the part `{part}`, which is off")]
    PartOff {
        /// The family.
        name: String,
        /// Its part.
        part: String,
    },
    /// A variable is fixed by two parts of a model, or by a part and by the model without parts.
    #[error("`{variable}` is fixed twice, by {} and by {}", fixing(.first.as_deref()), fixing(.second.as_deref()))]
    FixedTwice {
        /// The variable.
        variable: String,
        /// The part that fixes it first; `None` for the model itself.
        first: Option<String>,
        /// The part that fixes it again.
        second: Option<String>,
    },
    /// A part fixes a variable that was fixed by name before the part was switched on.
    #[error(
        "`{variable}` was fixed by name, and the part `{part}` fixes it: fix it by name after the part is \
         on, or not at all"
    )]
    FixedByName {
        /// The variable.
        variable: String,
        /// The part.
        part: String,
    },
    /// A family has more than 2³¹ elements.
    #[error("`{name}` has more than 2^31 elements")]
    TooManyElements {
        /// The family.
        name: String,
    },
    /// A family is to have an element that its index sets do not have.
    #[error("`{name}` is to have element {element}, but its sets combine to only {count}")]
    ElementOutOfRange {
        /// The family.
        name: String,
        /// The element, counted from 0 with the last index fastest.
        element: usize,
        /// Combinations of its sets.
        count: usize,
    },
    /// The elements a family is to have are out of order, or one is listed twice.
    #[error("the elements of `{name}` do not increase: {element} follows {before}")]
    ElementOrder {
        /// The family.
        name: String,
        /// The element that is not larger,
        element: usize,
        /// than the one before it.
        before: usize,
    },
    /// All labels exist, but their family does not have this combination of them.
    #[error("there is no `{element}`: `{family}` has only some of the combinations of its sets")]
    NoSuchElement {
        /// Name of the missing element.
        element: String,
        /// Its family.
        family: String,
    },
    /// A set has a label twice.
    #[error("set `{set}` has the label `{label}` twice")]
    DuplicateLabel {
        /// The set.
        set: String,
        /// The label.
        label: String,
    },
    /// A name that nothing has.
    #[error("there is no {kind} `{name}`{}", did_you_mean(.nearest.as_deref()))]
    UnknownName {
        /// What was looked for: `variable`, `parameter`, …
        kind: &'static str,
        /// The name.
        name: String,
        /// The nearest existing name, if one is near.
        nearest: Option<String>,
    },
    /// A solution is of a model with other families or other labels.
    #[error("the solution is of another model: `{family}` has other elements there")]
    OtherModel {
        /// The first family that differs.
        family: String,
    },
    /// Two elements of a family have the same name.
    #[error("two elements are called `{name}`, because labels contain commas: rename one")]
    AmbiguousName {
        /// The name.
        name: String,
    },
    /// A bound is NaN, a lower bound is `+inf` or an upper bound `-inf`.
    #[error("variable `{variable}` has the bounds [{lower}, {upper}], which no number satisfies")]
    UnusableBounds {
        /// Name of the variable.
        variable: String,
        /// Its lower bound.
        lower: f64,
        /// Its upper bound.
        upper: f64,
    },
    /// The lower bound is above the upper bound.
    #[error("variable `{variable}` has crossed bounds: lower {lower} is above upper {upper}")]
    CrossedBounds {
        /// Name of the variable.
        variable: String,
        /// Its lower bound.
        lower: f64,
        /// Its upper bound.
        upper: f64,
    },
    /// The start of a variable is NaN or infinite.
    #[error("the start of variable `{variable}` is {value}: give a finite number")]
    StartNotFinite {
        /// Name of the variable.
        variable: String,
        /// The start.
        value: f64,
    },
    /// A parameter is NaN or infinite.
    #[error("parameter `{parameter}` is {value}: give a finite number")]
    ParameterNotFinite {
        /// Name of the parameter's element.
        parameter: String,
        /// The value.
        value: f64,
    },
    /// No equation complements this variable.
    #[error("variable `{variable}` has no equation: pair one with it or fix it")]
    Unpaired {
        /// Name of the variable.
        variable: String,
    },
    /// Two equations complement this variable.
    #[error("variable `{variable}` is complementary to both `{first}` and `{second}`")]
    PairedTwice {
        /// Name of the variable.
        variable: String,
        /// The equation declared first.
        first: String,
        /// The other.
        second: String,
    },
    /// An equation family and the variables it complements differ in number.
    #[error(
        "equation `{equation}` has {equations} rows but is paired with {variables} elements of \
         variable `{variable}`"
    )]
    PairSize {
        /// The equation family.
        equation: String,
        /// Its rows.
        equations: usize,
        /// The variable family.
        variable: String,
        /// Number of its elements paired.
        variables: usize,
    },
    /// An equation family and its variable family have as many elements, but not the same ones.
    #[error(
        "`{equation}` has no counterpart in `{variable}`: pair families with different elements \
         by complements_elements"
    )]
    PairElements {
        /// The first equation without counterpart.
        equation: String,
        /// The variable family.
        variable: String,
    },
    /// The marginal of a fixed variable without equation.
    #[error("variable `{variable}` is fixed and has no equation, so it has no marginal")]
    NoEquation {
        /// Name of the variable.
        variable: String,
    },
    /// A row reads something that does not exist.
    #[error("`{row}` reads {kind} number {index}, but there are only {count}")]
    ReadOutOfRange {
        /// The equation or definition.
        row: String,
        /// `variable`, `definition` or `parameter`.
        kind: &'static str,
        /// What it asked for, counted from 0.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// A row does not read the same at all points, so that its derivatives would lack entries.
    #[error(
        "`{row}` reads `{read}` at some points and not at others; a row may not choose by values what it \
         reads (`select`, `max` and `min` compute both sides), or say so with `AdProblem::reading`"
    )]
    ReadsVary {
        /// The equation or definition.
        row: String,
        /// The variable or definition.
        read: String,
    },
    /// A definition reads itself or a later one.
    #[error("definition `{definition}` reads `{later}`, which is not defined before it")]
    DefinitionOrder {
        /// The definition.
        definition: String,
        /// What it reads.
        later: String,
    },
    /// Second derivatives are asked of an external function, which gives only first ones.
    #[error("equation `{equation}` calls an external function, which has no second derivatives")]
    NoSecondOrder {
        /// The equation.
        equation: String,
    },
    /// An option is out of range.
    #[error("option `{option}` is {value}: {rule}")]
    Option {
        /// Name of the field in [`Options`](crate::Options).
        option: &'static str,
        /// The value given.
        value: String,
        /// What it must be.
        rule: &'static str,
    },
    /// The linear solver cannot take this problem.
    #[error("the linear solver refuses the problem: {0}")]
    Linear(#[from] LinearError),
    /// The data do not fit the sets and tables of the model.
    #[error(transparent)]
    Data(#[from] DataError),
}

/// As [`Display`](fmt::Display): what `main` prints of an error it returns.
impl fmt::Debug for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

fn fixing(part: Option<&str>) -> String {
    part.map_or_else(|| "the model".to_owned(), |part| format!("the part `{part}`"))
}

/// The end of a sentence about a name that nothing has: `` ; did you mean `price`? ``, or nothing.
pub fn did_you_mean(nearest: Option<&str>) -> String {
    nearest.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default()
}

/// The candidate nearest to `name` in edit distance, if at most a third of its letters differ.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<String> {
    let limit = name.chars().count().div_ceil(3).max(1);
    candidates
        .into_iter()
        .map(|candidate| (edit_distance(name, candidate), candidate))
        .filter(|(distance, _)| *distance <= limit)
        .min()
        .map(|(_, candidate)| candidate.to_owned())
}

/// Levenshtein distance: insertions, deletions and replacements of letters.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for j in 0..b.len() {
            let replaced = diagonal + usize::from(letter != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(row[j + 1] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_offered_only_when_it_is_near() {
        let names = ["price", "quantity", "capacity"];
        assert_eq!(nearest("prise", names), Some("price".to_owned()));
        assert_eq!(nearest("capcity", names), Some("capacity".to_owned()));
        assert_eq!(nearest("wage", names), None);
    }

    #[test]
    fn an_unknown_name_reads_as_a_sentence() {
        let error = ModelError::UnknownName {
            kind: "variable",
            name: "prise".to_owned(),
            nearest: nearest("prise", ["price"]),
        };
        assert_eq!(error.to_string(), "there is no variable `prise`; did you mean `price`?");
    }
}
