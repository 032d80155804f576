//! Globalisation: which trial points a Newton method accepts, and when it stops trying.

mod armijo;
mod forcing;
mod reference;
mod stall;

pub use armijo::Armijo;
pub(crate) use forcing::Forcing;
pub use reference::{Nonmonotone, Reference};
pub use stall::Stall;
pub(crate) use stall::StallWatch;
