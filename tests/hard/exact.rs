//! The solution set of a small affine problem, exactly: `M` in integers, `q`, `l` and `u` in multiples
//! of 2⁻³², everything else in integers of 128 bits.
//!
//! ```text
//! S = ∪ P_A over the 3ⁿ active sets A;   P_A:  z_i = l_i, F_i >= 0;  F_i = 0, l_i <= z_i <= u_i;
//!                                              z_i = u_i, F_i <= 0
//! ```
//!
//! Every `P_A` is a polyhedron `E z = e, C z >= c`. Within a box it is a polytope, which is empty
//! exactly if it has no vertex: the equations with as many of the inequalities as make them `n`
//! independent ones. The box that decides whether there is any solution is so large that no
//! vertex of a nonempty `P_A` lies outside (Cramer's rule).
//!
//! Distance. At `z` in the box let `ρ_i = mid(z_i − l_i, F_i, z_i − u_i)`. Then `z` is in the `P_A` of
//! its own branches, with the right-hand sides of the equations moved by `ρ`. With `P_A` nonempty
//! [Sch86, theorem 10.5] (references in `mcp_core`) gives a solution `z*` with
//!
//! ```text
//! ‖z − z*‖∞ <= n Δ ‖ρ‖∞,   Δ = max |minor of M| / min |nonzero minor of M|
//! ```
//!
//! where `Δ` bounds the entries of the inverses of all submatrices of the equations and inequalities:
//! rows of `M` and of the unit matrix.

/// Unit of `q`, bounds and points.
pub(crate) const UNIT: f64 = 1.0 / 4_294_967_296.0;

/// `M z + q ⟂ l <= z <= u`; `None` is no bound.
#[derive(Clone, Debug)]
pub(crate) struct Exact {
    pub(crate) m: Vec<Vec<i128>>,
    pub(crate) q: Vec<i128>,
    pub(crate) lower: Vec<Option<i128>>,
    pub(crate) upper: Vec<Option<i128>>,
}

/// `a · z = b` or `a · z >= b`: the coefficients and `b`.
type Row = Vec<i128>;

#[derive(Clone, Copy, PartialEq)]
enum Place {
    Lower,
    Between,
    Upper,
}

impl Exact {
    pub(crate) fn n(&self) -> usize {
        self.q.len()
    }

    /// Whether there is a solution.
    pub(crate) fn is_solvable(&self) -> bool {
        let n = self.n();
        let largest =
            |values: &mut dyn Iterator<Item = i128>| values.fold(1, |m, x| m.max(x.abs()));
        let entry = largest(&mut self.m.iter().flatten().copied());
        let bounds = self.lower.iter().chain(&self.upper).flatten();
        let right = largest(&mut self.q.iter().chain(bounds).copied());
        let minor = (1..n).fold(1, |minor, k| minor * entry * k as i128);
        let far = n as i128 * minor * right;
        self.meets(&vec![-far; n], &vec![far; n])
    }

    /// Whether a solution lies in the box `low <= z <= high`.
    pub(crate) fn meets(&self, low: &[i128], high: &[i128]) -> bool {
        let mut places = vec![Place::Lower; self.n()];
        loop {
            if let Some((equations, mut inequalities)) = self.piece(&places) {
                for j in 0..self.n() {
                    inequalities.push(self.unit_row(j, 1, low[j]));
                    inequalities.push(self.unit_row(j, -1, -high[j]));
                }
                if has_vertex(self.n(), &equations, &inequalities) {
                    return true;
                }
            }
            if !advance(&mut places) {
                return false;
            }
        }
    }

    /// `Δ`.
    pub(crate) fn inverse_bound(&self) -> f64 {
        let (mut least, mut most) = (1, 1);
        let all = 1_u32 << self.n();
        for rows in 1..all {
            for columns in (1..all).filter(|c| c.count_ones() == rows.count_ones()) {
                let minor = self.minor(rows, columns).abs();
                most = most.max(minor);
                if minor > 0 {
                    least = least.min(minor);
                }
            }
        }
        most as f64 / least as f64
    }

    /// How much larger than its data numbers of an elimination get, and sums of them.
    pub(crate) fn growth(&self) -> f64 {
        let n = self.n();
        let entry = self.m.iter().flatten().fold(1.0_f64, |m, x| m.max(x.abs() as f64));
        (1..=n + 1).map(|k| k as f64 * entry).product()
    }

    /// Determinant of the rows and columns in two sets of bits, by its first row.
    fn minor(&self, rows: u32, columns: u32) -> i128 {
        if rows == 0 {
            return 1;
        }
        let i = rows.trailing_zeros() as usize;
        let (mut sum, mut sign) = (0, 1);
        for j in (0..self.n()).filter(|j| columns >> j & 1 == 1) {
            if self.m[i][j] != 0 {
                sum += sign * self.m[i][j] * self.minor(rows & !(1 << i), columns & !(1 << j));
            }
            sign = -sign;
        }
        sum
    }

    /// Equations and inequalities of an active set; `None` where one of its bounds does not exist.
    fn piece(&self, places: &[Place]) -> Option<(Vec<Row>, Vec<Row>)> {
        let (mut equations, mut inequalities) = (Vec::new(), Vec::new());
        for (i, place) in places.iter().enumerate() {
            let f = |sign: i128| {
                let row = self.m[i].iter().map(|m| sign * m);
                row.chain([-sign * self.q[i]]).collect()
            };
            let (lower, upper) = (self.lower[i], self.upper[i]);
            let is_fixed = lower.is_some() && lower == upper;
            match place {
                Place::Lower => equations.push(self.unit_row(i, 1, lower?)),
                Place::Upper | Place::Between if is_fixed => return None,
                Place::Upper => equations.push(self.unit_row(i, 1, upper?)),
                Place::Between => equations.push(f(1)),
            }
            match place {
                Place::Between => {
                    inequalities.extend(lower.map(|l| self.unit_row(i, 1, l)));
                    inequalities.extend(upper.map(|u| self.unit_row(i, -1, -u)));
                }
                _ if is_fixed => {}
                Place::Lower => inequalities.push(f(1)),
                Place::Upper => inequalities.push(f(-1)),
            }
        }
        Some((equations, inequalities))
    }

    /// `sign · z_j` and a right-hand side.
    fn unit_row(&self, j: usize, sign: i128, right: i128) -> Row {
        (0..self.n()).map(|k| if k == j { sign } else { 0 }).chain([right]).collect()
    }
}

/// The next of the `3ⁿ` active sets; false after the last.
fn advance(places: &mut [Place]) -> bool {
    for place in places {
        *place = match *place {
            Place::Lower => Place::Between,
            Place::Between => Place::Upper,
            Place::Upper => Place::Lower,
        };
        if *place != Place::Lower {
            return true;
        }
    }
    false
}

/// Whether the polyhedron has a vertex.
fn has_vertex(n: usize, equations: &[Row], inequalities: &[Row]) -> bool {
    let Some(reduced) = reduce(n, equations.to_vec()) else { return false };
    let rank = reduced.pivots.len();
    let mut chosen: Vec<usize> = (0..n - rank).collect();
    loop {
        let rows = equations.iter().chain(chosen.iter().map(|&k| &inequalities[k]));
        if let Some(vertex) = reduce(n, rows.cloned().collect())
            && vertex.pivots.len() == n
            && inequalities.iter().all(|row| vertex.satisfies(row))
        {
            return true;
        }
        if !next_choice(&mut chosen, inequalities.len()) {
            return false;
        }
    }
}

/// The next choice of as many of `0..n`, in lexical order; false after the last.
fn next_choice(chosen: &mut [usize], n: usize) -> bool {
    let count = chosen.len();
    for k in (0..count).rev() {
        if chosen[k] < n - count + k {
            chosen[k] += 1;
            for next in k + 1..count {
                chosen[next] = chosen[next - 1] + 1;
            }
            return true;
        }
    }
    false
}

/// Equations after elimination: `d z_j = b` for the pivots `(j, b)`, if all columns have one.
struct Reduced {
    pivots: Vec<(usize, i128)>,
    d: i128,
}

impl Reduced {
    /// Whether the point satisfies `a · z >= b`.
    fn satisfies(&self, row: &[i128]) -> bool {
        let (a, b) = row.split_at(row.len() - 1);
        let sum: i128 = self.pivots.iter().map(|&(j, z)| a[j] * z).sum();
        (sum - b[0] * self.d) * self.d.signum() >= 0
    }
}

/// Gauss–Jordan elimination without fractions ([Bar68], references in `mcp_core`): every entry stays a
/// minor of the rows, and the division is exact. `None` if the equations contradict each other.
fn reduce(n: usize, mut rows: Vec<Row>) -> Option<Reduced> {
    let (mut columns, mut d) = (Vec::new(), 1);
    for j in 0..n {
        let done = columns.len();
        let Some(k) = (done..rows.len()).find(|&k| rows[k][j] != 0) else { continue };
        rows.swap(done, k);
        let pivot = rows[done].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(k, _)| *k != done) {
            let factor = row[j];
            for (a, p) in row.iter_mut().zip(&pivot) {
                *a = (pivot[j] * *a - factor * p) / d;
            }
        }
        d = pivot[j];
        columns.push(j);
    }
    let rest = &rows[columns.len()..];
    if rest.iter().any(|row| row[n] != 0) {
        return None;
    }
    let pivots = columns.iter().zip(&rows).map(|(&j, row)| (j, row[n])).collect();
    Some(Reduced { pivots, d })
}

#[cfg(test)]
mod tests {
    use super::*;

    const ONE: i128 = 1 << 32;

    fn nonnegative(m: [[i128; 2]; 2], q: [i128; 2]) -> Exact {
        let m = m.map(|row| row.to_vec()).to_vec();
        let q = q.map(|q| q * ONE).to_vec();
        Exact { m, q, lower: vec![Some(0); 2], upper: vec![None; 2] }
    }

    #[test]
    fn rows_that_contradict_each_other_have_no_solution() {
        assert!(nonnegative([[1, -1], [-1, 1]], [-1, 1]).is_solvable());
        let mut free = nonnegative([[1, -1], [-1, 1]], [-1, 2]);
        free.lower = vec![None; 2];
        assert!(!free.is_solvable());
        assert!(!nonnegative([[-1, 0], [0, 1]], [-1, 0]).is_solvable());
    }

    #[test]
    fn a_segment_of_solutions_is_met_on_it_and_missed_beside_it() {
        // x + y = 1, x, y >= 0.
        let segment = nonnegative([[1, 1], [1, 1]], [-1, -1]);
        let meets =
            |x: i128, y: i128, by: i128| segment.meets(&[x - by, y - by], &[x + by, y + by]);
        assert!(meets(ONE / 4, 3 * (ONE / 4), 0));
        assert!(!meets(ONE / 4 + 2, 3 * (ONE / 4), 0) && meets(ONE / 4 + 2, 3 * (ONE / 4), 1));
        assert!(!meets(2 * ONE, -ONE, 1));
    }

    #[test]
    fn minors_bound_the_inverse() {
        assert_eq!(nonnegative([[2, 0], [0, 3]], [0, 0]).inverse_bound(), 6.0);
        assert_eq!(nonnegative([[0, 0], [0, 0]], [0, 0]).inverse_bound(), 1.0);
    }
}
