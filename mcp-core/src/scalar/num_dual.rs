//! num-dual types.
