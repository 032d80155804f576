//! The membrane by projected relaxation, and its closed form from the conditions that define it.

#[path = "../../examples/obstacle.rs"]
#[allow(dead_code, reason = "`main` is run as an example")]
mod example;

use crate::numbers::bisect;
use example::{Membrane, RADIUS, coordinate, exact, psi, touching};
use mcp_core::{Method, Options, solve};

#[test]
fn the_closed_form_meets_the_ball_with_its_value_and_slope() {
    let a = bisect(|a| a * a * (2.0 / a).ln() + a * a - 1.0, 0.1, 1.0);
    assert!((a - RADIUS).abs() < 1e-14, "{a}");
    let h = 1e-6;
    assert!((exact(RADIUS + 1e-12) - psi(RADIUS)).abs() < 1e-11);
    let slopes =
        [exact(RADIUS + h) - exact(RADIUS), psi(RADIUS) - psi(RADIUS - h)].map(|rise| rise / h);
    assert!((slopes[0] - slopes[1]).abs() < 1e-5, "{slopes:?}");
    // Above the ball, and zero at the rim.
    for step in 1..=100 {
        let r = RADIUS + f64::from(step) / 100.0 * (2.0 - RADIUS);
        assert!(exact(r) > psi(r));
    }
    assert!(exact(2.0).abs() < 1e-15);
}

/// Projected successive over-relaxation with the factor that is best without obstacle, until no
/// height moves by more than `1e-14`.
fn relaxed(n: usize) -> Vec<f64> {
    let radius = |i: usize, j: usize| coordinate(i, n).hypot(coordinate(j, n));
    let side = |j: usize| exact(coordinate(j, n).hypot(2.0));
    let factor = 2.0 / (1.0 + (std::f64::consts::PI / (n as f64 + 1.0)).sin());
    let mut u: Vec<f64> = (0..n * n).map(|k| psi(radius(k / n, k % n)).max(0.0)).collect();
    loop {
        let mut moved = 0.0_f64;
        for i in 0..n {
            for j in 0..n {
                let k = i * n + j;
                let up = if i == 0 { side(j) } else { u[k - n] };
                let down = if i == n - 1 { side(j) } else { u[k + n] };
                let left = if j == 0 { side(i) } else { u[k - 1] };
                let right = if j == n - 1 { side(i) } else { u[k + 1] };
                let free = u[k] + factor * ((up + down + left + right) / 4.0 - u[k]);
                let height = free.max(psi(radius(i, j)));
                moved = moved.max((height - u[k]).abs());
                u[k] = height;
            }
        }
        if moved < 1e-14 {
            return u;
        }
    }
}

#[test]
fn heights_on_the_grid_agree_with_relaxation() {
    let n = 39;
    let model = Membrane::over_ball(n).unwrap();
    let expected = relaxed(n);
    for method in [Method::NewtonFb, Method::NewtonMinFb] {
        let solution = solve(&model, &Options::new(method)).unwrap().solved().unwrap();
        for (k, (u, expected)) in solution.z.iter().zip(&expected).enumerate() {
            assert!((u - expected).abs() < 1e-11, "{method}, node {k}: {u} is not {expected}");
        }
        let view = model.view(&solution).unwrap();
        for (k, touches) in touching(&view).into_iter().enumerate() {
            let radius = coordinate(k / n, n).hypot(coordinate(k % n, n));
            assert_eq!(touches, expected[k] == psi(radius), "node {k}");
        }
    }
}
