//! The view: a solution by the names of the model.

use super::super::ast::{Field, FieldKind, Index};
use super::items::{about, indices};
use super::{Expansion, label};
use proc_macro2::{Ident, TokenStream};
use quote::format_ident;
use syn::Attribute;

/// A family as a field of the view.
struct Viewed<'a> {
    attributes: &'a [Attribute],
    name: &'a Ident,
    over: &'a [Index],
    /// The method of `Evaluated` that reads it, and its number among its kind.
    method: &'static str,
    number: usize,
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
        let table_values = tables.iter().map(|field| {
            let (name, text, sets) = (&field.name, label(&field.name), &field.over);
            code!(#name: ::mcp_core::language::viewed_table(
                #text,
                &[#(::mcp_core::language::Members::set(&self.#sets)),*],
                self.#name.values(),
            ),)
        });
        let fields = viewed.iter().map(|family| {
            let (name, attributes, rank) = (family.name, family.attributes, family.over.len());
            let text = format!("`{name}{}`", indices(family.over));
            let text = if attributes.is_empty() { Some(code!(#[doc = #text])) } else { None };
            let levels = match (rank, family.method) {
                (0, _) => code!(f64),
                (_, "variable") => code!(::mcp_core::language::VariableLevels<#rank>),
                _ => code!(::mcp_core::language::Levels<#rank>),
            };
            code!(#(#attributes)* #text #visibility #name: #levels,)
        });
        let values = viewed.iter().map(|family| {
            let (name, method, k) =
                (family.name, format_ident!("{}", family.method), family.number);
            if family.over.is_empty() {
                code!(#name: ::mcp_core::language::single(&at.#method(#k)),)
            } else {
                code!(#name: at.#method(#k),)
            }
        });
        let about = format!(
            "A solution of [`{name}`] by the names of the model: variables, definitions, parameters, \
             reports and tables."
        );
        let at = viewed.is_empty().then(|| code!(let _ = &at;));
        code! {
            #[doc = #about]
            #[allow(non_snake_case, reason = "fields are called as in the text of the model")]
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
                #visibility fn view(
                    &self,
                    solution: &::mcp_core::Solution,
                ) -> ::core::result::Result<#view, ::mcp_core::ModelError> {
                    let at = ::mcp_core::language::Evaluated::new(self, solution)?;
                    #at
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

    fn viewed(&self) -> Vec<Viewed<'_>> {
        let model = self.model;
        let vars = model.vars.iter().map(|v| (&v.attributes[..], &v.name, &v.over[..]));
        let lifted = self.lifted().map(|d| (&d.attributes[..], &d.name, &d.over[..]));
        let defs = self.definitions().map(|d| (&d.attributes[..], &d.name, &d.over[..]));
        let params = model.params.iter().map(|p| (&p.attributes[..], &p.name, &p.over[..]));
        let reports = model.reports.iter().map(|r| (&r.attributes[..], &r.name, &r.over[..]));
        let viewed = numbered("variable", vars.chain(lifted)).chain(numbered("definition", defs));
        let viewed = viewed.chain(numbered("parameter", params));
        viewed.chain(numbered("report", reports)).collect()
    }
}

/// Families of a kind with their numbers.
fn numbered<'a>(
    method: &'static str,
    families: impl Iterator<Item = (&'a [Attribute], &'a Ident, &'a [Index])>,
) -> impl Iterator<Item = Viewed<'a>> {
    families.enumerate().map(move |(number, (attributes, name, over))| Viewed {
        attributes,
        name,
        over,
        method,
        number,
    })
}
