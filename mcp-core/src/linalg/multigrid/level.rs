//! [`Level`]: a symmetric nine-point matrix on one grid, with its smoother and its way to the next.

use super::grid::{Grid, Parents, parents};

/// Values at the nodes of a grid inside a rim of zeros: node `(i, j)` at `(i + 1) m + j + 1`.
pub(super) type Field = Vec<f64>;

/// One grid of the hierarchy: the matrix, while fields are memory of the caller's. The matrix couples a node with itself and its eight neighbours; by symmetry
/// half of the couplings are kept. Entries of the rim are zero, except for ones on the diagonal.
#[derive(Clone, Debug)]
pub(super) struct Level {
    pub(super) grid: Grid,
    /// Length of a row of a field.
    pub(super) m: usize,
    pub(super) diagonal: Field,
    /// Couplings with `(i, j + 1)`, `(i + 1, j)`, `(i + 1, j + 1)`, `(i + 1, j − 1)`. The last two are
    /// empty for a five-point matrix.
    pub(super) east: Field,
    pub(super) south: Field,
    pub(super) south_east: Field,
    pub(super) south_west: Field,
    /// Nodes that are coupled with others: only these see the coarser grid.
    pub(super) coupled: Vec<bool>,
}

impl Level {
    pub(super) fn new(grid: Grid, nine_points: bool) -> Self {
        let m = grid.columns + 2;
        let size = m * (grid.rows + 2);
        let field = || vec![0.0; size];
        let diagonals = || if nine_points { field() } else { Vec::new() };
        Level {
            grid,
            m,
            diagonal: field(),
            east: field(),
            south: field(),
            south_east: diagonals(),
            south_west: diagonals(),
            coupled: vec![false; size],
        }
    }

    /// Length of a field.
    pub(super) fn size(&self) -> usize {
        self.diagonal.len()
    }

    fn has_nine_points(&self) -> bool {
        !self.south_east.is_empty()
    }

    /// Where the nodes of row `i`, counted from 1, stand in a field.
    fn row(&self, i: usize) -> std::ops::Range<usize> {
        i * self.m + 1..i * self.m + 1 + self.grid.columns
    }

    /// All entries zero.
    pub(super) fn clear(&mut self) {
        for list in [
            &mut self.diagonal,
            &mut self.east,
            &mut self.south,
            &mut self.south_east,
            &mut self.south_west,
        ] {
            list.fill(0.0);
        }
    }

    /// Cuts the couplings with the rim, sees which nodes are coupled at all, and gives those that are
    /// coupled with nothing, not even themselves, the row of the identity.
    pub(super) fn close(&mut self) {
        let (m, rows, columns) = (self.m, self.grid.rows, self.grid.columns);
        for i in 0..rows + 2 {
            for q in [i * m, i * m + columns, i * m + columns + 1] {
                self.east[q] = 0.0;
            }
            self.south[i * m] = 0.0;
            self.south[i * m + columns + 1] = 0.0;
        }
        for i in [0, rows, rows + 1] {
            self.south[i * m..(i + 1) * m].fill(0.0);
        }
        for i in [0, rows + 1] {
            self.east[i * m..(i + 1) * m].fill(0.0);
        }
        if self.has_nine_points() {
            for i in 0..rows + 2 {
                for q in [i * m, i * m + columns, i * m + columns + 1] {
                    self.south_east[q] = 0.0;
                }
                for q in [i * m, i * m + 1, i * m + columns + 1] {
                    self.south_west[q] = 0.0;
                }
            }
            for i in [0, rows, rows + 1] {
                self.south_east[i * m..(i + 1) * m].fill(0.0);
                self.south_west[i * m..(i + 1) * m].fill(0.0);
            }
        }
        for i in 0..rows + 2 {
            for q in [i * m, i * m + columns + 1] {
                self.diagonal[q] = 1.0;
            }
        }
        for i in [0, rows + 1] {
            self.diagonal[i * m..(i + 1) * m].fill(1.0);
        }
        for i in 1..=rows {
            for q in self.row(i) {
                let near = [self.east[q], self.east[q - 1], self.south[q], self.south[q - m]];
                let mut is_coupled = near.iter().any(|a| *a != 0.0);
                if self.has_nine_points() {
                    let far = [
                        self.south_east[q],
                        self.south_east[q - m - 1],
                        self.south_west[q],
                        self.south_west[q - m + 1],
                    ];
                    is_coupled |= far.iter().any(|a| *a != 0.0);
                }
                self.coupled[q] = is_coupled;
                if !is_coupled && self.diagonal[q] == 0.0 {
                    self.diagonal[q] = 1.0;
                }
            }
        }
    }

    /// A node without a positive diagonal entry, as it stands in a field.
    pub(super) fn not_positive(&self) -> Option<usize> {
        (1..=self.grid.rows).flat_map(|i| self.row(i)).find(|&q| !(self.diagonal[q] > 0.0))
    }

    /// `image ← A x` inside the rim.
    pub(super) fn apply(&self, x: &[f64], image: &mut [f64]) {
        let (m, nine) = (self.m, self.has_nine_points());
        for i in 1..=self.grid.rows {
            let row = self.row(i);
            let (start, columns) = (row.start, self.grid.columns);
            let here = &x[start - 1..=start + columns];
            let above = &x[start - m - 1..=start - m + columns];
            let below = &x[start + m - 1..=start + m + columns];
            let diagonal = &self.diagonal[row.clone()];
            let east = &self.east[start - 1..start + columns];
            let (south, north) =
                (&self.south[row.clone()], &self.south[start - m..start - m + columns]);
            let out = &mut image[row.clone()];
            for j in 0..columns {
                out[j] = diagonal[j] * here[j + 1]
                    + east[j + 1] * here[j + 2]
                    + east[j] * here[j]
                    + south[j] * below[j + 1]
                    + north[j] * above[j + 1];
            }
            if nine {
                let south_east = &self.south_east[row.clone()];
                let north_west = &self.south_east[start - m - 1..start - m - 1 + columns];
                let south_west = &self.south_west[row];
                let north_east = &self.south_west[start - m + 1..start - m + 1 + columns];
                for j in 0..columns {
                    out[j] += south_east[j] * below[j + 2]
                        + north_west[j] * above[j]
                        + south_west[j] * below[j]
                        + north_east[j] * above[j + 2];
                }
            }
        }
    }

    /// A Gauss–Seidel sweep on `A x = b`: forwards or backwards. `r` is memory for a row.
    pub(super) fn smooth(&self, b: &[f64], x: &mut [f64], r: &mut [f64], forwards: bool) {
        let rows = self.grid.rows;
        let right = &mut r[..self.grid.columns];
        for k in 1..=rows {
            self.smooth_row(if forwards { k } else { rows + 1 - k }, b, x, right, forwards);
        }
    }

    fn smooth_row(&self, i: usize, b: &[f64], x: &mut [f64], right: &mut [f64], forwards: bool) {
        let (m, row) = (self.m, self.row(i));
        let (start, columns) = (row.start, self.grid.columns);
        // What the rows above and below and b say does not wait for the neighbour in the row.
        let (before, rest) = x.split_at_mut(start - 1);
        let (here, after) = rest.split_at_mut(m);
        let above = &before[start - m - 1..];
        let b = &b[row.clone()];
        let (south, north) =
            (&self.south[row.clone()], &self.south[start - m..start - m + columns]);
        for j in 0..columns {
            right[j] = b[j] - south[j] * after[j + 1] - north[j] * above[j + 1];
        }
        if !self.south_east.is_empty() {
            let south_east = &self.south_east[row.clone()];
            let north_west = &self.south_east[start - m - 1..start - m - 1 + columns];
            let south_west = &self.south_west[row.clone()];
            let north_east = &self.south_west[start - m + 1..start - m + 1 + columns];
            for j in 0..columns {
                right[j] -= south_east[j] * after[j + 2]
                    + north_west[j] * above[j]
                    + south_west[j] * after[j]
                    + north_east[j] * above[j + 2];
            }
        }
        let east = &self.east[start - 1..start + columns];
        let diagonal = &self.diagonal[row];
        if forwards {
            for j in 0..columns {
                let inverse = diagonal[j].recip();
                here[j + 1] = (right[j] - east[j + 1] * here[j + 2] - east[j] * here[j]) * inverse;
            }
        } else {
            for j in (0..columns).rev() {
                let inverse = diagonal[j].recip();
                here[j + 1] = (right[j] - east[j] * here[j] - east[j + 1] * here[j + 2]) * inverse;
            }
        }
    }

    /// `r ← b − A x` inside the rim.
    pub(super) fn residual(&self, b: &[f64], x: &[f64], r: &mut [f64]) {
        self.apply(x, r);
        for i in 1..=self.grid.rows {
            let row = self.row(i);
            for (r, b) in r[row.clone()].iter_mut().zip(&b[row]) {
                *r = b - *r;
            }
        }
    }

    /// `b` of the coarser level: `Pᵀ r`.
    pub(super) fn restrict(&self, r: &[f64], coarse: &Level, b: &mut [f64]) {
        b.fill(0.0);
        self.for_each_pair(coarse.grid, |q, i, j, share, m| b[i * m + j] += share * r[q]);
        coarse.clear_rim(b);
    }

    /// `x ← x + P x` of the coarser level.
    pub(super) fn correct(&self, x: &mut [f64], coarse: &Level, of_coarse: &[f64]) {
        self.for_each_pair(coarse.grid, |q, i, j, share, m| x[q] += share * of_coarse[i * m + j]);
    }

    /// Every coupled node `q` with each coarse node `(i, j)`, counted from 1, that it is interpolated
    /// from, the share, and the length of a coarse row.
    fn for_each_pair(&self, coarse: Grid, mut with: impl FnMut(usize, usize, usize, f64, usize)) {
        let m = coarse.columns + 2;
        for i in 0..self.grid.rows {
            let down = parents(i, self.grid.rows, coarse.rows);
            for (j, q) in self.row(i + 1).enumerate() {
                if !self.coupled[q] {
                    continue;
                }
                let across = parents(j, self.grid.columns, coarse.columns);
                for_each_share(down, across, |row, column, share| with(q, row, column, share, m));
            }
        }
    }

    fn clear_rim(&self, field: &mut [f64]) {
        let (m, rows, columns) = (self.m, self.grid.rows, self.grid.columns);
        for i in 0..rows + 2 {
            field[i * m] = 0.0;
            field[i * m + columns + 1] = 0.0;
        }
        for i in [0, rows + 1] {
            field[i * m..(i + 1) * m].fill(0.0);
        }
    }
}

/// The coarse nodes of a fine one and its shares of them.
#[inline]
pub(super) fn for_each_share(
    down: Parents,
    across: Parents,
    mut with: impl FnMut(usize, usize, f64),
) {
    for a in 0..2 {
        for b in 0..2 {
            let share = down.shares[a] * across.shares[b];
            if share != 0.0 {
                with(down.first + a, across.first + b, share);
            }
        }
    }
}
