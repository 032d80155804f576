//! Messages about what is declared: names, sets, and what is missing.

/// The model has no variable.
pub(crate) const NO_VARIABLES: &str = "the model has no variables: `var x >= 0.0;`";

/// The model has no equation.
pub(crate) const NO_EQUATIONS: &str = "the model has no equations: `eq balance: … complements x;`";

/// M02: a name is declared twice.
pub(crate) fn duplicate(name: &str, first: &str, second: &str) -> String {
    if first == second {
        format!("`{name}` is declared twice")
    } else {
        format!("`{name}` is declared twice, as {first} and as {second}")
    }
}

/// M08: a declared name or an index means something else in the language.
pub(crate) fn reserved(name: &str) -> String {
    format!("`{name}` is a word of the language: choose another name")
}

/// M08: an index has the name of something declared.
pub(crate) fn index_shadows(index: &str, noun: &str) -> String {
    format!("the index `{index}` hides {noun} of this name: choose another one")
}

/// M08: an index stands twice in a header.
pub(crate) fn index_twice(index: &str) -> String {
    format!("the index `{index}` stands twice in the header")
}

/// M08: a closure or a `let` gives the name of something declared.
pub(crate) fn local_shadows(name: &str, noun: &str) -> String {
    format!("`{name}` hides {noun} of this name: choose another one")
}

/// A set is not declared.
pub(crate) fn unknown_set(name: &str, nearest: Option<&str>) -> String {
    match nearest {
        Some(nearest) => format!("there is no set `{name}`; did you mean `{nearest}`?"),
        None => format!("there is no set `{name}`: declare it in `data`"),
    }
}

/// What stands in the place of a set is something else.
pub(crate) fn not_a_set(name: &str, noun: &str, nearest: Option<&str>) -> String {
    let hint = nearest.map(|nearest| format!("; did you mean `{nearest}`?")).unwrap_or_default();
    format!("`{name}` is {noun}, not a set{hint}")
}

/// A set is made of itself.
pub(crate) fn circular(name: &str) -> String {
    format!("`{name}` is made of itself")
}

/// A family has more indices than can be read.
pub(crate) const TOO_MANY_INDICES: &str = "a family has at most six indices";

/// The pattern `l @ (i, j)` stands over a set that has no ends.
pub(crate) fn no_pairs(index: &str, set: &str) -> String {
    format!("the elements of `{set}` have no ends: write `{index} in {set}`")
}
