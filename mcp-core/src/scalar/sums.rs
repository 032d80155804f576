//! Sums, products and data conditions over anything that can be totalled: data or [`Real`].

use super::{Real, Scalar};
use std::ops::{Add, Mul};

/// What [`sum`], [`prod`] and [`when`] can result in: `f64`, integers or [`Real`].
pub trait Total: Copy + Add<Output = Self> + Mul<Output = Self> {
    /// The empty sum.
    fn zero() -> Self;
    /// The empty product.
    fn one() -> Self;
    /// `self + term`, in place.
    #[doc(hidden)]
    #[inline]
    fn accumulate(&mut self, term: Self) {
        *self = *self + term;
    }
}

macro_rules! total {
    ($($number:ty: $zero:literal $one:literal),*) => {$(
        impl Total for $number {
            #[inline]
            fn zero() -> Self { $zero }
            #[inline]
            fn one() -> Self { $one }
        }
    )*};
}

total!(f64: 0.0 1.0, i32: 0 1, i64: 0 1, u32: 0 1, u64: 0 1, usize: 0 1);

impl<D: Scalar> Total for Real<D> {
    #[inline]
    fn zero() -> Self {
        Real(D::constant(0.0))
    }
    #[inline]
    fn one() -> Self {
        Real(D::constant(1.0))
    }
    #[inline]
    fn accumulate(&mut self, term: Self) {
        self.0.accumulate(term.0);
    }
}

/// `Σ term(i)` over a set, from the first to the last; 0 if it is empty.
///
/// ```
/// use mcp_core::{Real, sum};
/// let q = [1.0, 2.0].map(Real::<f64>::from);
/// assert_eq!(sum(q, |q| 2.0 * q).into_scalar(), 6.0);
/// assert_eq!(sum(0..4, |i| i), 6);
/// ```
#[inline]
pub fn sum<T: Total, I: IntoIterator>(set: I, mut term: impl FnMut(I::Item) -> T) -> T {
    let mut terms = set.into_iter();
    let Some(first) = terms.next() else {
        return T::zero();
    };
    let mut total = term(first);
    for i in terms {
        total.accumulate(term(i));
    }
    total
}

/// `Π factor(i)` over a set, from the first to the last; 1 if it is empty.
#[inline]
pub fn prod<T: Total, I: IntoIterator>(set: I, mut factor: impl FnMut(I::Item) -> T) -> T {
    let mut factors = set.into_iter();
    let Some(first) = factors.next() else {
        return T::one();
    };
    let mut total = factor(first);
    for i in factors {
        total = total * factor(i);
    }
    total
}

/// The expression where a condition on data holds, 0 elsewhere (GAMS's `$`).
///
/// ```
/// use mcp_core::{Real, when};
/// let x = Real::<f64>::from(3.0);
/// assert_eq!(when(false, || x.ln()).into_scalar(), 0.0);
/// ```
#[inline]
pub fn when<T: Total>(condition: bool, expression: impl FnOnce() -> T) -> T {
    if condition { expression() } else { T::zero() }
}
