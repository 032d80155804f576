//! `#[mcp_fn]`: a model from a function of fixed size.

mod arguments;
mod expand;
mod parse;
mod signature;
mod types;

use crate::errors::Errors;
use crate::messages;
use arguments::Arguments;
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use signature::Checked;
use syn::LitInt;

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
    check_divisions(item_tokens, &mut errors);
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

/// `1/2` of two integer literals is 0 in Rust, hardly ever what a model means. `x * 1/2` is not
/// that: it is `(x * 1)/2`.
fn check_divisions(tokens: TokenStream, errors: &mut Errors) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for tree in &tokens {
        if let TokenTree::Group(group) = tree {
            check_divisions(group.stream(), errors);
        }
    }
    let is_integer = |tree: &TokenTree| syn::parse2::<LitInt>(tree.to_token_stream()).is_ok();
    let is_punct = |tree: &TokenTree, of: &[char]| match tree {
        TokenTree::Punct(punct) => of.contains(&punct.as_char()),
        _ => false,
    };
    for (k, three) in tokens.windows(3).enumerate() {
        let continues = k > 0 && is_punct(&tokens[k - 1], &['*', '/', '%', '.']);
        if is_integer(&three[0])
            && is_punct(&three[1], &['/'])
            && is_integer(&three[2])
            && !continues
        {
            errors.at(&three[0], messages::division(&three[0].to_string(), &three[2].to_string()));
        }
    }
}
