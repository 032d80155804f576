//! The brackets behind `complements` and `fix`.

use super::super::ast::{Eq, FieldKind, Index, Place, Var};
use super::super::names::{Kind, Names};
use super::super::tokens::{group, is_punct, is_word, stream, text, trees, word};
use crate::errors::Errors;
use crate::messages::{pairing as messages, reading};
use crate::nearest::nearest;
use proc_macro2::{Delimiter, TokenTree};
use syn::Ident;

/// Reports wrong pieces of a pair; whether every piece is an index over the whole set of the
/// variable.
pub(super) fn check_pair(eq: &Eq, var: &Var, names: &Names<'_>, errors: &mut Errors) -> bool {
    let name = var.name.to_string();
    if eq.pair.len() != var.over.len() {
        errors.at_span(eq.pair_end, rank(&var.name, &var.over, eq.pair.len()));
        return false;
    }
    let pieces: Vec<Vec<TokenTree>> = eq.pair.iter().cloned().map(trees).collect();
    let used: Vec<&Ident> =
        pieces.iter().filter_map(|piece| index_of(eq, piece)).map(|(word, _)| word).collect();
    if !is_in_order(eq, &used, errors) {
        return false;
    }
    let before = errors.len();
    let mut whole = true;
    for (place, (piece, of)) in pieces.iter().zip(&var.over).enumerate() {
        let required = of.set.to_string();
        if let Some((word, index)) = index_of(eq, piece) {
            let set = index.set.to_string();
            whole &= set == required;
            if !names.is_within(&set, &required) {
                let message = reading::other_set(&word.to_string(), &set, &name, place, &required);
                errors.at(word, message);
            }
        } else {
            whole = false;
            check_element(eq, piece, &name, place, &required, names, errors);
        }
    }
    if errors.len() == before
        && let Some(missing) = eq.over.iter().find(|index| !used.contains(&&index.name))
    {
        let message = messages::index_missing(&eq.name.to_string(), &missing.name.to_string());
        errors.at_span(eq.pair_end, message);
    }
    whole && used.len() == eq.over.len() && errors.len() == before
}

/// The index of the equation that is this piece.
fn index_of<'a, 'b>(eq: &'a Eq, piece: &'b [TokenTree]) -> Option<(&'b Ident, &'a Index)> {
    let [only] = piece else { return None };
    let word = word(Some(only))?;
    eq.over.iter().find(|index| index.name == *word).map(|index| (word, index))
}

/// Whether the indices stand in the order of the equation; `x[i, i]` is a diagonal.
fn is_in_order(eq: &Eq, used: &[&Ident], errors: &mut Errors) -> bool {
    let first = |k: &usize| !used[..*k].contains(&used[*k]);
    let used: Vec<&Ident> = (0..used.len()).filter(first).map(|k| used[k]).collect();
    let ordered: Vec<&Ident> =
        eq.over.iter().map(|index| &index.name).filter(|name| used.contains(name)).collect();
    let Some(k) = (0..used.len()).find(|&k| used[k] != ordered[k]) else { return true };
    let all: Vec<String> = eq.over.iter().map(|index| index.name.to_string()).collect();
    let all: Vec<&str> = all.iter().map(String::as_str).collect();
    errors.at(used[k], messages::order(&eq.name.to_string(), &all));
    false
}

/// A piece that is no index: a label, or the first or last element of a set.
fn check_element(
    eq: &Eq,
    piece: &[TokenTree],
    variable: &str,
    place: usize,
    required: &str,
    names: &Names<'_>,
    errors: &mut Errors,
) {
    let end = |word: &Ident| {
        let is_end =
            |index: &&Index| index.ends.as_ref().is_some_and(|(a, b)| a == word || b == word);
        eq.over.iter().find(is_end)
    };
    match piece {
        [tree] if let Some(index) = word(Some(tree)).and_then(end) => {
            let message = messages::end_in_pair(&tree.to_string(), &index.name.to_string());
            errors.at(tree, message);
        }
        _ if is_element(piece, variable, place, required, names, errors) => {}
        _ => {
            let shown = text(piece);
            let nearest = nearest_piece(eq, &shown, required, names);
            let message =
                messages::unknown_piece(&shown, &eq.name.to_string(), required, nearest.as_deref());
            errors.at(stream(piece), message);
        }
    }
}

/// The index of the equation or the label of the set nearest to a word.
fn nearest_piece(eq: &Eq, word: &str, set: &str, names: &Names<'_>) -> Option<String> {
    let mut known: Vec<String> = eq.over.iter().map(|index| index.name.to_string()).collect();
    if let Some(FieldKind::Labels(labels)) = names.set(set).map(|field| &field.kind) {
        known.extend(labels.iter().map(ToString::to_string));
    }
    let known: Vec<&str> = known.iter().map(String::as_str).collect();
    nearest(word, &known).filter(|_| word.len() > 2).map(str::to_owned)
}

/// Whether the piece is a label or `set.first()`; one of another set is reported.
fn is_element(
    piece: &[TokenTree],
    variable: &str,
    place: usize,
    required: &str,
    names: &Names<'_>,
    errors: &mut Errors,
) -> bool {
    let Some(first) = word(piece.first()) else { return false };
    let (name, shown) = (first.to_string(), text(piece));
    match names.get(&name) {
        Some(Kind::Label(set)) if piece.len() == 1 => {
            if !names.is_within(&set.to_string(), required) {
                let of = set.to_string();
                errors.at(first, reading::other_label(&name, &of, variable, place, required));
            }
            true
        }
        Some(Kind::Field(field)) if field.kind.is_set() && is_extreme(piece) => {
            if !field.kind.is_ordered() {
                errors.at(first, messages::no_order(&name));
            } else if !names.is_within(&name, required) {
                let message = reading::other_set(&shown, &name, variable, place, required);
                errors.at(first, message);
            }
            true
        }
        None => piece.len() == 1 && names.is_lost(&name),
        _ => false,
    }
}

/// `….first()` or `….last()`.
fn is_extreme(piece: &[TokenTree]) -> bool {
    piece.len() == 4
        && is_punct(piece.get(1), '.')
        && is_word(piece.get(2), &["first", "last"])
        && group(piece.get(3), Delimiter::Parenthesis).is_some()
}

/// Reports wrong places of a `fix`, or of what a part adds to: a family with these indices.
pub(super) fn check_places(
    places: &[Place],
    (family, over): (&Ident, &[Index]),
    names: &Names<'_>,
    errors: &mut Errors,
) {
    let name = family.to_string();
    if places.len() != over.len() {
        errors.at(family, rank(family, over, places.len()));
        return;
    }
    for (place, (fixed, of)) in places.iter().zip(over).enumerate() {
        let required = of.set.to_string();
        match fixed {
            Place::Every(index) => {
                let set = index.set.to_string();
                if !names.is_within(&set, &required) {
                    let index_name = index.name.to_string();
                    let message = reading::other_set(&index_name, &set, &name, place, &required);
                    errors.at(&index.name, message);
                }
            }
            Place::One(tokens) => {
                let piece = trees(tokens.clone());
                if !is_element(&piece, &name, place, &required, names, errors) && piece.len() == 1 {
                    let text = tokens.to_string();
                    errors.at(tokens, messages::unknown_label(&text, &required));
                }
            }
        }
    }
}

/// M06 with the sets of the family.
fn rank(family: &Ident, over: &[Index], given: usize) -> String {
    let sets: Vec<String> = over.iter().map(|index| index.set.to_string()).collect();
    let sets: Vec<&str> = sets.iter().map(String::as_str).collect();
    messages::rank(&family.to_string(), &sets, given)
}
