//! [`Case`]: a model with a start, known solutions, and every way to its derivatives.

use super::source::{ByHand, Differences, Scheme, Source};
use super::{AccuracyError, DoubleDouble, Reference};
use crate::error::ModelError;
use crate::model::{Model, Shape};
use crate::problem::{AdProblem, Derived, Engine, Pattern, Problem};
use crate::scalar::{Jet, Real};
use crate::solver::{Options, solve_from};
use std::sync::Arc;

/// The arithmetic of `F`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// 53 bits.
    #[default]
    F64,
    /// 106 bits, rounded to 53 at the end: [`DoubleDouble`].
    DoubleDouble,
}

/// Values of `J` by hand, in the order of the pattern.
type Jacobian = Box<dyn Fn(&[f64], &mut [f64])>;

/// A problem of the study.
pub struct Case {
    /// Name for tables and figures.
    pub name: String,
    /// Known solutions; errors are distances to the nearest.
    pub references: Vec<Reference>,
    /// Where cold solves start.
    pub start: Vec<f64>,
    /// Whether `F` is affine, so that Lemke's method applies.
    pub is_affine: bool,
    model: Box<dyn AnyModel>,
    by_hand: Option<Jacobian>,
}

/// What a case asks of its model, whatever its type.
trait AnyModel {
    fn shape(&self) -> &Shape;
    fn exact(&self, engine: Engine) -> Result<Box<dyn Problem + '_>, ModelError>;
    fn precise(&self) -> Result<Box<dyn Problem + '_>, ModelError>;
    fn near(&self, start: &[f64]) -> Result<Vec<f64>, ModelError>;
    fn refined(&self, near: &[f64]) -> Result<Reference, AccuracyError>;
    fn operations(&self) -> Result<[u64; 2], ModelError>;
    fn exact_jacobian(&self, z: &[f64]) -> Result<Vec<DoubleDouble>, ModelError>;
}

impl<M: Model> AnyModel for M {
    fn shape(&self) -> &Shape {
        Model::shape(self)
    }
    fn exact(&self, engine: Engine) -> Result<Box<dyn Problem + '_>, ModelError> {
        Ok(Box::new(AdProblem::with_engine(self, engine)?))
    }
    fn precise(&self) -> Result<Box<dyn Problem + '_>, ModelError> {
        Ok(Box::new(Precise(AdProblem::new(self)?)))
    }
    fn near(&self, start: &[f64]) -> Result<Vec<f64>, ModelError> {
        let options = Options::default().with(|o| o.tol_relative = 1e-12);
        Ok(solve_from(self, start, &options)?.z)
    }
    fn refined(&self, near: &[f64]) -> Result<Reference, AccuracyError> {
        Reference::refined(self, near)
    }
    fn operations(&self) -> Result<[u64; 2], ModelError> {
        let problem = AdProblem::new(self)?;
        Ok([problem.operations().total(), problem.jacobian_operations()?])
    }
    fn exact_jacobian(&self, z: &[f64]) -> Result<Vec<DoubleDouble>, ModelError> {
        const LANES: usize = 8;
        let problem = AdProblem::new(self)?;
        let (shape, pattern) = (problem.shape(), problem.pattern());
        let mut jac = vec![DoubleDouble::default(); pattern.nnz()];
        for first in (0..z.len()).step_by(LANES) {
            let seed = |(j, &z): (usize, &f64)| {
                Real::from_scalar(Jet::<LANES, _>::variable(z.into(), j.wrapping_sub(first)))
            };
            let z: Vec<Real<Jet<LANES, DoubleDouble>>> = z.iter().enumerate().map(seed).collect();
            let f = problem.rows_at(&z);
            for j in first..z.len().min(first + LANES) {
                for k in pattern.column(j) {
                    let row = shape.row_of_variable(pattern.row(k));
                    let row = row.expect("an entry belongs to a row");
                    jac[k] = f[row].into_scalar().d[j - first];
                }
            }
        }
        Ok(jac)
    }
}

impl Case {
    /// A case that starts where the model does, without references.
    pub fn new(name: impl Into<String>, model: impl Model + 'static) -> Self {
        Case {
            name: name.into(),
            references: Vec::new(),
            start: model.shape().start().to_vec(),
            is_affine: false,
            model: Box::new(model),
            by_hand: None,
        }
    }

    /// Starting elsewhere.
    #[must_use]
    pub fn from(self, start: &[f64]) -> Self {
        Case { start: start.to_vec(), ..self }
    }

    /// With an affine `F`.
    #[must_use]
    pub fn affine(self) -> Self {
        Case { is_affine: true, ..self }
    }

    /// With one more known solution.
    #[must_use]
    pub fn solved_by(mut self, reference: Reference) -> Self {
        self.references.push(reference);
        self
    }

    /// With the Jacobian by hand: `jacobian(z, values)` in the order of the pattern.
    #[must_use]
    pub fn by_hand(self, jacobian: impl Fn(&[f64], &mut [f64]) + 'static) -> Self {
        Case { by_hand: Some(Box::new(jacobian)), ..self }
    }

    /// With the solution that [`Method::Robust`](crate::Method::Robust) finds from the start, refined.
    ///
    /// # Errors
    /// As [`Reference::refined`].
    pub fn refined(self) -> Result<Self, AccuracyError> {
        let reference = self.refine(&self.model.near(&self.start)?)?;
        Ok(self.solved_by(reference))
    }

    /// The solution near a point: [`Reference::refined`].
    ///
    /// # Errors
    /// As [`Reference::refined`].
    pub fn refine(&self, near: &[f64]) -> Result<Reference, AccuracyError> {
        self.model.refined(near)
    }

    /// Number of variables.
    pub fn n(&self) -> usize {
        self.start.len()
    }

    /// Names, bounds, families.
    pub fn shape(&self) -> &Shape {
        self.model.shape()
    }

    /// Whether there is a Jacobian by hand.
    pub fn has_by_hand(&self) -> bool {
        self.by_hand.is_some()
    }

    /// The error of a point: the distance to the nearest known solution, [`Reference::distance`].
    ///
    /// # Errors
    /// [`AccuracyError::NoReference`].
    pub fn error(&self, z: &[f64]) -> Result<f64, AccuracyError> {
        let distances = self.references.iter().map(|reference| reference.distance(z));
        let nearest = distances.reduce(|nearest, d| if d <= nearest { d } else { nearest });
        nearest.ok_or_else(|| AccuracyError::NoReference { case: self.name.clone() })
    }

    /// The first known solution, rounded.
    ///
    /// # Errors
    /// [`AccuracyError::NoReference`].
    pub fn solution(&self) -> Result<Vec<f64>, AccuracyError> {
        let first = self.references.first();
        let first = first.ok_or_else(|| AccuracyError::NoReference { case: self.name.clone() })?;
        Ok(first.z.iter().map(|z| z.to_f64()).collect())
    }

    /// The problem with exact derivatives and `F` in the given arithmetic.
    ///
    /// # Errors
    /// As [`AdProblem::new`].
    pub fn in_arithmetic(&self, f: Arithmetic) -> Result<Box<dyn Problem + '_>, ModelError> {
        match f {
            Arithmetic::F64 => self.model.exact(Engine::Jet),
            Arithmetic::DoubleDouble => self.model.precise(),
        }
    }

    /// The problem with derivatives of a source.
    ///
    /// # Errors
    /// [`AccuracyError::NotByHand`]; [`AccuracyError::NoReference`] for the best steps, which are
    /// chosen at the solution; else as [`AdProblem::new`].
    pub fn problem(&self, source: Source) -> Result<Box<dyn Problem + '_>, AccuracyError> {
        let plain = self.model.exact(Engine::Jet)?;
        Ok(match source {
            Source::Jet => plain,
            Source::NumDual => self.model.exact(Engine::NumDual)?,
            Source::ByHand => match &self.by_hand {
                Some(by_hand) => Box::new(ByHand::new(plain, by_hand)),
                None => return Err(AccuracyError::NotByHand { case: self.name.clone() }),
            },
            Source::OneSided => Box::new(Differences::new(plain, Scheme::OneSided)),
            Source::Central => Box::new(Differences::new(plain, Scheme::Central)),
            Source::BestCentral => Box::new(self.with_best_steps(plain)?),
        })
    }

    fn with_best_steps<P: Problem>(&self, mut plain: P) -> Result<Differences<P>, AccuracyError> {
        let z = self.solution()?;
        let mut exact = vec![0.0; plain.pattern().nnz()];
        plain.evaluate(&z, None, Some(&mut exact));
        let steps = Differences::new(&mut plain, Scheme::Central).best_steps(&z, &exact);
        Ok(Differences::new(plain, Scheme::Central).with_steps(&steps))
    }

    /// The Jacobian at `z` in double-double, in the order of the pattern, by jets.
    pub(super) fn exact_jacobian(&self, z: &[f64]) -> Result<Vec<DoubleDouble>, AccuracyError> {
        Ok(self.model.exact_jacobian(z)?)
    }

    /// Scalar operations of `F`, and of `J` by the source; `None` for derivatives whose operations
    /// are not counted: those by hand and by num-dual.
    ///
    /// # Errors
    /// As [`AdProblem::new`].
    pub fn operations(&self, source: Source) -> Result<(u64, Option<u64>), AccuracyError> {
        let [f, jets] = self.model.operations()?;
        let by_differences = |scheme| -> Result<u64, ModelError> {
            let problem = Differences::new(self.model.exact(Engine::Jet)?, scheme);
            Ok(f * problem.passes_per_jacobian() as u64)
        };
        let j = match source {
            Source::Jet => Some(jets),
            Source::NumDual | Source::ByHand => None,
            Source::OneSided => Some(by_differences(Scheme::OneSided)?),
            Source::Central | Source::BestCentral => Some(by_differences(Scheme::Central)?),
        };
        Ok((f, j))
    }
}

/// `F` in double-double, rounded to `f64`; `J` by jets.
struct Precise<'m, M>(AdProblem<&'m M>);

impl<M: Model> Problem for Precise<'_, M> {
    fn shape(&self) -> &Arc<Shape> {
        self.0.shape()
    }
    fn pattern(&self) -> &Pattern {
        self.0.pattern()
    }
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        self.0.evaluate(z, None, jac);
        let Some(f) = f else { return };
        let z: Vec<Real<DoubleDouble>> = z.iter().map(|&z| Real::from(z)).collect();
        f.fill(0.0);
        for (row, value) in self.0.rows_at(&z).into_iter().enumerate() {
            f[self.0.shape().variable_of_row(row)] = value.into_scalar().to_f64();
        }
    }
    fn derived(&self, z: &[f64]) -> Derived {
        self.0.derived(z)
    }
}

#[cfg(test)]
#[path = "case_tests.rs"]
mod tests;
