//! What `mcp!` generates: reads, spans, and stubs where the model has errors.

use proc_macro2::{TokenStream, TokenTree};
use std::collections::HashMap;

const MODEL: &str = "model Trade {
    data { plants: Set, hours: Ordered, kinds: Set[old, new], big: Subset(plants), site: Map(plants, plants),
           n: 3, cost[plants, hours]: f64, rate: f64, notes: Vec<f64> }
    param tax[i in plants] = 0.1;
    param scale = 1.0;
    var x[i in plants, t in hours] >= 0.0;
    var hh free;
    def price[i in plants]: tax[i] * hh;
    eq ex[i in plants, t in hours]: price[site[i]] + cost[i, t] * rate + notes[0] + scale.base()
        + x.at(i, t - 1).or(0.0) + x.at(i, t, 1).or(0.0) + sum(n, |k| 1.0 / n as f64) + tax.base(i)
        complements x[i, t];
    eq eh: hh - sum(plants, |i| x[i, hours.wrap(t, -1)]) complements hh;
}";

fn expansion(text: &str) -> TokenStream {
    crate::model::mcp(text.parse().unwrap())
}

/// The text of the tokens without layout.
fn bare(text: &str) -> String {
    let tokens = text.parse::<TokenStream>().unwrap().to_string();
    tokens.chars().filter(|c| !c.is_whitespace()).collect()
}

#[test]
fn names_become_reads() {
    let expansion = bare(&expansion(MODEL).to_string());
    for read in [
        "(&model.price).get(read, (&model.site).get(i))",
        "(&model.cost).get(i, t) * (*(&model.rate))",
        "(**(&model.notes))[0] + (&model.scale).base()",
        "(&model.x).at(read, i, t - 1).or(0.0)",
        "(&model.x).at(read, i, (t) + (1)).or(0.0)",
        "sum((&model.n), |k| 1.0 / (&model.n).len() as f64)",
        "(&model.tax).base(i)",
        "(&model.hh).get(read)",
        "(&model.x).get(read, i, (&model.hours).wrap(t, -1))",
    ] {
        assert!(expansion.contains(&bare(read)), "no `{read}` in\n{expansion}");
    }
}

/// Every identifier with its place, at every depth.
fn places(tokens: TokenStream, found: &mut HashMap<(usize, usize), String>) {
    for tree in tokens {
        match tree {
            TokenTree::Group(group) => places(group.stream(), found),
            TokenTree::Ident(ident) => {
                let at = ident.span().start();
                found.insert((at.line, at.column), ident.to_string());
            }
            _ => {}
        }
    }
}

#[test]
fn every_name_of_an_expression_keeps_its_place() {
    let (mut written, mut kept) = (HashMap::new(), HashMap::new());
    let text: TokenStream = MODEL.parse().unwrap();
    places(text.clone(), &mut written);
    places(crate::model::mcp(text), &mut kept);
    let first_expression = 8;
    let words = ["def", "eq", "in", "complements"];
    let mut compared = 0;
    for (at, name) in written.iter().filter(|(at, _)| at.0 >= first_expression) {
        if !words.contains(&name.as_str()) {
            assert!(kept.contains_key(at), "`{name}` at {at:?} is lost");
            compared += 1;
        }
    }
    assert!(compared > 50);
}

#[test]
fn with_errors_the_compiler_gets_stubs() {
    let broken = MODEL.replace("price[site[i]] +", "prices[site[i]] +");
    let (whole, broken) = (expansion(MODEL).to_string(), expansion(&broken).to_string());
    let (whole, broken) = (bare(&whole), bare(&broken));
    assert!(broken.contains("compile_error!") && broken.contains("structTrade{"));
    assert!(broken.contains("#[cfg(not(rust_analyzer))]const_:()="));
    assert!(!broken.contains("(&model.cost)") && !broken.contains("#[cfg(any(rust_analyzer"));
    assert!(whole.contains("#[cfg(any(rust_analyzer,not(false)))]"));
    assert!(!whole.contains("unreachable!"));
}

#[test]
fn a_name_declared_twice_is_generated_once() {
    let text = "model M { data { a: f64, s: Subset(gone), t[gone]: f64 } var x free; eq x: x - a complements x; }";
    let expansion = bare(&expansion(text).to_string());
    assert_eq!(expansion.matches("x:::mcp_core::language::Variables").count(), 1);
    assert_eq!(expansion.matches("x:::mcp_core::language::Rows").count(), 0);
    assert!(expansion.contains("t:::mcp_core::language::Data<((),)>"), "{expansion}");
}

#[test]
fn documentation_and_units_are_taken_from_comments() {
    let text = "/// All of it.\n pub(crate) model M { data { /// price of iron [$/t]\n c: f64 }
        /// level\n /// of output [t]\n ///\n /// More.\n var x free; eq e: x - c complements x; }";
    let expansion = expansion(text).to_string();
    for part in
        ["level of output", "\"t\"", "`c`: price of iron", "pub (crate) struct M", "All of it."]
    {
        assert!(expansion.contains(part), "no `{part}` in\n{expansion}");
    }
}

#[test]
fn raw_names_lose_their_mark_where_people_read_them() {
    let text = "model M { data { r#type: f64, r#use: Set[r#in], c[r#use]: f64 } var r#match free;
        eq r#fn: r#match - r#type * c[r#in] complements r#match; }";
    let expansion = bare(&expansion(text).to_string());
    for part in ["[\"match\",", "[\"fn\",", "\"type\"", "[\"in\"]", "given_type"] {
        assert!(expansion.contains(part), "no `{part}` in\n{expansion}");
    }
}
