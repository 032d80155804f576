//! Tokens to the head of a function; its body is never looked at.

use crate::errors::Errors;
use crate::messages;
use proc_macro2::TokenStream;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Abi, Attribute, Ident, Signature, Token, Visibility};

/// A function without its body.
pub(super) struct Head {
    pub(super) attributes: Vec<Attribute>,
    pub(super) visibility: Visibility,
    pub(super) signature: Signature,
}

/// The head of the function, or why there is none.
pub(super) fn item(item: TokenStream, errors: &mut Errors) -> Option<Head> {
    let head = |input: ParseStream<'_>| {
        let attributes = input.call(Attribute::parse_outer)?;
        let visibility = input.parse()?;
        if !is_function(input)? {
            let rest: TokenStream = input.parse()?;
            let first = rest.into_iter().next();
            return Err(syn::Error::new_spanned(first, messages::NOT_A_FUNCTION));
        }
        let signature = input.parse()?;
        let _body: TokenStream = input.parse()?;
        Ok(Head { attributes, visibility, signature })
    };
    head.parse2(item).map_err(|error| errors.add(error)).ok()
}

/// Whether `fn` follows, after any qualifiers.
fn is_function(input: ParseStream<'_>) -> syn::Result<bool> {
    let ahead = input.fork();
    while ahead.peek(Token![const]) || ahead.peek(Token![async]) || ahead.peek(Token![unsafe]) {
        ahead.call(Ident::parse_any)?;
    }
    ahead.parse::<Option<Abi>>()?;
    Ok(ahead.peek(Token![fn]))
}
