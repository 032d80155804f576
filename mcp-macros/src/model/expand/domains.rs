//! One type for each index set, in a module of their own.

use super::super::ast::{Field, FieldKind};
use super::Expansion;
use proc_macro2::{Ident, TokenStream};

impl Expansion<'_> {
    /// `mod __Transport { pub enum plants {} … }`
    pub(super) fn domains(&self) -> TokenStream {
        let module = &self.rewriter.module;
        let domains = self.sets().map(|set| self.domain(set));
        code! {
            #[doc(hidden)]
            #[allow(
                non_camel_case_types, non_snake_case, non_upper_case_globals, unreachable_pub,
                missing_docs, dead_code, clippy::all, clippy::pedantic, reason = "generated"
            )]
            mod #module {
                #(#domains)*
            }
        }
    }

    fn domain(&self, set: &Field) -> TokenStream {
        let name = &set.name;
        let place = if let FieldKind::Subset(larger) = &set.kind
            && self.rewriter.names.set(&larger.to_string()).is_some()
        {
            code!((::core::primitive::u32, ::mcp_core::language::Ix<#larger>))
        } else {
            code!(::core::primitive::u32)
        };
        let ordered = set
            .kind
            .is_ordered()
            .then(|| code!(impl ::mcp_core::language::OrderedDomain for #name {}));
        let labels = labels(set);
        let larger = self.larger_sets(set).into_iter().map(|larger| in_larger_set(set, larger));
        code! {
            #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
            pub enum #name {}
            impl ::mcp_core::language::Domain for #name {
                type Place = #place;
            }
            #ordered
            #labels
            #(#larger)*
        }
    }

    /// All sets a subset lies in, the nearest first.
    fn larger_sets<'s>(&'s self, set: &'s Field) -> Vec<&'s Ident> {
        let mut larger = Vec::new();
        let mut current = set;
        while let FieldKind::Subset(parent) = &current.kind
            && !larger.contains(&parent)
            && let Some(field) = self.sets().find(|field| field.name == *parent)
        {
            larger.push(parent);
            current = field;
        }
        larger
    }
}

/// Labels known to the text, as constants.
fn labels(set: &Field) -> Option<TokenStream> {
    let FieldKind::Labels(labels) = &set.kind else { return None };
    let name = &set.name;
    let positions = 0..u32::try_from(labels.len()).unwrap_or(u32::MAX);
    Some(code! {
        impl #name {
            #(pub const #labels: ::mcp_core::language::Ix<Self> =
                ::mcp_core::language::Ix::new(#positions);)*
        }
    })
}

/// An index of the subset is an index of the larger set.
fn in_larger_set(set: &Field, larger: &Ident) -> TokenStream {
    let name = &set.name;
    code! {
        #[diagnostic::do_not_recommend]
        impl ::mcp_core::language::Element<#larger> for ::mcp_core::language::Ix<#name> {
            #[inline]
            fn position_in(self) -> ::core::primitive::usize {
                ::mcp_core::language::Element::<#larger>::position_in(self.of_larger_set())
            }
        }
        #[diagnostic::do_not_recommend]
        impl ::mcp_core::language::Near<#larger> for ::mcp_core::language::Ix<#name> {
            #[inline]
            fn position_near(self) -> ::core::primitive::i64 {
                ::mcp_core::language::Near::<#larger>::position_near(self.of_larger_set())
            }
        }
    }
}
