//! Parts: what is read and what is answered.

use super::{model_errors, model_with};

#[test]
fn a_part_with_everything_is_read() {
    assert_eq!(
        model_with(
            "/// A tax.\n part tax requires base2 excludes other { param rate[i in plants] = 0.1; \
             data { limit: f64, w[big]: f64, n: usize } var r[i in plants] free; var k[j in n] free; \
             fix r[oslo] = 1.0; def d: limit * g; eq er[i in plants] if w.sum() > 0.0: r[i] complements r[i]; \
             eq ek[j in n]: k[j] complements k[j]; report t: d; adds ex[i, markets_index]: rate[i]; \
             adds ex[oslo, j]: d; adds ex[i in big, j]: w[i]; adds ez: d; } \
             part base2 { adds ez: 1.0; } part other { } param after;"
        ),
        ""
    );
}

#[test]
fn adds_stands_in_a_part_and_a_part_in_a_model() {
    assert_eq!(
        model_with("adds ez: 1.0;"),
        "2:1 only a part adds to what is declared: `part tax { adds profit[i]: rate[i]; }`"
    );
    assert_eq!(
        model_with("part a { part b { var y free; } }"),
        "2:10 a part has no parts: write it beside this one, with `requires`"
    );
    assert_eq!(
        model_with("part a; part b requires { }"),
        "2:6 expected the items of the part: `part a { … }`\n\
         2:25 expected a name after `requires`"
    );
    assert_eq!(
        model_with("pat a { adds ez: 1.0; }"),
        "2:1 there is no item `pat`; did you mean `part`?"
    );
}

#[test]
fn a_target_is_an_equation_or_a_definition() {
    assert_eq!(
        model_with("part a { adds eez: 1.0; }"),
        "2:15 there is no equation or definition `eez`; did you mean `ez`?"
    );
    assert_eq!(
        model_with("part a { adds balance: 1.0; }"),
        "2:15 there is no equation or definition `balance`: there are `ez`, `ex`"
    );
    assert_eq!(
        model_with("part a { adds z0: 1.0; }"),
        "2:15 `z0` is a variable: write `adds ez`, its equation"
    );
    assert_eq!(
        model_with("report r: u; part a { adds r: 1.0; adds cost[i, j]: 1.0; }"),
        "2:28 `r` is a report: write the name of an equation or a definition\n\
         2:41 `cost` is a table: write the name of an equation or a definition"
    );
}

#[test]
fn the_indices_of_a_target_are_checked() {
    assert_eq!(
        model_with("part a { adds ex[i]: 1.0; }"),
        "2:15 `ex` has 2 indices (`plants`, `markets`), but 1 is given"
    );
    assert_eq!(
        model_with("part a { adds ex[i in hours, j]: 1.0; }"),
        "2:18 `i` is an index of `hours`, but the first index of `ex` is of `plants`"
    );
    assert_eq!(
        model_with("part a { adds ex[i, j]: cost[j, i]; }"),
        "2:30 `j` is an index of `markets`, but the first index of `cost` is of `plants`\n\
         2:33 `i` is an index of `plants`, but the second index of `cost` is of `markets`"
    );
    assert_eq!(
        model_with("part a { adds ex[olso, j]: 1.0; }"),
        "2:18 there is no `olso`; did you mean `oslo`?"
    );
    assert_eq!(
        model_with("part a { adds ex[u, j]: 1.0; }"),
        "2:18 the index `u` hides a datum of this name: choose another one"
    );
}

#[test]
fn only_a_part_and_those_that_require_it_see_it() {
    let part = "part a { data { c: f64, new: Set } var y free; eq ey: y complements y; }";
    assert_eq!(
        model_with(&format!("{part} def d: c + y;")),
        "2:81 `c` exists only with the part `a`: use it there, and reach the model with `adds`\n\
         2:85 `y` exists only with the part `a`: use it there, and reach the model with `adds`"
    );
    assert_eq!(
        model_with(&format!(
            "{part} part b {{ adds ez: y; adds ey: 1.0; param s[i in new] = 1.0; }}"
        )),
        "2:92 `y` exists only with the part `a`: write `requires a` in the head of this part\n\
         2:100 `ey` exists only with the part `a`: write `requires a` in the head of this part\n\
         2:122 `new` exists only with the part `a`: write `requires a` in the head of this part"
    );
    assert_eq!(
        model_with(&format!(
            "{part} part b requires a {{ }} part c requires b {{ adds ez: y; fix y = c; }}"
        )),
        ""
    );
    assert_eq!(
        model_with(&format!("{part} fix y = 1.0;")),
        "2:78 `y` exists only with the part `a`: use it there, and reach the model with `adds`"
    );
}

#[test]
fn an_equation_pairs_with_a_variable_of_its_own_part() {
    assert_eq!(
        model_with("part a { var y free; } eq ey: z0 complements y;"),
        "2:46 `y` is of the part `a`, but `ey` is of the model without parts: both exist together \
         or not at all"
    );
    assert_eq!(
        model_with("part a { eq more if u < 0.0: z0 complements z0; }"),
        "2:45 `z0` is of the model without parts, but `more` is of the part `a`: both exist \
         together or not at all"
    );
    assert_eq!(
        model_with("part a { var y >= 0.0; eq ey: 0.0 >= y complements y; var w free; }"),
        "2:59 `w` has no equation: write `eq … complements w`, or `fix` it"
    );
    assert_eq!(
        model_with("part a { var y >= 0.0; eq ey: 0.0 <= y complements y; }"),
        "2:35 `y` has a lower bound: write `lhs <= rhs` as `rhs >= lhs`"
    );
    assert_eq!(
        model_with("part a { fix y2 = 0.0; } var y2 free;"),
        "2:30 `y2` has no equation: write `eq … complements y2`, or `fix` it"
    );
}

#[test]
fn names_are_unique_in_the_whole_model() {
    assert_eq!(
        model_with("part a { def d: u; } part b { report d: u; } part c { param x = 1.0; }"),
        "2:38 `d` is declared twice, as a definition and as a report\n\
         2:61 `x` is declared twice, as a variable and as a parameter"
    );
    assert_eq!(model_with("part a { } part a { }"), "2:17 the part `a` is declared twice");
    assert_eq!(
        model_with("part ab_c { } part abC { } part m { } part view { }"),
        "2:20 the part `abC` would make a second type `AbC`: choose another name\n\
         2:33 the part `m` would make a second type `M`: choose another name"
    );
    assert_eq!(
        model_errors(
            "model View { var z free; eq e: z complements z; part view_builder { } part a_b { } part a__b { } part __ { } \
             part view_parts { } }"
        ),
        "1:54 the part `view_builder` would make a second type `ViewBuilder`: choose another name\n\
         1:89 the part `a__b` would make a second type `AB`: choose another name\n\
         1:103 no name for a type can be made from `__`: use a name with a letter\n\
         1:115 the part `view_parts` would make a second type `ViewParts`: choose another name"
    );
}

#[test]
fn parts_require_and_exclude_parts() {
    assert_eq!(
        model_with("part contact { } part friction requires contakt excludes friction { }"),
        "2:41 there is no part `contakt`; did you mean `contact`?\n\
         2:58 `friction` excludes itself: name another part"
    );
    assert_eq!(
        model_with("part a requires u { }  part b { }"),
        "2:17 there is no part `u`: the parts are `b`"
    );
    assert_eq!(
        model_with("part a { } part b requires a { } part c requires b excludes a { }"),
        "2:61 `c` requires `a`, directly or through others, and excludes it"
    );
}

#[test]
fn data_of_a_part_are_what_can_be_given_with_it() {
    assert_eq!(
        model_with("part a { data { list: Vec<f64>, n: usize, ok: f64 } }"),
        "2:17 the data of a part are sets, tables, maps and numbers `f64`: declare `list` in the \
         data of the model\n\
         2:33 the data of a part are sets, tables, maps and numbers `f64`: declare `n` in the data \
         of the model"
    );
}

#[test]
fn what_is_added_to_a_definition_does_not_read_it() {
    assert_eq!(
        model_with(
            "def d: u; def e: d; part a { def before: u; def f: e; adds d: f + d + before; }"
        ),
        "2:63 `f` reads `d`: what is added to `d` cannot read `f`\n\
         2:67 what is added to `d` cannot read `d`"
    );
    assert_eq!(model_with("def d lifted: u; part a { def f: d; adds d: f; }"), "");
}

#[test]
fn a_model_without_parts_has_nothing_of_them() {
    let text = "model M { data { s: Set } var x[i in s] free; def d[i in s]: x[i]; \
                eq e[i in s]: d[i] complements x[i]; }";
    let expansion = |text: &str| crate::model::mcp(text.parse().unwrap()).to_string();
    let plain = expansion(text);
    assert!(!plain.contains("part") && !plain.contains("Part") && !plain.contains("added"));
    let with = expansion(&text.replace(
        "complements x[i]; }",
        "complements x[i]; part a { def w: 2.0; adds d[i]: w; adds e[i in s]: w; } }",
    ));
    // The definition that is added comes first: 0; then 1, and 2 with what is added.
    let arms = with.split("fn def <").nth(1).unwrap();
    let order = ["0usize => __def_w", "1usize => __def_d", "2usize => __added__def_d"];
    let places = order.map(|arm| arms.find(arm).unwrap_or_else(|| panic!("no `{arm}` in\n{arms}")));
    assert!(places.is_sorted());
    assert!(with.contains("struct A"));
}

#[test]
fn a_row_runs_over_its_own_terms_and_asks_no_part() {
    let text = "model M { data { s: Set } var x[i in s] free; var y free;
                eq e[i in s]: x[i] complements x[i]; eq f: y complements y;
                part a { adds e[i]: 1.0; adds f: 2.0; } part b { adds e[i]: 3.0; } }";
    let expansion = crate::model::mcp(text.parse().unwrap()).to_string();
    let function = |name: &str| {
        let rest = expansion.split(&format!("fn {name} <")).nth(1).unwrap();
        rest.split("fn ").next().unwrap().to_owned()
    };
    let several = function("__added__row_e");
    assert!(several.contains("match term . addition { 0u32 => __term_0"), "{several}");
    assert!(several.contains("2u32 => __term_2") && !several.contains("1u32"), "{several}");
    let one = function("__added__row_f");
    assert!(one.contains("value + __term_1") && !one.contains("match"), "{one}");
    assert!(!several.contains(" if ") && !one.contains(" if "), "{several}{one}");
    // Without terms a family is computed by the function of the text.
    let arms = expansion.split("fn row <").nth(1).unwrap();
    assert!(arms.contains("0usize => __row_e") && arms.contains("2usize => __added__row_e"));
}

#[test]
fn the_types_of_parts_stand_in_a_module_of_the_model() {
    let text = "pub model M { var y free; eq f: y complements y;
                part a { adds f: 2.0; } part b { data { c: f64 } adds f: c; } }";
    let expansion = crate::model::mcp(text.parse().unwrap()).to_string();
    let module = expansion.split("pub mod MParts").nth(1).unwrap();
    let (module, rest) = module.split_once("pub use MParts :: *").unwrap();
    assert!(module.contains("pub struct A ;") && module.contains("pub struct B <"));
    assert!(rest.contains("PartsOf < M > for MParts :: A"), "{rest}");
}
