//! Divisions of integers, which lose the fraction.

use crate::errors::Errors;
use crate::messages;
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::LitInt;

/// `1/2` of two integer literals is 0 in Rust, hardly ever what a model means. `x * 1/2` is not
/// that: it is `(x * 1)/2`.
pub(crate) fn check(tokens: TokenStream, errors: &mut Errors) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for tree in &tokens {
        if let TokenTree::Group(group) = tree {
            check(group.stream(), errors);
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
