//! An effect whose data do not bind changes nothing.

use super::economy::effect::Effect;
use super::{levels, sample};

/// Numbers of two solves of one economy agree to this part.
const TOLERANCE: f64 = 1e-12;

/// What effects bring, and the prices they make.
const PAYMENTS: [&str; 7] = ["revenue", "duties", "rent", "rents", "permit", "profits", "scarcity"];

/// With the effect and without it all numbers that both have are the same, and the effect pays nothing.
fn assert_slack(effects: &[Effect], slack: &Effect) {
    let without = levels(effects);
    let with = levels(&[effects, std::slice::from_ref(slack)].concat());
    for (name, level) in &without {
        let error = (with[name] - level).abs() / level.abs().max(1.0);
        assert!(error <= TOLERANCE, "{slack:?} beside {effects:?}: {name} {level} {}", with[name]);
    }
    let is_payment = |name: &str| PAYMENTS.contains(&name.split('[').next().unwrap_or(name));
    let is_new = |name: &str| is_payment(name) && !without.contains_key(name);
    for (name, level) in with.iter().filter(|(name, _)| is_new(name)) {
        assert!(level.abs() <= TOLERANCE, "{slack:?} beside {effects:?}: {name} {level}");
    }
}

#[test]
fn an_effect_that_does_not_bind_changes_nothing() {
    for slack in sample::slack() {
        assert_slack(&[], &slack);
    }
}

#[test]
fn an_effect_that_does_not_bind_changes_nothing_beside_another() {
    for (k, slack) in sample::slack().into_iter().enumerate() {
        for (_, binding) in sample::all().into_iter().enumerate().filter(|(other, _)| *other != k) {
            assert_slack(&[binding], &slack);
        }
    }
}
