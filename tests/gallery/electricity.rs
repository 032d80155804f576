//! The screening curve says what is built and what it earns; a linear program says the same.

#[path = "../../examples/electricity.rs"]
#[allow(dead_code, reason = "`main` is run as an example")]
mod example;

use example::{CAPACITY, CAPPED, DATA, Electricity, SCARCITY};
use mcp_core::{Method, Options, solve};

/// Capital [$/kW a] and variable cost [$/MWh], as in `technologies.csv`.
const COSTS: [(f64, f64); 4] = [(480.0, 10.0), (220.0, 45.0), (110.0, 70.0), (55.0, 110.0)];
/// Hours [h/a] and load [GW], as in `segments.csv`, the highest load first.
const YEAR: [(f64, f64); 7] = [
    (5.0, 80.0),
    (45.0, 76.0),
    (200.0, 68.0),
    (1000.0, 60.0),
    (2500.0, 50.0),
    (2510.0, 42.0),
    (2500.0, 35.0),
];

/// Least cost [$/kW a] of a slice of load that lasts `hours`, and its technology; `None` sheds it.
fn screen(voll: f64, hours: f64) -> (f64, Option<usize>) {
    let built = COSTS.iter().enumerate().map(|(i, (k, c))| (k + c * hours / 1000.0, Some(i)));
    let shed = (voll * hours / 1000.0, None);
    built.chain([shed]).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
}

/// Prices [$/MWh], capacities and loads not served [GW].
fn in_closed_form(voll: f64) -> ([f64; 7], [f64; 4], [f64; 7]) {
    let (mut prices, mut capacities, mut shed) = ([0.0; 7], [0.0; 4], [0.0; 7]);
    let (mut lasting, mut below) = (0.0, 0.0);
    for (s, (hours, load)) in YEAR.iter().enumerate() {
        lasting += hours;
        let (cost, technology) = screen(voll, lasting);
        prices[s] = 1000.0 * (cost - below) / hours;
        below = cost;
        let slice = load - YEAR.get(s + 1).map_or(0.0, |next| next.1);
        match technology {
            Some(i) => capacities[i] += slice,
            None => shed[..=s].iter_mut().for_each(|shed| *shed += slice),
        }
    }
    (prices, capacities, shed)
}

#[test]
fn the_numbers_of_the_example_are_those_of_the_screening_curve() {
    for (case, (voll, asserted)) in [(5000.0, SCARCITY), (300.0, CAPPED)].into_iter().enumerate() {
        let (prices, capacities, shed) = in_closed_form(voll);
        for (s, (segment, price, lost)) in asserted.into_iter().enumerate() {
            assert!((prices[s] - price).abs() < 5e-4, "{segment}: {}", prices[s]);
            assert!((shed[s] - lost).abs() < 1e-12, "{segment}: {}", shed[s]);
        }
        for (i, (technology, capacity)) in CAPACITY.into_iter().enumerate() {
            assert!((capacities[i] - capacity[case]).abs() < 1e-12, "{technology}");
        }
    }
}

#[test]
fn plants_prices_and_shedding_agree_with_the_screening_curve() {
    let mut model = Electricity::read(DATA.as_ref()).unwrap();
    for voll in [5000.0, 300.0] {
        model.set_parameter("voll", &[voll]).unwrap();
        let options = Options::new(Method::NewtonMinFb);
        let solution = solve(&model, &options).unwrap().solved().unwrap();
        let view = model.view(&solution).unwrap();
        let (prices, capacities, shed) = in_closed_form(voll);
        for (found, expected) in [
            (view.p.values(), &prices[..]),
            (view.k.values(), &capacities[..]),
            (view.u.values(), &shed[..]),
        ] {
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-6, "{found} is not {expected}");
            }
        }
    }
}

/// The equilibrium is the linear program of least cost: feasible plants and feasible prices of the
/// same value, so that both are best.
#[test]
fn least_cost_is_the_value_of_the_load_at_the_prices() {
    let model = Electricity::read(DATA.as_ref()).unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    let (q, k, u, p) = (view.q.values(), view.k.values(), view.u.values(), view.p.values());
    let (mut cost, mut value) = (0.0, 0.0);
    for (i, (capital, _)) in COSTS.iter().enumerate() {
        cost += 1000.0 * capital * k[i];
        let rent = |(s, (hours, _)): (usize, &(f64, f64))| hours * (p[s] - COSTS[i].1).max(0.0);
        let rents: f64 = YEAR.iter().enumerate().map(rent).sum();
        assert!(rents < 1000.0 * capital + 1e-6, "prices are feasible");
    }
    for (s, (hours, load)) in YEAR.iter().enumerate() {
        let served: f64 = (0..4).map(|i| q[i * 7 + s]).sum();
        assert!(served + u[s] > load - 1e-9 && p[s] < 5000.0 + 1e-9, "{s} is feasible");
        let fuel: f64 = (0..4).map(|i| COSTS[i].1 * q[i * 7 + s]).sum();
        cost += hours * (fuel + 5000.0 * u[s]);
        value += hours * p[s] * load;
    }
    assert!((cost - value).abs() < 1e-9 * cost, "{cost} is not {value}");
}
