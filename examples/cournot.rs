//! # Five firms and one market: a Cournot equilibrium
//!
//! Firm `i` produces `q_i >= 0` at marginal cost `c_i + (q_i/L_i)^(1/β_i)`; at total output
//! `Q = Σ q_i` the market pays `p(Q) = (5000/Q)^(1/γ)`, a demand of constant elasticity `γ`. Each
//! firm takes the output of the others as given, so that its marginal revenue is
//! `p + q_i p′(Q) = p (1 − q_i/(γ Q))`. Nobody can gain by producing more or less:
//!
//! ```text
//! c_i + (q_i/L_i)^(1/β_i) − p(Q) (1 − q_i/(γ Q)) >= 0   ⟂   q_i >= 0
//! ```
//!
//! Source: Murphy, Sherali & Soyster, *A mathematical programming approach for determining
//! oligopolistic market equilibrium*, Math. Programming 24 (1982) 92–106; five firms with
//! `γ = 1.1` and `L_i = 5`, where total cost is `c q + β/(β+1) L^(−1/β) q^((β+1)/β)`. (The exponent
//! of `L` has the opposite sign in some test collections, which gives another equilibrium.)
//! Expected: `q = (36.9325, 41.8181, 43.7066, 42.6592, 39.1790)`.
//!
//! Beyond the printed digits the equilibrium is checked by each firm's best answer to the other
//! four, found by golden section on its profit: no derivative and nothing of the solver in it.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::{Method, ModelError, Options, certify, mcp, solve};
use std::error::Error;

const FIRMS: usize = 5;
const C: [f64; FIRMS] = [10.0, 8.0, 6.0, 4.0, 2.0];
const L: [f64; FIRMS] = [5.0; FIRMS];
const BETA: [f64; FIRMS] = [1.2, 1.1, 1.0, 0.9, 0.8];
const GAMMA: f64 = 1.1;
const PUBLISHED: [f64; FIRMS] = [36.9325, 41.8181, 43.7066, 42.6592, 39.1790];

mcp! {
    /// Firms choose outputs, the market finds the price.
    pub(crate) model Cournot {
        data { firms: 5, c[firms]: f64, l[firms]: f64, beta[firms]: f64, gamma: f64 }

        /// output
        var q[i in firms] >= 0.0 start 10.0;

        def total: sum(firms, |i| q[i]);
        def price: (5000.0 / total).pow(1.0 / gamma);
        def marginal_cost[i in firms]: c[i] + (q[i] / l[i]).pow(1.0 / beta[i]);
        def marginal_revenue[i in firms]: price * (1.0 - q[i] / (gamma * total));

        eq profit[i in firms]: marginal_cost[i] >= marginal_revenue[i]   complements q[i];
    }
}

impl Cournot {
    /// The five firms of the source.
    pub(crate) fn new() -> Result<Self, ModelError> {
        Cournot::builder().c(C).l(L).beta(BETA).gamma(GAMMA).build()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = Cournot::new()?;
    for method in Method::CLASSICAL {
        let solution = solve(&model, &Options::new(method))?.solved()?;
        let stats = solution.stats;
        println!(
            "{method:<14}{:>3} iterations, F = 0 to {:.0e}",
            stats.iterations, solution.certificate.natural_residual
        );
        for (q, published) in solution.z.iter().zip(PUBLISHED) {
            assert!((q - published).abs() < 0.5e-4, "{q} is not {published}");
        }
    }

    let solution = solve(&model, &Options::default())?.solved()?;
    let accuracy = certify(&model, &solution)?;
    println!("\n{accuracy}");
    assert!(accuracy.is_proved());

    let view = model.view(&solution)?;
    let q = view.q.values();
    println!("\nfirm    output   best answer    profit");
    for i in 0..FIRMS {
        let others = q.iter().sum::<f64>() - q[i];
        let answer = best_answer(i, others);
        assert!((answer - q[i]).abs() < 1e-5, "firm {} would rather produce {answer}", i + 1);
        println!("{:>4}{:>10.4}{answer:>14.4}{:>10.2}", i + 1, q[i], profit(i, q[i], others));
    }
    println!("price {:.4}", view.price);
    Ok(())
}

fn price(total: f64) -> f64 {
    (5000.0 / total).powf(1.0 / GAMMA)
}

fn profit(i: usize, q: f64, others: f64) -> f64 {
    let (beta, l) = (BETA[i], L[i]);
    let cost = C[i] * q + beta / (beta + 1.0) * l.powf(-1.0 / beta) * q.powf((beta + 1.0) / beta);
    price(q + others) * q - cost
}

/// The most profitable output against the others', by golden section on `[0, 200]`.
fn best_answer(i: usize, others: f64) -> f64 {
    let golden = (5_f64.sqrt() - 1.0) / 2.0;
    let (mut low, mut high) = (0.0, 200.0);
    while high - low > 1e-9 {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        if profit(i, a, others) < profit(i, b, others) {
            low = a;
        } else {
            high = b;
        }
    }
    f64::midpoint(low, high)
}
