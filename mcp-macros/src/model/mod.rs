//! `mcp! { … }`: a model over sets, from its text.

mod ast;
mod check;
mod expand;
mod names;
mod order;
mod parse;
mod rewrite;
mod tokens;

use crate::errors::Errors;
use expand::Bodies;
use names::Names;
use proc_macro2::TokenStream;

/// The model of the text, followed by everything that is wrong with it.
pub(crate) fn mcp(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let Some(mut model) = parse::model(tokens, &mut errors) else {
        return errors.to_compile_errors();
    };
    let names = names(&model, &mut errors);
    let mut expansion = if errors.is_empty() {
        expand::model(&model, &names, Bodies::Whole)
    } else {
        model.drop_duplicates();
        let names = Names::of(&model, &mut Errors::default());
        let server = in_language_server();
        let bodies = if server { Bodies::ForTheLanguageServer } else { Bodies::Stubs };
        expand::model(&model, &names, bodies)
    };
    expansion.extend(errors.to_compile_errors());
    print_if_asked(&model.name.to_string(), &expansion);
    expansion
}

/// The names of the model; what is wrong with it is in `errors`, in the order of the text.
fn names<'m>(model: &'m ast::Model, errors: &mut Errors) -> Names<'m> {
    let names = Names::of(model, errors);
    check::model(model, &names, errors);
    errors.sort();
    names
}

/// Whether a language server runs the macro: it reads all of a model with errors, where the compiler
/// would stumble over what follows from them.
fn in_language_server() -> bool {
    let program = std::env::current_exe().unwrap_or_default();
    program.file_stem().is_some_and(|stem| stem.to_string_lossy().contains("rust-analyzer"))
}

/// Prints the expansion of the model that the environment variable `MCP_MACRO_DEBUG` names.
#[allow(clippy::print_stderr, reason = "the user asks for it by name")]
fn print_if_asked(name: &str, expansion: &TokenStream) {
    if std::env::var("MCP_MACRO_DEBUG").is_ok_and(|asked| asked == name) {
        eprintln!("// expansion of `{name}`\n{expansion}");
    }
}

/// Everything that is wrong with the text, in its order.
#[cfg(test)]
pub(crate) fn check(tokens: TokenStream) -> Result<(), Errors> {
    let mut errors = Errors::default();
    if let Some(model) = parse::model(tokens, &mut errors) {
        names(&model, &mut errors);
    }
    if errors.is_empty() { Ok(()) } else { Err(errors) }
}
