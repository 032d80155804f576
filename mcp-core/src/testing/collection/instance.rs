//! [`Instance`]: a problem with a name, a start and what is known about it.

use super::scaled::{Rescaled, Scaling};
use crate::error::ModelError;
use crate::model::{Model, Shape};
use crate::problem::{AdProblem, Problem};
#[cfg(test)]
use crate::problem::{DerivativeReport, check_derivatives};
use std::fmt;
use std::sync::Arc;

/// A problem of the collection: a model, a start, and what is known about it.
///
/// Several instances may share one model. Cloning is cheap.
#[derive(Clone)]
pub struct Instance {
    /// Name for tables, such as `josephy-3`; the same as in the study.
    pub name: String,
    /// One of [`families`](super::families).
    pub family: &'static str,
    /// Where the problem comes from.
    pub source: &'static str,
    /// The start as published, `n` numbers; it may lie outside the box.
    pub start: Vec<f64>,
    /// Known solutions; there may be others.
    pub solutions: Vec<Vec<f64>>,
    /// Whether a solution exists.
    pub solvable: bool,
    model: Arc<dyn AnyModel>,
    scaling: Option<Arc<Scaling>>,
}

/// What an instance asks of its model, whatever its type.
trait AnyModel: Send + Sync {
    fn shape(&self) -> &Shape;
    fn problem(&self, start: &[f64]) -> Result<Box<dyn Problem + '_>, ModelError>;
    /// For the tests alone: every model would be compiled in three more arithmetics.
    #[cfg(test)]
    fn check_derivatives(&self, z: &[f64]) -> Result<DerivativeReport, ModelError>;
}

impl<M: Model + Send + Sync> AnyModel for M {
    fn shape(&self) -> &Shape {
        Model::shape(self)
    }
    fn problem(&self, start: &[f64]) -> Result<Box<dyn Problem + '_>, ModelError> {
        let mut problem = AdProblem::new(self)?;
        problem.set_start(start)?;
        Ok(Box::new(problem))
    }
    #[cfg(test)]
    fn check_derivatives(&self, z: &[f64]) -> Result<DerivativeReport, ModelError> {
        check_derivatives(self, z)
    }
}

impl Instance {
    /// A solvable instance that starts where the shape of the model says.
    pub(super) fn new(
        name: impl Into<String>,
        source: &'static str,
        model: impl Model + Send + Sync + 'static,
    ) -> Self {
        Instance {
            name: name.into(),
            family: "",
            source,
            start: model.shape().start().to_vec(),
            solutions: Vec::new(),
            solvable: true,
            model: Arc::new(model),
            scaling: None,
        }
    }

    /// The same problem from another start, under the name `{name}-{number}`.
    pub(super) fn numbered(&self, number: usize, start: &[f64]) -> Self {
        let name = format!("{}-{number}", self.name);
        Instance { name, start: start.to_vec(), ..self.clone() }
    }

    /// The instances `{name}-1`, `{name}-2`, … from these starts.
    pub(super) fn at_starts<S: AsRef<[f64]>>(self, starts: &[S]) -> Vec<Self> {
        let numbered = starts.iter().enumerate();
        numbered.map(|(k, start)| self.numbered(k + 1, start.as_ref())).collect()
    }

    pub(super) fn starting_at(self, start: impl Into<Vec<f64>>) -> Self {
        Instance { start: start.into(), ..self }
    }

    pub(super) fn renamed(self, name: impl Into<String>) -> Self {
        Instance { name: name.into(), ..self }
    }

    pub(super) fn solved_by(mut self, solution: impl Into<Vec<f64>>) -> Self {
        self.solutions.push(solution.into());
        self
    }

    pub(super) fn unsolvable(self) -> Self {
        Instance { solvable: false, ..self }
    }

    /// The same problem in other units.
    pub(super) fn scaled(&self, name: String, scaling: Scaling) -> Self {
        let in_new_units = |z: &Vec<f64>| scaling.to_scaled(z);
        Instance {
            name,
            start: in_new_units(&self.start),
            solutions: self.solutions.iter().map(in_new_units).collect(),
            scaling: Some(Arc::new(scaling)),
            ..self.clone()
        }
    }

    /// Number of variables.
    pub fn n(&self) -> usize {
        self.start.len()
    }

    /// The problem, with exact derivatives, starting at [`start`](Self::start) moved into the box.
    ///
    /// # Errors
    /// None in practice: the problems are well formed.
    pub fn problem(&self) -> Result<Box<dyn Problem + '_>, ModelError> {
        match &self.scaling {
            None => self.model.problem(&self.start),
            Some(scaling) => {
                let original = self.model.problem(self.model.shape().start())?;
                Ok(Box::new(Rescaled::new(original, Arc::clone(scaling), &self.start)?))
            }
        }
    }

    /// The problem before scaling, in whose units [`judge`](crate::testing::judge()) measures; the
    /// problem itself if it is not scaled.
    ///
    /// # Errors
    /// As [`problem`](Self::problem).
    pub fn original(&self) -> Result<Box<dyn Problem + '_>, ModelError> {
        self.model.problem(&self.to_original(&self.start))
    }

    /// The point in the units of [`original`](Self::original); `z` must have `n` numbers.
    pub fn to_original(&self, z: &[f64]) -> Vec<f64> {
        self.scaling.as_ref().map_or_else(|| z.to_vec(), |scaling| scaling.to_original(z))
    }

    /// [`check_derivatives`] of the model at `z`; of a scaled instance, of its original at the same
    /// point.
    #[cfg(test)]
    pub(super) fn check_derivatives(&self, z: &[f64]) -> Result<DerivativeReport, ModelError> {
        self.model.check_derivatives(&self.to_original(z))
    }
}

impl fmt::Debug for Instance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Instance")
            .field("name", &self.name)
            .field("family", &self.family)
            .field("n", &self.n())
            .field("solvable", &self.solvable)
            .finish_non_exhaustive()
    }
}
