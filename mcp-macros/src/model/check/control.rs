//! `return`, `break`, `continue` and `?`: outside a closure or a loop of the expression itself they
//! would leave the generated code instead.

use super::super::tokens::{is_punct, is_word, starts_closure, trees};
use crate::errors::Errors;
use crate::messages::reading;
use proc_macro2::{TokenStream, TokenTree};

/// What of the user's own stands around a place.
#[derive(Clone, Copy, Default)]
struct Inside {
    function: bool,
    repeated: bool,
}

/// Reports what would leave the expression.
pub(super) fn check(expression: &TokenStream, errors: &mut Errors) {
    walk(&trees(expression.clone()), Inside::default(), errors);
}

fn walk(tokens: &[TokenTree], around: Inside, errors: &mut Errors) {
    let mut here = around;
    for (k, token) in tokens.iter().enumerate() {
        if starts_closure(tokens, k) || is_word(Some(token), &["fn"]) {
            here.function = true;
        } else if is_word(Some(token), &["for", "while", "loop"]) {
            here.repeated = true;
        }
        // A label names a block of the expression.
        let labelled = is_punct(tokens.get(k + 1), '\'');
        let leaves = match token {
            TokenTree::Group(group) => {
                walk(&trees(group.stream()), here, errors);
                false
            }
            TokenTree::Punct(punct) if matches!(punct.as_char(), ',' | ';') => {
                here = around;
                false
            }
            TokenTree::Punct(punct) => punct.as_char() == '?' && !here.function,
            token if is_word(Some(token), &["return"]) => !here.function,
            token if is_word(Some(token), &["break", "continue"]) => !here.repeated && !labelled,
            _ => false,
        };
        if leaves {
            errors.at(token, reading::leaves(&token.to_string()));
        }
    }
}
