//! Siconos on the same linear obstacle problem, if a harness that runs it is at hand.
//!
//! `SICONOS_HARNESS` names a program that, called with `sparse` and the range of `k` in `KMIN` and `KMAX`,
//! prints tab-separated lines with a header; the columns `problem` (`obstacle-K`), `solver`, `iter`, `nF`,
//! `nJ` and `cpu_us` are read.

use std::error::Error;
use std::process::Command;

/// Prints a line for every solver of the harness at these `k`.
pub(crate) fn print(sides: &[usize]) -> Result<(), Box<dyn Error>> {
    let Some(harness) = std::env::var_os("SICONOS_HARNESS") else {
        println!("\nSiconos: set SICONOS_HARNESS to a program that runs it (benches/README.md)");
        return Ok(());
    };
    println!("\nSiconos, membrane, cold{:>21}{:>11}{:>6}{:>6}{:>6}", "n", "CPU s", "it", "F", "J");
    for k in sides {
        let side = k.to_string();
        let output = Command::new(&harness)
            .arg("sparse")
            .envs([("KMIN", &side), ("KMAX", &side)])
            .envs([("OPENBLAS_NUM_THREADS", "1"), ("OMP_NUM_THREADS", "1")])
            .output()?;
        let text = String::from_utf8(output.stdout)?;
        let mut lines = text.lines().map(|line| line.split('\t').collect::<Vec<_>>());
        let header = lines.next().ok_or("the harness printed nothing")?;
        let column = |name: &str| {
            header.iter().position(|title| *title == name).ok_or(format!("no column `{name}`"))
        };
        let columns: Vec<usize> = ["solver", "cpu_us", "iter", "nF", "nJ"]
            .into_iter()
            .map(column)
            .collect::<Result<_, _>>()?;
        for line in lines {
            let field = |c: usize| line.get(columns[c]).copied().unwrap_or("");
            let seconds = field(1).parse::<f64>()? * 1e-6;
            println!(
                "{:<34}{:>8}{seconds:>11.3}{:>6}{:>6}{:>6}",
                field(0),
                k * k,
                field(2),
                field(3),
                field(4)
            );
        }
    }
    Ok(())
}
