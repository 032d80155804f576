//! Families: laid out, and declared in the shape with their bounds, starts and pairs.

use super::super::ast::{Bounds, Def, Eq, Fix, Index, Place, Var};
use super::{Expansion, description, label};
use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;

impl Expansion<'_> {
    /// Lays a variable family out and declares it.
    pub(super) fn variable(&self, var: &Var, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let (name, text) = (&var.name, label(&var.name));
        let sets = Self::sets_of(&var.over);
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
        let bound = |value: &TokenStream| {
            let value = self.each(&var.over, value);
            code!(#model.#name.0.each(#value))
        };
        let (lower, upper) = match &var.bounds {
            Bounds::Free => (None, None),
            Bounds::Lower(lower) => (Some(bound(lower)), None),
            Bounds::Upper(upper) => (None, Some(bound(upper))),
            Bounds::Box(lower, upper) => (Some(bound(lower)), Some(bound(upper))),
        };
        let lower = lower.map(|lower| code!(#assembly.values.lower = #lower;));
        let upper = upper.map(|upper| code!(#assembly.values.upper = #upper;));
        let start = var.start.as_ref().map(|start| {
            let start = bound(start);
            code!(#assembly.values.start = #start;)
        });
        let fixes = self.model.fixes.iter().filter(|fix| fix.variable == var.name);
        let fixes = fixes.map(|fix| self.fix(fix, assembly));
        let declared = self::text(&text, &var.attributes);
        code! {
            #model.#name.0.set(#assembly.variables(#text, #sets, #condition))?;
            #lower
            #upper
            #start
            #(#fixes)*
            #assembly.declare(#declared, #sets, &#model.#name.0);
        }
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
        code!(#assembly.fix(#text, #sets, #at_each)?;)
    }

    pub(super) fn lifted_variable(def: &Def, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let (name, text, sets) = (&def.name, label(&def.name), Self::sets_of(&def.over));
        let declared = self::text(&text, &def.attributes);
        code! {
            #model.#name.0.set(#assembly.variables(#text, #sets, ::core::option::Option::None))?;
            #assembly.declare(#declared, #sets, &#model.#name.0);
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
        code!(#model.#name.0.set(#assembly.equation(#declared, #sets, #paired, #at_each))?;)
    }

    pub(super) fn lifted_rows(def: &Def, assembly: &Ident) -> TokenStream {
        let model = Self::local("model");
        let rows = Self::rows_of_lifted(def);
        let (sets, paired) = (Self::sets_of(&def.over), label(&def.name));
        let declared = text(&Self::lifted_equation(def), &def.attributes);
        code!(#model.#rows.0.set(#assembly.lifted(#declared, #sets, #paired))?;)
    }
}

/// `["x", "description", "unit"]`
pub(super) fn text(name: &str, attributes: &[syn::Attribute]) -> TokenStream {
    let (about, unit) = description(attributes);
    code!([#name, #about, #unit])
}
