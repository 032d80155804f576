//! Laws of mechanics: no penetration, Coulomb's law, rest, rods.

use super::files::effect::Effect;
use super::{all, bodies, entries, scene, set};
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
        ("ball_with_friction", 0.005),
        ("hopper", 0.001),
        ("pendulum", 0.002),
    ] {
        for factor in [1.0, 0.5, 0.25] {
            let mut system = bodies(name, |table| set(table, "time", "step", factor * h));
            let (mut worst, mut fastest) = (0.0_f64, 0.0_f64);
            while system.step().unwrap().time < 10.0 {
                let gaps = system.gaps().into_iter();
                worst = gaps.fold(worst, |worst, gap| worst.max(-gap));
                let speeds = system.velocities().iter().map(|v| v.abs());
                fastest = speeds.fold(fastest, f64::max);
            }
            assert!(worst <= factor * h * fastest, "{name}: {worst:e}");
        }
    }
}

/// Checks Coulomb's and Newton's law at every contact of the last step: `|r_t| <= μ r_n`, against the
/// slip where there is one; `u⁺ + e u >= 0`, and 0 where `r_n > 0`; all to what a solve asks for. Returns the numbers of contacts that
/// slide and that stick.
fn check_laws(case: &str, system: &MoreauJean, mu: f64, e: f64) -> [usize; 2] {
    let (mut sliding, mut sticking) = (0, 0);
    for reaction in system.reactions() {
        let limit = mu * reaction.normal;
        assert!(reaction.normal >= 0.0, "{case}: {reaction:?}");
        // To the residual that a solve asks for.
        assert!(reaction.tangential.abs() <= limit + 1e-13, "{case}: {reaction:?}");
        if reaction.slip.abs() > 1e-9 {
            sliding += usize::from(reaction.normal > 0.0);
            let against = -limit * reaction.slip.signum();
            let error = (reaction.tangential - against).abs();
            assert!(error <= 1e-12, "{case}: {reaction:?}");
        } else {
            sticking += usize::from(reaction.normal > 0.0);
        }
        let impact = reaction.rate.1 + e * reaction.rate.0;
        assert!(impact >= -1e-12, "{case}: {reaction:?}");
        assert!(reaction.normal <= 1e-13 || impact <= 1e-12, "{case}: {reaction:?}");
    }
    [sliding, sticking]
}

#[test]
fn coulombs_law_holds_at_every_contact_of_every_step() {
    let mut scenes = 0;
    for name in all().iter().filter(|name| scene(name).effects.contains(&Effect::Friction)) {
        let (steps, mut sliding, mut sticking) = (scene(name).steps, 0, 0);
        // As it stands, and with little friction, so that the first impact does not yet make it roll.
        for mu in [None, Some(0.02)] {
            let (mut given, mut bounce) = (f64::NAN, f64::NAN);
            let mut system = bodies(name, |table| {
                let [contact] = &mut entries(table, "contact")[..] else { panic!("one contact") };
                let contact = contact.as_table_mut().unwrap();
                if let Some(mu) = mu {
                    contact.insert("friction".to_owned(), mu.into());
                }
                given = contact["friction"].as_float().unwrap();
                bounce = contact["restitution"].as_float().unwrap();
            });
            for _ in 0..steps {
                system.step().unwrap();
                let found = check_laws(name, &system, given, bounce);
                (sliding, sticking) = (sliding + found[0], sticking + found[1]);
            }
        }
        assert!(sliding > 0 && sticking > 100, "{name}: {sliding} {sticking}");
        scenes += 1;
    }
    assert_eq!(scenes, 1);
}

/// Two discs side by side on a floor between walls, a third thrown on top of them: seven contacts.
fn pile_of_discs(mu: f64) -> Result<MoreauJean, DynamicsError> {
    let mut system = Mechanics::new();
    let disc = |name: &str, x: f64, y: f64, v: f64| {
        let body = Body::new(name, 1.0).radius(0.5).turning(0.125, 0.0, 0.0);
        body.moving(Axis::X, x, 0.0).moving(Axis::Y, y, v)
    };
    let left = system.add_body(&disc("left", -0.51, 0.5, 0.0))?;
    let right = system.add_body(&disc("right", 0.51, 0.5, 0.0))?;
    let top = system.add_body(&disc("top", 0.05, 2.0, -1.0).turning(0.125, 0.0, 8.0))?;
    system.add_gravity(9.81)?;
    let plane = |normal, offset| Obstacle::Plane { normal, offset };
    let floor = plane([0.0, 1.0], 0.0);
    for (name, body, with) in [
        ("left floor", left, floor),
        ("right floor", right, floor),
        ("left wall", left, plane([1.0, 0.0], -1.1)),
        ("right wall", right, plane([-1.0, 0.0], -1.1)),
        ("left right", left, Obstacle::Body(right)),
        ("top left", top, Obstacle::Body(left)),
        ("top right", top, Obstacle::Body(right)),
    ] {
        system.add_contact(Contact::new(name, body, with).friction(mu))?;
    }
    MoreauJean::new(system, Scheme::new(0.002), &step_options())
}

#[test]
fn coulombs_law_holds_at_every_contact_of_a_pile() {
    for mu in [0.1, 0.3] {
        let mut system = pile_of_discs(mu).unwrap();
        let (mut sliding, mut sticking, mut most) = (0, 0, 0);
        for _ in 0..1500 {
            let report = system.step().unwrap_or_else(|error| panic!("μ = {mu}: {error}"));
            assert!(report.residual < 1e-10, "μ = {mu}: {report:?}");
            let found = check_laws("pile", &system, mu, 0.0);
            (sliding, sticking) = (sliding + found[0], sticking + found[1]);
            most = most.max(report.active);
        }
        assert!(sliding > 100 && sticking > 100 && most >= 4, "{sliding} {sticking} {most}");
    }
}

/// `s ∈ −Sign(v)`: dry friction as a relay.
#[test]
fn dry_friction_opposes_the_velocity_in_every_step() {
    let mut oscillator = scene("friction_oscillator");
    let (mut sliding, mut sticking) = (0, 0);
    for _ in 0..oscillator.steps {
        oscillator.stepper.step().unwrap();
        let state = oscillator.stepper.state();
        let [_, v, friction] = state[..] else { panic!("x, v, friction: {state:?}") };
        if v.abs() > 1e-9 {
            sliding += 1;
            assert!((friction + v.signum()).abs() <= 1e-12, "{state:?}");
        } else {
            sticking += 1;
            assert!(friction.abs() <= 1.0, "{state:?}");
        }
    }
    assert!(sliding > 100 && sticking > 100, "{sliding} {sticking}");
}

/// A block on an inclined plane whose friction is `mu`, at rest.
fn block_on_a_slope(mu: f64, slope: f64, x: f64) -> Result<MoreauJean, DynamicsError> {
    let mut system = Mechanics::new();
    let body = Body::new("block", 2.0).moving(Axis::X, x, 0.0).moving(Axis::Y, slope * x, 0.0);
    let block = system.add_body(&body)?;
    system.add_gravity(9.81)?;
    let plane = Obstacle::Plane { normal: [-slope, 1.0], offset: 0.0 };
    system.add_contact(Contact::new("slope", block, plane).friction(mu))?;
    MoreauJean::new(system, Scheme::new(0.005), &step_options())
}

#[test]
fn rest_stays_at_rest_for_100_000_steps() {
    let ball = bodies("bouncing_ball", |table| {
        entries(table, "body")[0]
            .as_table_mut()
            .unwrap()
            .insert("y".to_owned(), vec![0.0, 0.0].into());
    });
    let beads = bodies("column_of_beads", |table| {
        for (k, body) in entries(table, "body").iter_mut().enumerate() {
            // As a person writes them; rounded, some gaps are 1e-17 m.
            let y: f64 = format!("{:.1}", 0.1 + k as f64 * 0.2).parse().unwrap();
            body.as_table_mut().unwrap().insert("y".to_owned(), vec![y, 0.0].into());
        }
    });
    let disc = bodies("ball_with_friction", |table| {
        let disc = &mut entries(table, "body")[0];
        disc["y"] = vec![0.5, 0.0].into();
        disc["angle"] = vec![0.0, 0.0].into();
    });
    // The ball that has bounced until it rests.
    let mut bounced = bodies("bouncing_ball", |_| ());
    for _ in 0..2000 {
        bounced.step().unwrap();
    }
    for (name, mut system) in [
        ("ball", ball),
        ("beads", beads),
        ("disc with friction", disc),
        ("bounced ball", bounced),
        ("block", block_on_a_slope(0.5, 0.3, 0.0).unwrap()),
        ("block further up", block_on_a_slope(0.5, 0.3, 0.7).unwrap()),
    ] {
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
    let mut system = block_on_a_slope(mu, slope, 0.0).unwrap();
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
