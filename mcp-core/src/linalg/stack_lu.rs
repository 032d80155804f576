//! [`StackLu`]: LU factors of a small matrix, all inside the struct.

use super::pivots::{PivotRange, check_finite};
use super::{FactorInfo, LinearError, LinearSolver};
use crate::problem::Pattern;

/// Largest order.
const LIMIT: usize = 16;

/// Entries of the largest matrix. Every index of an entry fits in a `u8`.
const ENTRIES: usize = LIMIT * LIMIT;

/// Runs `$body` for `$k` in `0..$n`, each time with a constant: small loops inside get unrolled.
macro_rules! forward {
    ($n:ident, $k:ident => $body:block) => {
        forward!($n, $k => $body, 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15)
    };
    ($n:ident, $k:ident => $body:block, $($constant:literal)*) => {
        $(if $constant < $n { let $k = $constant; $body })*
    };
}

/// The same from `$n - 1` down to 0.
macro_rules! backward {
    ($n:ident, $k:ident => $body:block) => {
        forward!($n, $k => $body, 15 14 13 12 11 10 9 8 7 6 5 4 3 2 1 0)
    };
}

/// Dense LU with partial pivoting for `n <= 16`, without heap.
///
/// Matrix, factors and permutation live in fixed arrays inside the struct (2.5 kB), and every
/// order has its own copy of the loops, so the compiler knows their lengths. Factor `2n³/3`, solve
/// `2n²` flops. Column-oriented outer products, \[GV13\] Alg. 3.4.1; rows are exchanged in place.
///
/// Pivots are used through their reciprocals: one whose reciprocal overflows counts as zero.
///
/// \[GV13\]: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., 2013.
#[derive(Clone, Debug)]
pub struct StackLu {
    n: usize,
    nnz: usize,
    /// Column-major index of every structural nonzero, in the order of the pattern.
    places: [u8; ENTRIES],
    /// Column by column: `L` without its unit diagonal below, `U` on and above the diagonal.
    factors: [f64; ENTRIES],
    /// Reciprocal of every pivot.
    reciprocals: [f64; LIMIT],
    /// Row exchanged with row `k` in step `k`.
    exchanges: [u8; LIMIT],
}

impl StackLu {
    /// Largest order of a matrix this solver takes.
    pub const LIMIT: usize = LIMIT;

    /// For the matrix of order 0, until [`analyse`](LinearSolver::analyse) is called.
    pub fn new() -> Self {
        StackLu {
            n: 0,
            nnz: 0,
            places: [0; ENTRIES],
            factors: [0.0; ENTRIES],
            reciprocals: [0.0; LIMIT],
            exchanges: [0; LIMIT],
        }
    }

    /// The factors as `N` columns of length `N`.
    #[inline]
    fn columns<const N: usize>(&self) -> &[[f64; N]; N] {
        self.factors.as_chunks().0.first_chunk().expect("N is at most 16")
    }

    #[inline]
    fn factor_order<const N: usize>(&mut self) -> Result<FactorInfo, LinearError> {
        let StackLu { factors, reciprocals, exchanges, .. } = self;
        let a: &mut [[f64; N]; N] =
            factors.as_chunks_mut().0.first_chunk_mut().expect("N is at most 16");
        // A zero pivot leaves NaN and infinity behind it, but no trace before it: the test of the
        // pivots after the steps finds it first, and the steps stay free of exits.
        forward!(N, k => {
            (reciprocals[k], exchanges[k]) = eliminate(a, k);
        });
        let mut pivots = PivotRange::new();
        for k in 0..N {
            pivots.take(a[k][k], k)?;
        }
        Ok(pivots.info())
    }

    #[inline]
    fn solve_order<const N: usize>(&self, rhs: &mut [f64]) {
        let a = self.columns::<N>();
        let x: &mut [f64; N] = rhs.try_into().expect("one right-hand side for every row");
        for k in 0..N {
            x.swap(k, usize::from(self.exchanges[k]).min(N - 1));
        }
        forward!(N, k => {
            for i in k + 1..N {
                x[i] -= a[k][i] * x[k];
            }
        });
        backward!(N, k => {
            x[k] *= self.reciprocals[k];
            for i in 0..k {
                x[i] -= a[k][i] * x[k];
            }
        });
    }

    #[inline]
    fn solve_transposed_order<const N: usize>(&self, rhs: &mut [f64]) {
        let a = self.columns::<N>();
        let x: &mut [f64; N] = rhs.try_into().expect("one right-hand side for every column");
        forward!(N, k => {
            for i in 0..k {
                x[k] -= a[k][i] * x[i];
            }
            x[k] *= self.reciprocals[k];
        });
        backward!(N, k => {
            for i in k + 1..N {
                x[k] -= a[k][i] * x[i];
            }
        });
        for k in (0..N).rev() {
            x.swap(k, usize::from(self.exchanges[k]).min(N - 1));
        }
    }
}

/// Step `k` of Gaussian elimination: the reciprocal of the pivot and the row exchanged with `k`.
#[inline(always)]
#[allow(clippy::inline_always, reason = "only with k known are the inner loops unrolled")]
fn eliminate<const N: usize>(a: &mut [[f64; N]; N], k: usize) -> (f64, u8) {
    let mut p = k;
    let mut largest = a[k][k].abs();
    for i in k + 1..N {
        let size = a[k][i].abs();
        if size > largest {
            largest = size;
            p = i;
        }
    }
    if p != k {
        for column in a.iter_mut() {
            column.swap(k, p);
        }
    }
    let mut multipliers = a[k];
    let reciprocal = multipliers[k].recip();
    for i in k + 1..N {
        multipliers[i] *= reciprocal;
    }
    a[k] = multipliers;
    for j in k + 1..N {
        for i in k + 1..N {
            a[j][i] -= multipliers[i] * a[j][k];
        }
    }
    (reciprocal, index(p))
}

impl Default for StackLu {
    fn default() -> Self {
        Self::new()
    }
}

/// Calls `$self.$method::<n>($arguments)` for the order `n` of the matrix, `$nothing` for order 0.
macro_rules! for_order {
    ($self:ident . $method:ident ($($argument:expr),*), $nothing:expr) => {
        match $self.n {
            0 => $nothing,
            1 => $self.$method::<1>($($argument),*),
            2 => $self.$method::<2>($($argument),*),
            3 => $self.$method::<3>($($argument),*),
            4 => $self.$method::<4>($($argument),*),
            5 => $self.$method::<5>($($argument),*),
            6 => $self.$method::<6>($($argument),*),
            7 => $self.$method::<7>($($argument),*),
            8 => $self.$method::<8>($($argument),*),
            9 => $self.$method::<9>($($argument),*),
            10 => $self.$method::<10>($($argument),*),
            11 => $self.$method::<11>($($argument),*),
            12 => $self.$method::<12>($($argument),*),
            13 => $self.$method::<13>($($argument),*),
            14 => $self.$method::<14>($($argument),*),
            15 => $self.$method::<15>($($argument),*),
            16 => $self.$method::<16>($($argument),*),
            _ => unreachable!("`analyse` refuses larger orders"),
        }
    };
}

impl LinearSolver for StackLu {
    fn name(&self) -> &'static str {
        "stack LU"
    }

    /// Notes where every nonzero goes. `O(nnz)`, allocates nothing, ever.
    ///
    /// # Errors
    /// [`LinearError::TooLarge`] for `n > 16`.
    fn analyse(&mut self, pattern: &Pattern) -> Result<(), LinearError> {
        let n = pattern.n();
        if n > LIMIT {
            return Err(LinearError::TooLarge { n, limit: LIMIT });
        }
        self.n = n;
        self.nnz = pattern.nnz();
        for (k, i, j) in pattern.entries() {
            self.places[k] = index(j * n + i);
        }
        Ok(())
    }

    fn factor(&mut self, values: &[f64]) -> Result<FactorInfo, LinearError> {
        assert_eq!(values.len(), self.nnz, "one value for every entry of the pattern");
        check_finite(values)?;
        let entries = self.n * self.n;
        if self.nnz == entries {
            self.factors[..entries].copy_from_slice(values);
        } else {
            self.factors[..entries].fill(0.0);
            for (&place, &value) in self.places.iter().zip(values) {
                self.factors[usize::from(place)] = value;
            }
        }
        for_order!(self.factor_order(), Ok(PivotRange::new().info()))
    }

    fn solve(&mut self, rhs: &mut [f64]) {
        for_order!(self.solve_order(rhs), ());
    }

    fn solve_transposed(&mut self, rhs: &mut [f64]) {
        for_order!(self.solve_transposed_order(rhs), ());
    }
}

/// An index of the fixed arrays as they store it.
#[inline]
fn index(i: usize) -> u8 {
    u8::try_from(i).expect("indices of the fixed arrays are below 256")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn order_sixteen_is_taken_and_order_seventeen_is_refused() {
        let mut solver = StackLu::new();
        assert_eq!(solver.analyse(&Pattern::dense(16)), Ok(()));
        let error = solver.analyse(&Pattern::dense(17));
        assert_eq!(error, Err(LinearError::TooLarge { n: 17, limit: 16 }));
    }

    #[test]
    fn the_factors_are_those_of_the_textbook() {
        // The 3-by-3 example of [GV13] section 3.4.
        let mut solver = StackLu::default();
        solver.analyse(&Pattern::dense(3)).unwrap();
        let a = [3.0, 2.0, 6.0, 17.0, 4.0, 18.0, 10.0, -2.0, -12.0];
        let info = solver.factor(&a).unwrap();
        let u = [6.0, 18.0, -12.0, 8.0, 16.0, 6.0];
        let found = solver.columns::<3>();
        let found = [found[0][0], found[1][0], found[2][0], found[1][1], found[2][1], found[2][2]];
        for (expected, found) in u.iter().zip(found) {
            assert!((expected - found).abs() < 1e-14, "{expected} {found}");
        }
        assert_eq!(solver.exchanges[..3], [2, 2, 2]);
        assert!((info.pivot_ratio - 0.75).abs() < 1e-15);
    }
}
