//! What the solvers keep between calls: pattern, dense columns, scratch memory.

use std::fmt;

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};

use super::LinearError;
use crate::problem::Pattern;

/// The pattern of the last analysis.
#[derive(Clone, Debug, Default)]
pub(super) struct KeptPattern(Option<Pattern>);

impl KeptPattern {
    /// Whether the pattern is the one kept, which needs no new analysis.
    pub(super) fn is(&self, pattern: &Pattern) -> bool {
        self.0.as_ref() == Some(pattern)
    }

    /// Keeps the pattern from now on.
    pub(super) fn keep(&mut self, pattern: &Pattern) {
        self.0 = Some(pattern.clone());
    }

    /// Forgets the pattern.
    pub(super) fn forget(&mut self) {
        self.0 = None;
    }

    /// The pattern kept.
    ///
    /// # Panics
    /// Before the first analysis: a factorisation then is an error of the program.
    pub(super) fn get(&self) -> &Pattern {
        self.0.as_ref().expect("`analyse` comes before `factor`")
    }
}

/// Writes the values of column `j` of the pattern into the column of a dense matrix.
pub(super) fn scatter_column(pattern: &Pattern, values: &[f64], j: usize, column: &mut [f64]) {
    let range = pattern.column(j);
    let values = &values[range.clone()];
    if values.len() == column.len() {
        column.copy_from_slice(values);
    } else {
        column.fill(0.0);
        for (i, &value) in pattern.column_rows(j).zip(values) {
            column[i] = value;
        }
    }
}

/// `len` copies of `value`, or [`LinearError::OutOfMemory`].
pub(super) fn try_filled<T: Clone>(value: T, len: usize, n: usize) -> Result<Vec<T>, LinearError> {
    let mut filled = Vec::new();
    filled.try_reserve_exact(len).map_err(|_| LinearError::OutOfMemory { n })?;
    filled.resize(len, value);
    Ok(filled)
}

/// Scratch memory of faer's algorithms.
pub(super) struct Scratch(MemBuffer);

impl Scratch {
    /// No memory.
    pub(super) fn empty() -> Self {
        Scratch(MemBuffer::new(StackReq::EMPTY))
    }

    /// Memory for a request, or [`LinearError::OutOfMemory`].
    pub(super) fn try_new(request: StackReq, n: usize) -> Result<Self, LinearError> {
        MemBuffer::try_new(request).map(Scratch).map_err(|_| LinearError::OutOfMemory { n })
    }

    /// All of it, for one call of an algorithm.
    pub(super) fn stack(&mut self) -> &mut MemStack {
        MemStack::new(&mut self.0)
    }
}

impl Default for Scratch {
    fn default() -> Self {
        Scratch::empty()
    }
}

impl fmt::Debug for Scratch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Scratch").field(&self.0.len()).finish()
    }
}
