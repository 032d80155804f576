//! What only the compiler can see: types inside expressions.

use mcp_core::mcp;

mcp! {
    model Types {
        data { plants: Set, markets: Set, hours: Ordered, big: Subset(plants), cost[plants, markets]: f64, name: String }
        var x[i in plants, j in markets] >= 0.0;
        var w[i in plants] >= "a";
        var s[t in hours] free start 1;
        var v[i in big] free if 3;
        eq profit[i in plants, j in markets]: cost[i, j] - sum(markets, |k| x[k, k])    complements x[i, j];
        eq supply[i in plants]: w[i].logarithm()                                        complements w[i];
        eq level[t in hours]: { s.at(t - 1); }                                          complements s[t];
        eq value[i in big]: max(v[i], "1")                                              complements v[i];
    }
}

fn main() {}
