//! Three hundred models of up to a thousand variables in one `mcp batch`: no crash, no hang, no false
//! `Solved`.
//!
//! Solvable models are made around a solution `z*`: with `A` strictly diagonally dominant, `g`
//! increasing in every variable, and `w*` of the sign that the place of `z*` between the bounds asks
//! for,
//!
//! ```text
//! F(z) = A (z − z*) + g(z) − g(z*) + w*
//! ```
//!
//! is a P-function, and `z*` the only solution ([FP03] Proposition 3.5.10). In the others one pair has
//! no solution, whatever the rest does.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod calls;
mod support;

use calls::{Said, empty_folder, mcp};
use mcp_cli::nl::NlModel;
use mcp_core::{Options, solve};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use support::node::{n, op, plus, power, sum, times, v};
use support::{File, Form, INF, Kind, Node, Row};

const MODELS: usize = 300;
const LARGEST: usize = 1000;

/// Numbers that look random: `SplitMix64` ([SLF14], references in `mcp_core`).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    /// In `[low, high)`.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
    fn below(&mut self, limit: usize) -> usize {
        usize::try_from(self.next() % limit as u64).unwrap()
    }
}

/// What increases beside the affine part.
#[derive(Clone, Copy, PartialEq)]
enum Increasing {
    Nothing,
    /// `z³`
    Cube,
    /// `exp(z/2)`
    Exponential,
    /// `max(z, z/2)`
    Kink,
}

impl Increasing {
    fn at(self, z: f64) -> f64 {
        match self {
            Increasing::Nothing => 0.0,
            Increasing::Cube => z.powi(3),
            Increasing::Exponential => (0.5 * z).exp(),
            Increasing::Kink => z.max(0.5 * z),
        }
    }
    fn node(self, j: usize) -> Node {
        match self {
            Increasing::Nothing => n(0.0),
            Increasing::Cube => power(v(j), 3.0),
            Increasing::Exponential => op(44, [times(n(0.5), v(j))]),
            Increasing::Kink => Node::Many(12, vec![v(j), times(n(0.5), v(j))]),
        }
    }
}

/// A file, and its only solution if it has one.
fn model(k: usize) -> (File, Option<Vec<f64>>) {
    let mut numbers = Numbers(k as u64);
    let is_solvable = k % 5 < 4;
    // All sizes, small ones more often. A solver tries long before it gives up.
    let largest = if is_solvable { LARGEST * (1 + k % 10) / 10 } else { 30 };
    let size = if k == 0 { LARGEST } else { 2 + numbers.below(largest - 1) };
    let kind = [
        Increasing::Nothing,
        Increasing::Cube,
        Increasing::Exponential,
        Increasing::Kink,
        Increasing::Nothing,
    ][k % 5];
    let is_boxed = k.is_multiple_of(3);
    let mut file = File::default();
    let (mut solution, mut force) = (Vec::new(), Vec::new());
    for _ in 0..size {
        let z = numbers.between(-2.0, 2.0);
        let away = numbers.between(0.5, 2.0);
        let far = if is_boxed { 3.0 } else { INF };
        // At the lower bound, between, at the upper bound, free; with the sign of F there.
        let (lower, upper, w) = match numbers.below(4) {
            0 => (z, z + far, away),
            1 => (z - away, z + far, 0.0),
            2 => (z - far, z, -away),
            _ => (-INF, INF, 0.0),
        };
        solution.push(z);
        force.push(w);
        file.variables.push((lower, upper, numbers.between(-3.0, 3.0)));
    }
    for i in 0..size {
        let mut linear: BTreeMap<usize, f64> = BTreeMap::new();
        for _ in 0..4 {
            *linear.entry(numbers.below(size)).or_default() += numbers.between(-1.0, 1.0);
        }
        let others: f64 = linear.iter().filter(|term| *term.0 != i).map(|term| term.1.abs()).sum();
        linear.insert(i, others + numbers.between(0.5, 2.0));
        let product: f64 = linear.iter().map(|(&j, a)| a * solution[j]).sum();
        let constant = force[i] - product - kind.at(solution[i]);
        let (lower, upper, _) = file.variables[i];
        let bits = i32::from(lower > -INF) + 2 * i32::from(upper < INF);
        let node = sum(vec![kind.node(i), n(constant), n(0.0)]);
        file.rows.push(Row(Kind::Complements(bits, i), linear.into_iter().collect(), node));
    }
    if is_solvable {
        return (file, Some(solution));
    }
    let i = numbers.below(size);
    let linear = vec![(i, 0.0)];
    (file.variables[i], file.rows[i]) = match (k / 5) % 3 {
        // 1 + z² = 0.
        0 => {
            let node = plus(n(1.0), power(v(i), 2.0));
            ((-INF, INF, 1.0), Row(Kind::Complements(0, i), linear, node))
        }
        // −exp(−z) ⟂ z >= 0: smaller and smaller, never 0.
        1 => {
            let node = op(16, [op(44, [op(16, [v(i)])])]);
            ((0.0, INF, 1.0), Row(Kind::Complements(1, i), linear, node))
        }
        // z² + 1/10 ⟂ z <= 0, negated: −z² − 1/10 would have to be >= 0.
        _ => {
            let node = plus(n(0.1), power(v(i), 2.0));
            ((-INF, 0.0, -1.0), Row(Kind::Complements(2, i), linear, node))
        }
    };
    (file, None)
}

/// Largest relative distance of two points.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let distance = |(a, b): (&f64, &f64)| (a - b).abs() / (1.0 + b.abs());
    a.iter().zip(b).map(distance).fold(0.0, f64::max)
}

/// Status and residual by file.
fn summary(folder: &Path) -> BTreeMap<String, (String, String)> {
    let table = fs::read_to_string(folder.join("summary.csv")).unwrap();
    let rows = table.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect());
    rows.map(|row: Vec<String>| (row[0].clone(), (row[3].clone(), row[4].clone()))).collect()
}

#[test]
fn three_hundred_models_end_in_one_batch_and_what_is_called_solved_is() {
    let folder = empty_folder("many");
    let name = |k: usize| format!("{k:03}.nl");
    let solutions: Vec<Option<Vec<f64>>> = (0..MODELS)
        .map(|k| {
            let (file, solution) = model(k);
            let form = [Form::Text, Form::LittleEndian, Form::BigEndian][k % 3];
            fs::write(folder.join(name(k)), file.write(form)).unwrap();
            solution
        })
        .collect();
    let files: Vec<String> = (0..MODELS).map(name).collect();
    let mut arguments = vec!["batch", "--csv", "summary.csv", "--time-limit", "20"];
    arguments.extend(files.iter().map(String::as_str));
    let Said { code, out, err } = mcp(&folder, &arguments);
    assert_eq!((code, err.as_str()), (1, ""));
    assert_eq!(out.lines().count(), MODELS + 3, "header, a line for each, a blank, a summary");

    let summary = summary(&folder);
    let mut not_solved = Vec::new();
    for (file, solution) in files.iter().zip(&solutions) {
        let (status, residual) = &summary[file];
        match (solution, status.as_str()) {
            (None, status) => {
                assert_ne!(status, "solved", "{file} has no solution");
                assert!(
                    !["crashed", "unreadable", "refused"].contains(&status),
                    "{file}: {status}"
                );
            }
            (Some(expected), "solved") => {
                assert!(residual.parse::<f64>().unwrap() <= 1e-6, "{file}: {residual}");
                // The same solve again, for its point.
                let model = NlModel::read(&folder.join(file)).unwrap();
                let options = Options::default().with(|options| options.tol = Some(1e-6));
                let found = solve(&model, &options).unwrap().solved().unwrap();
                let distance = distance(model.file_levels(&found.z), expected);
                assert!(distance < 1e-5, "{file}: the only solution is {distance:.1e} away");
            }
            (Some(_), status) => not_solved.push(format!("{file}: {status}")),
        }
    }
    assert!(not_solved.is_empty(), "{not_solved:?}");
}
