//! # Two solutions, one of them degenerate: the problem of Kojima and Shindo
//!
//! Find `x >= 0` with `F(x) >= 0` and `x_i F_i(x) = 0` for
//!
//! ```text
//! F1 = 3 x1² + 2 x1 x2 + 2 x2² + x3 + 3 x4 − 6
//! F2 = 2 x1² + x1 + x2² + 10 x3 + 2 x4 − 2
//! F3 = 3 x1² + x1 x2 + 2 x2² + 2 x3 + 9 x4 − 9
//! F4 = x1² + 3 x2² + 2 x3 + 3 x4 − 3
//! ```
//!
//! There are two solutions, easily checked by hand:
//!
//! | solution | `F` | |
//! | --- | --- | --- |
//! | (√6/2, 0, 0, 1/2) | (0, 2 + √6/2, 0, 0) | degenerate: `x3 = 0` and `F3 = 0` |
//! | (1, 0, 3, 0) | (0, 31, 0, 4) | nondegenerate |
//!
//! Source: Kojima & Shindo, *Extensions of Newton and quasi-Newton methods to systems of PC¹
//! equations*, J. Oper. Res. Soc. Japan 29 (1986) 352–374; `kojshin` in MCPLIB (Dirkse & Ferris
//! 1995), whose `10 x3` is used here.
//!
//! The problem is written twice: as a function, the form for a fixed number of variables, and as a
//! text of the language, which can also have sets, data and parameters. Every run of the one is
//! asserted to end where that of the other does.
//!
//! Which of the two solutions a run finds depends on start and method: a regression value. That a
//! run called solved is at one of them is not.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::{Method, Options, Real, Scalar, Solution, mcp, mcp_fn, solve_from};
use std::error::Error;

/// Four equations of Kojima and Shindo.
#[mcp_fn(lower = 0.0)]
pub(crate) fn kojima_shindo<D: Scalar>([x1, x2, x3, x4]: [Real<D>; 4]) -> [Real<D>; 4] {
    [
        3 * x1 * x1 + 2 * x1 * x2 + 2 * x2 * x2 + x3 + 3 * x4 - 6,
        2 * x1 * x1 + x1 + x2 * x2 + 10 * x3 + 2 * x4 - 2,
        3 * x1 * x1 + x1 * x2 + 2 * x2 * x2 + 2 * x3 + 9 * x4 - 9,
        x1 * x1 + 3 * x2 * x2 + 2 * x3 + 3 * x4 - 3,
    ]
}

mcp! {
    /// The same four equations with names.
    pub(crate) model KojimaShindoByName {
        var x1 >= 0.0;
        var x2 >= 0.0;
        var x3 >= 0.0;
        var x4 >= 0.0;

        eq f1: 3*x1*x1 + 2*x1*x2 + 2*x2*x2 + x3 + 3*x4 - 6        complements x1;
        eq f2: 2*x1*x1 + x1 + x2*x2 + 10*x3 + 2*x4 - 2            complements x2;
        eq f3: 3*x1*x1 + x1*x2 + 2*x2*x2 + 2*x3 + 9*x4 - 9        complements x3;
        eq f4: x1*x1 + 3*x2*x2 + 2*x3 + 3*x4 - 3                  complements x4;
    }
}

const STARTS: [[f64; 4]; 5] = [
    [0.0, 0.0, 0.0, 0.0],
    [1.0, 1.0, 1.0, 1.0],
    [1.0, 0.0, 1.0, 0.0],
    [100.0, 100.0, 100.0, 100.0],
    [1.0, 0.0, 0.0, 0.0],
];

/// Where the runs end, method by method: at the degenerate (`D`) or the regular (`R`) solution.
const ENDS: [&str; 3] = ["RRRDD", "RRRRD", "RRRDD"];

fn main() -> Result<(), Box<dyn Error>> {
    let (model, by_name) = (KojimaShindo::new()?, KojimaShindoByName::builder().build()?);
    let degenerate = [6_f64.sqrt() / 2.0, 0.0, 0.0, 0.5];
    let regular = [1.0, 0.0, 3.0, 0.0];

    println!("method         start              iterations    F    J  residual  status  ends at");
    for (method, expected) in Method::CLASSICAL.into_iter().zip(ENDS) {
        let mut ends = String::new();
        for start in STARTS {
            let options = Options::new(method);
            let solution = solve_from(&model, &start, &options)?.solved()?;
            let same = solve_from(&by_name, &start, &options)?.solved()?;
            assert_eq!(solution.z, same.z, "both forms are the same problem");
            let (letter, end) = if distance(&solution.z, &regular) < 1e-6 {
                ('R', "(1, 0, 3, 0)")
            } else {
                assert!(distance(&solution.z, &degenerate) < 1e-6);
                ('D', "(√6/2, 0, 0, 1/2)")
            };
            print_line(start, &solution, end);
            ends.push(letter);
        }
        assert_eq!(ends, expected, "regression value");
    }
    Ok(())
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn print_line(start: [f64; 4], solution: &Solution, end: &str) {
    println!(
        "{:<15}{:<21}{:>8}{:>5}{:>5}{:>10.1e}  {}  {end}",
        solution.method,
        format!("{start:?}").replace(".0", ""),
        solution.stats.iterations,
        solution.stats.residual_evaluations,
        solution.stats.jacobian_evaluations,
        solution.certificate.natural_residual,
        solution.status.name(),
    );
}
