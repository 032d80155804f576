//! [`Shape`]: everything about a model that is not a formula.

use super::bounds::checked_bounds;
use super::builder::{check_start, name_among};
use super::{BoundKind, Bounds, Family, Part, Set, ShapeBuilder, Variable};
use crate::error::{ModelError, nearest};
use crate::problem::{Index, small};
use std::num::NonZero;
use std::sync::Arc;

/// Families, names, bounds, starts, parameters and pairs of a model, and which of its parts are on.
///
/// Variables, definitions and parameters are numbered through in the order of declaration; so are
/// the rows of the equations. `F_i` is the row paired with variable `i`, whatever its own number.
/// Names are made on demand.
///
/// A copy shares what it has in common with its original: families and pairs for good, bounds and start
/// until one of the two changes them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    pub(super) structure: Arc<Structure>,
    bounds: Arc<Bounds>,
    start: Arc<Vec<f64>>,
    pub(super) parameter_values: Vec<f64>,
}

/// What never changes once it is built.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Structure {
    pub(super) variables: Vec<Family>,
    pub(super) equations: Vec<EquationFamily>,
    pub(super) definitions: Vec<Family>,
    pub(super) parameters: Vec<Family>,
    pub(super) reports: Vec<Family>,
    pub(super) parts: Vec<Part>,
    pub(super) row_of: RowOf,
}

/// An equation family and the variable each of its rows is paired with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct EquationFamily {
    pub(crate) family: Family,
    pub(crate) pairs: Paired,
}

/// The variables that the rows of a family are paired with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Paired {
    /// One after the other, from this one on.
    From(usize),
    /// Listed.
    List(Vec<Index>),
}

impl Paired {
    fn variable(&self, index: usize) -> usize {
        match self {
            Paired::From(first) => first + index,
            Paired::List(list) => list[index] as usize,
        }
    }
}

/// Row paired with each variable.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) enum RowOf {
    /// That of the same number.
    #[default]
    Same,
    /// Listed; fixed variables may have none.
    List(Vec<Option<NonZero<Index>>>),
}

impl RowOf {
    /// From a list of the rows, counted from 1.
    fn new(rows: Vec<Option<NonZero<Index>>>) -> Self {
        let is_same = |(i, row): (usize, &Option<NonZero<Index>>)| {
            row.is_some_and(|row| row.get() as usize == i + 1)
        };
        if rows.iter().enumerate().all(is_same) { RowOf::Same } else { RowOf::List(rows) }
    }

    fn variable(&self, i: usize) -> Option<usize> {
        match self {
            RowOf::Same => Some(i),
            RowOf::List(rows) => rows[i].map(|row| row.get() as usize - 1),
        }
    }
}

/// A row as a model is asked for it: see [`Model::row`](crate::Model::row).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// [Entry](Family::entry) of the equation family.
    pub family: usize,
    /// Number of the row in the family.
    pub index: usize,
}

impl Shape {
    /// Starts a declaration.
    pub fn builder() -> ShapeBuilder {
        ShapeBuilder::default()
    }

    /// A copy to be changed apart from this one. Not generic: compiled here, not with every model.
    pub(crate) fn shared_copy(&self) -> Arc<Shape> {
        Arc::new(self.clone())
    }

    /// A shape without names for a problem that is not a model: variables `z[1]`, …, equations
    /// `F[1]`, …, starting at `start` moved into the bounds.
    ///
    /// # Errors
    /// As [`ShapeBuilder::build`].
    pub fn anonymous(lower: &[f64], upper: &[f64], start: &[f64]) -> Result<Self, ModelError> {
        let rows = Set::count("rows", lower.len());
        let variable = Variable::new("z").over(&[&rows]).lower(lower).upper(upper).start(start);
        let equation = super::Equation::new("F").over(&[&rows]).complements("z");
        Self::builder().variable(variable).equation(equation).build()
    }

    /// Finds the row of every variable and checks that it has exactly one; a fixed one may have
    /// none.
    pub(super) fn assemble(
        mut structure: Structure,
        bounds: Bounds,
        start: Vec<f64>,
        parameter_values: Vec<f64>,
    ) -> Result<Self, ModelError> {
        let Structure { variables, equations, .. } = &structure;
        let mut row_of: Vec<Option<NonZero<Index>>> = vec![None; bounds.n()];
        let row_name = |row: usize| {
            let e = equations.partition_point(|e| e.family.offset + e.family.len <= row);
            equations[e].family.element_name(row - equations[e].family.offset)
        };
        for equation in equations {
            for index in 0..equation.family.len {
                let (row, variable) =
                    (equation.family.offset + index, equation.pairs.variable(index));
                let first = row_of[variable];
                row_of[variable] = NonZero::new(small(row + 1));
                if let Some(first) = first {
                    return Err(ModelError::PairedTwice {
                        variable: name_among(variables, variable),
                        first: row_name(first.get() as usize - 1),
                        second: row_name(row),
                    });
                }
            }
        }
        structure.row_of = RowOf::new(row_of);
        let (structure, bounds, start) = (Arc::new(structure), Arc::new(bounds), Arc::new(start));
        let shape = Shape { structure, bounds, start, parameter_values };
        shape.check_paired(&shape.bounds)?;
        Ok(shape)
    }

    /// Only a variable that `bounds` fix may lack an equation.
    fn check_paired(&self, bounds: &Bounds) -> Result<(), ModelError> {
        let lacks =
            |j: usize| self.row_of_variable(j).is_none() && bounds.kind(j) != BoundKind::Fixed;
        match (0..bounds.n()).find(|&j| lacks(j)) {
            Some(j) => Err(ModelError::Unpaired { variable: self.variable_name(j) }),
            None => Ok(()),
        }
    }

    /// Number of variables.
    pub fn n(&self) -> usize {
        self.bounds.n()
    }
    /// Number of rows of `F` that a model computes; smaller than [`n`](Self::n) only where fixed
    /// variables have no equation.
    pub fn row_count(&self) -> usize {
        self.structure.equations.iter().map(|e| e.family.len).sum()
    }
    /// Number of definitions.
    pub fn definition_count(&self) -> usize {
        self.structure.definitions.iter().map(Family::len).sum()
    }

    /// Variable families in the order of declaration.
    pub fn variables(&self) -> &[Family] {
        &self.structure.variables
    }
    /// Equation families in the order of declaration.
    pub fn equations(&self) -> impl ExactSizeIterator<Item = &Family> {
        self.structure.equations.iter().map(|e| &e.family)
    }
    /// Definition families in the order of declaration.
    pub fn definitions(&self) -> &[Family] {
        &self.structure.definitions
    }
    /// Parameter families in the order of declaration.
    pub fn parameters(&self) -> &[Family] {
        &self.structure.parameters
    }
    /// Report families in the order of declaration.
    pub fn reports(&self) -> &[Family] {
        &self.structure.reports
    }
    /// The box.
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }
    /// Where a solve starts unless told otherwise; inside the box.
    pub fn start(&self) -> &[f64] {
        &self.start
    }
    /// Values of all parameters.
    pub fn parameter_values(&self) -> &[f64] {
        &self.parameter_values
    }

    /// The variable family of that name.
    ///
    /// # Errors
    /// [`ModelError::UnknownName`] with the nearest name, [`ModelError::PartOff`].
    pub fn variable(&self, name: &str) -> Result<&Family, ModelError> {
        self.find("variable", &self.structure.variables, name)
    }
    /// The parameter family of that name.
    ///
    /// # Errors
    /// [`ModelError::UnknownName`] with the nearest name, [`ModelError::PartOff`].
    pub fn parameter(&self, name: &str) -> Result<&Family, ModelError> {
        self.find("parameter", &self.structure.parameters, name)
    }
    /// The definition family of that name.
    ///
    /// # Errors
    /// [`ModelError::UnknownName`] with the nearest name, [`ModelError::PartOff`].
    pub fn definition(&self, name: &str) -> Result<&Family, ModelError> {
        self.find("definition", &self.structure.definitions, name)
    }

    /// Changes the start, moving it into the bounds.
    ///
    /// # Errors
    /// [`ModelError::Length`], [`ModelError::StartNotFinite`].
    pub fn set_start(&mut self, start: &[f64]) -> Result<(), ModelError> {
        self.check_start(start)?;
        let own = Arc::make_mut(&mut self.start);
        own.copy_from_slice(start);
        self.bounds.project(own);
        Ok(())
    }

    /// Changes all bounds, moving the start into them.
    ///
    /// # Errors
    /// [`ModelError::Length`], [`ModelError::UnusableBounds`], [`ModelError::CrossedBounds`],
    /// [`ModelError::Unpaired`] for a variable without equation that is no longer fixed.
    pub fn set_bounds(&mut self, lower: &[f64], upper: &[f64]) -> Result<(), ModelError> {
        for (what, bound) in [("lower bounds", lower), ("upper bounds", upper)] {
            if bound.len() != self.n() {
                let (what, found) = (what.to_owned(), bound.len());
                return Err(ModelError::Length { what, expected: self.n(), found });
            }
        }
        let bounds = checked_bounds(lower.to_vec(), upper.to_vec(), |j| {
            name_among(&self.structure.variables, j)
        })?;
        self.check_paired(&bounds)?;
        bounds.project(Arc::make_mut(&mut self.start).as_mut_slice());
        self.bounds = Arc::new(bounds);
        Ok(())
    }

    /// Whether `start` has the right length and finite entries.
    pub(crate) fn check_start(&self, start: &[f64]) -> Result<(), ModelError> {
        if start.len() != self.n() {
            let what = "start".to_owned();
            return Err(ModelError::Length { what, expected: self.n(), found: start.len() });
        }
        check_start(start, |j| self.variable_name(j))
    }

    /// Row number `row` as the model is asked for it.
    pub fn row(&self, row: usize) -> Row {
        let (equation, index) = self.equation_of(row);
        Row { family: equation.family.entry(), index }
    }
    /// The equation family of row number `row`, and its place there.
    fn equation_of(&self, row: usize) -> (&EquationFamily, usize) {
        let equations = &self.structure.equations;
        let equation =
            &equations[equations.partition_point(|e| e.family.offset + e.family.len <= row)];
        (equation, row - equation.family.offset)
    }
    /// The variable that row number `row` is paired with.
    pub fn variable_of_row(&self, row: usize) -> usize {
        let (equation, index) = self.equation_of(row);
        equation.pairs.variable(index)
    }
    /// The row paired with variable `i`; `None` for a fixed variable without equation.
    pub fn row_of_variable(&self, i: usize) -> Option<usize> {
        self.structure.row_of.variable(i)
    }

    /// Name of variable `j`, such as `x[seattle, topeka]`.
    pub fn variable_name(&self, j: usize) -> String {
        name_among(&self.structure.variables, j)
    }
    /// Name of the equation paired with variable `i`: the name of `F_i`.
    pub fn equation_name(&self, i: usize) -> String {
        match self.row_of_variable(i) {
            Some(row) => {
                let (equation, index) = self.equation_of(row);
                equation.family.element_name(index)
            }
            None => format!("(no equation: {} is fixed)", self.variable_name(i)),
        }
    }
    /// Name of definition `k`.
    pub fn definition_name(&self, k: usize) -> String {
        name_among(&self.structure.definitions, k)
    }
    /// The variable family that variable `j` belongs to.
    pub fn variable_family(&self, j: usize) -> &Family {
        Family::of_element(&self.structure.variables, j).0
    }

    fn find<'a>(
        &self,
        kind: &'static str,
        families: &'a [Family],
        name: &str,
    ) -> Result<&'a Family, ModelError> {
        families.iter().find(|f| f.name() == name).ok_or_else(|| {
            let nearest = nearest(name, families.iter().map(Family::name));
            self.unknown_or_off(ModelError::UnknownName { kind, name: name.to_owned(), nearest })
        })
    }
}

#[cfg(test)]
#[path = "shape_tests.rs"]
mod tests;
