//! Messages of the parser of `mcp!`: what stands where something else belongs.

/// The words an item begins with.
pub(crate) const ITEMS: [&str; 9] =
    ["data", "param", "var", "fix", "def", "eq", "report", "part", "adds"];

/// The kinds of fields that are no types.
pub(crate) const KINDS: [&str; 5] = ["Set", "Ordered", "Subset", "Pairs", "Map"];

/// The macro does not begin with `model Name { … }`.
pub(crate) const MODEL: &str = "expected `pub model Name { … }`";

/// Something follows the model.
pub(crate) const AFTER_MODEL: &str = "nothing may follow the model: write one `mcp!` for each";

/// An item begins with a token that is no word.
pub(crate) const ITEM: &str =
    "expected one of `data`, `param`, `var`, `fix`, `def`, `eq`, `report`, `part`";

/// M01: an item begins with an unknown word.
pub(crate) fn unknown_item(word: &str, nearest: Option<&str>) -> String {
    match nearest {
        Some(nearest) => format!("there is no item `{word}`; did you mean `{nearest}`?"),
        None => format!("there is no item `{word}`: {ITEM}"),
    }
}

/// A `part` stands in a part.
pub(crate) const PART_INSIDE: &str =
    "a part has no parts: write it beside this one, with `requires`";

/// `adds` stands outside of a part.
pub(crate) const ADDS_OUTSIDE: &str =
    "only a part adds to what is declared: `part tax { adds profit[i]: rate[i]; }`";

/// No block stands behind the head of a part.
pub(crate) fn part_block(name: &str) -> String {
    format!("expected the items of the part: `part {name} {{ … }}`")
}

/// Attributes stand before the end of the block.
pub(crate) const NO_ITEM: &str = "expected an item behind its documentation";

/// An attribute other than documentation stands before an item or a field.
pub(crate) const ATTRIBUTE: &str =
    "only documentation, `/// …`, stands before an item: what depends on `cfg` is data";

/// An attribute that changes the model as a whole stands before it.
pub(crate) const MODEL_ATTRIBUTE: &str = "only documentation and lint levels stand before a model: write the attribute on a module around it";

/// An item is not closed, or goes on where it should end.
pub(crate) const SEMICOLON: &str = "expected `;`";

/// `data` is not followed by a block.
pub(crate) const DATA: &str = "expected the fields: `data { plants: Set, capacity[plants]: f64 }`";

/// A name is missing, or is a word of Rust.
pub(crate) fn name_missing(after: &str) -> String {
    format!("expected a name after `{after}`")
}

/// Brackets stand behind a name without anything in them.
pub(crate) fn empty_brackets(name: &str) -> String {
    format!("no index stands in the brackets: write `{name}` alone")
}

/// An index of a header is malformed.
pub(crate) const INDEX: &str = "expected an index: `i in plants`, or `l @ (i, j) in lines`";

/// A value or an expression is empty.
pub(crate) fn expression_missing(after: &str) -> String {
    format!("expected an expression after `{after}`")
}

/// `complements` stands in an item that is no equation.
pub(crate) const COMPLEMENTS: &str = "only an `eq` has `complements`";

/// A parameter goes on with something that is no value.
pub(crate) fn param_value(name: &str) -> String {
    format!("expected `param {name};` or `param {name} = 0.0;`")
}

/// A `fix` has no value.
pub(crate) fn fix_value(variable: &str) -> String {
    format!("expected the value: `fix {variable} = 1.0;`")
}

/// No colon stands behind a header.
pub(crate) fn colon_missing(name: &str) -> String {
    format!("expected `:` and an expression behind the header of `{name}`")
}

/// A variable has no bounds.
pub(crate) fn bounds_missing(name: &str) -> String {
    format!("expected the bounds of `{name}`: `free`, `>= 0.0`, `<= 1.0` or `in 0.0..=1.0`")
}

/// A bound is followed by another relation.
pub(crate) const TWO_BOUNDS: &str = "two bounds are written `in 0.0..=1.0`";

/// `in` is not followed by `lower..=upper`.
pub(crate) const BOX: &str = "expected both bounds: `in 0.0..=1.0`";

/// `start` follows the condition of a variable.
pub(crate) const START_BEFORE_IF: &str = "write `start` before `if`";

/// M09: an equation has no `complements`.
pub(crate) fn complements_missing(name: &str) -> String {
    format!("`{name}` needs its variable: end the equation with `complements x;`")
}

/// An equation has several relations.
pub(crate) const SECOND_RELATION: &str = "an equation has one relation";

/// One side of a relation is empty.
pub(crate) const SIDE_MISSING: &str = "a relation has two sides: `lhs >= rhs`";

/// A field has no name.
pub(crate) const FIELD: &str = "expected a field: `plants: Set`, `capacity[plants]: f64`";

/// A field has no kind.
pub(crate) fn kind_missing(name: &str) -> String {
    format!("expected what `{name}` is: `{name}: Set`, `{name}: f64`, `{name}[plants]: f64`")
}

/// Fields are not separated by commas.
pub(crate) const FIELD_COMMA: &str = "expected `,` between the fields";

/// Something in a list of sets or labels is no name.
pub(crate) const NAMES: &str =
    "expected names with commas between them, as in `load[nodes, hours]`";

/// A table holds something else than numbers.
pub(crate) fn table_type(name: &str) -> String {
    format!("a table holds numbers: write `{name}[…]: f64`")
}

/// A count is no integer.
pub(crate) const COUNT: &str = "expected a type, or a count such as `3`";

/// A field is no type.
pub(crate) const TYPE: &str =
    "expected `Set`, `Ordered`, `Subset(…)`, `Pairs(…)`, `Map(…)`, a count or a type";

/// A kind stands without its sets, or in other brackets.
pub(crate) fn kind_form(kind: &str) -> String {
    let form = match kind {
        "Set" => "Set` or `Set[labor, capital]",
        "Subset" => "Subset(plants)",
        "Pairs" => "Pairs(nodes, nodes)",
        "Map" => "Map(plants, nodes)",
        _ => "Ordered",
    };
    format!("write `{form}`")
}

/// A kind has another name.
pub(crate) fn unknown_kind(word: &str, nearest: Option<&str>) -> String {
    match nearest {
        Some(nearest) => format!("there is no `{word}`; did you mean `{nearest}`?"),
        None => format!("there is no `{word}`: {TYPE}"),
    }
}
