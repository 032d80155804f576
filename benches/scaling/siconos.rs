//! Siconos on the same linear obstacle problem, if a harness that runs it is at hand.
//!
//! `SICONOS_HARNESS` names a program that, called with `sparse` and the range of `k` in `KMIN` and `KMAX`,
//! prints tab-separated lines with a header; the columns `problem` (`obstacle-K`), `solver`, `info` (0:
//! solved), `iter`, `nF`, `nJ` and `cpu_us` are read. Other lines are skipped.

use std::error::Error;
use std::ffi::OsStr;
use std::process::Command;

/// The columns read, in the order they are printed.
const COLUMNS: [&str; 6] = ["solver", "cpu_us", "iter", "nF", "nJ", "info"];

/// Prints a line for every solver of the harness at these `k`.
pub(crate) fn print(sides: &[usize]) -> Result<(), Box<dyn Error>> {
    let Some(harness) = std::env::var_os("SICONOS_HARNESS") else {
        println!("\nSiconos: set SICONOS_HARNESS to a program that runs it (benches/README.md)");
        return Ok(());
    };
    println!(
        "\n{:<34}{:>8}{:>18}{:>12}{:>5}{:>5}  end",
        "Siconos, membrane, cold", "n", "CPU s", "it", "F", "J"
    );
    for &k in sides {
        for [solver, time, iterations, f, j, info] in lines_of(&harness, k)? {
            let seconds = time.parse::<f64>()? * 1e-6;
            let end = if info == "0" { "solved".to_owned() } else { format!("info {info}") };
            let n = k * k;
            println!("{solver:<34}{n:>8}{seconds:>18.3}{iterations:>12}{f:>5}{j:>5}  {end}");
        }
    }
    Ok(())
}

/// The [`COLUMNS`] of all lines for the obstacle problem on `k × k` nodes.
fn lines_of(harness: &OsStr, k: usize) -> Result<Vec<[String; 6]>, Box<dyn Error>> {
    let side = k.to_string();
    let output = Command::new(harness)
        .arg("sparse")
        .envs([("KMIN", &side), ("KMAX", &side)])
        .envs([("OPENBLAS_NUM_THREADS", "1"), ("OMP_NUM_THREADS", "1")])
        .output()?;
    let text = String::from_utf8_lossy(&output.stdout);
    let mut rows = text.lines().map(|line| line.split('\t').collect::<Vec<_>>());
    let header = rows.find(|row| row[0] == "problem").ok_or("the harness printed no header")?;
    let mut places = [0; 6];
    for (place, column) in places.iter_mut().zip(COLUMNS) {
        *place = header
            .iter()
            .position(|title| *title == column)
            .ok_or_else(|| format!("no column `{column}`"))?;
    }
    let problem = format!("obstacle-{k}");
    let found: Vec<[String; 6]> = rows
        .filter(|row| row.len() == header.len() && row[0] == problem)
        .map(|row| places.map(|place| row[place].to_owned()))
        .collect();
    if found.is_empty() {
        return Err(
            format!("no line of `{problem}`; the harness ended with {}", output.status).into()
        );
    }
    Ok(found)
}
