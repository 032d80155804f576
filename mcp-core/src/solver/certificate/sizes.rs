//! What counts as small: the sizes `w_j` of variables and `s_i` of equations.

use super::middle;
use crate::model::Shape;
use crate::problem::{Index, Pattern, small};

/// Sum and number of binary exponents over a block, in its scales.
type Mean = [i64; 2];

/// Takes in `z`, unless it is 0.
fn add(mean: &mut Mean, z: f64, scale: i32) {
    if z != 0.0 && z.is_finite() {
        mean[0] += i64::from(exponent(z) - scale);
        mean[1] += 1;
    }
}

fn value([sum, count]: Mean) -> Option<i32> {
    let mean = (count > 0).then(|| sum / count)?;
    Some(i32::try_from(mean).expect("a mean of small exponents is small"))
}

/// How far below its start a block may fall before the start counts: 2⁻¹³ is about 10⁻⁴.
const FLOOR: i32 = 13;
/// The same of a size of 1 where a block starts at 0: about 10⁻⁶.
const ZERO_FLOOR: i32 = 20;
/// Exponent for "no nonzero seen yet".
const NONE: i32 = i32::MIN / 4;
/// Gauge yet to be found of a block that starts at 0, and of one that is 0 at the point as well.
const STARTS_AT_ZERO: i32 = i32::MIN;
const IS_ZERO: i32 = i32::MIN + 1;

/// Workspace and result.
#[derive(Clone, Debug, Default)]
pub(super) struct Sizes {
    row_scale: Vec<i32>,
    column_scale: Vec<i32>,
    row_max: Vec<i32>,
    column_max: Vec<i32>,
    /// For every variable, then for every equation, one further on the way to the representative of
    /// its block.
    block: Vec<Index>,
    /// By representative of a block: means at the point and at the start, and the gauge.
    mean: Vec<Mean>,
    mean_start: Vec<Mean>,
    gauge: Vec<i32>,
    /// `w_j`.
    pub(super) weight: Vec<f64>,
    /// `s_i`.
    pub(super) of_row: Vec<f64>,
}

impl Sizes {
    pub(super) fn resize(&mut self, n: usize) {
        self.weight = vec![0.0; n];
        self.of_row = vec![0.0; n];
        for scale in [
            &mut self.row_scale,
            &mut self.column_scale,
            &mut self.row_max,
            &mut self.column_max,
            &mut self.gauge,
        ] {
            *scale = vec![0; n];
        }
        self.block = vec![0; 2 * n];
        (self.mean, self.mean_start) = (vec![[0; 2]; n], vec![[0; 2]; n]);
    }

    /// The sizes at `z`, with finite `F` and `J`.
    pub(super) fn measure(
        &mut self,
        shape: &Shape,
        pattern: &Pattern,
        (z, f, jac): (&[f64], &[f64], &[f64]),
    ) {
        self.equilibrate(pattern, jac);
        self.connect(pattern, jac);
        self.measure_blocks(z, shape.start());
        self.gauge(shape, z, f);
        self.weigh(shape, z);
        add_terms(pattern, jac, &self.weight, &mut self.of_row);
    }

    /// Rows are no larger than with other slopes; `other` is for the sizes with them.
    pub(super) fn lessen(&mut self, pattern: &Pattern, jac: &[f64], other: &mut [f64]) {
        add_terms(pattern, jac, &self.weight, other);
        for (size, other) in self.of_row.iter_mut().zip(other) {
            *size = size.min(*other);
        }
    }

    /// Binary exponents of row and column scales that bring the largest entry of every row and
    /// column of `J` near 1 ([Rui01](crate#references), in integers; at most ten sweeps).
    fn equilibrate(&mut self, pattern: &Pattern, jac: &[f64]) {
        self.column_scale.fill(0);
        // Rows first: in whatever units an equation is, the columns see the same matrix.
        self.row_max.fill(NONE);
        for (i, &entry) in pattern.rows().zip(jac) {
            if entry != 0.0 {
                self.row_max[i] = self.row_max[i].max(exponent(entry));
            }
        }
        for (scale, &max) in self.row_scale.iter_mut().zip(&self.row_max) {
            *scale = if max == NONE { 0 } else { -max };
        }
        for _ in 0..10 {
            self.row_max.fill(NONE);
            self.column_max.fill(NONE);
            for j in 0..pattern.n() {
                for k in pattern.column(j) {
                    let i = pattern.row(k);
                    if jac[k] != 0.0 {
                        let e = exponent(jac[k]) + self.row_scale[i] + self.column_scale[j];
                        self.row_max[i] = self.row_max[i].max(e);
                        self.column_max[j] = self.column_max[j].max(e);
                    }
                }
            }
            let mut balanced = true;
            let rows = self.row_scale.iter_mut().zip(&self.row_max);
            let columns = self.column_scale.iter_mut().zip(&self.column_max);
            for (scale, &max) in rows.chain(columns) {
                if max != NONE {
                    *scale -= max / 2;
                    balanced &= max.abs() <= 1;
                }
            }
            if balanced {
                break;
            }
        }
    }

    /// Blocks of variables and equations that nonzeros of `J` connect.
    fn connect(&mut self, pattern: &Pattern, jac: &[f64]) {
        let n = pattern.n();
        for (block, j) in self.block.iter_mut().zip(0..) {
            *block = j;
        }
        let mut blocks = 2 * n;
        for j in 0..n {
            for k in pattern.column(j) {
                if blocks <= 1 {
                    return;
                }
                if jac[k] != 0.0 {
                    let row = n + pattern.row(k);
                    let (a, b) = (self.representative(row), self.representative(j));
                    self.block[a.max(b)] = small(a.min(b));
                    blocks -= usize::from(a != b);
                }
            }
        }
    }

    /// The smallest variable known to be in the block, with the way there halved; of an equation without
    /// derivatives, itself.
    fn representative(&mut self, mut j: usize) -> usize {
        while self.block[j] as usize != j {
            self.block[j] = self.block[self.block[j] as usize];
            j = self.block[j] as usize;
        }
        j
    }

    /// Means of the variables of each block, at the point and at the start.
    fn measure_blocks(&mut self, z: &[f64], start: &[f64]) {
        for j in (0..z.len()).filter(|&j| self.block[j] as usize == j) {
            (self.mean[j], self.mean_start[j]) = ([0; 2], [0; 2]);
        }
        for j in 0..z.len() {
            let block = self.representative(j);
            add(&mut self.mean[block], z[j], self.column_scale[j]);
            add(&mut self.mean_start[block], start[j], self.column_scale[j]);
        }
    }

    /// The gauge of every block.
    fn gauge(&mut self, shape: &Shape, z: &[f64], f: &[f64]) {
        let mut all_start = true;
        for j in (0..z.len()).filter(|&j| self.block[j] as usize == j) {
            let (here, start) = (value(self.mean[j]), value(self.mean_start[j]));
            self.gauge[j] = match (here, start) {
                (Some(here), Some(start)) => here.max(start - FLOOR),
                (None, Some(start)) => start - FLOOR,
                (Some(_), None) => STARTS_AT_ZERO,
                (None, None) => IS_ZERO,
            };
            all_start &= start.is_some();
        }
        if !all_start {
            self.gauge_from_zero(shape, z, f);
        }
    }

    /// The same where a block starts at 0: 10⁻⁶ of a gauge that makes no `τ_j` larger than 1 is the least,
    /// and natural residuals stand for the point where it is 0 as well.
    fn gauge_from_zero(&mut self, shape: &Shape, z: &[f64], f: &[f64]) {
        let (n, bounds) = (z.len(), shape.bounds());
        // In place of the mean at the start, which is empty. The representative comes first.
        for j in 0..n {
            let block = self.representative(j);
            if self.gauge[block] <= IS_ZERO {
                let (unit, so_far) = (i64::from(-self.column_scale[j]), self.mean_start[block][0]);
                self.mean_start[block][0] = if j == block { unit } else { so_far.min(unit) };
            }
        }
        for i in 0..n {
            let (row, column) = (self.representative(n + i), self.representative(i));
            let (above, below) = (z[i] - bounds.lower()[i], z[i] - bounds.upper()[i]);
            let (block, scale) = if below < f[i] && f[i] < above {
                (row, -self.row_scale[i])
            } else {
                (column, self.column_scale[i])
            };
            if block < n && self.gauge[block] == IS_ZERO {
                add(&mut self.mean[block], middle(above, f[i], below), scale);
            }
        }
        for j in (0..n).filter(|&j| self.block[j] as usize == j) {
            if self.gauge[j] <= IS_ZERO {
                let [unit, _] = self.mean_start[j];
                let unit = i32::try_from(unit).expect("an exponent is small");
                self.gauge[j] =
                    value(self.mean[j]).map_or(unit, |here| here.max(unit - ZERO_FLOOR));
            }
        }
    }

    /// `w_j = |z_j| + τ_j`.
    fn weigh(&mut self, shape: &Shape, z: &[f64]) {
        let bounds = shape.bounds();
        for j in 0..z.len() {
            let block = self.representative(j);
            let exponent = (self.gauge[block] + self.column_scale[j]).clamp(-1000, 1000);
            let width = bounds.upper()[j] - bounds.lower()[j];
            let tau = 2_f64.powi(exponent);
            // Nothing can be resolved in a box of subnormal width.
            let is_box = width >= f64::MIN_POSITIVE;
            self.weight[j] = z[j].abs() + if is_box { tau.min(width) } else { tau };
        }
    }
}

/// `s_i = Σ_j |J_ij| w_j`. Subnormal derivatives count as zero: no solver can divide by them; so do
/// those that are not finite.
fn add_terms(pattern: &Pattern, jac: &[f64], weight: &[f64], of_row: &mut [f64]) {
    of_row.fill(0.0);
    for j in 0..pattern.n() {
        for k in pattern.column(j) {
            let size = jac[k].abs();
            if (f64::MIN_POSITIVE..=f64::MAX).contains(&size) {
                of_row[pattern.row(k)] += size * weight[j];
            }
        }
    }
}

/// `⌊log₂ |x|⌋` for a nonzero number.
fn exponent(x: f64) -> i32 {
    let biased = (x.to_bits() >> 52 & 0x7ff) as i32;
    if biased > 0 {
        biased - 1023
    } else {
        -1023 - (x.to_bits() << 12).leading_zeros().cast_signed()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_of_all_numbers() {
        assert_eq!([1.0, 1.5, 2.0, -0.75, 1e-3].map(exponent), [0, 0, 1, -1, -10]);
        assert_eq!(exponent(f64::MAX), 1023);
        assert_eq!(exponent(f64::MIN_POSITIVE), -1022);
        assert_eq!(exponent(f64::MIN_POSITIVE / 2.0), -1023);
        assert_eq!(exponent(5e-324), -1074);
        assert_eq!(exponent(-1.5e-323), -1073);
    }

    #[test]
    fn equilibration_brings_rows_and_columns_near_one() {
        let jac = [1e-8, 3e4, 0.0, 2e-3, 5e9, 1.0, 0.0, 7e2, 4e-6];
        let mut sizes = Sizes::default();
        sizes.resize(3);
        let pattern = Pattern::dense(3);
        sizes.equilibrate(&pattern, &jac);
        let (mut rows, mut columns) = ([0.0_f64; 3], [0.0_f64; 3]);
        for (k, i, j) in pattern.entries() {
            let scale = sizes.row_scale[i] + sizes.column_scale[j];
            let scaled = (jac[k] * 2_f64.powi(scale)).abs();
            rows[i] = rows[i].max(scaled);
            columns[j] = columns[j].max(scaled);
        }
        for largest in rows.into_iter().chain(columns) {
            assert!((0.25..=4.0).contains(&largest), "{rows:?} {columns:?}");
        }
    }

    #[test]
    fn an_empty_row_or_column_is_left_alone() {
        let mut sizes = Sizes::default();
        sizes.resize(2);
        sizes.equilibrate(&Pattern::dense(2), &[1024.0, 0.0, 0.0, 0.0]);
        assert_eq!((sizes.row_scale[1], sizes.column_scale[1]), (0, 0));
        assert_eq!(sizes.row_scale[0] + sizes.column_scale[0], -10);
    }
}
