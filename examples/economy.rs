//! # An economy with only the effects that a scenario names
//!
//! Two households `h` live on labor and spend constant parts `α_hs` of their means on three goods `s`.
//! Food and tools `i` are traded at prices of the world; all goods can be made of labor alone:
//!
//! ```text
//! a_s w − p_s                            >= 0   ⟂   y_s >= 0   output: its cost is its price
//! y_s + m_s − x_s − Σ_h α_hs I_h / p_s   >= 0   ⟂   p_s >= 0   price
//! Σ_h L_h − Σ_s a_s y_s                  >= 0   ⟂   w >= 0     wage
//! cif_i e − p_i                          >= 0   ⟂   m_i >= 0   imports
//! p_i − fob_i e                          >= 0   ⟂   x_i >= 0   exports
//! w L_h − I_h                             = 0       I_h free   income
//! Σ_i fob_i x_i − cif_i m_i              >= 0   ⟂   e = 1      foreign exchange, the numeraire
//! ```
//!
//! The base has no government. What a scenario names comes on top, each effect a `part` of the text in
//! `examples/economy/model.rs`; what it does not name has no unknown, no equation and no parameter:
//!
//! | effect | unknowns | what it adds |
//! | --- | --- | --- |
//! | `tax` | revenue | rates on what households pay |
//! | `tariff` | | rates on what imports cost |
//! | `quota` | rent of each limited good | `Q_i − m_i >= 0 ⟂ r_i >= 0`, and `r_i` to the cost of imports |
//! | `emission_cap` | price of permits | `E − Σ_s ε_s y_s >= 0 ⟂ π >= 0`, and `ε_s π` to costs |
//! | `markup` | | rates on the costs of a monopoly |
//! | `rationing` | scarcity for each ration | `R_hs − d_hs >= 0 ⟂ v_hs >= 0`: virtual price and income |
//!
//! Whoever earns what an effect brings is part of its data. Rations follow J. P. Neary, K. W. S. Roberts
//! (1980), The theory of household behaviour under rationing, European Economic Review 13, 25–42: a
//! household that may buy no more than `R` behaves as if the price were higher by `v` and the income by
//! `v R`.
//!
//! ```sh
//! cargo run --release --example economy                                  # all scenarios, side by side
//! cargo run --release --example economy -- examples/economy/quota.toml   # some
//! ```
//!
//! prints a table and writes all numbers to `target/economy.csv`.
//!
//! Source: the technology and the trade are those of Ricardo's textbook example with two countries of
//! which one is small; all numbers are illustrative. Expected: the closed forms of
//! `examples/economy/closed_form.rs` for free trade, taxes and quotas; by `tests/economy.rs` also that an
//! effect with slack data changes nothing and one that is off costs nothing.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

#[path = "economy/mod.rs"]
mod economy;

use economy::closed_form::expected;
use economy::effects::files_in;
use economy::scenario::Scenario;
use economy::table::Table;
use mcp_core::economics::check_walras;
use mcp_core::{AdProblem, Options, Report, solve};
use std::error::Error;
use std::path::{Path, PathBuf};

/// A closed form holds to this part of the number.
const TOLERANCE: f64 = 1e-9;

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    if paths.is_empty() {
        paths = scenarios_in(&root.join("examples/economy"))?;
    }
    let mut table = Table::default();
    for path in &paths {
        let Scenario { title, effects, economy } = Scenario::read(path)?;
        let solution = solve(&economy, &Options::default())?.solved()?;
        check_walras(&economy, &solution)?.verdict()?;
        let mut problem = AdProblem::new(&economy)?;
        let report = Report::new(&mut problem, &solution)?;
        for (name, value) in expected(&effects) {
            let found = report.level(name)?;
            let error = (found - value).abs() / value.abs().max(1.0);
            assert!(error <= TOLERANCE, "{title}: {name} is {found}, by hand {value}");
        }
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        table.add(&name, &problem, &report);
    }
    print!("{table}");
    let target = root.join("target/economy.csv");
    std::fs::write(&target, table.csv())?;
    println!("all numbers in {}", target.display());
    Ok(())
}

/// The scenario files of a folder, those with fewer effects first.
fn scenarios_in(folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let mut counted = Vec::new();
    for path in files_in(folder)? {
        counted.push((Scenario::read(&path)?.effects.len(), path));
    }
    counted.sort();
    Ok(counted.into_iter().map(|(_, path)| path).collect())
}
