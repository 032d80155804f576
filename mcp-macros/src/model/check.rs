//! What is wrong with a model that could be read: names, sets, pairs, and what expressions read.

mod control;
mod expressions;
mod family;
mod headers;
mod indices;
mod locals;
mod pairs;
mod parts;
mod reads;
mod sums;

use super::ast::Model;
use super::names::Names;
use crate::errors::Errors;
use crate::messages;

/// Reports everything that is wrong.
pub(super) fn model(model: &Model, names: &Names<'_>, errors: &mut Errors) {
    headers::check(model, names, errors);
    if model.vars.is_empty() {
        if model.lost.names.is_empty() && !model.lost.equations {
            errors.at(&model.name, messages::names::NO_VARIABLES);
        }
    } else {
        pairs::check(model, names, errors);
    }
    expressions::check(model, names, errors);
    parts::check(model, names, errors);
}
