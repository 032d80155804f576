//! Mixed complementarity problems.
extern crate self as mcp_core;
pub mod error;
pub mod globalise;
pub mod linalg;
pub mod model;
pub mod ncp;
pub mod problem;
pub mod scalar;
pub mod solver;
pub use error::*;
pub use globalise::*;
pub use linalg::*;
pub use model::*;
pub use problem::*;
pub use scalar::*;
pub use solver::*;
