//! What the compiler shows where `#[mcp_fn]` leaves an error to it.
//!
//! The messages of the macro itself are tested in `mcp-macros`, in milliseconds; each case here
//! runs the compiler. After a deliberate change: `TRYBUILD=overwrite cargo test --test macro_ui`.

#[test]
fn errors_stand_at_the_users_own_tokens() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
