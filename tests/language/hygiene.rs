//! Any name works: those of the generated code, too.

use mcp_core::{Model, Options, Real, Scalar, check_derivatives, mcp, solve};

/// A helper with a name the expansion also uses.
fn expression<D: Scalar>(x: Real<D>) -> Real<D> {
    2.0 * x
}

mcp! {
    /// Names that a careless expansion would catch.
    pub model Hygiene {
        data { values: Set, members: Set, table: f64, shape[values]: f64, places: f64, model: f64, site: Vec<f64> }
        param read[at in values] = shape[at];
        var f free;            var k free;            var z >= 0.0;          var l free;           var u free;
        var D free;            var x[i in values] free;                      var head free;        var tail free;
        var self_ free start 3.0;                     var next[entry in members] free;
        def combination[row in values]: read[row] * x[row];
        eq given: f - table                            complements f;
        eq start: k - f                                complements k;
        eq lower: z - 1.0                              complements z;
        eq upper: l - z                                complements l;
        eq family: u - l                               complements u;
        eq scalar: D - u                               complements D;
        eq index[at in values]: combination[at] - D    complements x[at];
        eq name: head - expression(D)                  complements head;
        eq rows: tail - head - site[1]                 complements tail;
        eq over: self_ - tail * places                 complements self_;
        eq free[row in members]: next[row] - self_ - model   complements next[row];
        report value: { let value = self_; value + 1.0 };
    }
}

mcp! {
    /// Keywords of Rust, types of Rust, and capitals.
    pub model Marked {
        data { u32: Set, r#type: f64 }
        var r#match[I in u32] free;
        eq E[I in u32]: r#match[I] - r#type      complements r#match[I];
    }
}

#[test]
fn keywords_and_primitive_types_are_names_too() {
    let model = Marked::builder().u32(["a"]).r#type(2.0).build().unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    assert!((solution.level("match[a]").unwrap() - 2.0).abs() < 1e-9);
    assert!((model.view(&solution).unwrap().r#match["a"] - 2.0).abs() < 1e-9);
    assert_eq!(model.shape().equation_name(0), "E[a]");
}

#[test]
fn every_name_can_be_used() {
    let model = Hygiene::builder()
        .values(["a", "b"])
        .members(1)
        .table(7.0)
        .shape([2.0, 4.0])
        .places(0.5)
        .model(10.0)
        .site(vec![0.0, 5.0])
        .build()
        .unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-9);
    near(view.k, 7.0);
    near(view.D, 1.0);
    near(view.x["a"], 0.5);
    near(view.x["b"], 0.25);
    near(view.head, 2.0);
    near(view.tail, 7.0);
    near(view.self_, 3.5);
    near(view.next["1"], 13.5);
    near(view.value, 4.5);
    near(view.combination["b"], 1.0);
    assert_eq!(view.read.values(), [2.0, 4.0]);
    check_derivatives(&model, model.shape().start()).unwrap().verdict().unwrap();
}
