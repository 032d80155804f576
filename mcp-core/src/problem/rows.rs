//! Derivatives row by row: a row carries only the lanes of what it reads.
//!
//! Everything but the rows themselves is compiled once, whatever the model: it sees the model as
//! [`RowsIn`] an arithmetic.

use super::Pattern;
use super::ad::Pass;
use super::plan::{Plan, RowPlan};
use super::record::{Recorded, all_rows, small, support_of};
use crate::apart::Apart;
use crate::model::{Local, Model, Point, Reader, Row, Shape, Slots};
use crate::scalar::{Jet, Magnitude, Real, Scalar, Wide};
use num_dual::DualSVec64;
use std::marker::PhantomData;

/// The slot of a number that the row at hand does not read: it carries no tangent.
const NO_LANE: u32 = u32::MAX;

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

#[derive(Clone, Copy)]
pub(super) enum Kind {
    Equation,
    Definition,
}

/// Rows with derivatives, in an arithmetic that is chosen by their number of lanes.
pub(super) trait LaneChoice {
    /// Evaluates `row`, gives the derivative in each lane to `put` in order, returns the value.
    fn evaluate(&self, row: &LocalRow<'_>, put: &mut impl FnMut(usize, f64)) -> f64;
}

/// Rows in plain numbers and in those of [`Jets`].
pub(super) trait JetRows: RowsIn<f64> + RowsIn<Jet<8>> + RowsIn<Wide> {}

impl<M: Model> JetRows for M {}

/// [`Jet`] with 8 or 16 lanes at a time: few counts, because a user's compiler meets every row once
/// for each. One of 4 gains nothing for narrow rows.
struct Jets<'a>(&'a dyn JetRows);

impl LaneChoice for Jets<'_> {
    fn evaluate(&self, row: &LocalRow<'_>, put: &mut impl FnMut(usize, f64)) -> f64 {
        match row.lanes {
            0 => row.value(self.0),
            1..=8 => row.evaluate::<Jet<8>>(self.0, put),
            _ => row.evaluate::<Wide>(self.0, put),
        }
    }
}

/// One arithmetic for all rows.
struct Always<'a, D>(&'a dyn RowsIn<D>);

impl<D: Scalar> LaneChoice for Always<'_, D> {
    fn evaluate(&self, row: &LocalRow<'_>, put: &mut impl FnMut(usize, f64)) -> f64 {
        row.evaluate(self.0, put)
    }
}

/// One equation or definition at a point, with the lanes of what it reads.
pub(super) struct LocalRow<'a> {
    kind: Kind,
    row: Row,
    point: Point<'a>,
    slots: Slots<'a>,
    lanes: usize,
}

impl LocalRow<'_> {
    fn value(&self, rows: &(impl RowsIn<f64> + ?Sized)) -> f64 {
        rows.row_in(self.kind, self.row, &Reader::plain(self.point)).0
    }

    /// One evaluation for every `D::LANES` lanes.
    fn evaluate<D: Scalar>(
        &self,
        rows: &(impl RowsIn<D> + ?Sized),
        put: &mut impl FnMut(usize, f64),
    ) -> f64 {
        let mut first = 0;
        loop {
            let local = Local { point: self.point, slots: self.slots, first_lane: small(first) };
            let result = rows.row_in(self.kind, self.row, &Reader::other(&local)).0;
            for k in first..self.lanes.min(first + D::LANES) {
                put(k, result.tangent(k - first));
            }
            first += D::LANES;
            if first >= self.lanes {
                return result.value();
            }
        }
    }
}

impl Plan {
    /// Value of a row; its derivatives by variables go to the row's targets in `gradient`.
    /// `known` are the gradients of the definitions it may read.
    fn differentiate(
        &self,
        (model, kind, plan): (&impl LaneChoice, Kind, &RowPlan),
        point: Point<'_>,
        slots: &mut SlotTable,
        known: &[f64],
        gradient: &mut [f64],
    ) -> f64 {
        let variables = &self.variables_read[plan.variables.clone()];
        let definitions = &self.definitions_read[plan.definitions.clone()];
        let targets = &self.targets[plan.targets.clone()];
        slots.assign(variables, definitions);
        let lanes = variables.len() + definitions.len();
        let row = LocalRow { kind, row: plan.row, point, slots: slots.view(), lanes };
        let mut used = variables.len();
        // Every entry belongs to one row. Variables come first, each with a target of its own.
        for &target in &targets[used..] {
            gradient[target as usize] = 0.0;
        }
        let value = model.evaluate(&row, &mut |lane, derivative| {
            if lane < variables.len() {
                gradient[targets[lane] as usize] = derivative;
                return;
            }
            // ∂f/∂d · ∂d/∂z; lanes arrive in order, and so do their targets.
            let support = self.gradient_of[definitions[lane - variables.len()] as usize].clone();
            for (&target, &by_variable) in targets[used..].iter().zip(&known[support.clone()]) {
                if by_variable != 0.0 {
                    gradient[target as usize] += derivative * by_variable;
                }
            }
            used += support.len();
        });
        slots.clear(variables, definitions);
        value
    }
}

/// The lane of every variable and definition that the row at hand reads.
#[derive(Debug)]
struct SlotTable {
    variables: Vec<u32>,
    definitions: Vec<u32>,
}

impl SlotTable {
    fn assign(&mut self, variables: &[u32], definitions: &[u32]) {
        let mut lane = 0;
        for &j in variables {
            self.variables[j as usize] = lane;
            lane += 1;
        }
        for &d in definitions {
            self.definitions[d as usize] = lane;
            lane += 1;
        }
    }

    fn clear(&mut self, variables: &[u32], definitions: &[u32]) {
        for &j in variables {
            self.variables[j as usize] = NO_LANE;
        }
        for &d in definitions {
            self.definitions[d as usize] = NO_LANE;
        }
    }

    fn view(&self) -> Slots<'_> {
        Slots { variables: &self.variables, definitions: &self.definitions }
    }
}

/// Workspace of row-by-row evaluation.
pub(super) struct Rows {
    plan: Plan,
    slots: SlotTable,
    definition_values: Vec<f64>,
    /// Gradients of all definitions by the variables of their supports, one after the other.
    gradients: Vec<f64>,
}

impl Rows {
    pub(super) fn new(shape: &Shape, recorded: &Recorded, pattern: &Pattern) -> Self {
        let plan = Plan::new(shape, recorded, pattern);
        let definitions = plan.definitions.ends.len();
        Rows {
            slots: SlotTable {
                variables: vec![NO_LANE; shape.n()],
                definitions: vec![NO_LANE; definitions],
            },
            definition_values: vec![0.0; definitions],
            gradients: vec![0.0; plan.gradient_of.last().map_or(0, |range| range.end)],
            plan,
        }
    }

    fn residual(&mut self, rows: &dyn RowsIn<f64>, z: &[f64], parameters: &[f64], f: &mut [f64]) {
        for (k, plan) in self.plan.definitions.rows().enumerate() {
            let point = Point { z, definitions: &self.definition_values, parameters };
            let value = rows.row_in(Kind::Definition, plan.row, &Reader::plain(point));
            self.definition_values[k] = value.0;
        }
        let point = Point { z, definitions: &self.definition_values, parameters };
        let read = Reader::plain(point);
        if f.len() > self.plan.variable_of_row.len() {
            f.fill(0.0);
        }
        let rows_of_families = all_rows(self.plan.equations.blocks.iter().copied());
        for (row, &i) in rows_of_families.zip(&self.plan.variable_of_row) {
            f[i as usize] = rows.row_in(Kind::Equation, row, &read).0;
        }
    }

    fn jacobian(
        &mut self,
        rows: &impl LaneChoice,
        (z, parameters): (&[f64], &[f64]),
        mut f: Option<&mut [f64]>,
        jac: &mut [f64],
    ) {
        let Rows { plan, slots, definition_values, gradients } = self;
        for (k, row) in plan.definitions.rows().enumerate() {
            let (known, own) = gradients.split_at_mut(plan.gradient_of[k].start);
            let point = Point { z, definitions: definition_values, parameters };
            let row = (rows, Kind::Definition, &row);
            definition_values[k] = plan.differentiate(row, point, slots, known, own);
        }
        if let Some(f) = &mut f
            && f.len() > plan.variable_of_row.len()
        {
            f.fill(0.0);
        }
        let point = Point { z, definitions: definition_values, parameters };
        for (row, &i) in plan.equations.rows().zip(&plan.variable_of_row) {
            let row = (rows, Kind::Equation, &row);
            let value = plan.differentiate(row, point, slots, gradients, jac);
            if let Some(f) = &mut f {
                f[i as usize] = value;
            }
        }
    }

    /// Not generic: compiled here, not with every model.
    fn jacobian_by_jets(
        &mut self,
        rows: &dyn JetRows,
        at: (&[f64], &[f64]),
        f: Option<&mut [f64]>,
        jac: &mut [f64],
    ) {
        self.jacobian(&Jets(rows), at, f, jac);
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
        _pattern: &Pattern,
        f: Option<&mut [f64]>,
        jac: &mut [f64],
    ) {
        self.0.jacobian_by_jets(model, at, f, jac);
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
