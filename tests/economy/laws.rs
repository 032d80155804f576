//! What holds in every scenario file.

use super::economy::effect::Effect;
use super::economy::scenario::Scenario;
use super::{economy_with, levels, sample, scenarios};
use mcp_core::economics::{check_homogeneous, check_walras};
use mcp_core::study::sweep;
use mcp_core::{Model, Options, check_derivatives, solve};

#[test]
fn the_parts_that_are_on_are_those_that_the_file_names() {
    for (path, Scenario { economy, effects, .. }) in scenarios() {
        assert_eq!(economy.parts().len(), effects.len(), "{}", path.display());
        let text = std::fs::read_to_string(&path).unwrap();
        let list = text.lines().find(|line| line.starts_with("effects")).unwrap();
        for part in economy.parts() {
            assert!(list.contains(&format!("\"{part}\"")), "{}: {part}", path.display());
        }
    }
}

/// All sets of effects.
pub(crate) fn sets() -> impl Iterator<Item = Vec<Effect>> {
    let is_on = |set: u32, k: usize| set >> k & 1 == 1;
    (0..1 << sample::all().len()).map(move |set| {
        let effects = sample::all().into_iter().enumerate();
        effects.filter(|&(k, _)| is_on(set, k)).map(|(_, effect)| effect).collect()
    })
}

#[test]
fn payments_are_receipts_with_every_set_of_effects() {
    assert_eq!(sets().count(), 64);
    for effects in sets() {
        let economy = economy_with(&effects);
        let solution = solve(&economy, &Options::default()).unwrap();
        let check = check_walras(&economy, &solution).unwrap();
        check.verdict().unwrap_or_else(|error| panic!("{effects:?}: {error}"));
    }
}

#[test]
fn only_relative_prices_matter() {
    let money = ["p", "w", "e", "income", "revenue", "rent", "permit", "scarcity"];
    for (path, Scenario { economy, .. }) in scenarios() {
        let shape = economy.shape();
        let exists = |name: &&str| shape.variable(name).is_ok_and(|family| !family.is_empty());
        let names: Vec<&str> = money.into_iter().filter(exists).collect();
        let check = check_homogeneous(&economy, &names).unwrap();
        check.verdict().unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
}

#[test]
fn derivatives_are_right() {
    for (path, Scenario { economy, .. }) in scenarios() {
        let solution = solve(&economy, &Options::default()).unwrap().solved().unwrap();
        let check = check_derivatives(&economy, &solution.z).unwrap();
        check.verdict().unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
}

/// A rate is a parameter of its part.
#[test]
fn a_rate_can_be_swept() {
    let rates = [0.0, 0.05, 0.1, 0.2];
    let sweep = sweep(&economy_with(&[sample::tariff()]), "duty_rate[food]", &rates).unwrap();
    let table = sweep.of(&["m[food]"]).unwrap();
    for (rate, imports) in rates.into_iter().zip(&table.columns[0].values) {
        let effect = Effect::Tariff { rate: [rate, 0.0], to: sample::TO_BOTH };
        let error = (imports - levels(&[effect])["m[food]"]).abs();
        assert!(error <= 1e-10, "{rate}: {error:e}");
    }
}
