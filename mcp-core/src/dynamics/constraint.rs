//! Gaps of contacts and the rows of `H`: `u = H v`.

use super::mechanics::{BodyId, Contact, Hold, Joint, Mechanics, Obstacle, Place};

/// A row of `H`: at most six coordinates.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Row {
    entries: [(usize, f64); 6],
    len: usize,
}

impl Row {
    fn put(&mut self, coordinate: Option<usize>, value: f64) {
        if let Some(i) = coordinate {
            self.entries[self.len] = (i, value);
            self.len += 1;
        }
    }

    /// A body's point in direction `n`, with the lever `arm` of its rotation.
    fn put_body(&mut self, place: Place, n: [f64; 2], arm: Option<f64>) {
        let [x, y, angle] = place.coordinates;
        self.put(x, n[0]);
        self.put(y, n[1]);
        if let Some(arm) = arm {
            self.put(angle, arm);
        }
    }

    /// Coordinates and entries.
    pub(super) fn entries(&self) -> &[(usize, f64)] {
        &self.entries[..self.len]
    }

    /// `H_i v`.
    pub(super) fn times(&self, v: &[f64]) -> f64 {
        self.entries().iter().map(|&(i, h)| h * v[i]).sum()
    }
}

/// Where a contact is: gap and normal from the obstacle to the body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap {
    pub(super) gap: f64,
    normal: [f64; 2],
}

/// `(n_y, −n_x)`: along a floor to the right.
fn tangent([x, y]: [f64; 2]) -> [f64; 2] {
    [y, -x]
}

fn opposite(n: [f64; 2]) -> [f64; 2] {
    n.map(|n| -n)
}

impl Mechanics {
    /// Position of a body's centre; coordinates it does not have are 0.
    fn centre(&self, body: BodyId, q: impl Fn(usize) -> f64) -> [f64; 2] {
        let [x, y, _] = self.places[body.0].coordinates;
        [x.map_or(0.0, &q), y.map_or(0.0, &q)]
    }

    /// Distance from the other centre and its direction; upwards where the centres coincide.
    fn direction(&self, body: BodyId, from: [f64; 2], q: impl Fn(usize) -> f64) -> (f64, [f64; 2]) {
        let [x, y] = self.centre(body, q);
        let d = [x - from[0], y - from[1]];
        // Exact along an axis: √(d²) = |d|.
        let distance = (d[0] * d[0] + d[1] * d[1]).sqrt();
        (distance, if distance > 0.0 { d.map(|d| d / distance) } else { [0.0, 1.0] })
    }

    /// Gap and normal of a contact: `g = n·x − offset − R` or `|x − x_b| − R − R_b`.
    pub(super) fn gap(&self, contact: &Contact, q: &[f64]) -> Gap {
        let at = |i: usize| q[i];
        let radius = self.places[contact.body.0].radius;
        match contact.with {
            Obstacle::Plane { normal, offset } => {
                let [x, y] = self.centre(contact.body, at);
                Gap { gap: normal[0] * x + normal[1] * y - offset - radius, normal }
            }
            Obstacle::Body(other) => {
                let (distance, normal) = self.direction(contact.body, self.centre(other, at), at);
                Gap { gap: distance - radius - self.places[other.0].radius, normal }
            }
        }
    }

    /// The normal row: `u_n`, the rate of the gap.
    pub(super) fn normal_row(&self, contact: &Contact, at: Gap) -> Row {
        let mut row = Row::default();
        row.put_body(self.places[contact.body.0], at.normal, None);
        if let Obstacle::Body(other) = contact.with {
            row.put_body(self.places[other.0], opposite(at.normal), None);
        }
        row
    }

    /// The tangential row: `u_t`, the slip. A body's point at `−R n` moves with `R ω t`.
    pub(super) fn tangential_row(&self, contact: &Contact, at: Gap) -> Row {
        let (t, mut row) = (tangent(at.normal), Row::default());
        let place = self.places[contact.body.0];
        row.put_body(place, t, Some(place.radius));
        if let Obstacle::Body(other) = contact.with {
            let place = self.places[other.0];
            row.put_body(place, opposite(t), Some(place.radius));
        }
        row
    }

    /// The row of a joint, at the coordinates that `q` predicts.
    pub(super) fn joint_row(&self, joint: &Joint, q: impl Fn(usize) -> f64) -> Row {
        let (place, mut row) = (self.places[joint.body.0], Row::default());
        match joint.hold {
            Hold::Rail(normal) => row.put_body(place, normal, None),
            Hold::Anchor(point) => {
                let (_, n) = self.direction(joint.body, point, q);
                row.put_body(place, n, None);
            }
            Hold::Body(other) => {
                let from = self.centre(other, &q);
                let (_, n) = self.direction(joint.body, from, q);
                row.put_body(place, n, None);
                row.put_body(self.places[other.0], opposite(n), None);
            }
        }
        row
    }
}
