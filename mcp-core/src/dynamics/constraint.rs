//! Gaps of contacts and the rows of `H`: `u = H v`, in any arithmetic.

use super::body::{BodyId, Place};
use super::contact::{Contact, Hold, Joint, Obstacle};
use super::error::DynamicsError;
use super::mechanics::Mechanics;
use crate::scalar::Scalar;

/// A vector of the plane; `None` along an axis that none of its bodies has: it is 0 and takes no
/// operation.
type Vector<D> = [Option<D>; 2];

/// A row of `H`: at most six coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row<D> {
    entries: [(usize, D); 6],
    len: usize,
}

impl<D: Scalar> Row<D> {
    fn new() -> Self {
        Row { entries: [(0, D::constant(0.0)); 6], len: 0 }
    }

    fn put(&mut self, coordinate: Option<usize>, value: Option<D>) {
        if let (Some(i), Some(value)) = (coordinate, value) {
            self.entries[self.len] = (i, value);
            self.len += 1;
        }
    }

    /// A body's point in direction `n`, with the lever `arm` of its rotation.
    fn put_body(&mut self, place: Place, n: Vector<D>, arm: Option<D>) {
        let [x, y, angle] = place.coordinates;
        self.put(x, n[0]);
        self.put(y, n[1]);
        self.put(angle, arm);
    }

    /// Coordinates and entries.
    pub(super) fn entries(&self) -> &[(usize, D)] {
        &self.entries[..self.len]
    }

    /// `H_i v`.
    pub(super) fn times(&self, v: &[D]) -> D {
        let terms = self.entries().iter().map(|&(i, h)| h * v[i]);
        terms.reduce(|sum, term| sum + term).unwrap_or(D::constant(0.0))
    }
}

/// Where a contact is: gap and normal from the obstacle to the body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap<D> {
    pub(super) gap: D,
    normal: Vector<D>,
}

/// `(n_y, −n_x)`: along a floor to the right.
fn tangent<D: Scalar>([x, y]: Vector<D>) -> Vector<D> {
    [y, x.map(|x| -x)]
}

fn opposite<D: Scalar>(n: Vector<D>) -> Vector<D> {
    n.map(|n| n.map(|n| -n))
}

/// Distance and direction of a difference; upwards where it is 0.
fn direction<D: Scalar>(d: Vector<D>) -> (D, Vector<D>) {
    let distance = match d {
        [Some(x), Some(y)] => (x * x + y * y).sqrt(),
        [Some(along), None] | [None, Some(along)] => along.abs(),
        [None, None] => D::constant(0.0),
    };
    let unit = if distance.value() > 0.0 {
        d.map(|d| d.map(|d| d / distance))
    } else {
        [None, Some(D::constant(1.0))]
    };
    (distance, unit)
}

/// `a − b`.
fn difference<D: Scalar>(a: Vector<D>, b: Vector<D>) -> Vector<D> {
    [0, 1].map(|k| match (a[k], b[k]) {
        (Some(a), Some(b)) => Some(a - b),
        (a, b) => a.or(b.map(|b| -b)),
    })
}

/// In which direction a contact or joint acts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Direction {
    Normal,
    Tangent,
}

/// Some body of the pair can move in this direction; `normal` is `None` where it turns with the bodies.
pub(super) fn can_move(
    name: &str,
    pair: [Option<Place>; 2],
    normal: Option<[f64; 2]>,
    direction: Direction,
) -> Result<(), DynamicsError> {
    let places = || pair.iter().flatten();
    let moves = |axis: usize| places().any(|place| place.coordinates[axis].is_some());
    let turns = |place: &Place| place.coordinates[2].is_some() && place.radius > 0.0;
    let (can, direction) = match (direction, normal) {
        (Direction::Normal, Some([x, y])) => {
            ((x != 0.0 && moves(0)) || (y != 0.0 && moves(1)), "normal")
        }
        (Direction::Normal, None) => (moves(0) || moves(1), "normal"),
        (Direction::Tangent, _) if places().any(turns) => return Ok(()),
        (Direction::Tangent, Some([x, y])) => {
            ((y != 0.0 && moves(0)) || (x != 0.0 && moves(1)), "tangent")
        }
        // Bodies that all move along one line never slip.
        (Direction::Tangent, None) => (moves(0) && moves(1), "tangent"),
    };
    if can { Ok(()) } else { Err(DynamicsError::NoMotion { what: name.to_owned(), direction }) }
}

impl Mechanics {
    /// Position of a body's centre; coordinates it does not have are 0.
    fn centre<D: Scalar>(&self, body: BodyId, q: impl Fn(usize) -> D) -> Vector<D> {
        let [x, y, _] = self.places[body.0].coordinates;
        [x.map(&q), y.map(&q)]
    }

    /// Gap and normal of a contact: `g = n·x − offset − R` or `|x − x_b| − R − R_b`. `number` makes a
    /// number of the data.
    pub(super) fn gap<D: Scalar>(
        &self,
        contact: &Contact,
        q: &[D],
        number: impl Fn(f64) -> D,
    ) -> Gap<D> {
        let centre = self.centre(contact.body, |i| q[i]);
        let radius = self.places[contact.body.0].radius;
        match contact.with {
            Obstacle::Plane { normal, offset } => {
                let terms = centre.into_iter().zip(normal).filter_map(|(x, n)| Some(x?.scale(n)));
                let height = terms.reduce(|sum, term| sum + term).unwrap_or_else(|| number(0.0));
                let gap = height.shift(-offset).shift(-radius);
                Gap { gap, normal: normal.map(|n| Some(number(n))) }
            }
            Obstacle::Body(other) => {
                let between = difference(centre, self.centre(other, |i| q[i]));
                let (distance, normal) = direction(between);
                let gap = distance.shift(-radius).shift(-self.places[other.0].radius);
                Gap { gap, normal }
            }
        }
    }

    /// The normal row: `u_n`, the rate of the gap.
    pub(super) fn normal_row<D: Scalar>(&self, contact: &Contact, at: Gap<D>) -> Row<D> {
        let mut row = Row::new();
        row.put_body(self.places[contact.body.0], at.normal, None);
        if let Obstacle::Body(other) = contact.with {
            row.put_body(self.places[other.0], opposite(at.normal), None);
        }
        row
    }

    /// The tangential row: `u_t`, the slip. A body's point at `−R n` moves with `R ω t`.
    pub(super) fn tangential_row<D: Scalar>(
        &self,
        contact: &Contact,
        at: Gap<D>,
        number: impl Fn(f64) -> D,
    ) -> Row<D> {
        let (t, mut row) = (tangent(at.normal), Row::new());
        let place = self.places[contact.body.0];
        row.put_body(place, t, Some(number(place.radius)));
        if let Obstacle::Body(other) = contact.with {
            let place = self.places[other.0];
            row.put_body(place, opposite(t), Some(number(place.radius)));
        }
        row
    }

    /// The row of a joint, at the coordinates that `q` predicts.
    pub(super) fn joint_row<D: Scalar>(
        &self,
        joint: &Joint,
        q: impl Fn(usize) -> D,
        number: impl Fn(f64) -> D,
    ) -> Row<D> {
        let (place, mut row) = (self.places[joint.body.0], Row::new());
        match joint.hold {
            Hold::Rail(normal) => row.put_body(place, normal.map(|n| Some(number(n))), None),
            Hold::Anchor(point) => {
                let point = point.map(|x| (x != 0.0).then(|| number(x)));
                let (_, n) = direction(difference(self.centre(joint.body, q), point));
                row.put_body(place, n, None);
            }
            Hold::Body(other) => {
                let centres = [joint.body, other].map(|body| self.centre(body, &q));
                let (_, n) = direction(difference(centres[0], centres[1]));
                row.put_body(place, n, None);
                row.put_body(self.places[other.0], opposite(n), None);
            }
        }
        row
    }
}
