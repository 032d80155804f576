//! Models of one module may have parts of the same name.

use mcp_core::{Model, mcp};

mcp! {
    pub model Home {
        var p >= 0.0;
        eq market: p - 2.0      complements p;
        part tax { param rate = 0.5; adds market: -rate; }
        part cap { adds market: 1.0; }
    }
}

mcp! {
    pub model World {
        data { regions: Set }
        var p[r in regions] >= 0.0;
        eq market[r in regions]: p[r] - 2.0      complements p[r];
        part tax { data { rates[regions]: f64 } adds market[r]: -rates[r]; }
        part quota { adds market[r]: 1.0; }
    }
}

#[allow(unused_qualifications, reason = "`Tax` alone is ambiguous")]
#[test]
fn parts_of_one_name_are_told_apart_by_their_models() {
    let home = Home::builder().build().unwrap();
    let world = World::builder().regions(["east", "west"]).build().unwrap();
    assert_eq!(home.with((Cap, HomeParts::Tax)).unwrap().parts(), ["tax", "cap"]);
    let taxed = world.with((WorldParts::Tax { rates: 1 }, Quota)).unwrap();
    assert_eq!((taxed.parts(), taxed.shape().n()), (vec!["tax", "quota"], 2));
}

#[test]
fn a_model_with_parts_may_stand_in_a_function() {
    mcp! {
        model Local {
            var p >= 0.0;
            eq market: p - 2.0  complements p;
            part tax { data { rate: f64 } adds market: -rate; }
        }
    }
    let taxed = Local::builder().build().unwrap().with(Tax { rate: 1 }).unwrap();
    assert_eq!(taxed.parts(), ["tax"]);
}
