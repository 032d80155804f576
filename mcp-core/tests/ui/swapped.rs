//! Two indices in the wrong order.

use mcp_core::mcp;

mcp! {
    /// Plants ship to markets.
    model Transport {
        data { plants: Set, markets: Set, capacity[plants]: f64, demand[markets]: f64, cost[plants, markets]: f64 }
        var x[i in plants, j in markets] >= 0.0;
        var w[i in plants] >= 0.0;
        var p[j in markets] >= 0.0;
        eq profit[i in plants, j in markets]: w[i] + cost[i, j] - p[j]      complements x[i, j];
        eq supply[i in plants]: capacity[i] >= sum(markets, |j| x[j, i])    complements w[i];
        eq market[j in markets]: sum(plants, |i| x[i, j]) >= demand[j]      complements p[j];
    }
}

fn main() {}
