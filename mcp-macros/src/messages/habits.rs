//! Messages for those who come from GAMS: the form that is right here.

/// M01: an item begins with a word of GAMS.
pub(crate) fn item(word: &str) -> Option<String> {
    let form = match word.to_lowercase().as_str() {
        "set" | "sets" => "data { plants: Set }",
        "parameter" | "parameters" | "scalar" | "scalars" | "table" => {
            "data { demand[markets]: f64 }"
        }
        "variable" | "variables" | "free" => "var x free;",
        "positive" => "var x >= 0.0;",
        "negative" => "var x <= 0.0;",
        "equation" | "equations" => "eq balance: … complements x;",
        _ => return None,
    };
    Some(format!("there is no item `{word}`: write `{form}`"))
}

/// `..` stands behind the header of an equation.
pub(crate) const DOTS: &str = "write `:` instead of `..`";

/// A family is declared with parentheses.
pub(crate) fn header_parentheses(name: &str) -> String {
    format!("indices stand in brackets: write `{name}[i in plants]`")
}

/// `$` stands in a header.
pub(crate) const HEADER_DOLLAR: &str = "write `if condition` instead of `$`";

/// `$` stands in an expression.
pub(crate) const DOLLAR: &str = "write `when(condition, || …)` instead of `$`";

/// `=e=`, `=g=` or `=l=` stands in an equation.
pub(crate) fn relation(sign: &str, letter: &str) -> String {
    format!("write `{sign}` instead of `={letter}=`")
}

/// `=` stands in an equation.
pub(crate) const EQUALS: &str = "a relation is `==`, `>=` or `<=`";

/// A family is read with parentheses.
pub(crate) fn call(name: &str) -> String {
    format!("indices stand in brackets: write `{name}[…]`")
}

/// A sum runs over an index instead of a set, or has no closure.
pub(crate) fn sum(function: &str, set: &str, index: &str) -> String {
    format!("write `{function}({set}, |{index}| …)`")
}

/// `**` or `^` stands for a power.
pub(crate) fn power(sign: &str) -> String {
    format!("write `.pow(…)` instead of `{sign}`")
}

/// An attribute of a variable is read.
pub(crate) fn attribute(variable: &str, attribute: &str) -> String {
    let form = match attribute {
        "l" => format!("give the start in the declaration: `var {variable} … start 1.0;`"),
        "fx" => format!("write `fix {variable} = 1.0;`"),
        _ => format!("write the bounds in the declaration: `var {variable} in 0.0..=1.0;`"),
    };
    format!("there is no `.{attribute}`: {form}")
}
