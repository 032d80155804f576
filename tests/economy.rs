//! The economy with the effects that scenarios name: what they come to, laws, and effects that cost
//! nothing while they are off.
#![allow(clippy::unwrap_used, reason = "a test stops where its data are wrong")]

#[path = "../examples/economy/mod.rs"]
#[allow(dead_code, reason = "the example uses more of it")]
mod economy;

#[path = "economy/by_hand.rs"]
mod by_hand;
#[path = "economy/closed_forms.rs"]
mod closed_forms;
#[path = "economy/every_set.rs"]
mod every_set;
#[path = "economy/faults.rs"]
mod faults;
#[path = "economy/laws.rs"]
mod laws;
#[path = "economy/sample.rs"]
mod sample;
#[path = "economy/slack.rs"]
mod slack;
#[path = "economy/texts.rs"]
mod texts;
#[path = "economy/twins.rs"]
mod twins;

use economy::effect::Effect;
use economy::effects::files_in;
use economy::model::Economy;
use economy::scenario::Scenario;
use mcp_core::{AdProblem, Options, Report, solve};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/economy")
}

/// All scenario files.
fn scenarios() -> Vec<(PathBuf, Scenario)> {
    let paths = files_in(&folder()).unwrap();
    assert!(paths.len() >= 8, "{paths:?}");
    let read = |path: PathBuf| match Scenario::read(&path) {
        Ok(scenario) => (path, scenario),
        Err(error) => panic!("{error}"),
    };
    paths.into_iter().map(read).collect()
}

fn economy_with(effects: &[Effect]) -> Economy {
    Economy::with_effects(effects).unwrap_or_else(|error| panic!("{effects:?}: {error}"))
}

/// Variables, definitions and reports of the solved economy, by name.
fn levels(effects: &[Effect]) -> BTreeMap<String, f64> {
    let economy = economy_with(effects);
    let solution = solve(&economy, &Options::default()).unwrap().solved();
    let solution = solution.unwrap_or_else(|error| panic!("{effects:?}: {error}"));
    let report = Report::new(&mut AdProblem::new(&economy).unwrap(), &solution).unwrap();
    let variables = report.rows().map(|row| (row.variable, row.level));
    variables.chain(report.derived().map(|row| (row.name, row.value))).collect()
}
