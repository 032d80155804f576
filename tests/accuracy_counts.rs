//! What accuracy costs, in counts, against the committed file `tests/data/accuracy_counts.csv`.
//!
//! Evaluations of `F`, of `J` and factorisations of every case, method, source and tolerance of the
//! study may exceed the file's by one, for another rounding of a function of the system's library;
//! solves keep their status. Scalar operations and times are reported by the example, never tested.
//! A change that is meant is committed with
//!
//! ```text
//! cargo run --release --example accuracy -- --counts
//! ```
//!
//! The file belongs to one target; on others nothing is compared.
#![cfg(all(target_arch = "x86_64", target_os = "linux", target_env = "gnu"))]
#![allow(clippy::unwrap_used, reason = "a test stops where its data are wrong")]

#[allow(dead_code, reason = "the test uses a part of it")]
#[path = "../examples/accuracy/cases.rs"]
mod cases;

use std::collections::BTreeMap;

/// Counts may exceed those of the file by this.
const ALLOWED: usize = 1;

/// Case, setting and tolerance; status; `F`, `J`, factorisations.
fn parsed(text: &str) -> BTreeMap<String, (String, [usize; 3])> {
    let line = |line: &str| {
        let fields: Vec<&str> = line.split(';').collect();
        let [problem, setting, tolerance, status, f, j, lu] = fields[..] else {
            panic!("seven fields expected: {line}")
        };
        let counts = [f, j, lu].map(|count| count.parse().unwrap());
        ([problem, setting, tolerance].join("; "), (status.to_owned(), counts))
    };
    text.lines().skip(1).map(line).collect()
}

#[test]
fn no_solve_costs_more_than_it_did() {
    let committed = parsed(&std::fs::read_to_string(cases::counts_file()).unwrap());
    let now = parsed(&cases::counts().unwrap());
    assert!(now.keys().eq(committed.keys()), "the file is of other cases or settings");
    let mut worse = Vec::new();
    for (what, (status, counts)) in now {
        let (before, allowed) = &committed[&what];
        let exceeds = counts.iter().zip(allowed).any(|(now, then)| *now > then + ALLOWED);
        if exceeds || status != *before {
            worse.push(format!("{what}: {status} {counts:?}, before {before} {allowed:?}"));
        }
    }
    assert!(worse.is_empty(), "F, J, factorisations: {worse:#?}");
}
