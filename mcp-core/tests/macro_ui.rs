//! What the compiler shows of the macros' errors, and where they leave an error to it.
//!
//! The messages of the macros themselves are tested in `mcp-macros`, in milliseconds; each case here
//! runs the compiler, whose own words change from version to version. So the cases are compared on
//! the version they were written with. After a deliberate change:
//! `TRYBUILD=overwrite cargo test --workspace --test macro_ui`.

use std::process::Command;

/// The compiler whose words stand in `tests/ui/*.stderr`.
const COMPILER: &str = "rustc 1.95.";

#[test]
fn errors_stand_at_the_users_own_tokens() {
    let version = Command::new("rustc").arg("--version").output().map(|output| output.stdout);
    if version.is_ok_and(|version| version.starts_with(COMPILER.as_bytes())) {
        trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
    }
}
