//! Nonsmooth dynamics: bodies with impacts and friction, circuits with diodes, relays.
//!
//! Every time step is one mixed complementarity problem, built from the effects a system is given
//! and no other: an effect that is not named adds no unknown, no equation and no operation, and a
//! contact takes part only where its gap is about to close. A ball in flight solves no problem.
//!
//! | | system | scheme |
//! | --- | --- | --- |
//! | first order | [`ComplementaritySystem`] with [`Pair`]s: diodes, relays, [twisting](ComplementaritySystem::twisting) controllers; [`Circuit`] by its elements | [`EulerMoreau`] |
//! | second order | [`Mechanics`]: planar [`Body`]s with gravity, springs, dampers, drag, [`Contact`]s, [`Joint`]s | [`MoreauJean`] |
//!
//! Both are [`TimeStepper`]s. The problem of a step keeps pattern, symbolic work and memory while
//! the same contacts are closed, and starts from the last reactions; nothing is allocated then. A
//! step whose certificate does not accept is an error that names time and contacts; none is
//! skipped.
//!
//! What the schemes do to energy: in flight, with linear springs, Moreau–Jean(½) conserves it up to
//! rounding; dampers, drag, impacts with restitution and friction take it
//! ([`MoreauJean::balance`]). It can rise where a contact closes between two steps, by `O(h)`, and
//! where friction and restitution meet, since Newton's law of impact looks at normal velocities
//! alone.

mod active_sets;
mod circuit;
mod complementarity_system;
mod constraint;
mod error;
mod euler_moreau;
mod inertia;
mod mechanics;
mod moreau_jean;
mod sparse_rows;
mod step_problem;
mod stepper;

pub use circuit::{Circuit, Element, ElementKind};
pub use complementarity_system::{ComplementaritySystem, Pair};
pub use error::DynamicsError;
pub use euler_moreau::EulerMoreau;
pub use mechanics::{Axis, Body, BodyId, Contact, Hold, Joint, Link, Mechanics, Obstacle};
pub use moreau_jean::{EnergyBalance, MoreauJean, Reaction, Scheme};
pub use step_problem::step_options;
pub use stepper::{StepReport, StepSize, TimeStepper};

#[cfg(test)]
mod tests;
