//! Energy: conserved in flight, balanced in every step, and where it can rise.

use super::{bodies, name_effects, set};
use mcp_core::dynamics::{EnergyBalance, MoreauJean, TimeStepper};

/// Scenes with bodies.
const SCENES: [&str; 5] =
    ["bouncing_ball", "column_of_beads", "ball_with_friction", "hopper", "pendulum"];

/// All balances of a run up to a time.
fn balances(mut system: MoreauJean, end: f64) -> Vec<EnergyBalance> {
    let mut balances = Vec::new();
    loop {
        let report = system.step().unwrap_or_else(|error| panic!("{error}"));
        balances.push(system.balance());
        if report.time >= end {
            return balances;
        }
    }
}

#[test]
fn a_flight_conserves_energy_to_1e_12() {
    for (name, effects) in [
        ("bouncing_ball", &["gravity"][..]),
        ("ball_with_friction", &["gravity"]),
        ("hopper", &["gravity", "spring"]),
    ] {
        let mut system = bodies(name, |table| name_effects(table, effects));
        let start = system.energy().unwrap();
        for _ in 0..5000 {
            assert_eq!(system.step().unwrap().unknowns, 0);
            // Potential energy falls without limit: relative to the kinetic energy it became.
            let scale = start.abs() + system.velocities().iter().map(|v| v * v).sum::<f64>();
            let change = system.energy().unwrap() - start;
            assert!(change.abs() <= 1e-12 * scale, "{name}: {change:e} of {scale:e}");
        }
    }
}

#[test]
fn the_energy_of_every_step_is_balanced() {
    for name in SCENES {
        let system = bodies(name, |_| ());
        let start = system.energy().unwrap().abs();
        for (k, balance) in balances(system, 2.0).into_iter().enumerate() {
            let EnergyBalance { change, reactions, damping, .. } = balance;
            let error = (change - reactions - damping).abs();
            assert!(error <= 1e-12 * start.max(1.0), "{name}, step {}: {error:e}", k + 1);
            assert!(damping <= 0.0, "{name}: damping gives energy");
        }
    }
}

/// The worst rise of a step while the step size is halved.
fn worst_rises(name: &str, h: f64, effects: Option<&[&str]>) -> [f64; 4] {
    [1.0, 0.5, 0.25, 0.125].map(|factor| {
        let system = bodies(name, |table| {
            set(table, "time", "step", factor * h);
            if let Some(effects) = effects {
                name_effects(table, effects);
            }
        });
        balances(system, 2.0).into_iter().map(|balance| balance.change).fold(0.0, f64::max)
    })
}

/// Friction with restitution is not among them: Newton's law of impact looks at normal velocities
/// alone, so that the two together can create energy.
#[test]
fn a_rise_of_energy_falls_with_the_step() {
    for (name, h, effects) in [
        ("bouncing_ball", 0.005, None),
        ("column_of_beads", 5e-4, None),
        ("hopper", 0.001, None),
        ("ball_with_friction", 0.005, Some(&["gravity", "contact", "friction"][..])),
        ("pendulum", 0.002, None),
    ] {
        let rises = worst_rises(name, h, effects);
        for halved in rises.windows(2) {
            // Up to rounding of energies of about 100 J.
            assert!(halved[1] <= 0.5 * halved[0] + 1e-12, "{name}: {rises:?}");
        }
    }
}
