//! Every expression of a model, with what may be read in it.

use super::super::ast::{Eq, Fix, Model, Place, Var};
use super::super::names::Names;
use super::family::{running, scope};
use super::reads::{Purpose, Reader};
use crate::errors::Errors;

/// Reports what expressions cannot read.
pub(super) fn check(model: &Model, names: &Names<'_>, errors: &mut Errors) {
    for (place, param) in model.params.iter().enumerate() {
        let mut reader = Reader::new(names, scope(&param.over, names), errors).of(param.part);
        if let Some(value) = &param.value {
            reader.check(value, Purpose::Parameter(&model.params[place..]));
        }
    }
    for var in &model.vars {
        check_var(var, names, errors);
    }
    for fix in &model.fixes {
        check_fix(fix, names, errors);
    }
    for (place, def) in model.defs.iter().enumerate() {
        let mut reader = Reader::new(names, scope(&def.over, names), errors).of(def.part);
        reader.check(&def.expression, Purpose::Definition(place, &def.name));
    }
    for eq in &model.eqs {
        check_eq(eq, names, errors);
    }
    for report in &model.reports {
        let mut reader = Reader::new(names, scope(&report.over, names), errors).of(report.part);
        reader.check(&report.expression, Purpose::Any);
    }
}

fn check_var(var: &Var, names: &Names<'_>, errors: &mut Errors) {
    let mut reader = Reader::new(names, scope(&var.over, names), errors).of(var.part);
    for bound in var.bounds.values() {
        reader.check(bound, Purpose::Data("a bound"));
    }
    if let Some(start) = &var.start {
        reader.check(start, Purpose::Data("a start"));
    }
    if let Some(condition) = &var.condition {
        reader.check(condition, Purpose::Data("a condition"));
    }
}

fn check_fix(fix: &Fix, names: &Names<'_>, errors: &mut Errors) {
    let mut reader = Reader::new(names, scope(running(&fix.places), names), errors).of(fix.part);
    for place in &fix.places {
        if let Place::One(element) = place {
            reader.check(element, Purpose::Data("an index"));
        }
    }
    reader.check(&fix.value, Purpose::Data("the value of a `fix`"));
}

fn check_eq(eq: &Eq, names: &Names<'_>, errors: &mut Errors) {
    let mut reader = Reader::new(names, scope(&eq.over, names), errors).of(eq.part);
    if let Some(condition) = &eq.condition {
        reader.check(condition, Purpose::Data("a condition"));
    }
    for side in eq.body.sides() {
        reader.check(side, Purpose::Any);
    }
}
