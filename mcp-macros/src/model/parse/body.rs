//! `eq name[i in set] if condition: body complements variable[i]`.

use super::super::ast::{Body, Eq, Lost, Relation};
use super::super::tokens::{
    group, is_operator, is_punct, is_word, parts, starts_closure, stream, trees, word,
};
use super::cursor::{Cursor, is_member};
use super::{header, items};
use crate::errors::Errors;
use crate::messages::{grammar, habits};
use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use syn::{Attribute, Ident};

/// `eq` with all that follows.
pub(super) fn eq(
    attributes: Vec<Attribute>,
    cursor: &mut Cursor<'_>,
    lost: &mut Lost,
) -> Option<Eq> {
    let name = cursor.name("eq")?;
    let over = header::indices(cursor, &name)?;
    let condition = Some(condition(cursor, &name)?).filter(|tokens| !tokens.is_empty());
    colon(cursor, &name)?;
    let trees = cursor.trees;
    let pair = (cursor.at..trees.len())
        .find(|&k| is_word(trees.get(k), &["complements"]) && !is_member(trees, k));
    let Some(end) = pair else {
        body(cursor.rest(), cursor.errors);
        cursor.errors.at(&name, grammar::complements_missing(&name.to_string()));
        lost.bodies.push((over, stream(cursor.rest())));
        return None;
    };
    let expression = cursor.expression_to(end, ":");
    // Before its first word is written, an equation has its place and its pair all the same.
    let body = match expression {
        Some(trees) => body(trees, cursor.errors),
        None => Body::Expression(TokenStream::new()),
    };
    cursor.at = end + 1;
    let variable = cursor.name("complements")?;
    let (pair, pair_end) = pair_of(cursor, &variable)?;
    cursor.finish()?;
    Some(Eq { attributes, name, over, condition, body, variable, pair, pair_end, part: None })
}

/// `if condition`, empty without it.
fn condition(cursor: &mut Cursor<'_>, name: &Ident) -> Option<TokenStream> {
    if !cursor.take_word("if") {
        return Some(TokenStream::new());
    }
    let trees = cursor.trees;
    let is_colon = |k: usize| is_operator(trees, k, ":") && !is_operator(trees, k, "::");
    let Some(end) = (cursor.at..trees.len()).find(|&k| is_colon(k)) else {
        cursor.errors.at(name, grammar::colon_missing(&name.to_string()));
        return None;
    };
    Some(stream(cursor.expression_to(end, "if")?))
}

/// The colon behind the header.
fn colon(cursor: &mut Cursor<'_>, name: &Ident) -> Option<()> {
    if is_punct(cursor.peek(), '$') {
        cursor.wrong(habits::HEADER_DOLLAR);
        return None;
    }
    items::colon(cursor, name)
}

/// What stands in the brackets of the pair, and where it ends.
fn pair_of(cursor: &mut Cursor<'_>, variable: &Ident) -> Option<(Vec<TokenStream>, Span)> {
    if group(cursor.peek(), Delimiter::Parenthesis).is_some() {
        cursor.wrong(habits::call(&variable.to_string()));
        return None;
    }
    let Some(brackets) = cursor.take_group(Delimiter::Bracket) else {
        return Some((Vec::new(), variable.span()));
    };
    if !header::has_parts(brackets, variable, cursor.errors) {
        return None;
    }
    let trees = trees(brackets.stream());
    let pair = parts(&trees).into_iter().map(stream).collect();
    Some((pair, brackets.span_close()))
}

/// A relation where it stands.
struct Found {
    at: usize,
    tokens: usize,
    relation: Relation,
}

/// An expression, or the two sides of a relation; an expression, too, where that is wrong.
fn body(trees: &[TokenTree], errors: &mut Errors) -> Body {
    let whole = Body::Expression(stream(trees));
    let mut found: Vec<Found> = relations(trees)
        .into_iter()
        .map(|(at, relation)| Found { at, tokens: 2, relation })
        .collect();
    found.extend(single_equals(trees, errors));
    if let Some(second) = found.get(1) {
        errors.at(&trees[second.at], grammar::SECOND_RELATION);
        return whole;
    }
    let Some(&Found { at, tokens, relation }) = found.first() else { return whole };
    let (left, right) = (&trees[..at], &trees[at + tokens..]);
    if left.is_empty() || right.is_empty() {
        errors.at(&trees[at], grammar::SIDE_MISSING);
        return whole;
    }
    let first = trees[at].span();
    let span = first.join(trees[at + tokens - 1].span()).unwrap_or(first);
    Body::Relation { left: stream(left), relation, span, right: stream(right) }
}

/// Every relation outside of groups, conditions and closures, with its place.
pub(super) fn relations(trees: &[TokenTree]) -> Vec<(usize, Relation)> {
    let signs = [Relation::AtLeast, Relation::AtMost, Relation::Equal];
    let mut found = Vec::new();
    for k in outside(trees) {
        let relation = signs.into_iter().find(|sign| is_operator(trees, k, sign.sign()));
        found.extend(relation.map(|relation| (k, relation)));
    }
    found
}

/// The places outside of conditions, and before any closure.
fn outside(trees: &[TokenTree]) -> Vec<usize> {
    let mut places = Vec::new();
    let (mut in_condition, mut k) = (false, 0);
    while k < trees.len() {
        let is_block = group(trees.get(k), Delimiter::Brace).is_some();
        if is_word(trees.get(k), &["if", "match", "while"]) && !is_member(trees, k) {
            in_condition = true;
        } else if in_condition {
            in_condition = !is_block;
        } else if is_punct(trees.get(k), '|') {
            if starts_closure(trees, k) {
                break;
            }
            k += usize::from(is_operator(trees, k, "||"));
        } else {
            places.push(k);
        }
        k += 1;
    }
    places
}

/// Reports a lone `=` and the relations of GAMS, `=e=`, of which it is known what they mean.
fn single_equals(trees: &[TokenTree], errors: &mut Errors) -> Option<Found> {
    let is_equals = |k: usize| {
        is_operator(trees, k, "=") && !is_operator(trees, k, "==") && !is_operator(trees, k, "=>")
    };
    let at = outside(trees).into_iter().find(|&k| is_equals(k))?;
    let letter = word(trees.get(at + 1)).map(|ident| ident.to_string().to_lowercase());
    let relation = match letter.as_deref().filter(|_| is_punct(trees.get(at + 2), '=')) {
        Some("e") => Relation::Equal,
        Some("g") => Relation::AtLeast,
        Some("l") => Relation::AtMost,
        _ => {
            errors.at(&trees[at], habits::EQUALS);
            return None;
        }
    };
    errors.at(&trees[at], habits::relation(relation.sign(), &letter.unwrap_or_default()));
    Some(Found { at, tokens: 3, relation })
}
