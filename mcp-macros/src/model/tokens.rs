//! Looking at tokens that are not parsed: words, operators, groups, parts between commas.

use proc_macro2::{Delimiter, Group, Ident, Spacing, TokenStream, TokenTree};

/// The tokens as a list.
pub(super) fn trees(tokens: TokenStream) -> Vec<TokenTree> {
    tokens.into_iter().collect()
}

/// The list as tokens.
pub(super) fn stream(trees: &[TokenTree]) -> TokenStream {
    trees.iter().cloned().collect()
}

/// The word, if it is one.
pub(super) fn word(tree: Option<&TokenTree>) -> Option<&Ident> {
    match tree {
        Some(TokenTree::Ident(ident)) => Some(ident),
        _ => None,
    }
}

/// The tokens as one writes them.
pub(super) fn text(trees: &[TokenTree]) -> String {
    let text = stream(trees).to_string();
    text.replace(" . ", ".").replace(" (", "(").replace(" [", "[")
}

/// Whether it is one of these words.
pub(super) fn is_word(tree: Option<&TokenTree>, of: &[&str]) -> bool {
    word(tree).is_some_and(|ident| of.iter().any(|word| ident == word))
}

/// Whether it is this sign.
pub(super) fn is_punct(tree: Option<&TokenTree>, of: char) -> bool {
    matches!(tree, Some(TokenTree::Punct(punct)) if punct.as_char() == of)
}

/// The group with these delimiters, if it is one.
pub(super) fn group(tree: Option<&TokenTree>, delimiter: Delimiter) -> Option<&Group> {
    match tree {
        Some(TokenTree::Group(group)) if group.delimiter() == delimiter => Some(group),
        _ => None,
    }
}

/// Whether the sign at `k` may be one operator with the next sign.
fn is_joint(trees: &[TokenTree], k: usize) -> bool {
    matches!(trees.get(k), Some(TokenTree::Punct(punct))
        if punct.spacing() == Spacing::Joint && !",;?#$@'".contains(punct.as_char()))
}

/// Whether this operator stands at `k`, and does not continue the sign before it.
pub(super) fn is_operator(trees: &[TokenTree], k: usize, operator: &str) -> bool {
    let continues = k > 0 && is_joint(trees, k - 1);
    let last = operator.chars().count().saturating_sub(1);
    !continues
        && operator.chars().enumerate().all(|(m, sign)| {
            is_punct(trees.get(k + m), sign) && (m == last || is_joint(trees, k + m))
        })
}

/// Whether the tokens before `k` leave an operand open: an operator, or nothing, stands there.
pub(super) fn starts_operand(trees: &[TokenTree], k: usize) -> bool {
    match k.checked_sub(1).and_then(|before| trees.get(before)) {
        None => true,
        Some(TokenTree::Punct(punct)) => punct.as_char() != '?',
        tree => is_word(tree, &["start", "in", "else", "return", "if", "match", "while", "move"]),
    }
}

/// Whether a closure begins at `k`: `|` where an operand is expected.
pub(super) fn starts_closure(trees: &[TokenTree], k: usize) -> bool {
    let ends_or = k > 0 && is_punct(trees.get(k - 1), '|') && !starts_operand(trees, k - 1);
    is_punct(trees.get(k), '|') && starts_operand(trees, k) && !ends_or
}

/// Whether the word at `k` is a name of its own: no field, method, path, macro or lifetime.
pub(super) fn is_name(trees: &[TokenTree], k: usize) -> bool {
    let before = |n: usize| k.checked_sub(n).and_then(|at| trees.get(at));
    let after_dot = is_punct(before(1), '.') && !is_punct(before(2), '.');
    let in_path = is_punct(before(1), ':') && is_punct(before(2), ':');
    let macro_name = is_punct(trees.get(k + 1), '!') && !is_punct(trees.get(k + 2), '=');
    let colon = is_punct(trees.get(k + 1), ':');
    !(after_dot || in_path || macro_name || colon || is_punct(before(1), '\''))
}

/// Whether the word at `k` has a method or a field behind it.
pub(super) fn is_receiver(trees: &[TokenTree], k: usize) -> bool {
    is_punct(trees.get(k + 1), '.') && !is_punct(trees.get(k + 2), '.')
}

/// The parts between the commas; a comma may stand at the end.
pub(super) fn parts(trees: &[TokenTree]) -> Vec<&[TokenTree]> {
    let mut parts: Vec<&[TokenTree]> = trees.split(|tree| is_punct(Some(tree), ',')).collect();
    if parts.last().is_some_and(|last| last.is_empty()) {
        parts.pop();
    }
    parts
}
