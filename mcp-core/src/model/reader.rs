//! [`Reader`]: how a row gets at variables, definitions and parameters.

use crate::scalar::{Real, Scalar};
use std::array::from_fn;
use std::cell::RefCell;

/// Gives a row the numbers it asks for, in the engine's arithmetic.
///
/// What stands behind it differs: whole vectors already in that arithmetic, plain numbers that get
/// their tangent in the moment they are read (only variables the row reads carry lanes), or a
/// recorder that finds the pattern. A row never sees which.
#[derive(Debug)]
pub struct Reader<'a, D: Scalar> {
    source: Source<'a, D>,
}

#[derive(Debug)]
enum Source<'a, D: Scalar> {
    Lanes { z: &'a [Real<D>], definitions: &'a [Real<D>], parameters: &'a [Real<D>] },
    Plain { point: Point<'a> },
    Local { point: Point<'a>, slots: Slots<'a>, first_lane: u32 },
    Recording { point: Point<'a>, reads: &'a RefCell<Reads> },
}

/// Plain values of everything a row can read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point<'a> {
    pub(crate) z: &'a [f64],
    pub(crate) definitions: &'a [f64],
    pub(crate) parameters: &'a [f64],
}

/// For the row at hand: the lane of every variable and definition it reads.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slots<'a> {
    pub(crate) variables: &'a [u32],
    pub(crate) definitions: &'a [u32],
}

/// What a row read, in the order of its first reads, with repetitions.
#[derive(Debug, Default)]
pub(crate) struct Reads {
    pub(crate) variables: Vec<usize>,
    pub(crate) definitions: Vec<usize>,
    pub(crate) parameters: Vec<usize>,
}

impl<'a, D: Scalar> Reader<'a, D> {
    pub(crate) fn lanes(
        z: &'a [Real<D>],
        definitions: &'a [Real<D>],
        parameters: &'a [Real<D>],
    ) -> Self {
        Reader { source: Source::Lanes { z, definitions, parameters } }
    }

    pub(crate) fn plain(point: Point<'a>) -> Self {
        Reader { source: Source::Plain { point } }
    }

    pub(crate) fn local(point: Point<'a>, slots: Slots<'a>, first_lane: u32) -> Self {
        Reader { source: Source::Local { point, slots, first_lane } }
    }

    pub(crate) fn recording(point: Point<'a>, reads: &'a RefCell<Reads>) -> Self {
        Reader { source: Source::Recording { point, reads } }
    }

    /// Variable number `j` among all variables.
    #[inline]
    pub fn var(&self, j: usize) -> Real<D> {
        match &self.source {
            Source::Lanes { z, .. } => z[j],
            Source::Plain { point } => Real(D::constant(point.z[j])),
            Source::Local { point, slots, first_lane } => {
                seed(point.z[j], slots.variables[j], *first_lane)
            }
            Source::Recording { point, reads } => {
                reads.borrow_mut().variables.push(j);
                recorded(point.z, j)
            }
        }
    }

    /// Definition number `k` among all definitions.
    #[inline]
    pub fn def(&self, k: usize) -> Real<D> {
        match &self.source {
            Source::Lanes { definitions, .. } => definitions[k],
            Source::Plain { point } => Real(D::constant(point.definitions[k])),
            Source::Local { point, slots, first_lane } => {
                seed(point.definitions[k], slots.definitions[k], *first_lane)
            }
            Source::Recording { point, reads } => {
                reads.borrow_mut().definitions.push(k);
                recorded(point.definitions, k)
            }
        }
    }

    /// Parameter number `k` among all parameters: a constant, unless derivatives by parameters are
    /// asked for.
    #[inline]
    pub fn param(&self, k: usize) -> Real<D> {
        match &self.source {
            Source::Lanes { parameters, .. } => parameters[k],
            Source::Plain { point } | Source::Local { point, .. } => {
                Real(D::constant(point.parameters[k]))
            }
            Source::Recording { point, reads } => {
                reads.borrow_mut().parameters.push(k);
                recorded(point.parameters, k)
            }
        }
    }

    /// The first `N` variables at once.
    #[inline]
    pub fn first<const N: usize>(&self) -> [Real<D>; N] {
        match &self.source {
            Source::Lanes { z, .. } if z.len() >= N => from_fn(|j| z[j]),
            Source::Plain { point } if point.z.len() >= N => {
                from_fn(|j| Real(D::constant(point.z[j])))
            }
            _ => from_fn(|j| self.var(j)),
        }
    }
}

#[inline]
fn seed<D: Scalar>(value: f64, slot: u32, first_lane: u32) -> Real<D> {
    // A slot below the chunk wraps to a huge lane, which carries no tangent.
    Real(D::seed(value, slot.wrapping_sub(first_lane) as usize))
}

/// NaN for a number that does not exist: the recorder reports it by name.
fn recorded<D: Scalar>(values: &[f64], k: usize) -> Real<D> {
    Real(D::seed(values.get(k).copied().unwrap_or(f64::NAN), 0))
}
