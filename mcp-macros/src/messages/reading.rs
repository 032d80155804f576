//! Messages about what an expression reads.

use super::pairing::{count, quoted};

/// An index of another set stands in brackets.
pub(crate) fn other_set(index: &str, set: &str, family: &str, place: usize, of: &str) -> String {
    format!(
        "`{index}` is an index of `{set}`, but the {} index of `{family}` is of `{of}`",
        ordinal(place)
    )
}

/// A label of another set stands in brackets.
pub(crate) fn other_label(label: &str, set: &str, family: &str, place: usize, of: &str) -> String {
    format!(
        "`{label}` is a label of `{set}`, but the {} index of `{family}` is of `{of}`",
        ordinal(place)
    )
}

/// A name that is not declared is read.
pub(crate) fn unknown_name(name: &str, nearest: Option<&str>) -> String {
    match nearest {
        Some(nearest) => format!("there is no `{name}`; did you mean `{nearest}`?"),
        None => format!("there is no `{name}`: declare it in `data`, or with `var` or `def`"),
    }
}

/// A scalar is read with an index.
pub(crate) fn scalar(name: &str) -> String {
    format!("`{name}` has {}: write `{name}` alone", count(0))
}

/// A family is read without indices.
pub(crate) fn family(name: &str, sets: &[&str]) -> String {
    format!("`{name}` is a family over {}: write `{name}[…]`", quoted(sets))
}

/// Something that is solved for, or may change, stands where only data may stand.
pub(crate) fn only_data(what: &str, name: &str, noun: &str) -> String {
    format!("{what} is data, but `{name}` is {noun}")
}

/// An `if` in an expression depends on what has derivatives.
pub(crate) fn branch(name: &str, noun: &str) -> String {
    format!(
        "a condition is data, but `{name}` is {noun}: a branch would be hidden from the \
         derivatives; use `max`, `min`, `clamp` or `select`"
    )
}

/// Nothing is said about a neighbour that does not exist.
pub(crate) fn or_missing(name: &str) -> String {
    format!("`{name}.at(…)` may not exist: write `{name}.at(…).or(value)`")
}

/// A method of a family as a whole.
pub(crate) fn method(name: &str, method: &str) -> String {
    format!("a family has no `{method}` here: write `{name}[…]`, or `{name}.at(…)` for a neighbour")
}

/// An expression would be left before its end.
pub(crate) fn leaves(word: &str) -> String {
    format!("`{word}` would leave the model, not the expression: let its value be the last")
}

/// A parameter stands where only data may stand.
pub(crate) fn only_base(what: &str, name: &str, arguments: &str) -> String {
    format!("{what} is data, but `{name}` is a parameter: write `{name}.base({arguments})`")
}

/// A definition reads one that is declared later.
pub(crate) fn later(name: &str, reader: &str) -> String {
    if name == reader {
        return format!("`{name}` reads itself: write a `var` with an `eq`");
    }
    format!("`{name}` is declared later: write it before `{reader}`")
}

/// The value of a parameter reads the parameter.
pub(crate) fn parameter_itself(name: &str) -> String {
    format!("`{name}` reads itself: write its value, or give it with the data")
}

/// An expression reads a report.
pub(crate) fn report(name: &str) -> String {
    format!("`{name}` is a report, made after the solve: nothing can read it")
}

/// An expression reads an equation.
pub(crate) fn equation(name: &str) -> String {
    format!("`{name}` is an equation, which has no value: write a `def`")
}

/// An index with a step, in the brackets of a family.
pub(crate) fn step(step: &str, set: &str, at: &str, wrap: &str) -> String {
    format!("`{step}` may leave `{set}`: write `{at}.or(…)`, or `{wrap}`")
}

/// An index with a step, over a set without order.
pub(crate) fn step_without_order(step: &str, set: &str) -> String {
    format!("`{set}` has no order for `{step}`: declare it `{set}: Ordered`")
}

fn ordinal(place: usize) -> String {
    match place {
        0 => "first".to_owned(),
        1 => "second".to_owned(),
        2 => "third".to_owned(),
        _ => format!("{}th", place + 1),
    }
}
