//! Parts that are switched on in the wrong place, and a name that two models have.

use mcp_core::mcp;

mcp! {
    model Home {
        var p >= 0.0;
        eq market: p - 2.0      complements p;
        part tax { adds market: -0.5; }
        part cap { data { limit: f64 } adds market: limit; }
    }
}

mcp! {
    model World {
        var q >= 0.0;
        eq trade: q - 2.0      complements q;
        part tax { adds trade: -0.5; }
    }
}

fn main() {
    let world = World::builder().build().unwrap();
    world.with(Tax).unwrap();
    world.with(WorldParts::Tax).unwrap();
    world.with(Cap { limit: 1.0 }).unwrap();
}
