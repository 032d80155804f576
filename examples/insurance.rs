//! # How much insurance to buy
//!
//! With probability `π` an accident costs `L` of a wealth of 1. A coverage `K` costs the premium
//! `γ K` in any case and pays `K` after an accident. Consumption is `C_g` on a good day and `C_b`
//! on a bad one; utility is `U(C) = C^ρ/ρ`. Expected utility `EU` is largest where the marginal
//! cost of coverage meets its marginal benefit, or at a limit, no coverage or full coverage:
//!
//! ```text
//! EU  = (1 − π) U(C_g) + π U(C_b)                                  ⟂   EU   free
//! EV  = 100 (((1 − π) C_g^ρ + π C_b^ρ)^(1/ρ) − 1)                  ⟂   EV   free
//! C_g = 1 − γ K                                                    ⟂   C_g  free
//! C_b = 1 − L + (1 − γ) K                                          ⟂   C_b  free
//! γ ((1 − π) U′(C_g) + π U′(C_b)) − π U′(C_b)                      ⟂   0 <= K <= L
//! ```
//!
//! `EV` is the sure change of wealth, in per cent, that is as good as the risk with its insurance.
//!
//! Source: *Expected utility of insurance* in the complementarity tutorial of JuMP, after a lecture
//! of T. F. Rutherford (AAE 706, Univ. of Wisconsin–Madison), with `π = 0.01`, `L = 0.5`,
//! `γ = 0.02`, `ρ = −1` and `K` free. Published: `C_g = 0.996`. The limits of `K` are ours.
//!
//! In closed form: the last equation is zero where `C_b = r C_g` with
//! `r = (γ (1 − π) / (π (1 − γ)))^(1/(ρ − 1))`, hence `K = (r − 1 + L) / (1 − γ + r γ)`, moved into
//! `[0, L]`. A fair premium, `γ = π`, buys full coverage, a degenerate corner; above
//! `γ = 4/103 ≈ 0.0388` insurance is not worth its price.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::{AdProblem, ModelError, Options, Real, Scalar, Solver, mcp};
use std::error::Error;

const PI: f64 = 0.01;
const LOSS: f64 = 0.5;
const RHO: f64 = -1.0;

mcp! {
    /// Coverage that makes expected utility largest.
    pub(crate) model Insurance {
        /// premium for a coverage of 1, `γ`
        param premium = 0.02;

        /// expected utility
        var EU free start 1.0;
        /// equivalent variation [per cent of wealth]
        var EV free start 1.0;
        /// consumption on a good day
        var C_g free start 1.0;
        /// consumption on a bad day
        var C_b free start 1.0;
        /// coverage
        var K in 0.0..=LOSS;

        /// `E C^ρ`, expected utility but for the factor `ρ`
        def expected: (1.0 - PI) * C_g.pow(RHO) + PI * C_b.pow(RHO);
        def benefit: PI * marginal(C_b);
        def cost: premium * ((1.0 - PI) * marginal(C_g) + benefit);

        eq utility:   expected / RHO == EU                               complements EU;
        eq variation: 100.0 * (expected.pow(1.0 / RHO) - 1.0) == EV      complements EV;
        eq good_day:  1.0 - premium * K == C_g                           complements C_g;
        eq bad_day:   1.0 - LOSS + (1.0 - premium) * K == C_b            complements C_b;
        eq coverage:  cost - benefit                                     complements K;
    }
}

/// `U′(C)`.
fn marginal<D: Scalar>(c: Real<D>) -> Real<D> {
    c.pow(RHO - 1.0)
}

impl Insurance {
    /// With the premium of the source.
    pub(crate) fn new() -> Result<Self, ModelError> {
        Insurance::builder().build()
    }
}

/// Coverage in closed form.
fn coverage(gamma: f64) -> f64 {
    let r = (gamma * (1.0 - PI) / (PI * (1.0 - gamma))).powf(1.0 / (RHO - 1.0));
    ((r - 1.0 + LOSS) / (1.0 - gamma + r * gamma)).clamp(0.0, LOSS)
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = Insurance::new()?;
    let mut problem = AdProblem::new(&model)?;
    let mut solver = Solver::new(Options::default())?;
    let published = model.view(&solver.solve(&mut problem)?.clone().solved()?)?;
    assert!((published.C_g - 0.996).abs() < 1e-3);

    println!("premium  coverage K     C_g     C_b   EV [%]");
    for gamma in [0.005, 0.01, 0.015, 0.02, 0.03, 0.04] {
        problem.set_parameter("premium", &[gamma])?;
        let view = model.view(&solver.solve(&mut problem)?.clone().solved()?)?;
        let InsuranceView { EU, EV, C_g, C_b, K, .. } = view;
        println!("{gamma:>7.3}{K:>12.4}{C_g:>8.4}{C_b:>8.4}{EV:>9.4}");

        let expected = coverage(gamma);
        close(K, expected);
        close(C_g, 1.0 - gamma * expected);
        close(C_b, 1.0 - LOSS + (1.0 - gamma) * expected);
        // With ρ = −1, consumption has a harmonic mean, and U = −1/C.
        let mean = 1.0 / ((1.0 - PI) / C_g + PI / C_b);
        close(EU, -1.0 / mean);
        close(EV, 100.0 * (mean - 1.0));
    }
    Ok(())
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-6, "{found} is not {expected}");
}
