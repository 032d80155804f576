//! Models in the language at work: sharing, conditions, hygiene, changes by name, bad input.
#![allow(clippy::unwrap_used, reason = "a test stops where its data are wrong")]

#[path = "language/bad_input.rs"]
mod bad_input;
#[path = "language/changes.rs"]
mod changes;
#[path = "language/hygiene.rs"]
mod hygiene;
#[path = "language/sharing.rs"]
mod sharing;
