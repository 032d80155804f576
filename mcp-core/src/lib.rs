//! Mixed complementarity problems.
extern crate self as mcp_core;
pub mod problem;
pub mod scalar;
pub use problem::*;
pub use scalar::*;
