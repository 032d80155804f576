//! A small open economy, the effects it knows, and files that name them.

pub(crate) mod closed_form;
pub(crate) mod data;
pub(crate) mod effect;
#[path = "../effects/mod.rs"]
pub(crate) mod effects;
pub(crate) mod file;
pub(crate) mod model;
mod numbers;
pub(crate) mod scenario;
pub(crate) mod table;
