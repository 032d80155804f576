//! Expressions: tokens go out as they came in, except that declared names become reads.
//!
//! | written | read |
//! | --- | --- |
//! | `x[i, j]` of a variable, parameter or definition | `model.x.get(read, i, j)` |
//! | `hh` of one without indices | `model.hh.get(read)` |
//! | `s.at(k, t - 1)`, `s.at(k, t, -1)` | `model.s.at(read, k, t - 1)` |
//! | `cost[i, j]` of a table, `site[g]` of a map | `model.cost.get(i, j)` |
//! | `plants`, `cost.sum()`, `tax.base(s)`, a plain value | the field of the model |
//! | `labor`, a label known to the text | its constant |
//! | `x`, a family without its brackets | as written: an error, or a word that is being typed |
//!
//! Every token of the user keeps its span, so that errors, completion and navigation are at home in
//! the text as it was written. Where a name of the user stands, no other word stands: the field is
//! `(&model.x)`, whose signs have the place of `x` and whose `model` has none, and `get` and `read`
//! stand at the opening bracket. So navigation from `x` leads to `x` only. The reference also keeps
//! `lines.into(n)` from being `Into::into`.

use super::ast::FieldKind;
use super::names::{Kind, Names, is_number};
use super::tokens::{group, is_name, is_punct, is_word, parts, stream, trees};
use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

/// Rewrites the expressions of one model.
pub(super) struct Rewriter<'m> {
    pub(super) names: &'m Names<'m>,
    /// The module of the model's index sets.
    pub(super) module: Ident,
}

impl Rewriter<'_> {
    /// An expression with its reads.
    pub(super) fn expression(&self, tokens: &TokenStream) -> TokenStream {
        let tokens = trees(tokens.clone());
        let mut out = TokenStream::new();
        let mut k = 0;
        while k < tokens.len() {
            match &tokens[k] {
                TokenTree::Ident(name) if is_name(&tokens, k) => {
                    let (read, used) = self.name(name, &tokens[k + 1..]);
                    out.extend(read);
                    k += 1 + used;
                }
                TokenTree::Group(group) => {
                    out.extend([self.group(group)]);
                    k += 1;
                }
                other => {
                    out.extend([other.clone()]);
                    k += 1;
                }
            }
        }
        out
    }

    fn group(&self, group: &Group) -> TokenTree {
        let mut rewritten = Group::new(group.delimiter(), self.expression(&group.stream()));
        rewritten.set_span(group.span());
        TokenTree::Group(rewritten)
    }

    /// A name with what follows it, and how many of the following tokens belong to the read.
    fn name(&self, name: &Ident, rest: &[TokenTree]) -> (TokenStream, usize) {
        let at = Span::mixed_site().located_at(name.span());
        let model = Ident::new("model", Span::mixed_site());
        let field = quote_spanned!(at=> (&#model.#name));
        let family = |rank, is_read| self.family((name, &field), rank, is_read, rest);
        match self.names.get(&name.to_string()) {
            None | Some(Kind::Eq | Kind::Report) => (quote!(#name), 0),
            Some(Kind::Label(set)) => {
                let module = &self.module;
                let mut set = set.clone();
                set.set_span(Span::mixed_site());
                (quote_spanned!(at=> #module::#set::#name), 0)
            }
            Some(Kind::Param(param)) => family(param.over.len(), true),
            Some(Kind::Var(var)) => family(var.over.len(), true),
            Some(Kind::Def(_, def)) => family(def.over.len(), true),
            Some(Kind::Field(declared)) => match &declared.kind {
                FieldKind::Table => family(declared.over.len(), false),
                FieldKind::Map(..) => family(1, false),
                FieldKind::Value(value) if is_number(value) => (quote_spanned!(at=> (*#field)), 0),
                FieldKind::Value(_) => (quote_spanned!(at=> (**#field)), 0),
                FieldKind::Count(_) | FieldKind::Size if is_word(rest.first(), &["as"]) => {
                    let len = Ident::new("len", Span::mixed_site());
                    (quote_spanned!(at=> #field.#len()), 0)
                }
                _ => (field, 0),
            },
        }
    }

    /// A family with what follows it; one that `is_read` in the engine's numbers takes the reader.
    fn family(
        &self,
        (name, field): (&Ident, &TokenStream),
        rank: usize,
        is_read: bool,
        rest: &[TokenTree],
    ) -> (TokenStream, usize) {
        let reader = |group: &Group| is_read.then(|| beside(group, "read"));
        if let Some(indices) = group(rest.first(), Delimiter::Bracket) {
            let get = beside(indices, "get");
            let call = self.call(indices, reader(indices), &pieces(indices.stream()));
            return (quote_spanned!(get.span()=> #field.#get #call), 1);
        }
        match rest {
            [TokenTree::Punct(dot), TokenTree::Ident(method), TokenTree::Group(arguments), ..]
                if dot.as_char() == '.' && method == "at" =>
            {
                let mut pieces = pieces(arguments.stream());
                offset_last(&mut pieces, rank);
                let call = self.call(arguments, reader(arguments), &pieces);
                (quote!(#field #dot #method #call), 3)
            }
            // The value of a parameter in the data, a method of a table, a word being typed.
            _ if is_receiver_of(rest, rank, is_read) => (field.clone(), 0),
            _ if rank > 0 => (quote!(#name), 0),
            _ => {
                let [get, read] = ["get", "read"].map(|of| Ident::new(of, Span::mixed_site()));
                (quote_spanned!(Span::mixed_site()=> #field.#get(#read)), 0)
            }
        }
    }

    /// `(reader, indices…)` where the group stood.
    fn call(&self, group: &Group, reader: Option<Ident>, indices: &[TokenStream]) -> TokenTree {
        let reader = reader.map(|reader| quote!(#reader)).into_iter();
        let arguments = reader.chain(indices.iter().map(|index| self.expression(index)));
        let mut call = Group::new(Delimiter::Parenthesis, quote!(#(#arguments),*));
        call.set_span(group.span());
        TokenTree::Group(call)
    }
}

/// Whether the family itself is meant: before the dot of a method; without indices only before
/// `.base`, since other methods are those of its value.
fn is_receiver_of(rest: &[TokenTree], rank: usize, is_read: bool) -> bool {
    let dot = is_punct(rest.first(), '.') && !is_punct(rest.get(1), '.');
    dot && (rank > 0 || !is_read || is_word(rest.get(1), &["base"]))
}

/// A word of the generated code where the group opens.
fn beside(group: &Group, word: &str) -> Ident {
    Ident::new(word, Span::mixed_site().located_at(group.span_open()))
}

/// Where the call stands that wraps an expression: at its first sign, so that no name is under it.
pub(super) fn wrapping(tokens: &TokenStream) -> Span {
    let tokens = trees(tokens.clone());
    let sign = tokens.iter().find(|token| !matches!(token, TokenTree::Ident(_)));
    let place = match sign.or(tokens.first()) {
        Some(TokenTree::Group(group)) => group.span_open(),
        other => other.map_or_else(Span::mixed_site, TokenTree::span),
    };
    Span::mixed_site().located_at(place)
}

/// One argument of `at` more than there are index sets is an offset of the last index.
fn offset_last(pieces: &mut Vec<TokenStream>, rank: usize) {
    if pieces.len() == rank + 1
        && let (Some(offset), Some(last)) = (pieces.pop(), pieces.pop())
    {
        pieces.push(quote!((#last) + (#offset)));
    }
}

/// Every place in an expression where a set of the data stands.
pub(super) fn sets_in(names: &Names<'_>, tokens: &TokenStream) -> Vec<Ident> {
    let mut sets = names_in(tokens);
    sets.retain(|name| names.set(&name.to_string()).is_some());
    sets
}

/// Every name in an expression that is no field, method or path, in the order of the text.
pub(super) fn names_in(tokens: &TokenStream) -> Vec<Ident> {
    let tokens = trees(tokens.clone());
    let places = tokens.iter().enumerate().flat_map(|(k, token)| match token {
        TokenTree::Group(group) => names_in(&group.stream()),
        TokenTree::Ident(name) if is_name(&tokens, k) => vec![name.clone()],
        _ => Vec::new(),
    });
    places.collect()
}

/// The parts of a list, split at its commas.
fn pieces(tokens: TokenStream) -> Vec<TokenStream> {
    parts(&trees(tokens)).into_iter().map(stream).collect()
}
