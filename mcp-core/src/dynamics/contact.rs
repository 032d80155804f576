//! [`Contact`]s and [`Joint`]s: what constrains bodies.

use super::body::BodyId;

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
    /// Names of the normal impulse and, with friction, of the tangential one.
    pub(super) fn multipliers(&self) -> (String, Option<String>) {
        (self.name.clone(), self.friction.map(|_| format!("{} friction", self.name)))
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
