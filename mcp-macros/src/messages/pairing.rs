//! Messages about equations and their variables.

/// M03: a variable has no equation.
pub(crate) fn without_equation(variable: &str) -> String {
    format!("`{variable}` has no equation: write `eq … complements {variable}`, or `fix` it")
}

/// M04: a variable has two equations.
pub(crate) fn paired_twice(variable: &str, equation: &str) -> String {
    format!("`{variable}` is already complementary to `{equation}`")
}

/// M05: there is no such variable.
pub(crate) fn unknown_variable(name: &str, nearest: Option<&str>, variables: &[&str]) -> String {
    match nearest {
        Some(nearest) => format!("there is no variable `{name}`; did you mean `{nearest}`?"),
        None => format!("there is no variable `{name}`: the variables are {}", quoted(variables)),
    }
}

/// M05: something that is no variable stands in a pair or behind `fix`.
pub(crate) fn not_a_variable(name: &str, noun: &str, variables: &[&str]) -> String {
    format!("`{name}` is {noun}: the variables are {}", quoted(variables))
}

/// M06: a variable has another number of indices than are given.
pub(crate) fn rank(variable: &str, sets: &[&str], given: usize) -> String {
    let (indices, are) = (count(sets.len()), is_are(given));
    let of = if sets.is_empty() { String::new() } else { format!(" ({})", quoted(sets)) };
    format!("`{variable}` has {indices}{of}, but {given} {are} given")
}

/// M07: the indices of the equation stand in another order.
pub(crate) fn order(equation: &str, indices: &[&str]) -> String {
    format!("the indices of `{equation}` stand in its order: {}", quoted(indices))
}

/// M07: an index of the equation is missing.
pub(crate) fn index_missing(equation: &str, index: &str) -> String {
    format!("the index `{index}` of `{equation}` is missing")
}

/// M07: a piece is neither an index nor a label.
pub(crate) fn unknown_piece(
    piece: &str,
    equation: &str,
    set: &str,
    nearest: Option<&str>,
) -> String {
    let hint = nearest.map(|nearest| format!("; did you mean `{nearest}`?")).unwrap_or_default();
    format!("`{piece}` is neither an index of `{equation}` nor a label of `{set}`{hint}")
}

/// A `fix` picks something that is no label.
pub(crate) fn unknown_label(piece: &str, set: &str) -> String {
    format!("`{piece}` is no label of `{set}` in the text: for every element write `i in {set}`")
}

/// M07: a piece is an end of the element that is the index.
pub(crate) fn end_in_pair(end: &str, index: &str) -> String {
    format!("`{end}` is an end of `{index}`: write `{index}`")
}

/// M07: `.first()` or `.last()` of a set without order.
pub(crate) fn no_order(set: &str) -> String {
    format!("`{set}` has no order: declare it `{set}: Ordered`")
}

/// The relation says the contrary of the bound.
pub(crate) fn turned(variable: &str, bound: &str, relation: &str, right: &str) -> String {
    format!("`{variable}` has {bound} bound: write `lhs {relation} rhs` as `rhs {right} lhs`")
}

/// M10: the equation of a free variable holds with equality.
pub(crate) fn free(variable: &str) -> String {
    format!("`{variable}` is free, its equation holds with equality: write `lhs == rhs`")
}

/// An equality stands for a variable with one bound.
pub(crate) fn equality(variable: &str, bound: &str, right: &str) -> String {
    format!("`{variable}` has {bound} bound: write `lhs {right} rhs`, or declare it `free`")
}

/// A relation stands for a variable with two bounds.
pub(crate) fn boxed(variable: &str) -> String {
    format!("`{variable}` has two bounds: write one expression, `lhs - rhs`")
}

/// The names in backquotes.
pub(crate) fn quoted(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}

/// A number of indices.
pub(crate) fn count(indices: usize) -> String {
    match indices {
        0 => "no index".to_owned(),
        1 => "1 index".to_owned(),
        _ => format!("{indices} indices"),
    }
}

fn is_are(n: usize) -> &'static str {
    if n == 1 { "is" } else { "are" }
}
