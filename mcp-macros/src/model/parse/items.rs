//! `param`, `fix`, `def`, `report`, `adds` and the head of a `part`.

use super::super::ast::{Adds, Def, Fix, Param, Part, Report};
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
    Some(Param { attributes, name, over, value, part: None })
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
    Some(Fix { variable, places, value, part: None })
}

/// `def name[i in set] lifted: expr`.
pub(super) fn def(attributes: Vec<Attribute>, cursor: &mut Cursor<'_>) -> Option<Def> {
    let name = cursor.name("def")?;
    let over = header::indices(cursor, &name)?;
    let lifted = cursor.take_word("lifted");
    colon(cursor, &name)?;
    let expression = stream(cursor.expression(":")?);
    Some(Def { attributes, name, over, lifted, expression, part: None })
}

/// `report name[i in set]: expr`.
pub(super) fn report(attributes: Vec<Attribute>, cursor: &mut Cursor<'_>) -> Option<Report> {
    let name = cursor.name("report")?;
    let over = header::indices(cursor, &name)?;
    colon(cursor, &name)?;
    let expression = stream(cursor.expression(":")?);
    Some(Report { attributes, name, over, expression, part: None })
}

/// `adds target[i in set]: expr`, in a part.
pub(super) fn adds(part: usize, cursor: &mut Cursor<'_>) -> Option<Adds> {
    let target = cursor.name("adds")?;
    let places = header::places(cursor, &target)?;
    colon(cursor, &target)?;
    let expression = stream(cursor.expression(":")?);
    Some(Adds { target, places, expression, part })
}

/// `part name requires a, b excludes c`, without the block.
pub(super) fn part(attributes: Vec<Attribute>, cursor: &mut Cursor<'_>) -> Option<Part> {
    let name = cursor.name("part")?;
    let (mut requires, mut excludes) = (Vec::new(), Vec::new());
    loop {
        if cursor.take_word("requires") {
            requires.extend(others(cursor, "requires")?);
        } else if cursor.take_word("excludes") {
            excludes.extend(others(cursor, "excludes")?);
        } else {
            return Some(Part { attributes, name, requires, excludes });
        }
    }
}

/// The parts behind `requires` or `excludes`.
fn others(cursor: &mut Cursor<'_>, word: &str) -> Option<Vec<Ident>> {
    let mut others = vec![cursor.name(word)?];
    while cursor.take_operator(",") {
        others.push(cursor.name(word)?);
    }
    Some(others)
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
