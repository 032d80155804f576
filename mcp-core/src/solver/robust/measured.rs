//! Where scales are measured: a point with `F` and `J`, and the graph of what is known there.

use super::equilibrate::{NEGLIGIBLE, NONE, exponent};
use crate::model::Bounds;
use crate::problem::Pattern;

/// How much the size of a known variable counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::solver) enum Sizes {
    /// As one entry of `J`.
    #[default]
    AsOneEntry,
    /// As all entries of `J` in its column together.
    AsAllEntries,
}

/// A point with finite `F` and `J`, in the units of the model.
#[derive(Clone, Copy)]
pub(in crate::solver) struct Sample<'a> {
    pub(in crate::solver) z: &'a [f64],
    pub(in crate::solver) f: &'a [f64],
    pub(in crate::solver) jac: &'a [f64],
    /// The start of the solve.
    pub(in crate::solver) start: &'a [f64],
    pub(in crate::solver) sizes: Sizes,
}

impl Sample<'_> {
    /// Which `z_j` are known: not 0, not 0 at the start, and with a term `J_ij z_j` that matters
    /// beside `F_i` and the largest term of some equation. `largest` is working memory.
    pub(super) fn mark_known(
        &self,
        pattern: &Pattern,
        bounds: &Bounds,
        largest: &mut [i32],
        known: &mut [bool],
    ) {
        for (largest, &f) in largest.iter_mut().zip(self.f) {
            *largest = if f == 0.0 { NONE } else { exponent(f) };
        }
        let terms = || {
            let entries = pattern.entries();
            let nonzero = entries.filter(|&(k, _, j)| self.jac[k] != 0.0 && self.z[j] != 0.0);
            nonzero.map(|(k, i, j)| (i, j, exponent(self.jac[k]) + exponent(self.z[j])))
        };
        for (i, _, e) in terms() {
            largest[i] = largest[i].max(e);
        }
        known.fill(false);
        for (i, j, e) in terms() {
            let is_live = bounds.lower()[i] < bounds.upper()[i];
            known[j] |= is_live && self.start[j] != 0.0 && e >= largest[i] + NEGLIGIBLE;
        }
    }
}

/// A sample of a problem, and which `z_j` are known.
#[derive(Clone, Copy)]
pub(super) struct Measured<'a> {
    pub(super) pattern: &'a Pattern,
    pub(super) bounds: &'a Bounds,
    pub(super) sample: Sample<'a>,
    pub(super) known: &'a [bool],
}

impl Measured<'_> {
    pub(super) fn is_fixed(&self, j: usize) -> bool {
        self.bounds.lower()[j] >= self.bounds.upper()[j]
    }

    /// The graph: an edge `(node of a row, node of a column, exponent)` for each nonzero outside the
    /// rows and columns of fixed variables. What is known of `z` is one more row, with the entries
    /// `1 / z_j`; if nothing is, `F` is one more column.
    pub(super) fn edges(&self) -> impl Iterator<Item = (usize, usize, i32)> + '_ {
        let Sample { z, f, jac, .. } = self.sample;
        let n = z.len();
        let live = move |&j: &usize| !self.is_fixed(j);
        let sizes = (0..n)
            .filter(move |j| live(j) && self.known[*j])
            .map(move |j| (2 * n, n + j, -exponent(z[j])));
        let nothing_is_known = !(0..n).any(|j| live(&j) && self.known[j]);
        let residual = (0..n)
            .filter(move |i| nothing_is_known && live(i) && f[*i] != 0.0)
            .map(move |i| (i, 2 * n + 1, exponent(f[i])));
        let entries = self
            .pattern
            .entries()
            .filter(move |(k, i, j)| jac[*k] != 0.0 && live(i) && live(j))
            .map(move |(k, i, j)| (i, n + j, exponent(jac[k])));
        sizes.chain(residual).chain(entries)
    }
}
