//! Test matrices, and reproducible random numbers to fill them.

use crate::problem::Pattern;

/// A matrix with its pattern.
#[derive(Clone, Debug)]
pub(super) struct Matrix {
    pub(super) pattern: Pattern,
    pub(super) values: Vec<f64>,
}

impl Matrix {
    pub(super) fn new(pattern: Pattern, mut entry: impl FnMut(usize, usize) -> f64) -> Self {
        let values = pattern.entries().map(|(_, i, j)| entry(i, j)).collect();
        Matrix { pattern, values }
    }

    pub(super) fn dense(n: usize, entry: impl FnMut(usize, usize) -> f64) -> Self {
        Matrix::new(Pattern::dense(n), entry)
    }

    /// At most four nonzeros in a column, the diagonal among them.
    pub(super) fn sparse(n: usize, random: &mut Random) -> Self {
        let columns = (0..n).map(|j| (0..3).map(|_| random.below(n)).chain([j]).collect());
        let pattern = Pattern::from_columns(columns);
        Matrix::new(pattern, |_, _| random.sign())
    }

    /// Row `i` has its one in column `(5 i + 2) mod n`; `n` is no multiple of 5.
    pub(super) fn permutation(n: usize) -> Self {
        let rows: Vec<_> = (0..n).map(|i| vec![(5 * i + 2) % n]).collect();
        Matrix::new(Pattern::from_rows(&rows), |_, _| 1.0)
    }

    /// The five-point Laplacian on a `k × k` grid plus an unsymmetric part.
    pub(super) fn grid(k: usize) -> Self {
        let at = |x: usize, y: usize| x + k * y;
        let mut rows = Vec::new();
        for y in 0..k {
            for x in 0..k {
                let mut row = vec![at(x, y)];
                row.extend((x > 0).then(|| at(x - 1, y)));
                row.extend((x + 1 < k).then(|| at(x + 1, y)));
                row.extend((y > 0).then(|| at(x, y - 1)));
                row.extend((y + 1 < k).then(|| at(x, y + 1)));
                rows.push(row);
            }
        }
        let entry = |i, j| {
            if i == j { 4.0 } else { -1.0 + 0.3 * f64::from(u8::from(i < j)) }
        };
        Matrix::new(Pattern::from_rows(&rows), entry)
    }

    pub(super) fn n(&self) -> usize {
        self.pattern.n()
    }

    /// `H x` or `Hᵀ x`.
    pub(super) fn times(&self, x: &[f64], transposed: bool) -> Vec<f64> {
        let mut product = vec![0.0; self.n()];
        for (k, i, j) in self.pattern.entries() {
            let (to, from) = if transposed { (j, i) } else { (i, j) };
            product[to] += self.values[k] * x[from];
        }
        product
    }

    /// The largest absolute value.
    pub(super) fn largest(&self) -> f64 {
        self.values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
    }
}

/// Knuth's 64-bit linear congruential generator.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn step(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        self.0 >> 33
    }

    pub(super) fn sign(&mut self) -> f64 {
        self.step() as f64 / f64::from(1 << 30) - 1.0
    }

    pub(super) fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.step()).unwrap() % n
    }
}
