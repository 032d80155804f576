//! Messages of the parser of `mcp!` at their places.

use super::model_errors as errors;
use super::model_with as beside;

#[test]
fn a_model_has_a_name_and_a_block() {
    assert_eq!(errors("modle M {}"), "1:1 expected `pub model Name { … }`");
    assert_eq!(errors("pub struct M {}"), "1:5 expected `pub model Name { … }`");
    assert_eq!(errors("model {}"), "1:7 expected `pub model Name { … }`");
    assert_eq!(errors("model M"), "1:1 expected `pub model Name { … }`");
    assert_eq!(errors(""), "1:1 expected `pub model Name { … }`");
    assert_eq!(
        errors("model M { var x free; eq e: x complements x; } model N {}"),
        "1:48 nothing may follow the model: write one `mcp!` for each"
    );
    assert_eq!(errors("model M {}"), "1:7 the model has no variables: `var x >= 0.0;`");
    assert_eq!(
        errors("model M { var x free; }"),
        "1:7 the model has no equations: `eq balance: … complements x;`"
    );
    assert_eq!(
        errors("model M { data { s: Set } eq e: 1.0 complements x; }"),
        "1:7 the model has no variables: `var x >= 0.0;`"
    );
}

#[test]
fn unknown_items_are_answered_with_the_nearest() {
    assert_eq!(
        beside("vaar y >= 0.0; reprt r: u;"),
        "2:1 there is no item `vaar`; did you mean `var`?\n\
2:16 there is no item `reprt`; did you mean `report`?"
    );
    assert_eq!(
        beside("constraint c: u;"),
        "2:1 there is no item `constraint`: expected one of `data`, `param`, `var`, \
`fix`, `def`, `eq`, `report`, `part`"
    );
    assert_eq!(
        beside("= 5; 3;"),
        "2:1 expected one of `data`, `param`, `var`, `fix`, `def`, `eq`, `report`, `part`\n\
2:6 expected one of `data`, `param`, `var`, `fix`, `def`, `eq`, `report`, `part`"
    );
    assert_eq!(
        beside("date { a: Set }  vra y free;"),
        "2:1 there is no item `date`; did you mean `data`?\n\
2:18 there is no item `vra`: expected one of `data`, `param`, `var`, `fix`, \
`def`, `eq`, `report`, `part`"
    );
    assert_eq!(beside("/// nothing follows"), "2:1 expected an item behind its documentation");
}

#[test]
fn an_item_ends_with_a_semicolon() {
    assert_eq!(
        beside(
            "param a = 1.0 param b;\n\
param d"
        ),
        "2:11 expected `;`\n\
3:7 expected `;`"
    );
    assert_eq!(
        beside(
            "var y free /// next\n\
var v free; eq ey: y complements y; eq ev: v complements v;"
        ),
        "2:7 expected `;`"
    );
    assert_eq!(beside("eq ey: u complements z0 data { k: Set }"), "2:22 expected `;`");
    assert_eq!(beside("report r: u"), "2:11 expected `;`");
    assert_eq!(beside("eq ey: u complements z0 z0;"), "2:25 expected `;`");
    assert_eq!(beside("var y free 0.0; report r: y;"), "2:12 expected `;`");
}

#[test]
fn every_item_says_what_it_lacks() {
    assert_eq!(beside("param ;"), "2:1 expected a name after `param`");
    assert_eq!(beside("param move;"), "2:7 expected a name after `param`");
    assert_eq!(beside("param a: f64;"), "2:8 expected `param a;` or `param a = 0.0;`");
    assert_eq!(beside("param a = ;"), "2:9 expected an expression after `=`");
    assert_eq!(beside("fix z0;"), "2:5 expected the value: `fix z0 = 1.0;`");
    assert_eq!(beside("fix z0 = ;"), "2:8 expected an expression after `=`");
    assert_eq!(beside("fix x[] = 1.0;"), "2:6 no index stands in the brackets: write `x` alone");
    assert_eq!(beside("def d = u;"), "2:7 expected `:` and an expression behind the header of `d`");
    assert_eq!(beside("def d: ;"), "2:6 expected an expression after `:`");
    assert_eq!(beside("def d: u complements z0;"), "2:10 only an `eq` has `complements`");
    assert_eq!(
        beside("report r[i in plants];"),
        "2:9 expected `:` and an expression behind the header of `r`"
    );
    assert_eq!(beside("eq e = u;"), "2:6 expected `:` and an expression behind the header of `e`");
    assert_eq!(
        beside("eq e if u > 0.0;"),
        "2:4 expected `:` and an expression behind the header of `e`"
    );
    assert_eq!(beside("eq e: complements z0;"), "2:5 expected an expression after `:`");
    assert_eq!(beside("eq e: u complements ;"), "2:9 expected a name after `complements`");
    assert_eq!(
        beside("eq e: u complements z0[];"),
        "2:23 no index stands in the brackets: write `z0` alone"
    );
}

#[test]
fn variables_have_bounds() {
    assert_eq!(
        beside("var y;"),
        "2:5 expected the bounds of `y`: `free`, `>= 0.0`, `<= 1.0` or `in 0.0..=1.0`"
    );
    assert_eq!(
        beside("var y = 0.0;"),
        "2:7 expected the bounds of `y`: `free`, `>= 0.0`, `<= 1.0` or `in 0.0..=1.0`"
    );
    assert_eq!(beside("var y >= start 1.0;"), "2:8 expected an expression after `>=`");
    assert_eq!(beside("var y >= 0.0 start ;"), "2:14 expected an expression after `start`");
    assert_eq!(beside("var y >= 0.0 if ;"), "2:14 expected an expression after `if`");
    assert_eq!(beside("var y >= 0.0 <= 1.0;"), "2:14 two bounds are written `in 0.0..=1.0`");
    assert_eq!(beside("var y in 0.0..1.0;"), "2:13 expected both bounds: `in 0.0..=1.0`");
    assert_eq!(beside("var y in 0.0;"), "2:10 expected both bounds: `in 0.0..=1.0`");
    assert_eq!(beside("var y in ..=1.0;"), "2:10 expected both bounds: `in 0.0..=1.0`");
    assert_eq!(beside("var y free if u > 0.0 start 1.0;"), "2:23 write `start` before `if`");
}

#[test]
fn headers_have_indices() {
    assert_eq!(beside("param a[];"), "2:8 no index stands in the brackets: write `a` alone");
    assert_eq!(
        beside("param a[i];"),
        "2:9 expected an index: `i in plants`, or `l @ (i, j) in lines`"
    );
    assert_eq!(
        beside("param a[i in plants,, j in markets];"),
        "2:8 expected an index: `i in plants`, or `l @ (i, j) in lines`"
    );
    assert_eq!(
        beside("param a[arcs @ i in arcs];"),
        "2:9 expected an index: `i in plants`, or `l @ (i, j) in lines`"
    );
    assert_eq!(
        beside("param a[l @ (i) in arcs];"),
        "2:9 expected an index: `i in plants`, or `l @ (i, j) in lines`"
    );
    assert_eq!(
        beside("fix x[i in, b] = 1.0;"),
        "2:7 expected an index: `i in plants`, or `l @ (i, j) in lines`"
    );
}

#[test]
fn fields_have_a_kind() {
    assert_eq!(
        beside("data { a, b: , : f64, k[]: f64, n[plants] }"),
        "2:8 expected what `a` is: `a: Set`, `a: f64`, `a[plants]: f64`\n\
2:12 expected what `b` is: `b: Set`, `b: f64`, `b[plants]: f64`\n\
2:16 expected a field: `plants: Set`, `capacity[plants]: f64`\n\
2:24 expected names with commas between them, as in `load[nodes, hours]`\n\
2:34 expected what `n` is: `n: Set`, `n: f64`, `n[plants]: f64`"
    );
    assert_eq!(
        beside(
            "data { a: Sett(b), s: set, v: Subset, w: Pairs(plants), o: Ordered[a], l: Set[], \
p: Subset(3), y: Map(plants), z: Set(a) }"
        ),
        "2:11 there is no `Sett`; did you mean `Set`?\n\
2:23 there is no `set`; did you mean `Set`?\n\
2:31 write `Subset(plants)`\n\
2:42 write `Pairs(nodes, nodes)`\n\
2:60 write `Ordered`\n\
2:78 expected names with commas between them, as in `load[nodes, hours]`\n\
2:91 expected names with commas between them, as in `load[nodes, hours]`\n\
2:99 write `Map(plants, nodes)`\n\
2:115 write `Set` or `Set[labor, capital]`"
    );
    assert_eq!(
        beside("data { t[plants]: usize, c: 1.5, v: Vec< }"),
        "2:19 a table holds numbers: write `t[…]: f64`\n\
2:29 expected a type, or a count such as `3`\n\
2:37 expected `Set`, `Ordered`, `Subset(…)`, `Pairs(…)`, `Map(…)`, a count or a \
type"
    );
    assert_eq!(
        beside("data { a: f64; b: f64 c: f64 }"),
        "2:14 expected `,` between the fields\n\
2:23 expected `,` between the fields"
    );
    assert_eq!(
        beside("data a: f64;"),
        "2:6 expected the fields: `data { plants: Set, capacity[plants]: f64 }`"
    );
}

#[test]
fn equations_have_one_relation_with_two_sides() {
    assert_eq!(beside("eq e: u >= complements z0;"), "2:9 a relation has two sides: `lhs >= rhs`");
    assert_eq!(
        beside("eq e: 0.0 <= z0 <= 1.0 complements z0;"),
        "2:17 an equation has one relation"
    );
    assert_eq!(beside("eq e: z0 = 1.0 complements z0;"), "2:10 a relation is `==`, `>=` or `<=`");
}

#[test]
fn equations_need_complements() {
    assert_eq!(
        beside("var y free; eq ey: y - u;"),
        "2:16 `ey` needs its variable: end the equation with `complements x;`"
    );
    assert_eq!(
        beside("eq ey: y.complements - u;"),
        "2:4 `ey` needs its variable: end the equation with `complements x;`"
    );
}

#[test]
fn errors_of_several_items_stand_in_the_order_of_the_text() {
    assert_eq!(
        errors(
            "model Transport {\n\
data { plants: Set, markets: Set, demand[market]: f64 }\n\
vaar w[i in plants] >= 0.0;\n\
var x[i in plants, j in markets] >= 0.0 start demand;\n\
var p[j in markets] >= 0.0\n\
eq profit[i in plants, j in markets]: p[i] - 1/2 complements x[j, i];\n\
eq supply[i in plants]: sum(markets, |j| x[i, j]) complements w[i];\n\
report total: x(i, j);\n\
var x free;\n\
eq market[j in markets]: x[j] =g= demand[j] complements q[j];\n\
}"
        ),
        "2:42 `market` is an equation, not a set; did you mean `markets`?\n\
3:1 there is no item `vaar`; did you mean `var`?\n\
4:47 `demand` is a family over `market`: write `demand[…]`\n\
5:24 expected `;`\n\
6:41 `i` is an index of `plants`, but the first index of `p` is of `markets`\n\
6:46 `1 / 2` divides integers, without the fraction: write `1.0 / 2.0`\n\
6:64 the indices of `profit` stand in its order: `i`, `j`\n\
8:15 indices stand in brackets: write `x[…]`\n\
9:5 `x` is declared twice\n\
10:26 `x` has 2 indices (`plants`, `markets`), but 1 is given\n\
10:31 write `>=` instead of `=g=`\n\
10:57 there is no variable `q`; did you mean `p`?"
    );
}

#[test]
fn only_documentation_stands_before_an_item() {
    use crate::messages::grammar::{ATTRIBUTE, MODEL_ATTRIBUTE};
    assert_eq!(
        super::model_with("#[cfg(test)] fix z0 = 1.0; data { #[allow(unused)] k: f64 }"),
        format!("2:1 {ATTRIBUTE}\n2:35 {ATTRIBUTE}")
    );
    let text = "#[cfg(test)] model M { var x free; eq e: x complements x; }";
    assert_eq!(super::model_errors(text), format!("1:1 {MODEL_ATTRIBUTE}"));
}
