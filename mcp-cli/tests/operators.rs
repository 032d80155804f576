//! Every operator of the format: values against the function itself, derivatives against a second
//! arithmetic and differences, in all forms of files.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

use mcp_cli::nl::{Names, NlModel};
use mcp_core::{AdProblem, Problem, check_derivatives};
use support::node::{many, n, op, v};
use support::{FORMS, File, INF, Kind, Node, Row};

/// Free variables, the expression as the first row, `z_j = 0` as the others.
fn model_of(expression: &Node, variables: usize) -> File {
    let mut rows = vec![Row(Kind::Equal(0.0), Vec::new(), expression.clone())];
    rows.extend((1..variables).map(|j| Row(Kind::Equal(0.0), vec![(j, 1.0)], n(0.0))));
    File { variables: vec![(-INF, INF, 0.5); variables], rows, ..File::default() }
}

/// `F` of the first row of a model at `z`.
fn first_row(model: &NlModel, z: &[f64]) -> f64 {
    let mut problem = AdProblem::new(model).unwrap();
    let mut f = vec![0.0; z.len()];
    problem.evaluate(z, Some(&mut f), None);
    model.row_values(z, &f)[0]
}

/// Value to rounding and derivatives of `expression` at every point, in every form.
fn check<const N: usize>(
    name: &str,
    expression: &Node,
    points: &[[f64; N]],
    function: impl Fn([f64; N]) -> f64,
) {
    let file = model_of(expression, N);
    for form in FORMS {
        let model = NlModel::parse(&file.write(form), Names::default()).unwrap();
        for &z in points {
            let (value, expected) = (first_row(&model, &z), function(z));
            let is_near = (value - expected).abs() <= 8.0 * f64::EPSILON * expected.abs();
            assert!(is_near, "{name} at {z:?}, {form:?}: {value:e}, not {expected:e}");
            let report = check_derivatives(&model, &z).unwrap();
            report.verdict().unwrap_or_else(|wrong| panic!("{name} at {z:?}: {wrong}"));
        }
    }
}

#[test]
fn functions_of_one_number_are_those_of_the_format() {
    let anywhere = [[0.3], [-0.7], [0.0], [2.6], [-31.4]];
    let between = [[0.3], [-0.7], [0.0], [0.99], [-1e-9]];
    let positive = [[0.3], [2.6], [700.0], [1e-6]];
    let one = |code| op(code, [v(0)]);
    check("floor", &one(13), &[[0.3], [-0.7], [2.6]], |[x]| x.floor());
    check("ceil", &one(14), &[[0.3], [-0.7], [2.6]], |[x]| x.ceil());
    check("abs", &one(15), &anywhere, |[x]| x.abs());
    check("negation", &one(16), &anywhere, |[x]| -x);
    check("tanh", &one(37), &anywhere, |[x]| x.tanh());
    check("tan", &one(38), &[[0.3], [-0.7], [1.5]], |[x]| x.tan());
    check("sqrt", &one(39), &positive, |[x]| x.sqrt());
    check("sinh", &one(40), &anywhere, |[x]| x.sinh());
    check("sin", &one(41), &anywhere, |[x]| x.sin());
    check("log10", &one(42), &positive, |[x]| x.log10());
    check("log", &one(43), &positive, |[x]| x.ln());
    check("exp", &one(44), &anywhere, |[x]| x.exp());
    check("cosh", &one(45), &anywhere, |[x]| x.cosh());
    check("cos", &one(46), &anywhere, |[x]| x.cos());
    check("atanh", &one(47), &between, |[x]| x.atanh());
    check("atan", &one(49), &anywhere, |[x]| x.atan());
    check("asinh", &one(50), &anywhere, |[x]| x.asinh());
    check("asin", &one(51), &between, |[x]| x.asin());
    check("acosh", &one(52), &[[1.0 + 1e-3], [2.6], [700.0]], |[x]| x.acosh());
    check("acos", &one(53), &between, |[x]| x.acos());
    check("square", &one(77), &anywhere, |[x]| x * x);
}

#[test]
fn functions_of_two_numbers_are_those_of_the_format() {
    let points = [[0.3, 1.7], [-2.4, 0.9], [5.5, -2.1], [-7.3, -3.2]];
    let two = |code| op(code, [v(0), v(1)]);
    check("plus", &two(0), &points, |[x, y]| x + y);
    check("minus", &two(1), &points, |[x, y]| x - y);
    check("times", &two(2), &points, |[x, y]| x * y);
    check("divided by", &two(3), &points, |[x, y]| x / y);
    check("mod", &two(4), &points, |[x, y]| x % y);
    check("power", &two(5), &[[0.3, 1.7], [2.4, -0.9]], f64_pow);
    check("power of a constant", &op(78, [n(1.5), v(0)]), &[[0.3], [-2.0]], |[y]| 1.5_f64.powf(y));
    check("constant power", &op(76, [v(0), n(2.5)]), &[[0.3], [2.0]], |[x]| x.powf(2.5));
    check("integer power", &op(5, [v(0), n(-3.0)]), &[[0.3], [-2.0]], |[x]| 1.0 / (x * x * x));
    check("less", &two(6), &points, |[x, y]| (x - y).max(0.0));
    check("atan2", &two(48), &points, |[y, x]| y.atan2(x));
    check("div", &two(55), &points, |[x, y]| (x / y).trunc());
}

fn f64_pow([x, y]: [f64; 2]) -> f64 {
    x.powf(y)
}

#[test]
fn rounding_is_to_digits_or_decimals_and_has_no_slope() {
    let to = |code, digits| op(code, [v(0), n(digits)]);
    check("precision", &to(56, 3.0), &[[1234.4], [-0.012_344]], |[x]| {
        if x > 0.0 { 1230.0 } else { -0.0123 }
    });
    check("round", &to(57, 1.0), &[[2.27], [-2.24]], |[x]| (x * 10.0).round() / 10.0);
    check("round to hundreds", &to(57, -2.0), &[[1234.4]], |_| 1200.0);
    check("trunc", &to(58, 1.0), &[[2.27], [-2.24]], |[x]| (x * 10.0).trunc() / 10.0);
}

#[test]
fn lists_of_operands_are_folded_from_the_left() {
    let points = [[0.3, 1.7, -0.4], [5.0, -2.0, 5.5]];
    let list = |code| many(code, [v(0), v(1), v(2)]);
    check("min", &list(11), &points, |[x, y, z]| x.min(y).min(z));
    check("max", &list(12), &points, |[x, y, z]| x.max(y).max(z));
    check("sum", &list(54), &points, |[x, y, z]| x + y + z);
    check("sum of one", &many(54, [v(0)]), &[[0.3]], |[x]| x);
    let equal = many(60, [v(0), v(1), v(2), n(0.3), n(5.0)]);
    check("numberof", &equal, &points, |_| 1.0);
}

type Comparison = fn(f64, f64) -> bool;

#[test]
fn conditions_choose_by_value_and_the_derivative_is_that_of_the_arm_taken() {
    let arms = |condition| op(35, [condition, op(41, [v(0)]), op(2, [v(1), v(1)])]);
    let points = [[0.3, 1.7], [2.0, 2.0], [3.0, -1.0]];
    let choose =
        |which: Comparison| move |[x, y]: [f64; 2]| if which(x, y) { x.sin() } else { y * y };
    let compare: [(u32, Comparison); 6] = [
        (22, |x, y| x < y),
        (23, |x, y| x <= y),
        (24, |x, y| x == y),
        (28, |x, y| x >= y),
        (29, |x, y| x > y),
        (30, |x, y| x != y),
    ];
    for (code, which) in compare {
        // At x = y differences would jump: values only.
        let expression = arms(op(code, [v(0), v(1)]));
        check("if", &expression, &[points[0], points[2]], choose(which));
        let model = model_of(&expression, 2).write(FORMS[0]);
        let model = NlModel::parse(&model, Names::default()).unwrap();
        let expected = choose(which)(points[1]);
        assert_eq!(first_row(&model, &points[1]), expected, "o{code} at a tie");
    }
}

#[test]
fn logical_operators_follow_their_truth_tables() {
    // v0 > 0 and v1 > 0 in all four combinations.
    let points = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
    let x = || op(29, [v(0), n(0.0)]);
    let y = || op(29, [v(1), n(0.0)]);
    let value = |condition| op(35, [condition, n(2.0), n(3.0)]);
    let table = |truth: [bool; 4]| {
        move |z: [f64; 2]| {
            let k = points.iter().position(|point| *point == z).unwrap();
            if truth[k] { 2.0 } else { 3.0 }
        }
    };
    let cases = [
        ("or", op(20, [x(), y()]), [true, true, true, false]),
        ("and", op(21, [x(), y()]), [true, false, false, false]),
        ("not", op(34, [x()]), [false, false, true, true]),
        ("forall", many(70, [x(), y(), n(1.0)]), [true, false, false, false]),
        ("exists", many(71, [x(), y(), n(0.0)]), [true, true, true, false]),
        ("implies", op(72, [x(), y(), n(1.0)]), [true, false, true, true]),
        ("iff", op(73, [x(), y()]), [true, false, false, true]),
        ("atleast 1", op(62, [n(1.0), many(59, [x(), y()])]), [true, true, true, false]),
        ("atmost 1", op(63, [n(1.0), many(59, [x(), y()])]), [false, true, true, true]),
        ("exactly 1", op(66, [n(1.0), many(59, [x(), y()])]), [false, true, true, false]),
        ("not atleast 1", op(67, [n(1.0), many(59, [x(), y()])]), [false, false, false, true]),
        ("not atmost 1", op(68, [n(1.0), many(59, [x(), y()])]), [true, false, false, false]),
        ("not exactly 1", op(69, [n(1.0), many(59, [x(), y()])]), [true, false, false, true]),
        ("a number as condition", op(6, [v(0), n(0.0)]), [true, true, false, false]),
    ];
    for (name, condition, truth) in cases {
        check(name, &value(condition), &points, table(truth));
    }
    check("count", &many(59, [x(), y(), n(7.0)]), &points, |[x, y]| {
        1.0 + f64::from(x > 0.0) + f64::from(y > 0.0)
    });
}

#[test]
fn a_piecewise_linear_term_is_0_at_0_and_has_its_slopes_between_its_breakpoints() {
    let term = Node::Piecewise(vec![-1.0, 0.5, 2.0, 3.0], vec![-2.0, 1.0, 4.0], 0);
    check(
        "<<-2, 1, 4; -1, 0.5, 2, 3>>",
        &term,
        &[[-5.0], [-1.0], [0.0], [0.5], [3.0], [6.0]],
        |[x]| {
            let left = if x < -2.0 { -1.0 - (x + 2.0) } else { 0.5 * x.min(1.0) };
            left + 2.0 * (x.min(4.0) - 1.0).max(0.0) + 3.0 * (x - 4.0).max(0.0)
        },
    );
}

#[test]
fn constants_of_all_kinds_are_numbers_and_are_combined_when_read() {
    let sum = many(54, [n(1.5), Node::Short(-300), Node::Long(70_000), v(0)]);
    check("constants", &sum, &[[0.25]], |[x]| 69_701.5 + x);
    let power = op(5, [v(0), op(0, [n(1.0), n(1.0)])]);
    check("exponent 1 + 1", &power, &[[-3.0]], |[x]| x * x);
    let operations = |constant: Node| {
        let file = model_of(&op(0, [constant, v(0)]), 1);
        let model = NlModel::parse(&file.write(FORMS[0]), Names::default()).unwrap();
        AdProblem::new(model).unwrap().operations()
    };
    assert_eq!(operations(op(2, [n(2.0), n(3.0)])), operations(n(6.0)));
}

#[test]
fn sums_of_constants_that_cancel_to_rounding_errors_are_0() {
    let difference = |numbers: [f64; 3]| {
        let [a, b, c] = numbers.map(n);
        let file = model_of(&op(1, [op(1, [a, b]), c]), 1);
        first_row(&NlModel::parse(&file.write(FORMS[0]), Names::default()).unwrap(), &[1.0])
    };
    assert_eq!(difference([0.3, 0.1, 0.2]), 0.0);
    assert_eq!(difference([0.3, 0.1, 0.2 + 1e-15]), 0.3 - 0.1 - (0.2 + 1e-15));
}

#[test]
fn the_second_operand_counts_only_where_the_first_does_not_decide() {
    // v0 > 0 and log(v0) < 3; v0 <= 0 or log(v0) < 3.
    let small = || op(22, [op(43, [v(0)]), n(3.0)]);
    let points = [[-3.0], [2.0], [30.0]];
    let is = |truth: bool| f64::from(truth);
    let and = op(21, [op(29, [v(0), n(0.0)]), small()]);
    check("and", &and, &points, |[x]| is(x > 0.0 && x.ln() < 3.0));
    let or = op(20, [op(23, [v(0), n(0.0)]), small()]);
    check("or", &or, &points, |[x]| is(x <= 0.0 || x.ln() < 3.0));
}

#[test]
fn exponents_of_any_size_are_read() {
    for exponent in [f64::from(i32::MIN), f64::from(i32::MAX), 3e9, -1e300, 0.0] {
        let file = model_of(&op(5, [v(0), n(exponent)]), 1);
        let model = NlModel::parse(&file.write(FORMS[0]), Names::default()).unwrap();
        assert_eq!(first_row(&model, &[1.0]), 1.0);
    }
}

#[test]
fn defined_variables_are_read_by_rows_and_by_each_other() {
    // d2 = z0 z1 + 3 z0, d3 = exp(d2) − z1; row: d2 d3.
    let mut file = model_of(&op(2, [v(2), v(3)]), 2);
    file.definitions.push((vec![(0, 3.0)], op(2, [v(0), v(1)])));
    file.definitions.push((vec![(1, -1.0)], op(44, [v(2)])));
    for form in FORMS {
        let model = NlModel::parse(&file.write(form), Names::default()).unwrap();
        let z = [0.3, -0.4];
        let d2: f64 = z[0] * z[1] + 3.0 * z[0];
        assert!((first_row(&model, &z) - d2 * (d2.exp() - z[1])).abs() < 1e-15);
        check_derivatives(&model, &z).unwrap().verdict().unwrap();
    }
}

#[test]
fn operators_without_meaning_for_real_numbers_are_named() {
    let cases = [
        (many(74, [v(0)]), "`alldiff` is for integer variables"),
        (many(75, [v(0)]), "`alldiff` is for integer variables"),
        (many(61, [v(0)]), "operators on strings"),
        (op(65, [v(0), v(0), v(0)]), "operators on strings"),
        (op(36, [v(0)]), "expected the number of an operator, found `o36`"),
    ];
    for (expression, message) in cases {
        let error = NlModel::parse(&model_of(&expression, 1).write(FORMS[0]), Names::default());
        let error = error.unwrap_err().to_string();
        assert!(error.starts_with("line 12, segment C0: ") && error.contains(message), "{error}");
    }
}
