//! Messages about parts.

use super::pairing::quoted;

/// Something is read that exists only with a part.
pub(crate) fn hidden(name: &str, part: &str, in_part: bool) -> String {
    let form = if in_part {
        format!("write `requires {part}` in the head of this part")
    } else {
        "use it there, and reach the model with `adds`".to_owned()
    };
    format!("`{name}` exists only with the part `{part}`: {form}")
}

/// An equation is paired with a variable of another part.
pub(crate) fn pair(
    variable: &str,
    part_of_variable: Option<&str>,
    equation: &str,
    part_of_equation: Option<&str>,
) -> String {
    let of = |part: Option<&str>| match part {
        Some(part) => format!("of the part `{part}`"),
        None => "of the model without parts".to_owned(),
    };
    format!(
        "`{variable}` is {}, but `{equation}` is {}: both exist together or not at all",
        of(part_of_variable),
        of(part_of_equation)
    )
}

/// Behind `requires` or `excludes` stands no part.
pub(crate) fn unknown(name: &str, nearest: Option<&str>, parts: &[&str]) -> String {
    match nearest {
        Some(nearest) => format!("there is no part `{name}`; did you mean `{nearest}`?"),
        None => format!("there is no part `{name}`: the parts are {}", quoted(parts)),
    }
}

/// A part is declared twice.
pub(crate) fn duplicate(name: &str) -> String {
    format!("the part `{name}` is declared twice")
}

/// A part requires or excludes itself.
pub(crate) fn itself(word: &str, name: &str) -> String {
    format!("`{name}` {word} itself: name another part")
}

/// A part requires and excludes the same.
pub(crate) fn never(name: &str, other: &str) -> String {
    format!("`{name}` requires `{other}`, directly or through others, and excludes it")
}

/// The type of a part has the name of another type of the model.
pub(crate) fn type_taken(name: &str, of: &str) -> String {
    format!("the part `{name}` would make a second type `{of}`: choose another name")
}

/// No type can be named after the part.
pub(crate) fn no_type(name: &str) -> String {
    format!("no name for a type can be made from `{name}`: use a name with a letter")
}

/// A field of a part is of a type of the user's own.
pub(crate) fn field_type(name: &str) -> String {
    format!(
        "the data of a part are sets, tables, maps and numbers `f64`: declare `{name}` in the data \
         of the model"
    )
}

/// `adds` names nothing that is declared.
pub(crate) fn unknown_target(name: &str, nearest: Option<&str>, targets: &[&str]) -> String {
    match nearest {
        Some(nearest) => {
            format!("there is no equation or definition `{name}`; did you mean `{nearest}`?")
        }
        None if targets.is_empty() => format!("there is no equation or definition `{name}`"),
        None => {
            format!("there is no equation or definition `{name}`: there are {}", quoted(targets))
        }
    }
}

/// `adds` names something that is no sum.
pub(crate) fn no_target(name: &str, noun: &str, equation: Option<&str>) -> String {
    let form = match equation {
        Some(equation) => format!("write `adds {equation}`, its equation"),
        None => "write the name of an equation or a definition".to_owned(),
    };
    format!("`{name}` is {noun}: {form}")
}

/// What is added to a definition reads it.
pub(crate) fn added_reads_target(name: &str, target: &str) -> String {
    if name == target {
        return format!("what is added to `{target}` cannot read `{target}`");
    }
    format!("`{name}` reads `{target}`: what is added to `{target}` cannot read `{name}`")
}
