//! # A leader before followers: Stackelberg above, Cournot below
//!
//! A market pays `p = a − b (x + Σ q_i)` [$/t]. The leader chooses its output `x` [t] first; the
//! followers see it and answer with a Cournot equilibrium. Follower `i` has the unit cost `c_i` and
//! the marginal revenue `p − b q_i`:
//!
//! ```text
//! c_i + b q_i − p >= 0   ⟂   q_i >= 0
//! ```
//!
//! The leader's output is a parameter of the followers' problem. Its profit `(p(x) − c_0) x` is
//! found by a solve for each `x`, from the last solution, and made largest by golden section.
//!
//! Source of the model: Sherali, Soyster & Murphy, *Stackelberg–Nash–Cournot equilibria:
//! characterizations and computations*, Operations Research 31 (1983) 253–276. The data are chosen
//! to be solved by hand: `a = 100`, `b = 1`, `c = (10, 20, 40)`, `c_0 = 15`. With `m` followers in
//! the market, of costs `c_1, …, c_m`, the price is `(a − b x + Σ c_i) / (m + 1)`, so that
//!
//! ```text
//! x <= 10          three followers,   p = (170 − x)/4
//! 10 <= x <= 70    two,               p = (130 − x)/3
//! 70 <= x <= 90    one,               p = (110 − x)/2
//! 90 <= x          none,              p = 100 − x
//! ```
//!
//! and the profit is largest at `x = (130 − 3·15)/2 = 42.5`, with `p = 175/6`. If nobody led, all
//! four firms in Cournot equilibrium, the price would be `(100 + 10 + 15 + 20)/4 = 36.25`, the
//! smallest firm out of the market, and `x = 36.25 − 15`. `tests/gallery/stackelberg_cournot.rs`
//! checks the formulas, and followers by trial.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::{AdProblem, ModelError, Options, Solver, mcp};
use std::error::Error;

mcp! {
    /// Followers share what a leader leaves of a market.
    pub(crate) model Followers {
        data {
            firms: Set,
            /// unit cost [$/t]
            c[firms]: f64,
            /// highest price [$/t]
            a: f64,
            /// what a ton takes from the price [$/t²]
            b: f64,
        }
        /// output of the leader [t]
        param x = 0.0;

        /// output of a follower [t]
        var q[i in firms] >= 0.0;

        /// price [$/t]
        def p: a - b * (x + sum(firms, |i| q[i]));

        eq profit[i in firms]: c[i] + b * q[i] >= p   complements q[i];
    }
}

/// Unit cost of the leader [$/t].
pub(crate) const COST: f64 = 15.0;

impl Followers {
    /// The three firms of the text.
    pub(crate) fn new() -> Result<Self, ModelError> {
        Followers::builder()
            .firms(["small", "middle", "large"])
            .c([40.0, 20.0, 10.0])
            .a(100.0)
            .b(1.0)
            .build()
    }
}

/// The followers, solved again and again for outputs of the leader.
pub(crate) struct Market {
    problem: AdProblem<Followers>,
    solver: Solver,
    z: Vec<f64>,
    /// Newton iterations of all solves.
    pub(crate) iterations: usize,
}

impl Market {
    pub(crate) fn new() -> Result<Self, ModelError> {
        let problem = AdProblem::new(Followers::new()?)?;
        let z = vec![0.0; 3];
        Ok(Market { problem, solver: Solver::new(Options::default())?, z, iterations: 0 })
    }

    /// The followers' answer to the output `x`.
    pub(crate) fn answer(&mut self, x: f64) -> Result<FollowersView, Box<dyn Error>> {
        self.problem.set_parameter("x", &[x])?;
        let solution = self.solver.solve_from(&mut self.problem, &self.z)?.clone().solved()?;
        self.z.clone_from(&solution.z);
        self.iterations += solution.stats.iterations;
        Ok(self.problem.model().view(&solution)?)
    }

    /// The leader's profit [$].
    pub(crate) fn profit(&mut self, x: f64) -> Result<f64, Box<dyn Error>> {
        Ok((self.answer(x)?.p - COST) * x)
    }

    /// The leader's best output between `low` and `high`, to a ten-thousandth of a ton.
    pub(crate) fn lead(&mut self, mut low: f64, mut high: f64) -> Result<f64, Box<dyn Error>> {
        let golden = (5_f64.sqrt() - 1.0) / 2.0;
        while high - low > 1e-4 {
            let (left, right) = (high - golden * (high - low), low + golden * (high - low));
            if self.profit(left)? < self.profit(right)? {
                low = left;
            } else {
                high = right;
            }
        }
        Ok(f64::midpoint(low, high))
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut market = Market::new()?;
    println!("  leader     price     small    middle     large    profit");
    for x in [0.0, 10.0, 21.25, 30.0, 42.5, 50.0, 60.0, 70.0, 80.0] {
        let view = market.answer(x)?;
        print!("{x:>8.2}{:>10.3}", view.p);
        view.q.values().iter().for_each(|q| print!("{:>10.3}", q + 0.0));
        println!("{:>10.2}", market.profit(x)?);
    }

    let mut market = Market::new()?;
    let x = market.lead(0.0, 100.0)?;
    println!(
        "\nbest output {x:.3} t, found in {} iterations of Newton's method",
        market.iterations
    );
    assert!((x - 42.5).abs() < 1e-3);
    let view = market.answer(x)?;
    assert!((view.p - 175.0 / 6.0).abs() < 1e-3);
    assert!(view.q["small"] < 1e-9);

    let profit = market.profit(x)?;
    let without_lead = market.profit(21.25)?;
    println!("profit {profit:.2} $, against {without_lead:.2} $ if nobody led");
    assert!((profit - 42.5 * (175.0 / 6.0 - 15.0)).abs() < 1e-6);
    assert!((without_lead - 21.25 * 21.25).abs() < 1e-6);
    Ok(())
}
