//! The hard cases: what must be solved, with a true error bound, and what must be refused, with the
//! right word. One file for each group; `cargo run --release --example hard_cases` prints them.
#![allow(clippy::unwrap_used, reason = "a test stops where its data are wrong")]

mod common;

#[path = "hard/bounds.rs"]
mod bounds;
#[path = "hard/case.rs"]
mod case;
#[path = "hard/check.rs"]
mod check;
#[path = "hard/cycling.rs"]
mod cycling;
#[path = "hard/degenerate.rs"]
mod degenerate;
#[path = "hard/exact.rs"]
mod exact;
#[path = "hard/families.rs"]
mod families;
#[path = "hard/fuzz.rs"]
mod fuzz;
#[path = "hard/fuzz_affine.rs"]
mod fuzz_affine;
#[path = "hard/fuzz_curved.rs"]
mod fuzz_curved;
#[path = "hard/invariances.rs"]
mod invariances;
#[path = "hard/kinks.rs"]
mod kinks;
#[path = "hard/overflow.rs"]
mod overflow;
#[path = "hard/phi.rs"]
mod phi;
#[path = "hard/powers.rs"]
mod powers;
#[path = "hard/random.rs"]
mod random;
#[path = "hard/scaling.rs"]
mod scaling;
#[path = "hard/several.rs"]
mod several;
#[path = "hard/singular.rs"]
mod singular;
#[path = "hard/traps.rs"]
mod traps;
#[path = "hard/weak.rs"]
mod weak;
#[path = "hard/zhuravlev.rs"]
mod zhuravlev;
