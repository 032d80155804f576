//! Every message of `#[mcp_fn]` at its place: `line:column message`.

use super::{mutilated, split};
use crate::function::{mcp_fn, model};
use crate::messages;

/// The errors of one macro call, one a line.
fn errors(text: &str) -> String {
    let (arguments, item) = split(text);
    match model(arguments, item) {
        Ok(_) => String::new(),
        Err(errors) => errors.lines().join("\n"),
    }
}

/// Errors of a function with these arguments of the attribute and two variables.
fn argument_errors(arguments: &str) -> String {
    let function = "fn f<D: Scalar>([x1, x2]: [Real<D>; 2]) -> [Real<D>; 2] { [x1, x2] }";
    errors(&format!("#[mcp_fn({arguments})]\n{function}"))
}

/// Errors of a function without arguments of the attribute.
fn function_errors(function: &str) -> String {
    errors(&format!("#[mcp_fn]\n{function}"))
}

#[test]
fn right_functions_have_no_errors() {
    for function in [
        "fn f<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] { [x] }",
        "pub(crate) fn f<S: mcp_core::Scalar>([mut x, r#type]: [mcp_core::Real<S>; 2]) \
         -> [mcp_core::Real<S>; 2] { [x, r#type] }",
        "fn f<D>(mut z: [Real<D>; N * 2]) -> [Real<D>; { 2 * N }] where D: Scalar { z }",
        "fn kojimaShindo<D: Scalar>(z: [(Real<D>); N]) -> ([Real<D>; M]) { z }",
        "fn f<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] { not even = a { body } }",
    ] {
        assert_eq!(function_errors(function), "", "{function}");
    }
    for arguments in [
        "",
        "lower = 0",
        "lower = [0, 0.5], upper = [1.0; 2], start = z0::<A, B>(), crate = a::b,",
        "start = START, crate = ::mcp_core",
    ] {
        assert_eq!(argument_errors(arguments), "", "{arguments}");
    }
}

#[test]
fn divisions_of_integer_literals_are_shown() {
    let body = |body: &str| {
        function_errors(&format!("fn f<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {{ {body} }}"))
    };
    for fine in ["[x * 1 / 2]", "[1.0 / 2.0 * x]", "[x / 2]", "[2 * x / 3]", "[t.0 / 2 * x]"] {
        assert_eq!(body(fine), "", "{fine}");
    }
    let half = messages::division("1", "2");
    assert_eq!(body("[1 / 2 * x]"), format!("2:55 {half}"));
    assert_eq!(body("[x.pow(1/2)]"), format!("2:61 {half}"));
    assert_eq!(half, "`1 / 2` divides integers, without the fraction: write `1.0 / 2.0`");
}

#[test]
fn comparisons_are_refused_with_what_to_use_instead() {
    let rest = "([x]: [Real<D>; 1]) -> [Real<D>; 1]";
    let bound = function_errors(&format!("fn f<D: Scalar + PartialOrd>{rest} {{ [x] }}"));
    assert_eq!(bound, format!("2:18 {}", messages::COMPARISON));
    let clause = format!("fn f<D: Scalar>{rest} where Real<D>: PartialOrd {{ [x] }}");
    assert_eq!(function_errors(&clause), format!("2:58 {}", messages::COMPARISON));
}

#[test]
fn only_functions_are_models() {
    for item in ["struct F;", "const F: fn() = g;", "impl F {}", "pub type F = fn(f64);"] {
        let column = if item.starts_with("pub") { 5 } else { 1 };
        let expected = format!("2:{column} {}", messages::NOT_A_FUNCTION);
        assert_eq!(function_errors(item), expected);
    }
    assert_eq!(
        function_errors("fn f<D: Scalar>"),
        "1:1 unexpected end of input, expected parentheses"
    );
}

#[test]
fn qualifiers_are_refused_where_they_stand() {
    let rest = "fn f<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] { [x] }";
    assert_eq!(
        function_errors(&format!("const async unsafe extern \"C\" {rest}")),
        "2:1 a model function cannot be `const`: write `fn` alone\n\
         2:7 a model function cannot be `async`: write `fn` alone\n\
         2:13 a model function cannot be `unsafe`: write `fn` alone\n\
         2:20 a model function cannot be `extern`: write `fn` alone"
    );
}

#[test]
fn a_model_needs_a_name() {
    for (name, shown) in [("self_", "self_"), ("__", "__"), ("_1", "_1")] {
        let function = format!("fn {name}<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {{ [x] }}");
        assert_eq!(
            function_errors(&function),
            format!(
                "2:4 no name for the model can be made from `{shown}`: use a name with a letter"
            )
        );
    }
}

#[test]
fn a_function_without_generics_gets_one_error_with_the_right_form() {
    for generics in ["", "<>", "<'a>", "<const N: usize>"] {
        assert_eq!(
            function_errors(&format!(
                "fn duo{generics}([x, y]: [f64; 2]) -> [f64; 2] {{ [x, y] }}"
            )),
            "2:4 a model function is generic in its numbers: \
             `fn duo<D: Scalar>([x1, x2]: [Real<D>; 2]) -> [Real<D>; 2]`"
        );
    }
}

#[test]
fn the_generic_parameter_is_one_scalar() {
    let errors = |generics: &str, clause: &str| {
        function_errors(&format!(
            "fn f{generics}([x]: [Real<S>; 1]) -> [Real<S>; 1] {clause} {{ [x] }}"
        ))
    };
    assert_eq!(errors("<S>", ""), "2:6 `S` needs its bound: write `S: Scalar`");
    assert_eq!(
        errors("<'a, S: Scalar, const N: usize, T>", ""),
        "2:6 a model function has one generic parameter: `<S: Scalar>`\n\
         2:21 a model function has one generic parameter: `<S: Scalar>`\n\
         2:37 a model function has one generic parameter: `<S: Scalar>`"
    );
    assert_eq!(
        errors("<S: Copy>", ""),
        "2:9 the only bound is `S: Scalar`: a model is evaluated with every number type"
    );
    assert_eq!(
        errors("<S: Scalar + Hash + 'static>", "where S: Send, f64: Into<S>"),
        "2:18 the only bound is `S: Scalar`: a model is evaluated with every number type\n\
         2:25 the only bound is `S: Scalar`: a model is evaluated with every number type\n\
         2:78 the only bound is `S: Scalar`: a model is evaluated with every number type\n\
         2:84 the only bound is `S: Scalar`: a model is evaluated with every number type"
    );
}

#[test]
fn there_is_exactly_one_argument() {
    let errors = |list: &str| {
        function_errors(&format!("fn f<D: Scalar>({list}) -> [Real<D>; 2] {{ todo!() }}"))
    };
    assert_eq!(errors(""), "2:16 the variables are missing: write `([x1, x2]: [Real<D>; 2])`");
    let several = "a model function has one argument, all its variables: \
        `([x1, x2]: [Real<D>; 2])`";
    assert_eq!(errors("x1: Real<D>, x2: Real<D>"), format!("2:30 {several}"));
    assert_eq!(errors("z: [Real<D>; 2], ..."), format!("2:34 {several}"));
    let receiver = "2:17 a model function has no `self`: move it out of the `impl` block, or \
        implement `Model` for the type";
    assert_eq!(errors("&self, z: [Real<D>; 2]"), receiver);
    assert_eq!(errors("self: Box<Self>"), receiver);
}

#[test]
fn every_variable_has_a_name() {
    let errors = |pattern: &str| {
        function_errors(&format!(
            "fn f<D: Scalar>({pattern}: [Real<D>; 2]) -> [Real<D>; 2] {{ todo!() }}"
        ))
    };
    for pattern in ["_", "&z", "(x, y)", "ref z", "z @ [x, y]", "Pair { x, y }"] {
        assert_eq!(errors(pattern), format!("2:17 {}", messages::PATTERN), "{pattern}");
    }
    assert_eq!(
        errors("[_, (x, y)]"),
        "2:18 every variable needs a name: reports and errors use it\n\
         2:21 expected the name of a variable, such as `x1`"
    );
    let rest = "every variable needs a name: write them all instead of `..`";
    assert_eq!(errors("[x, ..]"), format!("2:21 {rest}"));
    assert_eq!(errors("[x, tail @ ..]"), format!("2:21 {rest}"));
    assert_eq!(errors("[x]"), "2:17 1 variable is named, but the type has 2");
    assert_eq!(errors("[x, y, z]"), "2:17 3 variables are named, but the type has 2");
}

#[test]
fn the_argument_is_an_array_of_reals() {
    let errors = |ty: &str| {
        function_errors(&format!("fn f<D: Scalar>(z: {ty}) -> [Real<D>; 2] {{ todo!() }}"))
    };
    for ty in ["&[Real<D>]", "Real<D>", "Vec<Real<D>>", "&[Real<D>; 2]", "(Real<D>, Real<D>)"] {
        let expected = "2:20 expected an array of fixed size, `[Real<D>; 2]`: where the size \
            comes from data, implement `Model`";
        assert_eq!(errors(ty), expected, "{ty}");
    }
    for element in ["f64", "D", "Real", "Real<f64>", "Real<D, D>", "&Real<D>", "Dual<D>"] {
        assert_eq!(errors(&format!("[{element}; 2]")), "2:21 expected `Real<D>`", "{element}");
    }
    assert_eq!(errors("[Real<D>; 0]"), "2:30 a model has at least one variable");
    assert_eq!(
        errors("[Real<D>; _]"),
        "2:30 expected the number of variables: a literal or a constant"
    );
}

#[test]
fn as_many_equations_are_returned_as_there_are_variables() {
    let errors = |length: &str, output: &str| {
        function_errors(&format!("fn f<D: Scalar>(z: [Real<D>; {length}]){output} {{ todo!() }}"))
    };
    assert_eq!(
        errors("2", ""),
        "2:32 the equations are missing: return one number for each variable, `-> [Real<D>; 2]`"
    );
    assert_eq!(
        errors("N", " -> Vec<Real<D>>"),
        "2:37 expected one number for each variable, `-> [Real<D>; N]`"
    );
    assert_eq!(errors("2", " -> [f64; 2]"), "2:38 expected `Real<D>`");
    assert_eq!(
        errors("2", " -> [Real<D>; _]"),
        "2:47 expected the number of variables: a literal or a constant"
    );
    assert_eq!(
        errors("2", " -> [Real<D>; 1]"),
        "2:47 1 equation for 2 variables: every variable has one"
    );
    assert_eq!(
        errors("1", " -> [Real<D>; 3]"),
        "2:47 3 equations for 1 variable: every variable has one"
    );
}

#[test]
fn unknown_arguments_are_answered_with_the_nearest() {
    assert_eq!(
        argument_errors("lowr = 0.0"),
        "1:10 there is no argument `lowr`; did you mean `lower`?"
    );
    assert_eq!(
        argument_errors("tolerance = 0.0, 3 = 4, upper = 1.0"),
        "1:10 there is no argument `tolerance`: expected one of `lower`, `upper`, `start`, `crate`\n\
         1:27 expected one of `lower`, `upper`, `start`, `crate`"
    );
}

#[test]
fn arguments_are_given_once_with_a_value() {
    assert_eq!(argument_errors("lower = 0.0, lower = 1.0"), "1:23 `lower` is given twice");
    assert_eq!(
        argument_errors("lower, upper =, start(0.0), crate"),
        "1:10 `lower` needs a value: `lower = 0.0`\n\
         1:17 `upper` needs a value: `upper = 0.0`\n\
         1:26 `start` needs a value: `start = 0.0`\n\
         1:38 `crate` needs a value: `crate = mcp_core`"
    );
    assert_eq!(
        argument_errors("crate = \"core\", lower = 0.0 upper = 1.0"),
        "1:18 expected the path of `mcp_core`: `crate = my_core`\n\
         1:38 expected `,`"
    );
    assert_eq!(
        argument_errors("lower = +, upper = let"),
        "1:18 expected an expression\n1:21 the value of `upper` is not finished"
    );
}

#[test]
fn arrays_that_are_written_out_have_the_right_length() {
    assert_eq!(
        argument_errors("lower = [0.0, 0.0, 0.0], upper = [1.0], start = [0.0; 4]"),
        "1:18 `lower` has 3 entries, but there are 2 variables\n\
         1:43 `upper` has 1 entry, but there are 2 variables\n\
         1:58 `start` has 4 entries, but there are 2 variables"
    );
    let one = "fn f<D: Scalar>(z: [Real<D>; 1]) -> [Real<D>; 1] { z }";
    assert_eq!(
        errors(&format!("#[mcp_fn(lower = [])] {one}")),
        "1:18 `lower` has 0 entries, but there is 1 variable"
    );
    let unknown = "fn f<D: Scalar>(z: [Real<D>; N]) -> [Real<D>; N] { z }";
    assert_eq!(errors(&format!("#[mcp_fn(lower = [0.0, 1.0])] {unknown}")), "");
}

#[test]
fn independent_errors_are_shown_together() {
    assert_eq!(
        errors(
            "#[mcp_fn(lowr = 0.0, start = [0.0])]\n\
             async fn f<D>([x, _]: [f64; 2])\n\
             -> [Real<D>; 3] { todo!() }"
        ),
        "1:10 there is no argument `lowr`; did you mean `lower`?\n\
         2:1 a model function cannot be `async`: write `fn` alone\n\
         2:12 `D` needs its bound: write `D: Scalar`\n\
         2:19 every variable needs a name: reports and errors use it\n\
         2:24 expected `Real<D>`\n\
         3:14 3 equations for 2 variables: every variable has one\n\
         1:30 `start` has 1 entry, but there are 2 variables"
    );
}

#[test]
fn a_wrong_function_is_still_there_unchanged() {
    let function = "fn f ([x] : [f64 ; 1]) -> [f64 ; 1] { [x] }";
    let (arguments, item) = split(&format!("#[mcp_fn(lower)] {function}"));
    let output = mcp_fn(arguments, item.clone()).to_string();
    let errors = output.strip_prefix(&item.to_string()).unwrap();
    assert_eq!(errors.matches("compile_error").count(), 2);
    assert!(!errors.contains("struct"));
}

#[test]
fn no_text_makes_the_macro_panic() {
    let text = "#[mcp_fn(lower = [0, 1.5], upper = f(2), start = z0, crate = a::b)] \
        pub const unsafe fn f<'a, D: Scalar + Copy>([x, mut y]: [Real<D>; 2]) -> [Real<D>; 2] \
        where D: Send { [x, y] }";
    let (arguments, item) = split(text);
    for arguments in mutilated(&arguments) {
        mcp_fn(arguments, item.clone());
    }
    for item in mutilated(&item) {
        mcp_fn(arguments.clone(), item);
    }
}
