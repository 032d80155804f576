//! The modelling language of the mixed complementarity suite.
//!
//! Users do not depend on this crate: `mcp-core` re-exports its macros. What it generates is data
//! and calls into `mcp_core`, never an algorithm.
//!
//! A macro goes through four steps, each in its own file: the tokens are parsed, checked, and
//! either everything that is wrong is reported at once, each fault at its token, or the model is
//! generated. Every message stands in `messages.rs`.

mod errors;
mod function;
mod messages;
mod nearest;

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
