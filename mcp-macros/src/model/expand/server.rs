//! What only a language server reads: names to complete, and every occurrence of a name where it can
//! be renamed together with the others. The compiler drops it all.

use super::super::ast::FieldKind;
use super::super::rewrite::sets_in;
use super::Expansion;
use super::rows::Function;
use proc_macro2::{Ident, Span, TokenStream};
use quote::format_ident;

impl Expansion<'_> {
    /// Locals for all declared names.
    pub(super) fn offered_names(&self) -> TokenStream {
        let model = Self::local("model");
        let families = self.model.vars.iter().map(|var| &var.name);
        let names = families.chain(self.model.defs.iter().map(|def| &def.name));
        let data = self.offered_data();
        code!(#data #(#[cfg(rust_analyzer)] let #names = &#model.#names;)*)
    }

    /// Locals for what expressions over data may read.
    pub(super) fn offered_data(&self) -> TokenStream {
        let (model, module) = (Self::local("model"), &self.rewriter.module);
        let fields = self.model.fields.iter().map(|field| &field.name);
        let names = fields.chain(self.model.params.iter().map(|param| &param.name));
        let labels = self.model.fields.iter().map(|field| {
            let FieldKind::Labels(labels) = &field.kind else { return TokenStream::new() };
            let set = &field.name;
            code!(#(#[cfg(rust_analyzer)] let #labels = #module::#set::#labels;)*)
        });
        let labels: TokenStream = labels.collect();
        code!(#(#[cfg(rust_analyzer)] let #names = &#model.#names;)* #labels)
    }

    /// Expressions that read the same indices as others, but in another function.
    pub(super) fn also<'t>(&self, read: impl Iterator<Item = &'t TokenStream>) -> TokenStream {
        let read = read.map(|tokens| self.rewriter.expression(tokens));
        code!(#(#[cfg(rust_analyzer)] let _ = #read;)*)
    }

    /// Equations that are being written.
    pub(super) fn unfinished(&self) -> TokenStream {
        let unfinished = self.model.lost.bodies.iter().enumerate().map(|(k, (over, tokens))| {
            let name = format_ident!("__unfinished_{k}");
            let value = self.value(tokens);
            let (declared, also) = (Span::mixed_site(), TokenStream::new());
            let over = over.iter().collect();
            let function = Function { name, declared, rows: None, over, value, also };
            let function = self.function(&function, true);
            code!(#[cfg(rust_analyzer)] #function)
        });
        unfinished.collect()
    }

    /// Places where a name stands in the text, but in the expansion only as a field, only as a type,
    /// or in several functions.
    pub(super) fn occurrences(&self) -> TokenStream {
        let (model, model_type) = (Self::local("model"), &self.model.name);
        let module = &self.rewriter.module;
        let fields = self.model.fields.iter();
        let fields = fields.flat_map(|field| field.over.iter().chain(field.kind.sets()));
        let fields = fields.chain(self.model.fixes.iter().map(|fix| &fix.variable));
        let parts = self.occurrences_of_parts();
        let types: Vec<Ident> = self
            .model
            .expressions()
            .flat_map(|tokens| sets_in(self.rewriter.names, tokens))
            .collect();
        let vars = self.model.vars.iter().map(|var| {
            let bounds = var.bounds.values().into_iter();
            let values = bounds.chain(&var.start).chain(&var.condition);
            let (offered, values) = (self.offered_data(), self.also(values));
            Self::for_each(&var.over, code!({ #offered #values }))
        });
        code! {
            #[cfg(rust_analyzer)]
            fn __occurrences(#model: &#model_type) {
                #(let _ = &#model.#fields;)*
                #(let _: ::core::option::Option<#module::#types>;)*
                #(#vars)*
                #parts
            }
        }
    }
}
