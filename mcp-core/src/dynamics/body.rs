//! [`Body`]: a planar body by its coordinates.

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

    /// What its rate is called.
    pub(super) fn rate(self) -> &'static str {
        match self {
            Axis::X => "x velocity",
            Axis::Y => "y velocity",
            Axis::Angle => "angular velocity",
        }
    }
}

/// A planar body with the coordinates it is given: one that only falls has `y` alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    pub(super) name: String,
    pub(super) mass: f64,
    pub(super) inertia: f64,
    pub(super) radius: f64,
    pub(super) motion: [Option<(f64, f64)>; 3],
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

/// Number of a body in its [`Mechanics`](super::Mechanics).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyId(pub(super) usize);

/// A body as numbers of coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) coordinates: [Option<usize>; 3],
    pub(super) radius: f64,
}
