//! The generated model: data and calls.

use super::arguments::{Arguments, Setting};
use super::signature::{Function, Variables};
use super::types::{literal, ungrouped};
use crate::messages;
use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::Expr;
use syn::spanned::Spanned;

/// The struct, its constructor and its `impl Model`.
///
/// Locals are hygienic and paths absolute, and the user's own expressions (values and sizes) stand
/// only where no type parameter of ours is visible: variables and items may have any name.
pub(super) fn model(function: &Function, arguments: &Arguments) -> TokenStream {
    let site = Span::mixed_site();
    let core = core(arguments, site);
    let Function { attributes, visibility, name, model, size, .. } = function;
    let made_from = format!(" The model of [`{name}`](fn@{name}), made by `#[mcp_fn]`.");
    let settings = arguments.settings.iter().map(|setting| call(setting, arguments));
    let family = quote_spanned!(site=> family);
    let index = quote_spanned!(site=> index);
    let (shape, parameters, row) = match &function.variables {
        Variables::Named(names) => (
            quote_spanned!(site=> named(&[#(#names),*])),
            quote_spanned!(site=> #family: usize, _index: usize),
            family,
        ),
        Variables::Indexed(name) => (
            quote_spanned!(site=> indexed(#name)),
            quote_spanned!(site=> _family: usize, #index: usize),
            index,
        ),
    };
    let checks = checks(function);
    quote_spanned! {site=>
        #(#attributes)*
        #[doc = ""]
        #[doc = #made_from]
        #[derive(::core::clone::Clone, ::core::fmt::Debug)]
        #visibility struct #model {
            shape: #core::Shape,
        }

        #checks

        impl #model {
            /// The model with its names, bounds and start.
            ///
            /// # Errors
            /// If bounds are crossed or not usable, or the start is not finite; the error names
            /// the variable.
            #visibility fn new() -> ::core::result::Result<Self, #core::ModelError> {
                let shape = #core::__private::FunctionShape::<{ #size }>::new()
                    #(#settings)*
                    .#shape?;
                ::core::result::Result::Ok(Self { shape })
            }
        }

        impl #core::Model for #model {
            const WHOLE: ::core::option::Option<usize> = ::core::option::Option::Some(#size);

            fn shape(&self) -> &#core::Shape {
                &self.shape
            }

            fn row<D: #core::Scalar>(
                &self,
                #parameters,
                read: &#core::Reader<'_, D>,
            ) -> #core::Real<D> {
                #name::<D>(read.first())[#row]
            }

            fn whole<D: #core::Scalar>(
                &self,
                read: &#core::Reader<'_, D>,
                f: &mut [#core::Real<D>],
            ) {
                f.copy_from_slice(&#name::<D>(read.first()));
            }
        }
    }
}

/// The path of `mcp_core`.
fn core(arguments: &Arguments, span: Span) -> TokenStream {
    let given = arguments.core.as_ref().map(ToTokens::to_token_stream);
    given.unwrap_or_else(|| quote_spanned!(span=> ::mcp_core))
}

/// `.lower(value)`: type errors are shown at the user's own `lower` and value. The entries of an
/// array that is written out are converted one by one, so that `[0, 0.5]` is fine; its brackets
/// keep their span, or an error would be shown at the whole attribute.
fn call(setting: &Setting, arguments: &Arguments) -> TokenStream {
    let Setting { key, value } = setting;
    let span = Span::mixed_site().located_at(value.span());
    let Expr::Array(array) = ungrouped(value) else {
        return quote_spanned!(span=> .#key(#value));
    };
    let entries = array.elems.iter().map(|entry| {
        let span = Span::mixed_site().located_at(entry.span());
        let core = core(arguments, span);
        quote_spanned!(span=> #core::__private::number(#entry))
    });
    let array = quote_spanned!(array.span()=> [#(#entries),*]);
    quote_spanned!(span=> .#key(#array))
}

/// Checks of lengths that only the compiler knows, shown at the lengths.
fn checks(function: &Function) -> TokenStream {
    let Function { size, returned, .. } = function;
    let check = |at: &Expr, condition: TokenStream, message: &str| {
        let span = Span::mixed_site().located_at(at.span());
        quote_spanned!(span=> const _: () = ::core::assert!(#condition, #message);)
    };
    let mut checks = TokenStream::new();
    if literal(size).is_none() {
        checks.extend(check(size, quote!((#size) != 0), messages::NO_VARIABLES));
    }
    if quote!(#size).to_string() != quote!(#returned).to_string() {
        checks.extend(check(returned, quote!((#returned) == (#size)), messages::RETURN_LENGTH));
    }
    checks
}
