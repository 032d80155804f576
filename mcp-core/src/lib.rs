//! Mixed complementarity problems.
extern crate self as mcp_core;
pub mod error;
pub mod linalg { #[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)] #[error("x")] pub enum LinearError {} }
pub mod model;
pub mod problem;
pub mod scalar;
pub use error::*;
pub use model::*;
pub use problem::*;
pub use scalar::*;
