//! A fault of a scenario file is named with file, line and key.

use super::economy::effects::Source;
use super::economy::scenario::Scenario;
use super::folder;

/// What is said about a scenario after `from` in it has become `to`.
fn said(name: &str, from: &str, to: &str) -> String {
    let text = std::fs::read_to_string(folder().join(name).with_extension("toml")).unwrap();
    assert!(text.contains(from), "{name} has `{from}`");
    let text = text.replacen(from, to, 1);
    match Scenario::parse(&Source { file: "scenario.toml", text: &text }) {
        Ok(_) => panic!("{name} with `{to}` is accepted"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn a_fault_is_named_with_file_line_and_key() {
    for (name, from, to, message) in [
        (
            "tax",
            "[\"tax\"]",
            "[\"taxes\"]",
            "scenario.toml:3: `effects`: there is no effect `taxes`: choose tax, tariff, quota,",
        ),
        (
            "tax",
            "[\"tax\"]",
            "[\"tax\", \"tax\"]",
            "scenario.toml:3: `effects`: `tax` is named twice",
        ),
        (
            "tax",
            "[\"tax\"]",
            "[\"tax\", \"quota\"]",
            "scenario.toml:3: `effects`: the file has no data for `quota`",
        ),
        (
            "tax",
            "food = 0.05",
            "food = -0.05",
            "scenario.toml:6: `tax.rate.food`: is -0.05, but must be finite and at least 0",
        ),
        (
            "tax",
            "food = 0.05",
            "bread = 0.05",
            "scenario.toml:6: `tax.rate`: there is no `bread`: choose food, tools, services",
        ),
        (
            "tax",
            "workers = 0.8",
            "workers = 0.9",
            "scenario.toml:7: `tax.to`: the parts sum to 1.1, but must sum to 1",
        ),
        ("tax", "rate = {", "rates = {", "scenario.toml:6: `rates`: unknown field `rates`"),
        (
            "tax",
            "to = { workers = 0.8, merchants = 0.2 }",
            "",
            "scenario.toml:5: `to`: missing field `to`",
        ),
        (
            "tariff",
            "food = 0.1",
            "services = 0.1",
            "scenario.toml:7: `tariff.rate`: there is no `services`: choose food, tools",
        ),
        (
            "quota",
            "food = 3.0",
            "food = 0.0",
            "scenario.toml:6: `quota.limit.food`: is 0, but must be positive",
        ),
        (
            "emission_cap",
            ", services = 0.0",
            "",
            "scenario.toml:8: `emission_cap.intensity`: has no number for services",
        ),
        (
            "emission_cap",
            "limit = 5.4",
            "limit = nan",
            "scenario.toml:7: `emission_cap.limit`: is NaN, but must be positive",
        ),
        (
            "rationing",
            "limit.merchants",
            "limit.nobility",
            "scenario.toml:7: `rationing.limit`: there is no `nobility`: choose workers, merchants",
        ),
        (
            "rationing",
            "food = 2.4",
            "food = -2.4",
            "scenario.toml:6: `rationing.limit.workers.food`: is -2.4, but must be positive",
        ),
    ] {
        let said = said(name, from, to);
        assert!(said.starts_with(message), "{said}\ninstead of\n{message}");
    }
}

#[test]
fn a_file_that_is_not_there_is_named() {
    let Err(error) = Scenario::read(&folder().join("nowhere.toml")) else { panic!("it is read") };
    assert!(error.to_string().contains("nowhere.toml"), "{error}");
}
