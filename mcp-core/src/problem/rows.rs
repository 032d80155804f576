//! Derivatives row by row: a row carries only the lanes of what it reads.
//!
//! Everything but the rows themselves is compiled once, whatever the model: it sees the model as
//! [`RowsIn`] an arithmetic.

use super::Pattern;
use super::ad::Pass;
use super::constants::{Constants, Survey};
use super::local::{LaneChoice, LocalRow};
use super::plan::Plan;
use super::record::{Recorded, support_of};
use super::runs::{RowList, RowPlan};
use crate::apart::Apart;
use crate::model::{Local, Model, OnTape, Point, Reader, Row, Shape};
use crate::scalar::{Jet, Magnitude, Real, Scalar, Tape, Taped};
use num_dual::DualSVec64;
use std::cell::{Cell, RefCell};
use std::marker::PhantomData;

/// Rows of a model in one arithmetic, whatever the model.
pub(super) trait RowsIn<D: Scalar> {
    /// An equation or a definition.
    fn row_in(&self, kind: Kind, row: Row, read: &Reader<'_, D>) -> Real<D>;
}

impl<M: Model, D: Scalar> RowsIn<D> for M {
    fn row_in(&self, kind: Kind, Row { family, index }: Row, read: &Reader<'_, D>) -> Real<D> {
        match kind {
            Kind::Equation => self.row(family, index, read),
            Kind::Definition => self.def(family, index, read),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Equation,
    Definition,
}

/// Rows in plain numbers, in jets and on a tape.
pub(super) trait JetRows: RowsIn<f64> + RowsIn<Jet<8>> + for<'t> RowsIn<Taped<'t>> {}

impl<M: Model> JetRows for M {}

/// Narrow rows forward, in [`Jet`]s, wide rows backward, on a tape. Few arithmetics, because a user's
/// compiler meets every row once for each.
struct Jets<'a> {
    rows: &'a dyn JetRows,
    tape: &'a Tape,
    adjoints: RefCell<Vec<f64>>,
}

impl LaneChoice for Jets<'_> {
    #[inline]
    fn evaluate(&self, row: &LocalRow<'_>, mut put: impl FnMut(usize, f64)) -> f64 {
        match row.lanes {
            0 => row.value(self.rows),
            1..=8 => row.in_lanes::<Jet<8>>(self.rows, put),
            lanes => {
                let adjoints = &mut *self.adjoints.borrow_mut();
                let value = on_tape(self.rows, row, self.tape, adjoints);
                for (lane, &derivative) in adjoints[..lanes].iter().enumerate() {
                    put(lane, derivative);
                }
                value
            }
        }
    }
}

/// Not generic: compiled here, once.
fn on_tape(rows: &dyn JetRows, row: &LocalRow<'_>, tape: &Tape, adjoints: &mut Vec<f64>) -> f64 {
    row.on_tape(rows, &OnTape { local: row.local, tape }, adjoints)
}

/// One arithmetic for all rows.
struct Always<'a, D>(&'a dyn RowsIn<D>);

impl<D: Scalar> LaneChoice for Always<'_, D> {
    fn evaluate(&self, row: &LocalRow<'_>, put: impl FnMut(usize, f64)) -> f64 {
        row.in_lanes(self.0, put)
    }
}

/// Workspace of row-by-row evaluation.
pub(super) struct Rows {
    plan: Plan,
    constants: Constants,
    work: Work,
    definition_values: Vec<f64>,
    /// Gradients of all definitions by the variables of their supports, one after the other.
    gradients: Vec<f64>,
}

/// What the evaluation of one row needs beside the row.
struct Work {
    survey: Survey,
    /// By the definitions that the row reads.
    by_definitions: Vec<f64>,
    /// By the variables of a support.
    sum: Vec<f64>,
    /// Of the row at hand.
    list: RowList,
}

impl Rows {
    /// With `rows`, derivatives that are the same at every point are found.
    pub(super) fn new(
        rows: Option<&dyn JetRows>,
        shape: &Shape,
        recorded: &Recorded,
        pattern: &Pattern,
    ) -> Self {
        let definitions = recorded.definitions.len();
        let mut survey = Survey::new(shape.n(), definitions);
        let (plan, constants) = Plan::new(rows, shape, recorded, pattern, &mut survey);
        let [longest, most_definitions] = plan.most();
        Rows {
            work: Work {
                survey,
                by_definitions: Vec::with_capacity(most_definitions),
                sum: Vec::with_capacity(plan.largest_support()),
                list: RowList::with_capacity(longest),
            },
            definition_values: vec![0.0; definitions],
            gradients: vec![0.0; plan.gradient_entries()],
            plan,
            constants,
        }
    }

    pub(super) fn plan(&self) -> &Plan {
        &self.plan
    }

    fn residual(&mut self, rows: &dyn RowsIn<f64>, z: &[f64], parameters: &[f64], f: &mut [f64]) {
        for (k, row) in self.plan.definitions.rows().enumerate() {
            let point = Point { z, definitions: &self.definition_values, parameters };
            let value = rows.row_in(Kind::Definition, row, &Reader::plain(point));
            self.definition_values[k] = value.0;
        }
        let point = Point { z, definitions: &self.definition_values, parameters };
        let read = Reader::plain(point);
        if f.len() > self.plan.equations.len() {
            f.fill(0.0);
        }
        for (number, row) in self.plan.equations.rows().enumerate() {
            f[self.plan.variable_of(number)] = rows.row_in(Kind::Equation, row, &read).0;
        }
    }

    fn jacobian(
        &mut self,
        rows: &impl LaneChoice,
        (z, parameters): (&[f64], &[f64]),
        mut f: Option<&mut [f64]>,
        jac: &mut [f64],
    ) {
        let Rows { plan, constants, work, definition_values, gradients } = self;
        constants.start(jac, gradients);
        let Work { survey, by_definitions, sum, list } = work;
        let slots = survey.table.slots();
        let mut walk = plan.definitions.walk(list);
        for (k, row) in plan.definitions.rows().enumerate() {
            let (known, own) = gradients.split_at_mut(plan.gradient_of[k].start);
            let point = Point { z, definitions: definition_values, parameters };
            let local = Local { point, slots, first_lane: Cell::new(0) };
            let carried = walk.next();
            let lanes = carried.lanes();
            let row = LocalRow { kind: Kind::Definition, row, local: &local, lanes };
            let work = (&mut *by_definitions, &mut *sum);
            definition_values[k] = plan.differentiate(rows, &row, &carried, work, (known, own));
        }
        if let Some(f) = &mut f
            && f.len() > plan.equations.len()
        {
            f.fill(0.0);
        }
        let point = Point { z, definitions: definition_values, parameters };
        let local = Local { point, slots, first_lane: Cell::new(0) };
        let (mut walk, mut number) = (plan.equations.walk(list), 0);
        for &(family, length) in &plan.equations.blocks {
            for index in 0..length {
                let carried = walk.next();
                let (row, lanes) = (Row { family, index }, carried.lanes());
                let i = plan.variable_of(number);
                number += 1;
                if lanes == 0 && f.is_none() {
                    continue;
                }
                let row = LocalRow { kind: Kind::Equation, row, local: &local, lanes };
                let work = (&mut *by_definitions, &mut *sum);
                let value = plan.differentiate(rows, &row, &carried, work, (gradients, jac));
                if let Some(f) = &mut f {
                    f[i] = value;
                }
            }
        }
    }

    /// Not generic: compiled here, not with every model.
    fn jacobian_by_jets(
        &mut self,
        rows: &dyn JetRows,
        at: (&[f64], &[f64]),
        pattern: &Pattern,
        f: Option<&mut [f64]>,
        jac: &mut [f64],
    ) {
        if self.constants.exist && self.constants.parameters != at.1 {
            self.find_constants(rows, at, pattern);
        }
        let tape = Tape::over(std::mem::take(&mut self.work.survey.memory));
        let adjoints = RefCell::new(std::mem::take(&mut self.work.survey.derivatives));
        let jets = Jets { rows, tape: &tape, adjoints };
        self.jacobian(&jets, at, f, jac);
        self.work.survey.derivatives = jets.adjoints.into_inner();
        self.work.survey.memory = tape.into_memory();
    }

    /// Finds the constant derivatives for these parameters.
    fn find_constants(
        &mut self,
        rows: &dyn JetRows,
        (z, parameters): (&[f64], &[f64]),
        pattern: &Pattern,
    ) {
        let Rows { plan, constants, work, definition_values, .. } = self;
        let Work { survey, list, .. } = work;
        constants.clear(plan, pattern, parameters);
        for kind in [Kind::Definition, Kind::Equation] {
            let mut walk = plan.sequence(kind).walk(list);
            for (number, row) in plan.sequence(kind).rows().enumerate() {
                let point = Point { z, definitions: definition_values, parameters };
                let value = survey.run(rows, (kind, row), point);
                if kind == Kind::Definition {
                    definition_values[number] = value;
                }
                constants.add(plan, ((kind, number), walk.next()), pattern, survey);
            }
        }
        constants.shrink();
    }
}

impl Plan {
    /// Value of a row; its derivatives by variables are added to the row's targets in `gradient`.
    /// `known` are the gradients of the definitions it may read.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "it stands in two loops")]
    fn differentiate(
        &self,
        rows: &impl LaneChoice,
        row: &LocalRow<'_>,
        carried: &RowPlan<'_>,
        (by_definitions, sum): (&mut Vec<f64>, &mut Vec<f64>),
        (known, gradient): (&[f64], &mut [f64]),
    ) -> f64 {
        let [variables, definitions, targets] = carried.split();
        let slots = &row.local.slots;
        slots.assign(variables, definitions);
        by_definitions.clear();
        let (own, targets) = targets.split_at(variables.len());
        let value = rows.evaluate(row, |lane, derivative| match own.get(lane) {
            Some(&target) => gradient[target as usize] += derivative,
            None => by_definitions.push(derivative),
        });
        slots.clear(variables, definitions);
        if !definitions.is_empty() {
            self.chain(definitions, by_definitions, sum, targets, (known, gradient));
        }
        value
    }

    /// `∂f/∂d · ∂d/∂z` of all definitions that a row reads.
    fn chain(
        &self,
        definitions: &[u32],
        mut factors: &[f64],
        sum: &mut Vec<f64>,
        mut targets: &[u32],
        (known, gradient): (&[f64], &mut [f64]),
    ) {
        let by_variables = |d: u32| &known[self.gradient_of[d as usize].clone()];
        for group in self.supports.groups(definitions) {
            let (own_factors, rest) = factors.split_at(group.len());
            factors = rest;
            let (own, rest) = targets.split_at(self.gradient_of[group[0] as usize].len());
            targets = rest;
            if let ([d], [factor], [target]) = (group, own_factors, own) {
                let by_variable = by_variables(*d)[0];
                if by_variable != 0.0 {
                    gradient[*target as usize] += factor * by_variable;
                }
                continue;
            }
            sum.clear();
            sum.resize(own.len(), 0.0);
            let (fours, rest) = group.as_chunks::<4>();
            let (four_factors, rest_factors) = own_factors.as_chunks::<4>();
            for (four, factors) in fours.iter().zip(four_factors) {
                add_four_products(sum, *factors, four.map(by_variables));
            }
            for (&d, &factor) in rest.iter().zip(rest_factors) {
                add_product(sum, factor, by_variables(d));
            }
            for (&target, derivative) in own.iter().zip(&*sum) {
                gradient[target as usize] += derivative;
            }
        }
    }
}

/// `sum += ∂f/∂d · ∂d/∂z`; entries that are 0 stay out where the factor is not finite.
fn add_product(sum: &mut [f64], factor: f64, gradient: &[f64]) {
    if factor.is_finite() {
        for (sum, by_variable) in sum.iter_mut().zip(gradient) {
            *sum += factor * by_variable;
        }
    } else {
        for (sum, by_variable) in sum.iter_mut().zip(gradient).filter(|(_, by)| **by != 0.0) {
            *sum += factor * by_variable;
        }
    }
}

/// [`add_product`] of four definitions, in one pass over the sum.
fn add_four_products(sum: &mut [f64], factors: [f64; 4], gradients: [&[f64]; 4]) {
    if !factors.into_iter().all(f64::is_finite) {
        for (factor, gradient) in factors.into_iter().zip(gradients) {
            add_product(sum, factor, gradient);
        }
        return;
    }
    let n = sum.len();
    let [a, b, c, d] = gradients;
    let (a, b, c, d) = (&a[..n], &b[..n], &c[..n], &d[..n]);
    for j in 0..n {
        let two = sum[j] + factors[0] * a[j] + factors[1] * b[j];
        sum[j] = two + factors[2] * c[j] + factors[3] * d[j];
    }
}

/// Pattern of the Jacobian: for every row the union of what it reads and of the supports of the
/// definitions it reads.
pub(super) fn pattern_of(shape: &Shape, recorded: &Recorded) -> Pattern {
    Pattern::from_row_lists(shape.n(), |i, put| {
        let Some(row) = shape.row_of_variable(i) else { return };
        let reads = recorded.rows.row(row);
        if reads.definitions.is_empty() {
            for &j in reads.variables {
                put(j as usize);
            }
        } else {
            for j in support_of(reads, &recorded.definition_supports) {
                put(j as usize);
            }
        }
    })
}

/// Derivatives by [`Jet`].
pub(super) struct ByJets(pub(super) Apart<Rows>);

impl<M: Model> Pass<M> for ByJets {
    #[inline]
    fn residual(&mut self, model: &M, z: &[f64], parameters: &[f64], f: &mut [f64]) {
        self.0.residual(model, z, parameters, f);
    }
    #[inline]
    fn jacobian(
        &mut self,
        model: &M,
        at: (&[f64], &[f64]),
        pattern: &Pattern,
        f: Option<&mut [f64]>,
        jac: &mut [f64],
    ) {
        self.0.jacobian_by_jets(model, at, pattern, f, jac);
    }
}

/// Derivatives in one arithmetic for all rows.
pub(super) struct By<D> {
    rows: Apart<Rows>,
    arithmetic: PhantomData<fn() -> D>,
}

impl<D> By<D> {
    pub(super) fn new(rows: Apart<Rows>) -> Self {
        By { rows, arithmetic: PhantomData }
    }
}

/// num-dual's vector duals, eight lanes at a time.
pub(super) type ByNumDual = By<DualSVec64<8>>;

/// Sizes of the terms of every derivative instead of the derivatives.
pub(super) type ByMagnitude = By<Magnitude<8>>;

impl<M: Model, D: Scalar> Pass<M> for By<D> {
    fn residual(&mut self, model: &M, z: &[f64], parameters: &[f64], f: &mut [f64]) {
        self.rows.residual(model, z, parameters, f);
    }
    fn jacobian(
        &mut self,
        model: &M,
        at: (&[f64], &[f64]),
        _pattern: &Pattern,
        f: Option<&mut [f64]>,
        jac: &mut [f64],
    ) {
        self.rows.jacobian(&Always::<D>(model), at, f, jac);
    }
}
