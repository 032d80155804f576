//! Names that an expression gives itself: parameters of closures, `let`, `const`, `for`, arms.

use super::super::tokens::{
    group, is_operator, is_punct, is_word, parts, starts_closure, trees, word,
};
use proc_macro2::{Delimiter, TokenTree};
use syn::Ident;

/// The names that begin to be at `k`, and where the text goes on.
pub(super) fn bound(tokens: &[TokenTree], k: usize) -> Option<(Vec<Ident>, usize)> {
    let find = |is_end: &dyn Fn(usize) -> bool| {
        (k + 1..tokens.len()).find(|&at| is_end(at)).unwrap_or(tokens.len())
    };
    let (end, next) = if starts_closure(tokens, k) {
        let end = find(&|at| is_punct(tokens.get(at), '|'));
        (end, end + 1)
    } else if is_word(tokens.get(k), &["let", "const", "static"]) {
        let end = find(&|at| is_operator(tokens, at, "=") || is_punct(tokens.get(at), ';'));
        (end, end)
    } else if is_word(tokens.get(k), &["for"]) {
        let end = find(&|at| is_word(tokens.get(at), &["in"]));
        (end, end)
    } else {
        return None;
    };
    let mut names = Vec::new();
    pattern(&tokens[k + 1..end], &mut names);
    Some((names, next))
}

/// The names in the patterns of the arms of a `match`, if these are arms.
pub(super) fn of_arms(tokens: &[TokenTree]) -> Vec<Ident> {
    let mut names = Vec::new();
    let mut begin = 0;
    for k in 0..tokens.len() {
        if is_operator(tokens, k, "=>") {
            let guard = (begin..k).find(|&at| is_word(tokens.get(at), &["if"]));
            pattern(&tokens[begin..guard.unwrap_or(k)], &mut names);
        }
        let ends_arm = k >= 2
            && group(tokens.get(k), Delimiter::Brace).is_some()
            && is_operator(tokens, k - 2, "=>");
        if is_punct(tokens.get(k), ',') || ends_arm {
            begin = k + 1;
        }
    }
    names
}

/// The names in a pattern, without types and paths.
fn pattern(tokens: &[TokenTree], names: &mut Vec<Ident>) {
    let mut k = 0;
    while k < tokens.len() {
        if is_operator(tokens, k + 1, "::") {
            k += 3;
        } else if is_punct(tokens.get(k), ':') {
            while k < tokens.len() && !is_punct(tokens.get(k), ',') {
                k += 1;
            }
        } else if let Some(fields) = group(tokens.get(k), Delimiter::Brace) {
            field_patterns(&trees(fields.stream()), names);
            k += 1;
        } else if let TokenTree::Group(group) = &tokens[k] {
            pattern(&trees(group.stream()), names);
            k += 1;
        } else {
            let constructor = group(tokens.get(k + 1), Delimiter::Parenthesis).is_some()
                || group(tokens.get(k + 1), Delimiter::Brace).is_some();
            let word = word(tokens.get(k))
                .filter(|_| !constructor && !is_word(tokens.get(k), &["mut", "ref", "_"]));
            names.extend(word.cloned());
            k += 1;
        }
    }
}

/// The names in `field, field: pattern`.
fn field_patterns(fields: &[TokenTree], names: &mut Vec<Ident>) {
    for field in parts(fields) {
        let renamed = is_punct(field.get(1), ':');
        pattern(if renamed { &field[2..] } else { field }, names);
    }
}
