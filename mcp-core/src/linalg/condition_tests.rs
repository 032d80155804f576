use super::*;
use crate::generic::generic;
use crate::linalg::{FaerCholesky, FaerDenseLu, FaerSparseLu, NalgebraLu};
use nalgebra::DMatrix;

/// `‖H‖₁ ‖H⁻¹‖₁` from the inverse itself.
fn exact(h: &DMatrix<f64>) -> f64 {
    let norm = |m: &DMatrix<f64>| {
        m.column_iter().map(|column| column.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max)
    };
    norm(h) * norm(&h.clone().try_inverse().unwrap())
}

fn estimate(linear: &mut dyn LinearSolver, h: &DMatrix<f64>) -> f64 {
    let pattern = Pattern::dense(h.nrows());
    linear.analyse(&pattern).unwrap();
    linear.factor(h.as_slice()).unwrap();
    linear.condition(&pattern, h.as_slice())
}

#[test]
fn the_estimate_is_a_lower_bound_within_a_factor_of_five() {
    for n in [1, 2, 7, 30] {
        for seed in 0..20 {
            let entry = |i: usize, j: usize| generic(i * n + j + 1000 * seed) - 0.5;
            let h = DMatrix::from_fn(n, n, entry) + DMatrix::identity(n, n) * 0.1;
            let (exact, estimate) = (exact(&h), estimate(&mut NalgebraLu::new(), &h));
            assert!(estimate <= exact * (1.0 + 1e-9), "{n} {seed}: {estimate} > {exact}");
            assert!(estimate >= exact / 5.0, "{n} {seed}: {estimate} < {exact} / 5");
        }
    }
}

#[test]
fn every_direct_solver_gives_the_condition_of_the_hilbert_matrix() {
    let h = DMatrix::from_fn(6, 6, |i, j| 1.0 / (i + j + 1) as f64);
    let exact = exact(&h); // 2.9e7
    let solvers: [Box<dyn LinearSolver>; 4] = [
        Box::new(NalgebraLu::new()),
        Box::new(FaerDenseLu::new()),
        Box::new(FaerSparseLu::new()),
        Box::new(FaerCholesky::new()),
    ];
    for mut linear in solvers {
        let ratio = estimate(&mut *linear, &h) / exact;
        assert!((0.3..1.001).contains(&ratio), "{}: {ratio}", linear.name());
    }
}

#[test]
fn a_small_last_pivot_is_not_needed_for_a_large_condition() {
    // Ones on the diagonal, −1 above: all pivots are 1, the inverse has 2^(n−2).
    let n = 40;
    let entry = |i: usize, j: usize| match i.cmp(&j) {
        std::cmp::Ordering::Equal => 1.0,
        std::cmp::Ordering::Less => -1.0,
        std::cmp::Ordering::Greater => 0.0,
    };
    let h = DMatrix::from_fn(n, n, entry);
    let mut linear = NalgebraLu::new();
    assert!(estimate(&mut linear, &h) > 1e12);
    assert_eq!(linear.factor(h.as_slice()).unwrap().pivot_ratio, 1.0);
}
