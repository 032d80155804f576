//! The fields of a `data { … }` block.

use super::super::ast::{Field, FieldKind, Model};
use super::super::tokens::{group, is_operator, is_punct, parts, stream, trees, word};
use super::header::identifier;
use super::split::attributes;
use crate::errors::Errors;
use crate::messages::grammar;
use crate::nearest::nearest;
use proc_macro2::{Delimiter, Group, TokenTree};
use syn::{Ident, LitInt, Type};

/// Reads all fields, going on behind one that is wrong.
pub(super) fn fields(
    trees: &[TokenTree],
    belongs_to: Option<usize>,
    model: &mut Model,
    errors: &mut Errors,
) {
    for part in separate(trees, errors) {
        if part.is_empty() {
            continue;
        }
        if let Some(field) = field(part, errors) {
            model.fields.push(Field { part: belongs_to, ..field });
        } else {
            let names = part.iter().filter_map(|tree| word(Some(tree)));
            model.lost.names.extend(names.take(1).map(ToString::to_string));
        }
    }
}

/// The parts between the commas; a comma between `<` and `>` belongs to a type.
fn separate<'a>(trees: &'a [TokenTree], errors: &mut Errors) -> Vec<&'a [TokenTree]> {
    let (mut parts, mut start, mut depth) = (Vec::new(), 0, 0_usize);
    for (k, tree) in trees.iter().enumerate() {
        let arrow = k > 0 && is_operator(trees, k - 1, "->");
        if is_punct(Some(tree), '<') {
            depth += 1;
        } else if is_punct(Some(tree), '>') && !arrow {
            depth = depth.saturating_sub(1);
        }
        let semicolon = is_punct(Some(tree), ';');
        if semicolon {
            errors.at(tree, grammar::FIELD_COMMA);
        }
        if semicolon || is_punct(Some(tree), ',') && depth == 0 {
            parts.push(&trees[start..k]);
            (start, depth) = (k + 1, 0);
        }
    }
    parts.push(&trees[start..]);
    parts
}

/// `name[sets]: kind`.
fn field(part: &[TokenTree], errors: &mut Errors) -> Option<Field> {
    let mut at = 0;
    let attributes = attributes(part, &mut at, errors);
    let Some(name) = identifier(part.get(at)) else {
        errors.at(&part[at.min(part.len() - 1)], grammar::FIELD);
        return None;
    };
    at += 1;
    let over = match group(part.get(at), Delimiter::Bracket) {
        Some(brackets) => {
            at += 1;
            names(brackets, errors)?
        }
        None => Vec::new(),
    };
    if !is_punct(part.get(at), ':') || at + 1 == part.len() {
        let place = part.get(at).unwrap_or(&part[at - 1]);
        errors.at(place, grammar::kind_missing(&name.to_string()));
        return None;
    }
    let kind = kind(&name, !over.is_empty(), &part[at + 1..], errors)?;
    Some(Field { attributes, name, over, kind, part: None })
}

/// The names in a group.
fn names(of: &Group, errors: &mut Errors) -> Option<Vec<Ident>> {
    let trees = trees(of.stream());
    let names: Option<Vec<Ident>> = parts(&trees)
        .into_iter()
        .map(|part| identifier(part.first()).filter(|_| part.len() == 1))
        .collect();
    let names = names.filter(|names| !names.is_empty());
    if names.is_none() {
        errors.at(of, grammar::NAMES);
    }
    names
}

/// What stands behind the colon.
fn kind(
    name: &Ident,
    indexed: bool,
    trees: &[TokenTree],
    errors: &mut Errors,
) -> Option<FieldKind> {
    let first = word(trees.first()).map(ToString::to_string).unwrap_or_default();
    if indexed {
        if first == "f64" && trees.len() == 1 {
            return Some(FieldKind::Table);
        }
        errors.at(&trees[0], grammar::table_type(&name.to_string()));
        return None;
    }
    match trees {
        [TokenTree::Literal(_)] => {
            let count = syn::parse2::<LitInt>(stream(trees));
            let wrong = |_| errors.at(&trees[0], grammar::COUNT);
            count.map_err(wrong).ok().map(FieldKind::Count)
        }
        [_, TokenTree::Group(group)]
            if !first.is_empty() && group.delimiter() != Delimiter::Brace =>
        {
            with_arguments(&first, &trees[0], group, errors)
        }
        [word] if grammar::KINDS.contains(&first.as_str()) => match first.as_str() {
            "Set" => Some(FieldKind::Set),
            "Ordered" => Some(FieldKind::Ordered),
            _ => {
                errors.at(word, grammar::kind_form(&first));
                None
            }
        },
        [word] if matches!(first.as_str(), "set" | "ordered" | "Sets") => {
            errors.at(word, grammar::unknown_kind(&first, nearest(&first, &grammar::KINDS)));
            None
        }
        _ => value(trees, errors),
    }
}

/// `Set[…]`, `Subset(…)`, `Pairs(…)`, `Map(…)`.
fn with_arguments(
    word: &str,
    place: &TokenTree,
    arguments: &Group,
    errors: &mut Errors,
) -> Option<FieldKind> {
    if !grammar::KINDS.contains(&word) {
        errors.at(place, grammar::unknown_kind(word, nearest(word, &grammar::KINDS)));
        return None;
    }
    let brackets = arguments.delimiter() == Delimiter::Bracket;
    let mut names = names(arguments, errors)?.into_iter();
    let kind = match (word, brackets, names.len()) {
        ("Set", true, _) => return Some(FieldKind::Labels(names.collect())),
        ("Subset", false, 1) => names.next().map(FieldKind::Subset),
        ("Pairs", false, 2) => names.next().zip(names.next()).map(|(a, b)| FieldKind::Pairs(a, b)),
        ("Map", false, 2) => names.next().zip(names.next()).map(|(a, b)| FieldKind::Map(a, b)),
        _ => None,
    };
    if kind.is_none() {
        errors.at(place, grammar::kind_form(word));
    }
    kind
}

/// Any type.
fn value(trees: &[TokenTree], errors: &mut Errors) -> Option<FieldKind> {
    let whole = syn::parse2::<Type>(stream(trees));
    if let Ok(ty) = whole {
        return Some(FieldKind::Value(ty));
    }
    let behind = (1..trees.len()).find(|&k| syn::parse2::<Type>(stream(&trees[..k])).is_ok());
    match behind {
        Some(k) if word(trees.get(k)).is_some() => errors.at(&trees[k], grammar::FIELD_COMMA),
        _ => errors.at(&trees[0], grammar::TYPE),
    }
    None
}
