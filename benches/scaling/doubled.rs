//! A problem whose matrix is singular everywhere.

use mcp_core::{ModelError, mcp};

mcp! {
    /// A membrane on springs with every equation there twice, once for a variable that no equation reads:
    /// the matrix is singular everywhere, and not only up to rounding.
    pub(crate) model Doubled {
        data { nodes: usize }
        var z[i in nodes, j in nodes] free start 1.0;
        var w[i in nodes, j in nodes] free;
        def bent[i in nodes, j in nodes]:
            6.0 * z[i, j] - z.at(i - 1, j).or(0.0) - z.at(i + 1, j).or(0.0)
                - z.at(i, j - 1).or(0.0) - z.at(i, j + 1).or(0.0)
                + z[i, j] * z[i, j] * z[i, j] * 0.5 + 10.0;

        eq once[i in nodes, j in nodes]: bent[i, j] complements z[i, j];
        eq twice[i in nodes, j in nodes]: bent[i, j] complements w[i, j];
    }
}

impl Doubled {
    /// On `k × k` nodes.
    pub(crate) fn on(k: usize) -> Result<Self, ModelError> {
        Doubled::builder().nodes(k).build()
    }
}
