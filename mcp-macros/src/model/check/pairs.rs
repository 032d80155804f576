//! Every equation with its variable, every variable with its equations.

use super::super::ast::{Body, Bounds, Eq, Fix, Index, Model, Place, Relation, Var};
use super::super::names::{Kind, Names};
use super::indices;
use crate::errors::Errors;
use crate::messages::names::NO_EQUATIONS;
use crate::messages::{pairing as messages, parts};
use crate::nearest::nearest;
use std::collections::{HashMap, HashSet};
use syn::Ident;

/// Variables that have an equation or a value, and the equations over whole families.
#[derive(Default)]
struct Covered {
    variables: HashSet<String>,
    whole: HashMap<String, String>,
    /// A pair names no variable: which one it means is not known.
    unknown: bool,
}

/// Reports wrong pairs and variables without equations.
pub(super) fn check(model: &Model, names: &Names<'_>, errors: &mut Errors) {
    let mut covered = Covered { unknown: model.lost.equations, ..Covered::default() };
    for eq in &model.eqs {
        if let Some(var) = variable(&eq.variable, names, &mut covered, errors) {
            if eq.part != var.part {
                errors.at(&eq.variable, other_part(eq, var, model));
            }
            covered.variables.insert(var.name.to_string());
            check_pair(eq, var, names, &mut covered, errors);
        }
    }
    for fix in &model.fixes {
        if let Some(var) = variable(&fix.variable, names, &mut covered, errors) {
            let family = (&fix.variable, &var.over[..]);
            indices::check_places(&fix.places, family, names, errors);
            if let Some(part) = names.hidden_in(&var.name.to_string(), fix.part) {
                let (word, in_part) = (var.name.to_string(), fix.part.is_some());
                errors.at(&fix.variable, parts::hidden(&word, &part.name.to_string(), in_part));
            } else if is_whole(fix, var) && fix.part == var.part {
                covered.variables.insert(var.name.to_string());
            }
        }
    }
    if model.eqs.is_empty() {
        if !model.lost.equations {
            errors.at(&model.name, NO_EQUATIONS);
        }
    } else if !covered.unknown {
        for var in &model.vars {
            let name = var.name.to_string();
            if !covered.variables.contains(&name) {
                errors.at(&var.name, messages::without_equation(&name));
            }
        }
    }
}

/// An equation pairs with a variable that is on with it, and only with it.
fn other_part(eq: &Eq, var: &Var, model: &Model) -> String {
    let name = |part: Option<usize>| part.map(|part| model.parts[part].name.to_string());
    let (variable, equation) = (var.name.to_string(), eq.name.to_string());
    parts::pair(&variable, name(var.part).as_deref(), &equation, name(eq.part).as_deref())
}

/// The variable of this name, M05 where there is none.
fn variable<'a>(
    name: &Ident,
    names: &Names<'a>,
    covered: &mut Covered,
    errors: &mut Errors,
) -> Option<&'a Var> {
    let word = name.to_string();
    let variables = names.variables();
    let variables: Vec<&str> = variables.iter().map(String::as_str).collect();
    match names.get(&word) {
        Some(Kind::Var(var)) => return Some(var),
        Some(kind) => {
            covered.unknown = true;
            errors.at(name, messages::not_a_variable(&word, kind.noun(), &variables));
        }
        None if names.is_lost(&word) => {}
        None => {
            let nearest = nearest(&word, &variables);
            match nearest {
                Some(nearest) => {
                    covered.variables.insert(nearest.to_owned());
                }
                None => covered.unknown = true,
            }
            errors.at(name, messages::unknown_variable(&word, nearest, &variables));
        }
    }
    None
}

/// Whether every element of the variable is fixed.
fn is_whole(fix: &Fix, var: &Var) -> bool {
    let is_every = |(place, index): (&Place, &Index)| {
        place.index().is_some_and(|every| every.set == index.set)
    };
    fix.places.len() == var.over.len() && fix.places.iter().zip(&var.over).all(is_every)
}

fn check_pair(eq: &Eq, var: &Var, names: &Names<'_>, covered: &mut Covered, errors: &mut Errors) {
    if indices::check_pair(eq, var, names, errors) && eq.condition.is_none() {
        let name = var.name.to_string();
        match covered.whole.get(&name) {
            Some(first) => errors.at(&eq.variable, messages::paired_twice(&name, first)),
            None => {
                covered.whole.insert(name, eq.name.to_string());
            }
        }
    }
    if let Body::Relation { relation, span, .. } = &eq.body
        && let Some(message) = relation_message(&var.name.to_string(), &var.bounds, *relation)
    {
        errors.at_span(*span, message);
    }
}

/// What is wrong with a relation for a variable with these bounds.
fn relation_message(variable: &str, bounds: &Bounds, relation: Relation) -> Option<String> {
    let message = match (bounds, relation) {
        (Bounds::Lower(_), Relation::AtLeast)
        | (Bounds::Upper(_), Relation::AtMost)
        | (Bounds::Free, Relation::Equal) => return None,
        (Bounds::Lower(_), Relation::AtMost) => messages::turned(variable, "a lower", "<=", ">="),
        (Bounds::Upper(_), Relation::AtLeast) => messages::turned(variable, "an upper", ">=", "<="),
        (Bounds::Lower(_), Relation::Equal) => messages::equality(variable, "a lower", ">="),
        (Bounds::Upper(_), Relation::Equal) => messages::equality(variable, "an upper", "<="),
        (Bounds::Free, _) => messages::free(variable),
        (Bounds::Box(..), _) => messages::boxed(variable),
    };
    Some(message)
}
