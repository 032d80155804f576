//! Messages for those who come from GAMS at their places.

use super::model_with as beside;

#[test]
fn items_of_gams_are_answered_with_those_of_the_language() {
    assert_eq!(
        beside("Sets i, j; Parameters a, b;"),
        "2:1 there is no item `Sets`: write `data { plants: Set }`\n\
2:12 there is no item `Parameters`: write `data { demand[markets]: f64 }`"
    );
    assert_eq!(
        beside("Scalar f0; Table d(i, j); Variables y, v;"),
        "2:1 there is no item `Scalar`: write `data { demand[markets]: f64 }`\n\
2:12 there is no item `Table`: write `data { demand[markets]: f64 }`\n\
2:27 there is no item `Variables`: write `var x free;`"
    );
    assert_eq!(
        beside("positive variable y; Negative Variables v; free variable w;"),
        "2:1 there is no item `positive`: write `var x >= 0.0;`\n\
2:22 there is no item `Negative`: write `var x <= 0.0;`\n\
2:44 there is no item `free`: write `var x free;`"
    );
    assert_eq!(
        beside("Equations supply, demand;"),
        "2:1 there is no item `Equations`: write `eq balance: … complements x;`"
    );
}

#[test]
fn relations_of_gams() {
    assert_eq!(beside("eq e: z0 =e= 1.0 complements z0;"), "2:10 write `==` instead of `=e=`");
    assert_eq!(
        beside("eq e: z0 =G= 1.0 complements z0;"),
        "2:10 write `>=` instead of `=g=`\n\
2:10 `z0` is free, its equation holds with equality: write `lhs == rhs`"
    );
    assert_eq!(
        beside("eq e: z0 =l= 1.0 complements z0;"),
        "2:10 write `<=` instead of `=l=`\n\
2:10 `z0` is free, its equation holds with equality: write `lhs == rhs`"
    );
}

#[test]
fn headers_of_gams() {
    assert_eq!(beside("eq e.. z0 complements z0;"), "2:5 write `:` instead of `..`");
    assert_eq!(
        beside("eq e[j in markets].. u complements x[oslo, j];"),
        "2:19 write `:` instead of `..`"
    );
    assert_eq!(beside("def d.. u;"), "2:6 write `:` instead of `..`");
    assert_eq!(beside("var y(i) free;"), "2:6 indices stand in brackets: write `y[i in plants]`");
    assert_eq!(
        beside("eq e(j).. u complements x(j);"),
        "2:5 indices stand in brackets: write `e[i in plants]`"
    );
    assert_eq!(
        beside("eq e$(u > 0.0): u complements z0;"),
        "2:5 write `if condition` instead of `$`"
    );
    assert_eq!(
        beside("eq e[j in markets]$(u > 0.0): u complements x[oslo, j];"),
        "2:19 write `if condition` instead of `$`"
    );
    assert_eq!(beside("fix x(i, j) = 1.0;"), "2:6 indices stand in brackets: write `x[…]`");
    assert_eq!(
        beside("eq e[j in markets]: u complements x(a, j);"),
        "2:36 indices stand in brackets: write `x[…]`"
    );
}

#[test]
fn conditions_and_powers_of_gams() {
    assert_eq!(
        beside("report r: u$(u > 0.0) + z0;"),
        "2:12 write `when(condition, || …)` instead of `$`"
    );
    assert_eq!(
        beside("report r: z0 ** 2 + u ^ 2;"),
        "2:14 write `.pow(…)` instead of `**`\n\
2:23 write `.pow(…)` instead of `^`"
    );
}

#[test]
fn families_of_gams() {
    assert_eq!(
        beside("report r: x(i, j) + q(i) + cost(i, j);"),
        "2:11 indices stand in brackets: write `x[…]`\n\
2:21 indices stand in brackets: write `q[…]`\n\
2:28 indices stand in brackets: write `cost[…]`"
    );
}

#[test]
fn sums_of_gams() {
    assert_eq!(beside("report r[i in plants]: sum(i, q[i]);"), "2:24 write `sum(plants, |i| …)`");
    assert_eq!(beside("report r: sum((i, j), x[i, j]);"), "2:11 write `sum(set, |i| …)`");
    assert_eq!(
        beside("report r: sum(j, u) + sum(plants) + prod(plants, u);"),
        "2:11 write `sum(set, |j| …)`\n\
2:23 write `sum(plants, |i| …)`\n\
2:37 write `prod(plants, |i| …)`"
    );
    assert_eq!(beside("report r: sum(i in plants, q[i]);"), "2:11 write `sum(plants, |i| …)`");
    assert_eq!(
        beside("report r[i in plants]: sum(i, |i| q[i]);"),
        "2:24 write `sum(plants, |i| …)`"
    );
    assert_eq!(
        beside("report r: sum(plants, f64::from) + sum(0..3, |k| u) + sum(plants, helper);"),
        ""
    );
}

#[test]
fn attributes_of_gams() {
    assert_eq!(
        beside("report r: z0.l + x.lo[oslo, j0] + z0.up + z0.fx;"),
        "2:11 there is no `.l`: give the start in the declaration: `var z0 … start 1.0;`\n\
2:18 there is no `.lo`: write the bounds in the declaration: `var x in \
0.0..=1.0;`\n\
2:35 there is no `.up`: write the bounds in the declaration: `var z0 in \
0.0..=1.0;`\n\
2:43 there is no `.fx`: write `fix z0 = 1.0;`"
    );
}

#[test]
fn relations_of_gams_are_those_of_the_language_otherwise() {
    assert_eq!(
        beside("eq e[j in markets]: u =l= 1.0 complements x[oslo, j];"),
        "2:23 write `<=` instead of `=l=`\n\
2:23 `x` has a lower bound: write `lhs <= rhs` as `rhs >= lhs`"
    );
    assert_eq!(
        beside("eq e: u =e= 1.0 == z0 complements z0;"),
        "2:9 write `==` instead of `=e=`\n\
2:9 an equation has one relation\n\
2:10 `e` is an equation, which has no value: write a `def`"
    );
}
