//! Messages about what expressions read at their places.

use super::model_with as beside;

#[test]
fn indices_are_of_the_sets_of_the_family() {
    assert_eq!(
        beside("report r[i in plants, j in markets]: x[j, i];"),
        "2:40 `j` is an index of `markets`, but the first index of `x` is of `plants`\n\
2:43 `i` is an index of `plants`, but the second index of `x` is of `markets`"
    );
    assert_eq!(
        beside("report r[k in hours, b2 in big]: x[b2, k] + q[b2];"),
        "2:40 `k` is an index of `hours`, but the second index of `x` is of `markets`"
    );
    assert_eq!(
        beside("report r[l @ (i, j) in arcs]: x[i, j] + x[j, i];"),
        "2:43 `j` is an index of `markets`, but the first index of `x` is of `plants`\n\
2:46 `i` is an index of `plants`, but the second index of `x` is of `markets`"
    );
    assert_eq!(
        beside("data { h[big]: f64 } report r[i in plants]: h[i];"),
        "2:47 `i` is an index of `plants`, but the first index of `h` is of `big`"
    );
    assert_eq!(
        beside("report r[j in markets]: x[j, oslo] + q[oslo] + sum(plants, |j| q[j]);"),
        "2:27 `j` is an index of `markets`, but the first index of `x` is of `plants`\n\
2:30 `oslo` is a label of `plants`, but the second index of `x` is of `markets`"
    );
    assert_eq!(
        beside("report r[j in markets]: q[site[j]];"),
        "2:32 `j` is an index of `markets`, but the first index of `site` is of `plants`"
    );
    assert_eq!(
        beside(
            "data { w[markets, markets, markets, plants]: f64 } report r[i in plants, j in \
markets]: w[j, j, i, j];"
        ),
        "2:97 `i` is an index of `plants`, but the third index of `w` is of `markets`\n\
2:100 `j` is an index of `markets`, but the 4th index of `w` is of `plants`"
    );
}

#[test]
fn families_are_read_with_all_their_indices() {
    assert_eq!(
        beside("report r[i in plants]: x[i];"),
        "2:24 `x` has 2 indices (`plants`, `markets`), but 1 is given"
    );
    assert_eq!(
        beside("report r: g[oslo] + z0[oslo] + u[oslo];"),
        "2:11 `g` has no index: write `g` alone\n\
2:21 `z0` has no index: write `z0` alone\n\
2:32 `u` has no index: write `u` alone"
    );
    assert_eq!(
        beside("report r: x + cost.sum() + site;"),
        "2:11 `x` is a family over `plants`, `markets`: write `x[…]`\n\
2:28 `site` is a family over `plants`: write `site[…]`"
    );
    assert_eq!(
        beside("report r[i in plants, j in markets]: cosst[i, j];"),
        "2:38 there is no `cosst`; did you mean `cost`?"
    );
    assert_eq!(
        beside("report r[i in plants, j in markets]: nothing[i, j];"),
        "2:38 there is no `nothing`: declare it in `data`, or with `var` or `def`"
    );
}

#[test]
fn bounds_and_conditions_are_data() {
    assert_eq!(
        beside("var y >= z0 start q[oslo] if g > 0.0; eq ey: y complements y;"),
        "2:10 a bound is data, but `z0` is a variable\n\
2:19 a start is data, but `q` is a parameter: write `q.base(oslo)`\n\
2:30 a condition is data, but `g` is a parameter: write `g.base()`"
    );
    assert_eq!(
        beside(
            "var y in g..=x[oslo, j0].abs() start g.base() + q.base(oslo); eq ey: y \
complements y;"
        ),
        "2:10 a bound is data, but `g` is a parameter: write `g.base()`\n\
2:14 a bound is data, but `x` is a variable"
    );
    assert_eq!(
        beside("param p = g; fix z0 = q[oslo]; fix x[oslo, j in markets] = z0;"),
        "2:11 the value of a parameter is data, but `g` is a parameter: write `g.base()`\n\
2:23 the value of a `fix` is data, but `q` is a parameter: write `q.base(oslo)`\n\
2:60 the value of a `fix` is data, but `z0` is a variable"
    );
    assert_eq!(
        beside("def d: u; eq ey if d > g: u complements z0;"),
        "2:20 a condition is data, but `d` is a definition\n\
2:24 a condition is data, but `g` is a parameter: write `g.base()`"
    );
}

#[test]
fn definitions_read_earlier_ones() {
    assert_eq!(
        beside("def d1: d2 + 1.0; def d2: d1 + d2;"),
        "2:9 `d2` is declared later: write it before `d1`\n\
2:32 `d2` reads itself: write a `var` with an `eq`"
    );
    assert_eq!(
        beside("report r: u; def d: r + ex; report t: r; eq e: r complements z0;"),
        "2:21 `r` is a report, made after the solve: nothing can read it\n\
2:25 `ex` is an equation, which has no value: write a `def`\n\
2:39 `r` is a report, made after the solve: nothing can read it\n\
2:48 `r` is a report, made after the solve: nothing can read it"
    );
}

#[test]
fn steps_of_an_index_stay_in_its_set() {
    assert_eq!(
        beside(
            "var s[i in plants, t in hours] free; eq es[i in plants, t in hours]: s[i, t - 1] \
+ sum(hours, |h| s[i, h + 2]) complements s[i, t];"
        ),
        "2:75 `t - 1` may leave `hours`: write `s.at(i, t - 1).or(…)`, or `hours.wrap(t, \
-1)`\n\
2:104 `h + 2` may leave `hours`: write `s.at(i, h + 2).or(…)`, or `hours.wrap(h, \
2)`"
    );
    assert_eq!(
        beside("report r[i in plants]: q[i - 1];"),
        "2:26 `plants` has no order for `i - 1`: declare it `plants: Ordered`"
    );
    assert_eq!(
        beside("data { n: 4 } var v[k in n] free; eq ev[k in n]: v[k + 1] complements v[k];"),
        "2:52 `k + 1` may leave `n`: write `v.at(k + 1).or(…)`, or `n.wrap(k, 1)`"
    );
}

#[test]
fn names_of_closures_are_their_own() {
    assert_eq!(
        beside("report r[j in markets]: sum(plants,|j|q[j] * 2.0) + when(u > 1.0,||u) + q[j];"),
        "2:75 `j` is an index of `markets`, but the first index of `q` is of `plants`"
    );
    assert_eq!(
        beside(
            "report r[j in markets]: { let j = oslo; q[j] } + if u > 1.0 || u < 0.0 { **v } \
else { q[j] };"
        ),
        "2:89 `j` is an index of `markets`, but the first index of `q` is of `plants`"
    );
}

#[test]
fn divisions_of_integers_are_shown() {
    assert_eq!(
        beside("report r: 1/2 * z0;"),
        "2:11 `1 / 2` divides integers, without the fraction: write `1.0 / 2.0`"
    );
}

#[test]
fn functions_and_data_of_any_type_are_left_to_the_compiler() {
    assert_eq!(
        beside(
            "data { v: Vec<f64>, n: usize } report r[i in plants]: v[0] + helper(v[n - 1]) + \
q[i].max(g.abs()) + cost.sum();"
        ),
        ""
    );
    assert_eq!(
        beside(
            "report r: { let f = |a: f64| -> f64 { a * u }; f(z0) + Pair { x: 1.0 }.x + \
path::x(1.0) + format!(\"{}\", u).len() as f64 };"
        ),
        ""
    );
}

#[test]
fn a_misspelt_name_gets_the_nearest_one() {
    assert_eq!(
        beside("def d[i in plants, j in markets]: csot[i, j];"),
        "2:35 there is no `csot`; did you mean `cost`?"
    );
    assert_eq!(beside("def d: sum(hours, |t| sight[t]);"), "");
    assert_eq!(
        beside("def d[i in plants]: sitte[i].position() as f64 + z00;"),
        "2:21 there is no `sitte`; did you mean `site`?\n\
2:50 there is no `z00`; did you mean `z0`?"
    );
    // Locals, items and functions of the surrounding program are no misspelt names.
    for text in [
        "{ let sites = 1.0; sites }",
        "match f(u) { Some(sites) => sites, _ => { 0.0 } }",
        "match f(u) { Some(sites) if sites > 1.0 => { sites } None => 0.0 }",
        "if let Some(sites) = f(u) { sites } else { 0.0 }",
        "COST + sites(u) + cosst::f(u) + u.sites",
        "[1.0].iter().map(|costs| costs).sum()",
    ] {
        assert_eq!(beside(&format!("def d: {text};")), "", "{text}");
    }
}

#[test]
fn only_ordered_sets_have_neighbours() {
    assert_eq!(
        beside("def d[i in plants, j in markets]: x.at(i - 1, j).or(0.0);"),
        "2:40 `plants` has no order for `i - 1`: declare it `plants: Ordered`"
    );
}

#[test]
fn a_branch_cannot_depend_on_a_variable() {
    let told = |name: &str, noun: &str| {
        format!(
            "a condition is data, but `{name}` is {noun}: a branch would be hidden from the \
             derivatives; use `max`, `min`, `clamp` or `select`"
        )
    };
    assert_eq!(
        beside("def d: if z0 > 1.0 { z0 } else if (u + g) > 0.0 { g } else { 0.0 };"),
        format!("2:11 {}\n2:40 {}", told("z0", "a variable"), told("g", "a parameter"))
    );
    assert_eq!(beside("def d: if g.base() > u && true { z0 } else { g };"), "");
    assert_eq!(beside("def d: if let Some(v) = f(z0) { v } else { g };"), "");
}

#[test]
fn a_parameter_is_computed_from_earlier_ones() {
    assert_eq!(beside("param a = g.base(); param b[i in plants] = a.base() * q.base(i);"), "");
    assert_eq!(
        beside("param a = 2.0 * b.base(); param b = 1.0;"),
        "2:17 `b` is declared later: write it before `a`"
    );
    assert_eq!(
        beside("param a = a.base();"),
        format!("2:11 {}", crate::messages::reading::parameter_itself("a"))
    );
}

#[test]
fn an_expression_is_not_left_before_its_end() {
    let told = |word| crate::messages::reading::leaves(word);
    assert_eq!(
        beside("def d: { if u > 1.0 { return 3.0; } z0 };"),
        format!("2:23 {}", told("return"))
    );
    assert_eq!(
        beside("param w[i in plants] = { if u > 1.0 { continue; } f(u)? };"),
        format!("2:39 {}\n2:55 {}", told("continue"), told("?"))
    );
    for fine in [
        "[1.0].iter().map(|v| { if *v > 1.0 { return 2.0; } *v }).sum::<f64>() * z0",
        "{ let mut s = z0; for k in 0..3 { if k == 1 { continue; } s += z0; } s }",
        "'a: { if u > 1.0 { break 'a z0; } g }",
        "{ let ok = f(|v| Some(v?)); z0 }",
    ] {
        assert_eq!(beside(&format!("def d: {fine};")), "", "{fine}");
    }
}

#[test]
fn names_an_expression_gives_itself_are_known() {
    for fine in [
        "{ let Option { price: csot, .. } = o; z0 - csot }",
        "{ let csot = 2.0; let m = Map::<u8, u8>::new(); z0 - csot }",
        "match k { Kind::C { rate: sitte } => z0 * sitte, Kind::D { sitte } => sitte }",
        "sum(plants, function.clone()) + sum(plants, &function) + sum(plants, { |i| g })",
    ] {
        assert_eq!(beside(&format!("def d: {fine};")), "", "{fine}");
    }
    assert_eq!(
        beside("def d: { const z0: f64 = 3.0; z0 };"),
        "2:16 `z0` hides a variable of this name: choose another one"
    );
}

#[test]
fn a_number_that_is_summed_over_is_a_set() {
    assert_eq!(beside("data { n: usize } def d: sum(n, |k| k.position() as f64) / n as f64;"), "");
    assert_eq!(
        beside("data { start: f64 } var w >= start start start; eq ew: w complements w;"),
        ""
    );
}

#[test]
fn a_family_is_read_element_by_element() {
    assert_eq!(
        beside("def d: q.values().len() as f64 + x.count() as f64;"),
        format!(
            "2:10 {}\n2:36 {}",
            crate::messages::reading::method("q", "values"),
            crate::messages::reading::method("x", "count")
        )
    );
    assert_eq!(beside("def d: cost.sum() * cost.values()[0] * z0;"), "");
}

#[test]
fn a_neighbour_that_does_not_exist_needs_a_stand_in() {
    assert_eq!(
        beside("var s[t in hours] free; eq es[t in hours]: s.at(t - 1) - s[t] complements s[t];"),
        format!("2:46 {}", crate::messages::reading::or_missing("s"))
    );
}
