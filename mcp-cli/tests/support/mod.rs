//! A writer of small `.nl` files, text and binary, for tests and benchmarks.
#![allow(dead_code, reason = "every test uses a part")]

pub(crate) mod library;

use std::collections::BTreeSet;

/// How a file is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    Text,
    LittleEndian,
    BigEndian,
}

pub(crate) const FORMS: [Form; 3] = [Form::Text, Form::LittleEndian, Form::BigEndian];

/// An expression.
#[derive(Clone, Debug)]
pub(crate) enum Node {
    /// `n`: a number.
    Number(f64),
    /// `s`: a short integer.
    Short(i16),
    /// `l`: an integer.
    Long(i32),
    /// `v`: a variable, or from the number of variables on a defined one.
    Variable(usize),
    /// `o`: an operator with its operands.
    Op(u32, Vec<Node>),
    /// `o`: an operator that is told how many operands it has.
    Many(u32, Vec<Node>),
    /// `o64`: slopes, breakpoints, a variable.
    Piecewise(Vec<f64>, Vec<f64>, usize),
}

/// What segment `r` says about a row.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    Range(f64, f64),
    Upper(f64),
    Lower(f64),
    Nothing,
    Equal(f64),
    /// Bits of the finite bounds, variable counted from 0.
    Complements(i32, usize),
}

/// A row: kind, linear terms, expression.
#[derive(Clone, Debug)]
pub(crate) struct Row(pub(crate) Kind, pub(crate) Vec<(usize, f64)>, pub(crate) Node);

/// A file.
#[derive(Clone, Debug, Default)]
pub(crate) struct File {
    /// Lower bound, upper bound, start.
    pub(crate) variables: Vec<(f64, f64, f64)>,
    pub(crate) rows: Vec<Row>,
    /// Linear terms and expressions of the defined variables.
    pub(crate) definitions: Vec<(Vec<(usize, f64)>, Node)>,
    /// Whether segments `J` leave out the variables behind defined ones, against the rules.
    pub(crate) is_incomplete: bool,
}

pub(crate) const INF: f64 = f64::INFINITY;

impl Node {
    /// The variables it reads, those of definitions included.
    fn reads(&self, file: &File, reads: &mut BTreeSet<usize>) {
        match self {
            Node::Variable(j) if *j < file.variables.len() => {
                reads.insert(*j);
            }
            Node::Variable(_) if file.is_incomplete => {}
            Node::Variable(k) => {
                let (linear, node) = &file.definitions[k - file.variables.len()];
                reads.extend(linear.iter().map(|term| term.0));
                node.reads(file, reads);
            }
            Node::Op(_, nodes) | Node::Many(_, nodes) => {
                for node in nodes {
                    node.reads(file, reads);
                }
            }
            Node::Piecewise(_, _, j) => {
                reads.insert(*j);
            }
            _ => {}
        }
    }
}

impl File {
    /// The bytes of the file: text and both binary forms of the same.
    pub(crate) fn write(&self, form: Form) -> Vec<u8> {
        let mut out = Output { form, bytes: Vec::new() };
        out.bytes.extend_from_slice(self.header(form).as_bytes());
        let n = self.variables.len();
        for (k, (linear, node)) in self.definitions.iter().enumerate() {
            out.segment(b'V', &[n + k, linear.len(), 0]);
            out.terms(linear);
            out.node(node);
        }
        for (i, Row(_, _, node)) in self.rows.iter().enumerate() {
            out.segment(b'C', &[i]);
            out.node(node);
        }
        out.segment(b'x', &[n]);
        let starts: Vec<_> = self.variables.iter().map(|variable| variable.2).enumerate().collect();
        out.terms(&starts);
        out.segment(b'r', &[]);
        self.rows.iter().for_each(|row| out.kind(row.0));
        out.segment(b'b', &[]);
        for &(lower, upper, _) in &self.variables {
            out.kind(match (lower > -INF, upper < INF) {
                (false, false) => Kind::Nothing,
                (true, false) => Kind::Lower(lower),
                (false, true) => Kind::Upper(upper),
                (true, true) if lower == upper => Kind::Equal(lower),
                (true, true) => Kind::Range(lower, upper),
            });
        }
        let entries: Vec<Vec<(usize, f64)>> =
            self.rows.iter().map(|row| self.entries(row)).collect();
        out.segment(b'k', &[n - 1]);
        let mut lengths = vec![0; n];
        entries.iter().flatten().for_each(|entry| lengths[entry.0] += 1);
        let mut sum = 0;
        for length in &lengths[..n - 1] {
            sum += length;
            out.integers(&[sum]);
        }
        for (i, entries) in entries.iter().enumerate() {
            if !entries.is_empty() {
                out.segment(b'J', &[i, entries.len()]);
                out.terms(entries);
            }
        }
        out.bytes
    }

    fn header(&self, form: Form) -> String {
        let (n, m, defined) = (self.variables.len(), self.rows.len(), self.definitions.len());
        let (letter, arithmetic) = match form {
            Form::Text => ('g', 0),
            Form::LittleEndian => ('b', 1),
            Form::BigEndian => ('b', 2),
        };
        let equations = self.rows.iter().filter(|row| matches!(row.0, Kind::Equal(_))).count();
        let pairs = self.rows.iter().filter(|row| matches!(row.0, Kind::Complements(..))).count();
        let nonzeros: usize = self.rows.iter().map(|row| self.entries(row).len()).sum();
        format!(
            "{letter}3 1 1 0\t# written by a test\n \
             {n} {m} 0 0 {equations}\t# vars, constraints, objectives, ranges, eqns\n \
             {m} 0 0 {pairs} 0 0\t# nonlinear constrs, objs; ccons: lin, nonlin, nd, nzlb\n \
             0 0\t# network constraints: nonlinear, linear\n \
             {n} 0 0\t# nonlinear vars in constraints, objectives, both\n \
             0 0 {arithmetic} 1\t# linear network variables; functions; arith, flags\n \
             0 0 0 0 0\t# discrete variables: binary, integer, nonlinear (b,c,o)\n \
             {nonzeros} 0\t# nonzeros in Jacobian, gradients\n \
             0 0\t# max name lengths: constraints, variables\n \
             {defined} 0 0 0 0\t# common exprs: b,c,o,c1,o1\n"
        )
    }

    /// Linear terms, and coefficient 0 for variables that only the expression reads.
    fn entries(&self, Row(_, linear, node): &Row) -> Vec<(usize, f64)> {
        let mut reads = linear.iter().map(|term| term.0).collect();
        node.reads(self, &mut reads);
        let coefficient = |j| linear.iter().filter(|term| term.0 == j).map(|term| term.1).sum();
        reads.into_iter().map(|j| (j, coefficient(j))).collect()
    }
}

/// Files of tests have few variables and rows.
fn small(number: usize) -> i32 {
    i32::try_from(number).expect("fewer than 2^31")
}

/// Bytes that have been written.
struct Output {
    form: Form,
    bytes: Vec<u8>,
}

impl Output {
    fn segment(&mut self, letter: u8, numbers: &[usize]) {
        self.letter(letter, "");
        self.integers(numbers);
        if self.form == Form::Text && numbers.is_empty() {
            self.bytes.push(b'\n');
        }
    }

    /// A letter, in text with what follows on its line.
    fn letter(&mut self, letter: u8, text: &str) {
        self.bytes.push(letter);
        if self.form == Form::Text && !text.is_empty() {
            self.bytes.extend_from_slice(text.as_bytes());
            self.bytes.push(b'\n');
        }
    }

    /// A line of integers.
    fn integers(&mut self, numbers: &[usize]) {
        if self.form == Form::Text {
            let words: Vec<String> = numbers.iter().map(usize::to_string).collect();
            self.bytes.extend_from_slice(words.join(" ").as_bytes());
            if !numbers.is_empty() {
                self.bytes.push(b'\n');
            }
            return;
        }
        for &number in numbers {
            self.integer(small(number));
        }
    }

    fn integer(&mut self, number: i32) {
        match self.form {
            Form::Text => self.bytes.extend_from_slice(format!("{number}\n").as_bytes()),
            Form::LittleEndian => self.bytes.extend_from_slice(&number.to_le_bytes()),
            Form::BigEndian => self.bytes.extend_from_slice(&number.to_be_bytes()),
        }
    }

    fn number(&mut self, number: f64) {
        match self.form {
            Form::Text => self.bytes.extend_from_slice(format!("{number:?}\n").as_bytes()),
            Form::LittleEndian => self.bytes.extend_from_slice(&number.to_le_bytes()),
            Form::BigEndian => self.bytes.extend_from_slice(&number.to_be_bytes()),
        }
    }

    fn terms(&mut self, terms: &[(usize, f64)]) {
        for &(j, coefficient) in terms {
            if self.form == Form::Text {
                self.bytes.extend_from_slice(format!("{j} {coefficient:?}\n").as_bytes());
            } else {
                self.integer(small(j));
                self.number(coefficient);
            }
        }
    }

    fn kind(&mut self, kind: Kind) {
        let (digit, numbers): (u8, &[f64]) = match &kind {
            Kind::Range(lower, upper) => (b'0', &[*lower, *upper]),
            Kind::Upper(upper) => (b'1', &[*upper]),
            Kind::Lower(lower) => (b'2', &[*lower]),
            Kind::Nothing => (b'3', &[]),
            Kind::Equal(value) => (b'4', &[*value]),
            Kind::Complements(..) => (b'5', &[]),
        };
        self.bytes.push(digit);
        for &number in numbers {
            if self.form == Form::Text {
                self.bytes.extend_from_slice(format!(" {number:?}").as_bytes());
            } else {
                self.number(number);
            }
        }
        if let Kind::Complements(bits, j) = kind {
            let j = small(j + 1);
            if self.form == Form::Text {
                self.bytes.extend_from_slice(format!(" {bits} {j}").as_bytes());
            } else {
                self.integer(bits);
                self.integer(j);
            }
        }
        if self.form == Form::Text {
            self.bytes.push(b'\n');
        }
    }

    fn node(&mut self, node: &Node) {
        match node {
            Node::Number(value) => {
                self.letter(b'n', "");
                self.number(*value);
            }
            Node::Short(value) => {
                self.letter(b's', &value.to_string());
                match self.form {
                    Form::Text => {}
                    Form::LittleEndian => self.bytes.extend_from_slice(&value.to_le_bytes()),
                    Form::BigEndian => self.bytes.extend_from_slice(&value.to_be_bytes()),
                }
            }
            Node::Long(value) => {
                self.letter(b'l', "");
                self.integer(*value);
            }
            Node::Variable(j) => {
                self.letter(b'v', "");
                self.integers(&[*j]);
            }
            Node::Op(code, nodes) => {
                self.operator(*code);
                for node in nodes {
                    self.node(node);
                }
            }
            Node::Many(code, nodes) => {
                self.operator(*code);
                self.integers(&[nodes.len()]);
                for node in nodes {
                    self.node(node);
                }
            }
            Node::Piecewise(slopes, breakpoints, j) => {
                self.operator(64);
                self.integers(&[slopes.len()]);
                for (k, slope) in slopes.iter().enumerate() {
                    self.node(&Node::Number(*slope));
                    if let Some(breakpoint) = breakpoints.get(k) {
                        self.node(&Node::Number(*breakpoint));
                    }
                }
                self.node(&Node::Variable(*j));
            }
        }
    }

    fn operator(&mut self, code: u32) {
        self.letter(b'o', "");
        self.integers(&[code as usize]);
    }
}

/// Shorthand for expressions.
pub(crate) mod node {
    use super::Node;

    pub(crate) fn n(value: f64) -> Node {
        Node::Number(value)
    }
    pub(crate) fn v(j: usize) -> Node {
        Node::Variable(j)
    }
    pub(crate) fn op<const N: usize>(code: u32, nodes: [Node; N]) -> Node {
        Node::Op(code, nodes.into())
    }
    pub(crate) fn many<const N: usize>(code: u32, nodes: [Node; N]) -> Node {
        Node::Many(code, nodes.into())
    }
    pub(crate) fn plus(a: Node, b: Node) -> Node {
        op(0, [a, b])
    }
    pub(crate) fn times(a: Node, b: Node) -> Node {
        op(2, [a, b])
    }
    pub(crate) fn power(a: Node, p: f64) -> Node {
        op(5, [a, n(p)])
    }
    /// `c x y`.
    pub(crate) fn product(c: f64, x: usize, y: usize) -> Node {
        times(n(c), times(v(x), v(y)))
    }
    /// A sum of terms.
    pub(crate) fn sum(nodes: Vec<Node>) -> Node {
        Node::Many(54, nodes)
    }
}
