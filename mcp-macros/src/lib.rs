//! Mixed complementarity problems.
