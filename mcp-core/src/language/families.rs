//! What brackets read: [`Data`], [`Variables`], [`Definitions`], [`Parameters`], and the [`Rows`]
//! of equations, each over a tuple of index sets.

use super::ix::{Domain, Element, Maybe, Near};
use super::layout::{At, Elements, Filled, Layout};
use crate::model::{Asked, Reader};
use crate::scalar::{Real, Scalar};
use std::fmt;
use std::marker::PhantomData;

macro_rules! families {
    ($($(#[$about:meta])* $Family:ident<X $(, $L:ident)?>($Stored:ty $(= $Default:ty)?))*) => { $(
        $(#[$about])*
        pub struct $Family<X $(, $L = $Default)?>(
            #[doc(hidden)] pub $Stored,
            PhantomData<fn() -> X>,
        );

        impl<X $(, $L: Elements)?> $Family<X $(, $L)?> {
            /// Without elements.
            #[doc(hidden)]
            pub const EMPTY: Self = $Family(<$Stored>::EMPTY, PhantomData);
        }
        impl<X $(, $L: Clone)?> Clone for $Family<X $(, $L)?> {
            fn clone(&self) -> Self {
                $Family(self.0.clone(), PhantomData)
            }
        }
        impl<X $(, $L: fmt::Debug)?> fmt::Debug for $Family<X $(, $L)?> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.debug_tuple(stringify!($Family)).field(&self.0).finish()
            }
        }
    )* };
}

families! {
    /// Numbers given with the data, one for each combination: `cost[i, j]`.
    Data<X>(Filled)
    /// A variable family: `x[i, j]`.
    Variables<X, L>(L = Layout)
    /// A definition family: `cost[i]`, evaluated once per pass.
    Definitions<X>(Layout)
    /// A parameter family: `tax[i]`, and its value in the data, `tax.base(i)`.
    Parameters<X>(Filled)
    /// An equation family: which of its combinations have a row.
    Rows<X, L>(L = Layout)
}

impl<X> Data<X> {
    /// Sum of all values, from the first to the last.
    pub fn sum(&self) -> f64 {
        crate::scalar::sum(self.0.values(), |&value| value)
    }
    /// All values in order.
    pub fn values(&self) -> &[f64] {
        self.0.values()
    }
}

/// Numbers of combinations of the sets `X`.
struct Position<X>(PhantomData<X>);

/// Reading by index, for each number of index sets.
macro_rules! reading {
    ($($S:ident $i:ident $k:tt),*) => {
        impl<$($S: Domain),*> Position<($($S,)*)> {
            /// Number of a combination in dense order.
            #[inline]
            fn dense(layout: &Layout, $($i: impl Element<$S>),*) -> usize {
                let (dense, _) = (0, layout);
                $(
                    let position = $i.position_in();
                    debug_assert!(position < layout.lengths[$k], "an index of another model");
                    let dense = dense * layout.lengths[$k] + position;
                )*
                dense
            }
            /// Number of a combination in dense order, if all its indices exist.
            #[inline]
            fn near(layout: &Layout, $($i: impl Near<$S>),*) -> Option<usize> {
                let (dense, _) = (0, layout);
                $(
                    let position = usize::try_from($i.position_near()).ok()?;
                    if position >= layout.lengths[$k] {
                        return None;
                    }
                    let dense = dense * layout.lengths[$k] + position;
                )*
                Some(dense)
            }
        }
        impl<$($S: Domain),*> Data<($($S,)*)> {
            /// One value.
            #[doc(hidden)]
            #[inline]
            pub fn get(&self, $($i: impl Element<$S>),*) -> f64 {
                self.0.values()[Position::<($($S,)*)>::dense(&self.0.layout, $($i),*)]
            }
            /// The value at indices that may not exist.
            #[inline]
            pub fn at(&self, $($i: impl Near<$S>),*) -> Maybe<f64> {
                Maybe(Position::<($($S,)*)>::near(&self.0.layout, $($i),*).map(|dense| self.0.values()[dense]))
            }
        }
        #[allow(clippy::too_many_arguments, reason = "one for each index set")]
        impl<$($S: Domain,)* L: Elements> Variables<($($S,)*), L> {
            /// One variable.
            #[doc(hidden)]
            #[inline]
            pub fn get<D: Scalar>(&self, read: &Reader<'_, D>, $($i: impl Element<$S>),*) -> Real<D> {
                self.0.variable(read, Position::<($($S,)*)>::dense(self.0.layout(), $($i),*))
            }
            /// A variable at indices that may not exist. Inside `mcp!` it is called without `read`:
            /// `stock.at(t - 1).or(0.0)`.
            #[inline]
            pub fn at<D: Scalar>(&self, read: &Reader<'_, D>, $($i: impl Near<$S>),*) -> Maybe<Real<D>> {
                let place = Position::<($($S,)*)>::near(self.0.layout(), $($i),*).and_then(|dense| self.0.place(dense));
                Maybe(place.map(|place| read.row(Asked::Variable, self.0.layout().offset + place)))
            }
            /// Place of an element in the family, if it has one.
            #[doc(hidden)]
            pub fn place(&self, $($i: impl Element<$S>),*) -> Option<usize> {
                self.0.place(Position::<($($S,)*)>::dense(self.0.layout(), $($i),*))
            }
        }
        #[allow(clippy::too_many_arguments, reason = "one for each index set")]
        impl<$($S: Domain),*> Definitions<($($S,)*)> {
            /// One definition.
            #[doc(hidden)]
            #[inline]
            pub fn get<D: Scalar>(&self, read: &Reader<'_, D>, $($i: impl Element<$S>),*) -> Real<D> {
                read.row(Asked::Definition, self.0.offset + Position::<($($S,)*)>::dense(&self.0, $($i),*))
            }
            /// A definition that may not exist.
            #[inline]
            pub fn at<D: Scalar>(&self, read: &Reader<'_, D>, $($i: impl Near<$S>),*) -> Maybe<Real<D>> {
                Maybe(Position::<($($S,)*)>::near(&self.0, $($i),*).map(|dense| read.row(Asked::Definition, self.0.offset + dense)))
            }
            /// Place of a definition in the family.
            #[doc(hidden)]
            pub fn place(&self, $($i: impl Element<$S>),*) -> Option<usize> {
                Some(Position::<($($S,)*)>::dense(&self.0, $($i),*))
            }
            /// The positions of a definition's indices in their sets.
            #[doc(hidden)]
            #[inline]
            pub fn split(&self, row: usize) -> At {
                self.0.split(row)
            }
        }
        #[allow(clippy::too_many_arguments, reason = "one for each index set")]
        impl<$($S: Domain),*> Parameters<($($S,)*)> {
            /// One parameter.
            #[doc(hidden)]
            #[inline]
            pub fn get<D: Scalar>(&self, read: &Reader<'_, D>, $($i: impl Element<$S>),*) -> Real<D> {
                read.row(Asked::Parameter, self.0.layout.offset + Position::<($($S,)*)>::dense(&self.0.layout, $($i),*))
            }
            /// A parameter that may not exist.
            #[inline]
            pub fn at<D: Scalar>(&self, read: &Reader<'_, D>, $($i: impl Near<$S>),*) -> Maybe<Real<D>> {
                let dense = Position::<($($S,)*)>::near(&self.0.layout, $($i),*);
                Maybe(dense.map(|dense| read.row(Asked::Parameter, self.0.layout.offset + dense)))
            }
            /// Its value in the data: a plain number, which no later change of the parameter moves.
            #[inline]
            pub fn base(&self, $($i: impl Element<$S>),*) -> f64 {
                self.0.values()[Position::<($($S,)*)>::dense(&self.0.layout, $($i),*)]
            }
        }
        #[allow(clippy::too_many_arguments, reason = "one for each index set")]
        impl<$($S: Domain,)* L: Elements> Rows<($($S,)*), L> {
            /// Place of a row in the family, if it has one.
            #[doc(hidden)]
            pub fn place(&self, $($i: impl Element<$S>),*) -> Option<usize> {
                self.0.place(Position::<($($S,)*)>::dense(self.0.layout(), $($i),*))
            }
            /// The positions of a row's indices in their sets.
            #[doc(hidden)]
            #[inline]
            pub fn split(&self, row: usize) -> At {
                self.0.split(row)
            }
        }
    };
}

// One invocation for each rank, so that an error message that shows it stays short.
reading!();
reading!(A a 0);
reading!(A a 0, B b 1);
reading!(A a 0, B b 1, C c 2);
reading!(A a 0, B b 1, C c 2, E e 3);
reading!(A a 0, B b 1, C c 2, E e 3, F f 4);
reading!(A a 0, B b 1, C c 2, E e 3, F f 4, G g 5);

#[cfg(test)]
#[path = "families_tests.rs"]
mod tests;
