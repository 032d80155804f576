//! # A portfolio at least risk: optimality conditions with multipliers by name
//!
//! Shares `x_i >= 0` of a fortune, with expected returns `μ_i` [%] and covariances `V_ij` [%²], are
//! to return at least `ρ` at the least variance, and nothing is sold short:
//!
//! ```text
//! minimise ½ xᵀ V x   subject to   Σ μ_i x_i >= ρ,   Σ x_i = 1,   x >= 0.
//! ```
//!
//! The problem is convex, so that its solutions are those of the Karush–Kuhn–Tucker conditions,
//!
//! ```text
//! Σ_j V_ij x_j − λ μ_i − β >= 0   ⟂   x_i >= 0    risk at the margin, less what it earns
//! Σ μ_i x_i − ρ            >= 0   ⟂   λ >= 0      a price only for a return that is hard to get
//! Σ x_i − 1                       ⟂   β free
//! ```
//!
//! a linear complementarity problem with the multipliers as variables: `λ` is what a further per
//! cent of return costs in `½ variance`, the marginal of `x_i` what forbidding short sales costs.
//!
//! Source of the model: H. Markowitz, *Portfolio selection*, Journal of Finance 7 (1952) 77–91. The
//! data, in `examples/data/kkt`, are invented. Expected: with no return asked for, `λ = 0`; as more
//! is asked for, bonds and gold leave the portfolio, and European shares, riskier than American
//! ones and less profitable, never enter. `tests/gallery/kkt.rs` finds the same portfolios by trying
//! all 2⁶ sets of assets.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::language::{Labels, Table};
use mcp_core::{AdProblem, ModelError, Options, Report, mcp, solve};
use std::error::Error;
use std::path::Path;

mcp! {
    /// Least variance for a return, without short sales.
    pub(crate) model Portfolio {
        data {
            assets: Set,
            /// expected return [%]
            mu[assets]: f64,
            /// covariance of returns [%²]
            cov[assets, assets]: f64,
        }
        /// return asked for [%]
        param target = 0.0;

        /// share of an asset
        var x[i in assets] >= 0.0;
        /// half the variance that a further per cent of return costs [%]
        var lambda >= 0.0 start 100.0;
        /// multiplier of the budget [%²]
        var beta free;

        eq share[i in assets]:
            sum(assets, |j| cov[i, j] * x[j]) - lambda * mu[i] >= beta   complements x[i];
        eq earn: sum(assets, |i| mu[i] * x[i]) >= target                 complements lambda;
        eq budget: sum(assets, |i| x[i]) == 1.0                          complements beta;

        /// expected return [%]
        report earned: sum(assets, |i| mu[i] * x[i]);
        /// standard deviation [%]
        report risk: sum(assets, |i| sum(assets, |j| cov[i, j] * x[i] * x[j])).sqrt();
    }
}

/// The invented data.
pub(crate) const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/kkt");

impl Portfolio {
    /// Reads `returns.csv` and `covariances.csv` of a directory.
    pub(crate) fn read(directory: &Path) -> Result<Self, ModelError> {
        let returns = directory.join("returns.csv");
        Portfolio::builder()
            .assets(Labels::csv(&returns))
            .mu(Table::csv(&returns))
            .cov(Table::csv(directory.join("covariances.csv")))
            .build()
    }
}

/// Return asked for, standard deviation [%], `λ`.
pub(crate) const FRONTIER: [[f64; 3]; 7] = [
    [0.0, 3.819, 0.0],
    [4.0, 4.364, 6.621],
    [5.0, 6.489, 16.452],
    [6.0, 9.211, 26.282],
    [7.0, 12.134, 36.112],
    [8.0, 15.578, 61.863],
    [9.0, 20.311, 129.556],
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut model = Portfolio::read(DATA.as_ref())?;
    model.set_parameter("target", &[8.0])?;
    let solution = solve(&model, &Options::default())?.solved()?;
    println!("{}", Report::new(&mut AdProblem::new(&model)?, &solution)?.named("portfolio"));

    print!("{:>6}{:>8}{:>8}{:>9}", "asked", "return", "risk", "lambda");
    model.view(&solution)?.x.iter().for_each(|([asset], _)| print!("{asset:>9}"));
    println!();
    for [target, risk, lambda] in FRONTIER {
        model.set_parameter("target", &[target])?;
        let solution = solve(&model, &Options::default())?.solved()?;
        model.start_from(&solution)?;
        let view = model.view(&solution)?;
        print!("{target:>6.1}{:>8.3}{:>8.3}{:>9.3}", view.earned, view.risk, view.lambda);
        view.x.values().iter().for_each(|x| print!("{:>9.4}", x + 0.0));
        println!();
        assert!((view.risk - risk).abs() < 1e-3, "risk {}", view.risk);
        assert!((view.lambda - lambda).abs() < 1e-3, "multiplier {}", view.lambda);
        assert!(view.x["europe"] < 1e-9);
        assert!(view.x["bonds"] < 1e-9 || target < 8.0);
    }
    Ok(())
}
