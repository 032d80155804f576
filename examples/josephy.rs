//! # Josephy's problem: one solution, and two runs that do not get there
//!
//! Find `x >= 0` with `F(x) >= 0` and `x_i F_i(x) = 0` for
//!
//! ```text
//! F1 = 3 x1² + 2 x1 x2 + 2 x2² + x3 + 3 x4 − 6
//! F2 = 2 x1² + x1 + x2² + 3 x3 + 2 x4 − 2
//! F3 = 3 x1² + x1 x2 + 2 x2² + 2 x3 + 3 x4 − 1
//! F4 = x1² + 3 x2² + 2 x3 + 3 x4 − 3
//! ```
//!
//! Solution `(√6/2, 0, 0, 1/2)` with `F = (0, 2 + √6/2, 5, 0)`: by hand, `x1² = 3/2` makes both
//! `F1 = 3·3/2 + 3/2 − 6` and `F4 = 3/2 + 3/2 − 3` vanish. It is nondegenerate: of each pair
//! `x_i`, `F_i` exactly one is zero.
//!
//! Source: Josephy, *Newton's method for generalized equations*, MRC Technical Summary Report 1965,
//! Univ. of Wisconsin–Madison 1979; `josephy` in MCPLIB (Dirkse & Ferris 1995). The problem
//! of Kojima and Shindo, with other coefficients in `F2` and `F3`, has two solutions.
//!
//! From far away, (100, 100, 100, 100), the two Fischer–Burmeister directions run out of progress
//! or iterations. They say so; that they do is a regression value.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::{Method, Options, Real, Scalar, mcp_fn, solve_from};
use std::error::Error;

/// Four equations of Josephy.
#[mcp_fn(lower = 0.0)]
pub(crate) fn josephy<D: Scalar>([x1, x2, x3, x4]: [Real<D>; 4]) -> [Real<D>; 4] {
    [
        3 * x1 * x1 + 2 * x1 * x2 + 2 * x2 * x2 + x3 + 3 * x4 - 6,
        2 * x1 * x1 + x1 + x2 * x2 + 3 * x3 + 2 * x4 - 2,
        3 * x1 * x1 + x1 * x2 + 2 * x2 * x2 + 2 * x3 + 3 * x4 - 1,
        x1 * x1 + 3 * x2 * x2 + 2 * x3 + 3 * x4 - 3,
    ]
}

const STARTS: [[f64; 4]; 5] = [
    [0.0, 0.0, 0.0, 0.0],
    [1.0, 1.0, 1.0, 1.0],
    [1.0, 0.0, 1.0, 0.0],
    [100.0, 100.0, 100.0, 100.0],
    [1.0, 0.0, 0.0, 0.0],
];

fn main() -> Result<(), Box<dyn Error>> {
    let model = Josephy::new()?;
    let root = 6_f64.sqrt() / 2.0;

    println!("method         start              iterations    F    J  residual  status");
    for method in Method::CLASSICAL {
        for start in STARTS {
            let solution = solve_from(&model, &start, &Options::new(method))?;
            println!(
                "{:<15}{:<21}{:>8}{:>5}{:>5}{:>10.1e}  {}",
                method,
                format!("{start:?}").replace(".0", ""),
                solution.stats.iterations,
                solution.stats.residual_evaluations,
                solution.stats.jacobian_evaluations,
                solution.certificate.natural_residual,
                solution.status.name(),
            );
            if solution.is_solved() {
                close(&solution.z, &[root, 0.0, 0.0, 0.5]);
                close(&solution.f, &[0.0, 2.0 + root, 5.0, 0.0]);
            }
            let far = start[0] > 1.0 && method != Method::NewtonMinFb;
            assert_eq!(solution.is_solved(), !far, "regression value");
        }
    }
    Ok(())
}

fn close(found: &[f64], expected: &[f64]) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-6, "{found} is not {expected}");
    }
}
