//! What every linear solver must do, checked on all of them.

mod matrices;

use super::*;
use matrices::{Matrix, Random};

/// Every solver that takes this order.
fn solvers(n: usize) -> Vec<Box<dyn LinearSolver>> {
    let pattern = Pattern::dense(n);
    Linear::ALL.into_iter().filter_map(|choice| choice.solver_for(&pattern).ok()).collect()
}

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

/// `x ← H⁻¹ x`, or `x ← H⁻ᵀ x` for `back`.
fn solve(solver: &mut dyn LinearSolver, x: &mut [f64], back: bool) {
    if back {
        solver.solve_transposed(x);
    } else {
        solver.solve(x);
    }
}

/// Normwise backward stability of one solve: `|H x - b| <= 8 n eps (n max|H|) |x|`, with room for
/// a moderate growth of the pivots (\[GV13\] section 3.4).
fn assert_solved(solver: &dyn LinearSolver, matrix: &Matrix, x: &[f64], b: &[f64], back: bool) {
    let n = matrix.n() as f64;
    let product = matrix.times(x, back);
    let bound = 8.0 * n * f64::EPSILON * n * matrix.largest() * largest(x);
    for (i, (left, right)) in product.iter().zip(b).enumerate() {
        let residual = (left - right).abs();
        assert!(residual <= bound, "{} row {i}: {residual:e} > {bound:e}", solver.name());
    }
}

/// Factors and solves both ways.
fn check(solver: &mut dyn LinearSolver, matrix: &Matrix) -> FactorInfo {
    solver.analyse(&matrix.pattern).unwrap();
    let info = solver.factor(&matrix.values).unwrap_or_else(|e| panic!("{}: {e}", solver.name()));
    let b: Vec<f64> = (0..matrix.n()).map(|i| 1.0 - (i % 7) as f64 * 0.3).collect();
    for back in [false, true] {
        let mut x = b.clone();
        solve(solver, &mut x, back);
        assert_solved(solver, matrix, &x, &b, back);
    }
    info
}

fn check_all(matrix: &Matrix) {
    for mut solver in solvers(matrix.n()) {
        let info = check(&mut *solver, matrix);
        assert!(info.pivot_ratio > 0.0 && info.pivot_ratio <= 1.0, "{}", solver.name());
    }
}

fn assert_singular(matrix: &Matrix, column: impl Fn(usize) -> bool) {
    for mut solver in solvers(matrix.n()) {
        solver.analyse(&matrix.pattern).unwrap();
        match solver.factor(&matrix.values) {
            Err(LinearError::Singular { column: found }) => {
                assert!(column(found), "{}: column {found}", solver.name());
            }
            other => panic!("{}: {other:?}", solver.name()),
        }
    }
}

#[test]
fn the_matrix_of_order_zero_is_regular() {
    for mut solver in solvers(0) {
        solver.analyse(&Pattern::dense(0)).unwrap();
        assert_eq!(solver.factor(&[]), Ok(FactorInfo::new(1.0)), "{}", solver.name());
        solver.solve(&mut []);
        solver.solve_transposed(&mut []);
    }
}

#[test]
fn one_equation_is_a_division() {
    for mut solver in solvers(1) {
        solver.analyse(&Pattern::dense(1)).unwrap();
        assert_eq!(solver.factor(&[-4.0]), Ok(FactorInfo::new(1.0)), "{}", solver.name());
        let mut x = [2.0];
        solver.solve(&mut x);
        solver.solve_transposed(&mut x);
        assert!((x[0] - 0.125).abs() < f64::EPSILON);
        assert_eq!(solver.factor(&[0.0]), Err(LinearError::Singular { column: 0 }));
    }
}

#[test]
fn dense_systems_of_every_small_order_are_solved_both_ways() {
    let mut random = Random(1);
    for n in (1..=33).chain([64, 101, 150]) {
        check_all(&Matrix::dense(n, |_, _| random.sign()));
    }
}

#[test]
fn sparse_systems_are_solved_both_ways() {
    let mut random = Random(2);
    for n in (1..40).chain([90, 150, 220]) {
        let mut matrix = Matrix::sparse(n, &mut random);
        for j in 0..n {
            let diagonal = matrix.pattern.position(j, j).unwrap();
            matrix.values[diagonal] += 2.0;
        }
        check_all(&matrix);
    }
    for k in [1, 2, 5, 12] {
        check_all(&Matrix::grid(k));
    }
}

#[test]
fn the_larger_grids_with_supernodal_factors_are_solved_both_ways() {
    let matrix = Matrix::grid(60);
    check(&mut FaerSparseLu::new(), &matrix);
}

#[test]
fn permutation_matrices_are_solved_exactly() {
    for n in [1, 2, 3, 4, 7, 13, 16, 17, 101, 128] {
        let matrix = Matrix::permutation(n);
        let b: Vec<f64> = (0..n).map(|i| i as f64 + 0.5).collect();
        for mut solver in solvers(n) {
            solver.analyse(&matrix.pattern).unwrap();
            assert_eq!(solver.factor(&matrix.values).map(|_| ()), Ok(()), "{}", solver.name());
            for back in [false, true] {
                let mut x = matrix.times(&b, back);
                solve(&mut *solver, &mut x, back);
                assert_eq!(x, b, "{} n = {n}", solver.name());
            }
        }
    }
}

#[test]
fn badly_scaled_rows_do_not_spoil_the_normwise_backward_error() {
    let mut random = Random(3);
    for n in [2, 5, 8, 15, 40, 120] {
        let scale = |i: usize| [1.0, 1e-9, 1e7, 1e-3][i % 4];
        check_all(&Matrix::dense(n, |i, _| scale(i) * random.sign()));
    }
}

#[test]
fn the_hilbert_matrix_has_a_small_backward_error_and_a_small_pivot_ratio() {
    let matrix = Matrix::dense(8, |i, j| 1.0 / (i + j + 1) as f64);
    for mut solver in solvers(8) {
        let info = check(&mut *solver, &matrix);
        assert!(info.pivot_ratio < 1e-7, "{} {info:?}", solver.name());
    }
}

#[test]
fn a_zero_column_is_singular_and_named() {
    let mut random = Random(4);
    for n in [1, 2, 4, 9, 16, 50, 130] {
        let zero = n / 2;
        let entry = |_, j| if j == zero { 0.0 } else { random.sign() };
        assert_singular(&Matrix::dense(n, entry), |column| column == zero);
    }
}

#[test]
fn structurally_empty_columns_and_rows_are_singular() {
    for n in [1, 3, 16, 130] {
        let columns = (0..n).map(|j| if j == n / 3 { vec![] } else { vec![j] });
        assert_singular(&Matrix::new(Pattern::from_columns(columns), |_, _| 1.0), |c| c == n / 3);
        let rows: Vec<_> = (0..n).map(|i| if i == 0 { vec![] } else { (0..n).collect() }).collect();
        let matrix = Matrix::new(Pattern::from_rows(&rows), |i, j| f64::from(u8::from(j + 1 == i)));
        assert_singular(&matrix, |column| column < n);
    }
}

#[test]
fn duplicated_rows_are_singular() {
    for n in [2, 3, 6, 15, 30, 110] {
        let matrix = Matrix::dense(n, |i, j| {
            let i = if i == n - 1 { 0 } else { i };
            if i == j { 4.0 } else { f64::from(u8::try_from((i * j) % 2).unwrap_or(0)) / 8.0 }
        });
        for mut solver in solvers(n) {
            solver.analyse(&matrix.pattern).unwrap();
            match solver.factor(&matrix.values) {
                Err(LinearError::Singular { column }) => assert!(column < n),
                Ok(info) => assert!(info.pivot_ratio < 1e-14, "{} {info:?}", solver.name()),
                other => panic!("{}: {other:?}", solver.name()),
            }
        }
    }
}

#[test]
fn large_singular_grids_are_found_out() {
    // Pure differences around a ring of 2 000 nodes, each with far neighbours: rows sum to zero.
    let n = 2_000;
    let rows: Vec<_> =
        (0..n).map(|i| vec![i, (i + 1) % n, (i + 37) % n, (i * i + 5) % n]).collect();
    let pattern = Pattern::from_rows(&rows);
    let mut matrix = Matrix::new(pattern, |i, j| if i == j { 0.0 } else { -1.0 });
    for j in 0..n {
        let off = matrix.times(&vec![1.0; n], false);
        let k = matrix.pattern.position(j, j).unwrap();
        matrix.values[k] = -off[j];
    }
    let mut solver = FaerSparseLu::new();
    solver.analyse(&matrix.pattern).unwrap();
    match solver.factor(&matrix.values) {
        Err(LinearError::Singular { column }) => assert!(column < n),
        Ok(info) => assert!(info.pivot_ratio < 1e-13, "{info:?}"),
        other => panic!("{other:?}"),
    }
    let zero = 777;
    for k in matrix.pattern.column(zero) {
        matrix.values[k] = 0.0;
    }
    let error = solver.factor(&matrix.values);
    assert_eq!(error, Err(LinearError::Singular { column: zero }));
}

#[test]
fn a_pivot_whose_reciprocal_overflows_counts_as_zero() {
    for n in [1, 2, 5, 16, 40, 120] {
        let entry = |i, j| match (i, j) {
            _ if i != j => 0.0,
            (0, 0) => 1e-310,
            _ => 1.0,
        };
        assert_singular(&Matrix::dense(n, entry), |column| column == 0);
        assert_singular(
            &Matrix::new(Pattern::from_columns((0..n).map(|j| vec![j])), entry),
            |column| column == 0,
        );
    }
}

#[test]
fn values_that_are_not_finite_are_refused_and_forgotten() {
    let mut random = Random(5);
    for n in [1, 2, 7, 16, 60, 120] {
        let matrix = Matrix::dense(n, |_, _| random.sign());
        for mut solver in solvers(n) {
            solver.analyse(&matrix.pattern).unwrap();
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut values = matrix.values.clone();
                values[n * n / 2] = bad;
                assert_eq!(solver.factor(&values), Err(LinearError::NotFinite));
            }
            check(&mut *solver, &matrix);
        }
    }
}

#[test]
fn factors_that_overflow_are_refused() {
    for n in [2, 9, 16, 40, 120] {
        // The second pivot would be MAX + MAX.
        let matrix = Matrix::dense(n, |i, j| match (i, j) {
            (0 | 1, 1) => f64::MAX,
            (1, 0) => -1.0,
            _ if i == j => 1.0,
            _ => 0.0,
        });
        for mut solver in solvers(n) {
            solver.analyse(&matrix.pattern).unwrap();
            let answer = solver.factor(&matrix.values);
            if answer.is_ok() {
                // Another order of the columns avoids the overflow: then the answer must be right.
                let mut x = vec![1.0; n];
                solver.solve(&mut x);
                assert!(x.iter().all(|value| value.is_finite()), "{}", solver.name());
            } else {
                assert_eq!(answer, Err(LinearError::NotFinite), "{}", solver.name());
            }
        }
    }
}

#[test]
fn new_values_and_new_patterns_replace_the_old_ones() {
    let mut random = Random(6);
    for n in [3, 12, 16, 43, 142] {
        let dense = Matrix::dense(n, |_, _| random.sign());
        let same_pattern = Matrix::dense(n, |_, _| random.sign());
        let smaller = Matrix::dense(1, |_, _| 3.0);
        let permutation = Matrix::permutation(n);
        for mut solver in solvers(n) {
            for matrix in [&dense, &same_pattern, &smaller, &dense, &permutation, &dense] {
                check(&mut *solver, matrix);
            }
        }
    }
}

#[test]
fn a_singular_matrix_does_not_spoil_the_next_one() {
    let mut random = Random(7);
    for n in [2, 10, 16, 50, 130] {
        let regular = Matrix::dense(n, |_, _| random.sign());
        let singular = Matrix::dense(n, |i, _| if i == 0 { 0.0 } else { 1.0 });
        for mut solver in solvers(n) {
            solver.analyse(&regular.pattern).unwrap();
            assert!(matches!(solver.factor(&singular.values), Err(LinearError::Singular { .. })));
            check(&mut *solver, &regular);
        }
    }
}

#[test]
fn all_solvers_agree() {
    let mut random = Random(8);
    for n in [2, 3, 4, 8, 15, 30, 110] {
        let diagonal = n as f64;
        let matrix = Matrix::dense(n, |i, j| if i == j { diagonal } else { random.sign() });
        let answers: Vec<Vec<f64>> = solvers(n)
            .iter_mut()
            .map(|solver| {
                let mut x: Vec<f64> = (0..n).map(|i| (i + 1) as f64).collect();
                solver.analyse(&matrix.pattern).unwrap();
                solver.factor(&matrix.values).unwrap();
                solver.solve(&mut x);
                solver.solve_transposed(&mut x);
                x
            })
            .collect();
        for answer in &answers {
            for (x, y) in answer.iter().zip(&answers[0]) {
                assert!((x - y).abs() <= 1e-13 * largest(answer), "n = {n}: {x} {y}");
            }
        }
    }
}

#[test]
fn random_patterns_never_give_a_panic_or_a_false_answer() {
    let mut random = Random(9);
    let mut singular = 0;
    for case in 0..3_000 {
        let n = 1 + random.below(24);
        let most = 1 + case % 4;
        let columns = (0..n).map(|_| {
            let count = random.below(most + 1);
            (0..count).map(|_| random.below(n)).collect()
        });
        let pattern = Pattern::from_columns(columns.collect::<Vec<_>>());
        // Small integers make exact cancellation frequent.
        let matrix = Matrix::new(pattern, |_, _| (4.0 * random.sign()).trunc());
        for mut solver in solvers(n) {
            solver.analyse(&matrix.pattern).unwrap();
            match solver.factor(&matrix.values) {
                Ok(info) if info.pivot_ratio > 1e-12 => drop(check(&mut *solver, &matrix)),
                Ok(_) => {}
                Err(LinearError::Singular { column }) => {
                    assert!(column < n);
                    singular += 1;
                }
                Err(other) => panic!("{}: {other}", solver.name()),
            }
        }
    }
    assert!(singular > 1_000, "only {singular} singular cases");
}
