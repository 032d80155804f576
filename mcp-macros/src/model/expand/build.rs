//! `build()`: data are resolved, families laid out, and the shape declared.

use super::super::ast::{Field, FieldKind, Index, Param};
use super::super::names::{is_number, is_type};
use super::super::rewrite::wrapping;
use super::families::text;
use super::items::Family;
use super::{Expansion, label};
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote_spanned};

impl<'m> Expansion<'m> {
    /// `impl TransportBuilder { fn __build }`
    pub(super) fn build(&self) -> TokenStream {
        let (name, builder) = (&self.model.name, self.builder());
        let (body, of_parts) = (self.build_body(), self.with_and_lay_out());
        code! {
            #[automatically_derived]
            impl #builder {
                fn __build(self) -> ::core::result::Result<#name, ::mcp_core::ModelError> {
                    #body
                }
            }
            #of_parts
        }
    }

    fn build_body(&self) -> TokenStream {
        let name = &self.model.name;
        let [model, assembly] = ["model", "assembly"].map(Self::local);
        // Tables are read into the model; everything else first, since it has no default.
        let is_table = |field: &&Field| matches!(field.kind, FieldKind::Table);
        let (tables, data): (Vec<_>, Vec<_>) =
            self.in_order_of_need().into_iter().partition(is_table);
        let tables = tables.into_iter().map(|field| self.table(field, &assembly));
        let data = data.into_iter().map(|field| self.resolved_field(field, &assembly));
        let fields = self.model.fields.iter().map(|field| {
            let (name, local) = (&field.name, resolved(&field.name));
            if matches!(field.kind, FieldKind::Table) {
                code!(#name: ::mcp_core::language::Data::EMPTY,)
            } else {
                code!(#name: #local,)
            }
        });
        let empty = self.empty_families();
        if self.has_parts() {
            let (parts, additions) = (self.part_texts(), self.empty_additions());
            return code! {
                let mut #assembly = self.__given;
                #(#data)*
                let mut #model = #name {
                    #(#fields)*
                    #empty
                    #additions
                    __parts: ::mcp_core::language::Parts::off(#parts),
                    __shape: ::mcp_core::language::Assembly::no_shape(),
                };
                #(#tables)*
                #model.__lay_out(#assembly)
            };
        }
        let (families, start) = (self.lay_out(&assembly), self.lifted_start(&model));
        code! {
            let mut #assembly = self.__given;
            #(#data)*
            let mut #model = #name {
                #(#fields)*
                #empty
                __shape: ::mcp_core::language::Assembly::no_shape(),
            };
            #(#tables)*
            #families
            #assembly.finish(&mut #model.__shape)?;
            #start
            ::core::result::Result::Ok(#model)
        }
    }

    /// A table of the data, read into the model.
    pub(super) fn table(&self, field: &Field, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let (name, text, number) = (&field.name, label(&field.name), self.number_of(field));
        let sets = &field.over;
        let table = code! {
            #assembly
                .table(#number, #text, &[#(::mcp_core::language::Members::set(&#model.#sets)),*])
                .fill(&mut #model.#name.0);
        };
        Self::within(field.part, assembly, table)
    }

    /// Families laid out and declared, each kind in its order.
    pub(super) fn lay_out(&self, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let params = self.model.params.iter().enumerate();
        let params = params
            .map(|(k, param)| Self::within(param.part, assembly, self.param(k, param, assembly)));
        let vars = self.model.vars.iter().map(|var| self.variable(var, assembly));
        let lifted = self
            .lifted()
            .map(|def| Self::within(def.part, assembly, Self::lifted_variable(def, assembly)));
        let defs = self.definitions().map(|def| {
            let (name, text) = (&def.name, text(&label(&def.name), &def.attributes));
            let sets = Self::sets_of(&def.over);
            let definition = code!(#assembly.definition(#text, #sets).fill(&mut #model.#name.0););
            Self::within(def.part, assembly, definition)
        });
        let reports = self.model.reports.iter().map(|report| {
            let (name, text) = (&report.name, text(&label(&report.name), &report.attributes));
            let sets = Self::sets_of(&report.over);
            let report_family = code!(#assembly.report(#text, #sets).fill(&mut #model.#name.0););
            Self::within(report.part, assembly, report_family)
        });
        let eqs = self
            .model
            .eqs
            .iter()
            .map(|eq| Self::within(eq.part, assembly, self.equation(eq, assembly)));
        let lifted_eqs = self
            .lifted()
            .map(|def| Self::within(def.part, assembly, Self::lifted_rows(def, assembly)));
        let additions = self.additions(assembly);
        code! {
            #(#params)*
            #(#vars)*
            #(#lifted)*
            #(#defs)*
            #(#reports)*
            #(#eqs)*
            #(#lifted_eqs)*
            #additions
        }
    }

    /// The fields of the data, each after the sets it needs.
    pub(super) fn in_order_of_need(&self) -> Vec<&'m Field> {
        let mut waiting: Vec<&Field> = self.model.fields.iter().collect();
        let mut ordered: Vec<&Field> = Vec::new();
        while !waiting.is_empty() {
            let is_ready = |field: &&Field| {
                let mut needs = field.over.iter().chain(field.kind.sets());
                needs.all(|set| ordered.iter().any(|done| done.name == *set))
            };
            let (ready, rest): (Vec<&Field>, Vec<&Field>) = waiting.into_iter().partition(is_ready);
            if ready.is_empty() {
                break;
            }
            ordered.extend(ready);
            waiting = rest;
        }
        ordered
    }

    /// A field of the data in a local, from what was given.
    fn resolved_field(&self, field: &Field, assembly: &Ident) -> TokenStream {
        let local = resolved(&field.name);
        let value = self.resolve(field, assembly, &|set| resolved(set).into_token_stream());
        let stored = match &field.kind {
            // Read into the model.
            FieldKind::Table => return TokenStream::new(),
            FieldKind::Value(_) => None,
            _ => {
                let stored = self.set_type(field);
                Some(code!(: #stored))
            }
        };
        Self::within(field.part, assembly, code!(let #local #stored = #value;))
    }

    /// A field of the data, no table, from what was given and the sets that are there already.
    pub(super) fn resolve(
        &self,
        field: &Field,
        assembly: &Ident,
        set: &dyn Fn(&Ident) -> TokenStream,
    ) -> TokenStream {
        let (name, text) = (&field.name, label(&field.name));
        let number = self.number_of(field);
        let members = |of: &Ident| {
            let set = set(of);
            code!(::mcp_core::language::Members::set(&#set))
        };
        match &field.kind {
            FieldKind::Set | FieldKind::Ordered | FieldKind::Size => {
                code!(::mcp_core::language::IndexSet::new(#assembly.set(#number, #text)))
            }
            FieldKind::Labels(labels) => {
                let labels = labels.iter().map(label);
                code!(::mcp_core::language::IndexSet::new(#assembly.labels(#text, &[#(#labels),*])))
            }
            FieldKind::Count(count) => {
                code!(::mcp_core::language::IndexSet::new(#assembly.count(#text, #count)))
            }
            FieldKind::Subset(larger) => {
                let (members, larger) = (members(larger), set(larger));
                code!({
                    let (set, positions) = #assembly.subset(#number, #text, #members);
                    ::mcp_core::language::Subset::new(set, &#larger, positions)
                })
            }
            FieldKind::Pairs(from, to) => {
                let (from_set, to_set) = (members(from), members(to));
                let (from, to) = (set(from), set(to));
                code!({
                    let (set, ends) = #assembly.pairs(#number, #text, [#from_set, #to_set]);
                    ::mcp_core::language::Pairs::new(set, &#from, &#to, ends)
                })
            }
            FieldKind::Map(from, to) => {
                let (from_set, to_set) = (members(from), members(to));
                let (from, to) = (set(from), set(to));
                code!({
                    let targets = #assembly.map(#number, #text, [#from_set, #to_set]);
                    ::mcp_core::language::Map::new(&#from, &#to, targets)
                })
            }
            FieldKind::Table => TokenStream::new(),
            FieldKind::Value(value) if is_type(value, "f64") => {
                code!(#assembly.number(#number, #text))
            }
            FieldKind::Value(value) if is_number(value) => {
                code!(#assembly.required(#text, self.#name)?)
            }
            FieldKind::Value(_) => {
                code!(::std::sync::Arc::new(#assembly.required(#text, self.#name)?))
            }
        }
    }

    pub(super) fn empty_families(&self) -> TokenStream {
        let families = self.families().map(|Family { name, kind, .. }| {
            let kind = format_ident!("{kind}");
            code!(#name: ::mcp_core::language::#kind::EMPTY,)
        });
        families.collect()
    }

    fn param(&self, k: usize, param: &Param, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let (name, text) = (&param.name, text(&label(&param.name), &param.attributes));
        let (number, sets) = (self.model.fields.len() + k, Self::sets_of(&param.over));
        let values = match &param.value {
            None => code!(::core::option::Option::None),
            Some(value) => {
                let value = self.each(&param.over, value);
                code!(::core::option::Option::Some(#value))
            }
        };
        code! {
            #assembly.parameter(#number, #text, #sets, #values).fill(&mut #model.#name.0);
        }
    }

    /// The number under which a field is given.
    pub(super) fn number_of(&self, field: &Field) -> usize {
        self.model.fields.iter().take_while(|other| other.name != field.name).count()
    }

    /// A number for every element: a closure over the positions of its indices.
    pub(super) fn each(&self, over: &[Index], value: &TokenStream) -> TokenStream {
        let number = self.number(value);
        if is_literal(value) {
            return code!(&|_: &::mcp_core::language::At| #number);
        }
        let offered = self.offered_data();
        Self::at_each(over, &code!(#offered #number))
    }

    /// An expression over data as a number; what is no number is shown where it stands.
    pub(super) fn number(&self, value: &TokenStream) -> TokenStream {
        let at = wrapping(value);
        let expression = self.rewriter.expression(value);
        quote_spanned!(at=> ::mcp_core::__private::number(#expression))
    }

    /// Lifted definitions start where they hold.
    pub(super) fn lifted_start(&self, model: &Ident) -> Option<TokenStream> {
        let (vars, eqs) = (self.model.vars.len(), self.model.eqs.len());
        let lifted: Vec<TokenStream> = (0..self.lifted().count())
            .map(|k| {
                let (variable, equation) = (vars + k, eqs + k);
                code!((#variable, #equation))
            })
            .collect();
        let families = code!(&[#(#lifted),*]);
        (!lifted.is_empty()).then(|| {
            if self.has_parts() {
                return code! {
                    let start = #model.__parts.start_of_lifted(&#model, #families);
                    #model.__parts.start_at(&start, &mut #model.__shape)?;
                };
            }
            code! {
                let start = ::mcp_core::language::start_of_lifted(&#model, #families);
                #model.__shape.set_start(&start)?;
            }
        })
    }
}

/// Whether this is one literal, which reads no index.
pub(super) fn is_literal(value: &TokenStream) -> bool {
    let mut tokens = value.clone().into_iter();
    matches!((tokens.next(), tokens.next()), (Some(TokenTree::Literal(_)), None))
}

/// The local that holds a field of the data while the model is built.
fn resolved(field: &Ident) -> Ident {
    format_ident!("given_{}", field, span = Span::mixed_site())
}
