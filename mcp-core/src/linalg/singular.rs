//! The direction that a matrix shrinks most.

use nalgebra::DMatrix;

/// The smallest singular value and its right singular vector, of norm 1; `None` for an empty matrix
/// or one that is not finite. Cost: one singular value decomposition.
pub(crate) fn smallest_singular(matrix: DMatrix<f64>) -> Option<(f64, Vec<f64>)> {
    if matrix.is_empty() || !matrix.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let svd = matrix.svd(false, true);
    let (smallest, &value) =
        svd.singular_values.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
    let right = svd.v_t?;
    Some((value, right.row(smallest).iter().copied().collect()))
}
