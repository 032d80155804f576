//! # A model to copy: mills, a flour market and a tax
//!
//! Each mill sells flour at the market price `p` [$/t]. Its marginal cost is `cost + slope q`, and
//! it can make at most `limit` [t]. Buyers take `10 − p` [t]. A tax [$/t] is paid on every ton:
//!
//! ```text
//! cost_m + slope_m q_m + tax − p         ⟂   0 <= q_m <= limit_m   no mill gains by a change
//! Σ_m q_m − (10 − p)             >= 0    ⟂   p >= 0                flour left over is free
//! ```
//!
//! The old mill has cost 2 and slope 1, the new one cost 4, slope 0 and limit 3. No source: the
//! numbers are chosen to be solved by hand. Without tax the new mill is at its limit:
//! `2 + q_old = p` and `q_old + 3 = 10 − p` give `p = 4.5`. With a tax of 2 it is not, and its cost
//! is the price: `p = 6`, `q_old = q_new = 2`, and the tax yields 8.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

// One crate has all: the language, `mcp!`, and what solves and reports.
use mcp_core::{AdProblem, ModelError, Options, Report, mcp, solve};
use std::error::Error;

// `mcp!` makes three types: the model, `Flour`; what takes its data, `FlourBuilder`; and what shows
// a solution, `FlourView`. `pub(crate)` is their visibility.
mcp! {
    /// Mills sell flour on one market.
    pub(crate) model Flour {
        // What is given: a set of labels, and tables with a number for each of them. `///`
        // describes a thing, with its unit in brackets; reports print it.
        data {
            mills: Set,
            /// marginal cost of the first ton [$/t]
            cost[mills]: f64,
            /// what each further ton adds to it [$/t²]
            slope[mills]: f64,
            /// the most a mill can make [t]
            limit[mills]: f64,
        }

        // A number that may change between two solves. It has a value here, so that it need not be
        // given.
        /// tax on flour [$/t]
        param tax = 0.0;

        // What is looked for: one number `q[m]` for each mill `m`, and one price. Each has bounds:
        // `>= l`, `<= u`, `in l..=u` or `free`. `start` is the first guess, if 0 is not a good one.
        /// flour made by a mill [t]
        var q[m in mills] in 0.0..=limit[m];
        /// price of flour [$/t]
        var p >= 0.0 start 1.0;

        // One equation for each variable, paired with it by `complements`. With one bound it is a
        // relation that looks like the bound: `>=` for `p >= 0`. With two it is an expression: zero
        // between the bounds, at least 0 at the lower, at most 0 at the upper bound. `tax`, which
        // has no index, is read by its name alone; `|m|` is each mill in turn.
        eq profit[m in mills]: cost[m] + slope[m] * q[m] + tax - p      complements q[m];
        eq market: sum(mills, |m| q[m]) >= 10.0 - p                     complements p;

        // What a reader of the solution wants to know. It is computed after the solve.
        /// yield of the tax [$]
        report revenue: tax * sum(mills, |m| q[m]);
    }
}

/// The two mills.
pub(crate) fn flour() -> Result<Flour, ModelError> {
    // One call for each name in `data`, in any order. A table is a list in the order of the labels,
    // or pairs of label and number, or one number for all; infinity is no limit. Files are read by
    // `Labels::csv(path)` and `Table::csv(path)`. What is missing, unknown or given twice is an
    // error that names it.
    Flour::builder()
        .mills(["old", "new"])
        .cost([2.0, 4.0])
        .slope([("new", 0.0), ("old", 1.0)])
        .limit([f64::INFINITY, 3.0])
        .build()
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut model = flour()?;

    // Any point but a certified solution is turned by `solved()` into an error with advice.
    let before = solve(&model, &Options::default())?.solved()?;
    println!("{}", Report::new(&mut AdProblem::new(&model)?, &before)?.named("flour"));

    // The view has the names of the text; what has an index is read by its label.
    let view = model.view(&before)?;
    close(view.p, 4.5);
    close(view.q["old"], 2.5);
    close(view.q["new"], 3.0);
    // The marginal is the value of `profit`: a further ton would earn the new mill 0.5 $.
    close(view.q.marginal("new")?, -0.5);

    // Changes go by name: a parameter, and in the same way a bound, `set_upper("q[new]", 1.0)`, or
    // a variable that is to stay where it is put, `fix("p", 5.0)`.
    model.set_parameter("tax", &[2.0])?;
    // The next solve begins at the last solution.
    model.start_from(&before)?;
    let after = solve(&model, &Options::default())?.solved()?;

    let view = model.view(&after)?;
    close(view.p, 6.0);
    close(view.q["old"], 2.0);
    close(view.q["new"], 2.0);
    close(view.revenue, 8.0);
    println!("with a tax of {} $/t flour costs {:.2} $/t", view.tax, view.p);
    for ([mill], tons) in view.q.iter() {
        println!("  the {mill} mill makes {tons:.2} t");
    }
    println!("  the tax yields {:.2} $", view.revenue);
    Ok(())
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-6, "{found} is not {expected}");
}
