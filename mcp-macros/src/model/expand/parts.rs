//! Parts: a type for each with its data, and `with`. A family of a part that is off has no element and
//! is not declared.

use super::super::ast::{FieldKind, Part};
use super::additions::added_field;
use super::items::{about, indices, input_type, sets_of};
use super::{Expansion, label};
use crate::type_name::type_name;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote_spanned};

impl Expansion<'_> {
    pub(super) fn has_parts(&self) -> bool {
        !self.model.parts.is_empty()
    }

    /// What belongs to a part is made only where it is on.
    pub(super) fn within(
        part: Option<usize>,
        assembly: &Ident,
        tokens: TokenStream,
    ) -> TokenStream {
        match part {
            None => tokens,
            Some(part) => code!(#assembly.enter(#part); #tokens #assembly.leave();),
        }
    }

    /// The fields of the struct.
    pub(super) fn fields_of_parts(&self) -> Option<TokenStream> {
        let added = (0..self.model.adds.len()).map(added_field);
        self.has_parts().then(|| {
            code! {
                #(#added: ::mcp_core::language::Rows<()>,)*
                __parts: ::mcp_core::language::Parts,
            }
        })
    }

    /// The fields of the struct without anything in them.
    pub(super) fn empty_additions(&self) -> TokenStream {
        let added = (0..self.model.adds.len()).map(added_field);
        code!(#(#added: ::mcp_core::language::Rows::EMPTY,)*)
    }

    /// `&[PartText { … }]`
    pub(super) fn part_texts(&self) -> TokenStream {
        let names = self.rewriter.names;
        let texts = self.model.parts.iter().map(|part| {
            let text = label(&part.name);
            let [requires, excludes] = [&part.requires, &part.excludes]
                .map(|others| others.iter().filter_map(|other| names.part(other)));
            code! {
                ::mcp_core::language::PartText {
                    name: #text, requires: &[#(#requires),*], excludes: &[#(#excludes),*],
                }
            }
        });
        code!(&[#(#texts),*])
    }

    /// `fn with` and `fn parts`.
    pub(super) fn with(&self) -> Option<TokenStream> {
        let (visibility, name) = (&self.model.visibility, &self.model.name);
        self.has_parts().then(|| {
            code! {
                /// The model with these parts on beside those that are: one part with its data, or a
                /// tuple of several, in any order. Bounds, starts and parameters that were changed by
                /// name stay changed, but a variable that a part fixes has the bounds of the part and
                /// starts there.
                ///
                /// # Errors
                /// `ModelError::PartTwice` for a part that is on already; `PartRequired`, `PartExcluded`
                /// for parts that do not fit together, `FixedTwice` for a variable that two of them
                /// fix, `FixedByName` for one that was fixed by name and that one of them fixes; what is
                /// wrong with their data, as in `build()`; `DataError::AddedToAbsent` for a part that
                /// adds to rows that there are not.
                #visibility fn with(
                    &self, parts: impl ::mcp_core::language::PartsOf<#name>,
                ) -> ::core::result::Result<#name, ::mcp_core::ModelError> {
                    self.__with(self.__parts.with(&self.__shape, parts)?)
                }
                /// The names of the parts that are on, in the order of the text.
                #visibility fn parts(&self) -> ::std::vec::Vec<&'static str> {
                    self.__shape.parts()
                }
            }
        })
    }

    /// What `build` and `with` share, and the rest of `with`.
    pub(super) fn with_and_lay_out(&self) -> Option<TokenStream> {
        let name = &self.model.name;
        let [model, assembly] = ["model", "assembly"].map(Self::local);
        let data = self.in_order_of_need().into_iter().filter_map(|field| {
            let (part, name) = (field.part?, &field.name);
            let value = if matches!(field.kind, FieldKind::Table) {
                self.table(field, &assembly)
            } else {
                let value = self.resolve(field, &assembly, &|set| code!(#model.#set));
                Self::within(Some(part), &assembly, code!(#model.#name = #value;))
            };
            Some(code!(if #assembly.is_new(#part) { #value }))
        });
        let kept = self.model.params.iter().enumerate().map(|(k, param)| {
            let (number, name) = (self.model.fields.len() + k, &param.name);
            code!(#assembly.keep(#number, &#model.#name.0);)
        });
        let (families, start) = (self.lay_out(&assembly), self.lifted_start(&model));
        self.has_parts().then(|| {
            code! {
                #[automatically_derived]
                impl #name {
                    fn __with(
                        &self, mut #assembly: ::mcp_core::language::Assembly,
                    ) -> ::core::result::Result<#name, ::mcp_core::ModelError> {
                        let mut #model = ::core::clone::Clone::clone(self);
                        #(#data)*
                        #(#kept)*
                        #model.__lay_out(#assembly)
                    }
                    fn __lay_out(
                        self, mut #assembly: ::mcp_core::language::Assembly,
                    ) -> ::core::result::Result<#name, ::mcp_core::ModelError> {
                        let mut #model = self;
                        #families
                        let before = ::core::mem::take(&mut #model.__shape);
                        #model.__parts.finish(&mut #assembly, &before, &mut #model.__shape)?;
                        #start
                        ::core::result::Result::Ok(#model)
                    }
                }
            }
        })
    }

    /// `mod EconomyParts { pub struct Co2 { … } }` and `use EconomyParts::*`, so that models beside each
    /// other may have parts of one name: only who writes that name alone has to say which.
    pub(super) fn part_types(&self) -> Option<TokenStream> {
        let (visibility, model) = (&self.model.visibility, &self.model.name);
        let module = self.part_module();
        // In a model with errors two parts may have one name.
        let mut seen: Vec<Ident> = Vec::new();
        let parts = self.model.parts.iter().enumerate().filter_map(|(k, part)| {
            let name = type_name(&part.name).filter(|name| !seen.contains(name))?;
            seen.push(name.clone());
            Some(self.part_type(k, part, &name))
        });
        let (types, switches): (Vec<TokenStream>, Vec<TokenStream>) = parts.unzip();
        // Shown where a name is that of parts of two models: at the name of the model.
        let at = Span::mixed_site().located_at(model.span());
        let beside = quote_spanned!(at=> #visibility use #module::*;);
        let about = format!("The parts of [`{model}`](super::{model}), each with its data.");
        self.has_parts().then(|| {
            code! {
                #[doc = #about]
                #[allow(
                    non_snake_case, unreachable_pub, dead_code, clippy::struct_field_names,
                    reason = "a part may stay off; fields are called as in the text of the model"
                )]
                #visibility mod #module {
                    #(#types)*
                }
                #[doc(inline)]
                #[allow(
                    unused_imports, ambiguous_glob_reexports,
                    reason = "a part may stay off; another model may have such a part"
                )]
                #beside
                #(
                    #[allow(unused_qualifications, reason = "another model may have such a part")]
                    #[automatically_derived]
                    #switches
                )*
            }
        })
    }

    /// The module with the types of the parts.
    fn part_module(&self) -> Ident {
        format_ident!("{}Parts", self.model.name)
    }

    /// The type of a part, and how it is switched on.
    fn part_type(&self, number: usize, part: &Part, name: &Ident) -> (TokenStream, TokenStream) {
        let (model, module) = (&self.model.name, self.part_module());
        let text = format!("The part `{}` of [`{model}`](super::{model})", label(&part.name));
        let about = about(&part.attributes, &text);
        let given = self.given_with(number);
        if given.is_empty() {
            let unit = code! {
                #[doc = #about]
                #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
                pub struct #name;
            };
            let switch = code! {
                impl ::mcp_core::language::PartsOf<#model> for #module::#name {
                    fn give(self, assembly: &mut ::mcp_core::language::Assembly) {
                        assembly.switch_on(#number);
                    }
                }
            };
            return (unit, switch);
        }
        let types: Vec<Ident> =
            (0..given.len()).map(|k| format_ident!("T{k}", span = Span::mixed_site())).collect();
        let fields: Vec<&Ident> = given.iter().map(|given| given.name).collect();
        let numbers = given.iter().map(|given| given.number);
        let abouts = given.iter().map(|given| &given.about);
        let inputs: Vec<&TokenStream> = given.iter().map(|given| &given.input).collect();
        let with_data = code! {
            #[doc = #about]
            #[derive(::core::clone::Clone, ::core::fmt::Debug)]
            pub struct #name<#(#types = #inputs),*> {
                #(#[doc = #abouts] pub #fields: #types,)*
            }
        };
        let switch = code! {
            impl<#(#types: ::core::convert::Into<#inputs>),*> ::mcp_core::language::PartsOf<#model>
                for #module::#name<#(#types),*>
            {
                fn give(self, assembly: &mut ::mcp_core::language::Assembly) {
                    assembly.switch_on(#number);
                    #(
                        let value: #inputs = self.#fields.into();
                        assembly.give(#numbers, value);
                    )*
                }
            }
        };
        (with_data, switch)
    }

    /// What comes with a part: its data, and its parameters without a value in the text.
    fn given_with(&self, part: usize) -> Vec<GivenWith<'_>> {
        let fields = self.model.fields.iter().filter(|field| field.part == Some(part));
        let fields = fields.filter_map(|field| {
            let (input, what) = if let FieldKind::Value(value) = &field.kind {
                (value.to_token_stream(), "number")
            } else {
                let (input, what) = input_type(field)?;
                (code!(::mcp_core::language::#input), what)
            };
            let text = format!("The {what} `{}{}`", label(&field.name), sets_of(field));
            let about = about(&field.attributes, &text);
            Some(GivenWith { name: &field.name, number: self.number_of(field), input, about })
        });
        let first = self.model.fields.len();
        let params = self.model.params.iter().enumerate();
        let params = params.filter(|(_, param)| param.part == Some(part) && param.value.is_none());
        let params = params.map(|(k, param)| {
            let text = format!("The parameter `{}{}`", label(&param.name), indices(&param.over));
            let about = about(&param.attributes, &text);
            let input = code!(::mcp_core::language::Table);
            GivenWith { name: &param.name, number: first + k, input, about }
        });
        fields.chain(params).collect()
    }

    /// What a language server reads of heads and targets.
    pub(super) fn occurrences_of_parts(&self) -> TokenStream {
        let model = Self::local("model");
        let targets = self.model.adds.iter().map(|adds| &adds.target);
        let targets = targets.filter(|target| self.model.target(target).is_some());
        let names = self.model.parts.iter().map(|part| &part.name);
        let others =
            self.model.parts.iter().flat_map(|part| part.requires.iter().chain(&part.excludes));
        code! {
            #(let _ = &#model.#targets;)*
            #(let #names = ();)*
            #(let _ = #others;)*
        }
    }
}

/// A field of the type of a part.
struct GivenWith<'m> {
    name: &'m Ident,
    number: usize,
    input: TokenStream,
    about: String,
}
