//! Scene files: what they say, what is wrong with them, and the systems they describe.

pub(crate) mod effect;
#[path = "../effects/mod.rs"]
pub(crate) mod effects;
pub(crate) mod file;
pub(crate) mod mechanics;
pub(crate) mod place;
pub(crate) mod scene;
