//! A foot (0) and a body (1) on a spring with a damper.

use super::On;
use super::problems::{One, PUSH, solve};
use super::second_order::{Bodies, Contact};
use mcp_core::{Scalar, Tally};

const H: f64 = 0.001;
const MASS: [f64; 2] = [0.2, 1.0];
const G: f64 = 9.81;
const STIFFNESS: f64 = 400.0;
const DAMPING: f64 = 1.5;
const DRAG: f64 = 0.1;
/// Half a step: where implicit forces are taken.
const MID: f64 = 0.5 * H;

pub(super) fn hopper<'t>(on: On<'_>, tally: &'t Tally) -> Bodies<'t> {
    let number = move |x: f64| tally.variable(x);
    let mut hopper = Bodies {
        tally,
        h: H,
        gamma: 0.5,
        q: vec![number(0.5), number(1.0)],
        v: vec![number(0.0); 2],
        forces: vec![],
        inverse: vec![],
        coupled: None,
        joint: None,
        contacts: vec![],
        solve: Box::new(|data, start| {
            solve(One { bounds: PUSH, m: data.m[0][0], q: data.q[0] }, start)
        }),
    };
    // M̂ on the diagonal and, negative, beside it.
    let (mut diagonal, mut coupling) = (MASS, 0.0);
    if on.has("gravity") {
        let weigh = |k: usize| (vec![k], -MASS[k] * G);
        for (place, weight) in [0, 1].map(weigh) {
            let k = place[0];
            hopper.forces.push((place, Box::new(move |_, _, f| f[k] = f[k].shift(weight))));
        }
    }
    if on.has("spring") {
        let pull =
            |q: &[super::Number<'t>], v: &[super::Number<'t>], f: &mut [super::Number<'t>]| {
                let [foot, body] = [0, 1].map(|k| q[k] + v[k].scale(MID));
                let force = (body - foot).shift(-0.5).scale(STIFFNESS);
                (f[1], f[0]) = (f[1] - force, f[0] + force);
            };
        hopper.forces.push((vec![0, 1], Box::new(pull)));
    }
    if on.has("damper") {
        let pull =
            |_: &[super::Number<'t>], v: &[super::Number<'t>], f: &mut [super::Number<'t>]| {
                let force = (v[1] - v[0]).scale(DAMPING);
                (f[1], f[0]) = (f[1] - force, f[0] + force);
            };
        hopper.forces.push((vec![0, 1], Box::new(pull)));
        diagonal = diagonal.map(|m| m + MID * DAMPING);
        coupling += MID * DAMPING;
    }
    if on.has("drag") {
        hopper.forces.push((vec![1], Box::new(|_, v, f| f[1] = f[1] - v[1].scale(DRAG))));
        diagonal[1] += MID * DRAG;
    }
    if on.has("spring") {
        diagonal = diagonal.map(|m| m + MID * MID * STIFFNESS);
        coupling += MID * MID * STIFFNESS;
    }
    if on.has("spring") || on.has("damper") {
        // Two equations, the foot's eliminated first.
        let foot = 1.0 / diagonal[0];
        let share = -coupling * foot;
        let body = 1.0 / (diagonal[1] - -coupling * share);
        hopper.coupled = Some(Box::new(move |x| {
            x[1] = x[1] - x[0].scale(share);
            (x[0], x[1]) = (x[0].scale(foot), x[1].scale(body));
            x[0] = x[0] - x[1].scale(share);
        }));
    }
    hopper.inverse = diagonal.map(f64::recip).to_vec();
    if on.has("contact") {
        hopper.contacts.push(Contact {
            place: Box::new(move |q| {
                (q[0].scale(1.0).shift(0.0).shift(0.0), vec![(0, number(1.0))])
            }),
            restitution: None,
            tangent: None,
            impulses: vec![0.0],
        });
    }
    hopper
}
