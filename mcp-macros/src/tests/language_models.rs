//! The four models the language was designed for, as they stand in the acceptance tests.

use proc_macro2::{TokenStream, TokenTree};

/// General equilibrium with taxes: calibrated share form.
const CGE: &str = include_str!("../../../tests/language/cge.rs");
/// Hourly dispatch with a network and cyclic storage.
const POWER: &str = include_str!("../../../tests/language/power.rs");
/// Spatial price equilibrium on existing arcs.
const SPATIAL: &str = include_str!("../../../tests/language/spatial.rs");
/// One step of planar contact with friction.
const CONTACT_STEP: &str = include_str!("../../../tests/language/contact.rs");

/// What stands in the `mcp!` of each.
pub(super) fn models() -> [TokenStream; 4] {
    [CGE, POWER, SPATIAL, CONTACT_STEP].map(|text| {
        let program: TokenStream = text.parse().unwrap();
        let trees: Vec<TokenTree> = program.into_iter().collect();
        let model = trees.windows(3).find_map(|three| match three {
            [TokenTree::Ident(name), TokenTree::Punct(_), TokenTree::Group(model)]
                if name == "mcp" =>
            {
                Some(model.stream())
            }
            _ => None,
        });
        model.expect("a file with an `mcp!`")
    })
}
