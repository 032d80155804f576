//! # A taxed economy with a published equilibrium: Shoven and Whalley
//!
//! Two sectors `s` make goods from labor and capital with constant elasticity of substitution; two
//! consumers `h`, the rich who own the capital and the poor who work, buy them. A tax of rate `t` on the
//! capital of manufacturing is handed back, 40 % to the rich and 60 % to the poor:
//!
//! ```text
//! c_s − p_s                                            >= 0   ⟂   y_s >= 0
//! y_s − Σ_h α_hs I_h / (p_s^σ_h Σ_r α_hr p_r^(1−σ_h))  >= 0   ⟂   p_s >= 0
//! E_f − Σ_s y_s ∂c_s/∂w_fs                             >= 0   ⟂   w_f >= 0   price of factor f
//! I_h − Σ_f w_f e_hf − share_h R                        = 0       I_h free
//! R − Σ_s t_s w_K K_s                                   = 0       R free     revenue
//! c_s = (Σ_f δ_fs^σ_s w_fs^(1−σ_s))^(1/(1−σ_s)) / φ_s
//! ```
//!
//! with `w_fs` the price of the factor to the sector, tax included. Labor is the numeraire.
//!
//! Source: J. B. Shoven, J. Whalley (1984), Applied general-equilibrium models of taxation and
//! international trade: an introduction and survey. Journal of Economic Literature 22, 1007–1051, the
//! numerical example, with its data, its equilibrium without tax and that with a tax of 50 %.
//! Expected: the prices and quantities printed there, to the last digit.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::economics::{ces, check_homogeneous, check_walras};
use mcp_core::study::compare;
use mcp_core::{AdProblem, ModelError, Options, Report, mcp, solve};
use std::error::Error;

mcp! {
    /// Two sectors, two factors, two consumers, and a tax on capital.
    model Economy {
        data {
            sectors: Set, factors: Set[labor, capital], consumers: Set,
            /// scale and elasticity of substitution of production
            scale[sectors]: f64, sigma[sectors]: f64,
            /// weight of a factor in production
            delta[factors, sectors]: f64,
            /// weight of a good for a consumer, and its elasticity of substitution
            alpha[consumers, sectors]: f64, taste[consumers]: f64,
            /// what consumers own
            endowment[consumers, factors]: f64,
            /// part of the revenue that a consumer gets
            share[consumers]: f64,
        }
        /// tax on a factor in a sector, a part of its price
        param tax[f in factors, s in sectors] = 0.0;

        /// output
        var y[s in sectors] >= 0.0 start 10.0;
        /// price of a good
        var p[s in sectors] >= 1e-6 start 1.0;
        /// price of a factor
        var w[f in factors] >= 1e-6 start 1.0;
        /// income
        var income[h in consumers] free start sum(factors, |f| endowment[h, f]);
        /// revenue of the tax
        var revenue free;
        fix w[labor] = 1.0;

        def user[f in factors, s in sectors]: w[f] * (1.0 + tax[f, s]);
        /// sum of the weights as `ces` takes them
        def cost[s in sectors]: ces(sigma[s], factors, |f| (delta[f, s].powf(sigma[s]), user[f, s]))
            * sum(factors, |f| delta[f, s].powf(sigma[s])).powf(1.0 / (1.0 - sigma[s])) / scale[s];
        /// use of a factor
        def input[f in factors, s in sectors]: y[s] / scale[s]
            * (delta[f, s] * scale[s] * cost[s] / user[f, s]).pow(sigma[s]);
        def level[h in consumers]: sum(sectors, |s| alpha[h, s] * p[s].pow(1.0 - taste[h]));

        eq profit[s in sectors]: cost[s] - p[s]                                        complements y[s];
        eq market[s in sectors]: y[s]
            >= sum(consumers, |h| alpha[h, s] * income[h] / (p[s].pow(taste[h]) * level[h]))
                                                                                       complements p[s];
        eq hire[f in factors]: sum(consumers, |h| endowment[h, f]) >= sum(sectors, |s| input[f, s])
                                                                                       complements w[f];
        eq budget[h in consumers]: income[h] == sum(factors, |f| w[f] * endowment[h, f]) + share[h] * revenue
                                                                                       complements income[h];
        eq treasury: revenue == sum(factors, |f| sum(sectors, |s| tax[f, s] * w[f] * input[f, s]))
                                                                                       complements revenue;
    }
}

/// Prices and quantities as published: without tax, and with 50 % on the capital of manufacturing.
const PUBLISHED: [(&str, f64, f64); 5] = [
    ("p[manufacturing]", 1.399, 1.467),
    ("p[other]", 1.093, 1.006),
    ("w[capital]", 1.373, 1.128),
    ("y[manufacturing]", 24.942, 22.387),
    ("y[other]", 54.378, 57.307),
];

impl Economy {
    /// The economy of the article, without tax.
    fn published() -> Result<Self, ModelError> {
        Economy::builder()
            .sectors(["manufacturing", "other"])
            .consumers(["rich", "poor"])
            .scale([1.5, 2.0])
            .sigma([2.0, 0.5])
            .delta([[0.6, 0.7], [0.4, 0.3]])
            .alpha([[0.5, 0.5], [0.3, 0.7]])
            .taste([1.5, 0.75])
            .endowment([[0.0, 25.0], [60.0, 0.0]])
            .share([0.4, 0.6])
            .build()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut model = Economy::published()?;
    check_homogeneous(&model, &["p", "w", "income", "revenue"])?.verdict()?;
    let report = |model: &Economy| -> Result<Report, Box<dyn Error>> {
        let solution = solve(model, &Options::default())?.solved()?;
        check_walras(model, &solution)?.verdict()?;
        Ok(Report::new(&mut AdProblem::new(model)?, &solution)?)
    };
    let free = report(&model)?;
    model.set_parameter("tax[capital, manufacturing]", &[0.5])?;
    let taxed = report(&model)?;

    println!("A tax of 50 % on the capital of manufacturing");
    print!("{}", compare(free.solution(), taxed.solution()));
    for (name, before, after) in PUBLISHED {
        for (report, published) in [(&free, before), (&taxed, after)] {
            let found = report.level(name)?;
            assert!((found - published).abs() <= 5e-4, "{name}: {found}, published {published}");
        }
    }
    println!("all prices and quantities are those published, to the last of their digits");
    Ok(())
}
