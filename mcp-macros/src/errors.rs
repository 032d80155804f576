//! [`Errors`]: everything that is wrong with one macro call.

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;

/// Collects errors, so that all of them are shown at once.
#[derive(Default)]
pub(crate) struct Errors(Vec<syn::Error>);

impl Errors {
    /// An error that underlines these tokens.
    pub(crate) fn at(&mut self, tokens: impl ToTokens, message: impl Into<String>) {
        self.0.push(syn::Error::new_spanned(tokens, message.into()));
    }

    /// An error at a place that is no tokens, such as a closing parenthesis.
    pub(crate) fn at_span(&mut self, span: Span, message: impl Into<String>) {
        self.0.push(syn::Error::new(span, message.into()));
    }

    /// An error of the parser.
    pub(crate) fn add(&mut self, error: syn::Error) {
        self.0.push(error);
    }

    /// Puts the errors into the order of the text.
    pub(crate) fn sort(&mut self) {
        self.0.sort_by_key(|error| {
            let start = error.span().start();
            (start.line, start.column)
        });
    }

    /// How many errors there are.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether nothing is wrong.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// One `compile_error!` for each error.
    pub(crate) fn to_compile_errors(&self) -> TokenStream {
        self.0.iter().map(syn::Error::to_compile_error).collect()
    }

    /// The errors as `line:column message`, counted from 1.
    #[cfg(test)]
    pub(crate) fn lines(&self) -> Vec<String> {
        let errors = self.0.iter().flat_map(|error| error.clone().into_iter());
        errors
            .map(|error| {
                let start = error.span().start();
                format!("{}:{} {error}", start.line, start.column + 1)
            })
            .collect()
    }
}
