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
                (0, _) => code!(f64),
                (_, true) => code!(::mcp_core::language::VariableLevels<#rank>),
                (_, false) => code!(::mcp_core::language::Levels<#rank>),
            };
            code!(#(#attributes)* #text #visibility #name: #levels,)
        });
        let values = viewed.iter().map(|family| {
            let (name, numbers) = (family.name, numbers(family.name));
            match (family.over.len(), family.is_variable) {
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
                    let [#(#names),*] =
                        ::mcp_core::language::viewed(self, solution, &[#(#viewed_tables)*])?;
                    ::core::result::Result::Ok(#view { #(#values)* #(#table_values)* })
                }
            }
        }
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
        let vars = model.vars.iter().map(|v| (&v.attributes[..], &v.name, &v.over[..]));
        let lifted = self.lifted().map(|d| (&d.attributes[..], &d.name, &d.over[..]));
        let defs = self.definitions().map(|d| (&d.attributes[..], &d.name, &d.over[..]));
        let params = model.params.iter().map(|p| (&p.attributes[..], &p.name, &p.over[..]));
        let reports = model.reports.iter().map(|r| (&r.attributes[..], &r.name, &r.over[..]));
        let variables = vars.chain(lifted).map(|family| (family, true));
        let others = defs.chain(params).chain(reports).map(|family| (family, false));
        let viewed = |((attributes, name, over), is_variable)| Viewed {
            attributes,
            name,
            over,
            is_variable,
        };
        variables.chain(others).map(viewed).collect()
    }
}

/// The local with the numbers of a family.
fn numbers(family: &Ident) -> Ident {
    format_ident!("numbers_{}", family, span = Span::mixed_site())
}
