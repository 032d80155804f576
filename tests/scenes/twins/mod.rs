//! Scenes against steppers written by hand: for every effect and every pair of effects of every scene
//! that is switched off, a stepper that knows the other effects and no more. It has the bits of the
//! scene, its unknowns, nonzeros and operations.
//!
//! A hand stepper computes in [`Counted`] numbers, so that values and operations come from the same
//! formulas; its step problem is an `impl Model` by hand. Where the order of a sum shows in the last
//! bit it is the order that [`mcp_core::dynamics::MoreauJean`] documents.
#![allow(clippy::unwrap_used, reason = "a hand stepper that fails is a test that fails")]

mod balls;
mod beads;
mod circuits;
mod first_order;
mod hopper;
mod mass;
mod pendulum;
mod problems;
mod relays;
mod second_order;

use super::files::effect::Effect;
use super::files::effects::Effect as _;
use super::files::scene::Scene;
use super::{all, bits, name_effects, text_of};
use mcp_core::dynamics::{StepReport, StepSize};
use mcp_core::{Counted, Tally};

/// Steps compared: every scene has closed contacts, or pairs, within them.
const STEPS: u64 = 1200;

/// What a step is compared by.
#[derive(Debug, PartialEq)]
struct Facts {
    unknowns: usize,
    active: usize,
    iterations: usize,
    residual: u64,
    nonzeros: usize,
    operations: u64,
    state: Vec<u64>,
}

impl Facts {
    fn of(report: StepReport, size: StepSize, state: &[f64]) -> Self {
        assert_eq!(report.unknowns, size.unknowns);
        Facts {
            unknowns: report.unknowns,
            active: report.active,
            iterations: report.iterations,
            residual: report.residual.to_bits(),
            nonzeros: size.nonzeros,
            operations: size.operations,
            state: bits(state),
        }
    }
}

/// A stepper by hand.
trait Twin {
    fn step(&mut self) -> Facts;
}

/// A number of a hand stepper.
type Number<'t> = Counted<'t>;

/// The effects that are on.
#[derive(Clone, Copy)]
struct On<'a>(&'a [&'static str]);

impl On<'_> {
    fn has(self, effect: &str) -> bool {
        self.0.contains(&effect)
    }
}

/// The stepper by hand of a scene with these effects.
fn by_hand<'t>(scene: &str, on: On<'_>, tally: &'t Tally) -> Box<dyn Twin + 't> {
    match scene {
        "ball_with_friction" => Box::new(balls::rolling(on, tally)),
        "bouncing_ball" => Box::new(balls::bouncing(on, tally)),
        "column_of_beads" => Box::new(beads::column(on, tally)),
        "diode_bridge" => circuits::bridge(on, tally),
        "filippov" => relays::filippov(on, tally),
        "friction_oscillator" => relays::friction_oscillator(on, tally),
        "hopper" => Box::new(hopper::hopper(on, tally)),
        "pendulum" => Box::new(pendulum::pendulum(on, tally)),
        "relay_oscillator" => relays::relay_oscillator(on, tally),
        "rlc_diode" => circuits::oscillator(on, tally),
        "twisting" => relays::twisting(on, tally),
        "two_relays" => relays::two_relays(on, tally),
        "zhuravlev_ivanov" => Box::new(mass::Mass::new(on)),
        other => panic!("{other} has no twin"),
    }
}

/// The sets of effects that are left when none, one or two are switched off, with those that make no
/// sense without them.
fn sets(effects: &[&'static str]) -> Vec<Vec<&'static str>> {
    let mut sets = vec![effects.to_vec()];
    for (k, first) in effects.iter().enumerate() {
        for second in &effects[k..] {
            let is_on = |effect: &&&'static str| {
                let on_contact = ["restitution", "friction"].contains(effect);
                let without_contact = [first, second].contains(&&"contact");
                !([first, second].contains(effect) || (on_contact && without_contact))
            };
            let set: Vec<&'static str> = effects.iter().filter(is_on).copied().collect();
            if !sets.contains(&set) {
                sets.push(set);
            }
        }
    }
    sets
}

/// Whether a contact closes: without gravity nothing falls onto the floor, and without its rod the mass of
/// the pendulum falls along the wall.
fn closes(scene: &str, on: On<'_>) -> bool {
    on.has("contact") && on.has("gravity") && (scene != "pendulum" || on.has("joint"))
}

/// Whether a step has anything to solve.
fn has_problem(scene: &str, on: On<'_>) -> bool {
    let always = ["joint", "diode", "relay", "sliding_mode", "zhuravlev_ivanov"];
    closes(scene, on) || always.into_iter().any(|effect| on.has(effect))
}

#[test]
fn a_scene_is_the_stepper_by_hand_of_the_effects_it_names() {
    let mut compared = 0;
    for name in all() {
        let text = text_of(&name);
        let effects = Scene::parse(&name, &text).unwrap().effects;
        let effects: Vec<&'static str> = effects.into_iter().map(Effect::name).collect();
        for on in sets(&effects) {
            // A scene that is one effect has nothing without it.
            if name == "zhuravlev_ivanov" && on.is_empty() {
                continue;
            }
            let case = format!("{name} with {on:?}");
            // The data of what is off stay in the file.
            let mut table: toml::Table = text.parse().unwrap();
            name_effects(&mut table, &on);
            let text = toml::to_string(&table).unwrap();
            let mut scene = Scene::parse(&name, &text).unwrap_or_else(|e| panic!("{case}: {e}"));
            let tally = Tally::new();
            let mut twin = by_hand(&name, On(&on), &tally);
            let (mut solved, mut active) = (0, 0);
            for step in 1..=STEPS {
                let report = scene.stepper.step().unwrap_or_else(|e| panic!("{case}: {e}"));
                let size = scene.stepper.size().unwrap();
                let facts = Facts::of(report, size, &scene.stepper.state());
                assert_eq!(facts, twin.step(), "{case}, step {step}");
                solved += u64::from(report.unknowns > 0);
                active += report.active;
            }
            assert_eq!(solved > 0, has_problem(&name, On(&on)), "{case}");
            if on.contains(&"contact") {
                assert_eq!(active > 0, closes(&name, On(&on)), "{case}");
            }
            compared += 1;
        }
    }
    assert_eq!(compared, 67);
}
