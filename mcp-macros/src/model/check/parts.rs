//! Parts: what they require and exclude, and what they add to.

use super::super::ast::{Adds, FieldKind, Model, Part};
use super::super::names::{Kind, Names, is_type};
use super::super::order;
use super::super::rewrite::names_in;
use super::family::scope;
use super::indices;
use super::reads::{Purpose, Reader};
use crate::errors::Errors;
use crate::messages::parts as messages;
use crate::nearest::nearest;
use crate::type_name::type_name;

/// Reports what is wrong with parts and with what they add.
pub(super) fn check(model: &Model, names: &Names<'_>, errors: &mut Errors) {
    for (place, part) in model.parts.iter().enumerate() {
        check_name(place, part, model, errors);
        check_others(place, part, model, names, errors);
    }
    for field in model.fields.iter().filter(|field| field.part.is_some()) {
        if let FieldKind::Value(ty) = &field.kind
            && !is_type(ty, "f64")
        {
            errors.at(&field.name, messages::field_type(&field.name.to_string()));
        }
    }
    for adds in &model.adds {
        check_adds(adds, model, names, errors);
    }
}

/// Every part makes a type of its own.
fn check_name(place: usize, part: &Part, model: &Model, errors: &mut Errors) {
    let name = part.name.to_string();
    let before = &model.parts[..place];
    if before.iter().any(|other| other.name == part.name) {
        errors.at(&part.name, messages::duplicate(&name));
        return;
    }
    let Some(own) = type_name(&part.name) else {
        errors.at(&part.name, messages::no_type(&name));
        return;
    };
    let of_model =
        ["", "Builder", "View", "Sets", "Parts"].map(|end| format!("{}{end}", model.name));
    let is_taken = of_model.iter().any(|taken| own == taken)
        || before.iter().any(|other| type_name(&other.name).as_ref() == Some(&own));
    if is_taken {
        errors.at(&part.name, messages::type_taken(&name, &own.to_string()));
    }
}

/// The parts behind `requires` and `excludes`.
fn check_others(place: usize, part: &Part, model: &Model, names: &Names<'_>, errors: &mut Errors) {
    let all: Vec<String> = model.parts.iter().map(|part| part.name.to_string()).collect();
    let all: Vec<&str> = all.iter().map(String::as_str).filter(|name| part.name != name).collect();
    let required = names.with_required(place);
    let name = part.name.to_string();
    for (word, others) in [("requires", &part.requires), ("excludes", &part.excludes)] {
        for other in others {
            let of = other.to_string();
            let message = match names.part(other) {
                Some(_) if part.name == *other => messages::itself(word, &name),
                Some(other) if word == "excludes" && required.contains(&other) => {
                    messages::never(&name, &of)
                }
                Some(_) => continue,
                None if names.is_lost(&of) => continue,
                None => {
                    let near = nearest(&of, &all).filter(|_| of.chars().count() > 2);
                    messages::unknown(&of, near, &all)
                }
            };
            errors.at(other, message);
        }
    }
}

fn check_adds(adds: &Adds, model: &Model, names: &Names<'_>, errors: &mut Errors) {
    let before = errors.len();
    let mut reader = Reader::new(names, scope(adds.over(), names), errors).of(Some(adds.part));
    for pick in adds.picks() {
        reader.check(pick, Purpose::Data("an index"));
    }
    let has_places = reader.errors.len() == before;
    reader.check(&adds.expression, Purpose::Any);
    let target = adds.target.to_string();
    if let Some(message) = target_message(adds, model, names) {
        errors.at(&adds.target, message);
    } else if let Some((over, _)) = model.target(&adds.target) {
        if has_places {
            indices::check_places(&adds.places, (&adds.target, over), names, errors);
        }
        check_order(adds, &target, model, names, errors);
    }
}

/// What is wrong with the target.
fn target_message(adds: &Adds, model: &Model, names: &Names<'_>) -> Option<String> {
    let target = adds.target.to_string();
    if let Some(part) = names.hidden_in(&target, Some(adds.part)) {
        return Some(messages::hidden(&target, &part.name.to_string(), true));
    }
    match names.get(&target) {
        Some(Kind::Eq | Kind::Def(..)) => None,
        Some(kind) => {
            let eq = model.eqs.iter().find(|eq| eq.variable == adds.target);
            let eq = eq.map(|eq| eq.name.to_string());
            Some(messages::no_target(&target, kind.noun(), eq.as_deref()))
        }
        None if names.is_lost(&target) => None,
        None => {
            let eqs = model.eqs.iter().map(|eq| &eq.name);
            let all = eqs.chain(model.defs.iter().map(|def| &def.name));
            let all: Vec<String> = all.map(ToString::to_string).collect();
            let all: Vec<&str> = all.iter().map(String::as_str).collect();
            Some(messages::unknown_target(&target, nearest(&target, &all), &all))
        }
    }
}

/// What is added to a definition is evaluated before it.
fn check_order(adds: &Adds, target: &str, model: &Model, names: &Names<'_>, errors: &mut Errors) {
    let Some(Kind::Def(place, def)) = names.get(target) else { return };
    if def.lifted {
        return;
    }
    let reads = order::reads(model, names);
    for name in &names_in(&adds.expression) {
        if let Some(Kind::Def(by, read)) = names.get(&name.to_string())
            && !read.lifted
            && order::reaches(&reads, by, place)
        {
            errors.at(name, messages::added_reads_target(&name.to_string(), target));
        }
    }
}
