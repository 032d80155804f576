//! One Moreau–Jean step of planar bodies with Coulomb friction.

use mcp_core::{Options, mcp, solve};

mcp! {
    /// Planar bodies (x, y, angle) in contact; the ground does not move.
    pub model ContactStep {
        data {
            bodies: Set, dof: 3, contacts: Pairs(bodies, bodies),
            vfree[bodies, dof]: f64, winv[bodies, dof]: f64,
            na[contacts, dof]: f64, nb[contacts, dof]: f64,
            ta[contacts, dof]: f64, tb[contacts, dof]: f64,
            mu[contacts]: f64, e[contacts]: f64, un0[contacts]: f64, rho[contacts]: f64,
        }
        var rn[c in contacts] >= 0.0;
        var rt[c in contacts] free;
        def v[b in bodies, k in dof] lifted: vfree[b, k] + winv[b, k]
            * (sum(contacts.out_of(b), |c| na[c, k] * rn[c] + ta[c, k] * rt[c])
                + sum(contacts.into(b), |c| nb[c, k] * rn[c] + tb[c, k] * rt[c]));
        eq impact[c @ (a, b) in contacts]:
            sum(dof, |k| na[c, k] * v[a, k] + nb[c, k] * v[b, k]) + e[c] * un0[c]   complements rn[c];
        eq slip[c @ (a, b) in contacts]: {
            let ut = sum(dof, |k| ta[c, k] * v[a, k] + tb[c, k] * v[b, k]);
            rt[c] - (rt[c] - rho[c] * ut).clamp(-mu[c] * rn[c], mu[c] * rn[c])
        } complements rt[c];
    }
}

const RADIUS: f64 = 0.2;
const MASS: f64 = 2.0;
/// 2/5 m r²: a solid sphere.
const INERTIA: f64 = 0.4 * MASS * RADIUS * RADIUS;

/// A sphere that hits the ground at (1, -2) m/s without spin.
fn ball(mu: f64) -> ContactStep {
    ContactStep::builder()
        .bodies(["ball", "ground"])
        .contacts([("touch", "ball", "ground")])
        .vfree([[1.0, -2.0, 0.0], [0.0; 3]])
        .winv([[1.0 / MASS, 1.0 / MASS, 1.0 / INERTIA], [0.0; 3]])
        .na([[0.0, 1.0, 0.0]])
        .nb([[0.0, -1.0, 0.0]])
        .ta([[1.0, 0.0, RADIUS]])
        .tb([[-1.0, 0.0, 0.0]])
        .mu(mu)
        .e(0.5)
        .un0(-2.0)
        .rho(1.0)
        .build()
        .unwrap()
}

/// Normal and tangential impulse and velocities after the step.
fn step(mu: f64) -> (f64, f64, [f64; 3]) {
    let model = ball(mu);
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    let velocity = ["1", "2", "3"].map(|k| view.v[("ball", k)]);
    assert_eq!(view.v[("ground", "2")], 0.0);
    (view.rn["touch"], view.rt["touch"], velocity)
}

/// Newton's law: the normal velocity is reversed with restitution 1/2.
const NORMAL: f64 = MASS * (2.0 + 0.5 * 2.0);

#[test]
fn with_little_friction_the_ball_slips() {
    let (rn, rt, [vx, vy, omega]) = step(0.05);
    assert!((rn - NORMAL).abs() < 1e-9);
    assert!((rt + 0.05 * NORMAL).abs() < 1e-9);
    assert!((vx - (1.0 - 0.05 * NORMAL / MASS)).abs() < 1e-9);
    assert!((vy - 1.0).abs() < 1e-9);
    assert!((omega + 0.05 * NORMAL * RADIUS / INERTIA).abs() < 1e-8);
}

#[test]
fn with_much_friction_the_ball_rolls() {
    let (rn, rt, [vx, _, omega]) = step(1.0);
    let stick = -1.0 / (1.0 / MASS + RADIUS * RADIUS / INERTIA);
    assert!(stick.abs() < NORMAL);
    assert!((rn - NORMAL).abs() < 1e-9);
    assert!((rt - stick).abs() < 1e-9);
    assert!((vx + RADIUS * omega).abs() < 1e-9, "rolling: the contact point is at rest");
}

#[test]
fn without_contacts_there_is_nothing_but_the_free_motion() {
    let model = ContactStep::builder()
        .bodies(["ball"])
        .contacts(Vec::<(&str, &str)>::new())
        .vfree([[1.0, -2.0, 0.5]])
        .winv(1.0)
        .na(0.0)
        .nb(0.0)
        .ta(0.0)
        .tb(0.0)
        .mu(0.0)
        .e(0.0)
        .un0(0.0)
        .rho(1.0)
        .build()
        .unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    assert_eq!(model.view(&solution).unwrap().v.values(), [1.0, -2.0, 0.5]);
}
