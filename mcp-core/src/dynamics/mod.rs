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
//! ([`MoreauJean::balance`]), and joints by `O(h)`: the pendulum of the example `scenes`, without drag and wall, loses 3.4 J in ten seconds at
//! `h = 2` ms and 1.8 J at half of that. It can rise where a contact that already opens is pressed again within
//! the step, by `O(h²)`: a ball gains at most `m (1−e) / (8 (1+e)) · (g h)²`. It can also rise where
//! friction and restitution meet, since Newton's law of impact looks at normal velocities alone.

mod active_sets;
mod balance;
mod body;
mod circuit;
mod complementarity_system;
mod constraint;
mod contact;
mod error;
mod euler_moreau;
mod inertia;
mod link;
mod mechanics;
mod moreau_jean;
mod motion;
mod sparse_rows;
mod step_problem;
mod stepper;

pub use balance::{EnergyBalance, Reaction};
pub use body::{Axis, Body, BodyId};
pub use circuit::{Circuit, Element, ElementKind};
pub use complementarity_system::{ComplementaritySystem, Pair};
pub use contact::{Contact, Hold, Joint, Obstacle};
pub use error::DynamicsError;
pub use euler_moreau::EulerMoreau;
pub use link::Link;
pub use mechanics::Mechanics;
pub use moreau_jean::{MoreauJean, Scheme};
pub use step_problem::step_options;
pub use stepper::{StepReport, StepSize, TimeStepper};

#[cfg(test)]
mod tests;
