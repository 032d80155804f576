//! `[i in plants, l @ (i, j) in lines]` behind a name.

use super::super::ast::{Index, Place};
use super::super::tokens::{group, is_punct, is_word, parts, stream, trees, word};
use super::cursor::Cursor;
use crate::errors::Errors;
use crate::messages::{grammar, habits};
use proc_macro2::{Delimiter, Group, TokenTree};
use syn::Ident;

/// The indices in the brackets; none without brackets.
pub(super) fn indices(cursor: &mut Cursor<'_>, name: &Ident) -> Option<Vec<Index>> {
    if group(cursor.peek(), Delimiter::Parenthesis).is_some() {
        cursor.wrong(habits::header_parentheses(&name.to_string()));
        return None;
    }
    if is_punct(cursor.peek(), '$') {
        cursor.wrong(habits::HEADER_DOLLAR);
        return None;
    }
    let Some(brackets) = cursor.take_group(Delimiter::Bracket) else { return Some(Vec::new()) };
    let trees = trees(brackets.stream());
    if !has_parts(brackets, name, cursor.errors) {
        return None;
    }
    let indices: Vec<Option<Index>> = parts(&trees)
        .into_iter()
        .map(|part| {
            let index = index(part);
            if index.is_none() {
                no_index(part, brackets, cursor.errors);
            }
            index
        })
        .collect();
    indices.into_iter().collect()
}

/// The places in the brackets of a `fix`.
pub(super) fn places(cursor: &mut Cursor<'_>, name: &Ident) -> Option<Vec<Place>> {
    if group(cursor.peek(), Delimiter::Parenthesis).is_some() {
        cursor.wrong(habits::call(&name.to_string()));
        return None;
    }
    let Some(brackets) = cursor.take_group(Delimiter::Bracket) else { return Some(Vec::new()) };
    let trees = trees(brackets.stream());
    if !has_parts(brackets, name, cursor.errors) {
        return None;
    }
    let places: Vec<Option<Place>> = parts(&trees)
        .into_iter()
        .map(|part| {
            let runs = part.iter().any(|tree| is_word(Some(tree), &["in"]));
            let place = if runs {
                index(part).map(Place::Every)
            } else {
                (!part.is_empty()).then(|| Place::One(stream(part)))
            };
            if place.is_none() {
                no_index(part, brackets, cursor.errors);
            }
            place
        })
        .collect();
    places.into_iter().collect()
}

/// Whether something stands in the brackets.
pub(super) fn has_parts(brackets: &Group, name: &Ident, errors: &mut Errors) -> bool {
    let filled = !brackets.stream().is_empty();
    if !filled {
        errors.at(brackets, grammar::empty_brackets(&name.to_string()));
    }
    filled
}

/// `i in plants` or `l @ (i, j) in lines`.
fn index(part: &[TokenTree]) -> Option<Index> {
    let name = identifier(part.first())?;
    let (ends, rest) = match part.get(1) {
        tree if is_punct(tree, '@') => (Some(ends(part.get(2))?), &part[3..]),
        _ => (None, &part[1..]),
    };
    match rest {
        [word, set] if is_word(Some(word), &["in"]) => {
            Some(Index { name, ends, set: identifier(Some(set))? })
        }
        _ => None,
    }
}

/// `(i, j)`.
fn ends(tree: Option<&TokenTree>) -> Option<(Ident, Ident)> {
    let inner = trees(group(tree, Delimiter::Parenthesis)?.stream());
    match parts(&inner)[..] {
        [[first], [second]] => Some((identifier(Some(first))?, identifier(Some(second))?)),
        _ => None,
    }
}

/// A name that is no word of Rust.
pub(super) fn identifier(tree: Option<&TokenTree>) -> Option<Ident> {
    let ident = word(tree)?.clone();
    syn::parse2(TokenTree::from(ident).into()).ok()
}

fn no_index(part: &[TokenTree], brackets: &Group, errors: &mut Errors) {
    match part.first() {
        Some(first) => errors.at(first, grammar::INDEX),
        None => errors.at(brackets, grammar::INDEX),
    }
}
