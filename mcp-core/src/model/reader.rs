//! [`Reader`]: how a row gets at variables, definitions and parameters.

use crate::scalar::{Real, Scalar, Tape, Taped};
use std::array::from_fn;
use std::cell::{Cell, RefCell};
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
    Local(&'a Local<'a>),
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

/// The slot of a number that carries no tangent.
pub(crate) const NO_LANE: u32 = u32::MAX;

/// Plain numbers that get their tangent in the moment they are read.
#[derive(Debug)]
pub(crate) struct Local<'a> {
    pub(crate) point: Point<'a>,
    pub(crate) slots: Slots<'a>,
    /// The first of the lanes that are carried.
    pub(crate) first_lane: Cell<u32>,
}

/// Plain numbers that get their node of a tape in the moment they are read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OnTape<'t> {
    pub(crate) local: &'t Local<'t>,
    pub(crate) tape: &'t Tape,
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
    pub(crate) variables: &'a [Cell<u32>],
    pub(crate) definitions: &'a [Cell<u32>],
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

    pub(crate) fn local(local: &'a Local<'a>) -> Self {
        Reader { point: Point::EMPTY, source: Source::Local(local) }
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
            Source::Local(local) => local.var(j),
            Source::Other(give) => give.var(j),
        }
    }

    /// Definition number `k` among all definitions.
    #[inline]
    pub fn def(&self, k: usize) -> Real<D> {
        match &self.source {
            Source::Lanes { definitions, .. } => definitions[k],
            Source::Plain => Real(D::constant(self.point.definitions[k])),
            Source::Local(local) => local.def(k),
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
            Source::Local(local) => local.param(k),
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
            return Real(D::constant(value));
        }
        match what {
            Asked::Variable => self.variable(k),
            Asked::Definition => self.definition(k),
            Asked::Parameter => self.parameter(k),
        }
    }
    #[inline(never)]
    pub(crate) fn variable(&self, j: usize) -> Real<D> {
        match &self.source {
            Source::Local(local) => local.var(j),
            _ => self.var(j),
        }
    }
    #[inline(never)]
    pub(crate) fn definition(&self, k: usize) -> Real<D> {
        match &self.source {
            Source::Local(local) => local.def(k),
            _ => self.def(k),
        }
    }
    #[inline(never)]
    pub(crate) fn parameter(&self, k: usize) -> Real<D> {
        self.param(k)
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

impl Local<'_> {
    #[inline]
    fn var<D: Scalar>(&self, j: usize) -> Real<D> {
        self.seed(self.point.z[j], &self.slots.variables[j])
    }
    #[inline]
    fn def<D: Scalar>(&self, k: usize) -> Real<D> {
        self.seed(self.point.definitions[k], &self.slots.definitions[k])
    }
    #[inline]
    fn param<D: Scalar>(&self, k: usize) -> Real<D> {
        Real(D::constant(self.point.parameters[k]))
    }
    #[inline]
    fn seed<D: Scalar>(&self, value: f64, slot: &Cell<u32>) -> Real<D> {
        // A slot below the chunk wraps to a huge lane, which carries no tangent.
        Real(D::seed(value, slot.get().wrapping_sub(self.first_lane.get()) as usize))
    }
}

impl<'t> Give<Taped<'t>> for OnTape<'t> {
    fn var(&self, j: usize) -> Real<Taped<'t>> {
        self.read(self.local.point.z[j], &self.local.slots.variables[j])
    }
    fn def(&self, k: usize) -> Real<Taped<'t>> {
        self.read(self.local.point.definitions[k], &self.local.slots.definitions[k])
    }
    fn param(&self, k: usize) -> Real<Taped<'t>> {
        Real(Taped::constant(self.local.point.parameters[k]))
    }
}

impl<'t> OnTape<'t> {
    #[inline]
    fn read(&self, value: f64, slot: &Cell<u32>) -> Real<Taped<'t>> {
        Real(match slot.get() {
            NO_LANE => Taped::constant(value),
            lane => self.tape.read(value, lane),
        })
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

/// NaN for a number that does not exist: the recorder reports it by name.
fn recorded<D: Scalar>(values: &[f64], k: usize) -> Real<D> {
    Real(D::seed(values.get(k).copied().unwrap_or(f64::NAN), 0))
}
