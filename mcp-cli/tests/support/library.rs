//! The files of `examples/data/nl` that the writer makes.

use super::node::{many, n, op, plus, power, product, sum, times, v};
use super::{File, Form, INF, Kind, Node, Row};
use std::path::PathBuf;

/// The directory of the library.
pub(crate) fn directory() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/data/nl"))
}

/// A file with its name, its form and its names of variables and rows.
pub(crate) struct Entry {
    pub(crate) name: &'static str,
    pub(crate) form: Form,
    pub(crate) file: File,
    pub(crate) names: Option<(Vec<String>, Vec<String>)>,
}

/// All files that the writer makes.
pub(crate) fn written() -> Vec<Entry> {
    let entry = |name, form, file: File| Entry { name, form, file, names: None };
    let (operators, names) = operators();
    vec![
        Entry { names: Some(names), ..entry("operators", Form::Text, operators.clone()) },
        entry("operators_big_endian", Form::BigEndian, operators),
        entry("rows", Form::Text, rows()),
        entry("rows_little_endian", Form::LittleEndian, rows()),
        entry("defined", Form::Text, defined()),
        entry("kojima_shindo_little_endian", Form::LittleEndian, kojima_shindo()),
        entry("kojima_shindo_big_endian", Form::BigEndian, kojima_shindo()),
    ]
}

/// Every kind of row and of bounds.
///
/// ```text
/// z0 >= 1             z0² − 4           3 in between: 2
/// z1 <= 5             z1 − 9            at the bound, F = −4
/// −1 <= z2 <= 1       z2 + z0 − 7       at the upper bound, F = −4
/// z3 free             z3 − 3            by `5 0 4`
/// z4 fixed at 2       no row
/// z5 fixed at 3       z5 + 10           any value
/// z6, z7 free         z6 + z7 = 5, z6 − z7 = 1
/// nothing             z6 z7             a row without bounds
/// z8 >= 0             z8 + 1            at the bound, F = 1
/// ```
fn rows() -> File {
    let complements = |bits, j, linear: &[(usize, f64)], node| {
        Row(Kind::Complements(bits, j), linear.to_vec(), node)
    };
    File {
        variables: vec![
            (1.0, INF, 3.0),
            (-INF, 5.0, 0.0),
            (-1.0, 1.0, 0.0),
            (-INF, INF, 0.0),
            (2.0, 2.0, 2.0),
            (3.0, 3.0, 3.0),
            (-INF, INF, 0.0),
            (-INF, INF, 0.0),
            (0.0, INF, 4.0),
        ],
        rows: vec![
            complements(1, 0, &[], plus(power(v(0), 2.0), n(-4.0))),
            complements(2, 1, &[(1, 1.0)], n(-9.0)),
            complements(3, 2, &[(2, 1.0), (0, 1.0)], n(-7.0)),
            complements(0, 3, &[(3, 1.0)], n(-3.0)),
            complements(3, 5, &[(5, 1.0)], n(10.0)),
            Row(Kind::Equal(5.0), vec![(6, 1.0), (7, 1.0)], n(0.0)),
            Row(Kind::Range(1.0, 1.0), vec![(6, 1.0), (7, -1.0)], n(0.0)),
            Row(Kind::Nothing, Vec::new(), times(v(6), v(7))),
            complements(1, 8, &[(8, 1.0)], n(1.0)),
        ],
        ..File::default()
    }
}

/// A cost with two defined variables, one read by the other: `d = z0 + z1`, `e = d²/2 + z0`,
/// `z0 − 4 + d >= 0 ⟂ z0 >= 0`, `e − 8 >= 0 ⟂ z1 >= 0`: `z = (0, 4)`.
fn defined() -> File {
    let both = (0.0, INF, 1.0);
    File {
        variables: vec![both, both],
        rows: vec![
            Row(Kind::Complements(1, 0), vec![(0, 1.0)], plus(v(2), n(-4.0))),
            Row(Kind::Complements(1, 1), Vec::new(), plus(v(3), n(-8.0))),
        ],
        definitions: vec![
            (vec![(0, 1.0), (1, 1.0)], n(0.0)),
            (vec![(0, 1.0)], op(3, [power(v(2), 2.0), n(2.0)])),
        ],
        ..File::default()
    }
}

/// The problem of Kojima and Shindo, rows as in `mcp_core::mcp_fn`.
fn kojima_shindo() -> File {
    let row = |i, constant: f64, linear: &[(usize, f64)], quadratic: &[(f64, usize, usize)]| {
        let mut terms: Vec<Node> = quadratic.iter().map(|&(c, x, y)| product(c, x, y)).collect();
        terms.push(n(constant));
        Row(Kind::Complements(1, i), linear.to_vec(), sum(terms))
    };
    let start = [1.0, 0.5, 1.0, 0.0];
    File {
        variables: start.iter().map(|&start| (0.0, INF, start)).collect(),
        rows: vec![
            row(0, -6.0, &[(2, 1.0), (3, 3.0)], &[(3.0, 0, 0), (2.0, 0, 1), (2.0, 1, 1)]),
            row(1, -2.0, &[(0, 1.0), (2, 10.0), (3, 2.0)], &[(2.0, 0, 0), (1.0, 1, 1)]),
            row(2, -9.0, &[(2, 2.0), (3, 9.0)], &[(3.0, 0, 0), (1.0, 0, 1), (2.0, 1, 1)]),
            row(3, -3.0, &[(2, 2.0), (3, 3.0)], &[(1.0, 0, 0), (3.0, 1, 1)]),
        ],
        ..File::default()
    }
}

/// `y_k = operator_k(x)` for every operator of the format, with `x0 = 0.3` and `x1 = 1.7` fixed.
fn operators() -> (File, (Vec<String>, Vec<String>)) {
    let one = |code| op(code, [v(0)]);
    let two = |code| op(code, [v(0), v(1)]);
    let list = |code| many(code, [v(0), v(1), n(1.0)]);
    let if_else = |condition| op(35, [condition, v(0), v(1)]);
    let some = || many(59, [op(22, [v(0), v(1)]), op(29, [v(0), v(1)])]);
    let mut all: Vec<(String, Node)> = Vec::new();
    for code in [13, 14, 15, 16, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 49, 50, 51, 53, 77] {
        all.push((format!("o{code}"), one(code)));
    }
    all.push(("o52".to_owned(), op(52, [v(1)])));
    for code in [0, 1, 2, 3, 4, 5, 6, 48, 55, 76, 78] {
        all.push((format!("o{code}"), two(code)));
    }
    for code in [56, 57, 58] {
        all.push((format!("o{code}"), op(code, [times(v(0), v(1)), n(1.0)])));
    }
    for code in [22, 23, 24, 28, 29, 30] {
        all.push((format!("o35_o{code}"), if_else(two(code))));
    }
    for code in [20, 21, 73] {
        let condition = op(code, [op(22, [v(0), v(1)]), op(29, [v(0), v(1)])]);
        all.push((format!("o35_o{code}"), if_else(condition)));
    }
    all.push(("o35_o34".to_owned(), if_else(op(34, [two(22)]))));
    all.push(("o35_o72".to_owned(), if_else(op(72, [two(22), two(29), n(1.0)]))));
    for code in [62, 63, 66, 67, 68, 69] {
        all.push((format!("o35_o{code}"), if_else(op(code, [n(1.0), some()]))));
    }
    for code in [11, 12, 54, 60] {
        all.push((format!("o{code}"), list(code)));
    }
    for code in [70, 71] {
        all.push((format!("o35_o{code}"), if_else(many(code, [two(22), two(29)]))));
    }
    all.push(("o59".to_owned(), some()));
    all.push(("o64".to_owned(), Node::Piecewise(vec![-1.0, 0.5, 2.0], vec![-2.0, 1.0], 1)));

    let mut file = File { variables: vec![(0.3, 0.3, 0.3), (1.7, 1.7, 1.7)], ..File::default() };
    let mut columns = vec!["x0".to_owned(), "x1".to_owned()];
    let mut rows = Vec::new();
    for (k, (name, node)) in all.into_iter().enumerate() {
        file.variables.push((-INF, INF, 0.0));
        file.rows.push(Row(Kind::Equal(0.0), vec![(k + 2, -1.0)], node));
        columns.push(format!("y['{name}']"));
        rows.push(format!("is['{name}']"));
    }
    (file, (columns, rows))
}
