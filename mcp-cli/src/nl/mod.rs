//! AMPL's `.nl` files as models.
//!
//! AMPL, Pyomo and other modelling systems write a problem as one file, text or binary: ten lines
//! of header, then segments with expressions in prefix notation, linear terms, bounds and starts
//! ([Gay05](mcp_core#references)). [`NlModel`] reads the mixed complementarity problems among them:
//!
//! ```
//! use mcp_cli::nl::{Names, NlModel};
//! use mcp_core::{Options, solve};
//!
//! // 2 z + 1 − 5 >= 0 ⟂ z >= 0, the row with its constant in C, its variable in r, its slope in J.
//! let nl = b"g3 1 1 0
//!  1 1 0 0 0
//!  0 0 1 0 0 0
//!  0 0
//!  0 0 0
//!  0 0 0 1
//!  0 0 0 0 0
//!  1 0
//!  0 0
//!  0 0 0 0 0
//! C0
//! n-4
//! r
//! 5 1 1
//! b
//! 2 0
//! k0
//! J0 1
//! 0 2
//! ";
//! let model = NlModel::parse(nl, Names::default())?;
//! let solution = solve(&model, &Options::default())?.solved()?;
//! assert!((solution.level("_svar[1]")? - 2.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! What becomes of rows and bounds: rows with `complements` are `F`, equations go with the free
//! variables that are left, inequalities without a variable are an error that names the row, and so
//! are integers, objectives and imported functions. Where a row says which bounds of its variable
//! are finite, the bounds must agree. Defined variables (segments `V`) become definitions, each
//! evaluated once, or auxiliary variables where definitions would fill the Jacobian. A row is cut into
//! pieces, auxiliary variables too, where it is a sum so long that its gradient would take more than
//! about 10⁸ operations; products and defined variables of that length are not cut, and slow.
//! Pyomo's auxiliary variable for the body of a row is replaced, in that row, by what its equation
//! says it is.
//!
//! Kinks: `abs`, `min`, `max`, `less` and piecewise-linear terms are declared kinks of
//! [`mcp_core::scalar`]. Conditions that depend on variables choose by value: `if` has the
//! derivative of the arm taken, both arms and the condition count as read, and where the arms
//! differ the function jumps. `floor`, `ceil`, `round`, `trunc`, `div`, `precision` and logical values
//! have derivative 0; `x mod y` has slopes 1 and `−trunc(x/y)`.
//!
//! A damaged file is an error with line or byte, segment, what was expected and what was found;
//! nothing is allocated for what a file only announces, and no expression is nested too deep.

mod assemble;
mod complement;
mod cut;
mod defined;
mod error;
mod expression;
mod header;
mod input;
mod matching;
mod names;
mod operator;
mod segments;
mod sol;
mod substitute;
mod tape;

pub use error::{NlError, Place, Segment};
pub use matching::maximum as maximum_matching;
pub use names::{Names, stub_and_file, with_suffix};

use assemble::Body;
use mcp_core::{Model, Reader, Real, Scalar, Shape, sum};
use segments::Parts;
use std::fs;
use std::path::Path;
use tape::Tape;

/// A mixed complementarity problem from an `.nl` file; see the [module page](self).
///
/// Variables have the order of the file, equations that of its rows; a row that bounds nothing is no
/// equation. Defined variables are definitions, or, where many variables stand behind many of them or a
/// sum of a row is very long, auxiliary variables that come last, each with an equation, and so are
/// pieces of that sum.
#[derive(Clone, Debug)]
pub struct NlModel {
    shape: Shape,
    tape: Tape,
    /// Linear terms of all bodies: variable, coefficient.
    linear: Vec<(u32, f64)>,
    definitions: Vec<Body>,
    /// Variables of the file.
    variables: usize,
    /// Bodies of all rows of the file.
    rows: Vec<Body>,
    /// Row of every equation.
    row_of_equation: Vec<usize>,
    /// Variable of every row; `None` for a row that bounds nothing.
    variable_of_row: Vec<Option<usize>>,
    /// Options of the header, for the `.sol` file.
    options: Vec<i64>,
    tolerance: Option<f64>,
    warnings: Vec<String>,
}

impl NlModel {
    /// Reads `path` and, where they exist, the names in the `.col` and `.row` files beside it. The
    /// suffix `.nl` may be left out, as AMPL does.
    ///
    /// # Errors
    /// [`NlError::Io`], and as [`parse`](Self::parse).
    pub fn read(path: &Path) -> Result<Self, NlError> {
        let (stub, path) = stub_and_file(path);
        let bytes = fs::read(&path).map_err(|source| NlError::Io { path, source })?;
        Self::parse(&bytes, Names::beside(&stub)?)
    }

    /// Reads the bytes of a file, text or binary.
    ///
    /// # Errors
    /// [`NlError`], every kind but [`NlError::Io`].
    pub fn parse(bytes: &[u8], names: Names) -> Result<Self, NlError> {
        let mut names = names;
        let parts = Parts::read(bytes)?;
        let warnings = names.drop_misfits(parts.header.variables, parts.header.rows);
        Ok(NlModel { warnings, ..Self::assemble(parts, &names)? })
    }

    /// What was left out of the model although it was given: names that do not fit the file.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Number of variables of the file: the first of the model's `z`, in the same order.
    pub fn variables(&self) -> usize {
        self.variables
    }

    /// Number of rows of the file.
    pub fn constraints(&self) -> usize {
        self.rows.len()
    }

    /// The part of `z` that stands in the file, in its order.
    ///
    /// # Panics
    /// If `z` is shorter than [`variables`](Self::variables).
    pub fn file_levels<'a>(&self, z: &'a [f64]) -> &'a [f64] {
        &z[..self.variables()]
    }

    /// The point with these levels of the file's variables, auxiliary variables where their equations
    /// hold; 0 where that is not finite.
    ///
    /// # Panics
    /// If `z` is shorter than [`variables`](Self::variables).
    pub fn with_auxiliaries(&self, z: &[f64]) -> Vec<f64> {
        let mut z = self.file_levels(z).to_vec();
        if self.shape.n() > self.variables {
            for definition in &self.definitions {
                let level = self.value_at(definition, &z, &[]);
                z.push(if level.is_finite() { level } else { 0.0 });
            }
        }
        z
    }

    /// One number for each row of the file, what a `.sol` file gives as dual values: body minus
    /// right-hand side, that is `F` where the row goes with a variable, and the body of a row that
    /// bounds nothing.
    ///
    /// `z` and `f` are those of a [`Solution`](mcp_core::Solution) of this model: `f[j]` is the
    /// equation that goes with variable `j`.
    ///
    /// # Panics
    /// If `z` or `f` has fewer entries than the model has variables.
    pub fn row_values(&self, z: &[f64], f: &[f64]) -> Vec<f64> {
        let has_more = self.variable_of_row.contains(&None);
        let definitions = if has_more { self.definitions_at(z) } else { Vec::new() };
        let rows = self.rows.iter().zip(&self.variable_of_row);
        let value = |(body, variable): (&Body, &Option<usize>)| match variable {
            Some(j) => f[*j],
            None => self.value_at(body, z, &definitions),
        };
        rows.map(value).collect()
    }

    /// Options of the header and the tolerance behind them.
    fn sol_options(&self) -> (&[i64], Option<f64>) {
        (&self.options, self.tolerance)
    }

    /// Linear terms that are not 0.
    fn terms(&self, body: &Body) -> impl Iterator<Item = &(u32, f64)> {
        self.linear[body.linear.clone()].iter().filter(|(_, coefficient)| *coefficient != 0.0)
    }

    fn value<D: Scalar>(&self, body: &Body, read: &Reader<'_, D>) -> Real<D> {
        let terms = self.terms(body);
        let linear = sum(terms, |&(j, coefficient)| coefficient * read.var(j as usize));
        if body.expression.is_empty() {
            return linear - body.rhs;
        }
        let nonlinear = self.tape.value(&body.expression, read);
        let nonlinear = if body.factor == 1.0 { nonlinear } else { body.factor * nonlinear };
        nonlinear + linear - body.rhs
    }

    /// Values of all definitions; of none where they are variables.
    fn definitions_at(&self, z: &[f64]) -> Vec<f64> {
        if self.shape.definition_count() == 0 {
            return Vec::new();
        }
        let mut values = Vec::new();
        for definition in &self.definitions {
            values.push(self.value_at(definition, z, &values));
        }
        values
    }

    /// Value in plain numbers.
    fn value_at(&self, body: &Body, z: &[f64], definitions: &[f64]) -> f64 {
        let variable = |j: u32| Real::<f64>::from(z[j as usize]);
        let definition = |k: u32| Real::<f64>::from(definitions[k as usize]);
        let linear = sum(self.terms(body), |&(j, coefficient)| coefficient * variable(j));
        let nonlinear = self.tape.evaluate(&body.expression, &variable, &definition);
        (body.factor * nonlinear + linear - body.rhs).into_scalar()
    }
}

impl Model for NlModel {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, family: usize, index: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            0 => self.value(&self.rows[self.row_of_equation[index]], read),
            // An auxiliary variable is what it is defined as.
            _ => read.var(self.variables + index) - self.value(&self.definitions[index], read),
        }
    }
    fn def<D: Scalar>(&self, _family: usize, index: usize, read: &Reader<'_, D>) -> Real<D> {
        self.value(&self.definitions[index], read)
    }
}
