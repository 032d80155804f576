//! P-matrices on which the plain Newton method of the min map cycles ([BG12], references in
//! `mcp_core`).

use crate::case::Case;
use crate::common::{NONNEGATIVE, affine};
use mcp_core::Problem;

/// `M = I + 2 P` with the cyclic shift `P`: a P-matrix for odd `n`.
fn cyclic(n: usize) -> Vec<Vec<f64>> {
    let entry = |i: usize, j: usize| match () {
        () if i == j => 1.0,
        () if (j + 1) % n == i => 2.0,
        () => 0.0,
    };
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

fn cyclic_problem(n: usize, q: f64) -> impl Problem + use<> {
    affine(cyclic(n), vec![q; n], &vec![NONNEGATIVE; n], &vec![0.0; n])
}

pub(crate) fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for n in [3, 5, 7, 15] {
        for q in [1.0, -1.0] {
            let solution = if q > 0.0 { vec![0.0; n] } else { vec![1.0 / 3.0; n] };
            let mut start = vec![0.0; n];
            start[0] = -q;
            let name = format!("cyclic of order {n}, q = {q}");
            cases.push(Case::at(name, cyclic_problem(n, q), &start, &solution));
        }
    }
    cases
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cycling_problems_are_solved() {
        crate::check::check_all(cases());
    }

    /// One step: `z_i = 0` where `z_i <= F_i`, and `F_i = 0` elsewhere. With at most two rows in the
    /// second set the equations of order 3 can be solved by hand.
    fn plain_step(z: [f64; 3], q: f64) -> [f64; 3] {
        let m = cyclic(3);
        let f: [f64; 3] = std::array::from_fn(|i| q + (0..3).map(|j| m[i][j] * z[j]).sum::<f64>());
        let is_free = |i: usize| z[i] > f[i];
        let mut next = [0.0; 3];
        // F_i = z_i + 2 z_{i−1} + q: forward from the first row after a fixed one.
        let first = (0..3).find(|&i| !is_free(i)).expect("some row is at its bound");
        for i in (first + 1..first + 3).map(|i| i % 3) {
            next[i] = if is_free(i) { -q - 2.0 * next[(i + 2) % 3] } else { 0.0 };
        }
        next
    }

    #[test]
    fn the_plain_method_cycles_after_three_steps() {
        let mut path = vec![[-1.0, 0.0, 0.0]];
        for _ in 0..6 {
            path.push(plain_step(path[path.len() - 1], 1.0));
        }
        assert_eq!(path[..3], path[3..6], "{path:?}");
        assert!(path.iter().all(|z| z.iter().any(|z| *z != 0.0)), "0 is the solution: {path:?}");
    }
}
