//! `param`, `fix`, `def` and `report`.

use super::super::ast::{Def, Fix, Param, Report};
use super::super::tokens::{is_operator, stream};
use super::cursor::Cursor;
use super::header;
use crate::messages::{grammar, habits};
use syn::{Attribute, Ident};

/// `param name[i in set] = expr`.
pub(super) fn param(attributes: Vec<Attribute>, cursor: &mut Cursor<'_>) -> Option<Param> {
    let name = cursor.name("param")?;
    let over = header::indices(cursor, &name)?;
    let value = if cursor.peek().is_none() {
        None
    } else if cursor.take_operator("=") {
        Some(stream(cursor.expression("=")?))
    } else {
        cursor.wrong(grammar::param_value(&name.to_string()));
        return None;
    };
    Some(Param { attributes, name, over, value })
}

/// `fix name[labor] = expr`.
pub(super) fn fix(cursor: &mut Cursor<'_>) -> Option<Fix> {
    let variable = cursor.name("fix")?;
    let places = header::places(cursor, &variable)?;
    if !cursor.take_operator("=") {
        cursor.wrong(grammar::fix_value(&variable.to_string()));
        return None;
    }
    let value = stream(cursor.expression("=")?);
    Some(Fix { variable, places, value })
}

/// `def name[i in set] lifted: expr`.
pub(super) fn def(attributes: Vec<Attribute>, cursor: &mut Cursor<'_>) -> Option<Def> {
    let name = cursor.name("def")?;
    let over = header::indices(cursor, &name)?;
    let lifted = cursor.take_word("lifted");
    colon(cursor, &name)?;
    let expression = stream(cursor.expression(":")?);
    Some(Def { attributes, name, over, lifted, expression })
}

/// `report name[i in set]: expr`.
pub(super) fn report(attributes: Vec<Attribute>, cursor: &mut Cursor<'_>) -> Option<Report> {
    let name = cursor.name("report")?;
    let over = header::indices(cursor, &name)?;
    colon(cursor, &name)?;
    let expression = stream(cursor.expression(":")?);
    Some(Report { attributes, name, over, expression })
}

/// Takes the colon behind a header.
pub(super) fn colon(cursor: &mut Cursor<'_>, name: &Ident) -> Option<()> {
    if cursor.take_operator(":") {
        return Some(());
    }
    if is_operator(cursor.trees, cursor.at, "..") {
        cursor.wrong(habits::DOTS);
        cursor.at += 2;
        return Some(());
    }
    cursor.wrong(grammar::colon_missing(&name.to_string()));
    None
}
