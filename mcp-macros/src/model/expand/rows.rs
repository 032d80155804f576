//! `impl Model`: one generic function for each family of rows.

use super::super::ast::{Body, Index};
use super::super::rewrite::wrapping;
use super::Expansion;
use super::additions::Target;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote_spanned};

/// One row function: where its indices come from, and what it computes.
pub(super) struct Function<'a> {
    pub(super) name: Ident,
    /// Where the family is declared.
    pub(super) declared: Span,
    /// The field that splits a row number into indices; an unfinished equation has none.
    pub(super) rows: Option<Ident>,
    pub(super) over: Vec<&'a Index>,
    pub(super) value: TokenStream,
    /// What a language server shall see beside the value.
    pub(super) also: TokenStream,
}

impl Expansion<'_> {
    /// `impl Model` and the functions it calls.
    pub(super) fn implementation(&self) -> TokenStream {
        let equations = self.equation_functions();
        let definitions = self.definition_functions();
        let reports = self.report_functions();
        let targets = self.targets();
        let (row, def) = (dispatch(&equations, &targets[0]), dispatch(&definitions, &targets[1]));
        let (report, added) = (dispatch(&reports, &[]), self.added_functions(&targets));
        let (name, unfinished) = (&self.model.name, self.unfinished());
        let [equations, definitions, reports] =
            [(equations, true), (definitions, true), (reports, false)].map(
                |(functions, generic)| {
                    functions.iter().map(|f| self.function(f, generic)).collect::<TokenStream>()
                },
            );
        code! {
            #equations
            #definitions
            #reports
            #added
            #unfinished
            #[automatically_derived]
            impl ::mcp_core::Model for #name {
                fn shape(&self) -> &::mcp_core::Shape {
                    &self.__shape
                }
                fn row<D: ::mcp_core::Scalar>(
                    &self, family: usize, index: usize, read: &::mcp_core::Reader<'_, D>,
                ) -> ::mcp_core::Real<D> {
                    #row
                }
                fn def<D: ::mcp_core::Scalar>(
                    &self, family: usize, index: usize, read: &::mcp_core::Reader<'_, D>,
                ) -> ::mcp_core::Real<D> {
                    #def
                }
                fn report(
                    &self, family: usize, index: usize, read: &::mcp_core::Reader<'_, f64>,
                ) -> ::mcp_core::Real<f64> {
                    #report
                }
            }
        }
    }

    fn equation_functions(&self) -> Vec<Function<'_>> {
        let equations = self.model.eqs.iter().map(|eq| Function {
            name: format_ident!("__row_{}", eq.name),
            rows: Some(eq.name.clone()),
            over: eq.over.iter().collect(),
            value: self.body(&eq.body),
            also: self.also(eq.pair.iter().chain(&eq.condition)),
            declared: eq.name.span(),
        });
        let lifted = self.lifted().map(|def| {
            let (name, indices) = (&def.name, def.over.iter().map(|index| &index.name));
            let (model, read) = (Self::local("model"), Self::local("read"));
            let value = self.value(&def.expression);
            Function {
                name: format_ident!("__lifted_{}", def.name),
                rows: Some(Self::rows_of_lifted(def)),
                also: TokenStream::new(),
                over: def.over.iter().collect(),
                value: code!(#model.#name.get(#read, #(#indices),*) - #value),
                declared: def.name.span(),
            }
        });
        equations.chain(lifted).collect()
    }

    fn definition_functions(&self) -> Vec<Function<'_>> {
        let definitions = self.definitions();
        definitions.map(|def| self.plain("def", &def.name, &def.over, &def.expression)).collect()
    }

    fn report_functions(&self) -> Vec<Function<'_>> {
        let reports = self.model.reports.iter();
        reports
            .map(|report| self.plain("report", &report.name, &report.over, &report.expression))
            .collect()
    }

    /// A family whose value is one expression.
    fn plain<'a>(
        &self,
        kind: &str,
        name: &Ident,
        over: &'a [Index],
        expression: &TokenStream,
    ) -> Function<'a> {
        let value = self.value(expression);
        let (rows, declared) = (Some(name.clone()), name.span());
        let (name, also) = (format_ident!("__{}_{}", kind, name), TokenStream::new());
        let over = over.iter().collect();
        Function { name, declared, rows, over, value, also }
    }

    /// `F` of an equation.
    fn body(&self, body: &Body) -> TokenStream {
        match body {
            Body::Expression(tokens) => self.value(tokens),
            Body::Relation { left, relation: _, span, right } => {
                let (left, right) =
                    (self.rewriter.expression(left), self.rewriter.expression(right));
                let minus = quote_spanned!(*span=> -);
                let at = Span::mixed_site().located_at(*span);
                quote_spanned!(at=> ::mcp_core::language::expression((#left) #minus (#right)))
            }
        }
    }

    /// An expression as a number.
    pub(super) fn value(&self, tokens: &TokenStream) -> TokenStream {
        let at = wrapping(tokens);
        let expression = self.rewriter.expression(tokens);
        quote_spanned!(at=> ::mcp_core::language::expression(#expression))
    }

    /// The function of a family; reports are evaluated in plain numbers only.
    pub(super) fn function(&self, function: &Function<'_>, generic: bool) -> TokenStream {
        let Function { name, declared, rows, over, value, also } = function;
        let model_type = &self.model.name;
        let [model, row, read, at] = ["model", "row", "read", "at"].map(Self::local);
        let (parameters, number) = if generic {
            // Shown where rustc explains a type error: at the name of the family.
            let number = Ident::new("D", Span::mixed_site().located_at(*declared));
            (Some(code!(<#number: ::mcp_core::Scalar>)), code!(#number))
        } else {
            (None, code!(f64))
        };
        let indices = over.iter().enumerate().map(|(k, index)| {
            let (name, set) = (&index.name, &index.set);
            let ends = Self::ends(index);
            code! {
                let #name = ::mcp_core::language::Members::ix(&#model.#set, #at[#k]);
                #ends
            }
        });
        let offered = self.offered_names();
        let positions = if let Some(rows) = rows {
            code!(#model.#rows.split(#row))
        } else {
            let rank = over.len();
            code!([0_usize; #rank])
        };
        code! {
            fn #name #parameters(
                #model: &#model_type,
                #row: usize,
                #read: &::mcp_core::Reader<'_, #number>,
            ) -> ::mcp_core::Real<#number> {
                #offered
                let #at = #positions;
                #(#indices)*
                #also
                #value
            }
        }
    }
}

/// Calls the function of a family by its entry.
fn dispatch(functions: &[Function<'_>], targets: &[Target<'_>]) -> TokenStream {
    let plain = functions.iter().map(|function| function.name.clone());
    let arms = plain
        .chain(targets.iter().map(Target::name))
        .enumerate()
        .map(|(k, name)| code!(#k => #name(self, index, read),));
    code! {
        match family {
            #(#arms)*
            _ => ::mcp_core::Real::from(f64::NAN),
        }
    }
}
