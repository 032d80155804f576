//! [`Statement`]: what a model is, before it is solved.

use crate::model::{BoundKind, Family, Shape};
use crate::problem::{Pattern, Problem};

#[cfg(feature = "serde")]
use super::export::number;
use super::norms::Norms;

/// What a model is and how its Jacobian looks at the start: counts, families, pairs, norms of rows
/// and columns, and by name what depends on nothing, is zero or not finite.
///
/// ```
/// use mcp_core::{AdProblem, Statement};
/// # use mcp_core::{Equation, Model, Reader, Real, Scalar, Shape, Variable};
/// # struct Line(Shape);
/// # impl Model for Line {
/// #     fn shape(&self) -> &Shape { &self.0 }
/// #     fn row<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
/// #         2.0 * read.var(0) - 4.0
/// #     }
/// # }
/// # let shape = Shape::builder().variable(Variable::new("x").lower(0.0))
/// #     .equation(Equation::new("f").complements("x")).build()?;
/// let mut problem = AdProblem::new(Line(shape))?; // 2x − 4 ⟂ x >= 0
/// let statement = Statement::new(&mut problem).named("line");
/// assert!(statement.to_string().starts_with("line: 1 variable (1 lower), 1 equation"));
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Statement {
    /// Name of the model, possibly empty.
    pub name: String,
    /// Names of its [parts](crate::Shape::parts) that are on.
    pub parts: Vec<&'static str>,
    /// Number of variables.
    pub variables: usize,
    /// Variables by kind of bounds.
    pub kinds: Kinds,
    /// Number of equations; smaller than that of variables where fixed ones have none.
    pub equations: usize,
    /// Structural nonzeros of the Jacobian.
    pub nonzeros: usize,
    /// Structural nonzeros as a share of `n²`, between 0 and 1; 0 without variables.
    pub density: f64,
    /// Variable families in the order of declaration.
    pub families: Vec<FamilyStatement>,
    /// Equation families in the order of declaration, and what they are paired with.
    pub pairs: Vec<PairStatement>,
    /// Fixed variables without equation.
    pub without_equation: Examples,
    /// Equations that read no variable: constants, whatever the point.
    pub constant_equations: Examples,
    /// Variables in no equation: nothing depends on them, whatever the point.
    pub unread_variables: Examples,
    /// The equation with the smallest row norm that is not zero.
    pub smallest_row: Option<RowNorm>,
    /// The equation with the largest row norm.
    pub largest_row: Option<RowNorm>,
    /// The variable with the smallest column norm that is not zero.
    pub smallest_column: Option<ColumnNorm>,
    /// The variable with the largest column norm.
    pub largest_column: Option<ColumnNorm>,
    /// Equations that read variables, but all of whose derivatives are zero at the start.
    pub zero_rows: Examples,
    /// Variables that equations read, but all derivatives by which are zero at the start.
    pub zero_columns: Examples,
    /// Values of `F` and derivatives that are not finite at the start, such as `` F of `f` = NaN ``.
    pub non_finite: Examples,
}

/// Variables by kind of bounds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Kinds {
    /// No bound.
    pub free: usize,
    /// A lower bound.
    pub lower: usize,
    /// An upper bound.
    pub upper: usize,
    /// Both.
    pub boxed: usize,
    /// Both, and equal.
    pub fixed: usize,
}

/// A variable family.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FamilyStatement {
    /// Its name.
    pub name: String,
    /// Names of its index sets.
    pub sets: Vec<String>,
    /// Number of elements.
    pub size: usize,
    /// Unit of measure, possibly empty.
    pub unit: String,
    /// One line of explanation, possibly empty.
    pub about: String,
}

/// An equation family and the variable family it is complementary to.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct PairStatement {
    /// Name of the equation family.
    pub equation: String,
    /// Name of the variable family; empty for an equation family without rows.
    pub variable: String,
    /// Number of pairs.
    pub size: usize,
    /// Unit of measure of the equation, possibly empty.
    pub unit: String,
    /// One line of explanation of the equation, possibly empty.
    pub about: String,
}

/// The size of one row of the Jacobian.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct RowNorm {
    /// `max_j |J_ij|` at the start, in units of the equation per unit of the variable.
    #[cfg_attr(feature = "serde", serde(serialize_with = "number"))]
    pub norm: f64,
    /// The equation.
    pub equation: String,
}

/// The size of one column of the Jacobian.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct ColumnNorm {
    /// `max_i |J_ij|` at the start, in units of the equation per unit of the variable.
    #[cfg_attr(feature = "serde", serde(serialize_with = "number"))]
    pub norm: f64,
    /// The variable.
    pub variable: String,
}

/// How many there are, and the names of the first.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Examples {
    /// How many.
    pub count: usize,
    /// The first ten.
    pub first: Vec<String>,
}

impl Examples {
    /// Takes note of one more.
    fn note(&mut self, name: impl FnOnce() -> String) {
        self.count += 1;
        if self.first.len() < 10 {
            self.first.push(name());
        }
    }
}

impl Statement {
    /// States the model. Evaluates `F` and `J` once, at the start.
    ///
    /// Norms and zeros leave out fixed variables: their equations need not hold and they do not
    /// move. What is not finite is listed everywhere, since it stops a solve everywhere.
    pub fn new(problem: &mut dyn Problem) -> Self {
        let (n, nnz) = (problem.shape().n(), problem.pattern().nnz());
        let start = problem.shape().start().to_vec();
        let (mut f, mut jac) = (vec![0.0; n], vec![0.0; nnz]);
        problem.evaluate(&start, Some(&mut f), Some(&mut jac));

        let (shape, pattern) = (problem.shape(), problem.pattern());
        let mut statement = Self::of_shape(shape, nnz);
        for (i, &value) in f.iter().enumerate() {
            if !value.is_finite() {
                let name = || format!("F of `{}` = {value}", shape.equation_name(i));
                statement.non_finite.note(name);
            }
        }
        for (k, i, j) in pattern.entries() {
            let value = jac[k];
            if !value.is_finite() {
                statement.non_finite.note(|| {
                    let (equation, variable) = (shape.equation_name(i), shape.variable_name(j));
                    format!("derivative of `{equation}` by `{variable}` = {value}")
                });
            }
        }
        statement.note_unconnected(shape, pattern);
        let norms = Norms::of(shape, pattern, &jac);
        statement.note_norms(shape, &norms);
        statement
    }

    /// Equations and variables without structural nonzeros.
    fn note_unconnected(&mut self, shape: &Shape, pattern: &Pattern) {
        let mut reads = vec![false; pattern.n()];
        pattern.rows().for_each(|i| reads[i] = true);
        for i in 0..pattern.n() {
            if !reads[i] && shape.row_of_variable(i).is_some() {
                self.constant_equations.note(|| shape.equation_name(i));
            }
            if pattern.column(i).is_empty() {
                self.unread_variables.note(|| shape.variable_name(i));
            }
        }
    }

    /// Extreme and zero norms.
    fn note_norms(&mut self, shape: &Shape, norms: &Norms) {
        for i in norms.rows.zeros() {
            self.zero_rows.note(|| shape.equation_name(i));
        }
        for j in norms.columns.zeros() {
            self.zero_columns.note(|| shape.variable_name(j));
        }
        let row = |(i, norm)| RowNorm { norm, equation: shape.equation_name(i) };
        let column = |(j, norm)| ColumnNorm { norm, variable: shape.variable_name(j) };
        self.smallest_row = norms.rows.smallest().map(row);
        self.largest_row = norms.rows.largest().map(row);
        self.smallest_column = norms.columns.smallest().map(column);
        self.largest_column = norms.columns.largest().map(column);
    }

    /// Gives the model a name for the headline.
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = name.into();
        self
    }

    fn of_shape(shape: &Shape, nonzeros: usize) -> Self {
        let n = shape.n();
        let mut kinds = Kinds::default();
        let mut without_equation = Examples::default();
        for i in 0..n {
            let count = match shape.bounds().kind(i) {
                BoundKind::Free => &mut kinds.free,
                BoundKind::Lower => &mut kinds.lower,
                BoundKind::Upper => &mut kinds.upper,
                BoundKind::Boxed => &mut kinds.boxed,
                BoundKind::Fixed => &mut kinds.fixed,
            };
            *count += 1;
            if shape.row_of_variable(i).is_none() {
                without_equation.note(|| shape.variable_name(i));
            }
        }
        Statement {
            name: String::new(),
            parts: shape.parts(),
            variables: n,
            kinds,
            equations: shape.row_count(),
            nonzeros,
            density: if n == 0 { 0.0 } else { nonzeros as f64 / (n as f64 * n as f64) },
            families: shape.variables().iter().map(FamilyStatement::of).collect(),
            pairs: shape.equations().map(|family| PairStatement::of(shape, family)).collect(),
            without_equation,
            constant_equations: Examples::default(),
            unread_variables: Examples::default(),
            smallest_row: None,
            largest_row: None,
            smallest_column: None,
            largest_column: None,
            zero_rows: Examples::default(),
            zero_columns: Examples::default(),
            non_finite: Examples::default(),
        }
    }
}

impl FamilyStatement {
    fn of(family: &Family) -> Self {
        FamilyStatement {
            name: family.name().to_owned(),
            sets: family.sets().iter().map(|set| set.name().to_owned()).collect(),
            size: family.len(),
            unit: family.unit().to_owned(),
            about: family.about().to_owned(),
        }
    }
}

impl PairStatement {
    fn of(shape: &Shape, family: &Family) -> Self {
        let variable = if family.is_empty() {
            String::new()
        } else {
            let first = shape.variable_of_row(family.offset());
            shape.variable_family(first).name().to_owned()
        };
        PairStatement {
            equation: family.name().to_owned(),
            variable,
            size: family.len(),
            unit: family.unit().to_owned(),
            about: family.about().to_owned(),
        }
    }
}
