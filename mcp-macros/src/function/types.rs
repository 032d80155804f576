//! Looking at types and expressions of the user's text.

use syn::{Expr, GenericArgument, Ident, Lit, PathArguments, Type, TypeArray};

/// The array type behind parentheses and the groups that `macro_rules!` makes.
pub(super) fn array(ty: &Type) -> Option<&TypeArray> {
    match bare(ty) {
        Type::Array(array) => Some(array),
        _ => None,
    }
}

/// Whether the type is `Real<number>`, by any path.
pub(super) fn is_real(ty: &Type, number: &Ident) -> bool {
    let Type::Path(real) = bare(ty) else {
        return false;
    };
    let Some(last) = real.path.segments.last() else {
        return false;
    };
    let PathArguments::AngleBracketed(arguments) = &last.arguments else {
        return false;
    };
    let mut arguments = arguments.args.iter();
    let is_number = |argument: &GenericArgument| match argument {
        GenericArgument::Type(ty) => is_ident(ty, number),
        _ => false,
    };
    real.qself.is_none()
        && last.ident == "Real"
        && arguments.next().is_some_and(is_number)
        && arguments.next().is_none()
}

/// Whether the type is this name.
pub(super) fn is_ident(ty: &Type, name: &Ident) -> bool {
    matches!(bare(ty), Type::Path(path) if path.qself.is_none() && path.path.is_ident(name))
}

fn bare(ty: &Type) -> &Type {
    match ty {
        Type::Group(group) => bare(&group.elem),
        Type::Paren(paren) => bare(&paren.elem),
        _ => ty,
    }
}

/// The expression behind the groups that `macro_rules!` makes.
pub(super) fn ungrouped(expr: &Expr) -> &Expr {
    match expr {
        Expr::Group(group) => ungrouped(&group.expr),
        _ => expr,
    }
}

/// The value of an integer literal.
pub(super) fn literal(expr: &Expr) -> Option<usize> {
    match ungrouped(expr) {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(integer) => integer.base10_parse().ok(),
            _ => None,
        },
        _ => None,
    }
}
