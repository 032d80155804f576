//! The builder: one method for each field of the data and each parameter.

use super::super::ast::FieldKind;
use super::super::names::is_type;
use super::Expansion;
use super::items::{about, indices, input_type, sets_of};
use proc_macro2::{Ident, TokenStream};
use quote::format_ident;

impl Expansion<'_> {
    pub(super) fn builder_items(&self) -> TokenStream {
        let (model, builder) = (self.model, self.builder());
        let (visibility, name) = (&model.visibility, &model.name);
        let given: Vec<_> = self.given().collect();
        let fields = given.iter().filter(|(_, _, given, _)| !given.is_converted());
        let fields =
            fields.map(|(_, name, given, _)| code!(#name: ::core::option::Option<#given>,));
        let setters = given.iter().map(|(k, name, given, about)| {
            let (argument, give) = if given.is_converted() {
                let give = code! {
                    let value: #given = value.into();
                    self.__given.give(#k, value);
                };
                (code!(impl ::core::convert::Into<#given>), give)
            } else {
                (code!(#given), code!(self.#name = ::core::option::Option::Some(value);))
            };
            code! {
                #[doc = #about]
                #[must_use]
                #visibility fn #name(mut self, value: #argument) -> Self {
                    #give
                    self
                }
            }
        });
        let (about, build) = (
            format!("Data of [`{name}`]: sets, tables and values by name, in any order."),
            "The model with these data.\n\n# Errors\nWhat is missing, of the wrong shape, unknown, \
             given twice or not a number, by name; crossed bounds; a variable without equation or \
             with two.",
        );
        code! {
            #[doc = #about]
            #[allow(non_snake_case, clippy::struct_field_names, reason = "fields are called as in the text of the model")]
            #[derive(::core::default::Default)]
            #[must_use = "`build()` makes the model"]
            #visibility struct #builder {
                __given: ::mcp_core::language::Assembly,
                #(#fields)*
            }
            #[allow(non_snake_case, reason = "methods are called as in the text of the model")]
            #[automatically_derived]
            impl #builder {
                #(#setters)*
                #[doc = #build]
                #visibility fn build(self) -> ::core::result::Result<#name, ::mcp_core::ModelError> {
                    self.__build()
                }
            }
        }
    }

    /// What the builder takes: number, name, type and description.
    fn given(&self) -> impl Iterator<Item = (usize, &Ident, Given<'_>, String)> {
        let fields = self.model.fields.iter().enumerate();
        let fields = fields.filter(|(_, field)| field.part.is_none()).filter_map(|(k, field)| {
            if let FieldKind::Value(value) = &field.kind {
                let about = about(&field.attributes, &format!("`{}`", field.name));
                return Some((k, &field.name, Given::User(value), about));
            }
            let (input, what) = input_type(field)?;
            let text = format!("The {what} `{}{}`", field.name, sets_of(field));
            Some((k, &field.name, Given::Input(input), about(&field.attributes, &text)))
        });
        let first = self.model.fields.len();
        let params = self.model.params.iter().enumerate();
        let params = params.filter(|(_, param)| param.part.is_none()).map(move |(k, param)| {
            let default =
                if param.value.is_some() { ", in place of its value in the text" } else { "" };
            let text = format!("The parameter `{}{}`{default}", param.name, indices(&param.over));
            let given = Given::Input(format_ident!("Table"));
            (first + k, &param.name, given, about(&param.attributes, &text))
        });
        fields.chain(params)
    }
}

/// A type that the builder takes.
enum Given<'a> {
    /// One of the input types of `mcp_core::language`.
    Input(Ident),
    /// The user's own.
    User(&'a syn::Type),
}

impl Given<'_> {
    /// Whether the builder takes what can be made into it: `1` for an `f64`, too.
    fn is_converted(&self) -> bool {
        match self {
            Given::Input(_) => true,
            Given::User(user) => is_type(user, "f64"),
        }
    }
}

impl quote::ToTokens for Given<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Given::Input(name) => tokens.extend(code!(::mcp_core::language::#name)),
            Given::User(user) => user.to_tokens(tokens),
        }
    }
}
