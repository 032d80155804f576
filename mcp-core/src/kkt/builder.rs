//! Declarations of a program's variables and constraints.

use super::model::System;
use super::{Kkt, Program};
use crate::error::ModelError;
use crate::model::{Definition, Equation, Parameter, Set, Shape, Variable};

const INF: f64 = f64::INFINITY;

/// A constraint on `g_k(x)`: its name, kind, right-hand side, and the start of its multiplier.
#[derive(Clone, Debug)]
pub struct Constraint {
    name: String,
    /// Bounds of the multiplier in a minimisation.
    multiplier: (f64, f64),
    rhs: f64,
    start: f64,
}

impl Constraint {
    /// `g_k(x) >= rhs`; in a minimisation `λ_k >= 0`.
    pub fn at_least(name: impl Into<String>, rhs: f64) -> Self {
        Constraint { name: name.into(), multiplier: (0.0, INF), rhs, start: 0.0 }
    }
    /// `g_k(x) <= rhs`; in a minimisation `λ_k <= 0`.
    pub fn at_most(name: impl Into<String>, rhs: f64) -> Self {
        Constraint { name: name.into(), multiplier: (-INF, 0.0), rhs, start: 0.0 }
    }
    /// `g_k(x) = rhs`; `λ_k` is free.
    pub fn equal(name: impl Into<String>, rhs: f64) -> Self {
        Constraint { name: name.into(), multiplier: (-INF, INF), rhs, start: 0.0 }
    }
    /// Where the multiplier starts; default 0, moved into its bounds.
    #[must_use]
    pub fn start(mut self, multiplier: f64) -> Self {
        self.start = multiplier;
        self
    }
}

/// Collects the variables and constraints of a program; [`build`](Self::build) checks them.
#[derive(Clone, Debug)]
pub struct KktBuilder<P> {
    program: P,
    /// 1 to minimise, −1 to maximise.
    sense: f64,
    variables: Vec<Variable>,
    constraints: Vec<Constraint>,
}

impl<P: Program> KktBuilder<P> {
    pub(super) fn new(program: P, sense: f64) -> Self {
        KktBuilder { program, sense, variables: Vec::new(), constraints: Vec::new() }
    }

    /// Adds a family of variables, with their bounds and starts. The program gets all variables as one
    /// list, in the order of declaration.
    #[must_use]
    pub fn variable(mut self, variable: Variable) -> Self {
        self.variables.push(variable);
        self
    }

    /// Adds a constraint.
    #[must_use]
    pub fn constraint(mut self, constraint: Constraint) -> Self {
        self.constraints.push(constraint);
        self
    }

    /// Builds the shape and traces which variables each function uses.
    ///
    /// # Errors
    /// As [`ShapeBuilder::build`](crate::ShapeBuilder::build), where the names `lambda`, `constraint`,
    /// `rhs` and `objective` are taken; [`ModelError::DuplicateLabel`] if two constraints have the
    /// same name.
    pub fn build(self) -> Result<Kkt<P>, ModelError> {
        let KktBuilder { program, sense, variables, constraints } = self;
        let shape = shape(sense, variables, &constraints)?;
        let system = System::new(&program, sense, shape, constraints.len());
        Ok(Kkt::new(program, system))
    }
}

/// Variables and their slopes, then multipliers and their constraints.
fn shape(
    sense: f64,
    variables: Vec<Variable>,
    constraints: &[Constraint],
) -> Result<Shape, ModelError> {
    let names = Set::new("constraints", constraints.iter().map(|c| c.name.clone()))?;
    let each = |of: fn(&Constraint) -> f64| constraints.iter().map(of).collect::<Vec<f64>>();
    let (mut lower, mut upper) = (each(|c| c.multiplier.0), each(|c| c.multiplier.1));
    if sense < 0.0 {
        // [−u, −l]
        let mirrored = |bounds: Vec<f64>| bounds.into_iter().map(|b| 0.0 - b).collect();
        (lower, upper) = (mirrored(upper), mirrored(lower));
    }
    let lambda = Variable::new("lambda").over(&[&names]).lower(lower).upper(upper);
    let lambda = lambda.start(each(|c| c.start)).about("shadow price of a constraint");

    let mut shape = Shape::builder();
    for variable in variables {
        shape = shape.equation(Equation::of_each("dL/d", &variable)).variable(variable);
    }
    shape
        .variable(lambda)
        .equation(Equation::new("constraint").over(&[&names]).complements("lambda"))
        .parameter(Parameter::new("rhs", each(|c| c.rhs)).over(&[&names]))
        .report(Definition::new("objective"))
        .build()
}
