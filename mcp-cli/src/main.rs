//! The command `mcp`.
fn main() {}
