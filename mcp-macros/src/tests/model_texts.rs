//! Texts of `mcp!` without errors, and texts that are hard to read.

use super::language_models::models;
use super::model_errors as errors;
use super::mutilated;
use crate::model::check;

/// Errors of a model with these items beside two variables with equations.
fn beside(items: &str) -> String {
    errors(&format!(
        "model M {{ data {{ s: Set, hours: Ordered, c[s]: f64, u: f64 }} {items} \
         var x >= 0.0; eq ex: x complements x; }}"
    ))
}

#[test]
fn the_four_models_have_no_errors() {
    for model in models() {
        assert_eq!(check(model).map_err(|errors| errors.lines()), Ok(()));
    }
}

#[test]
fn all_forms_of_items_have_no_errors() {
    for items in [
        "",
        ";;",
        "data {} data { k: u32, m: std::collections::HashMap<String, f64>, } ",
        "data { /// count\n n: usize, v: Vec<f64>, f: fn(f64, f64) -> f64 } var y[i in n] free; \
         eq ey[i in n]: y[i] - v[0] complements y[i];",
        "param a; param b[i in s]; param d = 1.0; param e[i in s] = c[i];",
        "var a <= 1.0 start 0.5; eq ea: 1.0 <= u complements a;",
        "var a in -1.0..=1.0; eq ea: a complements a;",
        "var y[i in s] free; fix y[i in s] = c[i];",
        "def d[i in s] lifted: c[i] * x; report r[i in s,]: d[i] / u;",
        "#[doc = \"a\"] /// b\n param a;",
        "var y[t in hours] free; eq first: u complements y[hours.first()]; \
         eq last: u complements y[hours.last()];",
        "var y[t in hours] free; eq ey[t in hours] if t != hours.first(): y[t] complements y[t];",
    ] {
        assert_eq!(beside(items), "", "{items}");
    }
}

#[test]
fn an_if_that_begins_an_operand_is_no_condition() {
    for items in [
        "var y >= if u > 1.0 { 0.0 } else if u > 0.0 { 1.0 } else { 2.0 } start 1.0; \
         eq ey: y complements y;",
        "var y >= 1.0 + if u > 1.0 { 0.0 } else { 1.0 } start if u > 0.0 { 1.0 } else { 2.0 } \
         if u > 3.0; eq ey: y complements y;",
        "var y in if u > 1.0 { 0.0 } else { 1.0 }..=match u { _ => 2.0 } if u > 1.0; \
         eq ey: y complements y;",
        "var y free if u > 1.0; eq ey: y complements y;",
        "var y >= u.start if u.is_finite(); eq ey: y complements y;",
    ] {
        assert_eq!(beside(items), "", "{items}");
    }
}

#[test]
fn only_a_relation_of_the_equation_is_one() {
    for body in [
        "if u >= 1.0 { x } else if u == 2.0 { y } else { u }",
        "match u == 1.0 { true => x, false => y }",
        "when(u >= 1.0, || x)",
        "{ let b = u >= 1.0; if b { x } else { y } }",
        "y.map(u).max(x) - f::<f64>(u)",
    ] {
        let items = format!("var y in 0.0..=1.0; eq ey: {body} complements y;");
        assert_eq!(beside(&items), "", "{body}");
    }
    for body in ["if u >= 1.0 { x } else { y } == u", "a || b == u", "y == |v| v >= u"] {
        let items = format!("var y free; eq ey: {body} complements y;");
        assert_eq!(beside(&items), "", "{body}");
    }
}

#[test]
fn names_that_are_words_of_the_language_can_be_variables() {
    for name in ["eq", "var", "data", "fix", "param", "f", "k", "z", "D", "tail"] {
        let items = format!("var {name} free; eq e1: x - {name} complements {name};");
        assert_eq!(beside(&items), "", "{name}");
    }
}

#[test]
fn no_text_makes_the_macro_panic() {
    let text = "/// a\n pub(crate) model M { \
        data { s: Set[a, b], h: Ordered, p: Pairs(s, s), m: Map(h, s), k: 3, t[s, h]: f64 } \
        param q[i in s] = 1.0; var x[i in s, j in h] in -1.0..=t[i, j] start 0.0 if t[i, j] > 0.0; \
        fix x[a, j in h] = 1.0; def d[l @ (i, j) in p] lifted: sum(h, |v| x[i, v] - x[j, v - 1]); \
        eq e[i in s, j in h] if t[i, j] >= 0.0: x[i, j] >= q[i] ** 2 + when(true, || x[m[j], j]) \
        complements x[i, j]; report r: sum(i, x.l); }";
    let text = text.parse().unwrap();
    for mutilated in mutilated(&text) {
        let _ = check(mutilated);
    }
}
