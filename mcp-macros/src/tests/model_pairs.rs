//! Messages about equations and their variables at their places.

use super::model_with as beside;

#[test]
fn every_variable_has_an_equation() {
    assert_eq!(
        beside("var y free;"),
        "2:5 `y` has no equation: write `eq … complements y`, or `fix` it"
    );
    assert_eq!(
        beside("var y[i in plants] free; fix y[oslo] = 1.0;"),
        "2:5 `y` has no equation: write `eq … complements y`, or `fix` it"
    );
    assert_eq!(
        beside("var y[i in plants] free; fix y[i in big] = 1.0;"),
        "2:5 `y` has no equation: write `eq … complements y`, or `fix` it"
    );
}

#[test]
fn a_variable_has_one_equation_over_everything() {
    assert_eq!(
        beside("eq e[i in plants, j in markets]: u complements x[i, j];"),
        "2:48 `x` is already complementary to `ex`"
    );
    assert_eq!(
        beside("eq e: u complements z0; eq f: u complements z0;"),
        "2:45 `z0` is already complementary to `e`"
    );
    assert_eq!(beside("eq e if u > 0.0: u complements z0; eq f: u complements z0;"), "");
}

#[test]
fn equations_may_share_a_variable() {
    assert_eq!(beside("eq e[j in markets]: u complements x[oslo, j];"), "");
    assert_eq!(beside("eq e[i in big, j in markets]: u complements x[i, j];"), "");
    assert_eq!(
        beside("eq e[i in plants, j in markets] if cost[i, j] > u: u complements x[i, j];"),
        ""
    );
}

#[test]
fn pairs_and_fixes_name_variables() {
    assert_eq!(
        beside("eq e: u complements zz0;"),
        "2:21 there is no variable `zz0`; did you mean `z0`?"
    );
    assert_eq!(
        beside("eq e: u complements something;"),
        "2:21 there is no variable `something`: the variables are `z0`, `x`"
    );
    assert_eq!(
        beside("eq e: u complements q;"),
        "2:21 `q` is a parameter: the variables are `z0`, `x`"
    );
    assert_eq!(
        beside("eq e: u complements e;"),
        "2:21 `e` is an equation: the variables are `z0`, `x`"
    );
    assert_eq!(
        beside("fix z1 = 1.0; fix u = 1.0;"),
        "2:5 there is no variable `z1`; did you mean `z0`?\n\
2:19 `u` is a datum: the variables are `z0`, `x`"
    );
    assert_eq!(
        beside("var y free; eq e: u complements yy;"),
        "2:33 there is no variable `yy`; did you mean `y`?"
    );
}

#[test]
fn pairs_have_as_many_indices_as_the_variable() {
    assert_eq!(
        beside("eq e[i in plants]: u complements x[i];"),
        "2:37 `x` has 2 indices (`plants`, `markets`), but 1 is given"
    );
    assert_eq!(
        beside("eq e[i in plants]: u complements x;"),
        "2:34 `x` has 2 indices (`plants`, `markets`), but 0 are given"
    );
    assert_eq!(
        beside("eq e[i in plants]: u complements z0[i];"),
        "2:38 `z0` has no index, but 1 is given"
    );
    assert_eq!(
        beside("fix x[oslo] = 1.0;"),
        "2:5 `x` has 2 indices (`plants`, `markets`), but 1 is given"
    );
}

#[test]
fn pairs_have_the_indices_of_the_equation() {
    assert_eq!(
        beside("eq e[i in plants, j in markets]: u complements x[j, i];"),
        "2:50 the indices of `e` stand in its order: `i`, `j`"
    );
    assert_eq!(
        beside("eq e[i in plants, j in markets]: u complements x[i, i];"),
        "2:53 `i` is an index of `plants`, but the second index of `x` is of `markets`"
    );
    assert_eq!(
        beside("eq e[i in plants, j in markets]: u complements x[oslo, j];"),
        "2:57 the index `i` of `e` is missing"
    );
    assert_eq!(
        beside("eq e[i in plants]: u complements x[i, k];"),
        "2:39 `k` is neither an index of `e` nor a label of `markets`"
    );
    assert_eq!(
        beside("eq e[j in markets]: u complements x[olso, j];"),
        "2:37 `olso` is neither an index of `e` nor a label of `plants`; did you mean \
`oslo`?"
    );
    assert_eq!(
        beside("eq e[k in hours, j in markets]: u complements x[k, j];"),
        "2:49 `k` is an index of `hours`, but the first index of `x` is of `plants`"
    );
    assert_eq!(
        beside("eq e[i in plants]: u complements x[i, oslo];"),
        "2:39 `oslo` is a label of `plants`, but the second index of `x` is of `markets`"
    );
    assert_eq!(
        beside("eq e[j in markets]: u complements x[plants.first(), j];"),
        "2:37 `plants` has no order: declare it `plants: Ordered`"
    );
    assert_eq!(
        beside("eq e[i in plants]: u complements x[i, hours.last()];"),
        "2:39 `hours.last()` is an index of `hours`, but the second index of `x` is of \
`markets`"
    );
    assert_eq!(
        beside("eq e[l @ (i, j) in arcs]: u complements x[i, j];"),
        "2:43 `i` is an end of `l`: write `l`\n\
2:46 `j` is an end of `l`: write `l`"
    );
    assert_eq!(
        beside("eq e[i in plants]: u complements x[i, \"oslo\"];"),
        "2:39 `\"oslo\"` is neither an index of `e` nor a label of `markets`"
    );
    assert_eq!(
        beside("eq e[j in markets]: u complements x[site[oslo], j];"),
        "2:37 `site[oslo]` is neither an index of `e` nor a label of `plants`"
    );
}

#[test]
fn fixes_pick_elements_of_the_variable() {
    assert_eq!(
        beside("fix x[i, j in markets] = 1.0;"),
        "2:7 `i` is no label of `plants` in the text: for every element write `i in \
plants`"
    );
    assert_eq!(
        beside("fix x[oslo, k in hours] = 1.0;"),
        "2:13 `k` is an index of `hours`, but the second index of `x` is of `markets`"
    );
    assert_eq!(
        beside("fix x[j in markets, oslo] = 1.0;"),
        "2:7 `j` is an index of `markets`, but the first index of `x` is of `plants`\n\
2:21 `oslo` is a label of `plants`, but the second index of `x` is of `markets`"
    );
}

#[test]
fn relations_agree_with_bounds() {
    assert_eq!(
        beside("eq e[j in markets]: cost[oslo, j] <= u complements x[oslo, j];"),
        "2:35 `x` has a lower bound: write `lhs <= rhs` as `rhs >= lhs`"
    );
    assert_eq!(
        beside("eq e[j in markets]: cost[oslo, j] == u complements x[oslo, j];"),
        "2:35 `x` has a lower bound: write `lhs >= rhs`, or declare it `free`"
    );
    assert_eq!(
        beside("eq e: u >= z0 complements z0;"),
        "2:9 `z0` is free, its equation holds with equality: write `lhs == rhs`"
    );
    assert_eq!(
        beside("eq e: u <= z0 complements z0;"),
        "2:9 `z0` is free, its equation holds with equality: write `lhs == rhs`"
    );
    assert_eq!(
        beside("var y <= 1.0; eq e: u >= y complements y;"),
        "2:23 `y` has an upper bound: write `lhs >= rhs` as `rhs <= lhs`"
    );
    assert_eq!(
        beside("var y <= 1.0; eq e: u == y complements y;"),
        "2:23 `y` has an upper bound: write `lhs <= rhs`, or declare it `free`"
    );
    assert_eq!(
        beside("var y in 0.0..=1.0; eq e: u >= y complements y;"),
        "2:29 `y` has two bounds: write one expression, `lhs - rhs`"
    );
    assert_eq!(
        beside(
            "var y >= 0.0; eq e: u >= y complements y; var v <= 0.0; eq f: u <= v complements \
v; eq g0: u == z0 complements z0;"
        ),
        ""
    );
}

#[test]
fn a_wrong_pair_leaves_other_variables_alone() {
    assert_eq!(
        beside("var y free; var v free; eq ey: y complements yy; eq ev: v complements w;"),
        "2:46 there is no variable `yy`; did you mean `y`?\n\
2:71 there is no variable `w`; did you mean `v`?"
    );
    assert_eq!(
        beside("var y[i in plants] free; eq ey[i in plants]: y[i] complements y[i, i];"),
        "2:69 `y` has 1 index (`plants`), but 2 are given"
    );
    assert_eq!(
        beside("var y free; var v free; eq ey: y = complements y;"),
        "2:17 `v` has no equation: write `eq … complements v`, or `fix` it\n\
2:34 a relation is `==`, `>=` or `<=`"
    );
}

#[test]
fn a_diagonal_is_a_pair_of_its_own() {
    assert_eq!(
        beside(
            "var y[i in plants, j in plants] free; \
             eq off[i in plants, j in plants] if u > 0.0: u complements y[i, j]; \
             eq on[i in plants]: y[i, i] - 1.0 complements y[i, i];"
        ),
        ""
    );
}
