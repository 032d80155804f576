//! Energy: conserved in flight, balanced in every step, and where it can rise.

use super::{bodies, entries, name_effects, scene, set};
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

/// The step size of a scene.
fn step_of(table: &toml::Table) -> f64 {
    table["time"]["step"].as_float().expect("it has a step")
}

/// Steps of a flight.
const FLIGHT: u32 = 5000;

/// All bodies of a scene thrown upwards so fast that they come back after [`FLIGHT`] steps, the first
/// one metre per second faster where a spring holds it.
fn thrown(name: &str, effects: &[&str]) -> MoreauJean {
    bodies(name, |table| {
        name_effects(table, effects);
        let up = 9.81 * step_of(table) * f64::from(FLIGHT) / 2.0;
        for (k, body) in entries(table, "body").iter_mut().enumerate() {
            let faster = if k == 0 && effects.contains(&"spring") { 1.0 } else { 0.0 };
            let height = body["y"][0].as_float().expect("it has a height");
            body["y"] = vec![height, up + faster].into();
        }
    })
}

#[test]
fn a_flight_conserves_energy_to_1e_12() {
    for (name, effects) in [
        ("bouncing_ball", &["gravity", "contact", "restitution"][..]),
        ("column_of_beads", &["gravity", "contact", "restitution"]),
        ("ball_with_friction", &["gravity", "contact", "restitution", "friction"]),
        ("hopper", &["gravity", "spring", "contact"]),
        ("pendulum", &["gravity", "contact", "restitution"]),
    ] {
        let mut system = thrown(name, effects);
        let start = system.energy().unwrap();
        for step in 1..=FLIGHT {
            assert_eq!(system.step().unwrap().unknowns, 0, "{name}, step {step}");
            let change = system.energy().unwrap() - start;
            let relative = change.abs() / start.abs();
            assert!(relative <= 1e-12, "{name}, step {step}: {relative:e}");
        }
    }
}

#[test]
fn the_energy_of_every_step_is_balanced() {
    for name in SCENES {
        let system = bodies(name, |_| ());
        let start = system.energy().unwrap().abs();
        for (k, balance) in balances(system, 10.0).into_iter().enumerate() {
            let EnergyBalance { change, reactions, damping, .. } = balance;
            let error = (change - reactions - damping).abs();
            assert!(error <= 1e-12 * start.max(1.0), "{name}, step {}: {error:e}", k + 1);
            assert!(damping <= 0.0, "{name}: damping gives energy");
        }
    }
}

/// Resistors and diodes take energy, inductors and capacitors keep it; a step in which a diode switches
/// is right to first order only.
#[test]
fn the_energy_of_a_circuit_rises_at_switches_alone() {
    for name in ["rlc_diode", "diode_bridge"] {
        let mut scene = scene(name);
        let mut before = scene.stepper.energy().expect("a circuit has energy");
        let (start, mut active) = (before, 0);
        for step in 1..=scene.steps {
            let now = scene.stepper.step().unwrap().active;
            let energy = scene.stepper.energy().unwrap();
            let allowed = if now == active { 1e-12 } else { 1e-4 };
            assert!(
                energy <= before + allowed * start,
                "{name}, step {step}: {before} to {energy}"
            );
            (before, active) = (energy, now);
        }
        assert!(before < 0.9 * start, "{name}: {start} to {before}");
    }
}

/// The worst rise of a step up to a time while the step size is halved.
fn worst_rises(name: &str, end: f64, edit: impl Fn(&mut toml::Table)) -> [f64; 4] {
    [1.0, 0.5, 0.25, 0.125].map(|factor| {
        let system = bodies(name, |table| {
            let h = step_of(table);
            set(table, "time", "step", factor * h);
            edit(table);
        });
        balances(system, end).into_iter().map(|balance| balance.change).fold(0.0, f64::max)
    })
}

/// Friction with restitution is not among them: Newton's law of impact looks at normal velocities
/// alone, so that the two together can create energy.
#[test]
fn a_rise_of_energy_falls_with_the_step() {
    for (name, end, effects) in [
        ("column_of_beads", 2.0, &["gravity", "contact", "restitution"][..]),
        ("ball_with_friction", 10.0, &["gravity", "contact", "restitution"]),
        ("pendulum", 10.0, &["gravity", "joint", "contact"]),
    ] {
        let rises = worst_rises(name, end, |table| name_effects(table, effects));
        assert!(rises[0] > 1e-11, "{name}: {rises:?}");
        for halved in rises.windows(2) {
            // Up to rounding of energies of about 10 J.
            assert!(halved[1] <= 0.5 * halved[0] + 1e-14, "{name}: {rises:?}");
        }
    }
}

/// Energy rises where a contact that already opens, `u > 0`, is pressed again within the step: by
/// `½ m (1−e) u (g h − (1+e) u)`, at most at `u = g h / 2(1+e)`.
#[test]
fn the_energy_of_a_ball_rises_by_order_h_squared() {
    for e in [0.0, 0.3, 0.5, 0.7, 0.9] {
        for gamma in [0.5, 1.0] {
            let rises = worst_rises("bouncing_ball", 10.0, |table| {
                set(table, "time", "gamma", gamma);
                let floor = entries(table, "contact")[0].as_table_mut().unwrap();
                floor.insert("restitution".to_owned(), e.into());
            });
            for (rise, h) in rises.into_iter().zip([5e-3, 2.5e-3, 1.25e-3, 6.25e-4]) {
                let bound = (1.0 - e) / (8.0 * (1.0 + e)) * (9.81_f64 * h).powi(2);
                assert!(rise <= bound + 1e-14, "e = {e}, h = {h}: {rise:e} {bound:e}");
                // Without restitution the first impact is the last.
                assert_eq!(rise > 1e-12, e > 0.0, "e = {e}, h = {h}: {rise:e}");
            }
        }
    }
}

/// Where impacts do not bounce, or drag takes more than a step can give.
#[test]
fn energy_never_rises_in_these_scenes() {
    for (name, end, effects) in [
        ("hopper", 4.0, None),
        ("pendulum", 10.0, None),
        ("ball_with_friction", 10.0, Some(&["gravity", "contact", "friction"][..])),
    ] {
        let rises = worst_rises(name, end, |table| {
            if let Some(effects) = effects {
                name_effects(table, effects);
            }
        });
        // Up to rounding of energies of about 10 J.
        assert!(rises.iter().all(|&rise| rise <= 1e-14), "{name}: {rises:?}");
    }
}
