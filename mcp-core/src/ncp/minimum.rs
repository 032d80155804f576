//! The min map of a box: `mid(z−l, F, z−u)`, zero exactly at solutions.

/// Which of the three numbers the middle one is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// `z − l`: the variable is taken to be at its lower bound.
    Lower,
    /// `F`: the equation is taken to hold.
    Equation,
    /// `z − u`: the variable is taken to be at its upper bound.
    Upper,
}

/// The middle of `z − l`, `f` and `z − u`, and which it is. Ties take the bound, so that the row of
/// the linearisation is the cheap one. NaN in `z` or `f` gives NaN.
///
/// Requires `l <= u`; infinite bounds are never the middle.
#[inline]
pub fn mid(z: f64, f: f64, lower: f64, upper: f64) -> (f64, Branch) {
    if z - lower <= f {
        (z - lower, Branch::Lower)
    } else if z - upper >= f {
        (z - upper, Branch::Upper)
    } else if z.is_nan() {
        (z, Branch::Equation)
    } else {
        (f, Branch::Equation)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const INF: f64 = f64::INFINITY;

    #[test]
    fn ties_take_the_bound() {
        assert_eq!(mid(0.0, 0.0, 0.0, INF), (0.0, Branch::Lower));
        assert_eq!(mid(1.0, 0.0, 0.0, 1.0), (0.0, Branch::Upper));
        assert_eq!(mid(2.0, 5.0, 2.0, 2.0), (0.0, Branch::Lower));
        assert_eq!(mid(2.0, -5.0, 2.0, 2.0), (0.0, Branch::Upper));
    }

    #[test]
    fn a_free_variable_gives_its_equation() {
        assert_eq!(mid(3.0, -7.0, -INF, INF), (-7.0, Branch::Equation));
    }

    #[test]
    fn nan_is_never_hidden() {
        assert!(mid(f64::NAN, 1.0, 0.0, 1.0).0.is_nan());
        assert!(mid(0.0, f64::NAN, 0.0, 1.0).0.is_nan());
        assert!(mid(0.0, f64::NAN, -INF, INF).0.is_nan());
    }

    proptest! {
        #[test]
        fn mid_is_the_median(z in -5.0..5.0, f in -5.0..5.0, l in -5.0..5.0, width in 0.0..5.0) {
            let (u, mut three) = (l + width, [0.0; 3]);
            three.copy_from_slice(&[z - l, f, z - u]);
            three.sort_by(f64::total_cmp);
            prop_assert_eq!(mid(z, f, l, u).0, three[1]);
        }

        #[test]
        fn mid_vanishes_exactly_at_solutions(z in 0.0..1.0, f in -1.0..1.0) {
            prop_assert_eq!(mid(0.0, f, 0.0, 1.0).0 == 0.0, f >= 0.0);
            prop_assert_eq!(mid(1.0, f, 0.0, 1.0).0 == 0.0, f <= 0.0);
            prop_assert_eq!(mid(z, 0.0, 0.0, 1.0).0, 0.0);
        }
    }
}
