//! Trajectories published with Siconos, row by row.
#![allow(clippy::unreadable_literal, reason = "numbers as they are published")]

use super::{all, scene};

/// Of the published numbers, which have 12 digits: absolute below 1, else relative to the largest
/// number of the column.
const TOLERANCE: f64 = 1e-11;

/// A scene, names of columns, and rows `(time, numbers)`.
struct Published {
    scene: &'static str,
    columns: &'static [&'static str],
    rows: &'static [(f64, &'static [f64])],
    /// The first steps that are run; all rows lie in them.
    steps: u64,
}

const PUBLISHED: [Published; 9] = [
    Published {
        scene: "bouncing_ball",
        columns: &["ball.y", "ball.y'", "r[floor]"],
        rows: &[
            (2.5, &[0.39568070125, -1.6289505, 0.0]),
            (5.0, &[0.151353680263, -0.752258125755, 0.0]),
            (10.0, &[-2.28861809055e-05, 0.0, 0.04905]),
        ],
        steps: 2000,
    },
    Published {
        scene: "column_of_beads",
        columns: &["bead0.y", "bead0.y'", "bead1.y", "bead1.y'", "bead2.y", "bead2.y'"],
        rows: &[
            (
                0.5,
                &[
                    0.109846022999,
                    -3.05554267464,
                    0.322085102109,
                    2.49990744653,
                    0.547879957411,
                    -3.43388488453,
                ],
            ),
            (
                1.0,
                &[
                    0.104470953835,
                    -0.609785968359,
                    0.304401366415,
                    -0.343325355903,
                    0.506773617764,
                    0.366819045787,
                ],
            ),
        ],
        steps: 2000,
    },
    Published {
        // The reference counts lateral motion to the left: q₁ = −x.
        scene: "ball_with_friction",
        columns: &["ball.y", "ball.y'", "ball.angle'", "r[floor]", "-ball.x", "-ball.x'"],
        rows: &[(
            2.5,
            &[0.676051441784, -0.1141653465, 0.571428571429, 0.0, 0.623571428571, 0.285714285714],
        )],
        steps: 500,
    },
    Published {
        scene: "rlc_diode",
        columns: &["u[C]", "i[L]", "i[D]"],
        rows: &[(2.5e-3, &[5.34433848191, -0.0107494329584, 0.00534433848191])],
        steps: 250,
    },
    Published {
        scene: "diode_bridge",
        columns: &["u[C]", "i[L]", "i[a+]"],
        rows: &[
            (1.25e-3, &[5.35774865402, -0.00456434029415, 0.00535774865402]),
            (4.999e-3, &[0.786383910728, -0.00283071805415, 0.000786383910728]),
        ],
        steps: 5000,
    },
    Published {
        scene: "filippov",
        columns: &["x1", "x2"],
        rows: &[(0.5, &[0.144, -3.556])],
        steps: 500,
    },
    Published {
        scene: "relay_oscillator",
        columns: &["x1", "x2", "x3", "s"],
        rows: &[(50.0, &[-0.156158767438, -0.259391021189, 0.537732818927, 1.0])],
        steps: 5000,
    },
    Published {
        scene: "friction_oscillator",
        columns: &["x", "v", "friction"],
        rows: &[
            (25.0, &[0.682044135195, 0.0, 0.682044135195]),
            (100.0, &[0.682044135195, 0.0, 0.682044135195]),
        ],
        steps: 10_000,
    },
    Published {
        scene: "twisting",
        columns: &["x1", "x2"],
        rows: &[(5.0, &[-0.6215, 8.86])],
        steps: 50,
    },
];

#[test]
fn published_rows_are_reproduced_to_eleven_digits() {
    for Published { scene: name, columns, rows, steps } in PUBLISHED {
        let mut scene = scene(name);
        let names = scene.stepper.state_names();
        let column = |name: &str| {
            let (sign, name) = name.strip_prefix('-').map_or((1.0, name), |name| (-1.0, name));
            let k = names.iter().position(|other| other == name);
            (k.unwrap_or_else(|| panic!("no {name} in {names:?}")), sign)
        };
        let columns: Vec<(usize, f64)> = columns.iter().map(|name| column(name)).collect();
        let mut states = vec![scene.stepper.state()];
        for _ in 0..steps {
            scene.stepper.step().unwrap_or_else(|error| panic!("{name}: {error}"));
            states.push(scene.stepper.state());
        }
        for &(time, published) in rows {
            let h = scene.stepper.step_size();
            let is_near = |&k: &usize| (k as f64 * h - time).abs() < 0.5 * h;
            let step = (0..states.len()).find(is_near).expect("the row lies in the run");
            for (&(k, sign), &expected) in columns.iter().zip(published) {
                let largest = states.iter().map(|state| state[k].abs()).fold(1.0, f64::max);
                let found = sign * states[step][k];
                let error = (found - expected).abs() / largest;
                assert!(error <= TOLERANCE, "{name}, t = {time}: {found} for {expected}");
            }
        }
    }
}

#[test]
fn relays_and_the_zhuravlev_ivanov_mass_come_to_rest_at_0() {
    for (name, states) in
        [("two_relays", 2), ("filippov", 2), ("twisting", 2), ("zhuravlev_ivanov", 2)]
    {
        let mut scene = scene(name);
        for _ in 0..scene.steps {
            scene.stepper.step().unwrap_or_else(|error| panic!("{name}: {error}"));
        }
        let state = scene.stepper.state();
        assert!(state[..states].iter().all(|x| x.abs() < 1e-8), "{name}: {state:?}");
    }
}

#[test]
fn every_step_of_every_scene_is_solved_below_1e_10() {
    for name in all() {
        let mut scene = scene(&name);
        for step in 1..=scene.steps {
            let report = scene.stepper.step().unwrap_or_else(|error| panic!("{name}: {error}"));
            assert_eq!(report.step, step);
            assert!(report.residual < 1e-10, "{name}, t = {}: {}", report.time, report.residual);
        }
    }
}
