//! `F` and its derivatives over boxes.

use crate::model::Model;
use crate::problem::{AdProblem, Problem};
use crate::scalar::{Interval, Jet, Real, Scalar};

/// Eight columns of `G` at a time: every row is compiled in this one arithmetic for a proof.
type Lanes = Jet<8, Interval>;

/// A problem that can be evaluated over boxes, whatever its model.
pub(super) trait OverBoxes: Problem {
    /// Contains `F(x)` for all `x` in the box, in the order of the variables (0 where a fixed variable
    /// has no equation), and `∂F_i/∂x_j` for all pairs `i`, `j` of `active`, row by row.
    fn over(&self, x: &[Interval], active: &[usize]) -> (Vec<Interval>, Vec<Interval>);
}

impl<M: Model> OverBoxes for AdProblem<M> {
    fn over(&self, x: &[Interval], active: &[usize]) -> (Vec<Interval>, Vec<Interval>) {
        let (shape, m) = (self.shape(), active.len());
        let mut f = vec![Interval::point(0.0); x.len()];
        let mut slopes = vec![Interval::point(0.0); m * m];
        let mut lane_of = vec![usize::MAX; x.len()];
        for first in (0..m.max(1)).step_by(Lanes::LANES) {
            let here = first..m.min(first + Lanes::LANES);
            for k in here.clone() {
                lane_of[active[k]] = k - first;
            }
            let variable = |(&x, &lane)| Real(Lanes::variable(x, lane));
            let x: Vec<Real<Lanes>> = x.iter().zip(&lane_of).map(variable).collect();
            let rows = self.rows_at(&x);
            for (row, value) in rows.iter().enumerate() {
                f[shape.variable_of_row(row)] = value.0.v;
            }
            for (i, row) in active.iter().map(|&i| shape.row_of_variable(i)).enumerate() {
                for k in here.clone() {
                    let zero = Interval::point(0.0);
                    slopes[i * m + k] = row.map_or(zero, |row| rows[row].0.d[k - first]);
                }
            }
            for k in here {
                lane_of[active[k]] = usize::MAX;
            }
        }
        (f, slopes)
    }
}
