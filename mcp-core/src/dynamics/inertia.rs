//! [`Inertia`]: the matrix `M̂ = M + hθ C + (hθ)² K` of the free motion.

use super::constraint::Row;
use super::error::DynamicsError;
use super::mechanics::Mechanics;
use super::sparse_rows::SparseRows;
use crate::linalg::LinearError;
use crate::scalar::Scalar;

/// Working space: a number for each coordinate, and the 0 they start from.
pub(super) struct Column<D> {
    zero: D,
    entries: Vec<D>,
}

impl<D: Scalar> Column<D> {
    pub(super) fn new(zero: D, n: usize) -> Self {
        Column { zero, entries: vec![zero; n] }
    }

    /// All entries 0.
    pub(super) fn cleared(&mut self) -> &mut [D] {
        self.entries.fill(self.zero);
        &mut self.entries
    }
}

/// `M̂`, factored once; applied in any arithmetic.
pub(super) enum Inertia {
    /// `1 / M̂_ii` where nothing couples coordinates.
    Diagonal(Vec<f64>),
    /// `M̂ = L D Lᵀ` ([GV13](crate#references), § 4.1) within the envelope of `M̂`, whose coordinates
    /// stand in the order in which they were added.
    Coupled {
        /// `L` below its diagonal of ones.
        lower: SparseRows,
        /// `1 / D_ii`.
        inverse: Vec<f64>,
    },
}

impl Inertia {
    /// `M̂` sums masses, dampers and drag, springs, in this order.
    pub(super) fn new(system: &Mechanics, h_theta: f64) -> Result<Self, DynamicsError> {
        let n = system.mass.len();
        let entries = system.implicit_entries(h_theta);
        let mut envelope: Vec<usize> = (0..n).collect();
        for &(i, j, _) in &entries {
            envelope[i] = envelope[i].min(j);
        }
        // Row i from its first entry to its diagonal.
        let mut rows: Vec<Vec<f64>> = (0..n).map(|i| vec![0.0; i + 1 - envelope[i]]).collect();
        let masses = system.mass.iter().enumerate().map(|(i, &m)| (i, i, m));
        for (i, j, value) in masses.chain(entries).filter(|&(i, j, _)| j <= i) {
            rows[i][j - envelope[i]] += value;
        }
        let is_diagonal = rows.iter().all(|row| row.len() == 1);
        let inverse = factor(&mut rows, &envelope)?;
        if is_diagonal {
            return Ok(Inertia::Diagonal(inverse));
        }
        let columns: Vec<Vec<usize>> = (0..n).map(|i| (envelope[i]..i).collect()).collect();
        let mut lower = SparseRows::with_columns(&columns);
        let below = rows.iter().flat_map(|row| &row[..row.len() - 1]);
        for (place, &value) in lower.values.iter_mut().zip(below) {
            *place = value;
        }
        Ok(Inertia::Coupled { lower, inverse })
    }

    /// Whether two constraints act on each other: they share a coordinate, or all are coupled.
    pub(super) fn couples(&self, a: &Row<f64>, b: &Row<f64>) -> bool {
        match self {
            Inertia::Diagonal(_) => {
                a.entries().iter().any(|(i, _)| b.entries().iter().any(|(j, _)| i == j))
            }
            Inertia::Coupled { .. } => true,
        }
    }

    /// `v += M̂⁻¹ f` on the coordinates where forces act; `f` is used up.
    pub(super) fn accelerate<D: Scalar>(&self, forced: &[usize], f: &mut [D], v: &mut [D]) {
        match self {
            Inertia::Diagonal(inverse) => {
                for &i in forced {
                    v[i] = v[i] + f[i].scale(inverse[i]);
                }
            }
            Inertia::Coupled { lower, inverse } => add_solution(lower, inverse, f, v),
        }
    }

    /// `v += M̂⁻¹ Σ_i H_iᵀ λ_i`.
    pub(super) fn react<D: Scalar>(
        &self,
        rows: &[Row<D>],
        lambda: &[D],
        column: &mut Column<D>,
        v: &mut [D],
    ) {
        match self {
            Inertia::Diagonal(inverse) => {
                for (row, &r) in rows.iter().zip(lambda) {
                    for &(i, h) in row.entries() {
                        v[i] = v[i] + h.scale(inverse[i]) * r;
                    }
                }
            }
            Inertia::Coupled { lower, inverse } => {
                let column = column.cleared();
                for (row, &r) in rows.iter().zip(lambda) {
                    for &(i, h) in row.entries() {
                        column[i] = column[i] + h * r;
                    }
                }
                add_solution(lower, inverse, column, v);
            }
        }
    }

    /// Row `i` of the Delassus matrix, `(H M̂⁻¹ Hᵀ)_ij`, for the columns that `entries` gives.
    pub(super) fn delassus<'a, D: Scalar + 'a>(
        &self,
        rows: &[Row<D>],
        i: usize,
        column: &mut Column<D>,
        entries: impl Iterator<Item = (usize, &'a mut D)>,
    ) {
        match self {
            Inertia::Diagonal(inverse) => {
                for (j, entry) in entries {
                    let of_a = |&(a, ha): &(usize, D)| {
                        let same = rows[j].entries().iter().find(|(b, _)| *b == a);
                        same.map(|&(_, hb)| ha.scale(inverse[a]) * hb)
                    };
                    let terms = rows[i].entries().iter().filter_map(of_a);
                    *entry = terms.reduce(|sum, term| sum + term).unwrap_or(D::constant(0.0));
                }
            }
            Inertia::Coupled { lower, inverse } => {
                let column = column.cleared();
                for &(a, h) in rows[i].entries() {
                    column[a] = h;
                }
                solve(lower, inverse, column);
                for (j, entry) in entries {
                    *entry = rows[j].times(column);
                }
            }
        }
    }
}

/// `M̂ = L D Lᵀ` in place, `t_ij = M̂_ij − Σ_k t_ik L_jk`, `L_ij = t_ij / D_j`,
/// `D_i = M̂_ii − Σ_j t_ij L_ij`; returns `1 / D_i`.
fn factor(rows: &mut [Vec<f64>], envelope: &[usize]) -> Result<Vec<f64>, DynamicsError> {
    let mut inverse = Vec::with_capacity(rows.len());
    for i in 0..rows.len() {
        let (above, rest) = rows.split_at_mut(i);
        let (row, first) = (&mut rest[0], envelope[i]);
        for j in first..i {
            for k in first.max(envelope[j])..j {
                row[j - first] -= row[k - first] * above[j][k - envelope[j]];
            }
        }
        for j in first..i {
            let scaled = row[j - first] * inverse[j];
            row[i - first] -= row[j - first] * scaled;
            row[j - first] = scaled;
        }
        let pivot = row[i - first];
        if !(pivot > 0.0 && pivot.is_finite()) {
            return Err(LinearError::Singular { column: i }.into());
        }
        inverse.push(1.0 / pivot);
    }
    Ok(inverse)
}

/// `x ← (L D Lᵀ)⁻¹ x`.
fn solve<D: Scalar>(lower: &SparseRows, inverse: &[f64], x: &mut [D]) {
    for i in 0..x.len() {
        for (j, l) in lower.row(i) {
            x[i] = x[i] - x[j].scale(l);
        }
    }
    for (x, d) in x.iter_mut().zip(inverse) {
        *x = x.scale(*d);
    }
    for i in (0..x.len()).rev() {
        for (j, l) in lower.row(i) {
            x[j] = x[j] - x[i].scale(l);
        }
    }
}

/// `v += (L D Lᵀ)⁻¹ f`.
fn add_solution<D: Scalar>(lower: &SparseRows, inverse: &[f64], f: &mut [D], v: &mut [D]) {
    solve(lower, inverse, f);
    for (v, &dv) in v.iter_mut().zip(&*f) {
        *v = *v + dv;
    }
}
