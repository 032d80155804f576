//! The order in which definitions are evaluated: each behind those that it reads, itself or with what
//! parts add to it.

use super::ast::{Def, Model};
use super::names::{Kind, Names};
use super::rewrite::names_in;
use proc_macro2::{Ident, TokenStream};

/// What every definition reads, by places in the text; lifted definitions are variables, whose
/// values are there before.
pub(super) fn reads(model: &Model, names: &Names<'_>) -> Vec<Vec<usize>> {
    let of = |(place, def): (usize, &Def)| {
        let added = model.adds.iter().filter(|adds| adds.target == def.name);
        let added = added.flat_map(|adds| read_by(names, &adds.expression));
        let mut reads = read_by(names, &def.expression);
        reads.extend(added);
        reads.retain(|&read| read != place);
        if def.lifted { Vec::new() } else { reads }
    };
    model.defs.iter().enumerate().map(of).collect()
}

/// The definitions that an expression reads.
pub(super) fn read_by(names: &Names<'_>, expression: &TokenStream) -> Vec<usize> {
    let place = |name: &Ident| match names.get(&name.to_string()) {
        Some(Kind::Def(place, def)) if !def.lifted => Some(place),
        _ => None,
    };
    names_in(expression).iter().filter_map(place).collect()
}

/// Whether `reader` reads `read`, directly or through others.
pub(super) fn reaches(reads: &[Vec<usize>], reader: usize, read: usize) -> bool {
    let (mut open, mut seen) = (vec![reader], vec![false; reads.len()]);
    while let Some(place) = open.pop() {
        if place == read {
            return true;
        }
        if !std::mem::replace(&mut seen[place], true) {
            open.extend(&reads[place]);
        }
    }
    false
}

/// All definitions in the order of evaluation: that of the text wherever it can be.
pub(super) fn order(model: &Model, names: &Names<'_>) -> Vec<usize> {
    let reads = reads(model, names);
    let mut order = Vec::new();
    let mut seen = vec![false; reads.len()];
    for place in 0..reads.len() {
        visit(place, &reads, &mut seen, &mut order);
    }
    order
}

fn visit(place: usize, reads: &[Vec<usize>], seen: &mut [bool], order: &mut Vec<usize>) {
    if std::mem::replace(&mut seen[place], true) {
        return;
    }
    for &read in &reads[place] {
        visit(read, reads, seen, order);
    }
    order.push(place);
}
