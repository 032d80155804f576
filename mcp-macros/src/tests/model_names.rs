//! Messages about names and sets of `mcp!` at their places.

use super::model_with as beside;

#[test]
fn names_are_declared_once() {
    assert_eq!(beside("param u;"), "2:7 `u` is declared twice, as a datum and as a parameter");
    assert_eq!(beside("data { b: f64, plants: Set }"), "2:16 `plants` is declared twice");
    assert_eq!(
        beside("def x: u; report ex: u;"),
        "2:5 `x` is declared twice, as a variable and as a definition\n\
2:18 `ex` is declared twice, as an equation and as a report"
    );
    assert_eq!(
        beside("eq q: u complements z0;"),
        "2:4 `q` is declared twice, as a parameter and as an equation"
    );
}

#[test]
fn words_of_the_language_are_no_names() {
    assert_eq!(
        beside("param sum; param complements;"),
        "2:7 `sum` is a word of the language: choose another name\n\
2:18 `complements` is a word of the language: choose another name"
    );
    assert_eq!(
        beside("param p[max in plants];"),
        "2:9 `max` is a word of the language: choose another name"
    );
}

#[test]
fn indices_hide_nothing() {
    assert_eq!(
        beside("param p[u in plants];"),
        "2:9 the index `u` hides a datum of this name: choose another one"
    );
    assert_eq!(
        beside("param p[i in plants, i in markets];"),
        "2:22 the index `i` stands twice in the header"
    );
    assert_eq!(
        beside("param p[l @ (l, x) in arcs];"),
        "2:14 the index `l` stands twice in the header\n\
2:17 the index `x` hides a variable of this name: choose another one"
    );
}

#[test]
fn closures_and_lets_hide_nothing() {
    assert_eq!(
        beside("def d: sum(plants, |x| u);"),
        "2:21 `x` hides a variable of this name: choose another one"
    );
    assert_eq!(
        beside("def d: { let (q, mut y): (f64, f64) = (1.0, 2.0); for cost in 0..3 {} y };"),
        "2:15 `q` hides a parameter of this name: choose another one\n\
2:55 `cost` hides a table of this name: choose another one"
    );
    assert_eq!(
        beside("def d: sum(plants, |site| u) + { let ex = 1.0; ex };"),
        "2:21 `site` hides a map of this name: choose another one"
    );
}

#[test]
fn sets_are_declared() {
    assert_eq!(
        beside("data { t[plantz]: f64, m: Map(u, hourz), b: Subset(nothing) }"),
        "2:10 there is no set `plantz`; did you mean `plants`?\n\
2:31 `u` is a datum, not a set\n\
2:34 there is no set `hourz`; did you mean `hours`?\n\
2:52 there is no set `nothing`: declare it in `data`"
    );
    assert_eq!(
        beside("param p[i in market, j in cost];"),
        "2:14 there is no set `market`; did you mean `markets`?\n\
2:27 `cost` is a table, not a set"
    );
    assert_eq!(beside("report r[i in site]: u;"), "2:15 `site` is a map, not a set");
    assert_eq!(
        beside("def d: sum(marketz, |j| u);"),
        "2:12 there is no `marketz`; did you mean `markets`?"
    );
    assert_eq!(
        beside("data { k1: Subset(k2), k2: Subset(k1) }"),
        "2:8 `k1` is made of itself\n\
2:24 `k2` is made of itself"
    );
}

#[test]
fn only_pairs_have_ends() {
    assert_eq!(
        beside("param p[l @ (i, j) in plants];"),
        "2:14 the elements of `plants` have no ends: write `l in plants`"
    );
}

#[test]
fn nothing_follows_from_an_item_that_could_not_be_read() {
    assert_eq!(
        beside("var y[k on plants] free; eq ey[k in plants]: y[k, 1] complements y[k];"),
        "2:7 expected an index: `i in plants`, or `l @ (i, j) in lines`"
    );
    assert_eq!(beside("data { big2: Subset } param p[i in big2];"), "2:14 write `Subset(plants)`");
    assert_eq!(
        beside("vaar y free; eq ey: y complements y;"),
        "2:1 there is no item `vaar`; did you mean `var`?"
    );
    assert_eq!(
        beside("var y[k in plantz] free; eq ey[k in plantz]: y[k] complements y[k];"),
        "2:12 there is no set `plantz`; did you mean `plants`?\n\
2:37 there is no set `plantz`; did you mean `plants`?"
    );
}

#[test]
fn sets_are_not_made_of_each_other() {
    assert_eq!(
        beside("data { a: Pairs(a, plants), b: Pairs(c, plants), c: Subset(b) }"),
        "2:8 `a` is made of itself\n2:29 `b` is made of itself\n2:50 `c` is made of itself"
    );
}

#[test]
fn names_of_generated_code_are_reserved() {
    assert_eq!(
        beside("data { build: f64, __shape: f64 }"),
        "2:8 `build` is a word of the language: choose another name\n\
2:20 `__shape` is a word of the language: choose another name"
    );
    assert_eq!(
        beside("param ok[ex in plants] = 1.0;"),
        "",
        "an index may be called like an equation"
    );
}

#[test]
fn families_have_at_most_six_indices() {
    let seven =
        "a in plants, b in plants, c in plants, d in plants, e in plants, f in plants, k in plants";
    assert_eq!(
        beside(&format!("param p[{seven}] = 1.0;")),
        "2:87 a family has at most six indices"
    );
    let sets = ["plants"; 7].join(", ");
    assert_eq!(
        beside(&format!("data {{ t[{sets}]: f64 }}")),
        "2:58 a family has at most six indices"
    );
}
