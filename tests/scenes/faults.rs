//! A fault of a scene file is named with file, line and key.

use super::files::scene::Scene;
use super::{path_of, text_of};

/// What is said about a scene after `from` in it has become `to`.
fn said(name: &str, from: &str, to: &str) -> String {
    let text = text_of(name);
    assert!(text.contains(from), "{name} has `{from}`");
    match Scene::parse("scene.toml", &text.replacen(from, to, 1)) {
        Ok(_) => panic!("{name} with `{to}` is accepted"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn a_fault_is_named_with_file_line_and_key() {
    for (name, from, to, message) in [
        (
            "bouncing_ball",
            "\"gravity\", ",
            "\"gravitation\", ",
            "scene.toml:3: `effects`: there is no effect `gravitation`: choose gravity",
        ),
        ("bouncing_ball", "mass = 1.0\n", "", "scene.toml:12: `body.mass`: ball has no mass"),
        (
            "bouncing_ball",
            "mass = 1.0",
            "mass = -1.0",
            "scene.toml:14: `body.mass`: the mass of ball is -1, but must be a positive number",
        ),
        (
            "bouncing_ball",
            "step = 0.005",
            "step = -0.005",
            "scene.toml:6: `time.step`: is -0.005, but must be a positive number",
        ),
        (
            "bouncing_ball",
            "restitution = 0.9",
            "restitution = 1.9",
            "scene.toml:20: `contact.restitution`: the restitution of floor is 1.9, but",
        ),
        (
            "bouncing_ball",
            "body = \"ball\"",
            "body = \"bell\"",
            "scene.toml:19: `contact.body`: no body is called `bell`: ball",
        ),
        (
            "bouncing_ball",
            "\"contact\", ",
            "",
            "scene.toml:3: `effects`: `restitution` makes no sense without `contact`",
        ),
        (
            "bouncing_ball",
            "\"contact\", ",
            "\"contact\", \"friction\", ",
            "scene.toml:3: `effects`: the file has no data for `friction`",
        ),
        ("bouncing_ball", "mass =", "mas =", "scene.toml:14: `mas`: unknown field `mas`"),
        ("bouncing_ball", "steps = 2000", "", "scene.toml:5: `steps`: missing field `steps`"),
        (
            "ball_with_friction",
            "inertia = 0.1",
            "",
            "`body.inertia`: ball turns, but has no inertia",
        ),
        ("hopper", "along = \"y\"", "along = \"z\"", "`spring.along`: is `z`, but must be x, y"),
        ("rlc_diode", "\"diode\"]", "\"relay\"]", "scene.toml:4: `effects`: the file has no data"),
        ("rlc_diode", "kind = \"resistor\"", "kind = \"resister\"", "there is no `resister`"),
        ("rlc_diode", "value = 1e3", "value = 0.0", "`element`: the resistance of R is 0, but"),
        ("two_relays", "input = [2.0, 0.0]", "input = [2.0]", "`relay`: the input of s1 has 1"),
    ] {
        let said = said(name, from, to);
        assert!(said.contains(message), "`{said}` does not contain `{message}`");
    }
}

#[test]
fn a_file_that_does_not_exist_is_named() {
    let Err(error) = Scene::read(&path_of("nothing")) else { panic!("there is no such scene") };
    assert!(error.to_string().contains("nothing.toml"));
}
