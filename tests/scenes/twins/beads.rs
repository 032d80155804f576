//! Ten beads over a floor and each other.

use super::On;
use super::problems::{Equations, PUSH, solve};
use super::second_order::{Bodies, Contact};
use mcp_core::{Reader, Real, Scalar, Tally};

/// Impulses of neighbours: `M` is tridiagonal where contacts follow each other, and apart where one
/// between them is open.
struct Chain {
    /// `M` below, on and above the diagonal; `None`: the neighbour is open.
    m: Vec<(Option<f64>, f64, Option<f64>)>,
    q: Vec<f64>,
}

impl Equations for Chain {
    fn bounds(&self) -> Vec<[f64; 2]> {
        vec![PUSH; self.q.len()]
    }
    fn row<D: Scalar>(&self, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let (below, on, above) = self.m[i];
        let mut rate = on * read.var(i);
        if let Some(below) = below {
            rate = below * read.var(i - 1) + rate;
        }
        if let Some(above) = above {
            rate += above * read.var(i + 1);
        }
        rate + self.q[i]
    }
}

/// Mass 1, radius 0.1; a coordinate each, the height.
pub(super) fn column<'t>(on: On<'_>, tally: &'t Tally) -> Bodies<'t> {
    let number = move |x: f64| tally.variable(x);
    let mut beads = Bodies {
        tally,
        h: 5e-4,
        gamma: 0.5,
        q: (0..10).map(|k| number(1.0 + 0.25 * f64::from(k))).collect(),
        v: vec![number(0.0); 10],
        forces: vec![],
        inverse: vec![1.0; 10],
        coupled: None,
        joint: None,
        contacts: vec![],
        solve: Box::new(|data, start| {
            let neighbour = |i: usize, j: usize| {
                let are_next = data.contacts.get(j)?.abs_diff(data.contacts[i]) <= 1;
                are_next.then(|| data.m[i][j])
            };
            let row =
                |i: usize| (neighbour(i, i.wrapping_sub(1)), data.m[i][i], neighbour(i, i + 1));
            let m = (0..data.q.len()).map(row).collect();
            solve(Chain { m, q: data.q.clone() }, start)
        }),
    };
    if on.has("gravity") {
        let weights = |f: &mut [super::Number<'t>]| {
            for f in f {
                *f = f.shift(-9.81);
            }
        };
        beads.forces.push(((0..10).collect(), Box::new(move |_, _, f| weights(f))));
    }
    if on.has("contact") {
        let restitution = on.has("restitution").then_some(0.9);
        for k in 0..10 {
            let between = move |q: &[super::Number<'t>]| {
                if k == 0 {
                    return (q[0].scale(1.0).shift(0.0).shift(-0.1), vec![(0, number(1.0))]);
                }
                let d = q[k] - q[k - 1];
                let distance = d.abs();
                let n = d / distance;
                (distance.shift(-0.1).shift(-0.1), vec![(k, n), (k - 1, -n)])
            };
            let (tangent, impulses) = (None, vec![0.0]);
            beads.contacts.push(Contact {
                place: Box::new(between),
                restitution,
                tangent,
                impulses,
            });
        }
    }
    beads
}
