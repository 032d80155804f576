//! The generated model: data and calls, nothing numerical.
//!
//! | file | what it generates |
//! | --- | --- |
//! | `domains.rs` | the module with one type for each index set |
//! | `items.rs` | the struct and its methods |
//! | `builder.rs` | what takes the data |
//! | `view.rs` | what shows a solution |
//! | `build.rs` | `build()`: data are resolved, the parts of the model put together |
//! | `families.rs` | families laid out and declared in the shape |
//! | `parts.rs`, `additions.rs` | parts: their types and `with`; what they add to rows |
//! | `rows.rs` | `impl Model`: one generic function for each family |
//! | `server.rs` | what only a language server reads |
//!
//! Fields of the struct are called as in the text, so that a name has one definition.

/// Generated tokens. Their locals are hygienic: no name of the user can meet them.
macro_rules! code {
    ($($tokens:tt)*) => {
        ::quote::quote_spanned!(::proc_macro2::Span::mixed_site()=> $($tokens)*)
    };
}

mod additions;
mod build;
mod builder;
mod domains;
mod families;
mod items;
mod parts;
mod rows;
mod server;
mod view;

use super::ast::{Def, Field, FieldKind, Index, Model};
use super::names::Names;
use super::order::order;
use super::rewrite::Rewriter;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote_spanned};
use syn::ext::IdentExt;

/// What all parts of the expansion need.
struct Expansion<'m> {
    model: &'m Model,
    /// Definitions that are not lifted, in the order of evaluation.
    definitions: Vec<&'m Def>,
    rewriter: Rewriter<'m>,
}

/// What stands where the expressions of a model go.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Bodies {
    /// The expressions.
    Whole,
    /// The model has errors: the expressions, which the compiler leaves out.
    ForTheLanguageServer,
    /// The model has errors: nothing, since the compiler would only report what follows from them.
    Stubs,
}

/// The items of a model.
pub(super) fn model(model: &Model, names: &Names<'_>, bodies: Bodies) -> TokenStream {
    let module = format_ident!("{}Sets", model.name);
    let definitions = order(model, names).into_iter().map(|place| &model.defs[place]);
    let definitions = definitions.filter(|def| !def.lifted).collect();
    let rewriter = Rewriter { names, module };
    let expansion = Expansion { model, definitions, rewriter };
    let (domains, items) = (expansion.domains(), expansion.items());
    let part_types = expansion.part_types();
    let (build, implementation) = (expansion.build(), expansion.implementation());
    // A language server completes where the text up to the cursor expands to the same length with and
    // without the word at it: what quotes the text stands behind the bodies, and both conditions are
    // equally long.
    let occurrences = expansion.occurrences();
    let kept = if bodies == Bodies::Whole { code!(not(false)) } else { code!(all(false)) };
    let bodies_of_rows = (bodies != Bodies::Stubs).then(|| {
        code! {
            #[cfg(any(rust_analyzer, #kept))]
            const _: () = {
                #implementation
                #occurrences
                #build
            };
        }
    });
    let stubs = (bodies != Bodies::Whole).then(|| expansion.stubs());
    code! {
        #[allow(non_snake_case, non_upper_case_globals, unused, unused_parens, unexpected_cfgs, clippy::all, clippy::pedantic, reason = "generated")]
        const _: () = {
            use ::mcp_core::{
                Real, atan2, external, hypot, logsumexp, max, min, prod, select, smooth_max,
                smooth_min, sum, when,
            };
            #bodies_of_rows
            #stubs
        };
        #domains
        #items
        #part_types
    }
}

impl<'m> Expansion<'m> {
    /// A local of the generated code, which no name of the user can meet.
    fn local(name: &str) -> Ident {
        Ident::new(name, Span::mixed_site())
    }

    /// What the compiler meets in place of the bodies of a model with errors.
    fn stubs(&self) -> TokenStream {
        let (name, builder) = (&self.model.name, self.builder());
        let with = self.has_parts().then(|| {
            code! {
                impl #name {
                    fn __with(
                        &self, _: ::mcp_core::language::Assembly,
                    ) -> ::core::result::Result<#name, ::mcp_core::ModelError> {
                        ::core::unreachable!()
                    }
                }
            }
        });
        code! {
            #[cfg(not(rust_analyzer))]
            const _: () = {
                #with
                impl #builder {
                    fn __build(self) -> ::core::result::Result<#name, ::mcp_core::ModelError> {
                        ::core::unreachable!()
                    }
                }
                impl ::mcp_core::Model for #name {
                    fn shape(&self) -> &::mcp_core::Shape {
                        &self.__shape
                    }
                    fn row<D: ::mcp_core::Scalar>(
                        &self, _: usize, _: usize, _: &::mcp_core::Reader<'_, D>,
                    ) -> ::mcp_core::Real<D> {
                        ::core::unreachable!()
                    }
                }
            };
        }
    }

    /// Variable families: those declared, then lifted definitions.
    fn lifted(&self) -> impl Iterator<Item = &'m Def> {
        self.model.defs.iter().filter(|def| def.lifted)
    }
    /// Definition families in the order of evaluation.
    fn definitions(&self) -> impl Iterator<Item = &'m Def> {
        self.definitions.clone().into_iter()
    }
    /// Fields that are index sets.
    fn sets(&self) -> impl Iterator<Item = &'m Field> {
        self.model.fields.iter().filter(|field| field.kind.is_set())
    }

    /// The tuple of index sets of a family, as a type.
    fn tuple<'i>(&self, sets: impl Iterator<Item = &'i Ident>) -> TokenStream {
        let sets = sets.map(|set| self.set(set));
        code!((#(#sets,)*))
    }
    /// The type of an index set; a set that is not declared, in a model with errors, has none.
    fn set(&self, set: &Ident) -> TokenStream {
        let module = &self.rewriter.module;
        if self.rewriter.names.set(&set.to_string()).is_some() {
            code!(#module::#set)
        } else {
            code!(())
        }
    }
    /// Type of a set or a map in the struct.
    fn set_type(&self, field: &Field) -> TokenStream {
        let name = self.set(&field.name);
        match &field.kind {
            FieldKind::Subset(_) => code!(::mcp_core::language::Subset<#name>),
            FieldKind::Pairs(from, to) => {
                let (from, to) = (self.set(from), self.set(to));
                code!(::mcp_core::language::Pairs<#name, #from, #to>)
            }
            FieldKind::Map(from, to) => {
                let (from, to) = (self.set(from), self.set(to));
                code!(::mcp_core::language::Map<#from, #to>)
            }
            _ => code!(::mcp_core::language::IndexSet<#name>),
        }
    }
    /// The tuple of index sets of a header.
    fn header(&self, over: &[Index]) -> TokenStream {
        self.tuple(over.iter().map(|index| &index.set))
    }

    /// `&[…]`, the index sets of a header.
    fn sets_of<'i>(over: impl IntoIterator<Item = &'i Index>) -> TokenStream {
        let model = Self::local("model");
        let sets = over.into_iter().map(|index| &index.set);
        code!(&[#(::mcp_core::language::Members::set(&#model.#sets)),*])
    }

    /// `&|at| …`: what is computed for a combination of a header, given by positions.
    fn at_each<'i>(over: impl IntoIterator<Item = &'i Index>, body: &TokenStream) -> TokenStream {
        let [model, at] = ["model", "at"].map(Self::local);
        let indices = over.into_iter().enumerate().map(|(k, index)| {
            let (name, set) = (&index.name, &index.set);
            let ends = Self::ends(index);
            let all = quote_spanned!(Span::mixed_site().located_at(set.span())=> &#model.#set);
            code!(let #name = ::mcp_core::language::Members::ix(#all, #at[#k]); #ends)
        });
        code!(&|#at: &::mcp_core::language::At| {
            let #model = &#model;
            #(#indices)*
            #body
        })
    }

    /// Runs `body` for all combinations of a header.
    fn for_each(over: &[Index], body: TokenStream) -> TokenStream {
        let model = Self::local("model");
        over.iter().rev().fold(body, |body, index| {
            let Index { name, set, .. } = index;
            let ends = Self::ends(index);
            let all = quote_spanned!(Span::mixed_site().located_at(set.span())=> &#model.#set);
            code!(for #name in #all { #ends #body })
        })
    }
    /// `let (i, j) = …;` of an arc.
    fn ends(index: &Index) -> Option<TokenStream> {
        let Index { name, set, ends } = index;
        let (from, to) = ends.as_ref()?;
        let model = Self::local("model");
        let at = Span::mixed_site().located_at(set.span());
        Some(quote_spanned!(at=> let (#from, #to) = #model.#set.ends(#name);))
    }

    /// A row of an equation that a lifted definition stands for: `def v`.
    fn lifted_equation(def: &Def) -> String {
        format!("def {}", label(&def.name))
    }
    /// The field with the rows of a lifted definition.
    fn rows_of_lifted(def: &Def) -> Ident {
        format_ident!("__def_{}", def.name)
    }
}

/// A name as people read it: without `r#`.
fn label(name: &Ident) -> String {
    name.unraw().to_string()
}

/// What a doc comment says: text and, in brackets at its end, the unit.
fn description(attributes: &[syn::Attribute]) -> (String, String) {
    let mut lines = Vec::new();
    for attribute in attributes {
        if attribute.path().is_ident("doc")
            && let syn::Meta::NameValue(meta) = &attribute.meta
            && let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = &meta.value
        {
            let text = text.value().trim().to_owned();
            if text.is_empty() && !lines.is_empty() {
                break;
            }
            lines.push(text);
        }
    }
    let text = lines.join(" ").trim().to_owned();
    // `capacity[i]` at the end is no unit.
    match text.strip_suffix(']').and_then(|rest| rest.rsplit_once(" [")) {
        Some((about, unit)) => (about.trim().to_owned(), unit.trim().to_owned()),
        None => (text, String::new()),
    }
}
