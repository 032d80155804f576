//! The modelling language of the mixed complementarity suite.
//!
//! Users do not depend on this crate: `mcp-core` re-exports its macros. What it generates is data
//! and calls into `mcp_core`, never an algorithm.
//!
//! A macro goes through four steps, each in its own file or folder: the tokens are parsed, checked,
//! and either everything that is wrong is reported at once, each fault at its token, or the model is
//! generated. Every message stands in `messages.rs` and the folder beside it.

mod divisions;
mod errors;
mod function;
mod messages;
mod model;
mod nearest;
mod type_name;

#[cfg(test)]
mod tests;

use proc_macro::TokenStream;

/// # Form
///
/// ```text
/// #[mcp_fn]                            or   #[mcp_fn(argument, …)]
/// fn name<D: Scalar>([x1, x2]: [Real<D>; 2]) -> [Real<D>; 2] { … }
/// fn name<D: Scalar>(z: [Real<D>; N]) -> [Real<D>; N] { … }
///
/// argument := "lower" "=" values       default: no lower bounds
///           | "upper" "=" values       default: no upper bounds
///           | "start" "=" values       default: 0, moved into the bounds
///           | "crate" "=" path         where `mcp_core` is, if it was renamed
/// values   := a number for all variables, or an array with one number for each
/// ```
///
/// The length is a literal or any constant; the number type may have any name in place of `D`;
/// visibility, attributes and documentation are free. Values are any expressions, integers
/// included; the function can not be a method.
///
/// # What is generated
///
/// The function stays as it is and can be called with any number type. Beside it stands a model of
/// its name, `struct KojimaShindo` for `fn kojima_shindo`, of the same visibility and with the same
/// documentation, with
///
/// * `fn new() -> Result<KojimaShindo, ModelError>`, which checks bounds and start and names the
///   variable where one is wrong;
/// * `impl Model`, whose rows are the entries of the returned array;
/// * `impl Clone` and `impl Debug`.
///
/// # Names
///
/// | argument | variables | equations |
/// | --- | --- | --- |
/// | `[x1, x2]: [Real<D>; 2]` | `x1`, `x2` | `f[x1]`, `f[x2]` |
/// | `z: [Real<D>; 2]` | `z[1]`, `z[2]` | `f[1]`, `f[2]` |
/// | `f: [Real<D>; 2]` | `f[1]`, `f[2]` | `F[1]`, `F[2]` |
///
/// Equation and variable of the same position are complementary to each other.
#[proc_macro_attribute]
pub fn mcp_fn(arguments: TokenStream, item: TokenStream) -> TokenStream {
    function::mcp_fn(arguments.into(), item.into()).into()
}

/// # Form
///
/// ```text
/// model   := "model" NAME "{" item… "}"                     before it documentation, lint levels, `pub`
/// item    := "data" "{" field, … "}"
///          | "param"  NAME[over] ["=" value] ";"            without a value it comes with the data
///          | "var"    NAME[over] bounds ["start" value] ["if" condition] ";"
///          | "fix"    NAME[place, …] "=" value ";"
///          | "def"    NAME[over] ["lifted"] ":" expression ";"
///          | "eq"     NAME[over] ["if" condition] ":" body "complements" NAME[index, …] ";"
///          | "report" NAME[over] ":" expression ";"
///          | "part"   NAME ["requires" NAME, …] ["excludes" NAME, …] "{" item… "}"
///          | "adds"   NAME[place, …] ":" expression ";"      in a part
/// place   := i "in" SET  |  i, over the set of the target  |  LABEL
/// over    := i "in" SET, …  |  l "@" "(" i "," j ")" "in" PAIRS
/// bounds  := "free" | ">=" value | "<=" value | "in" value "..=" value
/// body    := expression  |  expression (">=" | "<=" | "==") expression
/// field   := NAME ":" kind  |  NAME[SET, …] ":" "f64"
///            before items and fields documentation, which may end with the unit: `/// price [$/t]`
/// kind    := "Set" | "Set[a, b]" | "Ordered" | "Subset(set)" | "Pairs(from, to)" | "Map(from, to)"
///          | a number of elements, such as 3 | "usize", where something is indexed by it | any type
/// ```
///
/// # Meaning
///
/// Every variable is complementary to one equation: at its lower bound `F >= 0`, at its upper bound
/// `F <= 0`, in between `F = 0`. A relation stands for `F = left − right`, and its sign has to agree
/// with the bound: `>=` with `>= lower`, `<=` with `<= upper`, `==` with `free`. A variable between
/// two bounds takes an expression.
///
/// * `data` are sets, tables and values; bounds, starts, conditions and the values of parameters are
///   expressions of data.
/// * `param` is a constant of a solve that can be changed between solves; `tax.base(s)` is its value
///   in the data.
/// * `if condition` on a variable: where it does not hold there is no variable (reading it gives 0)
///   and no row of its equation. On an equation: where it does not hold there is no row, so that
///   several equations can share a variable; each element must get exactly one.
/// * `fix` holds a variable; its equation is evaluated and reported, and need not hold.
/// * `def` is a sub-expression evaluated once per pass; `lifted`, it becomes a free variable with
///   the equation `v − expression`, which keeps rows short where much is read through it.
/// * `report` is evaluated at a solution and never part of `F`.
/// * `part` is an effect that exists only where it is switched on: see below.
///
/// Between `:` and `complements` stands Rust: `let`, `if` and `match` on data, closures, functions
/// generic over `Scalar`; `D` is the type of the engine's numbers, `Real<D>` that of an expression.
/// `sum`, `prod`, `when`, `max`, `min`, `select` and the other functions of `mcp_core` are in scope,
/// before functions of the same name in the program around. An expression ends with its value:
/// `return`, `?`, `break` and `continue` are for its own closures and loops. A local may not be called
/// like something declared, and a name that is nearly a declared one is taken for a misspelling.
///
/// An index of a subset also reads what is over the larger set, but is compared with indices of its
/// own set only, and has no neighbours.
///
/// | written | read |
/// | --- | --- |
/// | `x[i, j]`, `cost[i, j]`, `site[g]` | one element; every index must be of the right set |
/// | `sum(plants, \|i\| x[i, j])` | over a set; `lines.into(n)`, `lines.out_of(n)`, `site.of(n)` give lists |
/// | `s.at(k, t - 1).or(s0[k])`, `s.at(k, t, -1).or(…)` | a neighbour in an ordered set, and what stands in for it |
/// | `s[k, hours.wrap(t, -1)]` | the neighbour around the end |
/// | `hours.is_first(t)`, `hours.first()`, `thermal.contains(g)`, `i == j`, `i.position()` | data |
///
/// # Parts
///
/// A `part` holds any items but a further part. Where it is off, its variables, equations,
/// definitions, parameters and reports do not exist: no name, no unknown, no operation. What is added
/// to a row is resolved when the model is made: a family to which no part that is on adds is computed
/// as without parts, and in another one each row runs over its own terms; whether a part is on is not
/// asked again. `part emission_cap` makes a type `EmissionCap`, whose fields are the data of the part
/// and its parameters without value;
/// `model.with(EmissionCap { limit: 3.0, ef: [("coal", 1.0)] })?` gives the model with it, and
/// `model.with((tax, cap))?` with several, in any order. **A rate is a `param`; use a part when
/// unknowns come or go.**
///
/// * `adds profit[i]: term` adds to `F` of an equation, or to the value of a definition, of the model,
///   of the part itself, or of a part that it requires. Terms of several parts are added in the order
///   of the text, so that the order of switching on changes no bit. Where the target has no row,
///   nothing is added; that it has none of those named is an error of `with`. `adds mc[g in thermal]: …`
///   reaches a subset, `adds endow[labor]: …` a label.
/// * `requires a, b` and `excludes c` are checked by `with`. A part reads the model, itself and what
///   it requires, directly or through others; the model reads no part.
/// * An equation and its variable belong to the same part. `fix` may hold a variable of the model;
///   two parts cannot fix the same element, nor a part what was fixed by name before.
/// * Names are unique in the whole model; one of a part that is off is answered with its part. In the
///   view, a value without indices is an `Option`, `None` where the part is off, and other families
///   have no element.
/// * Bounds, starts and parameters that were changed by name before `with` stay changed. A variable
///   that a part fixes has the bounds of the part and starts there, whatever was changed; the model
///   without the part still has what was changed. Lifted definitions start where they hold with the
///   changed starts and parameters, unless their own start was changed.
/// * The types of the parts stand in a module, `EconomyParts` for `model Economy`, and beside the model
///   by `use EconomyParts::*`. Where models of one module have parts of the same name, that name alone
///   is ambiguous: write `EconomyParts::Tax`, or give each model a module of its own.
///
/// # What is generated
///
/// For `model Transport`, with the visibility and documentation of the text:
///
/// * `Transport`, which implements `Model`, with `builder()`, `view(&solution)`, and `fix`,
///   `set_lower`, `set_upper`, `set_start_of`, `set_parameter`, `start_from`, which go by name;
/// * `TransportBuilder`, one method for each field of the data and each parameter, and `build()`,
///   which checks everything;
/// * `TransportView`, one field for each variable, definition, parameter and report:
///   `view.x[("seattle", "topeka")]`;
/// * `TransportSets`, the types of the indices;
/// * `TransportParts`, with a type for each part, and `with` and `parts()`, the names of the parts that
///   are on.
///
/// With `MCP_MACRO_DEBUG=Transport` in the environment of the compiler, the expansion is printed.
#[proc_macro]
pub fn mcp(model: TokenStream) -> TokenStream {
    model::mcp(model.into()).into()
}
