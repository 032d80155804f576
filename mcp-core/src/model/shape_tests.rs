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

/// `x` over two markets twice, with these elements, and its equations with those.
fn sparse(x: &[usize], f: &[usize]) -> ShapeBuilder {
    let set = markets();
    let over = [&set, &set];
    Shape::builder()
        .variable(Variable::new("x").over(&over).only(x).lower([0.0, -1.0]).start(5.0))
        .equation(Equation::new("f").over(&over).only(f).complements("x"))
}

#[test]
fn sparse_families_are_numbered_through_by_what_exists() {
    let set = markets();
    let shape = sparse(&[1, 2], &[1, 2])
        .variable(Variable::new("y"))
        .equation(Equation::new("g").complements("y"))
        .definition(Definition::new("d").over(&[&set, &set]).only([3]))
        .definition(Definition::new("e"))
        .parameter(Parameter::new("cost", [7.0, 8.0]).over(&[&set, &set]).only([0, 3]))
        .build()
        .unwrap();
    assert_eq!((shape.n(), shape.row_count(), shape.definition_count()), (3, 3, 2));
    let names: Vec<String> = (0..3).map(|j| shape.variable_name(j)).collect();
    assert_eq!(names, ["x[a, b]", "x[b, a]", "y"]);
    assert_eq!(
        (shape.equation_name(1), shape.definition_name(0)),
        ("f[b, a]".into(), "d[b, b]".into())
    );
    assert_eq!(shape.bounds().lower()[..2], [0.0, -1.0]);
    assert_eq!(shape.parameter_values(), [7.0, 8.0]);
    let nan = shape.clone().set_parameter("cost", &[1.0, f64::NAN]).unwrap_err();
    assert_eq!(nan.to_string(), "parameter `cost[b, b]` is NaN: give a finite number");
}

#[test]
fn sparse_families_pair_by_position_only_with_the_same_elements() {
    let message = |builder: ShapeBuilder| builder.build().unwrap_err().to_string();
    assert_eq!(
        message(sparse(&[1, 2], &[1, 3])),
        "`f[b, b]` has no counterpart in `x`: pair families with different elements by \
         complements_elements"
    );
    assert_eq!(
        message(sparse(&[1, 2], &[1])),
        "equation `f` has 1 rows but is paired with 2 elements of variable `x`"
    );
    assert_eq!(
        message(sparse(&[2, 1], &[1, 2])),
        "the elements of `x` do not increase: 1 follows 2"
    );
    assert_eq!(
        message(sparse(&[0, 4], &[0, 1])),
        "`x` is to have element 4, but its sets combine to only 4"
    );
    // A dense family of the same length over another set has other elements.
    let set = markets();
    let arcs = Equation::new("f").over(&[&set]).complements("x");
    let flow = || Shape::builder().variable(Variable::new("x").over(&[&set, &set]).only([1, 2]));
    assert!(message(flow().equation(arcs)).starts_with("`f[a]` has no counterpart in `x`"));
    let arcs = Equation::new("f").over(&[&set]).complements_elements("x", [1, 0]);
    assert_eq!(flow().equation(arcs).build().unwrap().equation_name(0), "f[b]");
}

#[test]
fn a_copy_shares_families_and_changes_alone() {
    let shape = sparse(&[1, 2], &[1, 2]).build().unwrap();
    let mut copy = shape.clone();
    assert!(Arc::ptr_eq(&shape.structure, &copy.structure));
    copy.set_start(&[1.0, 1.0]).unwrap();
    assert_eq!((shape.start(), copy.start()), (&[5.0, 5.0][..], &[1.0, 1.0][..]));
}
