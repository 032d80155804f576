//! Tokens to a model. Headers are parsed, expressions stay tokens; after an item that is wrong the
//! parser goes on behind its `;`, so that one fault never hides another.

mod body;
mod cursor;
mod fields;
mod header;
mod items;
mod split;
mod variable;

use super::ast::{FieldKind, Index, Lost, Model, Place};
use super::names::is_type;
use super::tokens::{is_punct, is_word, trees, word};
use crate::errors::Errors;
use crate::messages::grammar;
use crate::nearest::nearest;
use proc_macro2::{TokenStream, TokenTree};
use std::collections::HashSet;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Ident};

/// The model, with all items that could be read.
pub(super) fn model(tokens: TokenStream, errors: &mut Errors) -> Option<Model> {
    let (mut model, body) = head.parse2(tokens).map_err(|error| errors.add(error)).ok()?;
    split::items(&trees(body), None, &mut model, errors);
    find_indices_of_adds(&mut model);
    find_sizes(&mut model);
    Some(model)
}

/// `pub model Name { … }` without its items, and their tokens.
fn head(input: ParseStream<'_>) -> syn::Result<(Model, TokenStream)> {
    let expected = |error: syn::Error| syn::Error::new(error.span(), grammar::MODEL);
    let attributes = input.call(Attribute::parse_outer)?;
    let lints = ["doc", "allow", "expect", "warn", "deny"];
    if let Some(other) = attributes
        .iter()
        .find(|attribute| !lints.iter().any(|lint| attribute.path().is_ident(lint)))
    {
        return Err(syn::Error::new_spanned(other, grammar::MODEL_ATTRIBUTE));
    }
    let visibility = input.parse()?;
    let word: Ident = input.parse().map_err(expected)?;
    if word != "model" {
        return Err(syn::Error::new(word.span(), grammar::MODEL));
    }
    let name: Ident = input.parse().map_err(expected)?;
    let block = |input: ParseStream<'_>| {
        let content;
        syn::braced!(content in input);
        content.parse::<TokenStream>()
    };
    let content = block(input).map_err(expected)?;
    if !input.is_empty() {
        return Err(syn::Error::new(input.span(), grammar::AFTER_MODEL));
    }
    let model = Model {
        attributes,
        visibility,
        name,
        fields: Vec::new(),
        params: Vec::new(),
        vars: Vec::new(),
        fixes: Vec::new(),
        defs: Vec::new(),
        eqs: Vec::new(),
        reports: Vec::new(),
        parts: Vec::new(),
        adds: Vec::new(),
        lost: Lost::default(),
    };
    Ok((model, content))
}

/// A name in the brackets of `adds` is an index over the whole set of its target, unless it is a label
/// known to the text, or nearly one.
fn find_indices_of_adds(model: &mut Model) {
    let mut all = std::mem::take(&mut model.adds);
    for adds in &mut all {
        let Some((over, _)) = model.target(&adds.target) else { continue };
        for (place, of) in adds.places.iter_mut().zip(over) {
            if let Place::One(tokens) = place
                && let [tree] = &trees(tokens.clone())[..]
                && let Some(name) = header::identifier(Some(tree))
                && !is_label(model, &name, &of.set)
            {
                *place = Place::Every(Index { name, ends: None, set: of.set.clone() });
            }
        }
    }
    model.adds = all;
}

/// Whether the text knows this label of a set, or one like it.
fn is_label(model: &Model, name: &Ident, set: &Ident) -> bool {
    let labels = model.fields.iter().find(|field| field.name == *set).map(|field| &field.kind);
    let Some(FieldKind::Labels(labels)) = labels else { return false };
    let (word, labels) = (name.to_string(), labels.iter().map(ToString::to_string));
    let labels: Vec<String> = labels.collect();
    let labels: Vec<&str> = labels.iter().map(String::as_str).collect();
    let near = || word.chars().count() > 2 && nearest(&word, &labels).is_some();
    labels.contains(&word.as_str()) || near()
}

/// A `usize` that something is indexed by is a set.
fn find_sizes(model: &mut Model) {
    let used = used_sets(model);
    for field in &mut model.fields {
        let is_usize = matches!(&field.kind, FieldKind::Value(ty) if is_type(ty, "usize"));
        if is_usize && used.contains(&field.name.to_string()) {
            field.kind = FieldKind::Size;
        }
    }
}

/// Every name that stands where a set stands, also `n` in `sum(n, |k| …)`.
fn used_sets(model: &Model) -> HashSet<String> {
    let mut used: HashSet<String> = model.headers().map(|index| index.set.to_string()).collect();
    for field in &model.fields {
        used.extend(field.over.iter().map(Ident::to_string));
        used.extend(field.kind.sets().iter().map(ToString::to_string));
    }
    for expression in model.expressions() {
        summed_sets(&trees(expression.clone()), &mut used);
    }
    used
}

fn summed_sets(tokens: &[TokenTree], used: &mut HashSet<String>) {
    for (k, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else { continue };
        let inner = trees(group.stream());
        let sums = k.checked_sub(1).is_some_and(|k| is_word(tokens.get(k), &["sum", "prod"]));
        if let Some(set) = word(inner.first()).filter(|_| sums && is_punct(inner.get(1), ',')) {
            used.insert(set.to_string());
        }
        summed_sets(&inner, used);
    }
}
