//! Laws of mechanics: no penetration, Coulomb's law, rest, rods.

use super::{bodies, set};
use mcp_core::dynamics::{
    Axis, Body, Contact, DynamicsError, Mechanics, MoreauJean, Obstacle, Scheme, TimeStepper,
    step_options,
};

#[test]
fn nothing_penetrates_deeper_than_half_a_step() {
    // Without reaction the gap ends above −½ h |u|, and |u| is at most twice the largest speed.
    for (name, h) in [
        ("bouncing_ball", 0.005),
        ("column_of_beads", 5e-4),
        ("hopper", 0.001),
        ("pendulum", 0.002),
    ] {
        for factor in [1.0, 0.5, 0.25] {
            let mut system = bodies(name, |table| set(table, "time", "step", factor * h));
            let (mut worst, mut fastest) = (0.0_f64, 0.0_f64);
            while system.step().unwrap().time < 2.0 {
                let gaps = system.gaps().into_iter();
                worst = gaps.fold(worst, |worst, gap| worst.max(-gap));
                let speeds = system.velocities().iter().map(|v| v.abs());
                fastest = speeds.fold(fastest, f64::max);
            }
            assert!(worst <= factor * h * fastest, "{name}: {worst:e}");
        }
    }
}

#[test]
fn coulombs_law_holds_at_every_contact() {
    // With little friction, so that the first impact does not yet make the ball roll.
    const MU: f64 = 0.02;
    let mut system = bodies("ball_with_friction", |table| {
        let contacts = table.get_mut("contact").and_then(toml::Value::as_array_mut).unwrap();
        contacts[0].as_table_mut().unwrap().insert("friction".to_owned(), MU.into());
    });
    let (mut sliding, mut sticking) = (0, 0);
    for _ in 0..2000 {
        let report = system.step().unwrap();
        for reaction in system.reactions() {
            let limit = MU * reaction.normal;
            assert!(reaction.normal >= 0.0, "{reaction:?}");
            assert!(reaction.tangential.abs() <= limit * (1.0 + 1e-12), "{reaction:?}");
            if reaction.slip.abs() > 1e-9 {
                sliding += 1;
                let against = -limit * reaction.slip.signum();
                assert!((reaction.tangential - against).abs() <= 1e-12, "{reaction:?}");
            } else {
                sticking += 1;
            }
            // Newton's law: u⁺ + e u >= 0, and 0 where it is in contact.
            let impact = reaction.rate.1 + 0.9 * reaction.rate.0;
            assert!(impact >= -1e-12, "t = {}: {reaction:?}", report.time);
            assert!(reaction.normal == 0.0 || impact <= 1e-12, "{reaction:?}");
        }
    }
    assert!(sliding > 0 && sticking > 100, "{sliding} {sticking}");
}

/// A block on an inclined plane whose friction is `mu`, at rest.
fn block_on_a_slope(mu: f64, slope: f64) -> Result<MoreauJean, DynamicsError> {
    let mut system = Mechanics::new();
    let body = Body::new("block", 2.0).moving(Axis::X, 0.0, 0.0).moving(Axis::Y, 0.0, 0.0);
    let block = system.add_body(&body)?;
    system.add_gravity(9.81)?;
    let plane = Obstacle::Plane { normal: [-slope, 1.0], offset: 0.0 };
    system.add_contact(Contact::new("slope", block, plane).friction(mu))?;
    MoreauJean::new(system, Scheme::new(0.005), &step_options())
}

#[test]
fn rest_stays_at_rest_for_100_000_steps() {
    let ball = bodies("bouncing_ball", |table| {
        let bodies = table.get_mut("body").and_then(toml::Value::as_array_mut).unwrap();
        bodies[0].as_table_mut().unwrap().insert("y".to_owned(), vec![0.0, 0.0].into());
    });
    let beads = bodies("column_of_beads", |table| {
        let bodies = table.get_mut("body").and_then(toml::Value::as_array_mut).unwrap();
        for (k, body) in bodies.iter_mut().enumerate() {
            // Closed in spite of rounding: each gap is −1e-12 m.
            let y = 0.1 + k as f64 * 0.2 - (k + 1) as f64 * 1e-12;
            body.as_table_mut().unwrap().insert("y".to_owned(), vec![y, 0.0].into());
        }
    });
    for (name, mut system) in
        [("ball", ball), ("beads", beads), ("block", block_on_a_slope(0.5, 0.3).unwrap())]
    {
        let mut fastest = 0.0_f64;
        for _ in 0..100_000 {
            system.step().unwrap_or_else(|error| panic!("{name}: {error}"));
            fastest = system.velocities().iter().fold(fastest, |most, v| most.max(v.abs()));
        }
        assert!(fastest <= 1e-12, "{name}: {fastest:e}");
    }
}

#[test]
fn a_block_slides_where_the_slope_is_steeper_than_its_friction() {
    // Along the slope: a = g (sin α − μ cos α).
    let (mu, slope) = (0.2_f64, 0.3_f64);
    let mut system = block_on_a_slope(mu, slope).unwrap();
    for _ in 0..200 {
        system.step().unwrap();
    }
    let speed = system.velocities()[0].hypot(system.velocities()[1]);
    let cosine = 1.0 / slope.hypot(1.0);
    let expected = 9.81 * cosine * (slope - mu) * 200.0 * 0.005;
    assert!((speed - expected).abs() < 1e-9, "{speed} {expected}");
}

#[test]
fn a_rod_keeps_its_length_to_second_order() {
    let drift = [0.004, 0.002, 0.001].map(|h| {
        let mut system = bodies("pendulum", |table| set(table, "time", "step", h));
        let mut worst = 0.0_f64;
        while system.step().unwrap().time < 3.0 {
            let &[x, y] = system.positions() else { panic!("the mass has x and y") };
            worst = worst.max((x.hypot(y) - 1.0).abs());
        }
        worst
    });
    for halved in drift.windows(2) {
        assert!(halved[1] < 0.3 * halved[0], "{drift:?}");
    }
}
