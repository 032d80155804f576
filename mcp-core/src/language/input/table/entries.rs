//! [`Entries`]: a table filled in any order, each element once.

use crate::Set;
use crate::language::input::positions::element_name;
use crate::language::input::{DataError, Place};

/// The numbers found so far.
pub(super) struct Entries<'a> {
    pub(super) table: &'a str,
    pub(super) sets: &'a [&'a Set],
    pub(super) file: Option<&'a str>,
    /// NaN where there is none yet: NaN is never a value.
    values: Vec<f64>,
    /// Lines of the values, for those from a file.
    lines: Vec<Option<u64>>,
}

impl<'a> Entries<'a> {
    /// A table without values; `len` is the number of its elements.
    pub(super) fn new(
        table: &'a str,
        sets: &'a [&'a Set],
        len: usize,
        file: Option<&'a str>,
    ) -> Self {
        let lines = vec![None; if file.is_some() { len } else { 0 }];
        Entries { table, sets, file, values: vec![f64::NAN; len], lines }
    }

    /// Sets the value of the element at a position.
    pub(super) fn put(
        &mut self,
        position: usize,
        value: f64,
        line: Option<u64>,
    ) -> Result<(), DataError> {
        if value.is_nan() {
            return Err(self.nan(position, line));
        }
        if !self.values[position].is_nan() {
            let (key, place) = (self.key(position), Place::of(self.file, line));
            let first = self.lines.get(position).copied().flatten();
            return Err(DataError::DuplicateKey { key, first, place });
        }
        self.values[position] = value;
        if let Some(first) = self.lines.get_mut(position) {
            *first = line;
        }
        Ok(())
    }

    /// The values of all elements.
    pub(super) fn finish(self) -> Result<Vec<f64>, DataError> {
        let Some(first) = self.values.iter().position(|value| value.is_nan()) else {
            return Ok(self.values);
        };
        let missing = self.values.iter().filter(|value| value.is_nan()).count();
        let (key, place) = (self.key(first), Place::of(self.file, None));
        Err(DataError::Missing { key, missing, expected: self.values.len(), place })
    }

    fn nan(&self, position: usize, line: Option<u64>) -> DataError {
        DataError::Nan { key: self.key(position), place: Place::of(self.file, line) }
    }

    fn key(&self, position: usize) -> String {
        element_name(self.table, self.sets, position)
    }
}
