//! [`AdProblem`]: a model with exact derivatives.

use super::derived::{Derived, definitions};
use super::lanes::Lanes;
use super::record::{constants, record_rows, trace_whole};
use super::rows::{ByJets, ByMagnitude, ByNumDual, JetRows, Rows, pattern_of};
use super::{Pattern, Problem};
use crate::apart::Apart;
use crate::error::ModelError;
use crate::model::{Model, Reader, Shape};
use crate::scalar::{Counted, Jet, Magnitude, OperationCounts, Real, Scalar, Tally, Trace};
use crate::solver::Solution;
use num_dual::DualSVec64;
use std::sync::Arc;

/// Which arithmetic carries the derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Engine {
    /// [`Jet`]: 8 lanes for a row, above that a sweep back over its operations; for a function of
    /// fixed size an even number up to 16. The default.
    #[default]
    Jet,
    /// num-dual's `DualSVec64<8>`: the independent second opinion.
    NumDual,
}

/// How a model is evaluated: dense lanes or row by row.
pub(super) trait Pass<M> {
    /// `F` alone.
    fn residual(&mut self, model: &M, z: &[f64], parameters: &[f64], f: &mut [f64]);
    /// `J`, and `F` if asked for.
    fn jacobian(
        &mut self,
        model: &M,
        at: (&[f64], &[f64]),
        pattern: &Pattern,
        f: Option<&mut [f64]>,
        jac: &mut [f64],
    );
}

/// A [`Model`] as a [`Problem`]: exact Jacobian, pattern found by recording, workspace kept.
///
/// It owns a copy of the model's shape, so bounds, start and parameters of *this problem* can be
/// changed between solves; a solution keeps the shape it was solved with. Evaluations allocate
/// nothing.
pub struct AdProblem<M> {
    model: M,
    shape: Arc<Shape>,
    pattern: Pattern,
    pass: Box<dyn Pass<M>>,
}

impl<M: Model> AdProblem<M> {
    /// Records the pattern and allocates the workspace, with the default [`Engine::Jet`].
    ///
    /// Rows are run at the start, and again at three other points, where they must read no more.
    ///
    /// # Errors
    /// [`ModelError::ReadOutOfRange`], [`ModelError::ReadsVary`], [`ModelError::DefinitionOrder`];
    /// [`ModelError::Length`] if a model of one function ([`Model::WHOLE`]) declares definitions or another number of rows.
    #[inline]
    pub fn new(model: M) -> Result<Self, ModelError> {
        Self::reading(model, &[])
    }

    /// The same for a model whose rows choose by values what they read: each `(i, j)` says that the
    /// equation paired with variable `i` may read variable `j`, whether or not it does at the start. For
    /// a model of one function, whose dependencies are traced, it says nothing.
    ///
    /// # Errors
    /// As [`AdProblem::new`], and [`ModelError::Length`] for a variable that does not exist.
    ///
    /// ```
    /// use mcp_core::{AdProblem, Equation, Model, ModelError, Problem, Reader, Real, Scalar, Shape, Variable};
    ///
    /// /// `F_x = x − 1`, and above 1 `x − y`: what is read depends on a value.
    /// struct Switch(Shape);
    ///
    /// impl Model for Switch {
    ///     fn shape(&self) -> &Shape { &self.0 }
    ///     fn row<D: Scalar>(&self, row: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
    ///         let x = if row == 0 { read.var(0) } else { return read.var(1) - 2.0 };
    ///         if x.into_scalar().value() > 1.0 { x - read.var(1) } else { x - 1.0 }
    ///     }
    /// }
    ///
    /// let shape = Shape::builder()
    ///     .variable(Variable::new("x").lower(0.0).start(1.0)).variable(Variable::new("y"))
    ///     .equation(Equation::new("f").complements("x")).equation(Equation::new("g").complements("y"))
    ///     .build()?;
    /// let refused = AdProblem::new(Switch(shape.clone())).err().map(|error| error.to_string());
    /// assert!(refused.is_some_and(|text| text.starts_with("`f` reads `y` at some points and not at others")));
    /// assert_eq!(AdProblem::reading(Switch(shape), &[(0, 1)])?.pattern().nnz(), 3);
    /// # Ok::<(), ModelError>(())
    /// ```
    #[inline]
    pub fn reading(model: M, besides: &[(usize, usize)]) -> Result<Self, ModelError> {
        Self::assemble(model, (besides, true), jet_lanes, |rows| Box::new(ByJets(rows)))
    }

    /// The same with derivatives by the given engine.
    ///
    /// # Errors
    /// As [`AdProblem::new`].
    pub fn with_engine(model: M, engine: Engine) -> Result<Self, ModelError> {
        match engine {
            Engine::Jet => Self::new(model),
            Engine::NumDual => Self::assemble(
                model,
                (&[], false),
                |shape, pattern| Box::new(Lanes::<DualSVec64<8>>::new(shape, pattern)),
                |rows| Box::new(ByNumDual::new(rows)),
            ),
        }
    }

    /// The problem that a solution belongs to: with its bounds and parameters.
    pub(crate) fn of_solution(model: M, solution: &Solution) -> Result<Self, ModelError> {
        let mut problem = Self::new(model)?;
        problem.shape.check_levels_of(solution)?;
        let (expected, found) = (problem.shape.row_count(), solution.shape.row_count());
        if expected != found {
            let what = "equations of the solution".to_owned();
            return Err(ModelError::Length { what, expected, found });
        }
        problem.shape = Arc::clone(&solution.shape);
        Ok(problem)
    }

    /// All rows in the order of declaration, in any arithmetic.
    pub(crate) fn rows_at<D: Scalar>(&self, z: &[Real<D>]) -> Vec<Real<D>> {
        let parameters = constants(self.shape.parameter_values());
        evaluate_all(&self.model, &self.shape, z, &parameters)
    }

    /// Instead of `J`, the sums of the absolute terms of its entries.
    pub(super) fn of_magnitudes(model: M) -> Result<Self, ModelError> {
        Self::assemble(
            model,
            (&[], false),
            |shape, pattern| Box::new(Lanes::<Magnitude<8>>::new(shape, pattern)),
            |rows| Box::new(ByMagnitude::new(rows)),
        )
    }

    #[inline]
    fn assemble(
        model: M,
        (besides, with_constants): (&[(usize, usize)], bool),
        lanes: impl FnOnce(&Shape, &Pattern) -> Box<dyn Pass<M>>,
        rows: impl FnOnce(Apart<Rows>) -> Box<dyn Pass<M>>,
    ) -> Result<Self, ModelError> {
        let shape = model.shape().shared_copy();
        let (pattern, pass) = if const { M::WHOLE.is_some() } {
            check_whole(M::WHOLE, &shape)?;
            let pattern = trace_whole(&model, &shape);
            let pass = lanes(&shape, &pattern);
            (pattern, pass)
        } else {
            let (pattern, workspace) = recorded(&model, &shape, besides, with_constants)?;
            (pattern, rows(workspace))
        };
        Ok(AdProblem { model, shape, pattern, pass })
    }

    /// The model.
    pub fn model(&self) -> &M {
        &self.model
    }

    /// For a model whose data change: no derivative is taken for constant.
    pub(crate) fn changing(model: M) -> Result<Self, ModelError> {
        Self::assemble(model, (&[], false), jet_lanes, |rows| Box::new(ByJets(rows)))
    }

    /// The model of a problem made by [`changing`](Self::changing), whose data may be changed as long
    /// as its shape and what its rows read stay.
    pub(crate) fn model_mut(&mut self) -> &mut M {
        &mut self.model
    }

    /// Changes the values of a parameter family of this problem: [`Shape::set_parameter`].
    ///
    /// # Errors
    /// [`ModelError::UnknownName`], [`ModelError::Length`], [`ModelError::ParameterNotFinite`].
    pub fn set_parameter(&mut self, name: &str, values: &[f64]) -> Result<(), ModelError> {
        Arc::make_mut(&mut self.shape).set_parameter(name, values)
    }

    /// Changes a parameter, or all of a family, of this problem to one value:
    /// [`Shape::fill_parameter`].
    ///
    /// # Errors
    /// As [`Shape::fill_parameter`].
    pub fn fill_parameter(&mut self, name: &str, value: f64) -> Result<(), ModelError> {
        Arc::make_mut(&mut self.shape).fill_parameter(name, value)
    }

    /// Changes the start of this problem: [`Shape::set_start`].
    ///
    /// # Errors
    /// [`ModelError::Length`], [`ModelError::StartNotFinite`].
    pub fn set_start(&mut self, start: &[f64]) -> Result<(), ModelError> {
        Arc::make_mut(&mut self.shape).set_start(start)
    }

    /// Changes all bounds of this problem: [`Shape::set_bounds`].
    ///
    /// # Errors
    /// [`ModelError::Length`], [`ModelError::UnusableBounds`], [`ModelError::CrossedBounds`],
    /// [`ModelError::Unpaired`].
    pub fn set_bounds(&mut self, lower: &[f64], upper: &[f64]) -> Result<(), ModelError> {
        Arc::make_mut(&mut self.shape).set_bounds(lower, upper)
    }

    /// Fixes a variable of this problem, or all of a family, by name: [`Shape::fix`].
    ///
    /// # Errors
    /// [`ModelError::UnknownName`], [`ModelError::Length`], [`ModelError::UnusableBounds`].
    pub fn fix(&mut self, name: &str, value: f64) -> Result<(), ModelError> {
        Arc::make_mut(&mut self.shape).fix(name, value)
    }

    /// Changes a lower bound of this problem by name: [`Shape::set_lower`].
    ///
    /// # Errors
    /// As [`Shape::set_lower`].
    pub fn set_lower(&mut self, name: &str, lower: f64) -> Result<(), ModelError> {
        Arc::make_mut(&mut self.shape).set_lower(name, lower)
    }

    /// Changes an upper bound of this problem by name: [`Shape::set_upper`].
    ///
    /// # Errors
    /// As [`Shape::set_upper`].
    pub fn set_upper(&mut self, name: &str, upper: f64) -> Result<(), ModelError> {
        Arc::make_mut(&mut self.shape).set_upper(name, upper)
    }

    /// Changes the start of a variable of this problem by name: [`Shape::set_start_of`].
    ///
    /// # Errors
    /// As [`Shape::set_start_of`].
    pub fn set_start_of(&mut self, name: &str, value: f64) -> Result<(), ModelError> {
        Arc::make_mut(&mut self.shape).set_start_of(name, value)
    }

    /// Starts this problem from another solution, by name: [`Shape::start_from`].
    ///
    /// # Errors
    /// As [`Shape::start_from`].
    pub fn start_from(&mut self, other: &Solution) -> Result<usize, ModelError> {
        Arc::make_mut(&mut self.shape).start_from(other)
    }

    /// Bounds, start and names of this problem.
    pub fn shape(&self) -> &Arc<Shape> {
        &self.shape
    }

    /// Whether all second derivatives exist.
    ///
    /// # Errors
    /// [`ModelError::NoSecondOrder`] names the first equation that calls an
    /// [`external`](crate::external()) function.
    pub fn check_second_order(&self) -> Result<(), ModelError> {
        // All variables in one lane: only whether something is read matters.
        let seed = |&z: &f64| Real(Trace::seed(z, 0));
        let z: Vec<Real<Trace>> = self.shape.start().iter().map(seed).collect();
        let parameters = constants(self.shape.parameter_values());
        let f = evaluate_all(&self.model, &self.shape, &z, &parameters);
        let lacks = |i: &usize| {
            let row = self.shape.row_of_variable(*i);
            row.is_some_and(|row| !f[row].into_scalar().has_second_order())
        };
        match (0..self.shape.n()).find(lacks) {
            Some(i) => Err(ModelError::NoSecondOrder { equation: self.shape.equation_name(i) }),
            None => Ok(()),
        }
    }

    /// Operations of one evaluation of `F` (all rows and definitions, each once).
    pub fn operations(&self) -> OperationCounts {
        let tally = Tally::new();
        let variable = |&z: &f64| Real(tally.variable(z));
        let z: Vec<Real<Counted<'_>>> = self.shape.start().iter().map(variable).collect();
        let parameters = constants(self.shape.parameter_values());
        evaluate_all(&self.model, &self.shape, &z, &parameters);
        tally.counts()
    }

    /// `∂F_i/∂p_k` of all equations by all parameters at `z`: `n` rows of `m` numbers, row by row.
    ///
    /// # Errors
    /// [`ModelError::Length`] if `z` does not have `n` entries.
    pub fn parameter_jacobian(&self, z: &[f64]) -> Result<Vec<f64>, ModelError> {
        type Chunk = Jet<8>;
        let (n, values) = (self.shape.n(), self.shape.parameter_values());
        if z.len() != n {
            return Err(ModelError::Length { what: "z".to_owned(), expected: n, found: z.len() });
        }
        let m = values.len();
        let mut jacobian = vec![0.0; n * m];
        let z: Vec<Real<Chunk>> = constants(z);
        for first in (0..m).step_by(Chunk::LANES) {
            let seed = |(k, &p): (usize, &f64)| Real(Chunk::seed(p, k.wrapping_sub(first)));
            let parameters: Vec<Real<Chunk>> = values.iter().enumerate().map(seed).collect();
            for (row, f) in
                evaluate_all(&self.model, &self.shape, &z, &parameters).iter().enumerate()
            {
                let i = self.shape.variable_of_row(row);
                for k in first..m.min(first + Chunk::LANES) {
                    jacobian[i * m + k] = f.0.tangent(k - first);
                }
            }
        }
        Ok(jacobian)
    }
}

/// Pattern and workspace of a model given row by row. Not generic: compiled here, not with every
/// model.
pub(super) fn recorded(
    model: &dyn JetRows,
    shape: &Shape,
    besides: &[(usize, usize)],
    with_constants: bool,
) -> Result<(Pattern, Apart<Rows>), ModelError> {
    let n = shape.n();
    if let Some(&(i, j)) = besides.iter().find(|(i, j)| *i.max(j) >= n) {
        let what = "variables, one of which is to be read".to_owned();
        return Err(ModelError::Length { what, expected: n, found: i.max(j) + 1 });
    }
    let recorded = record_rows(model, shape, besides)?;
    let pattern = pattern_of(shape, &recorded);
    // What is read beside the recorded may matter anywhere.
    let surveyed = (with_constants && besides.is_empty()).then_some(model);
    let rows = Rows::new(surveyed, shape, &recorded, &pattern);
    Ok((pattern, Apart::new(rows)))
}

/// A model of one function computes all rows of its shape and has no definitions.
fn check_whole(whole: Option<usize>, shape: &Shape) -> Result<(), ModelError> {
    let expected = whole.unwrap_or(0);
    let sizes = [
        ("rows of a model of one function", expected, shape.row_count()),
        ("definitions of a model of one function", 0, shape.definition_count()),
    ];
    match sizes.into_iter().find(|(_, expected, found)| expected != found) {
        Some((what, expected, found)) => {
            Err(ModelError::Length { what: what.to_owned(), expected, found })
        }
        None => Ok(()),
    }
}

/// Dense lanes for a model of one function. Branches on a constant, so that only one of the
/// arithmetics is compiled for a model.
fn jet_lanes<M: Model>(shape: &Shape, pattern: &Pattern) -> Box<dyn Pass<M>> {
    macro_rules! lanes {
        ($($count:literal)*) => {
            $(if const { lanes_for(M::WHOLE) == $count } {
                Box::new(Lanes::<Jet<$count>>::new(shape, pattern))
            } else)* {
                Box::new(Lanes::<Jet<16>>::new(shape, pattern))
            }
        };
    }
    lanes!(1 2 4 6 8 10 12 14)
}

/// Lanes for `n` variables: as few as carry them in passes of at most 16, an even number, since lanes
/// are computed in pairs at least.
pub(super) const fn lanes_for(whole: Option<usize>) -> usize {
    match whole {
        Some(0 | 1) => 1,
        Some(n) => n.div_ceil(n.div_ceil(16)).next_multiple_of(2),
        None => 16,
    }
}

/// All rows in the order of declaration, in any arithmetic, with definitions evaluated once.
fn evaluate_all<M: Model, D: Scalar>(
    model: &M,
    shape: &Shape,
    z: &[Real<D>],
    parameters: &[Real<D>],
) -> Vec<Real<D>> {
    let mut def = |k, index, read: &Reader<'_, D>| model.def(k, index, read);
    let definitions = definitions(shape, &mut def, z, parameters);
    let mut f = vec![Real(D::constant(0.0)); shape.row_count()];
    model.whole(&Reader::lanes(z, &definitions, parameters), &mut f);
    f
}

impl<M: Model> Problem for AdProblem<M> {
    #[inline]
    fn shape(&self) -> &Arc<Shape> {
        &self.shape
    }

    #[inline]
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    #[inline]
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        let parameters = self.shape.parameter_values();
        match (f, jac) {
            (f, Some(jac)) => {
                self.pass.jacobian(&self.model, (z, parameters), &self.pattern, f, jac);
            }
            (Some(f), None) => self.pass.residual(&self.model, z, parameters, f),
            (None, None) => {}
        }
    }

    #[inline]
    fn derived(&self, z: &[f64]) -> Derived {
        Derived::at(&self.model, z, self.shape.parameter_values())
    }
}

#[cfg(test)]
#[path = "ad_tests.rs"]
mod tests;
