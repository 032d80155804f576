//! Mixed complementarity problems from files of modelling systems.
//!
//! [`nl`] reads AMPL's `.nl` files, which AMPL, Pyomo and others write, as models of
//! [`mcp_core`]; solutions go back in `.sol` files.

pub mod nl;
