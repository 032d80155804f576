//! The view: a solution by the names of the model.

use super::super::ast::{Field, FieldKind, Index};
use super::items::{about, indices};
use super::{Expansion, label};
use proc_macro2::{Ident, Span, TokenStream};
use quote::format_ident;
use syn::Attribute;

/// A family as a field of the view.
struct Viewed<'a> {
    attributes: &'a [Attribute],
    name: &'a Ident,
    over: &'a [Index],
    part: Option<usize>,
    is_variable: bool,
}

impl Expansion<'_> {
    pub(super) fn view(&self) -> TokenStream {
        let (visibility, name) = (&self.model.visibility, &self.model.name);
        let view = format_ident!("{name}View");
        let viewed = self.viewed();
        let tables = self.tables();
        let table_fields = tables.iter().map(|field| {
            let (name, rank) = (&field.name, field.over.len());
            let about = about(&field.attributes, &format!("The table `{name}`"));
            code!(#[doc = #about] #visibility #name: ::mcp_core::language::Levels<#rank>,)
        });
        let viewed_tables = tables.iter().map(|field| {
            let (name, text, sets) = (&field.name, label(&field.name), &field.over);
            code!((
                #text,
                &[#(::mcp_core::language::Members::set(&self.#sets)),*],
                self.#name.values(),
            ),)
        });
        let fields = viewed.iter().map(|family| {
            let (name, attributes, rank) = (family.name, family.attributes, family.over.len());
            let text = format!("`{name}{}`", indices(family.over));
            let text = if attributes.is_empty() { Some(code!(#[doc = #text])) } else { None };
            let levels = match (rank, family.is_variable) {
                (0, _) if family.part.is_some() => code!(::core::option::Option<f64>),
                (0, _) => code!(f64),
                (_, true) => code!(::mcp_core::language::VariableLevels<#rank>),
                (_, false) => code!(::mcp_core::language::Levels<#rank>),
            };
            code!(#(#attributes)* #text #visibility #name: #levels,)
        });
        let values = viewed.iter().map(|family| {
            let (name, numbers) = (family.name, numbers(family.name));
            match (family.over.len(), family.is_variable) {
                (0, _) if family.part.is_some() => code!(#name: #numbers.single_if_on(),),
                (0, _) => code!(#name: #numbers.single(),),
                (_, true) => code!(#name: ::mcp_core::language::VariableLevels(
                    ::mcp_core::language::Levels(#numbers)
                ),),
                (_, false) => code!(#name: ::mcp_core::language::Levels(#numbers),),
            }
        });
        let table_values = tables.iter().map(|field| {
            let (name, numbers) = (&field.name, numbers(&field.name));
            code!(#name: ::mcp_core::language::Levels(#numbers),)
        });
        let names = viewed.iter().map(|family| family.name);
        let names = names.chain(tables.iter().map(|field| &field.name)).map(numbers);
        let all_numbers = if self.has_parts() {
            let apart = Self::viewed_apart(&viewed, &tables);
            code! {
                ::mcp_core::language::viewed_with_parts(
                    self, solution, &[#(#viewed_tables)*], &[#apart],
                )
            }
        } else {
            code!(::mcp_core::language::viewed(self, solution, &[#(#viewed_tables)*]))
        };
        let about = format!(
            "A solution of [`{name}`] by the names of the model: variables, definitions, parameters, \
             reports and tables."
        );
        code! {
            #[doc = #about]
            #[allow(non_snake_case, clippy::struct_field_names, reason = "fields are called as in the text of the model")]
            #[derive(::core::clone::Clone, ::core::fmt::Debug)]
            #visibility struct #view {
                #(#fields)*
                #(#table_fields)*
            }
            #[automatically_derived]
            impl #name {
                /// The solution by the names of the model.
                ///
                /// # Errors
                /// `ModelError::Length` or `ModelError::OtherModel` for a solution of a model with other
                /// variables or sets.
                #[inline(never)]
                #visibility fn view(
                    &self,
                    solution: &::mcp_core::Solution,
                ) -> ::core::result::Result<#view, ::mcp_core::ModelError> {
                    let [#(#names),*] = #all_numbers?;
                    ::core::result::Result::Ok(#view { #(#values)* #(#table_values)* })
                }
            }
        }
    }

    /// Place, name and part of every field of the view that belongs to a part.
    fn viewed_apart(viewed: &[Viewed<'_>], tables: &[&Field]) -> TokenStream {
        let families = viewed.iter().map(|family| (family.name, family.part));
        let all = families.chain(tables.iter().map(|field| (&field.name, field.part)));
        let apart = all.enumerate().filter_map(|(place, (name, part))| {
            let (name, part) = (label(name), part?);
            Some(code!((#place, #name, #part),))
        });
        apart.collect()
    }

    /// Tables of the data over sets that are declared.
    fn tables(&self) -> Vec<&Field> {
        let fields = self.model.fields.iter();
        let is_known = |set: &Ident| self.rewriter.names.set(&set.to_string()).is_some();
        fields
            .filter(|field| matches!(field.kind, FieldKind::Table))
            .filter(|field| field.over.iter().all(is_known))
            .collect()
    }

    /// Families in the order of `viewed` in `mcp_core`.
    fn viewed(&self) -> Vec<Viewed<'_>> {
        let model = self.model;
        let vars = model.vars.iter().map(|v| (&v.attributes[..], &v.name, &v.over[..], v.part));
        let lifted = self.lifted().map(|d| (&d.attributes[..], &d.name, &d.over[..], d.part));
        let defs = self.definitions().map(|d| (&d.attributes[..], &d.name, &d.over[..], d.part));
        let params = model.params.iter().map(|p| (&p.attributes[..], &p.name, &p.over[..], p.part));
        let reports =
            model.reports.iter().map(|r| (&r.attributes[..], &r.name, &r.over[..], r.part));
        let variables = vars.chain(lifted).map(|family| (family, true));
        let others = defs.chain(params).chain(reports).map(|family| (family, false));
        let viewed = |((attributes, name, over, part), is_variable)| Viewed {
            attributes,
            name,
            over,
            part,
            is_variable,
        };
        variables.chain(others).map(viewed).collect()
    }
}

/// The local with the numbers of a family.
fn numbers(family: &Ident) -> Ident {
    format_ident!("numbers_{}", family, span = Span::mixed_site())
}
