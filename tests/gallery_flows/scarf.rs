//! Scarf's economy, condition by condition: `p`, `y` from the solver, everything else from the files.

use crate::scarf::{NUMERAIRE, Scarf};
use crate::sheet::numbers;
use mcp_core::{Method, Options, solve, solve_from};

/// The tables: activities × goods, consumers × goods, consumers.
struct Economy {
    output: Vec<Vec<f64>>,
    owned: Vec<Vec<f64>>,
    reference: Vec<Vec<f64>>,
    sigma: Vec<f64>,
}

/// Prices and levels.
struct State {
    p: Vec<f64>,
    y: Vec<f64>,
}

fn economy() -> Economy {
    Economy {
        output: numbers("scarf/activities.csv"),
        owned: numbers("scarf/endowments.csv"),
        reference: numbers("scarf/demands.csv"),
        sigma: numbers("scarf/elasticities.csv").concat(),
    }
}

fn solved(options: &Options) -> State {
    let model = Scarf::read().unwrap();
    let view = model.view(&solve(&model, options).unwrap().solved().unwrap()).unwrap();
    State { p: view.p.values().to_vec(), y: view.y.values().to_vec() }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// What consumer `h` buys at prices `p`, worth what it owns.
fn bought(economy: &Economy, h: usize, p: &[f64]) -> Vec<f64> {
    let (sigma, wanted) = (economy.sigma[h], &economy.reference[h]);
    // Utility is largest where p (x/α)^(1/σ) is the same number for all goods: x = α (λ/p)^σ.
    let at_one: Vec<f64> = wanted.iter().zip(p).map(|(a, p)| a * p.powf(-sigma)).collect();
    let scale = dot(&economy.owned[h], p) / dot(&at_one, p);
    at_one.iter().map(|x| x * scale).collect()
}

/// What is left over of each good.
fn excess(economy: &Economy, state: &State) -> Vec<f64> {
    let consumers = 0..economy.owned.len();
    let bought: Vec<_> = consumers.map(|h| bought(economy, h, &state.p)).collect();
    let of_good = |table: &[Vec<f64>], c: usize| table.iter().map(|row| row[c]).sum::<f64>();
    let made = |c: usize| -> f64 {
        economy.output.iter().zip(&state.y).map(|(row, level)| row[c] * level).sum()
    };
    (0..state.p.len()).map(|c| made(c) + of_good(&economy.owned, c) - of_good(&bought, c)).collect()
}

#[test]
fn markets_clear() {
    let (economy, state) = (economy(), solved(&Options::default()));
    for (left, price) in excess(&economy, &state).into_iter().zip(&state.p) {
        // No good is free here, so none is left over.
        assert!(*price > 0.1);
        assert!(left.abs() < 1e-9, "{left}");
    }
}

#[test]
fn activities_that_are_used_earn_nothing_and_no_other_would_earn() {
    let (economy, state) = (economy(), solved(&Options::default()));
    for (row, level) in economy.output.iter().zip(&state.y) {
        let profit = dot(row, &state.p);
        assert!(profit < 1e-9, "{profit}");
        assert!(*level >= 0.0 && (level * profit).abs() < 1e-9, "{level} at {profit}");
    }
    let used = state.y.iter().filter(|level| **level > 1e-6).count();
    assert_eq!(used, 4, "regression value: d1, n1, n2 and c1");
}

#[test]
fn the_value_of_excess_supply_is_the_profit_at_any_prices() {
    // Walras' law: consumers spend what they have, whatever the prices and levels.
    let economy = economy();
    let state = State {
        p: vec![1.3, 0.4, 0.9, 2.0, 0.7, 1.1],
        y: vec![0.5, 0.1, 2.0, 0.3, 0.2, 0.4, 0.6, 0.9],
    };
    let profit: f64 =
        economy.output.iter().zip(&state.y).map(|(row, level)| level * dot(row, &state.p)).sum();
    let value = dot(&excess(&economy, &state), &state.p);
    assert!((value - profit).abs() < 1e-12 * value.abs().max(1.0), "{value} and {profit}");
}

#[test]
fn the_budget_that_is_not_imposed_is_kept() {
    let (economy, state) = (economy(), solved(&Options::default()));
    // What the first consumer owns is worth 9.1 at prices of 1: 1 + 3 + 5 + 0.1.
    assert!((dot(&economy.owned[0], &state.p) - 9.1).abs() < 1e-9);
}

#[test]
fn prices_double_with_the_numeraire_and_activities_stay() {
    let mut model = Scarf::read().unwrap();
    let once = model.view(&solve(&model, &Options::default()).unwrap().solved().unwrap()).unwrap();
    model.fix(NUMERAIRE, 18.2).unwrap();
    let twice = model.view(&solve(&model, &Options::default()).unwrap().solved().unwrap()).unwrap();
    for (once, twice) in once.p.values().iter().zip(twice.p.values()) {
        assert!((2.0 * once - twice).abs() < 1e-8);
    }
    for (once, twice) in once.y.values().iter().zip(twice.y.values()) {
        assert!((once - twice).abs() < 1e-8);
    }
}

#[test]
fn methods_and_starts_agree() {
    // Regression values: the equilibrium that the other tests verify, to six digits.
    let p = [1.132_500, 0.545_260, 1.061_885, 1.290_535, 0.827_654, 0.282_394];
    let y = [0.463_493, 0.0, 3.939_195, 0.006_023, 0.0, 0.0, 0.438_263, 0.0];
    let near = |found: &[f64], expected: &[f64]| {
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-6, "{found} is not {expected}");
        }
    };
    for method in [Method::Robust].into_iter().chain(Method::CLASSICAL) {
        let state = solved(&Options::new(method));
        near(&state.p, &p);
        near(&state.y, &y);
    }
    let model = Scarf::read().unwrap();
    for start in [0.3, 5.0] {
        let options = Options::new(Method::NewtonFb);
        let solution = solve_from(&model, &[start; 19], &options).unwrap().solved().unwrap();
        near(model.view(&solution).unwrap().p.values(), &p);
    }
}
