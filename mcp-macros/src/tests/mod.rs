//! Tests that run inside the process: messages with their places, and what is generated.

mod diagnostics;
mod expansion;

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
