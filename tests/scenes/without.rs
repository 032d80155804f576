//! What is not there is not computed: a ball in flight solves no problem, effects that are named cost
//! something, and the order of their names changes nothing. That an effect which is not named costs
//! nothing is shown in `twins`.

use super::files::effect::Effect;
use super::files::effects::Effect as _;
use super::files::scene::Scene;
use super::{bits, name_effects, text_of};
use toml::Table;

/// Steps compared: every scene has closed contacts, or pairs, within them.
const STEPS: u64 = 1200;

#[test]
fn an_effect_that_is_named_costs_something() {
    // Largest problem of the first steps, and most operations of one of them.
    let cost = |name: &str, text: &str| {
        let mut scene = Scene::parse(name, text).unwrap();
        let (mut unknowns, mut operations) = (0, 0);
        for _ in 0..STEPS {
            unknowns = unknowns.max(scene.stepper.step().unwrap().unknowns);
            operations = operations.max(scene.stepper.size().unwrap().operations);
        }
        (unknowns, operations)
    };
    for (name, effect) in [
        ("ball_with_friction", "friction"),
        ("bouncing_ball", "contact"),
        ("hopper", "spring"),
        ("hopper", "damper"),
        ("hopper", "drag"),
        ("pendulum", "joint"),
        ("rlc_diode", "diode"),
        ("two_relays", "relay"),
        ("twisting", "sliding_mode"),
    ] {
        let text = text_of(name);
        let effects = Scene::parse(name, &text).unwrap().effects;
        let mut names: Vec<&str> = effects.into_iter().map(Effect::name).collect();
        names.retain(|&other| other != effect && (effect, other) != ("contact", "restitution"));
        let mut table: Table = text.parse().unwrap();
        name_effects(&mut table, &names);
        let (on, off) = (cost(name, &text), cost(name, &toml::to_string(&table).unwrap()));
        assert!(off.0 <= on.0 && off.1 < on.1, "{name}, {effect}: {off:?} {on:?}");
    }
}

#[test]
fn a_ball_in_flight_solves_no_problem() {
    let mut scene = super::scene("bouncing_ball");
    // Free fall from 1 m takes 0.4515 s: 90 steps of 5 ms.
    for _ in 0..90 {
        assert_eq!(scene.stepper.step().unwrap().unknowns, 0);
        assert_eq!(scene.stepper.size().unwrap().nonzeros, 0);
    }
    let impact = scene.stepper.step().unwrap();
    assert_eq!((impact.unknowns, impact.active), (1, 1));
    // A problem is solved where the gap is about to close, γ = ½, and nowhere else.
    let (mut problems, mut closing) = (0, 0);
    for _ in 91..scene.steps {
        let state = scene.stepper.state();
        closing += u64::from(state[0] + 0.5 * 0.005 * state[1] <= 0.0);
        problems += u64::from(scene.stepper.step().unwrap().unknowns > 0);
    }
    assert_eq!(problems, closing);
    assert!(problems > 100 && problems < scene.steps / 2, "{problems}");
}

#[test]
fn the_order_in_which_effects_are_named_changes_nothing() {
    let text = text_of("hopper");
    let mut table: Table = text.parse().unwrap();
    name_effects(&mut table, &["contact", "drag", "damper", "spring", "gravity"]);
    let reversed = toml::to_string(&table).unwrap();
    let [mut a, mut b] = [&text, &reversed].map(|text| Scene::parse("hopper", text).unwrap());
    for _ in 0..STEPS {
        a.stepper.step().unwrap();
        b.stepper.step().unwrap();
        assert_eq!(bits(&a.stepper.state()), bits(&b.stepper.state()));
    }
}
