//! [`Grid`]: nodes of a rectangle, and how functions on it become coarser and finer.

use crate::error::ModelError;

/// `rows × columns` inner nodes of a rectangle, node `(i, j)` numbered `i · columns + j`, between rims
/// where values are known.
///
/// The next coarser grid has every second node of a direction with more than three: nodes `1, 3, 5, …`
/// counted from 0. Between them functions are interpolated linearly in each direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Nodes along the first index.
    pub rows: usize,
    /// Nodes along the second index.
    pub columns: usize,
}

/// The coarse nodes beside a fine one, counted from 1 so that 0 and one beyond the last are the rim, and
/// their shares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Parents {
    pub(super) first: usize,
    pub(super) shares: [f64; 2],
}

/// Nodes of a direction up to which it is not made coarser.
const FEW: usize = 3;

impl Grid {
    /// A grid of so many nodes.
    pub fn new(rows: usize, columns: usize) -> Self {
        Grid { rows, columns }
    }

    /// `k × k` nodes.
    pub fn square(k: usize) -> Self {
        Grid::new(k, k)
    }

    /// Number of nodes.
    pub fn n(self) -> usize {
        self.rows * self.columns
    }

    /// The next coarser grid; `None` if there is none.
    #[must_use]
    pub fn coarser(self) -> Option<Grid> {
        let halved = |k: usize| if k > FEW { k / 2 } else { k };
        let coarse = Grid::new(halved(self.rows), halved(self.columns));
        (coarse != self).then_some(coarse)
    }

    /// Values on this grid from those on another one of the same rectangle, interpolated linearly in each
    /// direction; on the rim the function is `rim`. Nodes are equally spaced: node `i` of `m` lies at the
    /// share `(i + 1)/(m + 1)` of the side.
    ///
    /// # Errors
    /// [`ModelError::Length`] unless there is one value for each node of the other grid.
    ///
    /// ```
    /// use mcp_core::Grid;
    /// let fine = Grid::new(1, 5).interpolate(&[2.0, 4.0], Grid::new(1, 2), 0.0)?;
    /// assert_eq!(fine, [1.0, 2.0, 3.0, 4.0, 2.0]);
    /// # Ok::<(), mcp_core::ModelError>(())
    /// ```
    pub fn interpolate(self, values: &[f64], from: Grid, rim: f64) -> Result<Vec<f64>, ModelError> {
        if values.len() != from.n() {
            let what = "values on the other grid".to_owned();
            return Err(ModelError::Length { what, expected: from.n(), found: values.len() });
        }
        // Counted from 1: 0 and one beyond the last are the rim.
        let at = |i: usize, j: usize| {
            let inside = (1..=from.rows).contains(&i) && (1..=from.columns).contains(&j);
            if inside { values[(i - 1) * from.columns + j - 1] } else { rim }
        };
        let across: Vec<(usize, f64)> =
            (0..self.columns).map(|j| place(j, self.columns, from.columns)).collect();
        let mut interpolated = Vec::with_capacity(self.n());
        for i in 0..self.rows {
            let (row, s) = place(i, self.rows, from.rows);
            for &(column, t) in &across {
                let along = |row| (1.0 - t) * at(row, column) + t * at(row, column + 1);
                interpolated.push((1.0 - s) * along(row) + s * along(row + 1));
            }
        }
        Ok(interpolated)
    }
}

/// The node of another grid, counted from 1, at or before node `i` of `nodes`, and how far beyond it, as a
/// share of its spacing.
fn place(i: usize, nodes: usize, other: usize) -> (usize, f64) {
    let (product, spaces) = ((i + 1) * (other + 1), nodes + 1);
    (product / spaces, (product % spaces) as f64 / spaces as f64)
}

/// The parents of node `i` of `fine` in a direction with `coarse` nodes on the coarser grid.
pub(super) fn parents(i: usize, fine: usize, coarse: usize) -> Parents {
    if fine == coarse {
        Parents { first: i + 1, shares: [1.0, 0.0] }
    } else if i % 2 == 1 {
        Parents { first: i.div_ceil(2), shares: [1.0, 0.0] }
    } else {
        Parents { first: i / 2, shares: [0.5, 0.5] }
    }
}
