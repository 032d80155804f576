//! How badly conditioned a matrix is, from its factors alone: [Hig88](crate#references) algorithm 4.1,
//! [GV13] section 3.5.4.
//!
//! ```text
//! ‖H⁻¹‖₁ = max ‖H⁻¹ x‖₁ over ‖x‖₁ <= 1, at a corner x = e_j of the ball
//! x = (1/n, …, 1/n);  y = H⁻¹ x;  v = H⁻ᵀ sign(y), a subgradient of ‖H⁻¹ x‖₁ by x
//! go to the corner of the largest |v_j| while that promises more, ‖v‖∞ > vᵀ x, at most five times
//! b_j = (−1)^j (1 + j / (n − 1)) as well: 2 ‖H⁻¹ b‖₁ / 3n, where the walk was misled
//! ```
//!
//! \[GV13\]: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., 2013.

use super::LinearSolver;
use crate::problem::Pattern;

/// Corners visited at most.
const CORNERS: usize = 5;

/// `‖H‖₁`, the largest sum of a column.
pub(super) fn norm_1(pattern: &Pattern, values: &[f64]) -> f64 {
    (0..pattern.n()).map(|j| sum(&values[pattern.column(j)])).fold(0.0, f64::max)
}

/// A lower bound of `‖H⁻¹‖₁` for the matrix of order `n` factored last.
pub(super) fn norm_1_of_inverse(linear: &mut (impl LinearSolver + ?Sized), n: usize) -> f64 {
    if n == 0 {
        return 0.0;
    }
    let mut y = vec![(n as f64).recip(); n];
    linear.solve(&mut y);
    let mut estimate = sum(&y);
    let mut corner = None;
    let mut signs = Vec::new();
    for _ in 0..CORNERS {
        let new_signs: Vec<bool> = y.iter().map(|y| y.is_sign_negative()).collect();
        if new_signs == signs {
            break;
        }
        signs = new_signs;
        let mut v: Vec<f64> = signs.iter().map(|&minus| if minus { -1.0 } else { 1.0 }).collect();
        linear.solve_transposed(&mut v);
        let largest = (0..n).fold(0, |k, j| if v[j].abs() > v[k].abs() { j } else { k });
        let at_x = corner.map_or_else(|| v.iter().sum::<f64>() / n as f64, |j: usize| v[j]);
        if v[largest].abs() <= at_x {
            break;
        }
        corner = Some(largest);
        y.fill(0.0);
        y[largest] = 1.0;
        linear.solve(&mut y);
        let next = sum(&y);
        if next <= estimate {
            break;
        }
        estimate = next;
    }
    for (j, y) in y.iter_mut().enumerate() {
        let size = 1.0 + j as f64 / (n.max(2) - 1) as f64;
        *y = if j % 2 == 0 { size } else { -size };
    }
    linear.solve(&mut y);
    estimate = estimate.max(2.0 * sum(&y) / (3.0 * n as f64));
    if estimate.is_finite() { estimate } else { f64::INFINITY }
}

fn sum(values: &[f64]) -> f64 {
    values.iter().map(|value| value.abs()).sum()
}

#[cfg(test)]
#[path = "condition_tests.rs"]
mod tests;
