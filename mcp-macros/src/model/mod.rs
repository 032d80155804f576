//! `mcp! { … }`: a model over sets, from its text.

mod ast;
mod check;
mod expand;
mod names;
mod parse;
mod rewrite;
mod tokens;

use crate::errors::Errors;
use names::Names;
use proc_macro2::TokenStream;

/// The model of the text, followed by everything that is wrong with it.
pub(crate) fn mcp(tokens: TokenStream) -> TokenStream {
    let (model, errors) = read(tokens);
    let Some(model) = model else { return errors.to_compile_errors() };
    let mut model = model;
    if !errors.is_empty() {
        model.drop_duplicates();
    }
    let names = Names::of(&model, &mut Errors::default());
    let bodies = if errors.is_empty() {
        expand::Bodies::Whole
    } else if in_language_server() {
        expand::Bodies::ForTheLanguageServer
    } else {
        expand::Bodies::Stubs
    };
    let mut expansion = expand::model(&model, &names, bodies);
    expansion.extend(errors.to_compile_errors());
    print_if_asked(&model.name.to_string(), &expansion);
    expansion
}

/// Whether a language server runs the macro: it reads all of a model with errors, where the compiler
/// would stumble over what follows from them.
fn in_language_server() -> bool {
    let program = std::env::current_exe().unwrap_or_default();
    program.file_stem().is_some_and(|stem| stem.to_string_lossy().contains("rust-analyzer"))
}

/// The model, as far as it could be read, and what is wrong with it in the order of the text.
fn read(tokens: TokenStream) -> (Option<ast::Model>, Errors) {
    let mut errors = Errors::default();
    let model = parse::model(tokens, &mut errors);
    if let Some(model) = &model {
        check::model(model, &mut errors);
    }
    errors.sort();
    (model, errors)
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
    let (_, errors) = read(tokens);
    if errors.is_empty() { Ok(()) } else { Err(errors) }
}
