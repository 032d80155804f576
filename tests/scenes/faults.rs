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

/// What is said of each file, with `from` once replaced by `to`, contains the message.
fn check(cases: &[(&str, &str, &str, &str)]) {
    for (name, from, to, message) in cases {
        let said = said(name, from, to);
        assert!(said.contains(message), "`{said}` does not contain `{message}`");
    }
}

#[test]
fn a_fault_is_named_with_file_line_and_key() {
    check(&[
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
        (
            "bouncing_ball",
            "mass = 1.0",
            "mass = \"heavy\"",
            "scene.toml:14: `mass`: invalid type: string \"heavy\"",
        ),
        (
            "bouncing_ball",
            "steps = 2000",
            "steps = -1",
            "scene.toml:7: `steps`: invalid value: integer `-1`",
        ),
        ("bouncing_ball", "mass = 1.0", "mass 1.0", "scene.toml:14: `mass 1.0`: "),
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
        (
            "rlc_diode",
            "value = 1e3",
            "value = 0.0",
            "`element.value`: the resistance of R is 0, but",
        ),
        (
            "two_relays",
            "input = [2.0, 0.0]",
            "input = [2.0]",
            "`relay.input`: the input of s1 has 1",
        ),
    ]);
}

#[test]
fn every_number_is_refused_with_line_and_key() {
    let floor = "body = \"ball\"\n";
    let on_floor = |line: &str| format!("{floor}{line}\n");
    let [normal, offset] = ["normal = [0.0, nan]", "offset = inf"].map(on_floor);
    let [straight, stiff] = ["rest = 0.5", "stiffness = 400.0"];
    check(&[
        (
            "bouncing_ball",
            "steps = 2000",
            "steps = 9\ntheta = 2.0",
            "8: `time.theta`: the theta of",
        ),
        (
            "bouncing_ball",
            "steps = 2000",
            "steps = 9\ngamma = -0.5",
            "8: `time.gamma`: the gamma of",
        ),
        ("bouncing_ball", "step = 0.005", "step = nan", "6: `time.step`: is NaN, but"),
        (
            "bouncing_ball",
            "= 9.81",
            "= nan",
            "10: `gravity.acceleration`: the acceleration of gravity",
        ),
        ("bouncing_ball", "y = [1.0, 0.0]", "y = [inf, 0.0]", "15: `body.y`: the y of ball is inf"),
        (
            "bouncing_ball",
            "y = [1.0, 0.0]",
            "y = [1.0, nan]",
            "15: `body.y`: the y velocity of ball",
        ),
        (
            "bouncing_ball",
            "mass = 1.0",
            "mass = 1.0\nradius = -1.0",
            "15: `body.radius`: the radius",
        ),
        ("bouncing_ball", floor, &normal, "20: `contact.normal`: the normal of floor is NaN"),
        ("bouncing_ball", floor, &offset, "20: `contact.offset`: the offset of floor is inf"),
        (
            "ball_with_friction",
            "inertia = 0.1",
            "inertia = 0.0",
            "`body.inertia`: the inertia of ball",
        ),
        (
            "ball_with_friction",
            "friction = 0.1",
            "friction = -0.1",
            "28: `contact.friction`: the fri",
        ),
        (
            "ball_with_friction",
            "angle = [0.0",
            "angle = [nan",
            "22: `body.angle`: the angle of ball",
        ),
        (
            "hopper",
            stiff,
            "stiffness = -1.0",
            "26: `spring.stiffness`: the stiffness of a spring is -1",
        ),
        ("hopper", straight, "rest = nan", "27: `spring.rest`: the rest of a spring is NaN"),
        (
            "hopper",
            "damping = 1.5",
            "damping = -1.5",
            "33: `damper.damping`: the damping of a damper",
        ),
        (
            "hopper",
            "coefficient = 0.1",
            "coefficient = nan",
            "37: `drag.coefficient`: the drag of body",
        ),
        (
            "pendulum",
            "anchor = [0.0",
            "anchor = [nan",
            "22: `joint.anchor`: the anchor of rod is NaN",
        ),
        (
            "pendulum",
            "anchor = [0.0, 0.0]",
            "rail = [0.0, 0.0]",
            "22: `joint.rail`: the normal of rod",
        ),
        ("rlc_diode", "start = 10.0", "start = nan", "15: `element.start`: the start of C is NaN"),
        (
            "rlc_diode",
            "value = 1e-2",
            "value = -1",
            "21: `element.value`: the inductance of L is -1",
        ),
        ("rlc_diode", "theta = 0.5", "theta = -0.5", "9: `time.theta`: the theta of the scheme"),
        (
            "twisting",
            "gain = 10.0",
            "gain = nan",
            "16: `sliding_mode.gain`: is NaN, but must be finite",
        ),
        ("twisting", "[0.0, 0.3]", "[0.0]", "17: `sliding_mode.inputs`: the input of u.2 has 1"),
        ("two_relays", "[0.0, 2.0]", "[0.0, inf]", "21: `relay.input`: the input of s2 is inf"),
        (
            "two_relays",
            "start = [1.0",
            "start = [nan",
            "11: `system.start`: the start of the system",
        ),
        (
            "two_relays",
            "matrix = [[0.0, 0.0]",
            "matrix = [[0.0]",
            "12: `system.matrix`: the matrix of",
        ),
        (
            "two_relays",
            "[[relay]]",
            "drift = [nan, 0.0]\n[[relay]]",
            "14: `system.drift`: the drift of",
        ),
        (
            "two_relays",
            "name = \"s1\"",
            "name = \"s1\"\nlower = 2.0",
            "16: `relay.lower`: the upper of s1",
        ),
        ("zhuravlev_ivanov", "kappa = 0.7", "kappa = nan", "11: `zhuravlev_ivanov.kappa`: is NaN"),
        ("zhuravlev_ivanov", "= 9.81", "= inf", "12: `zhuravlev_ivanov.acceleration`: is inf, but"),
        ("zhuravlev_ivanov", "[1.0, 10.0]", "[nan, 10.0]", "10: `zhuravlev_ivanov.start`: is NaN"),
    ]);
}

#[test]
fn a_name_is_used_once() {
    // The contact `a` with friction has the impulses `a` and `a friction`.
    let with_second = |name: &str| {
        let second = format!("[[contact]]\nname = \"{name}\"\nbody = \"ball\"\noffset = -1.0\n");
        Scene::parse("scene.toml", &format!("{}\n{second}", text_of("ball_with_friction")))
    };
    assert!(with_second("ceiling").is_ok());
    for name in ["floor", "floor friction"] {
        let error = with_second(name).err().unwrap().to_string();
        assert_eq!(
            error,
            format!("scene.toml:31: `contact.name`: the name `{name}` is used twice")
        );
    }
    check(&[
        (
            "column_of_beads",
            "name = \"1-2\"",
            "name = \"0-1\"",
            "`contact.name`: the name `0-1` is",
        ),
        (
            "column_of_beads",
            "name = \"bead1\"",
            "name = \"bead0\"",
            "19: `body.name`: the name `bead0`",
        ),
        ("two_relays", "name = \"s2\"", "name = \"s1\"", "20: `relay.name`: the name `s1` is used"),
        ("two_relays", "name = \"s2\"", "name = \"x1\"", "20: `relay.name`: the name `x1` is used"),
        ("two_relays", "\"x1\", \"x2\"", "\"x1\", \"x1\"", "10: `system.states`: the name `x1`"),
        ("rlc_diode", "name = \"L\"", "name = \"C\"", "19: `element.name`: the name `C` is used"),
    ]);
}

#[test]
fn what_cannot_act_is_refused_with_line_and_key() {
    check(&[
        // A body that only falls does not slip.
        (
            "bouncing_ball",
            "\"restitution\"]",
            "\"friction\"]",
            "scene.toml:3: `effects`: the file has no data for `friction`",
        ),
        (
            "column_of_beads",
            "with = \"bead0\"",
            "with = \"bead1\"",
            "`contact.with`: 0-1 is between bead1 and itself",
        ),
        (
            "hopper",
            "to = \"foot\"",
            "to = \"body\"",
            "24: `spring.to`: a spring is between body and",
        ),
        (
            "hopper",
            "along = \"y\"",
            "along = \"x\"",
            "25: `spring.along`: a spring needs the coord",
        ),
        (
            "bouncing_ball",
            "body = \"ball\"",
            "body = \"ball\"\nnormal = [1.0, 0.0]",
            "20: `contact.normal`: floor acts along its normal, where its bodies cannot move",
        ),
        (
            "rlc_diode",
            "between = [\"top\", \"ground\"]",
            "between = [\"top\", \"top\"]",
            "`element`:",
        ),
    ]);
    let text = text_of("bouncing_ball").replace("\"restitution\"]", "\"friction\"]");
    let error = Scene::parse("scene.toml", &text.replace("restitution =", "friction =")).err();
    let message =
        "scene.toml:20: `contact.friction`: floor acts along its tangent, where its bodies";
    assert!(error.unwrap().to_string().starts_with(message));
}

#[test]
fn a_file_that_does_not_exist_is_named() {
    let Err(error) = Scene::read(&path_of("nothing")) else { panic!("there is no such scene") };
    assert!(error.to_string().contains("nothing.toml"));
}
