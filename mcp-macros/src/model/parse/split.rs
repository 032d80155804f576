//! Where one item ends and the next begins.

use super::super::ast::{Def, Eq, Fix, Model, Param, Report, Var};
use super::super::tokens;
use super::super::tokens::{group, is_punct, is_word, stream, trees, word};
use super::cursor::{Cursor, is_member};
use super::{fields, items};
use crate::errors::Errors;
use crate::messages::grammar;
use crate::messages::habits;
use crate::nearest::nearest;
use proc_macro2::{Delimiter, Spacing, TokenTree};
use syn::Attribute;
use syn::parse::Parser;

/// Words behind the name of a variable, so that `start` behind `var` makes no item of the two.
const NO_NAMES: [&str; 8] = ["complements", "start", "if", "in", "free", "as", "lifted", "else"];

/// The tokens of an item without attributes, and whether its end is written.
struct Extent {
    end: usize,
    closed: bool,
}

/// Reads all items of the block of the model, or of this part.
pub(super) fn items(
    body: &[TokenTree],
    part: Option<usize>,
    model: &mut Model,
    errors: &mut Errors,
) {
    let mut at = 0;
    while at < body.len() {
        if is_punct(body.get(at), ';') {
            at += 1;
            continue;
        }
        let attributes = attributes(body, &mut at, errors);
        let extent = extent(body, at);
        if extent.end == at {
            errors.at(&body[at - 1], grammar::NO_ITEM);
            continue;
        }
        let text = Text { attributes, item: &body[at..extent.end], closed: extent.closed };
        item(text, part, model, errors);
        at = extent.end;
    }
}

/// Takes the documentation before an item.
pub(super) fn attributes(
    trees: &[TokenTree],
    at: &mut usize,
    errors: &mut Errors,
) -> Vec<Attribute> {
    let start = *at;
    while is_punct(trees.get(*at), '#') && group(trees.get(*at + 1), Delimiter::Bracket).is_some() {
        *at += 2;
    }
    let parsed = Attribute::parse_outer.parse2(stream(&trees[start..*at]));
    let mut attributes = parsed.unwrap_or_else(|error| {
        errors.add(error);
        Vec::new()
    });
    attributes.retain(|attribute| {
        let is_doc = attribute.path().is_ident("doc");
        if !is_doc {
            errors.at(attribute, grammar::ATTRIBUTE);
        }
        is_doc
    });
    attributes
}

/// Where the item at `at` ends.
fn extent(body: &[TokenTree], at: usize) -> Extent {
    let is_block = |k: usize| group(body.get(k), Delimiter::Brace).is_some();
    if is_word(body.get(at), &["part"]) {
        let ends = |&k: &usize| is_block(k) || is_punct(body.get(k), ';');
        if let Some(k) = (at + 1..body.len()).find(ends).filter(|&k| is_block(k)) {
            return Extent { end: k + 1, closed: true };
        }
    }
    let known = is_word(body.get(at), &grammar::ITEMS) && !is_word(body.get(at), &["data", "part"]);
    if word(body.get(at)).is_some() && !known {
        if is_block(at + 1) {
            return Extent { end: at + 2, closed: true };
        }
        if word(body.get(at + 1)).is_some() && is_block(at + 2) {
            return Extent { end: at + 3, closed: true };
        }
    }
    for k in at..body.len() {
        if is_punct(body.get(k), ';') {
            return Extent { end: k, closed: true };
        }
        if k > at + 1 && starts_item(body, k) {
            return Extent { end: before_attributes(body, k), closed: false };
        }
    }
    Extent { end: body.len(), closed: false }
}

/// Whether an item begins at `k`, in the midst of one that is not closed.
fn starts_item(body: &[TokenTree], k: usize) -> bool {
    if !is_word(body.get(k), &grammar::ITEMS) {
        return false;
    }
    match group(body.get(k + 1), Delimiter::Brace) {
        Some(_) if is_member(body, k) => false,
        Some(block) => is_word(body.get(k), &["data"]) && has_fields(block.stream().into_iter()),
        // Also behind a dot: no method is followed by a word, but a method may be still to come.
        None => word(body.get(k + 1)).is_some() && !is_word(body.get(k + 1), &NO_NAMES),
    }
}

/// Whether `name: …` or `name[…]: …` stands at the beginning.
fn has_fields(tokens: impl Iterator<Item = TokenTree>) -> bool {
    let first: Vec<TokenTree> = tokens.take(3).collect();
    let is_field_colon = |tree: Option<&TokenTree>| {
        matches!(tree, Some(TokenTree::Punct(punct))
            if punct.as_char() == ':' && punct.spacing() == Spacing::Alone)
    };
    let bracket = group(first.get(1), Delimiter::Bracket).is_some();
    word(first.first()).is_some() && is_field_colon(first.get(1 + usize::from(bracket)))
}

/// Where the attributes of the item at `k` begin.
fn before_attributes(body: &[TokenTree], mut k: usize) -> usize {
    while k >= 3
        && is_punct(body.get(k - 2), '#')
        && group(body.get(k - 1), Delimiter::Bracket).is_some()
    {
        k -= 2;
    }
    k
}

/// An item as it stands in the text.
struct Text<'a> {
    attributes: Vec<Attribute>,
    item: &'a [TokenTree],
    closed: bool,
}

/// Reads one item; one that is wrong is noted as lost.
fn item(text: Text<'_>, part: Option<usize>, model: &mut Model, errors: &mut Errors) {
    let Text { attributes, item, closed } = text;
    let before = errors.len();
    let mut cursor = Cursor { trees: item, at: 1, errors };
    let word = word(item.first()).map(ToString::to_string).unwrap_or_default();
    let read = match word.as_str() {
        "data" => data(part, &mut cursor, model),
        "param" => items::param(attributes, &mut cursor)
            .map(|item| model.params.push(Param { part, ..item })),
        "var" => super::variable::var(attributes, &mut cursor)
            .map(|item| model.vars.push(Var { part, ..item })),
        "fix" => items::fix(&mut cursor).map(|item| model.fixes.push(Fix { part, ..item })),
        "def" => {
            items::def(attributes, &mut cursor).map(|item| model.defs.push(Def { part, ..item }))
        }
        "eq" => super::body::eq(attributes, &mut cursor, &mut model.lost)
            .map(|item| model.eqs.push(Eq { part, ..item })),
        "report" => items::report(attributes, &mut cursor)
            .map(|item| model.reports.push(Report { part, ..item })),
        "part" if part.is_none() => self::part(attributes, &mut cursor, model),
        "part" => {
            cursor.errors.at(&item[0], grammar::PART_INSIDE);
            None
        }
        "adds" if let Some(part) = part => {
            items::adds(part, &mut cursor).map(|item| model.adds.push(item))
        }
        "adds" => {
            cursor.errors.at(&item[0], grammar::ADDS_OUTSIDE);
            None
        }
        _ => {
            unknown(&word, item, cursor.errors);
            None
        }
    };
    if read.is_none() {
        lose(&word, item, model);
    }
    if !closed && errors.len() == before {
        errors.at(item.last(), grammar::SEMICOLON);
    }
}

/// `part name { … }`.
fn part(attributes: Vec<Attribute>, cursor: &mut Cursor<'_>, model: &mut Model) -> Option<()> {
    let part = items::part(attributes, cursor)?;
    let Some(block) = cursor.take_group(Delimiter::Brace) else {
        cursor.wrong(grammar::part_block(&part.name.to_string()));
        return None;
    };
    cursor.finish()?;
    let number = model.parts.len();
    model.parts.push(part);
    items(&trees(block.stream()), Some(number), model, cursor.errors);
    Some(())
}

/// `data { … }`.
fn data(belongs_to: Option<usize>, cursor: &mut Cursor<'_>, model: &mut Model) -> Option<()> {
    let Some(block) = cursor.take_group(Delimiter::Brace) else {
        cursor.wrong(grammar::DATA);
        return None;
    };
    fields::fields(&trees(block.stream()), belongs_to, model, cursor.errors);
    cursor.finish()
}

/// The item word is no such word.
fn unknown(word: &str, item: &[TokenTree], errors: &mut Errors) {
    let message = if word.is_empty() {
        grammar::ITEM.to_owned()
    } else if let Some(message) = habits::item(word) {
        message
    } else {
        grammar::unknown_item(word, nearest(word, &grammar::ITEMS))
    };
    errors.at(&item[0], message);
}

/// Notes what an item may have declared.
fn lose(word: &str, item: &[TokenTree], model: &mut Model) {
    let known = grammar::ITEMS.contains(&word) && word != "part";
    let upto = if known { 2 } else { item.len() };
    let block = item.last().and_then(|tree| group(Some(tree), Delimiter::Brace));
    let inside = block.filter(|_| word == "part").map(|block| trees(block.stream()));
    let names = item.iter().take(upto).skip(1).chain(inside.iter().flatten());
    let names = names.filter_map(|tree| tokens::word(Some(tree)));
    model.lost.names.extend(names.map(ToString::to_string));
    model.lost.equations |= !known || word == "eq";
}
