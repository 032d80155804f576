//! The examples `scarf` and `traffic`: their solutions are checked in plain numbers, from the CSV
//! files alone, by code that shares nothing with the models.
#![allow(clippy::unwrap_used, reason = "a test stops where its data are wrong")]

#[path = "gallery_flows/braess.rs"]
mod braess;
#[path = "gallery_flows/scarf.rs"]
mod economy;
#[path = "gallery_flows/sheet.rs"]
mod sheet;
#[path = "gallery_flows/town.rs"]
mod town;

#[path = "../examples/scarf.rs"]
#[allow(dead_code, reason = "an example also prints")]
mod scarf;
#[path = "../examples/traffic.rs"]
#[allow(dead_code, reason = "an example also prints")]
mod traffic;
