//! Families: laid out, and declared in the shape with their bounds, starts and pairs.

use super::super::ast::{Bounds, Def, Eq, Fix, Index, Place, Var};
use super::build::is_literal;
use super::{Expansion, description, label};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident};

impl Expansion<'_> {
    /// Lays a variable family out and declares it.
    pub(super) fn variable(&self, var: &Var, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let (name, sets) = (&var.name, Self::sets_of(&var.over));
        let condition = match &var.condition {
            None => code!(::core::option::Option::None),
            Some(condition) => {
                let condition = self.rewriter.expression(condition);
                let offered = self.offered_data();
                let body = code!(#offered if #condition { true } else { false });
                let condition = Self::at_each(&var.over, &body);
                code!(::core::option::Option::Some(#condition))
            }
        };
        let (lower, upper) = match &var.bounds {
            Bounds::Free => (None, None),
            Bounds::Lower(lower) => (Some(lower), None),
            Bounds::Upper(upper) => (None, Some(upper)),
            Bounds::Box(lower, upper) => (Some(lower), Some(upper)),
        };
        let values = [("Lower", lower), ("Upper", upper), ("Start", var.start.as_ref())];
        let values = values.into_iter().filter_map(|(side, value)| {
            let (side, value) = (format_ident!("{side}"), value?);
            let side = code!(::mcp_core::language::Side::#side);
            Some(if is_literal(value) {
                let number = self.number(value);
                code!(#assembly.constant(#side, #number);)
            } else {
                let value = self.each(&var.over, value);
                code!(#assembly.values(#side, #value);)
            })
        });
        let fixes = self.model.fixes.iter().filter(|fix| fix.variable == var.name);
        let fixes = fixes.map(|fix| Self::within(fix.part, assembly, self.fix(fix, assembly)));
        let text = text(&label(name), &var.attributes);
        let family = code! {
            #assembly.variables(#text, #sets, #condition).fill(&mut #model.#name.0);
            #(#values)*
        };
        let family = Self::within(var.part, assembly, family);
        code!(#family #(#fixes)*)
    }

    /// One `fix` item, on the values of its family.
    fn fix(&self, fix: &Fix, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let (variable, value) = (&fix.variable, self.number(&fix.value));
        let text = label(variable);
        let places = fix.places.iter().map(|place| match place {
            Place::Every(index) => index.name.to_token_stream(),
            Place::One(tokens) => self.rewriter.expression(tokens),
        });
        let over: Vec<&Index> = fix.places.iter().filter_map(Place::index).collect();
        let sets = Self::sets_of(over.iter().copied());
        let body = code!((#model.#variable.place(#(#places),*), #value));
        let at_each = Self::at_each(over, &body);
        code!(#assembly.fix(#text, #sets, #at_each);)
    }

    pub(super) fn lifted_variable(def: &Def, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let (name, sets) = (&def.name, Self::sets_of(&def.over));
        let text = text(&label(name), &def.attributes);
        code! {
            #assembly
                .variables(#text, #sets, ::core::option::Option::None)
                .fill(&mut #model.#name.0);
        }
    }

    /// Which rows an equation has, and what they are paired with.
    pub(super) fn equation(&self, eq: &Eq, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let (name, variable) = (&eq.name, &eq.variable);
        let paired = label(variable);
        let sets = Self::sets_of(&eq.over);
        let pieces = eq.pair.iter().map(|piece| self.rewriter.expression(piece));
        let place = code!(#model.#variable.place);
        let place = code!(#place(#(#pieces),*));
        let body = match &eq.condition {
            None => place,
            Some(condition) => {
                let condition = self.rewriter.expression(condition);
                code!(if #condition { #place } else { ::core::option::Option::None })
            }
        };
        let at_each = Self::at_each(&eq.over, &body);
        let declared = text(&label(name), &eq.attributes);
        if self.is_paired_in_order(eq) {
            let like = if self.has_condition(variable) {
                code!(::core::option::Option::Some(&#model.#variable.0))
            } else {
                code!(::core::option::Option::None)
            };
            return code! {
                #assembly
                    .equation_like(#declared, #sets, #paired, #like)
                    .fill(&mut #model.#name.0);
                #[cfg(rust_analyzer)]
                #assembly.equation(#declared, #sets, #paired, #at_each);
            };
        }
        code! {
            #assembly.equation(#declared, #sets, #paired, #at_each).fill(&mut #model.#name.0);
        }
    }

    /// Whether an equation without condition has the sets of its variable, and each combination is
    /// paired with the element of the same: then there is nothing to compute.
    fn is_paired_in_order(&self, eq: &Eq) -> bool {
        let sets = |over: &[Index]| over.iter().map(|index| index.set.clone()).collect::<Vec<_>>();
        let variables = self.model.vars.iter().map(|var| (&var.name, &var.over));
        let mut variables = variables.chain(self.lifted().map(|def| (&def.name, &def.over)));
        let has_its_sets =
            variables.any(|(name, over)| *name == eq.variable && sets(over) == sets(&eq.over));
        let indices: Vec<String> = eq.over.iter().map(|index| index.name.to_string()).collect();
        let pieces: Vec<String> = eq.pair.iter().map(ToString::to_string).collect();
        eq.condition.is_none() && has_its_sets && indices == pieces
    }

    pub(super) fn lifted_rows(def: &Def, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let rows = Self::rows_of_lifted(def);
        let (sets, paired) = (Self::sets_of(&def.over), label(&def.name));
        let declared = text(&Self::lifted_equation(def), &def.attributes);
        code!(#assembly.lifted(#declared, #sets, #paired).fill(&mut #model.#rows.0);)
    }
}

/// `&["x", "description", "unit"]`
pub(super) fn text(name: &str, attributes: &[syn::Attribute]) -> TokenStream {
    let (about, unit) = description(attributes);
    code!(&[#name, #about, #unit])
}
