//! Declarations of a model's families, checked together when the [`Shape`] is built.

use super::bounds::checked_bounds;
use super::pairing::pair;
use super::shape::{RowOf, Structure};
use super::{Bounds, Family, Part, Set, Shape, Values};
use crate::error::ModelError;

macro_rules! describe {
    ($Declaration:ident, $indices:literal) => {
        impl $Declaration {
            #[doc = $indices]
            #[must_use]
            pub fn over(mut self, sets: &[&Set]) -> Self {
                self.family.over(sets);
                self
            }
            /// One for each label of this set, called by the label alone: `x['a']`, not
            /// `family['a']`. For names that come from elsewhere, such as a file.
            ///
            /// ```
            /// # use mcp_core::{Equation, Set, Shape, Variable};
            /// let columns = Set::new("columns", ["x['a','b']", "price"])?;
            /// let shape = Shape::builder()
            ///     .variable(Variable::new("column").labelled(&columns).lower(0.0))
            ///     .equation(Equation::new("row").over(&[&columns]).complements("column"))
            ///     .build()?;
            /// assert_eq!(shape.variable_name(0), "x['a','b']");
            /// assert_eq!(shape.variable_index("price")?, 1);
            /// # Ok::<(), mcp_core::ModelError>(())
            /// ```
            #[must_use]
            pub fn labelled(mut self, set: &Set) -> Self {
                self.family.labelled(set);
                self
            }
            /// Only these combinations of the elements of the sets, in increasing order, each
            /// counted from 0 with the last index fastest; the others do not exist. Lists of
            /// values then have one entry for each of these. See
            /// [`Family::position`](crate::Family::position).
            #[must_use]
            pub fn only(mut self, elements: impl Into<Vec<usize>>) -> Self {
                self.family.only(elements.into());
                self
            }
            /// One line of explanation for reports.
            #[must_use]
            pub fn about(mut self, about: impl Into<String>) -> Self {
                self.family.about = about.into();
                self
            }
            /// Unit of measure for reports.
            #[must_use]
            pub fn unit(mut self, unit: impl Into<String>) -> Self {
                self.family.unit = unit.into();
                self
            }
        }
    };
}

macro_rules! entered {
    ($($Declaration:ident)*) => { $(
        impl $Declaration {
            /// The number that stands for the family in calls of the model.
            #[must_use]
            pub(crate) fn entered(mut self, entry: usize) -> Self {
                self.family.entry = Some(entry);
                self
            }
        }
    )* };
}

entered!(Variable Equation Definition);

/// A family of variables: free and starting at 0 unless said otherwise.
#[derive(Clone, Debug)]
pub struct Variable {
    family: Family,
    lower: Values,
    upper: Values,
    start: Values,
}

describe!(Variable, "One variable for each combination of elements of these sets.");

impl Variable {
    /// Name of element `index` of those that exist.
    pub(crate) fn element_name(&self, index: usize) -> String {
        self.family.element_name(index)
    }
    /// A single free variable; see [`over`](Self::over).
    pub fn new(name: impl Into<String>) -> Self {
        Variable {
            family: Family::new(name.into()),
            lower: Values::Same(f64::NEG_INFINITY),
            upper: Values::Same(f64::INFINITY),
            start: Values::Same(0.0),
        }
    }
    /// Lower bounds; default `-inf`.
    #[must_use]
    pub fn lower(mut self, lower: impl Into<Values>) -> Self {
        self.lower = lower.into();
        self
    }
    /// Upper bounds; default `+inf`.
    #[must_use]
    pub fn upper(mut self, upper: impl Into<Values>) -> Self {
        self.upper = upper.into();
        self
    }
    /// Fixes the variables: their equations may have any value.
    #[must_use]
    pub fn fixed(mut self, value: impl Into<Values>) -> Self {
        self.lower = value.into();
        self.upper = self.lower.clone();
        self.start = self.lower.clone();
        self
    }
    /// Where a solve starts; default 0, moved into the bounds.
    #[must_use]
    pub fn start(mut self, start: impl Into<Values>) -> Self {
        self.start = start.into();
        self
    }
}

/// A family of equations and the variables they are complementary to.
#[derive(Clone, Debug)]
pub struct Equation {
    pub(super) family: Family,
    pub(super) variable: String,
    pub(super) elements: Option<Vec<usize>>,
}

describe!(Equation, "One equation for each combination of elements of these sets.");

impl Equation {
    /// A single equation; see [`over`](Self::over).
    pub fn new(name: impl Into<String>) -> Self {
        Equation { family: Family::new(name.into()), variable: String::new(), elements: None }
    }
    /// One equation for each element of a variable family, complementary to it, called as the
    /// variables with a prefix.
    pub(crate) fn of_each(prefix: &str, variable: &Variable) -> Self {
        let name = variable.family.name.clone();
        let family = Family { name: format!("{prefix}{name}"), ..variable.family.clone() };
        let family = Family { about: String::new(), unit: String::new(), ..family };
        Equation { family, variable: name, elements: None }
    }
    /// Pairs row `k` with element `k` of a variable family of the same size. Where only some
    /// combinations of the sets exist, they must be the same in both families.
    #[must_use]
    pub fn complements(mut self, variable: impl Into<String>) -> Self {
        self.variable = variable.into();
        self
    }
    /// Pairs row `k` with element `elements[k]` of a variable family, so that several equation
    /// families can share one. Elements are counted among those that exist.
    #[must_use]
    pub fn complements_elements(
        mut self,
        variable: impl Into<String>,
        elements: impl Into<Vec<usize>>,
    ) -> Self {
        self.variable = variable.into();
        self.elements = Some(elements.into());
        self
    }
}

/// A family of named sub-expressions, evaluated once per pass and read by rows.
#[derive(Clone, Debug)]
pub struct Definition {
    family: Family,
}

describe!(Definition, "One sub-expression for each combination of elements of these sets.");

impl Definition {
    /// A single definition; see [`over`](Self::over).
    pub fn new(name: impl Into<String>) -> Self {
        Definition { family: Family::new(name.into()) }
    }
}

/// A family of parameters: constants of a solve that can be changed between solves.
#[derive(Clone, Debug)]
pub struct Parameter {
    family: Family,
    values: Values,
}

describe!(Parameter, "One parameter for each combination of elements of these sets.");

impl Parameter {
    /// A parameter with its value; see [`over`](Self::over).
    pub fn new(name: impl Into<String>, values: impl Into<Values>) -> Self {
        Parameter { family: Family::new(name.into()), values: values.into() }
    }
}

/// Collects declarations; [`build`](Self::build) checks them together.
#[derive(Clone, Debug, Default)]
pub struct ShapeBuilder {
    variables: Vec<Variable>,
    equations: Vec<Equation>,
    definitions: Vec<Definition>,
    parameters: Vec<Parameter>,
    reports: Vec<Definition>,
    parts: Vec<Part>,
}

impl ShapeBuilder {
    /// Adds a variable family. Variables are numbered in the order of declaration.
    #[must_use]
    pub fn variable(mut self, variable: Variable) -> Self {
        self.variables.push(variable);
        self
    }
    /// Adds an equation family.
    #[must_use]
    pub fn equation(mut self, equation: Equation) -> Self {
        self.equations.push(equation);
        self
    }
    /// Adds a definition family. It may read earlier ones only.
    #[must_use]
    pub fn definition(mut self, definition: Definition) -> Self {
        self.definitions.push(definition);
        self
    }
    /// Adds a parameter family.
    #[must_use]
    pub fn parameter(mut self, parameter: Parameter) -> Self {
        self.parameters.push(parameter);
        self
    }

    /// Adds a family of reports: numbers that are evaluated at a solution and never read by a row.
    #[must_use]
    pub fn report(mut self, report: Definition) -> Self {
        self.reports.push(report);
        self
    }

    /// Gives the equation or definition family of this name another entry.
    pub(crate) fn enter(&mut self, name: &str, entry: usize) {
        let equations = self.equations.iter_mut().map(|equation| &mut equation.family);
        let definitions = self.definitions.iter_mut().map(|definition| &mut definition.family);
        if let Some(family) = equations.chain(definitions).find(|family| family.name == name) {
            family.entry = Some(entry);
        }
    }

    /// The parts of the model, in the order of its text.
    pub(crate) fn parts(mut self, parts: Vec<Part>) -> Self {
        self.parts = parts;
        self
    }

    /// Checks names, sizes, bounds, starts, parameters and pairs.
    ///
    /// # Errors
    /// The first fault found, by name: [`ModelError::DuplicateName`], [`ModelError::Length`],
    /// [`ModelError::UnusableBounds`], [`ModelError::CrossedBounds`],
    /// [`ModelError::StartNotFinite`], [`ModelError::ParameterNotFinite`],
    /// [`ModelError::UnknownName`], [`ModelError::PairSize`], [`ModelError::PairedTwice`],
    /// [`ModelError::Unpaired`], [`ModelError::TooManyElements`],
    /// [`ModelError::ElementOutOfRange`], [`ModelError::ElementOrder`],
    /// [`ModelError::PairElements`].
    pub fn build(self) -> Result<Shape, ModelError> {
        let ShapeBuilder { mut variables, mut equations, mut definitions, parts, .. } = self;
        let (mut parameters, reports) = (self.parameters, self.reports);
        let mut reports: Vec<Family> = reports.into_iter().map(|report| report.family).collect();
        let mut names = Vec::new();
        names.extend(variables.iter().map(|v| &v.family.name));
        names.extend(equations.iter().map(|e| &e.family.name));
        names.extend(definitions.iter().map(|d| &d.family.name));
        names.extend(parameters.iter().map(|p| &p.family.name));
        names.extend(reports.iter().map(|report| &report.name));
        names.sort_unstable();
        if let Some(pair) = names.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(ModelError::DuplicateName { name: pair[0].clone() });
        }

        let families = variables.iter_mut().map(|v| &mut v.family);
        let families = families.chain(equations.iter_mut().map(|e| &mut e.family));
        let families = families.chain(definitions.iter_mut().map(|d| &mut d.family));
        let families = families.chain(parameters.iter_mut().map(|p| &mut p.family));
        for family in families.chain(&mut reports) {
            family.check_elements()?;
        }

        let (variables, bounds, start) = number_variables(variables)?;
        number(definitions.iter_mut().map(|d| &mut d.family));
        number(parameters.iter_mut().map(|p| &mut p.family));
        number(reports.iter_mut());
        let (mut values, mut families) = (Vec::new(), Vec::with_capacity(parameters.len()));
        for parameter in parameters {
            extend(&mut values, &parameter.family, parameter.values, "value")?;
            families.push(parameter.family);
        }
        let parameters = families;
        check_parameters(&parameters, &values)?;
        let equations = pair(equations, &variables)?;
        let definitions = definitions.into_iter().map(|d| d.family).collect();
        let row_of = RowOf::default();
        let structure =
            Structure { variables, equations, definitions, parameters, reports, parts, row_of };
        Shape::assemble(structure, bounds, start, values)
    }
}

/// Parameters must be finite.
pub(super) fn check_parameters(families: &[Family], values: &[f64]) -> Result<(), ModelError> {
    match values.iter().position(|v| !v.is_finite()) {
        None => Ok(()),
        Some(k) => Err(ModelError::ParameterNotFinite {
            parameter: name_among(families, k),
            value: values[k],
        }),
    }
}

/// Name of element `k` among all elements of the families.
pub(super) fn name_among(families: &[Family], k: usize) -> String {
    let (family, index) = Family::of_element(families, k);
    family.element_name(index)
}

/// Gives every family its offset, and its entry unless it has one.
pub(super) fn number<'a>(families: impl Iterator<Item = &'a mut Family>) {
    let mut offset = 0;
    for (place, family) in families.enumerate() {
        family.offset = offset;
        family.entry.get_or_insert(place);
        offset += family.len;
    }
}

/// Appends one value for each element of the family.
fn extend(
    all: &mut Vec<f64>,
    family: &Family,
    values: Values,
    what: &str,
) -> Result<(), ModelError> {
    match values {
        Values::Same(value) => all.extend(std::iter::repeat_n(value, family.len)),
        Values::Each(each) if each.len() == family.len && all.is_empty() => *all = each,
        Values::Each(each) if each.len() == family.len => all.extend_from_slice(&each),
        Values::Each(each) => {
            return Err(ModelError::Length {
                what: format!("{what} of {}", family.name),
                expected: family.len,
                found: each.len(),
            });
        }
    }
    Ok(())
}

fn number_variables(
    mut variables: Vec<Variable>,
) -> Result<(Vec<Family>, Bounds, Vec<f64>), ModelError> {
    number(variables.iter_mut().map(|v| &mut v.family));
    let (mut lower, mut upper, mut start) = (Vec::new(), Vec::new(), Vec::new());
    let mut families = Vec::with_capacity(variables.len());
    for variable in variables {
        extend(&mut lower, &variable.family, variable.lower, "lower bound")?;
        extend(&mut upper, &variable.family, variable.upper, "upper bound")?;
        extend(&mut start, &variable.family, variable.start, "start")?;
        families.push(variable.family);
    }
    let bounds = checked_bounds(lower, upper, |j| name_among(&families, j))?;
    check_start(&start, |j| name_among(&families, j))?;
    bounds.project(&mut start);
    Ok((families, bounds, start))
}

/// A start must be finite.
pub(crate) fn check_start(start: &[f64], name: impl Fn(usize) -> String) -> Result<(), ModelError> {
    match start.iter().position(|z| !z.is_finite()) {
        None => Ok(()),
        Some(j) => Err(ModelError::StartNotFinite { variable: name(j), value: start[j] }),
    }
}
