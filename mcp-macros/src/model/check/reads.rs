//! [`Reader`]: walks over the tokens of an expression and looks at every declared name.

use super::super::ast::Param;
use super::super::names::{Kind, Names};
use super::super::tokens::{
    group, is_name, is_operator, is_punct, is_receiver, is_word, parts, starts_operand, text,
    trees, word,
};
use super::family::Scope;
use super::{control, locals};
use crate::divisions;
use crate::errors::Errors;
use crate::messages::{habits, names as naming, pairing, parts as of_parts, reading};
use crate::nearest::nearest;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use syn::Ident;

/// What an expression is for.
#[derive(Clone, Copy)]
pub(super) enum Purpose<'a> {
    /// Only data can be read.
    Data(&'static str),
    /// The value of the first of these parameters: data, and only parameters before it.
    Parameter(&'a [Param]),
    /// The definition at this place among all, with its name.
    Definition(usize, &'a Ident),
    /// Everything that has a value can be read.
    Any,
    /// The condition of an `if` in an expression.
    Branch,
}

/// Looks at the expressions of one item.
pub(super) struct Reader<'a> {
    pub(super) names: &'a Names<'a>,
    pub(super) scope: Scope,
    pub(super) locals: Vec<String>,
    /// The part that the item stands in.
    part: Option<usize>,
    pub(super) errors: &'a mut Errors,
}

impl<'a> Reader<'a> {
    /// A reader of an item with these indices.
    pub(super) fn new(names: &'a Names<'a>, scope: Scope, errors: &'a mut Errors) -> Self {
        Reader { names, scope, locals: Vec::new(), part: None, errors }
    }

    /// The reader of an item in a part.
    pub(super) fn of(self, part: Option<usize>) -> Self {
        Reader { part, ..self }
    }

    /// Reports what is wrong with the expression.
    pub(super) fn check(&mut self, expression: &TokenStream, purpose: Purpose<'_>) {
        divisions::check(expression.clone(), self.errors);
        control::check(expression, self.errors);
        self.walk(&trees(expression.clone()), purpose);
    }

    /// Names bound in a group end with it; those of a closure end at a comma, too, those of a
    /// statement do not.
    fn walk(&mut self, tokens: &[TokenTree], purpose: Purpose<'_>) {
        let outer = self.locals.len();
        self.bind(&locals::of_arms(tokens));
        let mut base = self.locals.len();
        let mut k = 0;
        while k < tokens.len() {
            if let Some((bound, next)) = locals::bound(tokens, k) {
                self.bind(&bound);
                k = next;
                continue;
            }
            if let Some(condition) = condition(tokens, k) {
                self.walk(condition, Purpose::Branch);
                k += 1 + condition.len();
                continue;
            }
            match &tokens[k] {
                TokenTree::Group(group) => self.walk(&trees(group.stream()), purpose),
                TokenTree::Punct(punct) if punct.as_char() == ',' => self.locals.truncate(base),
                TokenTree::Punct(punct) if punct.as_char() == ';' => base = self.locals.len(),
                TokenTree::Punct(_) => self.sign(tokens, k),
                TokenTree::Ident(name) if is_name(tokens, k) => self.name(tokens, k, name, purpose),
                _ => {}
            }
            k += 1;
        }
        self.locals.truncate(outer);
    }

    /// M08 for the names that an expression gives itself.
    fn bind(&mut self, bound: &[Ident]) {
        for name in bound {
            let word = name.to_string();
            let noun = match self.names.get(&word) {
                Some(Kind::Eq | Kind::Report) | None => None,
                Some(kind) => Some(kind.noun()),
            };
            if let Some(noun) = noun {
                self.errors.at(name, naming::local_shadows(&word, noun));
            }
            self.locals.push(word);
        }
    }

    /// Signs of GAMS.
    fn sign(&mut self, tokens: &[TokenTree], k: usize) {
        if is_punct(tokens.get(k), '$') {
            self.errors.at(&tokens[k], habits::DOLLAR);
        } else if is_punct(tokens.get(k), '^') {
            self.errors.at(&tokens[k], habits::power("^"));
        } else if is_operator(tokens, k, "**") && !starts_operand(tokens, k) {
            self.errors.at(&tokens[k], habits::power("**"));
        }
    }

    /// A name that is no field, method or path.
    fn name(&mut self, tokens: &[TokenTree], k: usize, name: &Ident, purpose: Purpose<'_>) {
        let word = name.to_string();
        if self.locals.contains(&word) || self.scope.contains_key(&word) {
            return;
        }
        if matches!(word.as_str(), "sum" | "prod") {
            self.sum(tokens, k, name);
        }
        match self.names.get(&word) {
            Some(kind) => {
                if let Some(hidden) = self.names.hidden_in(&word, self.part) {
                    let message =
                        of_parts::hidden(&word, &hidden.name.to_string(), self.part.is_some());
                    self.errors.at(name, message);
                } else if self.may_read(tokens, k, name, kind, purpose) {
                    self.read(tokens, k, name, kind);
                }
            }
            None => self.unknown(tokens, k, name),
        }
    }

    /// A name that is not declared here. It may be an item of the surrounding program, unless it is
    /// read with several indices or resembles a declared name.
    fn unknown(&mut self, tokens: &[TokenTree], k: usize, name: &Ident) {
        let word = name.to_string();
        let is_keyword = syn::parse2::<Ident>(TokenTree::from(name.clone()).into()).is_err();
        let is_item = word.starts_with(char::is_uppercase)
            || group(tokens.get(k + 1), Delimiter::Parenthesis).is_some();
        if is_keyword || is_item || self.names.is_lost(&word) {
            return;
        }
        let brackets = group(tokens.get(k + 1), Delimiter::Bracket);
        let several = brackets.is_some_and(|group| parts(&trees(group.stream())).len() > 1);
        let known =
            if brackets.is_some() { self.names.families() } else { self.names.without_brackets() };
        let known: Vec<&str> = known.iter().map(String::as_str).collect();
        // Of two letters, half may differ by chance.
        let near = nearest(&word, &known).filter(|_| word.chars().count() > 2 || several);
        if several || near.is_some() {
            self.errors.at(name, reading::unknown_name(&word, near));
        }
    }

    /// Whether an expression for this purpose can read this.
    fn may_read(
        &mut self,
        tokens: &[TokenTree],
        k: usize,
        name: &Ident,
        kind: Kind<'_>,
        purpose: Purpose<'_>,
    ) -> bool {
        let word = name.to_string();
        let is_base = is_receiver(tokens, k) && is_word(tokens.get(k + 2), &["base"]);
        let data = match purpose {
            Purpose::Data(what) => Some(what),
            Purpose::Parameter(_) => Some("the value of a parameter"),
            _ => None,
        };
        let message = match (kind, purpose) {
            (Kind::Report, _) => reading::report(&word),
            (Kind::Eq, _) => reading::equation(&word),
            (Kind::Param(_), Purpose::Data(_) | Purpose::Parameter(_)) if !is_base => {
                let what = data.unwrap_or_default();
                let brackets = group(tokens.get(k + 1), Delimiter::Bracket);
                let arguments = brackets.map(arguments).unwrap_or_default();
                reading::only_base(what, &word, &arguments)
            }
            (Kind::Param(_), Purpose::Branch) if !is_base => reading::branch(&word, kind.noun()),
            (Kind::Var(_) | Kind::Def(..), Purpose::Branch) => reading::branch(&word, kind.noun()),
            (Kind::Param(_), Purpose::Parameter([own, ..])) if own.name == *name => {
                reading::parameter_itself(&word)
            }
            (Kind::Param(_), Purpose::Parameter([own, later @ ..]))
                if later.iter().any(|param| param.name == *name) =>
            {
                reading::later(&word, &own.name.to_string())
            }
            (Kind::Var(_) | Kind::Def(..), Purpose::Data(_) | Purpose::Parameter(_)) => {
                let what = data.unwrap_or_default();
                reading::only_data(what, &word, kind.noun())
            }
            (Kind::Def(at, _), Purpose::Definition(reader, by)) if at >= reader => {
                reading::later(&word, &by.to_string())
            }
            _ => return true,
        };
        self.errors.at(name, message);
        false
    }

    /// What stands behind a declared name.
    fn read(&mut self, tokens: &[TokenTree], k: usize, name: &Ident, kind: Kind<'_>) {
        let Some(sets) = kind.sets() else { return };
        let word = name.to_string();
        if let Some(brackets) = group(tokens.get(k + 1), Delimiter::Bracket) {
            self.brackets(brackets, name, &sets);
        } else if group(tokens.get(k + 1), Delimiter::Parenthesis).is_some() && !sets.is_empty() {
            self.errors.at(name, habits::call(&word));
        } else if is_receiver(tokens, k) {
            let attribute = tokens.get(k + 2);
            if let Some(at) = group(tokens.get(k + 3), Delimiter::Parenthesis)
                && is_word(attribute, &["at"])
            {
                self.neighbours(at, &sets);
                let operator = |sign: char| is_punct(tokens.get(k + 4), sign);
                if ['+', '-', '*', '/'].into_iter().any(operator) {
                    self.errors.at(&tokens[k + 2], reading::or_missing(&word));
                }
            } else if !sets.is_empty()
                && let Kind::Param(_) | Kind::Var(_) | Kind::Def(..) = kind
                && let Some(method) = word_of(attribute)
                && !["at", "base", "l", "lo", "up", "fx"].contains(&method.as_str())
            {
                self.errors.at(&tokens[k + 2], reading::method(&word, &method));
            } else if matches!(kind, Kind::Var(_)) && is_word(attribute, &["l", "lo", "up", "fx"]) {
                let attribute = attribute.map(ToString::to_string).unwrap_or_default();
                self.errors.at(name, habits::attribute(&word, &attribute));
            }
        } else if !sets.is_empty() {
            let sets: Vec<&str> = sets.iter().map(String::as_str).collect();
            self.errors.at(name, reading::family(&word, &sets));
        }
    }

    /// `name[…]`.
    fn brackets(&mut self, brackets: &Group, name: &Ident, sets: &[String]) {
        let word = name.to_string();
        let tokens = trees(brackets.stream());
        let pieces = parts(&tokens);
        if sets.is_empty() {
            self.errors.at(name, reading::scalar(&word));
            return;
        }
        if pieces.len() != sets.len() {
            let sets: Vec<&str> = sets.iter().map(String::as_str).collect();
            self.errors.at(name, pairing::rank(&word, &sets, pieces.len()));
            return;
        }
        for (place, (piece, set)) in pieces.iter().zip(sets).enumerate() {
            match piece {
                [only] => self.index(only, &word, place, set),
                [index, sign, step] => {
                    let at = format!("{word}.at({})", arguments(brackets));
                    self.step([index, sign, step], &at, set);
                }
                _ => {}
            }
        }
    }

    /// `name.at(…)`: only an ordered set has neighbours.
    fn neighbours(&mut self, at: &Group, sets: &[String]) {
        let tokens = trees(at.stream());
        for (piece, set) in parts(&tokens).iter().zip(sets) {
            if let [index, sign, step] = piece
                && self.names.set(set).is_some_and(|set| !set.kind.is_ordered())
            {
                self.step([index, sign, step], "", set);
            }
        }
    }

    /// A plain index or label.
    fn index(&mut self, piece: &TokenTree, family: &str, place: usize, of: &str) {
        let Some(name) = word(Some(piece)) else { return };
        let text = name.to_string();
        if self.locals.contains(&text) {
            return;
        }
        if let Some(set) = self.scope.get(&text) {
            if let Some(set) = set
                && !self.names.is_within(set, of)
            {
                self.errors.at(name, reading::other_set(&text, set, family, place, of));
            }
        } else if let Some(Kind::Label(set)) = self.names.get(&text) {
            let set = set.to_string();
            if !self.names.is_within(&set, of) {
                self.errors.at(name, reading::other_label(&text, &set, family, place, of));
            }
        }
    }

    /// `t - 1` with an integer.
    fn step(&mut self, [index, sign, step]: [&TokenTree; 3], at: &str, of: &str) {
        let (Some(name), Some(set)) = (word(Some(index)), self.names.set(of)) else { return };
        let signed = is_punct(Some(sign), '-') || is_punct(Some(sign), '+');
        let is_integer = syn::parse2::<syn::LitInt>(step.clone().into()).is_ok();
        let text = name.to_string();
        if !signed
            || !is_integer
            || !(self.locals.contains(&text) || self.scope.contains_key(&text))
        {
            return;
        }
        let piece = format!("{name} {sign} {step}");
        let message = if set.kind.is_ordered() {
            let minus = if is_punct(Some(sign), '-') { "-" } else { "" };
            reading::step(&piece, of, at, &format!("{of}.wrap({name}, {minus}{step})"))
        } else {
            reading::step_without_order(&piece, of)
        };
        self.errors.at(name, message);
    }
}

/// The word as text.
fn word_of(tree: Option<&TokenTree>) -> Option<String> {
    word(tree).map(ToString::to_string)
}

/// The condition of the `if` or `while` at `k`; `if let` has none.
fn condition(tokens: &[TokenTree], k: usize) -> Option<&[TokenTree]> {
    let begins = is_word(tokens.get(k), &["if", "while"]);
    if !begins || is_word(tokens.get(k + 1), &["let"]) {
        return None;
    }
    let block = |at: &usize| group(tokens.get(*at), Delimiter::Brace).is_some();
    let end = (k + 1..tokens.len()).find(block)?;
    Some(&tokens[k + 1..end])
}

/// The pieces in brackets as text.
fn arguments(brackets: &Group) -> String {
    let tokens = trees(brackets.stream());
    let pieces: Vec<String> = parts(&tokens).into_iter().map(text).collect();
    pieces.join(", ")
}
