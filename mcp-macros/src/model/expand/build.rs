//! `build()`: data are resolved, families laid out, and the shape declared.

use super::super::ast::{Field, FieldKind, Index, Param};
use super::super::names::{is_number, is_type};
use super::super::rewrite::wrapping;
use super::families::text;
use super::{Expansion, label};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote_spanned};

impl<'m> Expansion<'m> {
    /// `impl TransportBuilder { fn __build }`
    pub(super) fn build(&self) -> TokenStream {
        let (name, builder) = (&self.model.name, self.builder());
        let body = self.build_body();
        code! {
            #[automatically_derived]
            impl #builder {
                fn __build(mut self) -> ::core::result::Result<#name, ::mcp_core::ModelError> {
                    #body
                }
            }
        }
    }

    fn build_body(&self) -> TokenStream {
        let name = &self.model.name;
        let [model, assembly] = ["model", "assembly"].map(Self::local);
        // Tables are read into the model; everything else first, since it has no default.
        let is_table = |field: &&Field| matches!(field.kind, FieldKind::Table);
        let (tables, data): (Vec<_>, Vec<_>) =
            self.in_order_of_need().into_iter().partition(is_table);
        let tables = tables.into_iter().map(|field| {
            let (name, text) = (&field.name, label(&field.name));
            let sets = &field.over;
            code!(#model.#name.0.set(::mcp_core::language::table(
                #text, &[#(::mcp_core::language::Members::set(&#model.#sets)),*], &self.#name,
            ))?;)
        });
        let data = data.into_iter().map(|field| self.resolve(field));
        let fields = self.model.fields.iter().map(|field| {
            let (name, local) = (&field.name, resolved(&field.name));
            if matches!(field.kind, FieldKind::Table) {
                code!(#name: ::core::default::Default::default(),)
            } else {
                code!(#name: #local,)
            }
        });
        let empty = self.empty_families();
        let params = self.model.params.iter().map(|param| self.param(param, &assembly));
        let vars = self.model.vars.iter().map(|var| self.variable(var, &assembly));
        let lifted = self.lifted().map(|def| Self::lifted_variable(def, &assembly));
        let defs = self.definitions().map(|def| {
            let (name, text) = (&def.name, text(&label(&def.name), &def.attributes));
            let sets = Self::sets_of(&def.over);
            code!(#model.#name.0.set(#assembly.definition(#text, #sets))?;)
        });
        let reports = self.model.reports.iter().map(|report| {
            let (name, text) = (&report.name, text(&label(&report.name), &report.attributes));
            let sets = Self::sets_of(&report.over);
            code!(#model.#name.0.set(#assembly.report(#text, #sets))?;)
        });
        let eqs = self.model.eqs.iter().map(|eq| self.equation(eq, &assembly));
        let lifted_eqs = self.lifted().map(|def| Self::lifted_rows(def, &assembly));
        let start = self.lifted_start(&model);
        code! {
            #(#data)*
            let mut #model = #name {
                __shape: ::mcp_core::Shape::builder().build()?,
                #(#fields)*
                #empty
            };
            let mut #assembly = ::mcp_core::language::Assembly::default();
            #(#tables)*
            #(#params)*
            #(#vars)*
            #(#lifted)*
            #(#defs)*
            #(#reports)*
            #(#eqs)*
            #(#lifted_eqs)*
            #model.__shape = #assembly.build()?;
            #start
            ::core::result::Result::Ok(#model)
        }
    }

    /// The fields of the data, each after the sets it needs.
    fn in_order_of_need(&self) -> Vec<&'m Field> {
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

    /// A field of the data, from what was given.
    fn resolve(&self, field: &Field) -> TokenStream {
        let (name, text, local) = (&field.name, label(&field.name), resolved(&field.name));
        let given = code!(::mcp_core::language::required(#text, self.#name.take())?);
        let members = |set: &Ident| {
            let local = resolved(set);
            code!(::mcp_core::language::Members::set(&#local))
        };
        let value = match &field.kind {
            FieldKind::Set | FieldKind::Ordered | FieldKind::Size => {
                code!(::mcp_core::language::IndexSet::new(
                    ::mcp_core::language::labels(#text, self.#name.take())?
                ))
            }
            FieldKind::Labels(labels) => {
                let labels = labels.iter().map(label);
                code!(::mcp_core::language::IndexSet::new(
                    ::mcp_core::Set::new(#text, [#(#labels),*])?
                ))
            }
            FieldKind::Count(count) => code!(::mcp_core::language::IndexSet::new(
                ::mcp_core::language::Labels::from(#count).into_set(#text)?
            )),
            FieldKind::Subset(larger) => {
                let (set, larger) = (members(larger), resolved(larger));
                code!({
                    let positions = #given.resolve(#text, #set)?;
                    ::mcp_core::language::Subset::new(#text, &#larger, &positions)?
                })
            }
            FieldKind::Pairs(from, to) => {
                let (from_set, to_set) = (members(from), members(to));
                let (from, to) = (resolved(from), resolved(to));
                code!({
                    let (set, ends) = #given.resolve(#text, #from_set, #to_set)?;
                    ::mcp_core::language::Pairs::new(set, &#from, &#to, &ends)
                })
            }
            FieldKind::Map(from, to) => {
                let (from_set, to_set) = (members(from), members(to));
                let (from, to) = (resolved(from), resolved(to));
                code!({
                    let targets = #given.resolve(#text, #from_set, #to_set)?;
                    ::mcp_core::language::Map::new(&#from, &#to, &targets)
                })
            }
            // Read into the model.
            FieldKind::Table => return TokenStream::new(),
            FieldKind::Value(value) if is_type(value, "f64") => {
                code!(::mcp_core::language::scalar(#text, self.#name.take())?)
            }
            FieldKind::Value(value) if is_number(value) => given,
            FieldKind::Value(_) => code!(::std::sync::Arc::new(#given)),
        };
        let stored = match &field.kind {
            FieldKind::Value(_) | FieldKind::Table => None,
            _ => {
                let stored = self.set_type(field);
                Some(code!(: #stored))
            }
        };
        code!(let #local #stored = #value;)
    }

    fn empty_families(&self) -> TokenStream {
        let model = self.model;
        let names = model.params.iter().map(|p| p.name.clone());
        let names = names.chain(model.vars.iter().map(|v| v.name.clone()));
        let names = names.chain(model.defs.iter().map(|d| d.name.clone()));
        let names = names.chain(self.lifted().map(Self::rows_of_lifted));
        let names = names.chain(model.eqs.iter().map(|e| e.name.clone()));
        let names = names.chain(model.reports.iter().map(|r| r.name.clone()));
        code!(#(#names: ::core::default::Default::default(),)*)
    }

    fn param(&self, param: &Param, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let (name, text) = (&param.name, label(&param.name));
        let sets = Self::sets_of(&param.over);
        let values = match &param.value {
            None => {
                code!(::mcp_core::language::table(#text, #sets, &self.#name)?.values().to_vec())
            }
            Some(value) => {
                let value = self.each(&param.over, value);
                code!(match &self.#name {
                    ::core::option::Option::Some(table) => table.resolve(#text, #sets)?,
                    ::core::option::Option::None => {
                        ::mcp_core::language::Layout::new(#text, #sets)?.each(#value)
                    }
                })
            }
        };
        let text = super::families::text(&text, &param.attributes);
        code!(#model.#name.0.set(#assembly.parameter(#text, #sets, #values))?;)
    }

    /// A number for every element: a closure over the positions of its indices.
    pub(super) fn each(&self, over: &[Index], value: &TokenStream) -> TokenStream {
        let (number, offered) = (self.number(value), self.offered_data());
        Self::at_each(over, &code!(#offered #number))
    }

    /// An expression over data as a number; what is no number is shown where it stands.
    pub(super) fn number(&self, value: &TokenStream) -> TokenStream {
        let at = wrapping(value);
        let expression = self.rewriter.expression(value);
        quote_spanned!(at=> ::mcp_core::__private::number(#expression))
    }

    /// Lifted definitions start where they hold.
    fn lifted_start(&self, model: &Ident) -> Option<TokenStream> {
        let (vars, eqs) = (self.model.vars.len(), self.model.eqs.len());
        let lifted: Vec<TokenStream> = (0..self.lifted().count())
            .map(|k| {
                let (variable, equation) = (vars + k, eqs + k);
                code!((#variable, #equation))
            })
            .collect();
        (!lifted.is_empty()).then(|| {
            code! {
                let start = ::mcp_core::language::start_of_lifted(&#model, &[#(#lifted),*]);
                #model.__shape.set_start(&start)?;
            }
        })
    }
}

/// The local that holds a field of the data while the model is built.
fn resolved(field: &Ident) -> Ident {
    format_ident!("given_{}", field, span = Span::mixed_site())
}
