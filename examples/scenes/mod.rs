//! Scene files: what they say, what is wrong with them, and the systems they describe.

pub(crate) mod effect;
pub(crate) mod error;
pub(crate) mod file;
pub(crate) mod mechanics;
pub(crate) mod scene;
