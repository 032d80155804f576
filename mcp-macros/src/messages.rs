//! Every message of the language: what is wrong, and the form that is right. Those of `#[mcp_fn]`
//! stand here, those of `mcp!` by subject.

pub(crate) mod grammar;
pub(crate) mod habits;
pub(crate) mod names;
pub(crate) mod pairing;
pub(crate) mod parts;
pub(crate) mod reading;

/// `#[mcp_fn]` stands on something that is not a function.
pub(crate) const NOT_A_FUNCTION: &str = "`#[mcp_fn]` makes a model of a function: \
    `fn name<D: Scalar>([x1, x2]: [Real<D>; 2]) -> [Real<D>; 2]`";

/// No `x` such as `async`.
pub(crate) fn qualifier(word: &str) -> String {
    format!("a model function cannot be `{word}`: write `fn` alone")
}

/// No type can be named after the function.
pub(crate) fn no_model_name(function: &str) -> String {
    format!("no name for the model can be made from `{function}`: use a name with a letter")
}

/// The function has no type parameter.
pub(crate) fn not_generic(function: &str) -> String {
    format!(
        "a model function is generic in its numbers: \
         `fn {function}<D: Scalar>([x1, x2]: [Real<D>; 2]) -> [Real<D>; 2]`"
    )
}

/// The function has further generic parameters.
pub(crate) fn other_parameter(number: &str) -> String {
    format!("a model function has one generic parameter: `<{number}: Scalar>`")
}

/// The type parameter has no bound.
pub(crate) fn bound_missing(number: &str) -> String {
    format!("`{number}` needs its bound: write `{number}: Scalar`")
}

/// Two integer literals are divided.
pub(crate) fn division(a: &str, b: &str) -> String {
    format!("`{a} / {b}` divides integers, without the fraction: write `{a}.0 / {b}.0`")
}

/// The type parameter, or `Real` of it, shall be comparable.
pub(crate) const COMPARISON: &str = "a model cannot compare its numbers, which would hide a branch \
    from its derivatives: use `max`, `min`, `abs`, `clamp` or `select`";

/// The type parameter has a bound that is not `Scalar`.
pub(crate) fn other_bound(number: &str) -> String {
    format!("the only bound is `{number}: Scalar`: a model is evaluated with every number type")
}

/// The function has no argument.
pub(crate) fn argument_missing(number: &str) -> String {
    format!("the variables are missing: write `([x1, x2]: [Real<{number}>; 2])`")
}

/// The function has `self`.
pub(crate) const RECEIVER: &str = "a model function has no `self`: move it out of the `impl` \
    block, or implement `Model` for the type";

/// The function has several arguments.
pub(crate) fn several_arguments(number: &str) -> String {
    format!(
        "a model function has one argument, all its variables: `([x1, x2]: [Real<{number}>; 2])`"
    )
}

/// The argument is neither `[x1, x2]` nor `z`.
pub(crate) const PATTERN: &str = "name the variables: `[x1, x2]`, or `z` for `z[1]`, `z[2]`";

/// A variable is called `_`.
pub(crate) const UNNAMED: &str = "every variable needs a name: reports and errors use it";

/// The pattern has `..`.
pub(crate) const REST: &str = "every variable needs a name: write them all instead of `..`";

/// An element of the pattern is not a name.
pub(crate) const NOT_A_NAME: &str = "expected the name of a variable, such as `x1`";

/// The argument is not an array.
pub(crate) fn not_an_array(number: &str) -> String {
    format!(
        "expected an array of fixed size, `[Real<{number}>; 2]`: where the size comes from data, \
         implement `Model`"
    )
}

/// The elements of an array are not `Real<D>`.
pub(crate) fn not_real(number: &str) -> String {
    format!("expected `Real<{number}>`")
}

/// The length of an array is `_`.
pub(crate) const LENGTH_INFERRED: &str =
    "expected the number of variables: a literal or a constant";

/// The length of an array is 0.
pub(crate) const NO_VARIABLES: &str = "a model has at least one variable";

/// The pattern and its type differ in length.
pub(crate) fn pattern_length(names: usize, variables: usize) -> String {
    format!("{} named, but the type has {variables}", count(names, "variable is", "variables are"))
}

/// Nothing is returned.
pub(crate) fn return_missing(number: &str, length: &str) -> String {
    format!(
        "the equations are missing: return one number for each variable, {}",
        returned(number, length)
    )
}

/// What is returned is not an array.
pub(crate) fn return_not_an_array(number: &str, length: &str) -> String {
    format!("expected one number for each variable, {}", returned(number, length))
}

fn returned(number: &str, length: &str) -> String {
    format!("`-> [Real<{number}>; {length}]`")
}

/// The arrays taken and returned differ in length.
pub(crate) fn return_length(equations: usize, variables: usize) -> String {
    format!(
        "{} for {}: every variable has one",
        count(equations, "equation", "equations"),
        count(variables, "variable", "variables")
    )
}

/// The arrays taken and returned differ in length, which only the compiler knows.
pub(crate) const RETURN_LENGTH: &str = "there must be as many equations as variables";

/// The arguments of `#[mcp_fn]`.
pub(crate) const ARGUMENTS: [&str; 4] = ["lower", "upper", "start", "crate"];

/// An argument has no name.
pub(crate) const ARGUMENT: &str = "expected one of `lower`, `upper`, `start`, `crate`";

/// There is no argument of this name.
pub(crate) fn unknown_argument(word: &str, nearest: Option<&str>) -> String {
    match nearest {
        Some(nearest) => format!("there is no argument `{word}`; did you mean `{nearest}`?"),
        None => format!("there is no argument `{word}`: {ARGUMENT}"),
    }
}

/// An argument was given before.
pub(crate) fn duplicate_argument(word: &str) -> String {
    format!("`{word}` is given twice")
}

/// An argument has no value.
pub(crate) fn value_missing(word: &str) -> String {
    let example = if word == "crate" { "crate = mcp_core" } else { &format!("{word} = 0.0") };
    format!("`{word}` needs a value: `{example}`")
}

/// The value of the last argument breaks off.
pub(crate) fn value_unfinished(word: &str) -> String {
    format!("the value of `{word}` is not finished")
}

/// `crate` is not a path.
pub(crate) const NOT_A_PATH: &str = "expected the path of `mcp_core`: `crate = my_core`";

/// Two arguments are not separated.
pub(crate) const COMMA: &str = "expected `,`";

/// An array has the wrong number of entries.
pub(crate) fn entries(word: &str, entries: usize, variables: usize) -> String {
    format!(
        "`{word}` has {}, but there {}",
        count(entries, "entry", "entries"),
        count_after(variables)
    )
}

fn count(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

fn count_after(n: usize) -> String {
    if n == 1 { "is 1 variable".to_owned() } else { format!("are {n} variables") }
}
