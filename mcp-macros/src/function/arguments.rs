//! `lower = …, upper = …, start = …, crate = …`.

use super::types::{literal, ungrouped};
use crate::errors::Errors;
use crate::messages;
use crate::nearest::nearest;
use proc_macro2::{TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Expr, Ident, Path, Token};

/// What was given to the attribute.
#[derive(Default)]
pub(super) struct Arguments {
    /// Bounds and start, in the order of the text.
    pub(super) settings: Vec<Setting>,
    /// Path of `mcp_core`, if given.
    pub(super) core: Option<Path>,
}

/// One of `lower`, `upper`, `start`.
pub(super) struct Setting {
    pub(super) key: Ident,
    pub(super) value: Expr,
}

impl Setting {
    /// Number of entries of an array that is written out.
    pub(super) fn entries(&self) -> Option<usize> {
        match ungrouped(&self.value) {
            Expr::Array(array) => Some(array.elems.len()),
            Expr::Repeat(repeat) => literal(&repeat.len),
            _ => None,
        }
    }
}

impl Arguments {
    /// Reads all arguments, continuing after one that is wrong.
    pub(super) fn parse(tokens: TokenStream, errors: &mut Errors) -> Self {
        let mut arguments = Arguments::default();
        let mut seen: Vec<String> = Vec::new();
        let list = |input: ParseStream<'_>| {
            while !input.is_empty() {
                if let Err(error) = arguments.read(input, &mut seen, errors) {
                    errors.add(error);
                    skip_to_comma(input)?;
                }
                if !input.is_empty() && input.parse::<Token![,]>().is_err() {
                    errors.at_span(input.span(), messages::COMMA);
                }
            }
            Ok(())
        };
        if let Err(error) = list.parse2(tokens) {
            errors.add(error);
        }
        arguments
    }

    /// Reads one argument.
    fn read(
        &mut self,
        input: ParseStream<'_>,
        seen: &mut Vec<String>,
        errors: &mut Errors,
    ) -> syn::Result<()> {
        let Ok(key) = input.call(Ident::parse_any) else {
            return Err(syn::Error::new(input.span(), messages::ARGUMENT));
        };
        let word = key.to_string();
        if !messages::ARGUMENTS.contains(&word.as_str()) {
            let message = messages::unknown_argument(&word, nearest(&word, &messages::ARGUMENTS));
            return Err(syn::Error::new(key.span(), message));
        }
        if seen.contains(&word) {
            errors.at(&key, messages::duplicate_argument(&word));
        }
        if input.parse::<Token![=]>().is_err() || input.is_empty() || input.peek(Token![,]) {
            return Err(syn::Error::new(key.span(), messages::value_missing(&word)));
        }
        seen.push(word);
        if key == "crate" {
            let not_a_path =
                |error: syn::Error| syn::Error::new(error.span(), messages::NOT_A_PATH);
            self.core = Some(input.call(Path::parse_mod_style).map_err(not_a_path)?);
        } else {
            let value = input.parse().map_err(|error| {
                if input.is_empty() {
                    let message = messages::value_unfinished(&key.to_string());
                    return syn::Error::new(key.span(), message);
                }
                error
            })?;
            self.settings.push(Setting { key, value });
        }
        Ok(())
    }
}

/// Leaves the rest of an argument that is wrong.
fn skip_to_comma(input: ParseStream<'_>) -> syn::Result<()> {
    while !input.is_empty() && !input.peek(Token![,]) {
        input.parse::<TokenTree>()?;
    }
    Ok(())
}
