//! From segments to a model: bodies of rows, pairs, shape.

use super::NlModel;
use super::complement::{NameOf, System};
use super::cut;
use super::defined;
use super::error::NlError;
use super::names::Names;
use super::segments::{Parts, RowKind, Sum};
use super::substitute::{self, Substitution};
use super::tape::{Expression, Tape, sum_of_constants};
use mcp_core::{Definition, Equation, Set, Shape, Variable};
use std::ops::Range;

/// `k e(z) + Σ c_j z_j − b`.
#[derive(Clone, Debug)]
pub(super) struct Body {
    /// `k`.
    pub(super) factor: f64,
    pub(super) expression: Expression,
    /// Where the linear terms stand among all.
    pub(super) linear: Range<usize>,
    /// Right-hand side `b`.
    pub(super) rhs: f64,
}

impl Body {
    /// An expression that is a constant becomes part of the right-hand side.
    fn new(Sum { expression, linear }: Sum, rhs: f64, tape: &Tape) -> Self {
        match tape.constant(&expression) {
            Some(value) => {
                let rhs = sum_of_constants(rhs, -value);
                Body { factor: 1.0, expression: Expression::default(), linear, rhs }
            }
            None => Body { factor: 1.0, expression, linear, rhs },
        }
    }
}

impl NlModel {
    /// Pairs rows with variables and makes the shape.
    pub(super) fn assemble(parts: Parts, names: &Names) -> Result<Self, NlError> {
        if let Some((place, segment)) = parts.objective {
            return Err(NlError::Objective { place, segment });
        }
        if let Some((count, first)) = parts.header.integers {
            return Err(NlError::Integer { count, variable: names.variable(first) });
        }
        let mut parts = parts;
        let mut rows = bodies(&parts);
        let terms = |i: usize| &parts.linear[rows[i].linear.clone()];
        let substitutions =
            substitute::find(&parts, terms, |i| parts.tape.ops(&rows[i].expression));
        let defining: Vec<_> = substitutions.iter().map(|s| (s.equation, s.variable)).collect();
        let columns = |i: usize| terms(i).iter().map(|&(j, _)| j).collect();
        let system =
            System { rows: &parts.rows, bounds: &parts.bounds, names, defining: &defining };
        let variable_of_row = system.pairs(columns)?;
        for substitution in &substitutions {
            rows[substitution.row] = put_equation(substitution, &rows, &mut parts.linear);
        }
        let has_variable = |i: &usize| variable_of_row[*i].is_some();
        let row_of_equation: Vec<usize> = (0..rows.len()).filter(has_variable).collect();

        let mut shape = Shape::builder().variable(columns_of(&parts, names)?).equation(rows_of(
            &variable_of_row,
            &row_of_equation,
            names,
        )?);
        let is_cut = cut::long_sums(&mut parts, &mut rows);
        let defined = Set::count("defined variables", parts.definitions.len());
        let bodies = || rows.iter().map(|row| (&row.expression, &row.linear));
        if !is_cut && defined::stay_sparse(&parts, bodies()) {
            shape = shape.definition(Definition::new(DEFINED).over(&[&defined]));
        } else {
            parts.tape.make_variables_of_definitions(parts.bounds.len());
            let equation = Equation::new(DEFINING).over(&[&defined]).complements(DEFINED);
            shape = shape.variable(Variable::new(DEFINED).over(&[&defined])).equation(equation);
        }
        let tape = parts.tape;
        let definition = |sum| Body::new(sum, 0.0, &tape);
        let mut model = NlModel {
            shape: shape.build()?,
            definitions: parts.definitions.into_iter().map(definition).collect(),
            variables: parts.bounds.len(),
            linear: parts.linear,
            rows,
            row_of_equation,
            variable_of_row,
            options: parts.header.options,
            tolerance: parts.header.tolerance,
            warnings: Vec::new(),
            tape,
        };
        model.start_auxiliaries(&substitutions, &parts.start)?;
        Ok(model)
    }

    /// Auxiliary variables start where their equations hold: defined ones, and substituted ones that
    /// the file gives no start.
    fn start_auxiliaries(
        &mut self,
        substitutions: &[Substitution],
        given: &[(usize, f64)],
    ) -> Result<(), NlError> {
        let mut start = self.with_auxiliaries(self.shape.start());
        let definitions = self.definitions_at(&start);
        let mut is_given = vec![false; self.variables];
        for &(j, _) in given {
            is_given[j] = true;
        }
        for s in substitutions.iter().filter(|s| !is_given[s.variable]) {
            // b v + r(z) at the old v.
            let gap = self.value_at(&self.rows[s.equation], &start, &definitions);
            start[s.variable] = finite_or_0(start[s.variable] - gap / s.coefficient);
        }
        self.shape.set_start(&start)?;
        Ok(())
    }
}

fn finite_or_0(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}

/// The row `c − (a/b) r(z)` of a substitution.
fn put_equation(substitution: &Substitution, rows: &[Body], linear: &mut Vec<(u32, f64)>) -> Body {
    let Body { factor, expression, linear: terms, rhs } = rows[substitution.equation].clone();
    let (scale, start) = (-substitution.ratio, linear.len());
    for k in terms {
        let (j, coefficient) = linear[k];
        if j as usize != substitution.variable {
            linear.push((j, scale * coefficient));
        }
    }
    // −c is the row's own right-hand side.
    let rhs = sum_of_constants(rows[substitution.row].rhs, scale * rhs);
    Body { factor: scale * factor, expression, linear: start..linear.len(), rhs }
}

/// Expression, linear terms and right-hand side of every row.
fn bodies(parts: &Parts) -> Vec<Body> {
    let mut sums = vec![Sum::default(); parts.rows.len()];
    for (row, _, expression) in &parts.expressions {
        sums[*row].expression = expression.clone();
    }
    for (row, _, linear) in &parts.terms {
        sums[*row].linear = linear.clone();
    }
    let rhs = |kind: &RowKind| match *kind {
        RowKind::Between { lower, .. } if kind.is_equation() => lower,
        _ => 0.0,
    };
    let rows = sums.into_iter().zip(&parts.rows);
    rows.map(|(sum, kind)| Body::new(sum, rhs(kind), &parts.tape)).collect()
}

/// Variables with bounds and start.
fn columns_of(parts: &Parts, names: &Names) -> Result<Variable, NlError> {
    let count = parts.bounds.len();
    let (lower, upper): (Vec<f64>, Vec<f64>) = parts.bounds.iter().copied().unzip();
    let mut start = vec![0.0; count];
    for &(j, z) in &parts.start {
        start[j] = z;
    }
    let family = match names.column_set()? {
        Some(columns) => Variable::new(COLUMNS).labelled(&columns),
        None => Variable::new(COLUMNS).over(&[&Set::count("columns", count)]),
    };
    Ok(family.lower(lower).upper(upper).start(start))
}

/// The equations: those of all rows that have a variable.
fn rows_of(
    variable_of_row: &[Option<usize>],
    row_of_equation: &[usize],
    names: &Names,
) -> Result<Equation, NlError> {
    let pairs: Vec<usize> = variable_of_row.iter().copied().flatten().collect();
    let family = match names.row_set()? {
        Some(rows) => Equation::new(ROWS).labelled(&rows),
        None => Equation::new(ROWS).over(&[&Set::count("rows", variable_of_row.len())]),
    };
    Ok(family.only(row_of_equation).complements_elements(COLUMNS, pairs))
}

/// AMPL's own names for the variables and the rows of a file.
const COLUMNS: &str = "_svar";
const ROWS: &str = "_scon";
/// Defined variables, and their equations where they are variables of the model.
const DEFINED: &str = "_sdef";
const DEFINING: &str = "_sdef_equation";
