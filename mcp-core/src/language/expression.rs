//! [`Expression`]: what rows compute.

use crate::scalar::{Real, Scalar};

/// What an equation, a definition or a report may be.
#[diagnostic::on_unimplemented(
    message = "expected a number, found `{Self}`",
    label = "not a number",
    note = "an equation, a definition or a report is one number: an expression of variables and data"
)]
pub trait Expression<D: Scalar> {
    /// The number in the engine's arithmetic.
    fn real(self) -> Real<D>;
}

macro_rules! expression {
    ($($T:ty),*) => { $(
        #[diagnostic::do_not_recommend]
        impl<D: Scalar> Expression<D> for $T {
            #[inline]
            fn real(self) -> Real<D> {
                Real::from(self)
            }
        }
    )* };
}

expression!(f64, &f64, i32);

/// Counts and positions.
#[diagnostic::do_not_recommend]
impl<D: Scalar> Expression<D> for usize {
    #[inline]
    fn real(self) -> Real<D> {
        Real::from(self as f64)
    }
}

#[diagnostic::do_not_recommend]
impl<D: Scalar> Expression<D> for Real<D> {
    #[inline]
    fn real(self) -> Real<D> {
        self
    }
}

/// The value of an expression.
#[inline]
pub fn expression<D: Scalar>(value: impl Expression<D>) -> Real<D> {
    value.real()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_number_is_an_expression() {
        let value = |number: Real<f64>| number.into_scalar();
        assert_eq!(value(expression(1.5)), 1.5);
        let shared = &1.5;
        assert_eq!(value(expression(shared)), 1.5);
        assert_eq!(value(expression(-3)), -3.0);
        assert_eq!(value(expression(7_usize)), 7.0);
        assert_eq!(value(expression(Real::from(2.0))), 2.0);
    }
}
