//! # A model without macros: two firms, two countries and the cost of shipping
//!
//! Firms and countries share their names: each firm sits in one country and sells in both. Country
//! `r` pays `p_r = a_r − b_r Σ_f s_fr`. A unit costs `c`, and `t` more to ship abroad. Each firm
//! takes the other's sales as given:
//!
//! ```text
//! c + t [f ≠ r] − (p_r − b_r s_fr) >= 0   ⟂   s_fr >= 0     marginal cost − marginal revenue
//! ```
//!
//! Source: Brander & Krugman, *A 'reciprocal dumping' model of international trade*, J. Int.
//! Economics 15 (1983) 313–321, with linear demand and a cost per unit shipped. Closed form: with
//! `m = (a_r − c)/b_r` and `τ = t/b_r`, if both firms sell in country `r`,
//!
//! ```text
//! home sales (m + τ)/3,  foreign sales (m − 2 τ)/3,
//! ```
//!
//! and if `τ >= m/2` the home firm has the market for itself and sells `m/2`. So as shipping gets
//! dearer, trade in the small country ends first; where it ends, both `s_fr` and its equation are
//! zero.
//!
//! The example shows what a macro would write: names, sets, parameters, a definition (the price,
//! shared by two rows), and rows. It then solves for one `t` after the other with one solver, each
//! time from the last solution, and compares with the same equations as a [`Problem`] that comes
//! with a Jacobian of its own.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::{
    AdProblem, Block, Definition, Equation, Model, ModelError, Options, Parameter, Pattern,
    Problem, Reader, Real, Scalar, Set, Shape, Solver, Variable, sum, when,
};
use std::error::Error;
use std::sync::Arc;

const COUNTRIES: [&str; 2] = ["large", "small"];
const A: [f64; 2] = [16.0, 10.0];
const B: [f64; 2] = [0.5, 1.0];
const COST: f64 = 4.0;

/// The equations, once, for any number type.
pub(crate) struct Trade {
    shape: Shape,
    sales: Block<2>,
}

impl Trade {
    pub(crate) fn new() -> Result<Self, ModelError> {
        let (firms, countries) = (Set::new("firms", COUNTRIES)?, Set::new("countries", COUNTRIES)?);
        let shape = Shape::builder()
            .parameter(Parameter::new("shipping", 0.0).about("cost per unit shipped"))
            .variable(Variable::new("sales").over(&[&firms, &countries]).lower(0.0).start(1.0))
            .definition(Definition::new("price").over(&[&countries]))
            .equation(Equation::new("profit").over(&[&firms, &countries]).complements("sales"))
            .build()?;
        let sales = shape.variable("sales")?.block();
        Ok(Trade { shape, sales })
    }
}

impl Model for Trade {
    fn shape(&self) -> &Shape {
        &self.shape
    }

    fn def<D: Scalar>(&self, _: usize, r: usize, read: &Reader<'_, D>) -> Real<D> {
        A[r] - B[r] * sum(0..2, |f| read.var(self.sales.at([f, r])))
    }

    fn row<D: Scalar>(&self, _: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
        let [f, r] = self.sales.split(k);
        let marginal_cost = COST + when(f != r, || read.param(0));
        marginal_cost - (read.def(r) - B[r] * read.var(self.sales.at([f, r])))
    }
}

/// The same equations as numbers, with their Jacobian written out.
struct TradeByHand {
    shape: Arc<Shape>,
    pattern: Pattern,
    shipping: f64,
}

impl TradeByHand {
    fn new(shape: Arc<Shape>) -> Self {
        // Sales are numbered `2 f + r`; an equation reads both firms' sales in its country.
        let pattern = Pattern::from_rows(&[vec![0, 2], vec![1, 3], vec![0, 2], vec![1, 3]]);
        TradeByHand { shape, pattern, shipping: 0.0 }
    }
}

impl Problem for TradeByHand {
    fn shape(&self) -> &Arc<Shape> {
        &self.shape
    }

    fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    fn evaluate(&mut self, s: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        for (i, f) in f.into_iter().flatten().enumerate() {
            let (firm, r) = (i / 2, i % 2);
            let marginal_cost = COST + if firm == r { 0.0 } else { self.shipping };
            *f = marginal_cost - A[r] + B[r] * (s[r] + s[2 + r] + s[i]);
        }
        if let Some(jac) = jac {
            for (k, i, j) in self.pattern.entries() {
                jac[k] = B[j % 2] * if i == j { 2.0 } else { 1.0 };
            }
        }
    }
}

/// Sales in closed form, in the order of the variables.
fn closed_form(t: f64) -> [f64; 4] {
    std::array::from_fn(|i| {
        let (firm, r) = (i / 2, i % 2);
        let (m, tau) = ((A[r] - COST) / B[r], t / B[r]);
        if firm == r {
            f64::min((m + tau) / 3.0, m / 2.0)
        } else {
            f64::max((m - 2.0 * tau) / 3.0, 0.0)
        }
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = Trade::new()?;
    println!("equation                   variable");
    for i in 0..model.shape.n() {
        println!("{:<23} ⟂  {}", model.shape.equation_name(i), model.shape.variable_name(i));
    }

    let mut problem = AdProblem::new(model)?;
    let mut by_hand = TradeByHand::new(Arc::clone(problem.shape()));
    let mut solver = Solver::new(Options::default())?;
    let mut start = problem.shape().start().to_vec();

    println!("\n          large country    small country");
    println!("shipping   home foreign     home foreign   iterations");
    for t in [0.0, 1.0, 2.0, 3.0, 4.0, 6.0, 8.0] {
        problem.set_parameter("shipping", &[t])?;
        by_hand.shipping = t;
        let solution = solver.solve_from(&mut problem, &start)?.clone().solved()?;
        let same = solver.solve_from(&mut by_hand, &start)?.clone().solved()?;
        let sales = closed_form(t);
        for ((s, same), expected) in solution.z.iter().zip(&same.z).zip(sales) {
            assert!((s - expected).abs() < 1e-6 && (same - expected).abs() < 1e-6);
        }
        // Firm `large` is at home in the first country, firm `small` in the second.
        let s = &solution.z;
        print!("{t:>8.1}{:>7.3}{:>8.3}  {:>7.3}{:>8.3}", s[0], s[2], s[3], s[1]);
        println!("{:>13}", solution.stats.iterations);
        start = solution.z;
    }
    Ok(())
}
