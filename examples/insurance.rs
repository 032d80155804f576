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

use mcp_core::{
    AdProblem, Equation, Model, ModelError, Options, Parameter, Reader, Real, Scalar, Shape,
    Solver, Variable,
};
use std::error::Error;

const PI: f64 = 0.01;
const LOSS: f64 = 0.5;
const RHO: f64 = -1.0;

/// Variables `EU`, `EV`, `C_g`, `C_b`, `K`; parameter `γ`.
pub(crate) struct Insurance(Shape);

impl Insurance {
    pub(crate) fn new() -> Result<Self, ModelError> {
        let free = |name| Variable::new(name).start(1.0);
        let shape = Shape::builder()
            .parameter(Parameter::new("premium", 0.02))
            .variable(free("EU").about("expected utility"))
            .variable(free("EV").about("equivalent variation").unit("per cent of wealth"))
            .variable(free("C_g").about("consumption on a good day"))
            .variable(free("C_b").about("consumption on a bad day"))
            .variable(Variable::new("K").lower(0.0).upper(LOSS).about("coverage"))
            .equation(Equation::new("utility").complements("EU"))
            .equation(Equation::new("variation").complements("EV"))
            .equation(Equation::new("good_day").complements("C_g"))
            .equation(Equation::new("bad_day").complements("C_b"))
            .equation(Equation::new("coverage").complements("K"))
            .build()?;
        Ok(Insurance(shape))
    }
}

impl Model for Insurance {
    fn shape(&self) -> &Shape {
        &self.0
    }

    fn row<D: Scalar>(&self, family: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        let [eu, ev, c_g, c_b, k] = [0, 1, 2, 3, 4].map(|j| move || read.var(j));
        let gamma = read.param(0);
        let marginal = |c: Real<D>| c.pow(RHO - 1.0);
        // `E C^ρ`: expected utility but for the factor `ρ`.
        let expected = || (1.0 - PI) * c_g().pow(RHO) + PI * c_b().pow(RHO);
        match family {
            0 => expected() / RHO - eu(),
            1 => 100 * (expected().pow(1.0 / RHO) - 1) - ev(),
            2 => 1 - gamma * k() - c_g(),
            3 => (1.0 - LOSS) + (1 - gamma) * k() - c_b(),
            _ => {
                let benefit = PI * marginal(c_b());
                gamma * ((1.0 - PI) * marginal(c_g()) + benefit) - benefit
            }
        }
    }
}

/// Coverage in closed form.
fn coverage(gamma: f64) -> f64 {
    let r = (gamma * (1.0 - PI) / (PI * (1.0 - gamma))).powf(1.0 / (RHO - 1.0));
    ((r - 1.0 + LOSS) / (1.0 - gamma + r * gamma)).clamp(0.0, LOSS)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut problem = AdProblem::new(Insurance::new()?)?;
    let mut solver = Solver::new(Options::default())?;
    let published = solver.solve(&mut problem)?.clone().solved()?;
    assert!((published.z[2] - 0.996).abs() < 1e-3);

    println!("premium  coverage K     C_g     C_b   EV [%]");
    for gamma in [0.005, 0.01, 0.015, 0.02, 0.03, 0.04] {
        problem.set_parameter("premium", &[gamma])?;
        let z = solver.solve(&mut problem)?.clone().solved()?.z;
        let [eu, ev, c_g, c_b, k] = z[..] else { unreachable!("five variables") };
        println!("{gamma:>7.3}{k:>12.4}{c_g:>8.4}{c_b:>8.4}{ev:>9.4}");

        let expected = coverage(gamma);
        close(k, expected);
        close(c_g, 1.0 - gamma * expected);
        close(c_b, 1.0 - LOSS + (1.0 - gamma) * expected);
        // With ρ = −1, consumption has a harmonic mean, and U = −1/C.
        let mean = 1.0 / ((1.0 - PI) / c_g + PI / c_b);
        close(eu, -1.0 / mean);
        close(ev, 100.0 * (mean - 1.0));
    }
    Ok(())
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-6, "{found} is not {expected}");
}
