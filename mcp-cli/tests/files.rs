//! Reading from a directory, answering with `.sol` text, and putting equations into rows.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

use mcp_cli::nl::{Names, NlError, NlModel};
use mcp_core::{AdProblem, Model, Options, Problem, solve};
use std::fs;
use std::path::Path;
use support::library::directory;
use support::node::{many, n, op, plus, v};
use support::{File, Form, INF, Kind, Node, Row};

const FREE: (f64, f64, f64) = (-INF, INF, 0.0);

fn parse(file: &File) -> NlModel {
    NlModel::parse(&file.write(Form::Text), Names::default()).unwrap()
}

#[test]
fn a_file_is_found_with_and_without_its_suffix_and_names_lie_beside_it() {
    for path in [directory().join("transport.nl"), directory().join("transport")] {
        let model = NlModel::read(&path).unwrap();
        assert_eq!(model.shape().variable_name(1), "w[san-diego]");
        assert_eq!((model.variables(), model.constraints()), (22, 22));
    }
    let nameless = NlModel::read(&directory().join("free")).unwrap();
    assert_eq!(nameless.shape().variable_name(0), "_svar[1]");
}

#[test]
fn a_stub_may_contain_dots() {
    let stub = Path::new(env!("CARGO_TARGET_TMPDIR")).join("a.stub.1");
    fs::copy(directory().join("free.nl"), stub.with_file_name("a.stub.1.nl")).unwrap();
    fs::write(stub.with_file_name("a.stub.1.col"), "x\ny\n").unwrap();
    assert_eq!(NlModel::read(&stub).unwrap().shape().variable_name(1), "y");
}

#[test]
fn names_may_be_latin_1_and_end_with_blank_lines() {
    let stub = Path::new(env!("CARGO_TARGET_TMPDIR")).join("latin_1");
    fs::copy(directory().join("free.nl"), stub.with_extension("nl")).unwrap();
    fs::write(stub.with_extension("col"), b"\xe4\n\xf6\n\n").unwrap();
    let model = NlModel::read(&stub).unwrap();
    assert_eq!([0, 1].map(|j| model.shape().variable_name(j)), ["ä", "ö"]);
    assert!(model.warnings().is_empty());
}

#[test]
fn a_file_that_does_not_exist_is_named() {
    let error = NlModel::read(Path::new("nowhere/model")).unwrap_err();
    assert!(matches!(error, NlError::Io { .. }));
    assert!(error.to_string().starts_with("cannot read nowhere/model.nl: "));
}

#[test]
fn a_sol_file_has_message_options_counts_values_and_result() {
    let model = NlModel::read(&directory().join("rows")).unwrap();
    let z: Vec<f64> = (0..9).map(|j| f64::from(j) / 3.0 * 10_f64.powi(4 * j - 16)).collect();
    let f = vec![0.25; 9];
    let sol = model.sol(&z, &f, "first\n\nthird line", 201);
    let lines: Vec<&str> = sol.lines().collect();
    assert_eq!(lines[..5], ["first", " ", "third line", "", "Options"]);
    assert_eq!(lines[5..13], ["3", "1", "1", "0", "9", "9", "9", "9"]);
    assert_eq!(lines[13..17], ["0.25"; 4]);
    let levels: Vec<f64> = lines[22..31].iter().map(|line| line.parse().unwrap()).collect();
    assert_eq!(levels, z, "all digits come back");
    assert_eq!(lines[31..], ["objno 0 201"]);

    let none = model.sol(&[], &[], "no answer", 500);
    assert!(none.ends_with("\n3\n1\n1\n0\n9\n0\n9\n0\nobjno 0 500\n"));
}

#[test]
fn a_tolerance_of_the_header_goes_back_behind_the_counts() {
    let text = fs::read_to_string(directory().join("free.nl")).unwrap();
    let text = text.replacen("g3 1 1 0", "g3 2 3 0 1e-7", 1);
    let model = NlModel::parse(text.as_bytes(), Names::default()).unwrap();
    let sol = model.sol(&[1.0, 2.0], &[0.0, 0.0], "m", 0);
    assert_eq!(sol, "m\n\nOptions\n5\n2\n3\n0\n2\n2\n2\n2\n1e-7\n0\n0\n1\n2\nobjno 0 0\n");
}

/// `2 v + 7 ⟂ x >= 0`, `−4 v + (e^x + x − 5) = 3`.
fn with_auxiliary() -> File {
    let body = plus(op(44, [v(0)]), n(-5.0));
    File {
        variables: vec![(0.0, INF, 0.5), FREE],
        rows: vec![
            Row(Kind::Complements(1, 0), vec![(1, 2.0)], n(7.0)),
            Row(Kind::Equal(3.0), vec![(0, 1.0), (1, -4.0)], body),
        ],
        ..File::default()
    }
}

/// `F` and the structural nonzeros of its first row, at `z`.
fn evaluated(model: &NlModel, z: &[f64]) -> (Vec<f64>, Vec<usize>) {
    let mut problem = AdProblem::new(model).unwrap();
    let mut f = vec![0.0; z.len()];
    problem.evaluate(z, Some(&mut f), None);
    let first = problem.pattern().entries().filter(|entry| entry.1 == 0).map(|entry| entry.2);
    (f, first.collect())
}

#[test]
fn an_auxiliary_variable_that_is_the_body_of_a_row_is_replaced_by_its_equation() {
    let model = parse(&with_auxiliary());
    let r = |x: f64| x.exp() - 5.0 + x - 3.0;
    let (x, v) = (0.7_f64, 9.0);
    let (f, reads) = evaluated(&model, &[x, v]);
    // c − (a/b) r = 7 + r/2, and the equation itself.
    assert!((f[0] - (7.0 + r(x) / 2.0)).abs() < 1e-14 && (f[1] - (r(x) - 4.0 * v)).abs() < 1e-14);
    assert_eq!(reads, [0]);
    // Where the file gives v no start, it starts on its equation.
    let text = String::from_utf8(with_auxiliary().write(Form::Text)).unwrap();
    let text = text.replace("\nx2\n0 0.5\n1 0.0\n", "\nx1\n0 0.5\n");
    let start = NlModel::parse(text.as_bytes(), Names::default()).unwrap().shape().start()[1];
    assert!((start - r(0.5) / 4.0).abs() < 1e-14);
    assert_eq!(model.shape().start()[1], 0.0, "a start in the file stays");
}

#[test]
fn an_auxiliary_variable_stays_where_its_equation_does_not_define_it() {
    let unchanged = |file: &File, reads: &[usize]| {
        let model = parse(file);
        let z = vec![0.7; file.variables.len()];
        assert_eq!(evaluated(&model, &z).1, reads);
    };
    // v also inside the expression of its equation.
    let mut nonlinear = with_auxiliary();
    nonlinear.rows[1].2 = op(44, [v(1)]);
    unchanged(&nonlinear, &[1]);
    // v in a defined variable.
    let mut defined = with_auxiliary();
    defined.definitions.push((vec![(1, 1.0)], n(0.0)));
    defined.rows[1].2 = v(2);
    unchanged(&defined, &[1]);
    // v in two equations.
    let mut twice = with_auxiliary();
    twice.variables.push(FREE);
    twice.rows.push(Row(Kind::Equal(0.0), vec![(1, 1.0), (2, 1.0)], n(0.0)));
    unchanged(&twice, &[1]);
    // v with a row of its own.
    let mut paired = with_auxiliary();
    paired.variables.push(FREE);
    paired.rows.push(Row(Kind::Complements(0, 1), vec![(2, 1.0)], n(0.0)));
    unchanged(&paired, &[1]);
}

#[test]
fn one_equation_defines_one_variable_only() {
    // v ⟂ x >= 0, w ⟂ y >= 0, v + w = x + y, w = 2.
    let at_0 = (0.0, INF, 1.0);
    let file = File {
        variables: vec![at_0, at_0, FREE, FREE],
        rows: vec![
            Row(Kind::Complements(1, 0), vec![(2, 1.0)], n(0.0)),
            Row(Kind::Complements(1, 1), vec![(3, 1.0)], n(0.0)),
            Row(Kind::Equal(0.0), vec![(0, -1.0), (1, -1.0), (2, 1.0), (3, 1.0)], n(0.0)),
            Row(Kind::Equal(2.0), vec![(3, 1.0)], n(0.0)),
        ],
        ..File::default()
    };
    let model = parse(&file);
    let (f, _) = evaluated(&model, &[1.0, 2.0, 3.0, 4.0]);
    // w is in two equations and stays; v = x + y − w.
    assert_eq!(f, [1.0 + 2.0 - 4.0, 4.0, 3.0 + 4.0 - 3.0, 2.0]);
}

/// `d_0 = z_0`, `d_k = d_{k−1}²/4 + z_k`; `d_k + z_k/2 = 1`.
fn chain(size: usize) -> File {
    let square = |k: usize| op(3, [op(77, [v(size + k - 1)]), n(4.0)]);
    let definition = |k: usize| (vec![(k, 1.0)], if k == 0 { n(0.0) } else { square(k) });
    let row = |k: usize| Row(Kind::Equal(1.0), vec![(k, 0.5)], v(size + k));
    File {
        variables: vec![(-INF, INF, 0.25); size],
        rows: (0..size).map(row).collect(),
        definitions: (0..size).map(definition).collect(),
        is_incomplete: true,
    }
}

#[test]
fn defined_variables_that_would_fill_the_jacobian_are_variables_behind_those_of_the_file() {
    let (small, large) = (parse(&chain(100)), parse(&chain(5000)));
    assert_eq!((small.shape().n(), small.shape().definition_count()), (100, 100));
    assert_eq!((large.shape().n(), large.shape().definition_count()), (10_000, 0));
    assert_eq!((large.variables(), large.constraints()), (5000, 5000));
    assert_eq!(large.shape().variable_name(5000), "_sdef[1]");
    // At the start d_0 = 1/4, d_1 = 1/64 + 1/4.
    assert_eq!(large.shape().start()[5000..5002], [0.25, 0.265_625]);
    let problem = AdProblem::new(&large).unwrap();
    assert!(problem.pattern().nnz() < 30_000);

    let solution = solve(&small, &Options::default()).unwrap().solved().unwrap();
    let sparse = solve(&large, &Options::default()).unwrap().solved().unwrap();
    for (a, b) in solution.z.iter().zip(large.file_levels(&sparse.z)) {
        assert!((a - b).abs() < 1e-8);
    }
    let sol = large.sol(&sparse.z, &sparse.f, "solved", 0);
    assert!(sol.contains("\n5000\n5000\n5000\n5000\n") && sol.lines().count() == 10_012);
}

#[test]
fn a_long_sum_becomes_pieces_and_keeps_its_value_and_solution() {
    // Σ z_j² = n, z_j = z_0: all 1.
    let size: usize = 6000;
    let squares: [Node; 6000] = std::array::from_fn(|j| op(77, [v(j)]));
    let mut rows = vec![Row(Kind::Equal(6000.0), Vec::new(), many(54, squares))];
    let equal = |j| Row(Kind::Equal(0.0), vec![(0, -1.0), (j, 1.0)], n(0.0));
    rows.extend((1..size).map(equal));
    let file = File { variables: vec![(-INF, INF, 2.0); size], rows, ..File::default() };
    let model = parse(&file);
    let pieces = model.shape().n() - size;
    assert!((20..60).contains(&pieces), "{pieces}");

    let mut problem = AdProblem::new(&model).unwrap();
    let (start, mut f) = (model.shape().start().to_vec(), vec![0.0; size + pieces]);
    problem.evaluate(&start, Some(&mut f), None);
    assert_eq!(model.row_values(&start, &f)[0], 4.0 * 6000.0 - 6000.0);
    // No row reads many variables but the first, which reads the pieces only.
    assert!(problem.pattern().nnz() < 5 * size);
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let levels = model.file_levels(&solution.z);
    assert!(levels.iter().all(|z| (z - 1.0).abs() < 1e-9));
}
