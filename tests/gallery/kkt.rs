//! Portfolios by enumeration of the assets they hold, one linear system each.

#[path = "../../examples/kkt.rs"]
#[allow(dead_code, reason = "`main` is run as an example")]
mod example;

use crate::numbers::solve_linear;
use example::{DATA, FRONTIER, Portfolio};
use mcp_core::{Options, solve};

/// As in `returns.csv`.
const MU: [f64; 6] = [3.0, 4.0, 6.0, 7.0, 8.0, 9.5];
/// As in `covariances.csv`.
const COV: [[f64; 6]; 6] = [
    [16.0, 4.0, 6.0, 2.0, 1.0, -2.0],
    [4.0, 225.0, 10.0, 15.0, 10.0, 30.0],
    [6.0, 10.0, 144.0, 110.0, 105.0, 120.0],
    [2.0, 15.0, 110.0, 324.0, 260.0, 300.0],
    [1.0, 10.0, 105.0, 260.0, 289.0, 280.0],
    [-2.0, 30.0, 120.0, 300.0, 280.0, 576.0],
];

struct Point {
    x: [f64; 6],
    lambda: f64,
    /// `V x − λ μ − β`.
    marginals: [f64; 6],
}

/// The stationary point that holds the assets of `held` and, if `binding`, earns just the target.
fn stationary(held: &[usize], binding: bool, target: f64) -> Option<Point> {
    let n = held.len();
    let (zero, one) = (|| vec![0.0; n], || vec![1.0; n]);
    let mut a: Vec<Vec<f64>> = Vec::new();
    for &i in held {
        let row = held.iter().map(|&j| COV[i][j]).chain([-MU[i], -1.0]);
        a.push(row.collect());
    }
    let earns: Vec<f64> = held.iter().map(|&i| MU[i]).collect();
    // `Σ μ x = ρ`, or `λ = 0`.
    a.push(if binding {
        [earns, vec![0.0, 0.0]].concat()
    } else {
        [zero(), vec![1.0, 0.0]].concat()
    });
    a.push([one(), vec![0.0, 0.0]].concat());
    let b = [zero(), vec![if binding { target } else { 0.0 }, 1.0]].concat();
    let solved = solve_linear(a, b)?;
    let (lambda, beta) = (solved[n], solved[n + 1]);
    let mut x = [0.0; 6];
    held.iter().zip(&solved).for_each(|(&i, &share)| x[i] = share);
    let risk = |i: usize| (0..6).map(|j| COV[i][j] * x[j]).sum::<f64>();
    let marginals = std::array::from_fn(|i| risk(i) - lambda * MU[i] - beta);
    Some(Point { x, lambda, marginals })
}

/// The one stationary point that meets all inequalities.
fn best(target: f64) -> Point {
    let mut found = Vec::new();
    for (set, binding) in (1..1 << 6).flat_map(|set| [(set, true), (set, false)]) {
        let held: Vec<usize> = (0..6).filter(|i| set >> i & 1 == 1).collect();
        let Some(point) = stationary(&held, binding, target) else { continue };
        let earned: f64 = MU.iter().zip(point.x).map(|(mu, x)| mu * x).sum();
        let meets = point.x.iter().all(|x| *x > -1e-12)
            && point.marginals.iter().all(|f| *f > -1e-9)
            && point.lambda > -1e-12
            && earned > target - 1e-12;
        if meets {
            found.push(point);
        }
    }
    assert_eq!(found.len(), 1, "portfolios that return {target}");
    found.remove(0)
}

fn variance(x: &[f64; 6]) -> f64 {
    (0..6).map(|i| (0..6).map(|j| COV[i][j] * x[i] * x[j]).sum::<f64>()).sum()
}

/// Without pivots, Gauss elimination of a symmetric matrix has positive pivots only if the matrix
/// is positive definite.
#[test]
fn the_variance_is_convex() {
    let mut a = COV;
    for k in 0..6 {
        assert!(a[k][k] > 0.0, "pivot {k}: {}", a[k][k]);
        for i in k + 1..6 {
            let factor = a[i][k] / a[k][k];
            for j in k..6 {
                a[i][j] -= factor * a[k][j];
            }
        }
    }
}

#[test]
fn the_frontier_of_the_example_is_that_of_enumeration() {
    for [target, risk, lambda] in FRONTIER {
        let point = best(target);
        assert!((variance(&point.x).sqrt() - risk).abs() < 5e-4, "{target}");
        assert!((point.lambda - lambda).abs() < 5e-4, "{target}");
    }
}

#[test]
fn shares_and_multipliers_agree_with_enumeration() {
    let mut model = Portfolio::read(DATA.as_ref()).unwrap();
    for [target, ..] in FRONTIER {
        model.set_parameter("target", &[target]).unwrap();
        let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
        let view = model.view(&solution).unwrap();
        let point = best(target);
        for i in 0..6 {
            assert!((view.x.values()[i] - point.x[i]).abs() < 1e-9, "{target}: share {i}");
            assert!((view.x.marginals()[i] - point.marginals[i]).abs() < 1e-7, "{target}: {i}");
        }
        assert!((view.lambda - point.lambda).abs() < 1e-7, "{target}: {}", view.lambda);
    }
}

#[test]
fn lambda_is_what_a_further_per_cent_of_return_costs() {
    let half_variance = |target: f64| 0.5 * variance(&best(target).x);
    for target in [4.5, 6.5, 8.5] {
        let h = 1e-4;
        let slope = (half_variance(target + h) - half_variance(target - h)) / (2.0 * h);
        assert!((slope - best(target).lambda).abs() < 1e-6, "{target}: {slope}");
    }
}
