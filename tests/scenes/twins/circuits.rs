//! An oscillating circuit, `C u' = −i`, `L i' = u`, with a diode, and with four.

use super::first_order::{Linear, Multipliers};
use super::problems::{Equations, One, PUSH, solve};
use super::{Number, On, Twin};
use mcp_core::{Reader, Real, Scalar, Tally};
use nalgebra::Matrix2;

const CAPACITY: f64 = 1e-6;
const INDUCTANCE: f64 = 1e-2;
const RESISTANCE: f64 = 1e3;

/// `W = (I − hθA)⁻¹` and the free state `W (I + h(1−θ)A) x`.
fn swing<'t>(
    h: f64,
    theta: f64,
) -> (Matrix2<f64>, impl Fn(&[Number<'t>]) -> Vec<Number<'t>> + 'static) {
    let a = Matrix2::new(0.0, -1.0 / CAPACITY, 1.0 / INDUCTANCE, 0.0);
    let w = (Matrix2::identity() - h * theta * a).try_inverse().unwrap();
    let t = w * (Matrix2::identity() + h * (1.0 - theta) * a);
    let row = move |x: &[Number<'t>], i| x[0].scale(t[(i, 0)]) + x[1].scale(t[(i, 1)]);
    (w, move |x: &[Number<'t>]| vec![row(x, 0), row(x, 1)])
}

/// What a current that discharges the capacitor does to voltage and coil in a step.
fn discharge(h: f64, w: &Matrix2<f64>) -> [f64; 2] {
    [h * w[(0, 0)] * (-1.0 / CAPACITY), h * w[(1, 0)] * (-1.0 / CAPACITY)]
}

/// The diode's current runs through the resistor: `w = R i − u`.
pub(super) fn oscillator<'t>(on: On<'_>, tally: &'t Tally) -> Box<dyn Twin + 't> {
    const H: f64 = 1e-5;
    let (w, free) = swing(H, 0.500_000_000_000_1);
    let [du, di] = discharge(H, &w);
    let diode = on.has("diode").then(|| Multipliers {
        bounds: vec![PUSH],
        output: Box::new(|x| vec![x[0].scale(-1.0)]),
        push: Box::new(move |i, x| {
            x[0] = x[0] + i[0].scale(du);
            x[1] = x[1] + i[0].scale(di);
        }),
        solve: Box::new(move |q, start| {
            solve(One { bounds: PUSH, m: -du + RESISTANCE, q: q[0] }, start)
        }),
    });
    Linear::boxed(tally, &[10.0, 0.0], free, diode)
}

/// Currents `a` and `b` through the diodes to plus, `c` through that from minus to the capacitor, and
/// the reverse voltage `w` of the fourth; `m` is what a unit of `a` adds to `−u` in a step.
///
/// ```text
/// w_a = R (a + b) − u − w,  w_b = R (a + b) − w,  w_c = u + w,  d = a + b − c
/// ```
struct Bridge {
    m: f64,
    q: [f64; 4],
}

impl Equations for Bridge {
    fn bounds(&self) -> Vec<[f64; 2]> {
        vec![PUSH; 4]
    }
    fn row<D: Scalar>(&self, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let [a, b, c, w] = [0, 1, 2, 3].map(|k| move |factor: f64| factor * read.var(k));
        let (m, r) = (self.m, RESISTANCE);
        let law = match i {
            0 => a(m + r) + b(r) + c(-m) + w(-1.0),
            1 => a(r) + b(r) + w(-1.0),
            2 => a(-m) + c(m) + w(1.0),
            _ => a(1.0) + b(1.0) + c(-1.0),
        };
        law + self.q[i]
    }
}

pub(super) fn bridge<'t>(on: On<'_>, tally: &'t Tally) -> Box<dyn Twin + 't> {
    const H: f64 = 1e-6;
    let (w, free) = swing(H, 0.5);
    let [du, di] = discharge(H, &w);
    let diodes = on.has("diode").then(|| Multipliers {
        bounds: vec![PUSH; 4],
        // −u and u; the others do not read the state.
        output: Box::new(|x| {
            let nothing = Number::constant(0.0);
            vec![x[0].scale(-1.0), nothing, x[0].scale(1.0), nothing]
        }),
        push: Box::new(move |i, x| {
            x[0] = x[0] + (i[0].scale(du) + i[2].scale(-du));
            x[1] = x[1] + (i[0].scale(di) + i[2].scale(-di));
        }),
        solve: Box::new(move |q, start| {
            solve(Bridge { m: -du, q: [q[0], q[1], q[2], q[3]] }, start)
        }),
    });
    Linear::boxed(tally, &[10.0, 0.0], free, diodes)
}
