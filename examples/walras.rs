//! # Prices of an economy: a Walrasian equilibrium with a good that may be free
//!
//! Three goods and one sector. The sector turns one unit of good 2 and one of good 3 into one of
//! good 1, at activity `y`. One consumer owns `b = (0, 5, 3)` and spends the shares
//! `s = (0.9, 0.1, 0)` of the income `M = Σ b_i p_i` (Cobb–Douglas). With `a = (1, −1, −1)`:
//!
//! ```text
//! −Σ_i a_i p_i              >= 0   ⟂   y   >= 0    no activity makes a profit
//! b_i + a_i y − s_i M/p_i   >= 0   ⟂   p_i >= 0    what is in excess supply is free
//! ```
//!
//! Only relative prices matter: good 2 is the numeraire, `p_2 = 1` fixed. Its market is then not
//! imposed, and clears all the same (Walras' law).
//!
//! Source: Mathiesen, *An algorithm based on a sequence of linear complementarity problems applied
//! to a Walrasian equilibrium model: an example*, Math. Programming 37 (1987) 1–18. Published
//! solution: `y = 3`, `p = (6, 1, 5)`, consumption `(3, 2, 0)`.
//!
//! For any endowment `b_3` of good 3 the equilibrium can be had by hand. If good 3 is scarce,
//! `y = b_3`, and the market of good 2, `5 − b_3 = 0.1 (5 + b_3 p_3)`, gives
//! `p_3 = 45/b_3 − 10`. From `b_3 = 4.5` on it is free: `p_3 = 0`, `y = 4.5`. At 4.5 price and
//! excess supply both vanish. Always `p_1 = p_2 + p_3`.
//!
//! With good 1 as numeraire the relative prices are the same, `p = (1, 1/6, 5/6)`, but from
//! `(1, 1, 1)` the Fischer–Burmeister directions are drawn to `p_2 = 0`, where demand has a pole.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::{AdProblem, Method, ModelError, Options, Solver, mcp};
use std::error::Error;

const OUTPUT: [f64; 3] = [1.0, -1.0, -1.0];
const SHARE: [f64; 3] = [0.9, 0.1, 0.0];
const ENDOWMENT: [f64; 3] = [0.0, 5.0, 3.0];

mcp! {
    /// One sector, one consumer, and prices.
    pub(crate) model Walras {
        data { goods: Set[good1, good2, good3], output[goods]: f64, share[goods]: f64 }
        param endowment[i in goods];

        /// activity of the sector
        var y >= 0.0 start 1.0;
        /// price, good 2 being the numeraire
        var p[i in goods] >= 0.0 start 1.0;
        fix p[good2] = 1.0;

        def income: sum(goods, |i| endowment[i] * p[i]);
        def demand[i in goods]: when(share[i] > 0.0, || share[i] * income / p[i]);

        eq profit: 0.0 >= sum(goods, |i| output[i] * p[i])                     complements y;
        eq market[i in goods]: endowment[i] + output[i] * y >= demand[i]       complements p[i];
    }
}

impl Walras {
    /// The economy of the source.
    pub(crate) fn new() -> Result<Self, ModelError> {
        Walras::builder().output(OUTPUT).share(SHARE).endowment(ENDOWMENT).build()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = Walras::new()?;
    let mut problem = AdProblem::new(&model)?;
    let mut solver = Solver::new(Options::default())?;
    let published = solver.solve(&mut problem)?.clone().solved()?;
    close(&published.z, &[3.0, 6.0, 1.0, 5.0]);

    println!("endowment of good 3     y      p1      p2      p3   excess of good 3   of good 2");
    for b3 in [1.5, 3.0, 4.0, 4.5, 6.0] {
        problem.set_parameter("endowment", &[0.0, 5.0, b3])?;
        let solution = solver.solve(&mut problem)?.clone().solved()?;
        let view = model.view(&solution)?;
        let (y, p, excess) = (view.y, view.p.values(), view.p.marginals());
        print!("{b3:>19.1}{y:>6.2}{:>8.3}{:>8.3}{:>8.3}", p[0], p[1], p[2]);
        println!("{:>19.3}{:>12.0e}", excess[2], excess[1]);
        let p3 = f64::max(45.0 / b3 - 10.0, 0.0);
        close(&[y], &[b3.min(4.5)]);
        close(p, &[1.0 + p3, 1.0, p3]);
        close(excess, &[0.0, 0.0, f64::max(b3 - 4.5, 0.0)]);
    }

    println!("\ngood 1 as numeraire, from p = (1, 1, 1):");
    problem.set_parameter("endowment", &ENDOWMENT)?;
    problem.set_lower("p[good2]", 0.0)?;
    problem.set_upper("p[good2]", f64::INFINITY)?;
    problem.fix("p[good1]", 1.0)?;
    for method in [Method::NewtonFb, Method::OldFb, Method::NewtonMinFb] {
        let solution = Solver::new(Options::new(method))?.solve(&mut problem)?.clone();
        println!("  {method:<14} p = {:.4?}: {}", &solution.z[1..], solution.status.name());
        if method == Method::NewtonMinFb || solution.is_solved() {
            close(&solution.solved()?.z, &[3.0, 1.0, 1.0 / 6.0, 5.0 / 6.0]);
        }
    }
    Ok(())
}

fn close(found: &[f64], expected: &[f64]) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-6, "{found} is not {expected}");
    }
}
