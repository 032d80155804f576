//! What people do with a model: solve it for many values of a parameter, compare two answers.
//!
//! | item | answers |
//! | --- | --- |
//! | [`sweep`] | how does everything move with a parameter, and where do bounds begin or cease to bind? |
//! | [`compare`] | what changed between two solutions, by name, in percent? |

mod compare;
#[cfg(feature = "plots")]
mod plot;
mod sweep;
mod sweep_table;

pub use compare::{Change, Changes, Lone, Outcome, compare};
#[cfg(feature = "plots")]
pub use plot::{COLORS, PlotError};
pub use sweep::{StateChange, Sweep, SweepPoint, sweep, sweep_with};
pub use sweep_table::{SweepColumn, SweepLine, SweepTable};
