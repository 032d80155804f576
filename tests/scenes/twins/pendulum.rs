//! A mass on a rod beside a wall.

use super::On;
use super::problems::{FREE, One, PUSH, Two, solve};
use super::second_order::{Bodies, Contact};
use mcp_core::{Scalar, Tally};

const H: f64 = 0.002;
const MASS: f64 = 2.0;
const DRAG: f64 = 0.05;

pub(super) fn pendulum<'t>(on: On<'_>, tally: &'t Tally) -> Bodies<'t> {
    let number = move |x: f64| tally.variable(x);
    let has_rod = on.has("joint");
    let mut mass = Bodies {
        tally,
        h: H,
        gamma: 0.5,
        q: vec![number(1.0), number(0.0)],
        v: vec![number(0.0); 2],
        forces: vec![],
        inverse: vec![1.0 / MASS; 2],
        coupled: None,
        joint: None,
        contacts: vec![],
        solve: Box::new(move |data, start| match data.q[..] {
            [q] => {
                let bounds = if has_rod { FREE } else { PUSH };
                solve(One { bounds, m: data.m[0][0], q }, start)
            }
            [rod, wall] => {
                let m = [[data.m[0][0], data.m[0][1]], [data.m[1][0], data.m[1][1]]];
                solve(Two { bounds: [FREE, PUSH], m, q: [rod, wall] }, start)
            }
            _ => panic!("a rod and a wall"),
        }),
    };
    if on.has("gravity") {
        mass.forces.push((vec![1], Box::new(|_, _, f| f[1] = f[1].shift(-MASS * 9.81))));
    }
    if on.has("drag") {
        for k in [0, 1] {
            mass.forces.push((vec![k], Box::new(move |_, v, f| f[k] = f[k] - v[k].scale(DRAG))));
        }
        mass.inverse = vec![1.0 / (MASS + 0.5 * H * DRAG); 2];
    }
    if has_rod {
        let rod = |q: &[super::Number<'t>]| {
            let length = (q[0] * q[0] + q[1] * q[1]).sqrt();
            vec![(0, q[0] / length), (1, q[1] / length)]
        };
        mass.joint = Some((Box::new(rod), 0.0));
    }
    if on.has("contact") {
        mass.contacts.push(Contact {
            // The wall at −0.4, a disc of radius 0.1.
            place: Box::new(move |q| {
                let along = q[0].scale(1.0) + q[1].scale(0.0);
                (along.shift(0.4).shift(-0.1), vec![(0, number(1.0)), (1, number(0.0))])
            }),
            restitution: on.has("restitution").then_some(0.7),
            tangent: None,
            impulses: vec![0.0],
        });
    }
    mass
}
