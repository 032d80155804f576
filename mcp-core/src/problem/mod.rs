//! Problems as numbers.
mod pattern;
pub use pattern::{Pattern, WithDiagonal};
