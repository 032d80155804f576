//! [`Tape`]: expressions as flat lists of operations, each after its operands.
//!
//! `o2 v0 o44 v1`, the product of `z_0` and `e^{z_1}`, becomes `z_0, z_1, exp, ×`. Evaluation walks
//! along the list with a stack of numbers, so that no nesting is too deep for it.

use super::operator::{Binary, Unary};
use mcp_core::{Reader, Real, Scalar, select, sum};
use std::ops::Range;

/// Numbers on the stack of an evaluation that needs no allocation.
const SHALLOW: usize = 8;

/// One operation: takes its operands from the stack and leaves its value there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Op {
    Constant(f64),
    Variable(u32),
    Definition(u32),
    Unary(Unary),
    Binary(Binary),
    /// `xⁿ`.
    IntegerPower(i32),
    /// `xᵖ`.
    RealPower(f64),
    If,
    /// How many of the operands after the first equal it; the number of operands.
    NumberOf(u32),
    Piecewise(u32),
}

impl Op {
    /// How many numbers it takes from the stack.
    pub(super) fn operands(self) -> usize {
        match self {
            Op::Constant(_) | Op::Variable(_) | Op::Definition(_) => 0,
            Op::Unary(_) | Op::IntegerPower(_) | Op::RealPower(_) | Op::Piecewise(_) => 1,
            Op::Binary(_) => 2,
            Op::If => 3,
            Op::NumberOf(operands) => operands as usize,
        }
    }

    /// Whether the value is 0 or 1.
    pub(super) fn is_logical(self) -> bool {
        match self {
            Op::Constant(value) => value == 0.0 || value == 1.0,
            Op::Unary(unary) => unary.is_logical(),
            Op::Binary(binary) => binary.is_logical(),
            _ => false,
        }
    }
}

/// `f(x) = s_0 x + Σ Δs_i max(x − b_i, 0) − c`, with `c` such that `f(0) = 0`: slopes `s_i` between
/// breakpoints `b_1 <= b_2 <= …`, `Δs_i = s_i − s_{i−1}` (AMPL's `<<b; s>> x`).
#[derive(Clone, Debug)]
struct PiecewiseLinear {
    first_slope: f64,
    offset: f64,
    /// Where its breakpoints stand among all.
    kinks: Range<usize>,
}

/// One expression: its operations, and how many numbers its evaluation keeps.
#[derive(Clone, Debug, Default)]
pub(super) struct Expression {
    pub(super) ops: Range<usize>,
    depth: usize,
}

impl Expression {
    /// Whether it has no operations: its value is 0.
    pub(super) fn is_empty(&self) -> bool {
        self.ops.is_empty()
    }
}

/// The operations of all expressions of a file, one after the other.
#[derive(Clone, Debug, Default)]
pub(super) struct Tape {
    ops: Vec<Op>,
    piecewise: Vec<PiecewiseLinear>,
    /// Breakpoints and by how much the slope changes there.
    kinks: Vec<(f64, f64)>,
}

impl Tape {
    /// Where the next operation will stand.
    pub(super) fn len(&self) -> usize {
        self.ops.len()
    }

    /// Lets definition `k` be variable `first + k`.
    pub(super) fn make_variables_of_definitions(&mut self, first: usize) {
        let first = u32::try_from(first).expect("the header allows 2^31 variables");
        for op in &mut self.ops {
            if let Op::Definition(k) = *op {
                *op = Op::Variable(first + k);
            }
        }
    }

    /// The operation appended last.
    pub(super) fn last(&self) -> Option<Op> {
        self.ops.last().copied()
    }

    /// Operations of an expression.
    pub(super) fn ops(&self, expression: &Expression) -> &[Op] {
        &self.ops[expression.ops.clone()]
    }

    /// Appends an operation. Operations among constants are done at once, unless they fail; sums by
    /// [`sum_of_constants`].
    pub(super) fn push(&mut self, op: Op) {
        let mut op = op;
        if let (Op::Binary(Binary::Pow), Some(Op::Constant(p))) = (op, self.last()) {
            self.ops.pop();
            op = power(p);
        }
        let first = self.ops.len() - op.operands();
        let is_constant = |op: &Op| matches!(op, Op::Constant(_));
        if first < self.ops.len() && self.ops[first..].iter().all(is_constant) {
            self.ops.push(op);
            let value = match self.ops[first..] {
                [Op::Constant(a), Op::Constant(b), Op::Binary(Binary::Add)] => {
                    sum_of_constants(a, b)
                }
                [Op::Constant(a), Op::Constant(b), Op::Binary(Binary::Sub)] => {
                    sum_of_constants(a, -b)
                }
                _ => self.value_of_constants(first),
            };
            if value.is_finite() {
                self.ops.truncate(first);
                self.ops.push(Op::Constant(value));
            }
        } else {
            self.ops.push(op);
        }
    }

    /// Appends a piecewise-linear function of the number before it: slopes and the breakpoint that
    /// ends each of them, in increasing order, then the last slope.
    pub(super) fn push_piecewise(&mut self, pieces: &[(f64, f64)], last_slope: f64) {
        let slopes = pieces.iter().map(|piece| piece.0).chain([last_slope]);
        let slopes: Vec<f64> = slopes.collect();
        let start = self.kinks.len();
        let kinks = pieces.iter().zip(slopes.windows(2)).map(|(piece, s)| (piece.1, s[1] - s[0]));
        self.kinks.extend(kinks);
        let kinks = start..self.kinks.len();
        let offset = self.kinks[kinks.clone()].iter().map(|(b, change)| change * (-b).max(0.0));
        let (first_slope, offset) = (slopes[0], offset.sum());
        let number = u32::try_from(self.piecewise.len()).expect("fewer than the bytes of a file");
        self.piecewise.push(PiecewiseLinear { first_slope, offset, kinks });
        self.push(Op::Piecewise(number));
    }

    /// Appends operations as they are, an expression.
    pub(super) fn append(&mut self, ops: &[Op]) -> Expression {
        let start = self.ops.len();
        self.ops.extend_from_slice(ops);
        self.expression_from(start)
    }

    /// The expression that has been appended since `start`.
    pub(super) fn expression_from(&self, start: usize) -> Expression {
        let (mut on_stack, mut depth) = (0, 0);
        for op in &self.ops[start..] {
            on_stack = on_stack + 1 - op.operands();
            depth = depth.max(on_stack);
        }
        Expression { ops: start..self.ops.len(), depth }
    }

    fn value_of_constants(&self, start: usize) -> f64 {
        let mut stack = vec![Real::<f64>::from(0.0); self.ops.len() - start];
        let none = |_| Real::from(f64::NAN);
        self.run(&self.ops[start..], &mut stack, &none, &none).into_scalar()
    }

    /// The value of an expression that is a constant.
    pub(super) fn constant(&self, expression: &Expression) -> Option<f64> {
        match self.ops(expression) {
            [Op::Constant(value)] => Some(*value),
            _ => None,
        }
    }

    /// Value of an expression of what is read.
    pub(super) fn value<D: Scalar>(
        &self,
        expression: &Expression,
        read: &Reader<'_, D>,
    ) -> Real<D> {
        let variable = |j: u32| read.var(j as usize);
        let definition = |k: u32| read.def(k as usize);
        self.evaluate(expression, &variable, &definition)
    }

    /// Value of an expression; 0 without operations.
    pub(super) fn evaluate<D: Scalar>(
        &self,
        expression: &Expression,
        variable: &dyn Fn(u32) -> Real<D>,
        definition: &dyn Fn(u32) -> Real<D>,
    ) -> Real<D> {
        let (ops, zero) = (self.ops(expression), Real::from(0.0));
        if expression.depth <= SHALLOW {
            self.run(ops, &mut [zero; SHALLOW], variable, definition)
        } else {
            self.run(ops, &mut vec![zero; expression.depth], variable, definition)
        }
    }

    /// The value that `ops` leave on the stack, which is deep enough for them.
    fn run<D: Scalar>(
        &self,
        ops: &[Op],
        stack: &mut [Real<D>],
        variable: &dyn Fn(u32) -> Real<D>,
        definition: &dyn Fn(u32) -> Real<D>,
    ) -> Real<D> {
        let mut top = 0;
        for &op in ops {
            let first = top - op.operands();
            let x = |k: usize| stack[first + k];
            let value = match op {
                Op::Constant(value) => Real::from(value),
                Op::Variable(j) => variable(j),
                Op::Definition(k) => definition(k),
                Op::Unary(unary) => unary.of(x(0)),
                Op::Binary(binary) => binary.of(x(0), x(1)),
                Op::IntegerPower(n) => x(0).powi(n),
                Op::RealPower(p) => x(0).pow(p),
                Op::If => select(x(0), x(1), x(2)),
                Op::NumberOf(_) => sum(first + 1..top, |k| Binary::Eq.of(x(0), stack[k])),
                Op::Piecewise(number) => self.piecewise(number as usize, x(0)),
            };
            stack[first] = value;
            top = first + 1;
        }
        stack[0]
    }

    fn piecewise<D: Scalar>(&self, number: usize, x: Real<D>) -> Real<D> {
        let PiecewiseLinear { first_slope, offset, kinks } = &self.piecewise[number];
        let rises = sum(&self.kinks[kinks.clone()], |(b, change)| *change * (x - *b).max(0.0));
        *first_slope * x + rises - *offset
    }
}

/// `xᵖ` with a constant `p`.
fn power(p: f64) -> Op {
    #[allow(clippy::cast_possible_truncation, reason = "compared with the original")]
    let n = p as i32;
    if f64::from(n) == p { Op::IntegerPower(n) } else { Op::RealPower(p) }
}

/// `a + b`, and 0 where no more than rounding errors are left of the two: decimals of a file are rounded,
/// and `0.3 − 0.1 − 0.2` in a row without variables has to be 0, not −2.8e−17.
pub(super) fn sum_of_constants(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if sum.abs() <= 4.0 * f64::EPSILON * a.abs().max(b.abs()) { 0.0 } else { sum }
}
