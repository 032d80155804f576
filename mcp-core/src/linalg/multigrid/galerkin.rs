//! The matrix of the next coarser grid: `Pᵀ A P`, with `P` zero at nodes that are coupled with nothing.
//!
//! Such nodes are variables whose value is known; a coarse function that reached into them would be no
//! direction of the reduced problem. This truncation is that of monotone multigrid methods
//! ([Kor94](crate#references)).

use super::grid::parents;
use super::level::{Level, for_each_share};

impl Level {
    /// Computes the entries of the coarser level.
    pub(super) fn coarsen(&self, coarse: &mut Level) {
        coarse.clear();
        for i in 0..self.grid.rows {
            for j in 0..self.grid.columns {
                let q = (i + 1) * self.m + j + 1;
                if !self.coupled[q] {
                    continue;
                }
                self.add(coarse, (i, j), (i, j), self.diagonal[q]);
                self.add_both(coarse, (i, j), (0, 1), self.east[q]);
                self.add_both(coarse, (i, j), (1, 0), self.south[q]);
                if !self.south_east.is_empty() {
                    self.add_both(coarse, (i, j), (1, 1), self.south_east[q]);
                    self.add_both(coarse, (i, j), (1, -1), self.south_west[q]);
                }
            }
        }
        coarse.close();
    }

    /// The entry of `p` and its neighbour at an offset, and of the neighbour and `p`.
    fn add_both(&self, coarse: &mut Level, p: (usize, usize), offset: (usize, isize), entry: f64) {
        if entry != 0.0 {
            let neighbour = (p.0 + offset.0, p.1.wrapping_add_signed(offset.1));
            self.add(coarse, p, neighbour, entry);
            self.add(coarse, neighbour, p, entry);
        }
    }

    /// `A_pq` times the shares of `p` and `q`, where the coarse level keeps it.
    #[inline]
    fn add(&self, coarse: &mut Level, p: (usize, usize), q: (usize, usize), entry: f64) {
        let of = |(i, j): (usize, usize)| {
            (
                parents(i, self.grid.rows, coarse.grid.rows),
                parents(j, self.grid.columns, coarse.grid.columns),
            )
        };
        let (from, to) = (of(p), of(q));
        let m = coarse.m;
        for_each_share(from.0, from.1, |i, j, share| {
            let place = i * m + j;
            let weighed = share * entry;
            for_each_share(to.0, to.1, |k, l, share| {
                let value = weighed * share;
                if k == i && l == j {
                    coarse.diagonal[place] += value;
                } else if k == i && l == j + 1 {
                    coarse.east[place] += value;
                } else if k == i + 1 && l == j {
                    coarse.south[place] += value;
                } else if k == i + 1 && l == j + 1 {
                    coarse.south_east[place] += value;
                } else if k == i + 1 && l + 1 == j {
                    coarse.south_west[place] += value;
                }
            });
        });
    }
}
