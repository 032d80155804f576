//! What `#[mcp_fn]` generates, compared as tokens.

use super::split;
use crate::function::model;
use proc_macro2::TokenStream;

/// The generated model of a function with this head.
fn expansion(text: &str) -> String {
    let (arguments, item) = split(text);
    match model(arguments, item) {
        Ok(model) => model.to_string(),
        Err(errors) => panic!("{:?}", errors.lines()),
    }
}

/// The text of the tokens without layout.
fn bare(text: &str) -> String {
    let tokens = text.parse::<TokenStream>().unwrap().to_string();
    tokens.chars().filter(|c| !c.is_whitespace()).collect()
}

/// Asserts that the expansion has these tokens, in whatever layout they are written.
fn assert_has(expansion: &str, tokens: &str) {
    assert!(bare(expansion).contains(&bare(tokens)), "no `{tokens}` in\n{expansion}");
}

const DUO: &str = "pub fn duo<D: Scalar>([x, mut y]: [Real<D>; 2]) -> [Real<D>; 2] { [x, y] }";

#[test]
fn the_whole_model_of_named_variables() {
    let expected = r#"
        #[doc = r" Two firms."]
        #[doc = ""]
        #[doc = " The model of [`duo`](fn@duo), made by `#[mcp_fn]`."]
        #[derive(::core::clone::Clone, ::core::fmt::Debug)]
        pub struct Duo {
            shape: ::mcp_core::Shape,
        }
        impl Duo {
            #[doc = r" The model with its names, bounds and start."]
            #[doc = r""]
            #[doc = r" # Errors"]
            #[doc = r" If bounds are crossed or not usable, or the start is not finite; the error names"]
            #[doc = r" the variable."]
            pub fn new() -> ::core::result::Result<Self, ::mcp_core::ModelError> {
                let shape = ::mcp_core::__private::FunctionShape::<{ 2 }>::new()
                    .lower(0)
                    .named(&["x", "y"])?;
                ::core::result::Result::Ok(Self { shape })
            }
        }
        impl ::mcp_core::Model for Duo {
            const WHOLE: ::core::option::Option<usize> = ::core::option::Option::Some(2);
            fn shape(&self) -> &::mcp_core::Shape {
                &self.shape
            }
            fn row<D: ::mcp_core::Scalar>(
                &self,
                family: usize,
                _index: usize,
                read: &::mcp_core::Reader<'_, D>,
            ) -> ::mcp_core::Real<D> {
                duo::<D>(read.first())[family]
            }
            fn whole<D: ::mcp_core::Scalar>(
                &self,
                read: &::mcp_core::Reader<'_, D>,
                f: &mut [::mcp_core::Real<D>],
            ) {
                f.copy_from_slice(&duo::<D>(read.first()));
            }
        }
    "#;
    let found =
        expansion(&format!("#[mcp_fn(lower = 0)] #[doc = r\" Two firms.\"] #[inline] {DUO}"));
    assert_eq!(bare(&found), bare(expected));
}

#[test]
fn arguments_become_calls_in_their_order() {
    let found = expansion(&format!(
        "#[mcp_fn(start = Z0, lower = [0, -1.5], upper = [9; 2], crate = crate::core)] {DUO}"
    ));
    assert_has(
        &found,
        "crate::core::__private::FunctionShape::<{ 2 }>::new()
            .start(Z0)
            .lower([crate::core::__private::number(0), crate::core::__private::number(-1.5)])
            .upper([9; 2])",
    );
    assert_has(&found, "impl crate::core::Model for Duo");
    assert!(!found.contains("mcp_core ::"), "{found}");
}

#[test]
fn indexed_variables_have_a_size_the_compiler_checks() {
    let found =
        expansion("#[mcp_fn] fn all<D: Scalar>(z: [Real<D>; m::N]) -> [Real<D>; m::N] { z }");
    assert_has(
        &found,
        "const _: () = ::core::assert!((m::N) != 0, \"a model has at least one variable\");",
    );
    assert_has(&found, "FunctionShape::<{ m::N }>::new().indexed(\"z\")");
    assert_has(&found, "::core::option::Option::Some(m::N)");
    assert_has(&found, "all::<D>(read.first())[index]");
}

#[test]
fn lengths_that_are_written_differently_are_compared_by_the_compiler() {
    let found = expansion("#[mcp_fn] fn all<D: Scalar>(z: [Real<D>; 4]) -> [Real<D>; N] { z }");
    let check = "const _: () = ::core::assert!((N) == (4), \"there must be as many equations as variables\");";
    assert_has(&found, check);
    assert_eq!(found.matches("assert").count(), 1);
}

#[test]
fn models_are_called_like_their_functions() {
    for (function, model) in [
        ("kojima_shindo", "KojimaShindo"),
        ("kojimaShindo", "KojimaShindo"),
        ("x1_2_b", "X1_2B"),
        ("_hidden", "Hidden"),
        ("r#match", "Match"),
        ("r#type_of", "TypeOf"),
        ("Cournot", "Cournot"),
        ("écart_β", "ÉcartΒ"),
    ] {
        let text = format!("#[mcp_fn] fn {function}<D: Scalar>(z: [Real<D>; 2]) -> [Real<D>; 2]");
        assert_has(&expansion(&text), &format!("struct {model}"));
    }
}
