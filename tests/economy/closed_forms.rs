//! Scenarios against formulas by hand, and against each other.

use super::economy::closed_form::{WAGE, expected};
use super::economy::data::{CIF, FOB, HOURS, LABOR, SHARE};
use super::economy::effect::Effect;
use super::{levels, sample};
use std::collections::BTreeMap;

const FREE: f64 = f64::INFINITY;
const TOLERANCE: f64 = 1e-10;

fn assert_near(case: &str, found: f64, value: f64) {
    let error = (found - value).abs() / value.abs().max(1.0);
    assert!(error <= TOLERANCE, "{case}: {found}, by hand {value}");
}

fn assert_expected(effects: &[Effect]) {
    let (levels, expected) = (levels(effects), expected(effects));
    assert!(!expected.is_empty());
    for (name, value) in expected {
        assert_near(&format!("{effects:?}: {name}"), levels[name], value);
    }
}

#[test]
fn free_trade_is_as_by_hand() {
    assert_expected(&[]);
    let levels = levels(&[]);
    assert_near("welfare", levels["welfare[workers]"], 20_000.0);
    assert_near("imports", levels["m[food]"], 3.25);
    assert_near("exports", levels["x[tools]"], 1.3);
}

#[test]
fn a_tax_is_as_by_hand() {
    for rate in [0.0, 0.1, 0.5, 2.0] {
        for to in [[1.0, 0.0], [0.3, 0.7], [0.0, 1.0]] {
            for shape in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.2, 1.0, 0.5]] {
                assert_expected(&[Effect::Tax { rate: shape.map(|part| rate * part), to }]);
            }
        }
    }
}

#[test]
fn a_quota_is_as_by_hand() {
    // Food made in the country below 2.6 to 2.7, a rent alone below 3.25, above nothing.
    for limit in [0.5, 1.5, 2.5, 2.8, 3.0, 3.2, 3.5, 10.0] {
        for to in [[1.0, 0.0], [0.3, 0.7], [0.0, 1.0]] {
            assert_expected(&[Effect::Quota { limit: [limit, FREE], to }]);
        }
    }
}

/// Tools `E/ε` are all that may be made; services employ the rest, and their market gives the wage:
///
/// ```text
/// Σ_h α_h (w L_h + to_h y (fob − w a)) = w Σ_h L_h − w a y
/// ```
#[test]
fn an_emission_cap_is_as_by_hand() {
    let (to, alpha) = (sample::TO_BOTH, SHARE.map(|share| share[2]));
    for limit in [5.2, 5.4, 5.9] {
        let tools = limit / sample::INTENSITY[1];
        let of_permits = alpha[0] * to[0] + alpha[1] * to[1];
        let services = LABOR[0] + LABOR[1] - HOURS[1] * tools;
        let of_wages = alpha[0] * LABOR[0] + alpha[1] * LABOR[1];
        let wage =
            of_permits * tools * FOB[1] / (services + of_permits * tools * HOURS[1] - of_wages);
        let levels = levels(&[Effect::EmissionCap { limit, intensity: sample::INTENSITY, to }]);
        assert_near("wage", levels["w"], wage);
        assert_near("permit", levels["permit"], (FOB[1] - wage * HOURS[1]) / sample::INTENSITY[1]);
        assert_near("tools", levels["y[tools]"], tools);
        assert_near("services", levels["y[services]"], services);
    }
}

/// A household that may buy `R` behaves as at the price `p + v` with the income `I + v R`:
/// `(p + v) R = α (I + v R)`.
#[test]
fn a_ration_is_as_by_hand() {
    let [alpha, _, _] = SHARE[0];
    let income = WAGE * LABOR[0];
    for ration in [1.0, 2.0, 2.9] {
        let scarcity = (alpha * income - CIF[0] * ration) / (ration * (1.0 - alpha));
        let limit = [[ration, FREE, FREE], [FREE; 3]];
        let levels = levels(&[Effect::Rationing { limit }]);
        assert_near("scarcity", levels["scarcity[workers, food]"], scarcity);
        assert_near("imports", levels["m[food]"], ration + SHARE[1][0] * WAGE * LABOR[1] / CIF[0]);
        // What is not spent on food goes to the others in proportion.
        let rest = (income - CIF[0] * ration) / (1.0 - alpha);
        assert_near("tools", levels["demand[workers, tools]"], SHARE[0][1] * rest / FOB[1]);
    }
}

/// Levels under these names agree.
fn assert_equal(one: &BTreeMap<String, f64>, other: &BTreeMap<String, f64>, names: &[&str]) {
    for &name in names {
        assert_near(name, one[name], other[name]);
    }
}

const ALLOCATION: [&str; 8] = [
    "w",
    "y[tools]",
    "y[services]",
    "m[food]",
    "income[workers]",
    "income[merchants]",
    "welfare[workers]",
    "welfare[merchants]",
];

#[test]
fn a_tariff_on_what_is_not_made_at_home_is_a_tax() {
    let to = sample::TO_BOTH;
    for rate in [0.05, 0.1, 0.2] {
        let tariff = levels(&[Effect::Tariff { rate: [rate, 0.0], to }]);
        let tax = levels(&[Effect::Tax { rate: [rate, 0.0, 0.0], to }]);
        assert_equal(&tariff, &tax, &ALLOCATION);
        assert_near("yield", tariff["duties"], tax["revenue"]);
    }
}

#[test]
fn a_markup_on_services_is_a_tax_of_its_owner() {
    let to = sample::TO_MERCHANTS;
    for rate in [0.05, 0.25, 1.0] {
        let markup = levels(&[Effect::Markup { rate: [0.0, 0.0, rate], to }]);
        let tax = levels(&[Effect::Tax { rate: [0.0, 0.0, rate], to }]);
        assert_equal(&markup, &tax, &ALLOCATION);
        assert_near("yield", markup["profits"], tax["revenue"]);
    }
}

/// J. Bhagwati (1965), On the equivalence of tariffs and quotas. In: Trade, Growth and the Balance of
/// Payments.
#[test]
fn a_quota_of_the_imports_under_a_tariff_is_that_tariff() {
    let to = sample::TO_BOTH;
    for rate in [0.05, 0.1, 0.2] {
        let tariff = levels(&[Effect::Tariff { rate: [rate, 0.0], to }]);
        let quota = levels(&[Effect::Quota { limit: [tariff["m[food]"], FREE], to }]);
        assert_equal(&tariff, &quota, &ALLOCATION);
        assert_near("price", tariff["p[food]"], quota["p[food]"]);
        assert_near("yield", tariff["duties"], quota["rents"]);
    }
}
