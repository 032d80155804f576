//! [`Mechanics`]: planar bodies and the effects that act on them.

use super::error::{DynamicsError, finite, not_negative, positive, share};
use crate::scalar::Scalar;

/// A coordinate of a planar body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// To the right.
    X,
    /// Up.
    Y,
    /// Rotation, counter-clockwise.
    Angle,
}

impl Axis {
    /// `x`, `y`, `angle`.
    pub fn name(self) -> &'static str {
        match self {
            Axis::X => "x",
            Axis::Y => "y",
            Axis::Angle => "angle",
        }
    }
}

/// A planar body with the coordinates it is given: one that only falls has `y` alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    name: String,
    mass: f64,
    inertia: f64,
    radius: f64,
    motion: [Option<(f64, f64)>; 3],
}

impl Body {
    /// A point of this mass \[kg\] without coordinates.
    pub fn new(name: impl Into<String>, mass: f64) -> Self {
        Body { name: name.into(), mass, inertia: 0.0, radius: 0.0, motion: [None; 3] }
    }
    /// A disc of this radius \[m\].
    #[must_use]
    pub fn radius(mut self, radius: f64) -> Self {
        self.radius = radius;
        self
    }
    /// Moves along `axis`, [`Axis::X`] or [`Axis::Y`], from `position` \[m\] with `velocity` \[m/s\].
    #[must_use]
    pub fn moving(mut self, axis: Axis, position: f64, velocity: f64) -> Self {
        self.motion[axis as usize] = Some((position, velocity));
        self
    }
    /// Turns with the moment of inertia \[kg m²\] from `angle` with the angular `velocity` \[1/s\].
    #[must_use]
    pub fn turning(mut self, inertia: f64, angle: f64, velocity: f64) -> Self {
        self.inertia = inertia;
        self.motion[Axis::Angle as usize] = Some((angle, velocity));
        self
    }
}

/// Number of a body in its [`Mechanics`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyId(pub(super) usize);

/// What a contact is with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Obstacle {
    /// The half plane `normal · x <= offset`; a floor has the normal `[0, 1]`.
    Plane {
        /// Direction out of it, of any length.
        normal: [f64; 2],
        /// Distance from the origin along the normal \[m\].
        offset: f64,
    },
    /// Another disc.
    Body(BodyId),
}

/// A unilateral contact with Newton's law of impact, and Coulomb friction if asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    pub(super) name: String,
    pub(super) body: BodyId,
    pub(super) with: Obstacle,
    pub(super) restitution: f64,
    pub(super) friction: Option<f64>,
}

impl Contact {
    /// `0 <= u⁺ ⟂ r >= 0` without restitution and friction.
    pub fn new(name: impl Into<String>, body: BodyId, with: Obstacle) -> Self {
        Contact { name: name.into(), body, with, restitution: 0.0, friction: None }
    }
    /// Newton's law: `0 <= u⁺ + e u ⟂ r >= 0`.
    #[must_use]
    pub fn restitution(mut self, e: f64) -> Self {
        self.restitution = e;
        self
    }
    /// Coulomb's law: `|r_t| <= μ r_n`, equal and opposite to the slip where there is one.
    #[must_use]
    pub fn friction(mut self, mu: f64) -> Self {
        self.friction = Some(mu);
        self
    }
}

/// What a joint holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// The body stays on a line with this normal, of any length.
    Rail([f64; 2]),
    /// The body keeps its distance from a point.
    Anchor([f64; 2]),
    /// The body keeps its distance from another.
    Body(BodyId),
}

/// A bilateral constraint, kept by a multiplier without bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    pub(super) name: String,
    pub(super) body: BodyId,
    pub(super) hold: Hold,
}

impl Joint {
    /// A joint of a body.
    pub fn new(name: impl Into<String>, body: BodyId, hold: Hold) -> Self {
        Joint { name: name.into(), body, hold }
    }
}

/// A linear force along one axis, between two bodies or a body and the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// The axis.
    pub axis: Axis,
    /// The body.
    pub body: BodyId,
    /// The body it is linked to; `None`: the ground.
    pub to: Option<BodyId>,
    /// Stiffness \[N/m\] or damping \[N s/m\].
    pub coefficient: f64,
    /// Of a spring: the coordinate difference, or the coordinate, without force \[m\].
    pub rest: f64,
}

/// A link between coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    pub(super) i: usize,
    pub(super) j: Option<usize>,
    pub(super) coefficient: f64,
    pub(super) rest: f64,
}

impl Term {
    /// `x_i − x_j − rest`.
    fn extension<D: Scalar>(self, x: impl Fn(usize) -> D) -> D {
        let difference = match self.j {
            Some(j) => x(self.i) - x(j),
            None => x(self.i),
        };
        if self.rest == 0.0 { difference } else { difference - D::constant(self.rest) }
    }

    /// `f_i −= force`, `f_j += force`.
    fn pull<D: Scalar>(self, force: D, f: &mut [D]) {
        f[self.i] = f[self.i] - force;
        if let Some(j) = self.j {
            f[j] = f[j] + force;
        }
    }

    /// Adds `scale ·` its matrix `±c` to `(i, j, value)` entries.
    fn entries(self, scale: f64, put: &mut impl FnMut(usize, usize, f64)) {
        let c = scale * self.coefficient;
        put(self.i, self.i, c);
        if let Some(j) = self.j {
            put(j, j, c);
            put(self.i, j, -c);
            put(j, self.i, -c);
        }
    }
}

/// A body as numbers of coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) coordinates: [Option<usize>; 3],
    pub(super) radius: f64,
}

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
    /// positive where the body turns, a negative radius, a motion that is not finite.
    pub fn add_body(&mut self, body: &Body) -> Result<BodyId, DynamicsError> {
        let of = |what: &str| format!("the {what} of {}", body.name);
        positive(|| of("mass"), body.mass)?;
        not_negative(|| of("radius"), body.radius)?;
        let mut coordinates = [None; 3];
        for axis in [Axis::X, Axis::Y, Axis::Angle] {
            let Some((position, velocity)) = body.motion[axis as usize] else { continue };
            let mass = match axis {
                Axis::Angle => positive(|| of("inertia"), body.inertia)?,
                Axis::X | Axis::Y => body.mass,
            };
            coordinates[axis as usize] = Some(self.mass.len());
            self.names.push(format!("{}.{}", body.name, axis.name()));
            self.mass.push(mass);
            self.start.0.push(finite(|| of(axis.name()), position)?);
            self.start.1.push(finite(|| of("velocity"), velocity)?);
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
        finite(|| "gravity".to_owned(), g)?;
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
        self.constant.push((i, finite(|| "a force".to_owned(), force)?));
        Ok(())
    }

    /// Linear (Stokes) drag: the force `−c v` on every coordinate of a body but its angle.
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] if `c` \[N s/m\] is negative.
    pub fn add_drag(&mut self, body: BodyId, c: f64) -> Result<(), DynamicsError> {
        not_negative(|| "drag".to_owned(), c)?;
        for i in self.places[body.0].coordinates.into_iter().take(2).flatten() {
            self.dampers.push(Term { i, j: None, coefficient: c, rest: 0.0 });
        }
        Ok(())
    }

    /// A linear spring.
    ///
    /// # Errors
    /// [`DynamicsError::NoCoordinate`], [`DynamicsError::OutOfRange`] for a negative stiffness.
    pub fn add_spring(&mut self, link: Link) -> Result<(), DynamicsError> {
        let term = self.term("a spring", link)?;
        self.springs.push(term);
        Ok(())
    }

    /// A linear damper.
    ///
    /// # Errors
    /// As [`add_spring`](Self::add_spring).
    pub fn add_damper(&mut self, link: Link) -> Result<(), DynamicsError> {
        let term = self.term("a damper", link)?;
        self.dampers.push(Term { rest: 0.0, ..term });
        Ok(())
    }

    /// A unilateral contact.
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] for a restitution outside `[0, 1]`, a negative friction, a
    /// normal without length.
    pub fn add_contact(&mut self, mut contact: Contact) -> Result<(), DynamicsError> {
        let of = |what: &str| format!("the {what} of {}", contact.name);
        share(|| of("restitution"), contact.restitution)?;
        not_negative(|| of("friction"), contact.friction.unwrap_or(0.0))?;
        if let Obstacle::Plane { normal, offset } = contact.with {
            finite(|| of("offset"), offset)?;
            let length = positive(|| of("normal"), normal[0].hypot(normal[1]))?;
            let normal = normal.map(|n| n / length);
            contact.with = Obstacle::Plane { normal, offset };
        }
        self.contacts.push(contact);
        Ok(())
    }

    /// A bilateral joint.
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] for a rail whose normal has no length.
    pub fn add_joint(&mut self, mut joint: Joint) -> Result<(), DynamicsError> {
        if let Hold::Rail(normal) = joint.hold {
            let what = || format!("the normal of {}", joint.name);
            let length = positive(what, normal[0].hypot(normal[1]))?;
            joint.hold = Hold::Rail(normal.map(|n| n / length));
        }
        self.joints.push(joint);
        Ok(())
    }

    fn coordinate(&self, what: &str, body: BodyId, axis: Axis) -> Result<usize, DynamicsError> {
        let missing = || DynamicsError::NoCoordinate {
            what: what.to_owned(),
            coordinate: format!("{}.{}", self.body_names[body.0], axis.name()),
        };
        self.places[body.0].coordinates[axis as usize].ok_or_else(missing)
    }

    fn term(&self, what: &str, link: Link) -> Result<Term, DynamicsError> {
        let i = self.coordinate(what, link.body, link.axis)?;
        let j = link.to.map(|to| self.coordinate(what, to, link.axis)).transpose()?;
        let coefficient = not_negative(|| what.to_owned(), link.coefficient)?;
        let rest = finite(|| what.to_owned(), link.rest)?;
        Ok(Term { i, j, coefficient, rest })
    }

    /// `f(q, v) − hθ K v` of the effects there are, added to `f`.
    pub(super) fn forces<D: Scalar>(
        &self,
        h_theta: f64,
        q: impl Fn(usize) -> D,
        v: impl Fn(usize) -> D,
        f: &mut [D],
    ) {
        let number = D::constant;
        for &(i, force) in &self.constant {
            f[i] = f[i] + number(force);
        }
        for spring in &self.springs {
            let predicted = |i| q(i) + number(h_theta) * v(i);
            spring.pull(number(spring.coefficient) * spring.extension(predicted), f);
        }
        for damper in &self.dampers {
            damper.pull(number(damper.coefficient) * damper.extension(&v), f);
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
