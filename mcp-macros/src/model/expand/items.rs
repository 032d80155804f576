//! The struct of the model, and its methods.

use super::super::ast::{Eq, Field, FieldKind, Index};
use super::super::names::is_number;
use super::{Expansion, description, label};
use proc_macro2::{Ident, TokenStream};
use quote::format_ident;
use syn::Attribute;

/// A family as a field of the struct.
pub(super) struct Family<'m> {
    pub(super) name: Ident,
    /// Its type in `mcp_core::language`.
    pub(super) kind: &'static str,
    pub(super) over: &'m [Index],
    /// Whether some combinations may have no element.
    pub(super) is_sparse: bool,
}

impl Expansion<'_> {
    /// Name of the builder.
    pub(super) fn builder(&self) -> Ident {
        format_ident!("{}Builder", self.model.name)
    }
    /// Struct, builder and view.
    pub(super) fn items(&self) -> TokenStream {
        let (structure, builder, view) = (self.structure(), self.builder_items(), self.view());
        let methods = self.methods();
        code! {
            #structure
            #builder
            #view
            #methods
        }
    }

    fn structure(&self) -> TokenStream {
        let super::super::ast::Model { attributes, visibility, name, .. } = self.model;
        // What drops without failing first: an unwinding drop is compiled for all that follows.
        let is_table = |field: &&Field| matches!(field.kind, FieldKind::Table);
        let (tables, fields): (Vec<_>, Vec<_>) = self.model.fields.iter().partition(is_table);
        let [tables, fields] = [tables, fields].map(|fields| {
            let field = |field: &Field| {
                let (name, stored) = (&field.name, self.stored(field));
                code!(#name: #stored,)
            };
            fields.into_iter().map(field).collect::<TokenStream>()
        });
        let families = self.families().map(|Family { name, kind, over, is_sparse }| {
            let (kind, sets) = (format_ident!("{kind}"), self.header(over));
            let sparse = is_sparse.then(|| code!(::mcp_core::language::Sparse));
            code!(#name: ::mcp_core::language::#kind<#sets, #sparse>,)
        });
        let (contents, of_parts) = (self.contents(), self.fields_of_parts());
        code! {
            #(#attributes)*
            #[doc = #contents]
            #[allow(non_snake_case, clippy::struct_field_names, reason = "fields are called as in the text of the model")]
            #[derive(::core::clone::Clone)]
            #visibility struct #name {
                #(#families)*
                #tables
                #fields
                #of_parts
                __shape: ::mcp_core::Shape,
            }
        }
    }

    /// A field of the data as it is stored.
    fn stored(&self, field: &Field) -> TokenStream {
        match &field.kind {
            FieldKind::Table => {
                let sets = self.tuple(field.over.iter());
                code!(::mcp_core::language::Data<#sets>)
            }
            FieldKind::Value(value) if is_number(value) => code!(#value),
            FieldKind::Value(value) => code!(::std::sync::Arc<#value>),
            _ => self.set_type(field),
        }
    }

    /// All families.
    pub(super) fn families(&self) -> impl Iterator<Item = Family<'_>> {
        let model = self.model;
        let family = |name: &Ident, kind, over, is_sparse| {
            let name = name.clone();
            Family { name, kind, over, is_sparse }
        };
        let all = move |name: &Ident, kind, over| family(name, kind, over, false);
        let params = model.params.iter().map(move |p| all(&p.name, "Parameters", &p.over[..]));
        let vars = model.vars.iter();
        let vars = vars.map(move |v| family(&v.name, "Variables", &v.over, v.condition.is_some()));
        let lifted = self.lifted().map(move |d| all(&d.name, "Variables", &d.over));
        let rows = self.lifted().map(move |d| all(&Self::rows_of_lifted(d), "Rows", &d.over));
        let defs = self.definitions().map(move |d| all(&d.name, "Definitions", &d.over));
        let eqs = model.eqs.iter();
        let eqs = eqs.map(move |e| family(&e.name, "Rows", &e.over, self.may_lack_rows(e)));
        let reports = model.reports.iter().map(move |r| all(&r.name, "Rows", &r.over));
        params.chain(vars).chain(lifted).chain(rows).chain(defs).chain(eqs).chain(reports)
    }

    /// Whether an equation has no row for some combinations, or its variable no element.
    fn may_lack_rows(&self, eq: &Eq) -> bool {
        eq.condition.is_some() || self.has_condition(&eq.variable)
    }
    /// Whether a variable family has a condition.
    pub(super) fn has_condition(&self, variable: &Ident) -> bool {
        self.model.vars.iter().any(|var| var.name == *variable && var.condition.is_some())
    }

    /// What the model consists of, for its documentation.
    fn contents(&self) -> String {
        let mut text = String::from("\n\n| | |\n| --- | --- |\n");
        let mut row = |kind: &str,
                       name: &Ident,
                       over: &[Index],
                       attributes: &[Attribute],
                       part: Option<usize>| {
            let (about, unit) = description(attributes);
            let of = part.map(|part| format!(" of part `{}`", label(&self.model.parts[part].name)));
            let of = of.unwrap_or_default();
            let unit = if unit.is_empty() { String::new() } else { format!(" \\[{unit}\\]") };
            let line = format!("| {kind} `{name}{}`{of} | {about}{unit} |\n", indices(over));
            text.push_str(&line);
        };
        let model = self.model;
        for var in &model.vars {
            row("var", &var.name, &var.over, &var.attributes, var.part);
        }
        for def in &model.defs {
            row("def", &def.name, &def.over, &def.attributes, def.part);
        }
        for eq in &model.eqs {
            row("eq", &eq.name, &eq.over, &eq.attributes, eq.part);
        }
        for report in &model.reports {
            row("report", &report.name, &report.over, &report.attributes, report.part);
        }
        text
    }

    /// Changes by name, passed on to the shape.
    fn methods(&self) -> TokenStream {
        let (visibility, name, builder) =
            (&self.model.visibility, &self.model.name, self.builder());
        let with = self.with();
        let by_name = [
            ("fix", "Fixes a variable, or all of a family, by name: `Shape::fix`.", "value"),
            ("set_lower", "Changes a lower bound by name: `Shape::set_lower`.", "lower"),
            ("set_upper", "Changes an upper bound by name: `Shape::set_upper`.", "upper"),
            ("set_start_of", "Changes a start by name: `Shape::set_start_of`.", "value"),
        ]
        .map(|(method, about, value)| {
            let (method, value) = (format_ident!("{method}"), format_ident!("{value}"));
            let errors = format!("\n\n# Errors\nAs `Shape::{method}`.");
            code! {
                #[doc = #about]
                #[doc = #errors]
                #visibility fn #method(
                    &mut self, name: &str, #value: f64,
                ) -> ::core::result::Result<(), ::mcp_core::ModelError> {
                    self.__shape.#method(name, #value)
                }
            }
        });
        code! {
            #[automatically_derived]
            impl #name {
                /// Takes the data, by name.
                #visibility fn builder() -> #builder {
                    ::core::default::Default::default()
                }
                #(#by_name)*
                #with
                /// Changes the values of a parameter family: `Shape::set_parameter`.
                ///
                /// # Errors
                /// As `Shape::set_parameter`.
                #visibility fn set_parameter(
                    &mut self, name: &str, values: &[f64],
                ) -> ::core::result::Result<(), ::mcp_core::ModelError> {
                    self.__shape.set_parameter(name, values)
                }
                /// Starts from a solution of this or another model, by name: `Shape::start_from`. Returns
                /// how many variables found their level there.
                ///
                /// # Errors
                /// As `Shape::start_from`.
                #visibility fn start_from(
                    &mut self, other: &::mcp_core::Solution,
                ) -> ::core::result::Result<usize, ::mcp_core::ModelError> {
                    self.__shape.start_from(other)
                }
            }
            #[automatically_derived]
            impl ::core::fmt::Debug for #name {
                fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                    f.debug_struct(::core::stringify!(#name)).finish_non_exhaustive()
                }
            }
        }
    }
}

/// The description of a field: the user's own and what it is.
pub(super) fn about(attributes: &[Attribute], what: &str) -> String {
    match description(attributes) {
        (about, _) if about.is_empty() => format!("{what}."),
        (about, unit) if unit.is_empty() => format!("{what}: {about}."),
        (about, unit) => format!("{what}: {about} \\[{unit}\\]."),
    }
}

/// The input type of `mcp_core::language` that a field is given as, and what it is called; none for numbers,
/// and for what the text itself gives.
pub(super) fn input_type(field: &Field) -> Option<(Ident, &'static str)> {
    let (input, what) = match &field.kind {
        FieldKind::Set | FieldKind::Ordered | FieldKind::Size => ("Labels", "set"),
        FieldKind::Subset(_) => ("LabelSubset", "subset"),
        FieldKind::Pairs(..) => ("LabelPairs", "pairs"),
        FieldKind::Map(..) => ("LabelMap", "map"),
        FieldKind::Table => ("Table", "table"),
        FieldKind::Value(_) | FieldKind::Labels(_) | FieldKind::Count(_) => return None,
    };
    Some((format_ident!("{input}"), what))
}

/// `[plants, markets]`, or nothing.
pub(super) fn sets_of(field: &Field) -> String {
    let sets: Vec<String> = field.over.iter().map(ToString::to_string).collect();
    if sets.is_empty() { String::new() } else { format!("[{}]", sets.join(", ")) }
}

/// `[i in plants, j in markets]`, or nothing.
pub(super) fn indices(over: &[Index]) -> String {
    let indices: Vec<String> =
        over.iter().map(|index| format!("{} in {}", index.name, index.set)).collect();
    if indices.is_empty() { String::new() } else { format!("[{}]", indices.join(", ")) }
}
