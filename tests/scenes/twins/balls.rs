//! A ball that bounces, and one that spins.

use super::problems::{Coulomb, One, PUSH, solve};
use super::second_order::{Bodies, Contact};
use super::{Number, On};
use mcp_core::{Scalar, Tally};

const H: f64 = 0.005;
const G: f64 = 9.81;

/// Mass 1, a coordinate: its height.
pub(super) fn bouncing<'t>(on: On<'_>, tally: &'t Tally) -> Bodies<'t> {
    let number = |x: f64| tally.variable(x);
    let mut ball = Bodies {
        tally,
        h: H,
        gamma: 0.5,
        q: vec![number(1.0)],
        v: vec![number(0.0)],
        forces: vec![],
        inverse: vec![1.0],
        coupled: None,
        joint: None,
        contacts: vec![],
        solve: Box::new(|data, start| {
            solve(One { bounds: PUSH, m: data.m[0][0], q: data.q[0] }, start)
        }),
    };
    if on.has("gravity") {
        ball.forces.push((vec![0], Box::new(|_, _, f| f[0] = f[0].shift(-G))));
    }
    if on.has("contact") {
        ball.contacts.push(Contact {
            // Over the floor at 0, for a point: y − 0 − 0.
            place: Box::new(move |q| {
                (q[0].scale(1.0).shift(0.0).shift(0.0), vec![(0, number(1.0))])
            }),
            restitution: on.has("restitution").then_some(0.9),
            tangent: None,
            impulses: vec![0.0],
        });
    }
    ball
}

/// Mass 1, radius ½, inertia 0.1; coordinates `x`, `y`, angle.
pub(super) fn rolling<'t>(on: On<'_>, tally: &'t Tally) -> Bodies<'t> {
    let number = move |x: f64| tally.variable(x);
    let mut ball = Bodies {
        tally,
        h: H,
        gamma: 1.0,
        q: [0.0, 1.0, 0.0].map(number).to_vec(),
        v: [0.0, 0.0, 2.0].map(number).to_vec(),
        forces: vec![],
        inverse: vec![1.0, 1.0, 1.0 / 0.1],
        coupled: None,
        joint: None,
        contacts: vec![],
        solve: Box::new(|data, start| {
            solve(One { bounds: PUSH, m: data.m[0][0], q: data.q[0] }, start)
        }),
    };
    if on.has("gravity") {
        ball.forces.push((vec![1], Box::new(|_, _, f| f[1] = f[1].shift(-G))));
    }
    if on.has("contact") {
        ball.contacts.push(Contact {
            place: Box::new(move |q| {
                let height = q[0].scale(0.0) + q[1].scale(1.0);
                (height.shift(0.0).shift(-0.5), vec![(0, number(0.0)), (1, number(1.0))])
            }),
            restitution: on.has("restitution").then_some(0.9),
            tangent: None,
            impulses: vec![0.0],
        });
    }
    if on.has("friction") {
        // Along the floor, with the lever R.
        let tangent =
            move |n: &Vec<(usize, Number<'t>)>| vec![(0, n[1].1), (1, -n[0].1), (2, number(0.5))];
        ball.contacts[0].tangent = Some(Box::new(tangent));
        ball.contacts[0].impulses = vec![0.0; 2];
        ball.solve = Box::new(|data, start| {
            let m = [[data.m[0][0], data.m[0][1]], [data.m[1][0], data.m[1][1]]];
            solve(Coulomb { mu: 0.1, m, q: [data.q[0], data.q[1]] }, start)
        });
    }
    ball
}
