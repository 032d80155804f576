//! [`Cost`]: what a solve takes, in counts that depend on no clock.

use crate::problem::Pattern;
use crate::solver::Stats;

/// What a solve takes, the certificate's part included.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Evaluations of `F` alone.
    pub residual: usize,
    /// Evaluations of `J`. The certificate's are of `F` and `J`.
    pub jacobian: usize,
    /// Factorisations.
    pub factorisations: usize,
    /// Scalar operations of all evaluations and factorisations; `None` where those of `J` are not
    /// counted. Exchanges of a pivoting method are left out.
    pub operations: Option<u64>,
}

impl Cost {
    /// From the statistics of a solve and the operations of one `F` and one `J`.
    pub fn of(stats: Stats, pattern: &Pattern, (f, j): (u64, Option<u64>)) -> Self {
        let residual = stats.residual_evaluations;
        let jacobian = stats.jacobian_evaluations + stats.certificate_evaluations;
        let operations = j.map(|j| {
            residual as u64 * f
                + jacobian as u64 * j
                + stats.factorisations as u64 * of_factorisation(pattern)
        });
        Cost { residual, jacobian, factorisations: stats.factorisations, operations }
    }
}

/// `2n³/3`, or `2 n p q` for a band of `p` diagonals below and `q` above the main one, whichever is
/// less ([GV13](crate#references), sections 3.2 and 4.3). An order that reduces fill takes less.
fn of_factorisation(pattern: &Pattern) -> u64 {
    let n = pattern.n() as u64;
    let (mut below, mut above) = (0, 0);
    for (_, i, j) in pattern.entries() {
        below = below.max(i.saturating_sub(j));
        above = above.max(j.saturating_sub(i));
    }
    (2 * n.pow(3) / 3).min(2 * n * below as u64 * above as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dense_factorisation_takes_two_thirds_of_n_cubed() {
        assert_eq!(of_factorisation(&Pattern::dense(30)), 18_000);
    }

    #[test]
    fn a_band_takes_the_product_of_its_widths() {
        let band = Pattern::from_columns(
            (0..100_usize).map(|j| (j.saturating_sub(2)..(j + 4).min(100)).collect()),
        );
        assert_eq!(of_factorisation(&band), 2 * 100 * 3 * 2);
    }

    #[test]
    fn operations_that_are_not_counted_make_no_total() {
        let stats = Stats { residual_evaluations: 3, jacobian_evaluations: 2, ..Stats::default() };
        let pattern = Pattern::dense(3);
        assert_eq!(Cost::of(stats, &pattern, (10, None)).operations, None);
        assert_eq!(Cost::of(stats, &pattern, (10, Some(100))).operations, Some(230));
    }
}
