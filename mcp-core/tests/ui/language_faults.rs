//! Everything that is wrong with a model is shown at once, each fault at its word, and nothing that
//! only follows from it.

use mcp_core::{ModelError, mcp};

mcp! {
    model Faults {
        data { plants: Set, markets: Set, cost[plants, markets]: f64 }
        variable y free;
        var x[i in plants, j in markets] >= 0.0;
        var w[i in plants] >= 0.0;
        var p[j in market] <= 1.0;
        eq profit[i in plants, j in markets]: w(i) + cost[i, j] - p[j]    complements x[j, i];
        eq supply[i in plants].. sum(j, x[i, j]) =l= 1.0                  complements w[i];
        eq market[j in markets]: sum(plants, |i| x[i, j]) >= p[j - 1]     complements p[j];
    }
}

fn main() -> Result<(), ModelError> {
    let model = Faults::builder().plants(["a"]).markets(["b"]).cost(1.0).build()?;
    let _ = mcp_core::solve(&model, &mcp_core::Options::default())?;
    Ok(())
}
