//! The name of a type, made of a name of a model: `emission_cap` becomes `EmissionCap`.

use proc_macro2::Ident;
use syn::ext::IdentExt;

/// The name in upper camel case, where the name stands; none can be made of underscores alone.
pub(crate) fn type_name(name: &Ident) -> Option<Ident> {
    let text = name.unraw().to_string();
    let mut camel = String::new();
    for word in text.split('_').filter(|word| !word.is_empty()) {
        let (before, after) = (camel.chars().next_back(), word.chars().next());
        if before.is_some_and(char::is_numeric) && after.is_some_and(char::is_numeric) {
            camel.push('_');
        }
        camel.extend(after.into_iter().flat_map(char::to_uppercase));
        camel.extend(word.chars().skip(1));
    }
    let mut camel = syn::parse_str::<Ident>(&camel).ok()?;
    camel.set_span(name.span());
    Some(camel)
}
