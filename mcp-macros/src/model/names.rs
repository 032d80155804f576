//! [`Names`]: everything that is declared, in one name space.

use super::ast::{Def, Field, FieldKind, Index, Model, Param, Part, Var};
use crate::errors::Errors;
use crate::messages::names as messages;
use crate::nearest::nearest;
use std::collections::{HashMap, HashSet};
use syn::{Ident, Type};

/// Names that mean something else.
const RESERVED: [&str; 15] = [
    "build",
    "complements",
    "self",
    "sum",
    "prod",
    "when",
    "max",
    "min",
    "select",
    "atan2",
    "hypot",
    "logsumexp",
    "smooth_max",
    "smooth_min",
    "external",
];

/// What a name stands for.
#[derive(Clone, Copy)]
pub(super) enum Kind<'a> {
    Field(&'a Field),
    /// A label, with its set.
    Label(&'a Ident),
    Param(&'a Param),
    Var(&'a Var),
    /// A definition, with its place among all.
    Def(usize, &'a Def),
    Eq,
    Report,
}

impl Kind<'_> {
    /// What it is, with its article.
    pub(super) fn noun(&self) -> &'static str {
        match self {
            Kind::Field(field) => match field.kind {
                FieldKind::Map(..) => "a map",
                FieldKind::Table => "a table",
                FieldKind::Value(_) => "a datum",
                _ => "a set",
            },
            Kind::Label(_) => "a label",
            Kind::Param(_) => "a parameter",
            Kind::Var(_) => "a variable",
            Kind::Def(..) => "a definition",
            Kind::Eq => "an equation",
            Kind::Report => "a report",
        }
    }

    /// The sets it is indexed by; nothing where brackets have a meaning of their own.
    pub(super) fn sets(&self) -> Option<Vec<String>> {
        let strings = |over: &[Ident]| over.iter().map(ToString::to_string).collect();
        let of = |over: &[Index]| over.iter().map(|index| index.set.to_string()).collect();
        Some(match self {
            Kind::Field(field) => match &field.kind {
                FieldKind::Table => strings(&field.over),
                FieldKind::Map(from, _) => vec![from.to_string()],
                FieldKind::Value(ty) if is_type(ty, "f64") => Vec::new(),
                _ => return None,
            },
            Kind::Param(param) => of(&param.over),
            Kind::Var(var) => of(&var.over),
            Kind::Def(_, def) => of(&def.over),
            Kind::Label(_) | Kind::Eq | Kind::Report => return None,
        })
    }
}

/// Everything that is declared.
pub(super) struct Names<'a> {
    kinds: HashMap<String, Kind<'a>>,
    order: Vec<&'a Ident>,
    lost: HashSet<&'a str>,
    /// The part that a name is declared in.
    part_of: HashMap<String, usize>,
    parts: &'a [Part],
}

impl<'a> Names<'a> {
    /// All names of the model; a name that is declared before is reported.
    pub(super) fn of(model: &'a Model, errors: &mut Errors) -> Self {
        let lost = model.lost.names.iter().map(String::as_str).collect();
        let mut names = Names {
            kinds: HashMap::new(),
            order: Vec::new(),
            lost,
            part_of: HashMap::new(),
            parts: &model.parts,
        };
        for (name, kind, part) in declared(model) {
            let word = name.to_string();
            if Self::is_reserved(&word) {
                errors.at(name, messages::reserved(&word));
            }
            if let Some(first) = names.kinds.get(&word) {
                errors.at(name, messages::duplicate(&word, first.noun(), kind.noun()));
            } else {
                names.part_of.extend(part.map(|part| (word.clone(), part)));
                names.kinds.insert(word, kind);
                names.order.push(name);
            }
        }
        names
    }

    /// Whether the name means something else in the language.
    pub(super) fn is_reserved(name: &str) -> bool {
        RESERVED.contains(&name) || name.starts_with("__")
    }

    /// What the name stands for.
    pub(super) fn get(&self, name: &str) -> Option<Kind<'a>> {
        self.kinds.get(name).copied()
    }

    /// The part that a name is declared in, where `reader`, a part or the model itself, does not see
    /// it: a part sees the model, itself and what it requires.
    pub(super) fn hidden_in(&self, name: &str, reader: Option<usize>) -> Option<&'a Part> {
        let owner = *self.part_of.get(name)?;
        let sees = reader.is_some_and(|reader| self.with_required(reader).contains(&owner));
        if sees { None } else { self.parts.get(owner) }
    }

    /// A part and all that it requires, directly or through others.
    pub(super) fn with_required(&self, part: usize) -> Vec<usize> {
        let mut all = vec![part];
        let mut next = 0;
        while let Some(part) = all.get(next).and_then(|&part| self.parts.get(part)) {
            let required = part.requires.iter().filter_map(|name| self.part(name));
            let new: Vec<usize> = required.filter(|part| !all.contains(part)).collect();
            all.extend(new);
            next += 1;
        }
        all
    }

    /// The place of the part of this name.
    pub(super) fn part(&self, name: &Ident) -> Option<usize> {
        self.parts.iter().position(|part| part.name == *name)
    }

    /// Whether the name may stand in an item that could not be read.
    pub(super) fn is_lost(&self, name: &str) -> bool {
        self.lost.contains(name)
    }

    /// The field, if it is a set.
    pub(super) fn set(&self, name: &str) -> Option<&'a Field> {
        match self.get(name) {
            Some(Kind::Field(field)) if field.kind.is_set() => Some(field),
            _ => None,
        }
    }

    /// The names of all variables.
    pub(super) fn variables(&self) -> Vec<String> {
        let is_variable =
            |name: &&&Ident| matches!(self.get(&name.to_string()), Some(Kind::Var(_)));
        self.order.iter().filter(is_variable).map(ToString::to_string).collect()
    }

    /// The names of all that is read with brackets.
    pub(super) fn families(&self) -> Vec<String> {
        let names = self.order.iter().map(ToString::to_string);
        let is_family = |name: &String| {
            let sets = self.get(name).and_then(|kind| kind.sets());
            sets.is_some_and(|sets| !sets.is_empty())
        };
        names.filter(is_family).collect()
    }

    /// The names of all that is read without brackets.
    pub(super) fn without_brackets(&self) -> Vec<String> {
        let families = self.families();
        let is_value = |name: &String| {
            !families.contains(name) && !matches!(self.get(name), Some(Kind::Eq | Kind::Report))
        };
        self.order.iter().map(ToString::to_string).filter(is_value).collect()
    }

    /// The set with a name like this.
    pub(super) fn nearest_set(&self, name: &str) -> Option<String> {
        let sets: Vec<String> = self.order.iter().map(ToString::to_string).collect();
        let sets: Vec<&str> =
            sets.iter().map(String::as_str).filter(|set| self.set(set).is_some()).collect();
        nearest(name, &sets).map(str::to_owned)
    }

    /// Whether an element of `inner` is one of `outer`; unknown sets are not judged.
    pub(super) fn is_within(&self, inner: &str, outer: &str) -> bool {
        let (Some(mut field), Some(_)) = (self.set(inner), self.set(outer)) else { return true };
        for _ in 0..=self.order.len() {
            if field.name == outer {
                return true;
            }
            let FieldKind::Subset(of) = &field.kind else { return false };
            let Some(above) = self.set(&of.to_string()) else { return true };
            field = above;
        }
        true
    }
}

/// Every declared name with what it stands for and its part, in the order of the text.
fn declared(model: &Model) -> Vec<(&Ident, Kind<'_>, Option<usize>)> {
    let mut all: Vec<(&Ident, Kind<'_>, Option<usize>)> = Vec::new();
    for field in &model.fields {
        all.push((&field.name, Kind::Field(field), field.part));
        if let FieldKind::Labels(labels) = &field.kind {
            all.extend(labels.iter().map(|label| (label, Kind::Label(&field.name), field.part)));
        }
    }
    all.extend(model.params.iter().map(|param| (&param.name, Kind::Param(param), param.part)));
    all.extend(model.vars.iter().map(|var| (&var.name, Kind::Var(var), var.part)));
    let defs = model.defs.iter().enumerate();
    all.extend(defs.map(|(place, def)| (&def.name, Kind::Def(place, def), def.part)));
    all.extend(model.eqs.iter().map(|eq| (&eq.name, Kind::Eq, eq.part)));
    all.extend(model.reports.iter().map(|report| (&report.name, Kind::Report, report.part)));
    all.sort_by_key(|(name, ..)| {
        let start = name.span().start();
        (start.line, start.column)
    });
    all
}

/// Whether a value of this type is stored by itself rather than shared.
pub(super) fn is_number(value: &Type) -> bool {
    let numbers = ["f64", "f32", "usize", "isize", "i32", "u32", "i64", "u64", "bool"];
    numbers.iter().any(|number| is_type(value, number))
}

/// Whether the type is written as this word.
pub(super) fn is_type(value: &Type, word: &str) -> bool {
    matches!(value, Type::Path(path) if path.path.is_ident(word))
}
