//! Systems that relays and a twisting controller act on.

use super::first_order::{Linear, Multipliers};
use super::problems::{Equations, FREE, One, PUSH, RELAY, Two, solve};
use super::{Number, On, Twin};
use mcp_core::{Reader, Real, Scalar, Tally};
use nalgebra::{Matrix2, Matrix3};

/// States that stand still but for their relays.
fn at_rest<'t>(x: &[Number<'t>]) -> Vec<Number<'t>> {
    x.iter().map(|x| x.scale(1.0)).collect()
}

/// Two integrators with a relay each: `x' = 2 λ`, `y = x`.
struct Apart {
    m: f64,
    q: [f64; 2],
}

impl Equations for Apart {
    fn bounds(&self) -> Vec<[f64; 2]> {
        vec![RELAY; 2]
    }
    fn row<D: Scalar>(&self, i: usize, read: &Reader<'_, D>) -> Real<D> {
        self.m * read.var(i) + self.q[i]
    }
}

pub(super) fn two_relays<'t>(on: On<'_>, tally: &'t Tally) -> Box<dyn Twin + 't> {
    const M: f64 = 1e-3 * 2.0;
    let relays = on.has("relay").then(|| Multipliers {
        bounds: vec![RELAY; 2],
        output: Box::new(at_rest),
        push: Box::new(|s, x| {
            x[0] = x[0] + s[0].scale(M);
            x[1] = x[1] + s[1].scale(M);
        }),
        solve: Box::new(|q, start| solve(Apart { m: M, q: [q[0], q[1]] }, start)),
    });
    Linear::boxed(tally, &[1.0, -1.0], at_rest, relays)
}

/// `x₁' = 2 s₁ − 52 s₂`, `x₂' = 52 s₁ + 2 s₂`, `y = x`.
pub(super) fn filippov<'t>(on: On<'_>, tally: &'t Tally) -> Box<dyn Twin + 't> {
    const M: [[f64; 2]; 2] = [[1e-3 * 2.0, 1e-3 * -52.0], [1e-3 * 52.0, 1e-3 * 2.0]];
    let relays = on.has("relay").then(|| Multipliers {
        bounds: vec![RELAY; 2],
        output: Box::new(at_rest),
        push: Box::new(|s, x| {
            for i in 0..2 {
                x[i] = x[i] + (s[0].scale(M[i][0]) + s[1].scale(M[i][1]));
            }
        }),
        solve: Box::new(|q, start| solve(Two { bounds: [RELAY; 2], m: M, q: [q[0], q[1]] }, start)),
    });
    Linear::boxed(tally, &[3.0, 3.0], at_rest, relays)
}

/// `x' = v`, `v' = −x + s`, `s` against `v`.
pub(super) fn friction_oscillator<'t>(on: On<'_>, tally: &'t Tally) -> Box<dyn Twin + 't> {
    const H: f64 = 1e-2;
    let a = Matrix2::new(0.0, 1.0, -1.0, 0.0);
    let w = (Matrix2::identity() - H * 0.5 * a).try_inverse().unwrap();
    let t = w * (Matrix2::identity() + H * 0.5 * a);
    let free = move |x: &[Number<'t>]| {
        let row = |i| x[0].scale(t[(i, 0)]) + x[1].scale(t[(i, 1)]);
        vec![row(0), row(1)]
    };
    let [to_x, to_v] = [H * w[(0, 1)], H * w[(1, 1)]];
    let friction = on.has("relay").then(|| Multipliers {
        bounds: vec![RELAY],
        output: Box::new(|x| vec![x[1].scale(1.0)]),
        push: Box::new(move |s, x| {
            x[0] = x[0] + s[0].scale(to_x);
            x[1] = x[1] + s[0].scale(to_v);
        }),
        solve: Box::new(move |q, start| solve(One { bounds: RELAY, m: to_v, q: q[0] }, start)),
    });
    Linear::boxed(tally, &[12.0, 6.0], free, friction)
}

/// `x₁' = x₂`, `x₂' = x₃`, `x₃' = −3 x₂ − 2 x₃ + s`, `s` against `x₁`.
pub(super) fn relay_oscillator<'t>(on: On<'_>, tally: &'t Tally) -> Box<dyn Twin + 't> {
    const H: f64 = 1e-2;
    let a = Matrix3::new(0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, -3.0, -2.0);
    let w = (Matrix3::identity() - H * 0.5 * a).try_inverse().unwrap();
    let t = w * (Matrix3::identity() + H * 0.5 * a);
    let free = move |x: &[Number<'t>]| {
        // Nothing reads x₁ but itself.
        let rest = |i| x[1].scale(t[(i, 1)]) + x[2].scale(t[(i, 2)]);
        let first = x[0].scale(t[(0, 0)]) + x[1].scale(t[(0, 1)]) + x[2].scale(t[(0, 2)]);
        vec![first, rest(1), rest(2)]
    };
    let push = [0, 1, 2].map(|i| H * w[(i, 2)]);
    let relay = on.has("relay").then(|| Multipliers {
        bounds: vec![RELAY],
        output: Box::new(|x| vec![x[0].scale(1.0)]),
        push: Box::new(move |s, x| {
            for i in 0..3 {
                x[i] = x[i] + s[0].scale(push[i]);
            }
        }),
        solve: Box::new(move |q, start| solve(One { bounds: RELAY, m: push[0], q: q[0] }, start)),
    });
    let start = 0.675_237_237_117_829_7; // 3 √2 / (2 π)
    Linear::boxed(tally, &[0.0, start, 0.0], free, relay)
}

/// A control `(u₁, u₂)` in the polygon `P u >= −1` that opposes `y`, with multipliers of its sides.
struct Polygon {
    /// Half the step.
    half: f64,
    m: [[f64; 2]; 2],
    q: [f64; 2],
}

impl Equations for Polygon {
    fn bounds(&self) -> Vec<[f64; 2]> {
        vec![FREE, FREE, PUSH, PUSH, PUSH, PUSH]
    }
    fn row<D: Scalar>(&self, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let [u, v, right, above, left, below] =
            [0, 1, 2, 3, 4, 5].map(|k| move |factor: f64| factor * read.var(k));
        let (half, m, q) = (self.half, self.m, self.q);
        let y = |i: usize| u(m[i][0]) + v(m[i][1]);
        match i {
            0 => y(0) + right(-1.0) + above(half) + left(1.0) + below(-half) + q[0],
            1 => y(1) + above(-1.0) + below(1.0) + q[1],
            2 => u(1.0) + 1.0,
            3 => u(-half) + v(1.0) + 1.0,
            4 => u(-1.0) + 1.0,
            _ => u(half) + v(-1.0) + 1.0,
        }
    }
}

/// `x₁' = x₂`, `x₂' = 10 u₁ + 3 u₂`, `y = x`.
pub(super) fn twisting<'t>(on: On<'_>, tally: &'t Tally) -> Box<dyn Twin + 't> {
    const H: f64 = 0.1;
    const HALF: f64 = H * 0.5;
    let free = |x: &[Number<'t>]| vec![x[0].scale(1.0) + x[1].scale(HALF + HALF), x[1].scale(1.0)];
    let input = [10.0, 10.0 * 0.3];
    let m = [input.map(|b| H * HALF * b), input.map(|b| H * b)];
    let controller = on.has("sliding_mode").then(|| Multipliers {
        bounds: vec![FREE, FREE, PUSH, PUSH, PUSH, PUSH],
        output: Box::new(|x| {
            let one = Number::constant(1.0);
            vec![x[0].scale(1.0), x[1].scale(1.0), one, one, one, one]
        }),
        push: Box::new(move |u, x| {
            for i in 0..2 {
                x[i] = x[i] + (u[0].scale(m[i][0]) + u[1].scale(m[i][1]));
            }
        }),
        solve: Box::new(move |q, start| {
            solve(Polygon { half: H / 2.0, m, q: [q[0], q[1]] }, start)
        }),
    });
    Linear::boxed(tally, &[10.0, 10.0], free, controller)
}
