//! `sum` and `prod`: a set, and a closure with its index.

use super::super::tokens::{group, is_operator, is_punct, is_word, parts, trees, word};
use super::reads::Reader;
use crate::messages::habits;
use proc_macro2::{Delimiter, TokenTree};
use syn::Ident;

impl Reader<'_> {
    /// `sum(i, …)` of GAMS.
    pub(super) fn sum(&mut self, tokens: &[TokenTree], k: usize, function: &Ident) {
        let Some(call) = group(tokens.get(k + 1), Delimiter::Parenthesis) else { return };
        let inner = trees(call.stream());
        let arguments = parts(&inner);
        let set = arguments.first().copied().unwrap_or_default();
        let body = arguments.get(1).copied().unwrap_or_default();
        if !(self.is_set(set) && self.is_function(body)) {
            let (over, index) = self.meant(set);
            self.errors.at(function, habits::sum(&function.to_string(), &over, &index));
        }
    }

    /// Whether it may be a set: no index of the item, no tuple, no `i in plants`.
    fn is_set(&self, tokens: &[TokenTree]) -> bool {
        let is_index = only_word(tokens).is_some_and(|word| self.scope.contains_key(&word));
        let tuple = group(tokens.first(), Delimiter::Parenthesis)
            .filter(|group| tokens.len() == 1 && parts(&trees(group.stream())).len() > 1);
        let runs = tokens.iter().any(|tree| is_word(Some(tree), &["in"]));
        !(is_index || tuple.is_some() || runs)
    }

    /// Whether the tokens may be a closure or a function: nothing of the model begins them.
    fn is_function(&self, tokens: &[TokenTree]) -> bool {
        if is_punct(tokens.first(), '|') || is_word(tokens.first(), &["move"]) {
            return true;
        }
        if is_punct(tokens.first(), '&') || group(tokens.first(), Delimiter::Brace).is_some() {
            return true;
        }
        match word(tokens.first()) {
            Some(first) => {
                self.names.get(&first.to_string()).is_none() || is_operator(tokens, 1, "::")
            }
            None => false,
        }
    }

    /// The set and the index that were probably meant.
    fn meant(&self, first: &[TokenTree]) -> (String, String) {
        let other = || ("set".to_owned(), "i".to_owned());
        let text = |tree: Option<&TokenTree>| tree.map(ToString::to_string).unwrap_or_default();
        if first.iter().any(|tree| is_word(Some(tree), &["in"])) {
            return (text(first.last()), text(first.first()));
        }
        let Some(word) = only_word(first) else { return other() };
        if self.names.get(&word).is_some() {
            return (word, "i".to_owned());
        }
        let set = self.scope.get(&word).cloned().flatten();
        (set.unwrap_or_else(|| "set".to_owned()), word)
    }
}

/// The word, if there is nothing else.
fn only_word(tokens: &[TokenTree]) -> Option<String> {
    word(tokens.first()).filter(|_| tokens.len() == 1).map(ToString::to_string)
}
