//! Parts of a model: off, they cost nothing; on, they are as if their text stood in the model.
#![allow(clippy::unwrap_used, reason = "a test stops where its data are wrong")]

#[allow(dead_code, clippy::pedantic, clippy::all, reason = "generated, in a macro of this crate")]
#[path = "language/economy.rs"]
mod economy;
#[path = "language/parts.rs"]
mod parts;
#[path = "language/parts_beside.rs"]
mod parts_beside;
#[path = "language/parts_changes.rs"]
mod parts_changes;
#[path = "language/parts_rows.rs"]
mod parts_rows;
#[path = "language/twins.rs"]
mod twins;
