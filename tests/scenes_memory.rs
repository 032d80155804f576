//! Memory of time steppers: nothing is allocated while the same contacts are closed.

#![allow(unsafe_code, reason = "a counting allocator has to implement an unsafe trait")]

#[path = "allocations/counter.rs"]
mod counter;
#[path = "../examples/scenes/mod.rs"]
#[allow(dead_code, reason = "the example uses more of it")]
mod files;

use counter::allocations;
use files::scene::Scene;
use std::path::Path;

#[test]
fn nothing_is_allocated_while_the_same_contacts_are_closed() {
    // Steps until all sets of contacts have been seen, or long enough for beads at rest.
    for (name, before, after) in [
        ("bouncing_ball", 1000, 1000),
        ("ball_with_friction", 1000, 1000),
        ("column_of_beads", 3900, 100),
        ("hopper", 3000, 1000),
        ("pendulum", 3000, 2000),
        ("rlc_diode", 100, 400),
        ("diode_bridge", 2000, 3000),
        ("relay_oscillator", 1000, 9000),
        ("friction_oscillator", 100, 9900),
        ("two_relays", 600, 400),
        ("zhuravlev_ivanov", 5000, 5000),
    ] {
        let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes");
        let mut scene = Scene::read(&directory.join(name).with_extension("toml")).unwrap();
        let mut run = |steps| {
            for _ in 0..steps {
                scene.stepper.step().unwrap();
            }
        };
        run(before);
        assert_eq!(allocations(|| run(after)), 0, "{name}");
    }
}
