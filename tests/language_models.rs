//! The four models the language was designed for, solved on small data with answers derived by other
//! means: closed forms, or a different algorithm on plain numbers.
#![allow(clippy::unwrap_used, reason = "a test stops where its data are wrong")]

#[path = "language/cge.rs"]
mod cge;
#[path = "language/contact.rs"]
mod contact;
#[path = "language/power.rs"]
mod power;
#[path = "language/spatial.rs"]
mod spatial;
