//! What a user writes: `F` as families of rows, and its [`Shape`].
//!
//! A mixed complementarity problem is: find `z` with `l <= z <= u` such that for every `i`
//!
//! ```text
//! F_i(z) >= 0  if z_i = l_i
//! F_i(z)  = 0  if l_i < z_i < u_i          (always, if z_i is free)
//! F_i(z) <= 0  if z_i = u_i
//! ```
//!
//! This is the sign convention of PATH, GAMS and JuMP. CompEcon and Miranda & Fackler use the
//! opposite one. Economists write `cost - price ⟂ quantity` and `supply - demand ⟂ price`.
//!
//! Write `F` in the language, [`mcp!`](macro@crate::mcp), or as a function of fixed size with
//! [`#[mcp_fn]`](macro@crate::mcp_fn); [`Model`] can also be implemented by hand.

mod bounds;
mod builder;
mod by_name;
mod family;
mod pairing;
mod parts;
mod quantity;
mod reader;
mod set;
mod shape;
mod transfer;

pub use bounds::{BoundKind, Bounds};
pub use builder::{Definition, Equation, Parameter, ShapeBuilder, Variable};
pub use family::{Block, Family, Values};
pub(crate) use family::{MOST_ELEMENTS, combinations};
pub(crate) use parts::Part;
pub(crate) use quantity::Quantity;
pub use reader::Reader;
pub(crate) use reader::{Asked, Give, Local, NO_LANE, OnTape, Point, Reads, Recorder, Slots};
pub use set::Set;
pub use shape::{Row, Shape};

use crate::scalar::{Real, Scalar};

/// A mixed complementarity problem whose `F` is written once, over any [`Scalar`].
///
/// `F` comes as **families of rows**: [`row`](Self::row) computes one equation from what it reads,
/// which is how the pattern is found, how a row carries only the lanes of its own variables, and
/// how an equation is named in a report.
///
/// ```
/// use mcp_core::{Equation, Model, ModelError, Options, Reader, Real, Scalar, Shape, Variable};
///
/// /// Two firms: `marginal cost − marginal revenue ⟂ quantity`.
/// struct Duopoly(Shape);
///
/// impl Model for Duopoly {
///     fn shape(&self) -> &Shape {
///         &self.0
///     }
///     fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
///         let (own, other) = (read.var(i), read.var(1 - i));
///         1.0 - (10.0 - other - 2.0 * own)
///     }
/// }
///
/// let firms = mcp_core::Set::new("firms", ["a", "b"])?;
/// let shape = Shape::builder()
///     .variable(Variable::new("q").over(&[&firms]).lower(0.0))
///     .equation(Equation::new("profit").over(&[&firms]).complements("q"))
///     .build()?;
/// let solution = mcp_core::solve(&Duopoly(shape), &Options::default())?;
/// assert!(solution.is_solved());
/// assert!((solution.z[0] - 3.0).abs() < 1e-9);
/// # Ok::<(), ModelError>(())
/// ```
pub trait Model {
    /// `Some(n)` if all `n` rows come from one function of fixed size, so that
    /// [`whole`](Self::whole) is called instead of [`row`](Self::row).
    const WHOLE: Option<usize> = None;

    /// Families, names, bounds, starts, pairs.
    fn shape(&self) -> &Shape;

    /// `F` of one equation: element `index` of the equation family with the
    /// [entry](Family::entry) `family`, both counted from 0 in the order of declaration. A point
    /// outside the domain of `F` shows itself as a NaN.
    fn row<D: Scalar>(&self, family: usize, index: usize, read: &Reader<'_, D>) -> Real<D>;

    /// One definition: a sub-expression that rows and later definitions read with
    /// [`Reader::def`]. Evaluated once per pass however often it is read. Only called for models
    /// whose shape declares definitions; the default is NaN, which a solve reports as a domain
    /// error of the equations that read it.
    fn def<D: Scalar>(&self, _family: usize, _index: usize, _read: &Reader<'_, D>) -> Real<D> {
        Real::from(f64::NAN)
    }

    /// One report: a number that people want to see, evaluated at a solution. Only called for models
    /// whose shape declares reports; the default is NaN.
    fn report(&self, _family: usize, _index: usize, _read: &Reader<'_, f64>) -> Real<f64> {
        Real::from(f64::NAN)
    }

    /// All rows at once, in the order of declaration. Override it together with
    /// [`WHOLE`](Self::WHOLE).
    fn whole<D: Scalar>(&self, read: &Reader<'_, D>, f: &mut [Real<D>]) {
        for (row, f) in f.iter_mut().enumerate() {
            let Row { family, index } = self.shape().row(row);
            *f = self.row(family, index, read);
        }
    }
}

impl<M: Model> Model for &M {
    const WHOLE: Option<usize> = M::WHOLE;

    fn shape(&self) -> &Shape {
        (**self).shape()
    }
    #[inline]
    fn row<D: Scalar>(&self, family: usize, index: usize, read: &Reader<'_, D>) -> Real<D> {
        (**self).row(family, index, read)
    }
    #[inline]
    fn def<D: Scalar>(&self, family: usize, index: usize, read: &Reader<'_, D>) -> Real<D> {
        (**self).def(family, index, read)
    }
    fn report(&self, family: usize, index: usize, read: &Reader<'_, f64>) -> Real<f64> {
        (**self).report(family, index, read)
    }
    #[inline]
    fn whole<D: Scalar>(&self, read: &Reader<'_, D>, f: &mut [Real<D>]) {
        (**self).whole(read, f);
    }
}
