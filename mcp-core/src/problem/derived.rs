//! [`Derived`]: what a model computes beside `F`.

use super::record::constants;
use crate::model::{Model, Reader, Shape};
use crate::scalar::{Real, Scalar};

/// What a model computes beside `F`: in the order of the families in its shape.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Derived {
    /// One value for each definition.
    pub definitions: Vec<f64>,
    /// One value for each report.
    pub reports: Vec<f64>,
}

/// A model in plain numbers, whatever the model: what takes it is compiled once.
#[doc(hidden)]
pub trait PlainModel {
    /// [`Model::shape`].
    fn plain_shape(&self) -> &Shape;
    /// [`Model::row`].
    fn plain_row(&self, family: usize, index: usize, read: &Reader<'_, f64>) -> Real<f64>;
    /// [`Model::def`].
    fn plain_def(&self, family: usize, index: usize, read: &Reader<'_, f64>) -> Real<f64>;
    /// [`Model::report`].
    fn plain_report(&self, family: usize, index: usize, read: &Reader<'_, f64>) -> Real<f64>;
}

impl<M: Model> PlainModel for M {
    fn plain_shape(&self) -> &Shape {
        self.shape()
    }
    fn plain_row(&self, family: usize, index: usize, read: &Reader<'_, f64>) -> Real<f64> {
        self.row(family, index, read)
    }
    fn plain_def(&self, family: usize, index: usize, read: &Reader<'_, f64>) -> Real<f64> {
        self.def(family, index, read)
    }
    fn plain_report(&self, family: usize, index: usize, read: &Reader<'_, f64>) -> Real<f64> {
        self.report(family, index, read)
    }
}

impl Derived {
    /// Evaluates definitions and reports at `z`, with these parameters.
    pub(crate) fn at(model: &dyn PlainModel, z: &[f64], parameters: &[f64]) -> Self {
        let shape = model.plain_shape();
        let (z, parameters) = (constants(z), constants(parameters));
        let definitions = plain_definitions(model, &z, &parameters);
        let read = Reader::lanes(&z, &definitions, &parameters);
        let mut reports = Vec::new();
        for family in shape.reports() {
            let report = |index| model.plain_report(family.entry(), index, &read).into_scalar();
            reports.extend((0..family.len()).map(report));
        }
        let definitions = definitions.into_iter().map(Real::into_scalar).collect();
        Derived { definitions, reports }
    }
}

/// All definitions of a model in plain numbers.
pub(crate) fn plain_definitions(
    model: &dyn PlainModel,
    z: &[Real<f64>],
    parameters: &[Real<f64>],
) -> Vec<Real<f64>> {
    let mut def = |k, index, read: &Reader<'_, f64>| model.plain_def(k, index, read);
    definitions(model.plain_shape(), &mut def, z, parameters)
}

/// One definition, by its family and its index.
type Def<'a, D> = dyn FnMut(usize, usize, &Reader<'_, D>) -> Real<D> + 'a;

/// All definitions in order, in any arithmetic: each reads those before it.
pub(super) fn definitions<D: Scalar>(
    shape: &Shape,
    def: &mut Def<'_, D>,
    z: &[Real<D>],
    parameters: &[Real<D>],
) -> Vec<Real<D>> {
    let mut definitions: Vec<Real<D>> = Vec::with_capacity(shape.definition_count());
    for family in shape.definitions() {
        for index in 0..family.len() {
            let value = def(family.entry(), index, &Reader::lanes(z, &definitions, parameters));
            definitions.push(value);
        }
    }
    definitions
}
