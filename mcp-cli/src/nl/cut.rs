//! Long sums cut into pieces, each an auxiliary variable.
//!
//! The derivative of a row by `k` variables takes `k` tangents in each of its `a` operations: `F = Σ x_j²`
//! over `n` variables, `O(n)` long in the file, has a gradient of `O(n²)` operations. With
//!
//! ```text
//! d_1 = Σ_{j <= m} x_j²,   d_2 = Σ_{m < j <= 2m} x_j²,   …,      F = d_1 + d_2 + …
//! ```
//!
//! it takes `O(n m)`, and `O((n/m)²)` for the last sum. The `d_p` are free variables behind those of
//! the file, each with the equation `d_p − … = 0`.

use super::assemble::Body;
use super::operator::Binary;
use super::segments::{Parts, Sum};
use super::tape::{Expression, Op};
use std::ops::Range;

/// Operations times variables of a row up to which its sum stays whole.
const WORK: usize = 1 << 26;
/// Operations of a piece, unless one term has more; a linear term has two.
const PIECE: usize = 512;

/// Cuts the sums of all rows that are too long, appends the pieces to the definitions, and says
/// whether there are any: definitions must be variables of the model then.
pub(super) fn long_sums(parts: &mut Parts, rows: &mut [Body]) -> bool {
    let before = parts.definitions.len();
    for row in rows {
        let terms = parts.linear[row.linear.clone()].iter().copied();
        let terms: Vec<(u32, f64)> = terms.filter(|term| term.1 != 0.0).collect();
        if !is_long(parts.tape.ops(&row.expression), &terms) {
            continue;
        }
        let mut sum = Vec::new();
        if let Some(pieces) = pieces(parts.tape.ops(&row.expression)) {
            for piece in pieces {
                let expression = parts.tape.append(&piece);
                sum.push((define(parts, Sum { expression, linear: 0..0 }), row.factor));
            }
            row.expression = Expression::default();
        }
        for terms in terms.chunks(PIECE / 2) {
            let linear = append(&mut parts.linear, terms);
            sum.push((define(parts, Sum { expression: Expression::default(), linear }), 1.0));
        }
        row.linear = append(&mut parts.linear, &sum);
    }
    parts.definitions.len() > before
}

/// The variable of a new definition.
fn define(parts: &mut Parts, definition: Sum) -> u32 {
    parts.definitions.push(definition);
    u32::try_from(parts.bounds.len() + parts.definitions.len() - 1).expect("fewer than 2^32 terms")
}

fn append(linear: &mut Vec<(u32, f64)>, terms: &[(u32, f64)]) -> Range<usize> {
    let start = linear.len();
    linear.extend_from_slice(terms);
    start..linear.len()
}

/// Whether operations times variables are beyond [`WORK`].
fn is_long(ops: &[Op], terms: &[(u32, f64)]) -> bool {
    let operations = ops.len() + 2 * terms.len();
    if operations.saturating_mul(operations) <= WORK {
        return false;
    }
    let variable = |op: &Op| match *op {
        Op::Variable(j) => Some((j, false)),
        Op::Definition(k) => Some((k, true)),
        _ => None,
    };
    let linear = terms.iter().map(|term| (term.0, false));
    let mut reads: Vec<_> = ops.iter().filter_map(variable).chain(linear).collect();
    reads.sort_unstable();
    reads.dedup();
    operations.saturating_mul(reads.len()) > WORK
}

/// The terms of the sum that an expression is, in their order, as sums of [`PIECE`] operations; `None`
/// if it is no sum of more than one such.
fn pieces(ops: &[Op]) -> Option<Vec<Vec<Op>>> {
    // Where the operands of every operation begin.
    let mut starts: Vec<usize> = Vec::with_capacity(ops.len());
    let mut stack: Vec<usize> = Vec::new();
    for (k, op) in ops.iter().enumerate() {
        let first = stack.len() - op.operands();
        let start = stack.get(first).copied().unwrap_or(k);
        stack.truncate(first);
        stack.push(start);
        starts.push(start);
    }
    let mut pieces: Vec<Vec<Op>> = Vec::new();
    let mut waiting = vec![ops.len().checked_sub(1)?];
    while let Some(last) = waiting.pop() {
        if ops[last] == Op::Binary(Binary::Add) {
            // The first operand ends before the second begins, and comes first.
            waiting.extend([last - 1, starts[last - 1] - 1]);
            continue;
        }
        let term = &ops[starts[last]..=last];
        match pieces.last_mut() {
            Some(piece) if piece.len() < PIECE => {
                piece.extend_from_slice(term);
                piece.push(Op::Binary(Binary::Add));
            }
            _ => pieces.push(term.to_vec()),
        }
    }
    (pieces.len() > 1).then_some(pieces)
}
