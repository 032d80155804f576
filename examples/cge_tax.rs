//! A general equilibrium: what does a higher tax on manufacturing do?
//!
//! Two sectors make goods from labor, capital and each other's goods, in nests with constant
//! elasticities of substitution; one household owns the factors and buys goods; the government
//! spends the tax on output. The benchmark is a social accounting matrix (`sam.csv`, billion dollars,
//! data of this example), from which the calibrated share form takes its shares; all prices are 1
//! there, and labor is the numeraire.
//!
//! 1. The benchmark is replicated: at prices and activities of 1 every equation holds to rounding.
//! 2. The tax rate on manufacturing rises from 10 to 30 %, and everything is compared by name. The
//!    expected changes are derived again with plain numbers, by bisection, in
//!    `tests/language/cge.rs`.
//! 3. The rate sweeps from 0 to 50 %: a table, a CSV file and a picture.

#![allow(clippy::print_stdout, reason = "an example prints its results")]

use indicatif::ProgressBar;
use mcp_core::economics::{Sam, ces, ces2, check_homogeneous, check_walras, cobb};
use mcp_core::language::Table;
use mcp_core::study::{compare, sweep_with};
use mcp_core::{AdProblem, Model, Options, Report, check_point, mcp, solve};
use std::error::Error;
use std::fs::{self, File};
use std::path::Path;

mcp! {
    /// Y = CES(value added, intermediates), with a tax on output.
    pub model Cge {
        data {
            sectors: Set, factors: Set[labor, capital],
            y0[sectors]: f64, va0[sectors]: f64, id0[sectors, sectors]: f64, fd0[factors, sectors]: f64,
            c0[sectors]: f64, g0[sectors]: f64, fbar[factors]: f64, sva[sectors]: f64, sy[sectors]: f64, sc: f64,
        }
        /// tax on output, a part of its value
        param ty[s in sectors];
        /// activity [base = 1]
        var y[s in sectors] >= 0.0 start 1.0;
        /// price of a good [base = 1]
        var p[s in sectors] >= 1e-9 start 1.0;
        /// price of a factor [base = 1]
        var pf[f in factors] >= 1e-9 start 1.0;
        /// income of the household [billion $]
        var hh free start sum(factors, |f| fbar[f]);
        /// income of the government [billion $]
        var gov free start sum(sectors, |s| g0[s]);
        fix pf[labor] = 1.0;

        /// unit cost of value added [base = 1]
        def cva[s in sectors]: ces(sva[s], factors, |f| (fd0[f, s], pf[f]));
        /// unit cost of intermediates [base = 1]
        def cin[s in sectors]: cobb(sectors, |k| (id0[k, s], p[k]));
        /// unit cost of output before tax [base = 1]
        def cy[s in sectors]: ces2(sy[s], va0[s] / (y0[s] * (1.0 - ty.base(s))), cva[s], cin[s]);
        /// demand for a factor [billion $ at base prices]
        def df[f in factors, s in sectors]: fd0[f, s] * y[s] * (cy[s] / cva[s]).pow(sy[s]) * (cva[s] / pf[f]).pow(sva[s]);
        /// consumer prices [base = 1]
        def cpi: ces(sc, sectors, |s| (c0[s], p[s]));

        eq zero_profit[s in sectors]: cy[s] * (1.0 - ty.base(s)) - p[s] * (1.0 - ty[s])   complements y[s];
        eq goods[s in sectors]: y0[s] * y[s]
            - sum(sectors, |k| id0[s, k] * y[k] * (cy[k] / cin[k]).pow(sy[k]) * cin[k] / p[s])
            - c0[s] * hh / (c0.sum() * cpi) * (cpi / p[s]).pow(sc)
            - g0[s] * gov / (g0.sum() * p[s])                                             complements p[s];
        eq endowment[f in factors]: fbar[f] - sum(sectors, |s| df[f, s])                  complements pf[f];
        eq income: hh - sum(factors, |f| pf[f] * fbar[f])                                 complements hh;
        eq budget: gov - sum(sectors, |s| ty[s] * p[s] * y0[s] * y[s])                    complements gov;

        /// real consumption [base = 1]
        report welfare: hh / cpi / c0.sum();
    }
}

const SECTORS: [&str; 2] = ["agriculture", "manufacturing"];
const FACTORS: [&str; 2] = ["labor", "capital"];

/// The tax on manufacturing in the counterfactual.
pub const TAX: f64 = 0.3;

/// Changes in percent when the tax on manufacturing rises from 10 to 30 %.
pub const CHANGES: [(&str, f64); 6] = [
    ("p[agriculture]", 8.7461),
    ("p[manufacturing]", 39.6044),
    ("pf[capital]", -3.2896),
    ("y[agriculture]", 17.1474),
    ("y[manufacturing]", -13.6856),
    ("gov", 183.4618),
];

/// The economy of the accounting matrix.
///
/// # Errors
/// What is wrong with the matrix or the tables, by name.
pub fn economy() -> Result<Cge, Box<dyn Error>> {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/data/cge_tax");
    let sam = Sam::csv(data.join("sam.csv"))?;
    let totals = |accounts: [&'static str; 2]| -> Result<Vec<(&str, f64)>, Box<dyn Error>> {
        accounts.into_iter().map(|account| Ok((account, sam.total(account)?))).collect()
    };
    let mut value_added = Vec::new();
    let mut rates = Vec::new();
    for sector in SECTORS {
        value_added.push((sector, sam.get("labor", sector)? + sam.get("capital", sector)?));
        rates.push((sector, sam.get("tax", sector)? / sam.total(sector)?));
    }
    let elasticity = |name: &str| Table::csv_column(data.join("elasticities.csv"), name);
    Ok(Cge::builder()
        .sectors(SECTORS)
        .y0(totals(SECTORS)?)
        .va0(value_added)
        .id0(sam.block(&SECTORS, &SECTORS)?)
        .fd0(sam.block(&FACTORS, &SECTORS)?)
        .c0(sam.column(&SECTORS, "household")?)
        .g0(sam.column(&SECTORS, "government")?)
        .fbar(totals(FACTORS)?)
        .sva(elasticity("sva"))
        .sy(elasticity("sy"))
        .sc(1.5)
        .ty(rates)
        .build()?)
}

/// Runs the three steps.
///
/// # Errors
/// Of the data and of the model, by name.
pub fn main() -> Result<(), Box<dyn Error>> {
    let mut model = economy()?;

    println!("1. The benchmark");
    let benchmark_check = check_point(&model, model.shape().start())?;
    println!("benchmark residual {:.1e}", benchmark_check.residual());
    assert!(benchmark_check.residual() < 1e-12, "{benchmark_check}");
    check_homogeneous(&model, &["p", "pf", "hh", "gov"])?.verdict()?;
    let report = |model: &Cge| -> Result<Report, Box<dyn Error>> {
        let solution = solve(model, &Options::default())?.solved()?;
        check_walras(model, &solution)?.verdict()?;
        Ok(Report::new(&mut AdProblem::new(model)?, &solution)?)
    };
    let benchmark = report(&model)?;

    println!("\n2. The tax on manufacturing rises from 10 to {:.0} %", 100.0 * TAX);
    model.set_parameter("ty[manufacturing]", &[TAX])?;
    let counterfactual = report(&model)?;
    let changes = compare(&benchmark, &counterfactual);
    print!("{changes}");
    for (name, percent) in CHANGES {
        let found = changes.get(name)?.percent();
        assert!((found - percent).abs() < 5e-5, "{name}: {found}");
    }

    println!("\n3. The tax from 0 to 50 %");
    let rates: Vec<f64> = (0..=50).map(|k| f64::from(k) / 100.0).collect();
    let bar = ProgressBar::new(rates.len() as u64);
    let sweep =
        sweep_with(&model, "ty[manufacturing]", &rates, &Options::default(), &mut |_| bar.inc(1))?;
    bar.finish_and_clear();
    assert!(sweep.is_solved());
    let table = sweep.of(&["p[manufacturing]", "pf[capital]", "gov", "welfare"])?;
    let text = table.to_string();
    let mut lines = text.lines();
    println!("{}", lines.next().unwrap_or_default());
    lines.step_by(5).for_each(|line| println!("{line}"));
    let target = Path::new(env!("CARGO_MANIFEST_DIR")).join("target");
    fs::create_dir_all(&target)?;
    table.write_csv(File::create(target.join("cge_tax.csv"))?)?;
    let relative = sweep.of(&["p", "pf[capital]", "welfare"])?.in_percent();
    relative.write_svg(target.join("cge_tax.svg"))?;
    println!("every point: target/cge_tax.csv; picture: target/cge_tax.svg");
    Ok(())
}
