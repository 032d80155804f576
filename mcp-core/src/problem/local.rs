//! One row at a point, with lanes for what it reads.

use super::record::small;
use super::rows::{Kind, RowsIn};
use crate::model::{Local, NO_LANE, OnTape, Reader, Row, Slots};
use crate::scalar::{Scalar, Taped};
use std::cell::Cell;

/// Rows with derivatives, in an arithmetic that is chosen by their number of lanes.
pub(super) trait LaneChoice {
    /// Evaluates `row`, gives the derivative in each lane to `put` in order, returns the value.
    fn evaluate(&self, row: &LocalRow<'_>, put: impl FnMut(usize, f64)) -> f64;
}

/// One equation or definition at a point, with the lanes of what it reads.
pub(super) struct LocalRow<'a> {
    pub(super) kind: Kind,
    pub(super) row: Row,
    pub(super) local: &'a Local<'a>,
    pub(super) lanes: usize,
}

impl LocalRow<'_> {
    #[inline]
    pub(super) fn value(&self, rows: &(impl RowsIn<f64> + ?Sized)) -> f64 {
        rows.row_in(self.kind, self.row, &Reader::plain(self.local.point)).0
    }

    /// Forward: one evaluation for every `D::LANES` lanes.
    #[inline]
    pub(super) fn in_lanes<D: Scalar>(
        &self,
        rows: &(impl RowsIn<D> + ?Sized),
        mut put: impl FnMut(usize, f64),
    ) -> f64 {
        let mut first = 0;
        loop {
            self.local.first_lane.set(small(first));
            let result = rows.row_in(self.kind, self.row, &Reader::local(self.local)).0;
            let carried = D::LANES.min(self.lanes - first);
            for lane in 0..carried {
                put(first + lane, result.tangent(lane));
            }
            first += D::LANES;
            if first >= self.lanes {
                return result.value();
            }
        }
    }

    /// Backward: one evaluation, and one sweep over its operations for all lanes.
    pub(super) fn on_tape<'t>(
        &self,
        rows: &(impl RowsIn<Taped<'t>> + ?Sized),
        reads: &'t OnTape<'t>,
        adjoints: &mut Vec<f64>,
    ) -> f64 {
        reads.tape.begin(small(self.lanes));
        let result = rows.row_in(self.kind, self.row, &Reader::other(reads)).0;
        reads.tape.differentiate(&result, adjoints);
        result.plain()
    }
}

/// The lane of every variable and definition that the row at hand reads.
#[derive(Debug, Default)]
pub(super) struct SlotTable {
    variables: Vec<u32>,
    definitions: Vec<u32>,
}

impl SlotTable {
    /// Without lanes.
    pub(super) fn new(variables: usize, definitions: usize) -> Self {
        SlotTable { variables: vec![NO_LANE; variables], definitions: vec![NO_LANE; definitions] }
    }

    pub(super) fn slots(&mut self) -> Slots<'_> {
        Slots {
            variables: Cell::from_mut(&mut self.variables[..]).as_slice_of_cells(),
            definitions: Cell::from_mut(&mut self.definitions[..]).as_slice_of_cells(),
        }
    }
}

impl Slots<'_> {
    /// Lanes for these, in order.
    #[inline]
    pub(super) fn assign(&self, variables: &[u32], definitions: &[u32]) {
        let mut lane = 0;
        for &j in variables {
            self.variables[j as usize].set(lane);
            lane += 1;
        }
        for &d in definitions {
            self.definitions[d as usize].set(lane);
            lane += 1;
        }
    }

    /// No lanes for these any more.
    #[inline]
    pub(super) fn clear(&self, variables: &[u32], definitions: &[u32]) {
        for &j in variables {
            self.variables[j as usize].set(NO_LANE);
        }
        for &d in definitions {
            self.definitions[d as usize].set(NO_LANE);
        }
    }
}
