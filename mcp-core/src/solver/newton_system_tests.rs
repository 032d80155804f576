use super::*;
use crate::solver::options::Method;

/// A chain of `n` springs, `2 d_i − d_(i−1) − d_(i+1)` and `shift d_i`; `skew` is added below the
/// diagonal.
fn chain(n: usize, shift: f64, skew: f64) -> (Pattern, Vec<f64>) {
    let rows: Vec<Vec<usize>> =
        (0..n).map(|i| (i.saturating_sub(1)..n.min(i + 2)).collect()).collect();
    let pattern = Pattern::from_rows(&rows);
    let entry = |i: usize, j: usize| match i.cmp(&j) {
        std::cmp::Ordering::Equal => 2.0 + shift,
        std::cmp::Ordering::Greater => skew - 1.0,
        std::cmp::Ordering::Less => -1.0,
    };
    let jac = pattern.entries().map(|(_, i, j)| entry(i, j)).collect();
    (pattern, jac)
}

fn system(pattern: &Pattern) -> NewtonSystem {
    NewtonSystem::new(pattern, &Options::new(Method::NewtonFb), &mut None).unwrap()
}

/// Rows of every kind: free, at a bound, between, and nearly at a bound.
fn rows_of(n: usize) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let a = (0..n).map(|i| [0.0, 1.0, 0.3, 1.0][i % 4]).collect();
    let b = (0..n).map(|i| [1.0, 0.0, 0.7, 1e-14][i % 4]).collect();
    let r = (0..n).map(|i| (0.37 * i as f64).sin()).collect();
    (a, b, r)
}

/// Largest `|H d + r|_i` relative to its terms.
fn backward_error(pattern: &Pattern, jac: &[f64], (a, b): Rows<'_>, r: &[f64], d: &[f64]) -> f64 {
    let mut residual: Vec<f64> = (0..d.len()).map(|i| r[i] + a[i] * d[i]).collect();
    let mut size: Vec<f64> = (0..d.len()).map(|i| r[i].abs() + (a[i] * d[i]).abs()).collect();
    for (k, i, j) in pattern.entries() {
        residual[i] += b[i] * jac[k] * d[j];
        size[i] += (b[i] * jac[k] * d[j]).abs();
    }
    residual.iter().zip(&size).map(|(r, s)| r.abs() / s).fold(0.0, f64::max)
}

#[test]
fn the_reduced_system_and_lu_have_the_same_solution() {
    // With 2 the two entries of a pair have different signs: `T J` is symmetric with signs in `T`.
    for skew in [0.0, 2.0] {
        let (pattern, jac) = chain(200, 0.1, skew);
        let (a, b, r) = rows_of(200);
        let (mut system, mut d) = (system(&pattern), vec![0.0; 200]);
        assert!(system.solve(&jac, &mut jac.clone(), (&a, &b), &r, &mut d));
        assert!(system.is_reduced);
        let error = backward_error(&pattern, &jac, (&a, &b), &r, &d);
        assert!(error <= BACKWARD, "{skew}: {error:e}");
    }
}

#[test]
fn a_matrix_without_symmetry_goes_to_lu() {
    let n = 200;
    // A ring that is wound in one direction: products around it differ.
    let rows: Vec<Vec<usize>> = (0..n).map(|i| vec![(i + n - 1) % n, i, (i + 1) % n]).collect();
    let pattern = Pattern::from_rows(&rows);
    let entry = |i: usize, j: usize| match (j + n - i) % n {
        0 => 3.0,
        1 => -1.2,
        _ => -0.7,
    };
    let jac: Vec<f64> = pattern.entries().map(|(_, i, j)| entry(i, j)).collect();
    let (a, b, r) = rows_of(n);
    let (mut system, mut d) = (system(&pattern), vec![0.0; n]);
    assert!(system.solve(&jac, &mut jac.clone(), (&a, &b), &r, &mut d));
    assert!(!system.is_reduced);
    assert!(backward_error(&pattern, &jac, (&a, &b), &r, &d) < 1e-13);
}

#[test]
fn a_zero_pivot_leaves_the_matrix_to_lu() {
    // Pairs [0 1; 1 0]: no factors without pivoting.
    let rows: Vec<Vec<usize>> = (0..200_usize).map(|i| vec![i ^ 1]).collect();
    let pattern = Pattern::from_rows(&rows);
    let (jac, a, b) = (vec![1.0; 200], vec![0.0; 200], vec![1.0; 200]);
    let r: Vec<f64> = (0..200).map(f64::from).collect();
    let (mut system, mut d) = (system(&pattern), vec![0.0; 200]);
    assert!(system.solve(&jac, &mut jac.clone(), (&a, &b), &r, &mut d));
    assert!(!system.is_reduced);
    assert!((0..200).all(|i: usize| d[i] == -r[i ^ 1]));
}

#[test]
fn known_variables_get_exactly_what_their_row_says() {
    let (pattern, jac) = chain(200, 0.1, 0.0);
    let (mut a, mut b, r) = rows_of(200);
    (a[5], b[5]) = (2.0, 0.0);
    let (mut system, mut d) = (system(&pattern), vec![0.0; 200]);
    assert!(system.solve(&jac, &mut jac.clone(), (&a, &b), &r, &mut d));
    assert_eq!(d[5], -r[5] / 2.0);
    assert_eq!(d[1], -r[1]);
}

#[test]
fn a_diagonal_that_j_lacks_is_added() {
    // J = [0 1; 1 0] in blocks, H = diag(a) + diag(b) J with a = 3.
    let rows: Vec<Vec<usize>> = (0..200).map(|i| vec![i ^ 1]).collect();
    let pattern = Pattern::from_rows(&rows);
    let (jac, a, b) = (vec![1.0; 200], vec![3.0; 200], vec![1.0; 200]);
    let r: Vec<f64> = (0..200).map(f64::from).collect();
    let (mut system, mut d) = (system(&pattern), vec![0.0; 200]);
    assert!(system.solve(&jac, &mut jac.clone(), (&a, &b), &r, &mut d));
    assert!(system.is_reduced);
    assert!(backward_error(&pattern, &jac, (&a, &b), &r, &d) < 1e-14);
}

#[test]
fn rows_in_units_of_their_own_do_not_hide_the_symmetry() {
    let (pattern, mut jac) = chain(200, 0.1, 0.0);
    for (k, i, j) in pattern.entries() {
        jac[k] *= [1.0, 3.0, 9.0, 0.2, 50.0][i % 5] * [1.0, 0.7, 2.1][j % 3];
    }
    let (a, b, r) = rows_of(200);
    let (mut system, mut d) = (system(&pattern), vec![0.0; 200]);
    assert!(system.solve(&jac, &mut jac.clone(), (&a, &b), &r, &mut d));
    assert!(system.is_reduced);
    assert!(backward_error(&pattern, &jac, (&a, &b), &r, &d) <= BACKWARD);
}
