//! The cases of the study, and the counts that a test compares.

#[allow(dead_code, unreachable_pub, reason = "the example is included whole")]
#[path = "../cge_tax.rs"]
mod cge_tax;

use mcp_core::accuracy::{Case, Run, Setting, problems};
use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Nodes of a side of the obstacle problem whose counts are compared.
const FEW_NODES: usize = 20;
/// Tolerances whose counts are compared.
const TOLERANCES: [f64; 3] = [1e-4, 1e-8, 1e-12];

/// The cases of the library, and the general equilibrium of `examples/cge_tax.rs` with the higher tax,
/// from its benchmark.
///
/// # Errors
/// Of the cases and of the data.
pub(crate) fn all(nodes: usize) -> Result<Vec<Case>, Box<dyn Error>> {
    let mut cases = problems::all(nodes)?;
    let mut economy = cge_tax::economy()?;
    economy.set_parameter("ty[manufacturing]", &[cge_tax::TAX])?;
    cases.insert(4, Case::new("tax cge", economy).refined()?);
    Ok(cases)
}

/// Where the counts are kept.
pub(crate) fn counts_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/accuracy_counts.csv")
}

/// `F`, `J` and factorisations of every case, setting and tolerance, one line each.
///
/// # Errors
/// Of the cases.
pub(crate) fn counts() -> Result<String, Box<dyn Error>> {
    let mut text = String::from("problem;setting;tolerance;status;F;J;factorisations\n");
    for case in all(FEW_NODES)? {
        for setting in Setting::all(&case, &TOLERANCES) {
            let run = Run::new(&case, setting, None)?;
            let cost = run.cost;
            writeln!(
                text,
                "{};{};{:e};{};{};{};{}",
                case.name,
                setting.name(),
                setting.tolerance,
                run.status.name(),
                cost.residual,
                cost.jacobian,
                cost.factorisations
            )?;
        }
    }
    Ok(text)
}
