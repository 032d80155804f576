//! Tests that run inside the process: messages with their places, and what is generated.

mod diagnostics;
mod expansion;
mod language_models;
mod model_diagnostics;
mod model_expansion;
mod model_habits;
mod model_names;
mod model_pairs;
mod model_parts;
mod model_reads;
mod model_texts;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// Splits `#[mcp_fn(arguments)] item`, keeping places.
fn split(text: &str) -> (TokenStream, TokenStream) {
    let tokens: TokenStream = text.parse().unwrap();
    let mut tokens = tokens.into_iter();
    assert_eq!(tokens.next().unwrap().to_string(), "#");
    let Some(TokenTree::Group(attribute)) = tokens.next() else { panic!("no attribute") };
    let arguments = match attribute.stream().into_iter().nth(1) {
        Some(TokenTree::Group(list)) if list.delimiter() == Delimiter::Parenthesis => list.stream(),
        _ => TokenStream::new(),
    };
    (arguments, tokens.collect())
}

/// The tokens cut off at every place, and without every single token, at every depth.
fn mutilated(tokens: &TokenStream) -> Vec<TokenStream> {
    let trees: Vec<TokenTree> = tokens.clone().into_iter().collect();
    let mut all = Vec::new();
    for (i, tree) in trees.iter().enumerate() {
        let (before, after) = (&trees[..i], &trees[i + 1..]);
        all.push(before.iter().cloned().collect());
        all.push(before.iter().chain(after).cloned().collect());
        if let TokenTree::Group(group) = tree {
            for inner in mutilated(&group.stream()) {
                let group = TokenTree::from(Group::new(group.delimiter(), inner));
                all.push(before.iter().chain([&group]).chain(after).cloned().collect());
            }
        }
    }
    all
}

/// The errors of one `mcp!`, one a line.
fn model_errors(text: &str) -> String {
    match crate::model::check(text.parse().unwrap()) {
        Ok(()) => String::new(),
        Err(errors) => errors.lines().join("\n"),
    }
}

/// The errors of one `mcp!` with these items on its second line.
fn model_with(items: &str) -> String {
    model_errors(&format!(
        "model M {{ data {{ plants: Set[oslo, rome], markets: Set, hours: Ordered, big: Subset(plants), \
         cost[plants, markets]: f64, u: f64, site: Map(plants, markets), \
         arcs: Pairs(plants, markets) }} param q[i in plants]; param g; var z0 free; \
         var x[i in plants, j in markets] >= 0.0; eq ez if u > 0.0: z0 complements z0; \
         eq ex[i in plants, j in markets]: u complements x[i, j];\n{items}\n}}"
    ))
}
