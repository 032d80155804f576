//! Rows, bounds and names: what is paired with what, and the errors that name rows.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

use mcp_cli::nl::{Names, NlError, NlModel};
use mcp_core::{AdProblem, Model, Options, Problem, solve};
use support::node::{n, op, plus, v};
use support::{File, Form, INF, Kind, Node, Row};

const FREE: (f64, f64, f64) = (-INF, INF, 0.0);

fn file(variables: &[(f64, f64, f64)], rows: &[Row]) -> File {
    File { variables: variables.to_vec(), rows: rows.to_vec(), ..File::default() }
}

fn linear(kind: Kind, terms: &[(usize, f64)]) -> Row {
    Row(kind, terms.to_vec(), n(0.0))
}

fn names(columns: &[&str], rows: &[&str]) -> Names {
    let owned = |names: &[&str]| Some(names.iter().map(|&name| name.to_owned()).collect());
    Names { columns: owned(columns), rows: owned(rows) }
}

fn parse(file: &File, names: Names) -> Result<NlModel, NlError> {
    NlModel::parse(&file.write(Form::Text), names)
}

/// The message about a file whose variables are `x`, `y` and rows `f`, `g`.
fn message(variables: &[(f64, f64, f64)], rows: &[Row]) -> String {
    let names = names(&["x", "y"][..variables.len()], &["f", "g"][..rows.len()]);
    parse(&file(variables, rows), names).unwrap_err().to_string()
}

#[test]
fn an_inequality_without_a_variable_is_named() {
    for kind in [Kind::Lower(1.0), Kind::Upper(1.0), Kind::Range(0.0, 1.0)] {
        assert_eq!(
            message(&[FREE], &[linear(kind, &[(0, 1.0)])]),
            "row `f` is an inequality and complements no variable: write `f: … complements v >= 0` \
             with its multiplier `v`"
        );
    }
}

#[test]
fn the_bits_of_a_row_must_be_the_bounds_of_its_variable() {
    let boxed = (0.0, 10.0, 1.0);
    for (bits, said) in
        [(0, "no finite bound"), (1, "a lower bound only"), (2, "an upper bound only")]
    {
        assert_eq!(
            message(&[boxed], &[linear(Kind::Complements(bits, 0), &[(0, 1.0)])]),
            format!(
                "row `f` complements `x` with {said}, but its bounds are [0, 10]: make bounds and \
                 condition the same, for example `l <= x <= u complements …`"
            )
        );
    }
    let both = linear(Kind::Complements(3, 0), &[(0, 1.0)]);
    assert!(message(&[FREE], &[both]).contains("with both bounds, but its bounds are [-inf, inf]"));
}

#[test]
fn a_system_that_is_not_square_says_what_is_left_over() {
    let equation = |j| linear(Kind::Equal(1.0), &[(j, 1.0)]);
    assert_eq!(
        message(&[FREE], &[equation(0), equation(0)]),
        "the system is not square: 2 equations for 1 free variable that no row complements; `g` \
         is the first without one"
    );
    assert!(message(&[FREE, FREE], &[equation(0)]).ends_with("`y` is the first without one"));
    let fixed = (1.0, 1.0, 1.0);
    assert!(message(&[fixed], &[equation(0)]).contains("1 equation for 0 free variables"));
}

#[test]
fn a_variable_with_bounds_needs_a_row_that_complements_it() {
    assert_eq!(
        message(&[(0.0, INF, 1.0)], &[linear(Kind::Equal(1.0), &[(0, 1.0)])]),
        "variable `x` has bounds, [0, inf], but no row complements it: equations go with free \
         variables only"
    );
}

#[test]
fn a_variable_is_complemented_once() {
    let row = linear(Kind::Complements(1, 0), &[(0, 1.0)]);
    assert_eq!(
        message(&[(0.0, INF, 1.0)], &[row.clone(), row]),
        "variable `x` is complemented by both `f` and `g`"
    );
}

#[test]
fn crossed_bounds_and_infinite_equations_are_refused() {
    let row = linear(Kind::Complements(3, 0), &[(0, 1.0)]);
    let text = String::from_utf8(file(&[(0.0, 1.0, 0.0)], &[row]).write(Form::Text)).unwrap();
    let crossed =
        NlModel::parse(text.replace("\n0 0.0 1.0\n", "\n0 2 1\n").as_bytes(), Names::default());
    assert_eq!(
        crossed.unwrap_err().to_string(),
        "variable `_svar[1]` has crossed bounds: lower 2 is above upper 1"
    );
    let infinite = linear(Kind::Range(1e30, 1e30), &[(0, 1.0)]);
    assert!(matches!(
        parse(&file(&[FREE], &[infinite]), Names::default()),
        Err(NlError::Inequality { .. })
    ));
}

#[test]
fn bounds_from_1e20_on_are_infinite() {
    let variables = [(-1e20, 3e20, 0.0), (-9e19, 1e20, 0.0)];
    let rows =
        [linear(Kind::Equal(0.0), &[(0, 1.0)]), linear(Kind::Complements(1, 1), &[(1, 1.0)])];
    let model = parse(&file(&variables, &rows), Names::default()).unwrap();
    assert_eq!(model.shape().bounds().lower(), [-INF, -9e19]);
    assert_eq!(model.shape().bounds().upper(), [INF, INF]);
}

#[test]
fn equations_go_with_free_variables_so_that_the_diagonal_is_nonzero() {
    // f reads x and y, g only x: in order, g would go with y.
    let rows = [
        Row(Kind::Equal(3.0), Vec::new(), plus(v(0), op(44, [v(1)]))),
        linear(Kind::Equal(2.0), &[(0, 1.0)]),
    ];
    let model = parse(&file(&[FREE, FREE], &rows), names(&["x", "y"], &["f", "g"])).unwrap();
    assert_eq!(model.shape().equation_name(0), "g");
    assert_eq!(model.shape().equation_name(1), "f");
    let problem = AdProblem::new(&model).unwrap();
    assert!((0..2).all(|j| problem.pattern().position(j, j).is_some()));
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    assert!(
        (solution.level("x").unwrap() - 2.0).abs() < 1e-9
            && solution.level("y").unwrap().abs() < 1e-9
    );
}

#[test]
fn equations_that_cannot_be_matched_still_get_a_variable() {
    let rows = [linear(Kind::Equal(1.0), &[(0, 1.0)]), linear(Kind::Equal(1.0), &[(0, 1.0)])];
    let model = parse(&file(&[FREE, FREE], &rows), Names::default()).unwrap();
    assert_eq!(model.shape().row_count(), 2);
}

#[test]
fn constants_of_bodies_and_right_hand_sides_are_subtracted() {
    // 2 x + 1 = 7 and y + 3 >= 0 at y = 0.
    let rows = [
        Row(Kind::Equal(7.0), vec![(0, 2.0)], n(1.0)),
        Row(Kind::Complements(1, 1), vec![(1, 1.0)], n(3.0)),
    ];
    let model = parse(&file(&[FREE, (0.0, INF, 5.0)], &rows), Names::default()).unwrap();
    let mut f = [0.0; 2];
    AdProblem::new(&model).unwrap().evaluate(&[1.0, 2.0], Some(&mut f), None);
    assert_eq!(f, [-4.0, 5.0]);
}

#[test]
fn names_are_used_as_they_are() {
    let rows = [linear(Kind::Equal(1.0), &[(0, 1.0)]), linear(Kind::Equal(2.0), &[(1, 1.0)])];
    let file = file(&[FREE, FREE], &rows);
    // Names of objectives may follow those of rows.
    let given = names(&["x['a','b']", "y"], &["bal['a']", "f", "cost"]);
    let model = parse(&file, given).unwrap();
    assert_eq!(model.shape().variable_name(0), "x['a','b']");
    assert_eq!(model.shape().equation_name(0), "bal['a']");
    assert_eq!(model.shape().variable_index("y"), Ok(1));
    let generic = parse(&file, Names::default()).unwrap();
    assert_eq!(generic.shape().variable_name(1), "_svar[2]");
    assert_eq!(generic.shape().equation_name(1), "_scon[2]");
}

#[test]
fn names_that_do_not_fit_give_way_to_generic_ones_with_a_warning() {
    let rows = [linear(Kind::Equal(1.0), &[(0, 1.0)]), linear(Kind::Equal(2.0), &[(1, 1.0)])];
    let file = file(&[FREE, FREE], &rows);
    let columns = |reason: &str| {
        format!("the names in .col are not used, {reason}: columns are called _svar[1], …")
    };
    for (names, warning) in [
        (names(&["x"], &["f", "g"]), columns("1 for 2 columns")),
        (names(&["x", "y", "z"], &["f", "g"]), columns("3 for 2 columns")),
        (names(&["x", "x"], &["f", "g"]), columns("`x` stands there twice")),
    ] {
        let model = parse(&file, names).unwrap();
        assert_eq!(model.warnings(), [warning]);
        assert_eq!(model.shape().variable_name(1), "_svar[2]");
        assert_eq!(model.shape().equation_name(1), "g");
    }
    let few_rows = parse(&file, names(&["x", "y"], &["f"])).unwrap();
    assert_eq!(few_rows.warnings().len(), 1);
    assert_eq!(few_rows.shape().equation_name(0), "_scon[1]");
    assert!(parse(&file, names(&["x", "y"], &["f", "g"])).unwrap().warnings().is_empty());
}

/// A text file with these counts of binary and integer variables, and these segments in front.
fn altered(change: impl Fn(String) -> String) -> String {
    let rows = [linear(Kind::Equal(1.0), &[(0, 1.0)]), linear(Kind::Equal(2.0), &[(1, 1.0)])];
    let text = String::from_utf8(file(&[FREE, FREE], &rows).write(Form::Text)).unwrap();
    let changed = change(text.clone());
    assert_ne!(text, changed);
    match NlModel::parse(changed.as_bytes(), names(&["x", "y"], &["f", "g"])) {
        Ok(_) => String::new(),
        Err(error) => error.to_string(),
    }
}

#[test]
fn what_a_complementarity_problem_lacks_is_refused_by_name() {
    let discrete = |line: &'static str| {
        move |text: String| text.replace(" 0 0 0 0 0\t# discrete", &format!(" {line}\t# discrete"))
    };
    assert_eq!(
        altered(discrete("0 1 0 0 0")),
        "1 variable must be integral, the first `y`: a complementarity problem has real variables \
         only"
    );
    assert!(
        altered(discrete("1 1 0 0 0")).starts_with("2 variables must be integral, the first `x`")
    );
    assert!(altered(discrete("0 0 0 1 0")).contains("the first `y`"));

    let objective = |segment: &'static str| {
        move |text: String| {
            text.replace(" 2 2 0 ", " 2 2 1 ").replace("\nr\n", &format!("\n{segment}\nr\n"))
        }
    };
    assert_eq!(altered(objective("O0 0\nn3")), "", "a constant asks for nothing");
    assert_eq!(altered(objective("O0 0\nn3\nG0 1\n0 0")), "");
    assert_eq!(
        altered(objective("O0 0\nv1")),
        "line 18, segment O0: the file has an objective, but a complementarity problem has none: \
         write the optimality conditions as `complements`, or in Rust use mcp_core::kkt"
    );
    assert!(
        altered(objective("O0 1\nn0\nG0 1\n0 1")).starts_with("line 20, segment G0: the file has")
    );

    let function = |text: String| {
        text.replace(" 0 0 0 1\t", " 0 1 0 1\t").replace("\nC0", "\nF0 1 -1 gsl_sf_gamma\nC0")
    };
    assert_eq!(
        altered(function),
        "line 11, segment F0: the function `gsl_sf_gamma` is imported, which is not supported"
    );
    assert_eq!(
        altered(|text| text.replace(" 2 2 0 0 2\t", " 2 2 0 0 2 1\t")),
        "line 2, header line 2: 1 logical rows: a complementarity problem has none"
    );
}

#[test]
fn suffixes_duals_and_column_lengths_are_read_over() {
    let more = |text: String| {
        let suffixes = "S0 1 sstatus\n0 3\nS5 2 slack\n0 1.5\n1 -2\nd1\n1 0.25\n";
        let text = text.replace("\nC0", &format!("\n{suffixes}C0"));
        text.replace("\nk1\n", "\nK1\n")
    };
    assert_eq!(altered(more), "");
}

#[test]
fn faults_name_line_segment_what_was_expected_and_what_was_found() {
    let cases: [(&str, &str, &str); 9] = [
        (
            "\nC1\n",
            "\nC2\n",
            "line 13, segment C: expected the number of the segment from 0 to 1, found `2`",
        ),
        ("\nC1\n", "\nC0\n", "line 13, segment C0: expected one segment C0 only, found `C0`"),
        (
            "\nC1\nn0.0",
            "\nC1\nnzero",
            "line 14, segment C1: expected a finite number, found `zero`",
        ),
        (
            "\nr\n4 1.0",
            "\nr\n7 1.0",
            "line 19, segment r: expected a kind of bounds, 0 to 5, found `7`",
        ),
        (
            "\nr\n4 1.0",
            "\nr\n5 4 1",
            "line 19, segment r: expected which bounds are finite, from 0 to 3, found `4`",
        ),
        (
            "\nr\n4 1.0",
            "\nr\n5 1 3",
            "line 19, segment r: expected the number of a variable from 1 to 2, found `3`",
        ),
        (
            "\nk1\n",
            "\nk2\n",
            "line 24, segment k: expected 1, the number of columns less one, found `2`",
        ),
        (
            "\nJ1 1\n",
            "\nQ1 1\n",
            "line 28, next segment: expected one of the segments F S V C L O d x r b k K J G, found `Q1`",
        ),
        (
            "\nJ1 1\n",
            "\nJ1 2\n",
            "line 30, segment J1: expected the number of a variable, found the end of the file",
        ),
    ];
    for (from, to, message) in cases {
        assert_eq!(altered(|text| text.replace(from, to)), message);
    }
    let twice = altered(|text| text.replace("\nb\n", "\nr\n"));
    assert!(twice.contains("segment r: expected one segment r only, found `r`"), "{twice}");
    let missing = altered(|text| text.replace("\nC0\nn0.0\n", "\nC0\nv2\n"));
    assert!(
        missing.starts_with("line 12, segment C0: expected the number of a variable from 0 to 1"),
        "{missing}"
    );
    let undefined = altered(|text| {
        text.replace(" 0 0 0 0 0\t# common", " 1 0 0 0 0\t# common")
            .replace("\nC0\nn0.0\n", "\nC0\nv2\n")
    });
    assert_eq!(
        undefined,
        "line 12, segment C0: expected a segment V2 before its first use, found `2`"
    );
}

#[test]
fn faults_of_binary_files_name_bytes() {
    let rows = [Row(Kind::Equal(1.0), vec![(0, 1.0)], Node::Number(0.0))];
    let mut bytes = file(&[FREE], &rows).write(Form::LittleEndian);
    let at = bytes.windows(2).position(|pair| pair == b"C\0").unwrap();
    bytes[at + 5] = b'q';
    assert_eq!(
        NlModel::parse(&bytes, Names::default()).unwrap_err().to_string(),
        format!(
            "byte {}, segment C0: expected one of `n`, `s`, `l`, `v`, `o`, found the bytes 71 00 00 \
             00 00 00 00 00",
            at + 5
        )
    );
}
