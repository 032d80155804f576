//! Complementarity functions: `φ(a, b) = 0` exactly where `a >= 0`, `b >= 0`, `ab = 0`.
//!
//! | function | formula | used for |
//! | --- | --- | --- |
//! | [`fischer_burmeister`] | `a + b − √(a² + b²)` | merit `θ = ½‖Φ‖²`, Newton directions |
//! | [`mid`] | `mid(z−l, F, z−u)`, for `[0, ∞)` the minimum | active-set directions, natural residual |
//!
//! On a box the Fischer–Burmeister function is nested, `φ(z−l, −φ(u−z, −F))` ([Bil95](crate#references)); free
//! variables give `F`, fixed ones `z − l`: see [`Reformulation`]. Cost of one evaluation of `Φ` and
//! its derivative: one or two square roots a row.

mod fischer_burmeister;
mod minimum;
mod reformulation;

pub use fischer_burmeister::{fischer_burmeister, fischer_burmeister_derivative, kink_element};
pub use minimum::{Branch, mid};
pub use reformulation::Reformulation;
