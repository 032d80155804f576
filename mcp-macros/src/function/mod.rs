//! `#[mcp_fn]`: a model from a function of fixed size.

mod arguments;
mod expand;
mod parse;
mod signature;
mod types;

use crate::divisions;
use crate::errors::Errors;
use crate::messages;
use arguments::Arguments;
use proc_macro2::TokenStream;
use signature::Checked;

/// The function unchanged, followed by its model or by everything that is wrong.
pub(crate) fn mcp_fn(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let added = model(arguments, item.clone()).unwrap_or_else(|errors| errors.to_compile_errors());
    [item, added].into_iter().collect()
}

/// The model of the function.
pub(crate) fn model(arguments: TokenStream, item: TokenStream) -> Result<TokenStream, Errors> {
    let mut errors = Errors::default();
    let arguments = Arguments::parse(arguments, &mut errors);
    let item_tokens = item.clone();
    let head = parse::item(item, &mut errors);
    let checked = head.map(|head| signature::check(&head, &mut errors));
    let Checked { function, count } = checked.unwrap_or_default();
    divisions::check(item_tokens, &mut errors);
    if let Some(variables) = count {
        check_entries(&arguments, variables, &mut errors);
    }
    match function {
        Some(function) if errors.is_empty() => Ok(expand::model(&function, &arguments)),
        _ => Err(errors),
    }
}

/// An array that is written out has one entry for each variable.
fn check_entries(arguments: &Arguments, variables: usize, errors: &mut Errors) {
    for setting in &arguments.settings {
        if let Some(entries) = setting.entries()
            && entries != variables
        {
            let message = messages::entries(&setting.key.to_string(), entries, variables);
            errors.at(&setting.value, message);
        }
    }
}
