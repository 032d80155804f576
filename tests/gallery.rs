//! The numbers the examples assert, derived again by other means: closed forms, bisection,
//! enumeration, another algorithm, duality.
#![allow(clippy::unwrap_used, reason = "a test stops where its data are wrong")]

#[path = "gallery/bimatrix.rs"]
mod bimatrix;
#[path = "gallery/electricity.rs"]
mod electricity;
#[path = "gallery/kkt.rs"]
mod kkt;
#[path = "gallery/numbers.rs"]
mod numbers;
#[path = "gallery/obstacle.rs"]
mod obstacle;
#[path = "gallery/power.rs"]
mod power;
#[path = "gallery/spatial_price.rs"]
mod spatial_price;
#[path = "gallery/stackelberg_cournot.rs"]
mod stackelberg_cournot;
