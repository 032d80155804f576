//! An effect that is not named costs nothing: a scene whose file has its data, and one that has
//! never heard of it, are the same step by step, bit for bit, in unknowns, nonzeros and operations.

use super::files::effect::Effect;
use super::files::effects::Effect as _;
use super::files::scene::Scene;
use super::{all, text_of};
use toml::{Table, Value};

/// Steps compared: every scene has closed contacts, or pairs, within them.
const STEPS: u64 = 700;

/// Tables that are the data of an effect.
const TABLES: [&str; 8] =
    ["gravity", "spring", "damper", "drag", "contact", "joint", "relay", "sliding_mode"];

fn entries<'a>(table: &'a mut Table, key: &str) -> Option<&'a mut Vec<Value>> {
    table.get_mut(key).and_then(Value::as_array_mut)
}

/// The scene's text without the names of these effects, and without their data if asked for.
fn without(text: &str, off: &[&str], forget: bool) -> String {
    let mut table: Table = text.parse().expect("the scene is well formed");
    if let Some(effects) = entries(&mut table, "effects") {
        effects.retain(|effect| !off.contains(&effect.as_str().unwrap_or_default()));
    }
    for effect in off.iter().filter(|_| forget) {
        if TABLES.contains(effect) {
            table.remove(*effect);
        } else if let Some(elements) = entries(&mut table, "element") {
            elements.retain(|element| element["kind"].as_str() != Some(effect));
        } else {
            for contact in entries(&mut table, "contact").into_iter().flatten() {
                contact.as_table_mut().expect("a contact is a table").remove(*effect);
            }
        }
    }
    toml::to_string(&table).expect("it was read from text")
}

/// All sets of one or two effects that can be switched off, with what makes no sense without them.
fn sets(effects: &[&'static str]) -> Vec<Vec<&'static str>> {
    let mut sets = Vec::new();
    for (k, &first) in effects.iter().enumerate() {
        for &second in &effects[k..] {
            let mut set = vec![first, second];
            if set.contains(&"contact") {
                let on_contact = ["restitution", "friction"];
                set.extend(on_contact.into_iter().filter(|effect| effects.contains(effect)));
            }
            set.sort_unstable();
            set.dedup();
            sets.push(set);
        }
    }
    sets
}

fn bits(state: &[f64]) -> Vec<u64> {
    state.iter().map(|x| x.to_bits()).collect()
}

#[test]
fn an_effect_that_is_not_named_costs_nothing() {
    let mut compared = 0;
    for name in all().into_iter().filter(|name| name != "zhuravlev_ivanov") {
        let text = text_of(&name);
        let effects = Scene::parse(&name, &text).unwrap().effects;
        let effects: Vec<&'static str> = effects.into_iter().map(Effect::name).collect();
        for off in sets(&effects) {
            let case = format!("{name} without {off:?}");
            let parse = |forget| {
                let text = without(&text, &off, forget);
                Scene::parse(&name, &text).unwrap_or_else(|error| panic!("{case}: {error}"))
            };
            let (mut unnamed, mut unheard) = (parse(false), parse(true));
            assert_eq!(unnamed.stepper.state_names(), unheard.stepper.state_names(), "{case}");
            for _ in 0..STEPS {
                let reports = [unnamed.stepper.step(), unheard.stepper.step()];
                let [a, b] = reports.map(|report| report.unwrap_or_else(|e| panic!("{case}: {e}")));
                assert_eq!(a, b, "{case}");
                assert_eq!(unnamed.stepper.size(), unheard.stepper.size(), "{case}");
                let states = [unnamed.stepper.state(), unheard.stepper.state()];
                assert_eq!(bits(&states[0]), bits(&states[1]), "{case}, t = {}", a.time);
            }
            compared += 1;
        }
    }
    assert!(compared >= 50, "{compared}");
}

#[test]
fn an_effect_that_is_named_costs_something() {
    // Largest problem of the first steps, and operations over all of them.
    let cost = |name: &str, text: &str| {
        let mut scene = Scene::parse(name, text).unwrap();
        let (mut unknowns, mut operations) = (0, 0);
        for _ in 0..STEPS {
            unknowns = unknowns.max(scene.stepper.step().unwrap().unknowns);
            operations += scene.stepper.size().operations;
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
        let off = if effect == "contact" { vec!["contact", "restitution"] } else { vec![effect] };
        let (on, off) = (cost(name, &text), cost(name, &without(&text, &off, true)));
        assert!(off.0 <= on.0 && off.1 < on.1, "{name}, {effect}: {off:?} {on:?}");
    }
}

#[test]
fn a_ball_in_flight_solves_no_problem() {
    let mut scene = super::scene("bouncing_ball");
    // Free fall from 1 m takes 0.4515 s: 90 steps of 5 ms.
    for _ in 0..90 {
        assert_eq!(scene.stepper.step().unwrap().unknowns, 0);
        assert_eq!(scene.stepper.size().nonzeros, 0);
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
    entries(&mut table, "effects").unwrap().reverse();
    let reversed = toml::to_string(&table).unwrap();
    let [mut a, mut b] = [&text, &reversed].map(|text| Scene::parse("hopper", text).unwrap());
    for _ in 0..STEPS {
        a.stepper.step().unwrap();
        b.stepper.step().unwrap();
        assert_eq!(bits(&a.stepper.state()), bits(&b.stepper.state()));
    }
}
