//! `var name[i in set] >= lower start expr if condition`.

use super::super::ast::{Bounds, Var};
use super::super::tokens::{is_operator, is_word, starts_operand, stream};
use super::body::relations;
use super::cursor::{Cursor, is_member};
use super::header;
use crate::messages::grammar;
use proc_macro2::{TokenStream, TokenTree};
use syn::{Attribute, Ident};

/// `var` with all that follows.
pub(super) fn var(attributes: Vec<Attribute>, cursor: &mut Cursor<'_>) -> Option<Var> {
    let name = cursor.name("var")?;
    let over = header::indices(cursor, &name)?;
    let bounds = bounds(cursor, &name)?;
    let start = if cursor.take_word("start") {
        let end = end(cursor.trees, cursor.at);
        Some(stream(cursor.expression_to(end, "start")?))
    } else {
        None
    };
    let condition = if cursor.take_word("if") {
        let end = end(cursor.trees, cursor.at);
        Some(stream(cursor.expression_to(end, "if")?))
    } else {
        None
    };
    if condition.is_some() && is_word(cursor.peek(), &["start"]) {
        cursor.wrong(grammar::START_BEFORE_IF);
        return None;
    }
    cursor.finish()?;
    Some(Var { attributes, name, over, bounds, start, condition, part: None })
}

/// Where the expression that begins at `from` ends: at `start`, or at an `if` behind an operand.
fn end(trees: &[TokenTree], from: usize) -> usize {
    let ends = |k: usize| {
        !is_member(trees, k)
            && (is_word(trees.get(k), &["start"]) && !(k == from && is_alone(trees, k))
                || is_word(trees.get(k), &["if"]) && k > from && !starts_operand(trees, k))
    };
    (from..trees.len()).find(|&k| ends(k)).unwrap_or(trees.len())
}

/// Whether the word at `k` is a whole expression: nothing that could be its value follows.
fn is_alone(trees: &[TokenTree], k: usize) -> bool {
    match trees.get(k + 1) {
        None | Some(TokenTree::Punct(_)) => true,
        next => is_word(next, &["start", "if"]),
    }
}

/// `free`, `>= expr`, `<= expr` or `in expr..=expr`.
fn bounds(cursor: &mut Cursor<'_>, name: &Ident) -> Option<Bounds> {
    if cursor.take_word("free") {
        Some(Bounds::Free)
    } else if cursor.take_operator(">=") {
        Some(Bounds::Lower(one_bound(cursor, ">=")?))
    } else if cursor.take_operator("<=") {
        Some(Bounds::Upper(one_bound(cursor, "<=")?))
    } else if cursor.take_word("in") {
        both_bounds(cursor)
    } else {
        cursor.wrong(grammar::bounds_missing(&name.to_string()));
        None
    }
}

/// The bound behind `>=` or `<=`.
fn one_bound(cursor: &mut Cursor<'_>, sign: &str) -> Option<TokenStream> {
    let end = end(cursor.trees, cursor.at);
    let bound = cursor.expression_to(end, sign)?;
    if let Some((k, ..)) = relations(bound).first() {
        cursor.errors.at(&bound[*k], grammar::TWO_BOUNDS);
        return None;
    }
    Some(stream(bound))
}

/// `expr..=expr`.
fn both_bounds(cursor: &mut Cursor<'_>) -> Option<Bounds> {
    let end = end(cursor.trees, cursor.at);
    let trees = cursor.expression_to(end, "in")?;
    let Some(k) = (0..trees.len()).find(|&k| is_operator(trees, k, "..")) else {
        cursor.errors.at(&trees[0], grammar::BOX);
        return None;
    };
    let (lower, upper) = (&trees[..k], trees.get(k + 3..).unwrap_or_default());
    if !is_operator(trees, k, "..=") || lower.is_empty() || upper.is_empty() {
        cursor.errors.at(&trees[k], grammar::BOX);
        return None;
    }
    Some(Bounds::Box(stream(lower), stream(upper)))
}
