//! A model as it was written: headers in parts, expressions as tokens.

use proc_macro2::{Span, TokenStream};
use std::collections::HashSet;
use syn::{Attribute, Ident, LitInt, Type, Visibility};

/// `pub model Name { … }`; the items of a kind in the order of declaration.
pub(super) struct Model {
    pub(super) attributes: Vec<Attribute>,
    pub(super) visibility: Visibility,
    pub(super) name: Ident,
    pub(super) fields: Vec<Field>,
    pub(super) params: Vec<Param>,
    pub(super) vars: Vec<Var>,
    pub(super) fixes: Vec<Fix>,
    pub(super) defs: Vec<Def>,
    pub(super) eqs: Vec<Eq>,
    pub(super) reports: Vec<Report>,
    pub(super) parts: Vec<Part>,
    pub(super) adds: Vec<Adds>,
    pub(super) lost: Lost,
}

/// What could not be read: errors that would only follow from it are not shown. Empty in a model
/// without errors.
#[derive(Default)]
pub(super) struct Lost {
    /// Names that may be declared there.
    pub(super) names: Vec<String>,
    /// Whether an equation may be among it.
    pub(super) equations: bool,
    /// Equations without `complements`, as they are while they are written: indices and body.
    pub(super) bodies: Vec<(Vec<Index>, TokenStream)>,
}

impl Model {
    /// Keeps the first declaration of every name, so that the expansion of a model with errors has
    /// each once.
    pub(super) fn drop_duplicates(&mut self) {
        let mut seen = HashSet::new();
        let mut is_new = |name: &Ident| seen.insert(name.to_string());
        self.fields.retain(|field| is_new(&field.name));
        self.params.retain(|param| is_new(&param.name));
        self.vars.retain(|var| is_new(&var.name));
        self.defs.retain(|def| is_new(&def.name));
        self.eqs.retain(|eq| is_new(&eq.name));
        self.reports.retain(|report| is_new(&report.name));
    }

    /// The equation or definition of this name: its indices, and the part that it belongs to.
    pub(super) fn target(&self, name: &Ident) -> Option<(&[Index], Option<usize>)> {
        let eqs = self.eqs.iter().map(|eq| (&eq.name, &eq.over, eq.part));
        let defs = self.defs.iter().map(|def| (&def.name, &def.over, def.part));
        let mut targets = eqs.chain(defs);
        targets.find(|(own, ..)| *own == name).map(|(_, over, part)| (&over[..], part))
    }

    /// Every expression of the self.
    pub(super) fn expressions(&self) -> impl Iterator<Item = &TokenStream> {
        let params = self.params.iter().filter_map(|param| param.value.as_ref());
        let starts = self.vars.iter().flat_map(|var| var.start.iter().chain(&var.condition));
        let bounds = self.vars.iter().flat_map(|var| var.bounds.values());
        let defs = self.defs.iter().map(|def| &def.expression);
        let bodies = self.eqs.iter().flat_map(|eq| eq.body.sides());
        let conditions = self.eqs.iter().flat_map(|eq| eq.condition.iter().chain(&eq.pair));
        let reports = self.reports.iter().map(|report| &report.expression);
        let fixes = self.fixes.iter().map(|fix| &fix.value);
        let adds = self.adds.iter().map(|adds| &adds.expression);
        let values = params.chain(starts).chain(bounds).chain(fixes);
        values.chain(defs).chain(bodies).chain(conditions).chain(reports).chain(adds)
    }

    /// Every index of every header.
    pub(super) fn headers(&self) -> impl Iterator<Item = &Index> {
        let params = self.params.iter().flat_map(|param| &param.over);
        let vars = self.vars.iter().flat_map(|var| &var.over);
        let fixes = self.fixes.iter().flat_map(|fix| &fix.places).filter_map(Place::index);
        let defs = self.defs.iter().flat_map(|def| &def.over);
        let eqs = self.eqs.iter().flat_map(|eq| &eq.over);
        let reports = self.reports.iter().flat_map(|report| &report.over);
        let adds = self.adds.iter().flat_map(Adds::over);
        params.chain(vars).chain(fixes).chain(defs).chain(eqs).chain(reports).chain(adds)
    }
}

/// One field of a `data { … }` block: `capacity[plants]: f64`.
pub(super) struct Field {
    pub(super) attributes: Vec<Attribute>,
    pub(super) name: Ident,
    /// Sets it is indexed by; empty for sets, maps and plain values.
    pub(super) over: Vec<Ident>,
    pub(super) kind: FieldKind,
    pub(super) part: Option<usize>,
}

/// What stands after the colon of a field.
#[allow(clippy::large_enum_variant, reason = "a model has few fields")]
pub(super) enum FieldKind {
    /// `Set`
    Set,
    /// `Set[labor, capital]`: labels known to the text.
    Labels(Vec<Ident>),
    /// `Ordered`
    Ordered,
    /// `Subset(gens)`
    Subset(Ident),
    /// `Pairs(nodes, nodes)`
    Pairs(Ident, Ident),
    /// `Map(gens, nodes)`
    Map(Ident, Ident),
    /// `3`: the set 1, 2, 3.
    Count(LitInt),
    /// `usize`, and used as an index set: the set 1, …, n.
    Size,
    /// `f64` with index sets.
    Table,
    /// Any other type, without index sets.
    Value(Type),
}

impl FieldKind {
    /// The sets it is made of.
    pub(super) fn sets(&self) -> Vec<&Ident> {
        match self {
            FieldKind::Subset(of) => vec![of],
            FieldKind::Pairs(from, to) | FieldKind::Map(from, to) => vec![from, to],
            _ => Vec::new(),
        }
    }
    /// Whether the field can index something.
    pub(super) fn is_set(&self) -> bool {
        !matches!(self, FieldKind::Map(..) | FieldKind::Table | FieldKind::Value(_))
    }
    /// Whether its elements have neighbours: `t - 1`, `hours.wrap(t, 1)`.
    pub(super) fn is_ordered(&self) -> bool {
        matches!(self, FieldKind::Ordered | FieldKind::Count(_) | FieldKind::Size)
    }
}

/// One index in the brackets of a header: `i in plants` or `l @ (i, j) in lines`.
pub(super) struct Index {
    pub(super) name: Ident,
    /// `(i, j)`, the ends of an element of a `Pairs`.
    pub(super) ends: Option<(Ident, Ident)>,
    pub(super) set: Ident,
}

/// `param name[i in set] = expr;`
pub(super) struct Param {
    pub(super) attributes: Vec<Attribute>,
    pub(super) name: Ident,
    pub(super) over: Vec<Index>,
    /// Without it, the value comes with the data.
    pub(super) value: Option<TokenStream>,
    pub(super) part: Option<usize>,
}

/// `var name[i in set] >= lower start expr if condition;`
pub(super) struct Var {
    pub(super) attributes: Vec<Attribute>,
    pub(super) name: Ident,
    pub(super) over: Vec<Index>,
    pub(super) bounds: Bounds,
    pub(super) start: Option<TokenStream>,
    pub(super) condition: Option<TokenStream>,
    pub(super) part: Option<usize>,
}

/// Bounds in the header of a variable.
pub(super) enum Bounds {
    /// `free`
    Free,
    /// `>= expr`
    Lower(TokenStream),
    /// `<= expr`
    Upper(TokenStream),
    /// `in expr..=expr`
    Box(TokenStream, TokenStream),
}

impl Bounds {
    /// The expressions of the bounds.
    pub(super) fn values(&self) -> Vec<&TokenStream> {
        match self {
            Bounds::Free => Vec::new(),
            Bounds::Lower(bound) | Bounds::Upper(bound) => vec![bound],
            Bounds::Box(lower, upper) => vec![lower, upper],
        }
    }
}

/// One place in brackets: an index that runs, or an expression that picks one element.
pub(super) enum Place {
    /// `i in plants`
    Every(Index),
    /// `labor`
    One(TokenStream),
}

impl Place {
    /// The index that runs.
    pub(super) fn index(&self) -> Option<&Index> {
        match self {
            Place::Every(index) => Some(index),
            Place::One(_) => None,
        }
    }
}

/// `fix name[labor] = expr;` or `fix name[i in set] = expr;`
pub(super) struct Fix {
    pub(super) variable: Ident,
    pub(super) places: Vec<Place>,
    pub(super) value: TokenStream,
    pub(super) part: Option<usize>,
}

/// `def name[i in set]: expr;` or `def name[i in set] lifted: expr;`
pub(super) struct Def {
    pub(super) attributes: Vec<Attribute>,
    pub(super) name: Ident,
    pub(super) over: Vec<Index>,
    /// A variable of its own, with the definition as its equation.
    pub(super) lifted: bool,
    pub(super) expression: TokenStream,
    pub(super) part: Option<usize>,
}

/// `eq name[i in set] if condition: body complements variable[i];`
pub(super) struct Eq {
    pub(super) attributes: Vec<Attribute>,
    pub(super) name: Ident,
    pub(super) over: Vec<Index>,
    pub(super) condition: Option<TokenStream>,
    pub(super) body: Body,
    pub(super) variable: Ident,
    /// What stands in the brackets after the variable, one part for each index.
    pub(super) pair: Vec<TokenStream>,
    /// The closing bracket, or the variable without one: where a missing index is shown.
    pub(super) pair_end: Span,
    pub(super) part: Option<usize>,
}

/// What an equation says.
pub(super) enum Body {
    /// `F`
    Expression(TokenStream),
    /// `lhs >= rhs`, `lhs <= rhs`, `lhs == rhs`: `F = lhs - rhs`.
    Relation { left: TokenStream, relation: Relation, span: Span, right: TokenStream },
}

impl Body {
    /// The expressions of the body.
    pub(super) fn sides(&self) -> Vec<&TokenStream> {
        match self {
            Body::Expression(tokens) => vec![tokens],
            Body::Relation { left, right, .. } => vec![left, right],
        }
    }
}

/// The sign between the sides of a relation.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Relation {
    AtLeast,
    AtMost,
    Equal,
}

impl Relation {
    /// As it is written.
    pub(super) fn sign(self) -> &'static str {
        match self {
            Relation::AtLeast => ">=",
            Relation::AtMost => "<=",
            Relation::Equal => "==",
        }
    }
}

/// `report name[i in set]: expr;`
pub(super) struct Report {
    pub(super) attributes: Vec<Attribute>,
    pub(super) name: Ident,
    pub(super) over: Vec<Index>,
    pub(super) expression: TokenStream,
    pub(super) part: Option<usize>,
}

/// `part name requires a, b excludes c { … }`; its items stand among those of the model, with its
/// place in the list of parts.
pub(super) struct Part {
    pub(super) attributes: Vec<Attribute>,
    pub(super) name: Ident,
    pub(super) requires: Vec<Ident>,
    pub(super) excludes: Vec<Ident>,
}

/// `adds target[i in set]: expr;` in a part.
pub(super) struct Adds {
    pub(super) target: Ident,
    /// What stands in the brackets after the target.
    pub(super) places: Vec<Place>,
    pub(super) expression: TokenStream,
    pub(super) part: usize,
}

impl Adds {
    /// The indices that run.
    pub(super) fn over(&self) -> Vec<&Index> {
        self.places.iter().filter_map(Place::index).collect()
    }
    /// The expressions that pick one element.
    pub(super) fn picks(&self) -> impl Iterator<Item = &TokenStream> {
        self.places.iter().filter_map(|place| match place {
            Place::One(tokens) => Some(tokens),
            Place::Every(_) => None,
        })
    }
}
