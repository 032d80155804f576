//! Rows whose body is one auxiliary variable get the expression that the variable stands for.
//!
//! Pyomo writes `F(x) ⟂ x >= 0` with an auxiliary variable `v` as two rows,
//!
//! ```text
//! a v + c ⟂ x >= 0,      b v + r(z) = 0  with v free,
//! ```
//!
//! whose Jacobian `(0 a; r′ b)` has a zero diagonal even where `F′` is positive definite. With the
//! equation put into the first row,
//!
//! ```text
//! c − (a/b) r(z) ⟂ x >= 0,      b v + r(z) = 0,
//! ```
//!
//! solutions are the same, the Jacobian `(−(a/b) r′ 0; r′ b)` is block triangular, and a method sees
//! the model that the user wrote. The equation goes with `v`, which starts where the equation holds
//! at the start of the others unless the file gives it a start.

use super::segments::{Parts, RowKind};
use super::tape::Op;

/// A row `a v + c` and the equation `b v + r(z) = 0` that takes the place of `v` in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Substitution {
    pub(super) row: usize,
    pub(super) equation: usize,
    pub(super) variable: usize,
    /// `a/b`.
    pub(super) ratio: f64,
    /// `b`.
    pub(super) coefficient: f64,
}

/// Where a variable that may be substituted stands.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Use {
    /// It is no candidate.
    Other,
    /// The body of a row, in no equation yet.
    Body,
    /// In one equation, linearly, with this coefficient.
    Equation(usize, f64),
}

/// What can be substituted: `v` is free, no row complements it, no definition reads it, and it is in the
/// linear part of one equation, which defines no other substituted variable, and in no expression of
/// an equation. `terms(i)` are the linear terms of row `i`, `ops(i)` the operations of its expression
/// unless that is a constant.
pub(super) fn find<'a>(
    parts: &'a Parts,
    terms: impl Fn(usize) -> &'a [(u32, f64)],
    ops: impl Fn(usize) -> &'a [Op],
) -> Vec<Substitution> {
    let bodies = single_variables(parts, &terms, &ops);
    let mut uses = vec![Use::Other; parts.bounds.len()];
    for &(_, variable, _) in &bodies {
        let is_free = parts.bounds[variable] == (f64::NEG_INFINITY, f64::INFINITY);
        uses[variable] = if is_free { Use::Body } else { Use::Other };
    }
    for kind in &parts.rows {
        if let RowKind::Complements { variable, .. } = *kind {
            uses[variable] = Use::Other;
        }
    }
    exclude_nonlinear(parts, &mut uses, &ops);
    for (i, kind) in parts.rows.iter().enumerate() {
        if !kind.is_equation() {
            continue;
        }
        for &(j, coefficient) in terms(i) {
            let variable = &mut uses[j as usize];
            *variable = match *variable {
                Use::Body if coefficient != 0.0 => Use::Equation(i, coefficient),
                _ => Use::Other,
            };
        }
    }
    let mut defines = vec![None; parts.rows.len()];
    let mut found = Vec::new();
    for (row, variable, a) in bodies {
        if let Use::Equation(equation, coefficient) = uses[variable]
            && *defines[equation].get_or_insert(variable) == variable
        {
            let ratio = a / coefficient;
            if ratio.is_normal() {
                found.push(Substitution { row, equation, variable, ratio, coefficient });
            }
        }
    }
    found
}

/// Rows with complements whose body is `a v + c`: row, `v`, `a`.
fn single_variables<'a>(
    parts: &Parts,
    terms: &impl Fn(usize) -> &'a [(u32, f64)],
    ops: &impl Fn(usize) -> &'a [Op],
) -> Vec<(usize, usize, f64)> {
    let mut bodies = Vec::new();
    for (i, kind) in parts.rows.iter().enumerate() {
        if let RowKind::Complements { .. } = kind
            && let [(j, a)] = *terms(i)
            && a != 0.0
            && ops(i).is_empty()
        {
            bodies.push((i, j as usize, a));
        }
    }
    bodies
}

/// Variables in the expression of an equation or in a definition are no candidates.
fn exclude_nonlinear<'a>(parts: &'a Parts, uses: &mut [Use], ops: &impl Fn(usize) -> &'a [Op]) {
    let equations = (0..parts.rows.len()).filter(|&i| parts.rows[i].is_equation());
    let definitions = parts.definitions.iter().map(|sum| parts.tape.ops(&sum.expression));
    for op in equations.map(ops).chain(definitions).flatten() {
        if let Op::Variable(j) = *op {
            uses[j as usize] = Use::Other;
        }
    }
    for sum in &parts.definitions {
        for &(j, _) in &parts.linear[sum.linear.clone()] {
            uses[j as usize] = Use::Other;
        }
    }
}
