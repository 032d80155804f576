//! The sets of fields and headers, and the names of indices.

use super::super::ast::{Field, FieldKind, Index, Model};
use super::super::names::{Kind, Names};
use super::family;
use crate::errors::Errors;
use crate::messages::{names as messages, parts};
use syn::Ident;

/// Most index sets of a family.
const MOST_INDICES: usize = 6;

/// Reports sets that are none, and indices that hide something.
pub(super) fn check(model: &Model, names: &Names<'_>, errors: &mut Errors) {
    for field in &model.fields {
        check_field(field, names, errors);
    }
    for (header, part) in family::all(model) {
        check_header(&header, part, names, errors);
    }
}

fn check_field(field: &Field, names: &Names<'_>, errors: &mut Errors) {
    for set in field.over.iter().chain(field.kind.sets()) {
        check_set(set, field.part, names, errors);
    }
    if let Some(seventh) = field.over.get(MOST_INDICES) {
        errors.at(seventh, messages::TOO_MANY_INDICES);
    }
    if is_circular(field, names) {
        errors.at(&field.name, messages::circular(&field.name.to_string()));
    }
}

/// Whether a set is made of itself, directly or through others.
fn is_circular(field: &Field, names: &Names<'_>) -> bool {
    let mut seen: Vec<&Ident> = Vec::new();
    let mut open = field.kind.sets();
    while let Some(set) = open.pop() {
        if *set == field.name {
            return true;
        }
        if !seen.contains(&set) {
            seen.push(set);
            open.extend(
                names.set(&set.to_string()).map(|set| set.kind.sets()).into_iter().flatten(),
            );
        }
    }
    false
}

fn check_set(set: &Ident, part: Option<usize>, names: &Names<'_>, errors: &mut Errors) {
    let word = set.to_string();
    if let Some(hidden) = names.hidden_in(&word, part) {
        errors.at(set, parts::hidden(&word, &hidden.name.to_string(), part.is_some()));
        return;
    }
    if names.set(&word).is_some() || names.is_lost(&word) {
        return;
    }
    let nearest = names.nearest_set(&word).filter(|_| word.len() > 2);
    let message = match names.get(&word) {
        Some(kind) => messages::not_a_set(&word, kind.noun(), nearest.as_deref()),
        None => messages::unknown_set(&word, nearest.as_deref()),
    };
    errors.at(set, message);
}

fn check_header(header: &[&Index], part: Option<usize>, names: &Names<'_>, errors: &mut Errors) {
    if let Some(seventh) = header.get(MOST_INDICES) {
        errors.at(&seventh.name, messages::TOO_MANY_INDICES);
    }
    let mut seen: Vec<&Ident> = Vec::new();
    for index in header {
        let ends = index.ends.iter().flat_map(|(from, to)| [from, to]);
        for name in std::iter::once(&index.name).chain(ends) {
            check_index(name, &seen, names, errors);
            seen.push(name);
        }
        check_set(&index.set, part, names, errors);
        check_ends(index, names, errors);
    }
}

/// M08.
fn check_index(name: &Ident, seen: &[&Ident], names: &Names<'_>, errors: &mut Errors) {
    let word = name.to_string();
    if seen.contains(&name) {
        errors.at(name, messages::index_twice(&word));
    } else if Names::is_reserved(&word) {
        errors.at(name, messages::reserved(&word));
    } else if let Some(kind) = names.get(&word)
        && !matches!(kind, Kind::Eq | Kind::Report)
    {
        errors.at(name, messages::index_shadows(&word, kind.noun()));
    }
}

/// `l @ (i, j)` needs a set of pairs.
fn check_ends(index: &Index, names: &Names<'_>, errors: &mut Errors) {
    let set = index.set.to_string();
    if let (Some((from, _)), Some(field)) = (&index.ends, names.set(&set))
        && !matches!(field.kind, FieldKind::Pairs(..))
    {
        errors.at(from, messages::no_pairs(&index.name.to_string(), &set));
    }
}
