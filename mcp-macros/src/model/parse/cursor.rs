//! [`Cursor`]: walks over the tokens of one item.

use super::super::tokens::{group, is_operator, is_punct, is_word, word};
use crate::errors::Errors;
use crate::messages::grammar;
use proc_macro2::{Delimiter, Group, Span, TokenTree};
use syn::Ident;

/// The tokens of an item and the place in them.
pub(super) struct Cursor<'a> {
    pub(super) trees: &'a [TokenTree],
    pub(super) at: usize,
    pub(super) errors: &'a mut Errors,
}

impl<'a> Cursor<'a> {
    /// The next token.
    pub(super) fn peek(&self) -> Option<&'a TokenTree> {
        self.trees.get(self.at)
    }

    /// What is left.
    pub(super) fn rest(&self) -> &'a [TokenTree] {
        self.trees.get(self.at..).unwrap_or_default()
    }

    /// Takes this word.
    pub(super) fn take_word(&mut self, of: &str) -> bool {
        let found = is_word(self.peek(), &[of]);
        self.at += usize::from(found);
        found
    }

    /// Takes this operator.
    pub(super) fn take_operator(&mut self, operator: &str) -> bool {
        let found = is_operator(self.trees, self.at, operator);
        self.at += if found { operator.len() } else { 0 };
        found
    }

    /// Takes a group with these delimiters.
    pub(super) fn take_group(&mut self, delimiter: Delimiter) -> Option<&'a Group> {
        let group = group(self.peek(), delimiter)?;
        self.at += 1;
        Some(group)
    }

    /// Takes the name that `after` needs.
    pub(super) fn name(&mut self, after: &str) -> Option<Ident> {
        let name = word(self.peek()).and_then(|ident| {
            let tokens = TokenTree::from(ident.clone()).into();
            syn::parse2::<Ident>(tokens).ok()
        });
        match name {
            Some(_) => self.at += 1,
            None => self.wrong(grammar::name_missing(after)),
        }
        name
    }

    /// The next token, or the last one where nothing is left, is wrong.
    pub(super) fn wrong(&mut self, message: impl Into<String>) {
        self.errors.at_span(self.place(), message);
    }

    /// Where the next token stands, or the last one where nothing is left.
    pub(super) fn place(&self) -> Span {
        let tree = self.peek().or_else(|| self.trees.get(..self.at)?.last());
        tree.or(self.trees.last()).map_or_else(Span::call_site, TokenTree::span)
    }

    /// Nothing may be left.
    pub(super) fn finish(&mut self) -> Option<()> {
        if self.peek().is_some() {
            self.wrong(grammar::SEMICOLON);
            return None;
        }
        Some(())
    }

    /// Takes all tokens up to `end`, which are the value of `what`.
    pub(super) fn expression_to(&mut self, end: usize, what: &str) -> Option<&'a [TokenTree]> {
        let trees = self.trees.get(self.at..end).unwrap_or_default();
        if trees.is_empty() {
            let before = self.at.checked_sub(1).and_then(|at| self.trees.get(at));
            let span = before.map_or_else(Span::call_site, TokenTree::span);
            self.errors.at_span(span, grammar::expression_missing(what));
            return None;
        }
        self.at = end;
        Some(trees)
    }

    /// Takes all that is left, the value of `what`, in which `complements` has no place.
    pub(super) fn expression(&mut self, what: &str) -> Option<&'a [TokenTree]> {
        let trees = self.expression_to(self.trees.len(), what)?;
        let word = (0..trees.len())
            .find(|&k| is_word(trees.get(k), &["complements"]) && !is_member(trees, k));
        match word {
            None => Some(trees),
            Some(k) => {
                self.errors.at(&trees[k], grammar::COMPLEMENTS);
                None
            }
        }
    }
}

/// Whether the word at `k` stands behind a dot.
pub(super) fn is_member(trees: &[TokenTree], k: usize) -> bool {
    k > 0 && is_punct(trees.get(k - 1), '.')
}
