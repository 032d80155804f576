//! What parts add to equations and definitions.
//!
//! A family with terms of parts that are on has an entry of its own in `Model::row` and `Model::def`,
//! chosen when the shape is built: without them the function of the family is called as if there were
//! no parts.

use super::super::ast::{Adds, Place};
use super::rows::Function;
use super::{Expansion, label};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident};

/// A family that parts add terms to.
pub(super) struct Target<'m> {
    /// The field with its rows.
    rows: Ident,
    /// Its name in the shape.
    text: String,
    /// The function that computes it without parts.
    function: Ident,
    /// The entry that computes it with what is added.
    entry: usize,
    /// Whether the terms are subtracted: a lifted definition is the row `v − expression`.
    is_lifted: bool,
    /// What is added, by its number among all, in the order of the text.
    adds: Vec<(usize, &'m Adds)>,
    /// Its number among those with additions.
    number: usize,
}

impl<'m> Expansion<'m> {
    /// Equations with additions, and definitions with additions.
    pub(super) fn targets(&self) -> [Vec<Target<'m>>; 2] {
        let mut count = 0;
        let mut target = |name: &Ident, rows: Ident, text: String, function: Ident, is_lifted| {
            let adds = self.model.adds.iter().enumerate();
            let adds: Vec<_> = adds.filter(|(_, adds)| adds.target == *name).collect();
            let (number, is_target) = (count, !adds.is_empty());
            count += usize::from(is_target);
            is_target.then_some(Target { rows, text, function, entry: 0, is_lifted, adds, number })
        };
        let mut equations = Vec::new();
        for eq in &self.model.eqs {
            let function = format_ident!("__row_{}", eq.name);
            equations.extend(target(&eq.name, eq.name.clone(), label(&eq.name), function, false));
        }
        for def in self.lifted() {
            let (rows, text) = (Self::rows_of_lifted(def), Self::lifted_equation(def));
            let function = format_ident!("__lifted_{}", def.name);
            equations.extend(target(&def.name, rows, text, function, true));
        }
        let mut definitions = Vec::new();
        for def in self.definitions() {
            let function = format_ident!("__def_{}", def.name);
            definitions.extend(target(
                &def.name,
                def.name.clone(),
                label(&def.name),
                function,
                false,
            ));
        }
        let first = [self.model.eqs.len() + self.lifted().count(), self.definitions().count()];
        for (targets, first) in [&mut equations, &mut definitions].into_iter().zip(first) {
            for (k, target) in targets.iter_mut().enumerate() {
                target.entry = first + k;
            }
        }
        [equations, definitions]
    }

    /// The rows that each addition reaches.
    pub(super) fn additions(&self, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let additions = self.targets().into_iter().flatten().flat_map(|target| {
            let Target { rows, text, entry, number, .. } = target;
            let additions = target.adds.into_iter().map(|(k, adds)| {
                let (over, sets) = (adds.over(), Self::sets_of(adds.over()));
                let places = adds.places.iter().map(|place| match place {
                    Place::Every(index) => index.name.to_token_stream(),
                    Place::One(tokens) => self.rewriter.expression(tokens),
                });
                let at_each = Self::at_each(over, &code!(#model.#rows.place(#(#places),*)));
                let (field, k) = (added_field(k), term_number(k));
                let addition = code! {
                    let rows = ::mcp_core::language::Elements::count(&#model.#rows.0);
                    #model.#field.0 =
                        #assembly.addition((#text, #number, rows, #entry), #k, #sets, #at_each);
                };
                Self::within(Some(adds.part), assembly, addition)
            });
            additions.collect::<Vec<_>>()
        });
        additions.collect()
    }

    /// The functions of what is added, and of the families with it.
    pub(super) fn added_functions(&self, targets: &[Vec<Target<'_>>; 2]) -> TokenStream {
        let terms = self.model.adds.iter().enumerate().map(|(k, adds)| self.term(k, adds));
        let sums = targets.iter().flatten().map(|target| self.with_added(target));
        terms.chain(sums).collect()
    }

    /// A family with what is added to it: a row runs over its own terms.
    fn with_added(&self, target: &Target<'_>) -> TokenStream {
        let (name, function, type_name) = (target.name(), &target.function, &self.model.name);
        let [model, row, read] = ["model", "row", "read"].map(Self::local);
        let sign = if target.is_lifted { code!(-) } else { code!(+) };
        let number = target.number;
        let value = |k: usize| {
            let term = term_name(k);
            code!(#term(#model, term.combination(), #read))
        };
        let value = if let [(k, _)] = target.adds[..] {
            value(k)
        } else {
            let arms = target.adds.iter().map(|&(k, _)| {
                let (number, value) = (term_number(k), value(k));
                code!(#number => #value,)
            });
            code!(match term.addition { #(#arms)* _ => continue })
        };
        code! {
            fn #name<D: ::mcp_core::Scalar>(
                #model: &#type_name,
                #row: usize,
                #read: &::mcp_core::Reader<'_, D>,
            ) -> ::mcp_core::Real<D> {
                let mut value = #function(#model, #row, #read);
                for term in #model.__parts.added(#number, #row) {
                    value = value #sign #value;
                }
                value
            }
        }
    }

    /// One addition: its expression, for a combination of its indices.
    fn term(&self, k: usize, adds: &Adds) -> TokenStream {
        let function = Function {
            name: term_name(k),
            declared: adds.target.span(),
            rows: Some(added_field(k)),
            over: adds.over(),
            value: self.value(&adds.expression),
            also: self.also(adds.picks()),
        };
        self.function(&function, true)
    }
}

impl Target<'_> {
    /// The function that computes it with what is added.
    pub(super) fn name(&self) -> Ident {
        format_ident!("__added{}", self.function)
    }
}

/// The field with the rows that an addition reaches.
pub(super) fn added_field(k: usize) -> Ident {
    format_ident!("__added_{k}")
}

/// The number of an addition in its terms.
fn term_number(k: usize) -> u32 {
    u32::try_from(k).unwrap_or(u32::MAX)
}

/// The function of an addition.
fn term_name(k: usize) -> Ident {
    format_ident!("__term_{k}")
}
