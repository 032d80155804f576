//! [`Mechanics`]: planar bodies and the effects that act on them.

use super::body::{Axis, Body, BodyId, Place};
use super::constraint::{Direction, can_move};
use super::contact::{Contact, Hold, Joint, Obstacle};
use super::error::{DynamicsError, finite, not_negative, positive, share, unused};
use super::link::{Link, Term};
use crate::scalar::Scalar;

/// Planar bodies with the effects they are given, and no other: every `add` method is one effect.
///
/// ```text
/// M v' = f(q, v) + Hᵀ r,   q' = v,   f = f₀ − K (q − q₀) − C v
/// ```
///
/// `f₀`: gravity, `K`: springs, `C`: dampers and drag, `H`: contacts and joints.
#[derive(Clone, Debug, Default)]
pub struct Mechanics {
    pub(super) names: Vec<String>,
    pub(super) mass: Vec<f64>,
    pub(super) start: (Vec<f64>, Vec<f64>),
    pub(super) places: Vec<Place>,
    body_names: Vec<String>,
    pub(super) constant: Vec<(usize, f64)>,
    pub(super) springs: Vec<Term>,
    pub(super) dampers: Vec<Term>,
    pub(super) contacts: Vec<Contact>,
    pub(super) joints: Vec<Joint>,
}

impl Mechanics {
    /// Nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a body.
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] for a mass that is not positive, an inertia that is not
    /// positive where the body turns, a negative radius, a motion that is not finite;
    /// [`DynamicsError::NameTwice`].
    pub fn add_body(&mut self, body: &Body) -> Result<BodyId, DynamicsError> {
        unused(&body.name, self.body_names.iter().map(String::as_str))?;
        positive("mass", &body.name, body.mass)?;
        not_negative("radius", &body.name, body.radius)?;
        if body.motion[Axis::Angle as usize].is_some() {
            positive("inertia", &body.name, body.inertia)?;
        }
        for axis in [Axis::X, Axis::Y, Axis::Angle] {
            if let Some((position, velocity)) = body.motion[axis as usize] {
                finite(axis.name(), &body.name, position)?;
                finite(axis.rate(), &body.name, velocity)?;
            }
        }
        let mut coordinates = [None; 3];
        for axis in [Axis::X, Axis::Y, Axis::Angle] {
            let Some((position, velocity)) = body.motion[axis as usize] else { continue };
            coordinates[axis as usize] = Some(self.mass.len());
            self.names.push(format!("{}.{}", body.name, axis.name()));
            self.mass.push(if axis == Axis::Angle { body.inertia } else { body.mass });
            self.start.0.push(position);
            self.start.1.push(velocity);
        }
        self.places.push(Place { coordinates, radius: body.radius });
        self.body_names.push(body.name.clone());
        Ok(BodyId(self.places.len() - 1))
    }

    /// Gravity: the force `−m g` along `y` on every body there is that moves up and down.
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] if `g` \[m/s²\] is not finite.
    pub fn add_gravity(&mut self, g: f64) -> Result<(), DynamicsError> {
        finite("acceleration", "gravity", g)?;
        let weights = self.places.iter().filter_map(|place| place.coordinates[Axis::Y as usize]);
        let weights: Vec<_> = weights.map(|i| (i, -self.mass[i] * g)).collect();
        self.constant.extend(weights);
        Ok(())
    }

    /// A constant force \[N\], or torque \[N m\].
    ///
    /// # Errors
    /// [`DynamicsError::NoCoordinate`], [`DynamicsError::OutOfRange`].
    pub fn add_force(&mut self, body: BodyId, axis: Axis, force: f64) -> Result<(), DynamicsError> {
        let i = self.coordinate("a force", body, axis)?;
        self.constant.push((i, finite("force", &self.body_names[body.0], force)?));
        Ok(())
    }

    /// Linear (Stokes) drag: the force `−c v` on every coordinate of a body but its angle.
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] if `c` \[N s/m\] is negative.
    pub fn add_drag(&mut self, body: BodyId, c: f64) -> Result<(), DynamicsError> {
        not_negative("drag", &self.body_names[body.0], c)?;
        for i in self.places[body.0].coordinates.into_iter().take(2).flatten() {
            self.dampers.push(Term { i, j: None, coefficient: c, rest: 0.0 });
        }
        Ok(())
    }

    /// A linear spring.
    ///
    /// # Errors
    /// [`DynamicsError::NoCoordinate`], [`DynamicsError::OutOfRange`] for a negative stiffness,
    /// [`DynamicsError::SameBody`].
    pub fn add_spring(&mut self, link: Link) -> Result<(), DynamicsError> {
        let term = self.term("a spring", "stiffness", link)?;
        self.springs.push(term);
        Ok(())
    }

    /// A linear damper.
    ///
    /// # Errors
    /// As [`add_spring`](Self::add_spring).
    pub fn add_damper(&mut self, link: Link) -> Result<(), DynamicsError> {
        let term = self.term("a damper", "damping", link)?;
        self.dampers.push(Term { rest: 0.0, ..term });
        Ok(())
    }

    /// A unilateral contact.
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] for a restitution outside `[0, 1]`, a negative friction, a
    /// normal without length, [`DynamicsError::SameBody`], [`DynamicsError::NameTwice`], and
    /// [`DynamicsError::NoMotion`] if the bodies cannot move along the normal or, with friction,
    /// along the tangent: a body that only falls has no friction with a floor.
    pub fn add_contact(&mut self, mut contact: Contact) -> Result<(), DynamicsError> {
        let (name, friction) = contact.multipliers();
        for name in std::iter::once(&name).chain(&friction) {
            unused(name, self.multipliers().iter().map(String::as_str))?;
        }
        share("restitution", &name, contact.restitution)?;
        not_negative("friction", &name, contact.friction.unwrap_or(0.0))?;
        if let Obstacle::Plane { normal, offset } = contact.with {
            finite("offset", &name, offset)?;
            let normal = unit(&name, normal)?;
            contact.with = Obstacle::Plane { normal, offset };
        }
        let (other, normal) = match contact.with {
            Obstacle::Plane { normal, .. } => (None, Some(normal)),
            Obstacle::Body(other) => (Some(other), None),
        };
        let pair = self.pair(&name, contact.body, other)?;
        can_move(&name, pair, normal, Direction::Normal)?;
        if contact.friction.is_some() {
            can_move(&name, pair, normal, Direction::Tangent)?;
        }
        self.contacts.push(contact);
        Ok(())
    }

    /// A bilateral joint.
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] for a rail whose normal has no length or an anchor that is not
    /// finite, and otherwise as [`add_contact`](Self::add_contact).
    pub fn add_joint(&mut self, mut joint: Joint) -> Result<(), DynamicsError> {
        unused(&joint.name, self.multipliers().iter().map(String::as_str))?;
        let (mut other, mut fixed) = (None, None);
        match joint.hold {
            Hold::Rail(normal) => {
                let normal = unit(&joint.name, normal)?;
                joint.hold = Hold::Rail(normal);
                fixed = Some(normal);
            }
            Hold::Anchor(point) => {
                for x in point {
                    finite("anchor", &joint.name, x)?;
                }
            }
            Hold::Body(body) => other = Some(body),
        }
        let pair = self.pair(&joint.name, joint.body, other)?;
        can_move(&joint.name, pair, fixed, Direction::Normal)?;
        self.joints.push(joint);
        Ok(())
    }

    /// Names of all multipliers: joints, then contacts with their friction.
    pub(super) fn multipliers(&self) -> Vec<String> {
        let contacts = self.contacts.iter().map(Contact::multipliers);
        let contacts = contacts.flat_map(|(name, friction)| std::iter::once(name).chain(friction));
        self.joints.iter().map(|joint| joint.name.clone()).chain(contacts).collect()
    }

    /// The bodies of a contact or joint.
    fn pair(
        &self,
        name: &str,
        body: BodyId,
        other: Option<BodyId>,
    ) -> Result<[Option<Place>; 2], DynamicsError> {
        self.are_two(name, body, other)?;
        Ok([Some(body), other].map(|body| body.map(|body| self.places[body.0])))
    }

    fn are_two(
        &self,
        what: &str,
        body: BodyId,
        other: Option<BodyId>,
    ) -> Result<(), DynamicsError> {
        if other != Some(body) {
            return Ok(());
        }
        let body = self.body_names[body.0].clone();
        Err(DynamicsError::SameBody { what: what.to_owned(), body })
    }

    fn coordinate(&self, what: &str, body: BodyId, axis: Axis) -> Result<usize, DynamicsError> {
        let missing = || DynamicsError::NoCoordinate {
            what: what.to_owned(),
            coordinate: format!("{}.{}", self.body_names[body.0], axis.name()),
        };
        self.places[body.0].coordinates[axis as usize].ok_or_else(missing)
    }

    fn term(&self, what: &str, quantity: &'static str, link: Link) -> Result<Term, DynamicsError> {
        self.are_two(what, link.body, link.to)?;
        let i = self.coordinate(what, link.body, link.axis)?;
        let j = link.to.map(|to| self.coordinate(what, to, link.axis)).transpose()?;
        let coefficient = not_negative(quantity, what, link.coefficient)?;
        let rest = finite("rest", what, link.rest)?;
        Ok(Term { i, j, coefficient, rest })
    }

    /// Adds `f(q, v) − hθ K v` to `f`: constant forces, then springs, `k (x + hθ v − x₀)`, then
    /// dampers and drag, each in the order in which they were added.
    pub(super) fn forces<D: Scalar>(&self, h_theta: f64, q: &[D], v: &[D], f: &mut [D]) {
        for &(i, force) in &self.constant {
            f[i] = f[i].shift(force);
        }
        for spring in &self.springs {
            let predicted = |i: usize| q[i] + v[i].scale(h_theta);
            spring.pull(spring.extension(predicted).scale(spring.coefficient), f);
        }
        for damper in &self.dampers {
            damper.pull(damper.extension(|i| v[i]).scale(damper.coefficient), f);
        }
    }

    /// Coordinates on which any force acts.
    pub(super) fn forced(&self) -> Vec<usize> {
        let links = self.springs.iter().chain(&self.dampers);
        let mut forced: Vec<usize> =
            links.flat_map(|link| [Some(link.i), link.j]).flatten().collect();
        forced.extend(self.constant.iter().map(|&(i, _)| i));
        forced.sort_unstable();
        forced.dedup();
        forced
    }

    /// Entries of `hθ C + (hθ)² K`, with repetitions.
    pub(super) fn implicit_entries(&self, h_theta: f64) -> Vec<(usize, usize, f64)> {
        let mut entries = Vec::new();
        let mut put = |i, j, value| entries.push((i, j, value));
        for damper in &self.dampers {
            damper.entries(h_theta, &mut put);
        }
        for spring in &self.springs {
            spring.entries(h_theta * h_theta, &mut put);
        }
        entries
    }

    /// `½ vᵀ M v + ½ Σ k (extension)² − f₀ · q`.
    pub(super) fn energy(&self, q: &[f64], v: &[f64]) -> f64 {
        let kinetic: f64 = self.mass.iter().zip(v).map(|(m, v)| 0.5 * m * v * v).sum();
        let square = |spring: &Term| spring.extension(|i| q[i]).powi(2);
        let elastic: f64 = self.springs.iter().map(|s| 0.5 * s.coefficient * square(s)).sum();
        let potential: f64 = self.constant.iter().map(|&(i, force)| force * q[i]).sum();
        kinetic + elastic - potential
    }

    /// `−vᵀ C v`, the power of dampers and drag.
    pub(super) fn damping_power(&self, v: impl Fn(usize) -> f64) -> f64 {
        let power = |damper: &Term| damper.coefficient * damper.extension(&v).powi(2);
        -self.dampers.iter().map(power).sum::<f64>()
    }
}

/// A direction of length 1.
fn unit(name: &str, normal: [f64; 2]) -> Result<[f64; 2], DynamicsError> {
    let length = positive("normal", name, normal[0].hypot(normal[1]))?;
    Ok(normal.map(|n| n / length))
}
