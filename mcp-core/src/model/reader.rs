//! [`Reader`]: how a row gets at variables, definitions and parameters.

use crate::scalar::{Real, Scalar};
use std::array::from_fn;
use std::cell::RefCell;
use std::fmt;

/// Gives a row the numbers it asks for, in the engine's arithmetic.
///
/// What stands behind it differs: whole vectors already in that arithmetic, plain numbers that get
/// their tangent in the moment they are read (only variables the row reads carry lanes), or a
/// recorder that finds the pattern. A row never sees which.
pub struct Reader<'a, D: Scalar> {
    /// Of the source, if that is plain, and else empty.
    point: Point<'a>,
    source: Source<'a, D>,
}

enum Source<'a, D: Scalar> {
    Lanes {
        z: &'a [Real<D>],
        definitions: &'a [Real<D>],
        parameters: &'a [Real<D>],
    },
    Plain,
    /// Behind a pointer, so that a row of the user's is not compiled together with it.
    Other(&'a dyn Give<D>),
}

/// Where numbers come from that are made while they are read.
pub(crate) trait Give<D: Scalar> {
    fn var(&self, j: usize) -> Real<D>;
    fn def(&self, k: usize) -> Real<D>;
    fn param(&self, k: usize) -> Real<D>;
}

impl<D: Scalar> fmt::Debug for Reader<'_, D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Reader").finish_non_exhaustive()
    }
}

/// Plain values of everything a row can read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point<'a> {
    pub(crate) z: &'a [f64],
    pub(crate) definitions: &'a [f64],
    pub(crate) parameters: &'a [f64],
}

/// What a row asks for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Asked {
    Variable,
    Definition,
    Parameter,
}

impl<'a> Point<'a> {
    /// Without numbers.
    const EMPTY: Self = Point { z: &[], definitions: &[], parameters: &[] };

    #[inline]
    fn of(&self, what: Asked) -> &'a [f64] {
        match what {
            Asked::Variable => self.z,
            Asked::Definition => self.definitions,
            Asked::Parameter => self.parameters,
        }
    }
}

/// Plain numbers that get their tangent in the moment they are read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Local<'a> {
    pub(crate) point: Point<'a>,
    pub(crate) slots: Slots<'a>,
    /// The first of the lanes that are carried.
    pub(crate) first_lane: u32,
}

/// Plain numbers, and a note of everything that is read.
#[derive(Debug)]
pub(crate) struct Recorder<'a> {
    pub(crate) point: Point<'a>,
    pub(crate) reads: RefCell<Reads>,
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

impl Reads {
    /// Forgets everything; the memory stays.
    pub(crate) fn clear(&mut self) {
        for list in [&mut self.variables, &mut self.definitions, &mut self.parameters] {
            list.clear();
        }
    }
}

impl<'a, D: Scalar> Reader<'a, D> {
    pub(crate) fn lanes(
        z: &'a [Real<D>],
        definitions: &'a [Real<D>],
        parameters: &'a [Real<D>],
    ) -> Self {
        Reader { point: Point::EMPTY, source: Source::Lanes { z, definitions, parameters } }
    }

    pub(crate) fn plain(point: Point<'a>) -> Self {
        Reader { point, source: Source::Plain }
    }

    pub(crate) fn other(give: &'a dyn Give<D>) -> Self {
        Reader { point: Point::EMPTY, source: Source::Other(give) }
    }

    /// Variable number `j` among all variables.
    #[inline]
    pub fn var(&self, j: usize) -> Real<D> {
        match &self.source {
            Source::Lanes { z, .. } => z[j],
            Source::Plain => Real(D::constant(self.point.z[j])),
            Source::Other(give) => give.var(j),
        }
    }

    /// Definition number `k` among all definitions.
    #[inline]
    pub fn def(&self, k: usize) -> Real<D> {
        match &self.source {
            Source::Lanes { definitions, .. } => definitions[k],
            Source::Plain => Real(D::constant(self.point.definitions[k])),
            Source::Other(give) => give.def(k),
        }
    }

    /// Parameter number `k` among all parameters: a constant, unless derivatives by parameters are
    /// asked for.
    #[inline]
    pub fn param(&self, k: usize) -> Real<D> {
        match &self.source {
            Source::Lanes { parameters, .. } => parameters[k],
            Source::Plain => Real(D::constant(self.point.parameters[k])),
            Source::Other(give) => give.param(k),
        }
    }

    /// A number for rows of `mcp!`: by a call unless it is a plain number of a point, because every
    /// place that reads one would otherwise be compiled with all sources.
    #[inline]
    pub(crate) fn row(&self, what: Asked, k: usize) -> Real<D> {
        if const { D::LANES == 0 }
            && let Some(&value) = self.point.of(what).get(k)
        {
            Real(D::constant(value))
        } else {
            self.apart(what, k)
        }
    }
    #[inline(never)]
    pub(crate) fn apart(&self, what: Asked, k: usize) -> Real<D> {
        match what {
            Asked::Variable => self.var(k),
            Asked::Definition => self.def(k),
            Asked::Parameter => self.param(k),
        }
    }

    /// The first `N` variables at once.
    #[inline]
    pub fn first<const N: usize>(&self) -> [Real<D>; N] {
        match &self.source {
            Source::Lanes { z, .. } if z.len() >= N => from_fn(|j| z[j]),
            Source::Plain if self.point.z.len() >= N => {
                from_fn(|j| Real(D::constant(self.point.z[j])))
            }
            _ => from_fn(|j| self.var(j)),
        }
    }
}

impl<D: Scalar> Give<D> for Local<'_> {
    fn var(&self, j: usize) -> Real<D> {
        seed(self.point.z[j], self.slots.variables[j], self.first_lane)
    }
    fn def(&self, k: usize) -> Real<D> {
        seed(self.point.definitions[k], self.slots.definitions[k], self.first_lane)
    }
    fn param(&self, k: usize) -> Real<D> {
        Real(D::constant(self.point.parameters[k]))
    }
}

impl<D: Scalar> Give<D> for Recorder<'_> {
    fn var(&self, j: usize) -> Real<D> {
        self.reads.borrow_mut().variables.push(j);
        recorded(self.point.z, j)
    }
    fn def(&self, k: usize) -> Real<D> {
        self.reads.borrow_mut().definitions.push(k);
        recorded(self.point.definitions, k)
    }
    fn param(&self, k: usize) -> Real<D> {
        self.reads.borrow_mut().parameters.push(k);
        recorded(self.point.parameters, k)
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
