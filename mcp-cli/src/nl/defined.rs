//! Defined variables: definitions of the model, or auxiliary variables where those would fill the
//! Jacobian.
//!
//! A definition `d_k = e_k(z, d)` is evaluated once per pass, and rows that read it have derivatives by
//! all variables behind it. In a chain, `d_k` of `d_{k−1}` and `z_k`, these are `k`, and a short file
//! would have a Jacobian of `n²/2` nonzeros. There, every `d_k` becomes a free variable of the model
//! behind those of the file, with the equation `d_k − e_k(z, d) = 0`.

use super::segments::Parts;
use super::tape::{Expression, Op};
use std::ops::Range;

/// Nonzeros per operation and linear term of the file, and nonzeros in any case, up to which
/// definitions stay definitions.
const FILL: usize = 64;
const SMALL: usize = 1_000_000;

/// Whether gradients of definitions, and of rows that read them, are within proportion to the file.
/// Rows are expressions and ranges of linear terms.
pub(super) fn stay_sparse<'a>(
    parts: &Parts,
    rows: impl Iterator<Item = (&'a Expression, &'a Range<usize>)>,
) -> bool {
    let limit = SMALL + FILL * (parts.tape.len() + parts.linear.len());
    let mut fill = Fill { parts, supports: Vec::new(), left: limit };
    for definition in &parts.definitions {
        match fill.support(&definition.expression, &definition.linear) {
            Some(support) => fill.supports.push(support),
            None => return false,
        }
    }
    rows.into_iter().all(|(expression, linear)| fill.support(expression, linear).is_some())
}

/// Nonzeros of gradients, counted as they are found.
struct Fill<'a> {
    parts: &'a Parts,
    /// The variables behind every definition so far, sorted.
    supports: Vec<Vec<u32>>,
    /// Nonzeros that may still be found.
    left: usize,
}

impl Fill<'_> {
    /// The variables behind an expression with linear terms, unless they are too many.
    fn support(&mut self, expression: &Expression, linear: &Range<usize>) -> Option<Vec<u32>> {
        let terms = &self.parts.linear[linear.clone()];
        let mut support: Vec<u32> = terms.iter().map(|term| term.0).collect();
        let mut definitions = Vec::new();
        for op in self.parts.tape.ops(expression) {
            match *op {
                Op::Variable(j) => support.push(j),
                Op::Definition(k) => definitions.push(k as usize),
                _ => {}
            }
        }
        definitions.sort_unstable();
        definitions.dedup();
        let behind: usize = definitions.iter().map(|&k| self.supports[k].len()).sum();
        self.left = self.left.checked_sub(support.len() + behind)?;
        for k in definitions {
            support.extend_from_slice(&self.supports[k]);
        }
        support.sort_unstable();
        support.dedup();
        Some(support)
    }
}
