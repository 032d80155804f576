//! What the head of a model function must look like.

use super::parse::Head;
use super::types::{array, is_ident, is_real, literal};
use crate::errors::Errors;
use crate::messages;
use crate::type_name::type_name;
use quote::{ToTokens, quote};
use syn::ext::IdentExt;
use syn::{
    Attribute, Expr, FnArg, GenericParam, Ident, Pat, PatType, ReturnType, Signature, TypeArray,
    TypeParamBound, Visibility, WherePredicate,
};

/// What was found in the head of a function.
#[derive(Default)]
pub(super) struct Checked {
    /// `None` if something is wrong that the model depends on.
    pub(super) function: Option<Function>,
    /// Number of variables, if the text says it.
    pub(super) count: Option<usize>,
}

/// A function that is a model.
pub(super) struct Function {
    /// Documentation and lint levels, which its model has too.
    pub(super) attributes: Vec<Attribute>,
    pub(super) visibility: Visibility,
    pub(super) name: Ident,
    /// Name of the model.
    pub(super) model: Ident,
    pub(super) variables: Variables,
    /// Number of variables, as written.
    pub(super) size: Expr,
    /// Number of equations, as written.
    pub(super) returned: Expr,
}

/// Names of the variables.
pub(super) enum Variables {
    /// `[x1, x2]`.
    Named(Vec<String>),
    /// `z`.
    Indexed(String),
}

/// Checks the head of a function.
pub(super) fn check(head: &Head, errors: &mut Errors) -> Checked {
    let signature = &head.signature;
    check_qualifiers(signature, errors);
    let model = model_name(&signature.ident, errors);
    let number = number_type(signature, errors);
    let checker = Checker { number: number.as_ref() };
    let argument = checker.argument(signature, errors);
    let variables = argument.and_then(|argument| variables(&argument.pat, errors));
    let size = argument.and_then(|argument| checker.size(argument, errors));
    let count = size.and_then(literal).filter(|&count| count > 0);
    let named = match &variables {
        Some(Variables::Named(names)) => Some(names.len()),
        _ => None,
    };
    if let (Some(argument), Some(named), Some(count)) = (argument, named, count)
        && named != count
    {
        errors.at(&argument.pat, messages::pattern_length(named, count));
    }
    let returned = checker.returned(signature, size, errors);
    let function = || {
        Some(Function {
            attributes: head.attributes.iter().filter(|a| is_copied(a)).cloned().collect(),
            visibility: head.visibility.clone(),
            name: signature.ident.clone(),
            model: model?,
            variables: variables?,
            size: size?.clone(),
            returned: returned?.clone(),
        })
    };
    Checked { function: function(), count: count.or(named) }
}

/// Attributes of the function that its model has too.
fn is_copied(attribute: &Attribute) -> bool {
    attribute.path().is_ident("doc") || attribute.path().is_ident("allow")
}

fn check_qualifiers(signature: &Signature, errors: &mut Errors) {
    if let Some(word) = &signature.constness {
        errors.at(word, messages::qualifier("const"));
    }
    if let Some(word) = &signature.asyncness {
        errors.at(word, messages::qualifier("async"));
    }
    if let syn::Safety::Unsafe(word) = &signature.safety {
        errors.at(word, messages::qualifier("unsafe"));
    }
    if let Some(abi) = &signature.abi {
        errors.at(abi, messages::qualifier("extern"));
    }
}

/// `kojima_shindo` becomes `KojimaShindo`; an underscore stays between digits.
fn model_name(function: &Ident, errors: &mut Errors) -> Option<Ident> {
    let text = function.unraw().to_string();
    let model = type_name(function);
    if model.is_none() {
        errors.at(function, messages::no_model_name(&text));
    }
    model
}

/// The type parameter `D` of `<D: Scalar>`.
fn number_type(signature: &Signature, errors: &mut Errors) -> Option<Ident> {
    let generics = &signature.generics;
    let Some(parameter) = generics.type_params().next() else {
        errors.at(&signature.ident, messages::not_generic(&signature.ident.to_string()));
        return None;
    };
    let number = &parameter.ident;
    for other in &generics.params {
        if !matches!(other, GenericParam::Type(other) if other.ident == *number) {
            errors.at(other, messages::other_parameter(&number.to_string()));
        }
    }
    let mut bounds = 0;
    let mut check_bound = |bound: &TypeParamBound, errors: &mut Errors| {
        bounds += 1;
        if is_comparison(bound) {
            errors.at(bound, messages::COMPARISON);
        } else if !is_scalar(bound) {
            errors.at(bound, messages::other_bound(&number.to_string()));
        }
    };
    parameter.bounds.iter().for_each(|bound| check_bound(bound, errors));
    for predicate in generics.where_clause.iter().flat_map(|clause| &clause.predicates) {
        match predicate {
            WherePredicate::Type(of) if is_ident(&of.bounded_ty, number) => {
                of.bounds.iter().for_each(|bound| check_bound(bound, errors));
            }
            WherePredicate::Type(of) if of.bounds.iter().any(is_comparison) => {
                errors.at(predicate, messages::COMPARISON);
            }
            _ => errors.at(predicate, messages::other_bound(&number.to_string())),
        }
    }
    if bounds == 0 {
        errors.at(number, messages::bound_missing(&number.to_string()));
    }
    Some(number.clone())
}

fn is_scalar(bound: &TypeParamBound) -> bool {
    is_trait(bound, &["Scalar"])
}

fn is_comparison(bound: &TypeParamBound) -> bool {
    is_trait(bound, &["PartialOrd", "PartialEq", "Ord", "Eq"])
}

/// Whether a bound is one of these traits, under any path.
fn is_trait(bound: &TypeParamBound, names: &[&str]) -> bool {
    match bound {
        TypeParamBound::Trait(bound) => bound
            .path
            .segments
            .last()
            .is_some_and(|last| names.iter().any(|name| last.ident == name)),
        _ => false,
    }
}

/// Checks of types and patterns, which show the user's own number type.
struct Checker<'a> {
    number: Option<&'a Ident>,
}

impl Checker<'_> {
    /// The number type for messages.
    fn shown(&self) -> String {
        self.number.map_or_else(|| "D".to_owned(), Ident::to_string)
    }

    /// The only argument.
    fn argument<'s>(&self, signature: &'s Signature, errors: &mut Errors) -> Option<&'s PatType> {
        let mut arguments = signature.inputs.iter();
        let first = match arguments.next() {
            None => {
                let span = signature.paren_token.span.join();
                errors.at_span(span, messages::argument_missing(&self.shown()));
                return None;
            }
            Some(FnArg::Receiver(receiver)) => {
                errors.at(receiver, messages::RECEIVER);
                return None;
            }
            Some(FnArg::Typed(first)) => first,
        };
        let second = arguments.next().map(ToTokens::to_token_stream);
        if let Some(second) = second.or_else(|| signature.variadic.as_ref().map(|v| quote!(#v))) {
            errors.at(second, messages::several_arguments(&self.shown()));
            return None;
        }
        Some(first)
    }

    /// The length of the argument's array.
    fn size<'s>(&self, argument: &'s PatType, errors: &mut Errors) -> Option<&'s Expr> {
        let Some(array) = array(&argument.ty) else {
            errors.at(&argument.ty, messages::not_an_array(&self.shown()));
            return None;
        };
        self.element(array, errors);
        if literal(&array.len) == Some(0) {
            errors.at(&array.len, messages::NO_VARIABLES);
        }
        if let Expr::Infer(_) = array.len {
            errors.at(&array.len, messages::LENGTH_INFERRED);
            return None;
        }
        Some(&array.len)
    }

    fn element(&self, array: &TypeArray, errors: &mut Errors) {
        if let Some(number) = self.number
            && !is_real(&array.elem, number)
        {
            errors.at(&array.elem, messages::not_real(&number.to_string()));
        }
    }

    /// The length of the returned array.
    fn returned<'s>(
        &self,
        signature: &'s Signature,
        size: Option<&Expr>,
        errors: &mut Errors,
    ) -> Option<&'s Expr> {
        let length = size.map_or_else(|| "2".to_owned(), |size| quote!(#size).to_string());
        let ReturnType::Type(_, ty) = &signature.output else {
            let message = messages::return_missing(&self.shown(), &length);
            errors.at_span(signature.paren_token.span.close(), message);
            return None;
        };
        let Some(array) = array(ty) else {
            errors.at(ty, messages::return_not_an_array(&self.shown(), &length));
            return None;
        };
        self.element(array, errors);
        if let (Some(equations), Some(variables)) = (literal(&array.len), size.and_then(literal))
            && equations != variables
            && variables > 0
        {
            errors.at(&array.len, messages::return_length(equations, variables));
        }
        if let Expr::Infer(_) = array.len {
            errors.at(&array.len, messages::LENGTH_INFERRED);
            return None;
        }
        Some(&array.len)
    }
}

/// The names in the argument's pattern.
fn variables(pattern: &Pat, errors: &mut Errors) -> Option<Variables> {
    if let Some(name) = name(pattern) {
        return Some(Variables::Indexed(name));
    }
    let Pat::Slice(slice) = pattern else {
        errors.at(pattern, messages::PATTERN);
        return None;
    };
    let mut names = Vec::new();
    for element in &slice.elems {
        if let Some(name) = name(element) {
            names.push(name);
            continue;
        }
        let is_rest = |pattern: &Pat| matches!(pattern, Pat::Rest(_));
        errors.at(
            element,
            match element {
                Pat::Wild(_) => messages::UNNAMED,
                Pat::Rest(_) => messages::REST,
                Pat::Ident(rest) if rest.subpat.as_ref().is_some_and(|(_, p)| is_rest(p)) => {
                    messages::REST
                }
                _ => messages::NOT_A_NAME,
            },
        );
    }
    (names.len() == slice.elems.len()).then_some(Variables::Named(names))
}

/// The name of a pattern that is a name, with or without `mut`.
fn name(pattern: &Pat) -> Option<String> {
    match pattern {
        Pat::Ident(name) if name.by_ref.is_none() && name.subpat.is_none() => {
            Some(name.ident.unraw().to_string())
        }
        _ => None,
    }
}
