//! What stands in a scene file.

use super::effects::{At, Source};
use super::place::Entry;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::ops::Deref;

/// Two values, neither more nor fewer.
#[derive(Debug)]
pub(crate) struct Two<T>(pub(crate) [T; 2]);

impl<T> Deref for Two<T> {
    type Target = [T; 2];

    fn deref(&self) -> &[T; 2] {
        &self.0
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Two<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let values = Vec::deserialize(deserializer)?;
        let two = |values: Vec<T>| D::Error::invalid_length(values.len(), &"two");
        values.try_into().map(Two).map_err(two)
    }
}

/// A scene: a base of bodies, circuit elements or a linear system, the effects it names, their data.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SceneFile {
    pub(crate) title: String,
    pub(crate) effects: Vec<At<String>>,
    pub(crate) time: Time,
    #[serde(default)]
    pub(crate) body: Vec<At<Body>>,
    #[serde(default)]
    pub(crate) element: Vec<At<Element>>,
    pub(crate) system: Option<At<System>>,
    pub(crate) zhuravlev_ivanov: Option<At<ZhuravlevIvanov>>,
    pub(crate) gravity: Option<Gravity>,
    #[serde(default)]
    pub(crate) spring: Vec<At<Spring>>,
    #[serde(default)]
    pub(crate) damper: Vec<At<Damper>>,
    #[serde(default)]
    pub(crate) drag: Vec<At<Drag>>,
    #[serde(default)]
    pub(crate) contact: Vec<At<Contact>>,
    #[serde(default)]
    pub(crate) joint: Vec<At<Joint>>,
    #[serde(default)]
    pub(crate) relay: Vec<At<Relay>>,
    #[serde(default)]
    pub(crate) sliding_mode: Vec<At<SlidingMode>>,
}

/// Step size [s], number of steps, parameters of the scheme.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Time {
    pub(crate) step: At<f64>,
    pub(crate) steps: u64,
    pub(crate) theta: Option<At<f64>>,
    pub(crate) gamma: Option<At<f64>>,
}

impl Time {
    /// Where the parameters of the scheme stand; a matrix that `h` makes singular is a fault of `h`.
    pub(crate) fn entry<'a>(&self, source: &'a Source<'a>) -> Entry<'a> {
        Entry::new(source, "time", self.step.span())
            .has("step", "step", &self.step)
            .has("matrix", "step", &self.step)
            .may("theta", "theta", self.theta.as_ref())
            .may("gamma", "gamma", self.gamma.as_ref())
    }
}

/// A planar body: position and velocity of the coordinates it has.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Body {
    pub(crate) name: At<String>,
    pub(crate) mass: Option<At<f64>>,
    pub(crate) inertia: Option<At<f64>>,
    pub(crate) radius: Option<At<f64>>,
    pub(crate) x: Option<At<Two<f64>>>,
    pub(crate) y: Option<At<Two<f64>>>,
    pub(crate) angle: Option<At<Two<f64>>>,
}

/// An element of a circuit; the current flows from the first node to the second.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Element {
    pub(crate) name: At<String>,
    pub(crate) kind: At<String>,
    pub(crate) value: Option<At<f64>>,
    pub(crate) start: Option<At<f64>>,
    pub(crate) between: Two<String>,
}

/// `x' = A x + b`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct System {
    pub(crate) states: At<Vec<String>>,
    pub(crate) start: At<Vec<f64>>,
    pub(crate) matrix: At<Vec<Vec<f64>>>,
    pub(crate) drift: Option<At<Vec<f64>>>,
}

/// The transformed bouncing mass.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ZhuravlevIvanov {
    pub(crate) start: Two<At<f64>>,
    pub(crate) kappa: At<f64>,
    pub(crate) acceleration: At<f64>,
}

/// Effect `gravity`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Gravity {
    pub(crate) acceleration: At<f64>,
}

/// Effect `spring`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Spring {
    pub(crate) body: At<String>,
    pub(crate) to: Option<At<String>>,
    pub(crate) along: At<String>,
    pub(crate) stiffness: At<f64>,
    pub(crate) rest: Option<At<f64>>,
}

/// Effect `damper`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Damper {
    pub(crate) body: At<String>,
    pub(crate) to: Option<At<String>>,
    pub(crate) along: At<String>,
    pub(crate) damping: At<f64>,
}

/// Effect `drag`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Drag {
    pub(crate) body: At<String>,
    pub(crate) coefficient: At<f64>,
}

/// Effect `contact`, with a plane, by default the floor, or another body; `restitution` and `friction` are for the effects of
/// these names.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Contact {
    pub(crate) name: At<String>,
    pub(crate) body: At<String>,
    pub(crate) with: Option<At<String>>,
    pub(crate) normal: Option<At<Two<f64>>>,
    pub(crate) offset: Option<At<f64>>,
    pub(crate) restitution: Option<At<f64>>,
    pub(crate) friction: Option<At<f64>>,
}

/// Effect `joint`: one of `rail`, `anchor`, `with`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Joint {
    pub(crate) name: At<String>,
    pub(crate) body: At<String>,
    pub(crate) rail: Option<At<Two<f64>>>,
    pub(crate) anchor: Option<At<Two<f64>>>,
    pub(crate) with: Option<At<String>>,
}

/// Effect `relay`: `x' += input λ`, `y = output · x`, `−λ` in the sign of `y`; by default within ±1.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Relay {
    pub(crate) name: At<String>,
    pub(crate) input: At<Vec<f64>>,
    pub(crate) output: At<Vec<f64>>,
    pub(crate) lower: Option<At<f64>>,
    pub(crate) upper: Option<At<f64>>,
}

/// Effect `sliding_mode`: a twisting controller with two inputs, times the gain, and two outputs.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SlidingMode {
    pub(crate) name: At<String>,
    pub(crate) gain: At<f64>,
    pub(crate) inputs: At<Two<Vec<f64>>>,
    pub(crate) outputs: At<Two<Vec<f64>>>,
}

/// Numbers of things by their names.
pub(crate) type Names<T> = BTreeMap<String, T>;

/// What is given, or the default.
pub(crate) fn or<T: Clone>(given: Option<&At<T>>, default: T) -> T {
    given.map_or(default, |given| given.get_ref().clone())
}
