//! Derivatives that are the same at every point: found on a tape, copied into every Jacobian.
//!
//! A linear term costs nothing then: of the row `4 z − z_w − z_e − z_s − z_n + h² z³` only the
//! derivative by `z` is carried. A derivative is constant if no slope between the row and what it
//! reads depends on variables, which the structure of the row tells and no value.

use super::Pattern;
use super::local::SlotTable;
use super::packed::Packed;
use super::plan::Plan;
use super::record::small;
use super::rows::{JetRows, Kind, RowsIn};
use super::runs::RowPlan;
use crate::model::{Give, NO_LANE, Point, Reader, Row, Slots};
use crate::scalar::{Dependence, Real, Scalar, Tape, TapeMemory, Taped};
use std::cell::{Cell, RefCell};

/// The constant part of all derivatives, for these parameters.
#[derive(Debug, Default)]
pub(super) struct Constants {
    /// By the entries of the Jacobian.
    pub(super) jacobian: Packed,
    /// By the entries of the gradients of definitions.
    pub(super) gradients: Vec<f64>,
    /// The parameters they were found with.
    pub(super) parameters: Vec<f64>,
    /// Whether any derivative is constant.
    pub(super) exist: bool,
}

impl Constants {
    /// Values that start from the constants, from 0 without.
    pub(super) fn start(&self, jac: &mut [f64], gradients: &mut [f64]) {
        if self.exist {
            self.jacobian.copy_to(jac);
            gradients.copy_from_slice(&self.gradients);
        } else {
            jac.fill(0.0);
            gradients.fill(0.0);
        }
    }

    /// No constants yet, with these parameters.
    pub(super) fn clear(&mut self, plan: &Plan, pattern: &Pattern, parameters: &[f64]) {
        self.jacobian.clear(pattern.nnz());
        self.gradients.clear();
        self.gradients.resize(plan.gradient_entries(), 0.0);
        self.parameters.clear();
        self.parameters.extend_from_slice(parameters);
    }

    /// All are found: memory that is not needed is given back.
    pub(super) fn shrink(&mut self) {
        if self.exist {
            self.jacobian.pack();
        } else {
            *self = Constants::default();
        }
    }

    /// Adds what is constant in the row that was surveyed last; the other derivatives are `carried`.
    pub(super) fn add(
        &mut self,
        plan: &Plan,
        (row, carried): ((Kind, usize), RowPlan<'_>),
        pattern: &Pattern,
        survey: &Survey,
    ) {
        let [variables, definitions, _] = carried.split();
        for read in &survey.variables {
            if variables.binary_search(&read.number).is_err() {
                self.add_one(row.0, plan.place(row, read.number, pattern), read.derivative);
            }
        }
        for read in &survey.definitions {
            if plan.supports.find(definitions, read.number) {
                continue;
            }
            let (d, derivative) = (read.number as usize, read.derivative);
            let support = plan.supports.variables(plan.supports.of_definition[d]);
            for (k, &j) in plan.gradient_of[d].clone().zip(support) {
                let by_variable = self.gradients[k];
                if by_variable != 0.0 {
                    let place = plan.place(row, j, pattern);
                    self.add_one(row.0, place, derivative * by_variable);
                }
            }
        }
    }

    fn add_one(&mut self, kind: Kind, place: usize, derivative: f64) {
        self.exist = true;
        match kind {
            Kind::Equation => self.jacobian.add(place, derivative),
            Kind::Definition => self.gradients[place] += derivative,
        }
    }
}

/// What a row reads, and the derivative by it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Read {
    /// Number of the variable or definition.
    pub(super) number: u32,
    lane: u32,
    derivative: f64,
    /// Whether the derivative is the same at every point.
    pub(super) is_constant: bool,
}

/// Runs rows on a tape, with a lane for everything they read.
#[derive(Debug)]
pub(super) struct Survey {
    /// Without lanes between rows.
    pub(super) table: SlotTable,
    pub(super) memory: TapeMemory,
    /// What the last row read, by number.
    pub(super) variables: Vec<Read>,
    pub(super) definitions: Vec<Read>,
    pub(super) derivatives: Vec<f64>,
    dependence: Vec<Dependence>,
}

impl Survey {
    pub(super) fn new(variables: usize, definitions: usize) -> Self {
        Survey {
            table: SlotTable::new(variables, definitions),
            memory: TapeMemory::default(),
            variables: Vec::new(),
            definitions: Vec::new(),
            derivatives: Vec::new(),
            dependence: Vec::new(),
        }
    }

    /// Runs a row and returns its value.
    pub(super) fn run(
        &mut self,
        rows: &dyn JetRows,
        (kind, row): (Kind, Row),
        point: Point<'_>,
    ) -> f64 {
        let tape = Tape::over(std::mem::take(&mut self.memory));
        tape.begin(0);
        self.variables.clear();
        self.definitions.clear();
        let (variables, definitions) = (&mut self.variables, &mut self.definitions);
        let (variables, definitions) = (RefCell::new(variables), RefCell::new(definitions));
        let reads = Reads { point, tape: &tape, slots: self.table.slots(), variables, definitions };
        let result = on_tape(rows, kind, row, &reads);
        tape.differentiate(&result, &mut self.derivatives);
        tape.dependence(&result, &mut self.dependence);
        let value = result.plain();
        self.memory = tape.into_memory();
        for reads in [&mut self.variables, &mut self.definitions] {
            reads.sort_unstable_by_key(|read| read.number);
            for read in reads {
                let lane = read.lane as usize;
                read.derivative = self.derivatives[lane];
                read.is_constant =
                    self.dependence[lane] != Dependence::Varying && read.derivative.is_finite();
            }
        }
        let slots = self.table.slots();
        self.variables.iter().for_each(|read| slots.variables[read.number as usize].set(NO_LANE));
        self.definitions
            .iter()
            .for_each(|read| slots.definitions[read.number as usize].set(NO_LANE));
        value
    }
}

/// Apart, so that the lifetime of the tape has a name.
fn on_tape<'t>(rows: &dyn JetRows, kind: Kind, row: Row, reads: &'t Reads<'t>) -> Taped<'t> {
    RowsIn::<Taped<'t>>::row_in(rows, kind, row, &Reader::other(reads)).0
}

/// Plain numbers that get a lane when they are read for the first time.
struct Reads<'t> {
    point: Point<'t>,
    tape: &'t Tape,
    slots: Slots<'t>,
    variables: RefCell<&'t mut Vec<Read>>,
    definitions: RefCell<&'t mut Vec<Read>>,
}

impl<'t> Give<Taped<'t>> for Reads<'t> {
    fn var(&self, j: usize) -> Real<Taped<'t>> {
        self.read(self.point.z[j], j, &self.slots.variables[j], &self.variables)
    }
    fn def(&self, k: usize) -> Real<Taped<'t>> {
        self.read(self.point.definitions[k], k, &self.slots.definitions[k], &self.definitions)
    }
    fn param(&self, k: usize) -> Real<Taped<'t>> {
        Real(Taped::constant(self.point.parameters[k]))
    }
}

impl<'t> Reads<'t> {
    /// Number `k` of its kind, with its slot and the list of what was read.
    fn read(
        &self,
        value: f64,
        k: usize,
        slot: &Cell<u32>,
        list: &RefCell<&mut Vec<Read>>,
    ) -> Real<Taped<'t>> {
        if slot.get() != NO_LANE {
            return Real(self.tape.read(value, slot.get()));
        }
        let lane = self.tape.len();
        slot.set(lane);
        let read = Read { number: small(k), lane, derivative: f64::NAN, is_constant: false };
        list.borrow_mut().push(read);
        Real(self.tape.leaf(value))
    }
}

#[cfg(test)]
#[path = "constants_tests.rs"]
mod tests;
