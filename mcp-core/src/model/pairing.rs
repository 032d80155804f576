//! Which variable each row of an equation family is paired with.

use super::builder::{Equation, number};
use super::shape::{EquationFamily, Paired};
use super::{Family, Set};
use crate::error::ModelError;
use crate::problem::small;

/// Resolves every equation's variable and the elements it is paired with.
pub(super) fn pair(
    mut equations: Vec<Equation>,
    variables: &[Family],
) -> Result<Vec<EquationFamily>, ModelError> {
    number(equations.iter_mut().map(|e| &mut e.family));
    let mut paired = Vec::new();
    for Equation { family, variable, elements } in equations {
        let target = variables.iter().find(|v| v.name == variable).ok_or_else(|| {
            let names = variables.iter().map(|v| v.name.as_str());
            let nearest = crate::error::nearest(&variable, names);
            ModelError::UnknownName { kind: "variable", name: variable.clone(), nearest }
        })?;
        let count = elements.as_ref().map_or(target.len, Vec::len);
        if count != family.len {
            return Err(ModelError::PairSize {
                equation: family.name,
                equations: family.len,
                variable,
                variables: count,
            });
        }
        if elements.is_none() {
            check_same_elements(&family, target)?;
        }
        let listed = elements.unwrap_or_default();
        if let Some(&index) = listed.iter().find(|&&k| k >= target.len) {
            return Err(ModelError::ReadOutOfRange {
                row: family.name,
                kind: "paired variable",
                index,
                count: target.len,
            });
        }
        let is_all = listed.iter().enumerate().all(|(index, &k)| index == k);
        let pairs = if is_all {
            Paired::From(target.offset)
        } else {
            Paired::List(listed.into_iter().map(|k| small(target.offset + k)).collect())
        };
        paired.push(EquationFamily { family, pairs });
    }
    Ok(paired)
}

/// Families of the same length are paired by position, but not element `a` of a sparse one with
/// element `b` of another.
fn check_same_elements(equation: &Family, variable: &Family) -> Result<(), ModelError> {
    let is_sparse = equation.is_sparse() || variable.is_sparse();
    let lengths = |family: &Family| family.sets.iter().map(Set::len).collect::<Vec<_>>();
    let same_sets = lengths(equation) == lengths(variable);
    let differs = |&k: &usize| !same_sets || equation.combination(k) != variable.combination(k);
    match (0..equation.len).find(|k| is_sparse && differs(k)) {
        None => Ok(()),
        Some(k) => Err(ModelError::PairElements {
            equation: equation.element_name(k),
            variable: variable.name.clone(),
        }),
    }
}
