//! The headers of all items, and the indices that are in scope in each.

use super::super::ast::{FieldKind, Index, Model, Place};
use super::super::names::Names;
use std::collections::HashMap;

/// The indices of an item, each with its set; without one where the set is wrong.
pub(super) type Scope = HashMap<String, Option<String>>;

/// The indices of a header.
pub(super) fn scope<'a>(over: impl IntoIterator<Item = &'a Index>, names: &Names<'_>) -> Scope {
    let known = |set: String| names.set(&set).map(|_| set);
    let mut scope = Scope::new();
    for index in over {
        scope.insert(index.name.to_string(), known(index.set.to_string()));
        let Some((from, to)) = &index.ends else { continue };
        let sets = match names.set(&index.set.to_string()).map(|field| &field.kind) {
            Some(FieldKind::Pairs(a, b)) => (known(a.to_string()), known(b.to_string())),
            _ => (None, None),
        };
        scope.insert(from.to_string(), sets.0);
        scope.insert(to.to_string(), sets.1);
    }
    scope
}

/// Every header of the model, with the part that it stands in.
pub(super) fn all(model: &Model) -> Vec<(Vec<&Index>, Option<usize>)> {
    let mut all: Vec<(Vec<&Index>, Option<usize>)> = Vec::new();
    all.extend(model.params.iter().map(|param| (all_of(&param.over), param.part)));
    all.extend(model.vars.iter().map(|var| (all_of(&var.over), var.part)));
    all.extend(model.fixes.iter().map(|fix| (running(&fix.places), fix.part)));
    all.extend(model.defs.iter().map(|def| (all_of(&def.over), def.part)));
    all.extend(model.eqs.iter().map(|eq| (all_of(&eq.over), eq.part)));
    all.extend(model.reports.iter().map(|report| (all_of(&report.over), report.part)));
    all.extend(model.adds.iter().map(|adds| (adds.over(), Some(adds.part))));
    all
}

fn all_of(over: &[Index]) -> Vec<&Index> {
    over.iter().collect()
}

/// The indices among the places of a `fix`.
pub(super) fn running(places: &[Place]) -> Vec<&Index> {
    places.iter().filter_map(Place::index).collect()
}
