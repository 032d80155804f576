use super::*;
use crate::model::{Definition, Equation, Parameter};

fn markets() -> Set {
    Set::new("markets", ["a", "b"]).unwrap()
}

#[test]
fn rows_are_found_from_variables_and_back() {
    let set = markets();
    let shape = Shape::builder()
        .variable(Variable::new("p").over(&[&set]).lower(0.0))
        .variable(Variable::new("q"))
        .equation(Equation::new("budget").complements("q"))
        .equation(Equation::new("clear").over(&[&set]).complements("p"))
        .build()
        .unwrap();
    assert_eq!(shape.n(), 3);
    assert_eq!((0..3).map(|row| shape.variable_of_row(row)).collect::<Vec<_>>(), [2, 0, 1]);
    assert_eq!(shape.equation_name(1), "clear[b]");
    assert_eq!(shape.equation_name(2), "budget");
    assert_eq!(shape.variable_name(1), "p[b]");
}

#[test]
fn several_equation_families_may_share_a_variable_family() {
    let shape = Shape::builder()
        .variable(Variable::new("p").over(&[&markets()]))
        .equation(Equation::new("first").complements_elements("p", [1]))
        .equation(Equation::new("second").complements_elements("p", [0]))
        .build()
        .unwrap();
    assert_eq!(shape.equation_name(0), "second");
}

#[test]
fn every_fault_names_its_offender() {
    let one = || Shape::builder().variable(Variable::new("x"));
    let eq = |name: &str| Equation::new(name).complements("x");
    let over = |v: Variable| {
        let set = markets();
        let equation = Equation::new("f").over(&[&set]).complements("x");
        Shape::builder().variable(v.over(&[&set])).equation(equation)
    };
    let cases = [
        (one(), "variable `x` has no equation: pair one with it or fix it"),
        (
            one().equation(eq("f")).equation(eq("g")),
            "variable `x` is complementary to both `f` and `g`",
        ),
        (one().equation(eq("x")), "the name `x` is used twice"),
        (
            one().equation(eq("f").over(&[&Set::count("a", usize::MAX), &Set::count("b", 2)])),
            "`f` has more than 2^31 elements",
        ),
        (
            one().equation(Equation::new("f").complements("y")),
            "there is no variable `y`; did you mean `x`?",
        ),
        (
            one().equation(eq("f").over(&[&markets()])),
            "equation `f` has 2 rows but is paired with 1 elements of variable `x`",
        ),
        (
            one().equation(Equation::new("f").complements_elements("x", [3])),
            "`f` reads paired variable number 3, but there are only 1",
        ),
        (
            over(Variable::new("x").lower([0.0, 2.0]).upper(1.0)),
            "variable `x[b]` has crossed bounds: lower 2 is above upper 1",
        ),
        (
            over(Variable::new("x").lower([0.0, f64::NAN])),
            "variable `x[b]` has the bounds [NaN, inf], which no number satisfies",
        ),
        (
            over(Variable::new("x").lower([0.0])),
            "the length of `lower bound of x` is 1, expected 2",
        ),
        (
            over(Variable::new("x").start([f64::INFINITY, 0.0])),
            "the start of variable `x[a]` is inf: give a finite number",
        ),
        (
            over(Variable::new("x")).parameter(Parameter::new("tax", f64::NAN)),
            "parameter `tax` is NaN: give a finite number",
        ),
    ];
    for (builder, message) in cases {
        assert_eq!(builder.build().unwrap_err().to_string(), message);
    }
}

#[test]
fn a_fixed_variable_needs_no_equation() {
    let shape = Shape::builder().variable(Variable::new("x").fixed(2.0)).build().unwrap();
    assert_eq!(shape.row_of_variable(0), None);
    assert_eq!(shape.row_count(), 0);
    assert_eq!(shape.start(), [2.0]);
}

#[test]
fn starts_are_moved_into_the_bounds() {
    let shape = Shape::anonymous(&[0.0, 0.0], &[1.0, 1.0], &[-3.0, 0.5]).unwrap();
    assert_eq!(shape.start(), [0.0, 0.5]);
}

#[test]
fn parameters_are_changed_by_name() {
    let mut shape = Shape::builder()
        .variable(Variable::new("x"))
        .equation(Equation::new("f").complements("x"))
        .definition(Definition::new("cost"))
        .parameter(Parameter::new("a", 1.0))
        .parameter(Parameter::new("tax", [0.1, 0.2]).over(&[&markets()]))
        .build()
        .unwrap();
    shape.set_parameter("tax", &[0.3, 0.4]).unwrap();
    assert_eq!(shape.parameter_values(), [1.0, 0.3, 0.4]);
    let unknown = shape.set_parameter("tox", &[1.0]).unwrap_err();
    assert_eq!(unknown.to_string(), "there is no parameter `tox`; did you mean `tax`?");
    let nan = shape.set_parameter("tax", &[0.0, f64::NAN]).unwrap_err();
    assert_eq!(nan.to_string(), "parameter `tax[b]` is NaN: give a finite number");
    assert_eq!(shape.definition_name(0), "cost");
}
