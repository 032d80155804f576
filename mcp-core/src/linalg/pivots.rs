//! The checks every factorisation makes: finite values, usable pivots.

use super::{FactorInfo, LinearError};

/// Refuses values with a NaN or an infinity among them. `O(nnz)`, without a branch per value.
pub(super) fn check_finite(values: &[f64]) -> Result<(), LinearError> {
    let bad = values.iter().fold(false, |bad, value| bad | !value.is_finite());
    if bad { Err(LinearError::NotFinite) } else { Ok(()) }
}

/// The extreme pivots seen so far, in absolute value.
#[derive(Clone, Copy, Debug)]
pub(super) struct PivotRange {
    smallest: f64,
    largest: f64,
}

impl PivotRange {
    /// No pivot seen yet.
    pub(super) fn new() -> Self {
        PivotRange { smallest: f64::INFINITY, largest: 0.0 }
    }

    /// Takes in the pivot of `column` and returns its reciprocal.
    ///
    /// # Errors
    /// [`LinearError::NotFinite`] for a pivot that has overflowed, [`LinearError::Singular`] for
    /// one without a finite reciprocal.
    #[inline]
    pub(super) fn take(&mut self, pivot: f64, column: usize) -> Result<f64, LinearError> {
        if !pivot.is_finite() {
            return Err(LinearError::NotFinite);
        }
        let reciprocal = pivot.recip();
        if !reciprocal.is_finite() {
            return Err(LinearError::Singular { column });
        }
        self.smallest = self.smallest.min(pivot.abs());
        self.largest = self.largest.max(pivot.abs());
        Ok(reciprocal)
    }

    /// The ratio of the extreme pivots; 1 for the matrix of order 0.
    pub(super) fn info(self) -> FactorInfo {
        FactorInfo::new(if self.largest > 0.0 { self.smallest / self.largest } else { 1.0 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nan_or_an_infinity_anywhere_is_found() {
        assert_eq!(check_finite(&[]), Ok(()));
        assert_eq!(check_finite(&[0.0, -1.0, f64::MAX, f64::MIN_POSITIVE]), Ok(()));
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for place in 0..9 {
                let mut values = [1.0; 9];
                values[place] = bad;
                assert_eq!(check_finite(&values), Err(LinearError::NotFinite));
            }
        }
    }

    #[test]
    fn a_pivot_without_a_finite_reciprocal_counts_as_zero() {
        let mut pivots = PivotRange::new();
        let singular = Err(LinearError::Singular { column: 3 });
        assert_eq!(pivots.take(0.0, 3), singular);
        assert_eq!(pivots.take(-0.0, 3), singular);
        assert_eq!(pivots.take(f64::MIN_POSITIVE / 8.0, 3), singular);
        assert_eq!(pivots.take(f64::NAN, 3), Err(LinearError::NotFinite));
        assert!(pivots.take(f64::MIN_POSITIVE, 3).is_ok());
    }

    #[test]
    fn the_pivot_ratio_is_that_of_the_extremes_and_one_without_pivots() {
        let mut pivots = PivotRange::new();
        assert_eq!(pivots.info(), FactorInfo::new(1.0));
        for pivot in [2.0, -8.0, 4.0] {
            assert_eq!(pivots.take(pivot, 0), Ok(1.0 / pivot));
        }
        assert_eq!(pivots.info(), FactorInfo::new(0.25));
    }
}
