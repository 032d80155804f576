//! Scalar operations of one evaluation of `J`, counted.

use super::AdProblem;
use super::ad::{lanes_for, recorded};
use super::record::{all_rows, block, constants};
use super::rows::{Kind, RowsIn};
use crate::model::{Model, Reader, Row};
use crate::scalar::{Counted, Jet, Real, Scalar, Tally};

/// The counting scalar with one tangent.
type Tangent<'t> = Jet<1, Counted<'t>>;

impl<M: Model> AdProblem<M> {
    /// Operations of one evaluation of `J` with [`Jet`]s: values, and tangents in all lanes that are
    /// carried, whether they are zero or not.
    ///
    /// A row takes `a` operations for its value and `t` for one tangent. Derivatives that are the same
    /// at every point take none. A row with up to 8 others takes `a + 8 t`, and `a + 2 t` above:
    /// slopes of all operations, and one sweep back over them.
    /// A function of fixed size takes `a + L t` in all rows together for every `L` of its variables, at
    /// most 16. The chain rule through definitions takes two more for every variable of every
    /// definition by which a derivative is carried.
    ///
    /// ```
    /// # use mcp_core::{AdProblem, Real, Scalar, mcp_fn};
    /// #[mcp_fn]
    /// fn square<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    ///     [x * x]
    /// }
    /// let problem = AdProblem::new(Square::new()?)?;
    /// // x·x, and ẋ·x + x·ẋ.
    /// assert_eq!((problem.operations().total(), problem.jacobian_operations()?), (1, 1 + 3));
    /// # Ok::<(), mcp_core::ModelError>(())
    /// ```
    ///
    /// # Errors
    /// As [`AdProblem::new`].
    pub fn jacobian_operations(&self) -> Result<u64, crate::ModelError> {
        let (model, shape) = (self.model(), self.shape());
        if M::WHOLE.is_some() {
            let value = self.operations().total();
            let tally = Tally::new();
            let z: Vec<Real<Tangent<'_>>> =
                shape.start().iter().map(|&z| tangent(&tally, z)).collect();
            let mut f = vec![Real(Tangent::constant(0.0)); shape.row_count()];
            model.whole(&Reader::lanes(&z, &[], &constants(shape.parameter_values())), &mut f);
            return Ok(in_lanes(value, tally.counts().total(), shape.n(), lanes_for(M::WHOLE)));
        }
        let (_, workspace) = recorded(model, shape, &[], true)?;
        let rows = all_rows(shape.equations().map(block));
        let definitions = all_rows(shape.definitions().iter().map(block));
        let all: Vec<(Kind, Row)> = definitions
            .map(|row| (Kind::Definition, row))
            .chain(rows.map(|row| (Kind::Equation, row)))
            .collect();
        let tally = Tally::new();
        let values = self.counted(&tally, &all, |z| Real(tally.variable(z)));
        let tangents = self.counted(&tally, &all, |z| tangent(&tally, z));
        let carried = workspace.plan().carried();
        let mut total = 0;
        for ((value, with_tangent), (lanes, chained)) in
            values.into_iter().zip(tangents).zip(carried)
        {
            total += match lanes {
                0 => value,
                1..=8 => in_lanes(value, with_tangent, lanes, 8),
                _ => value + 2 * (with_tangent - value),
            };
            total += 2 * chained as u64;
        }
        Ok(total)
    }

    /// Operations of each row in an arithmetic that counts in `tally`.
    fn counted<D: Scalar>(
        &self,
        tally: &Tally,
        rows: &[(Kind, Row)],
        variable: impl Fn(f64) -> Real<D>,
    ) -> Vec<u64> {
        let shape = self.shape();
        let z: Vec<Real<D>> = shape.start().iter().map(|&z| variable(z)).collect();
        // Whatever their values: a model cannot branch on them.
        let definitions = vec![variable(1.0); shape.definition_count()];
        let parameters = constants(shape.parameter_values());
        let read = Reader::lanes(&z, &definitions, &parameters);
        let operations = |&(kind, row): &(Kind, Row)| {
            let before = tally.counts().total();
            let _ = self.model().row_in(kind, row, &read);
            tally.counts().total() - before
        };
        rows.iter().map(operations).collect()
    }
}

fn tangent(tally: &Tally, z: f64) -> Real<Tangent<'_>> {
    // A tangent that counts, as no constant does.
    Real(Jet { v: tally.variable(z), d: [tally.variable(1.0)] })
}

/// `⌈k/L⌉ (a + L t)`, from the operations `a` of the value and `a + t` with one tangent.
fn in_lanes(value: u64, with_tangent: u64, k: usize, lanes: usize) -> u64 {
    k.div_ceil(lanes) as u64 * (value + lanes as u64 * (with_tangent - value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{mcp, mcp_fn};

    #[mcp_fn(start = 1.0)]
    fn products<D: Scalar>(z: [Real<D>; 5]) -> [Real<D>; 5] {
        std::array::from_fn(|i| z[i] * z[(i + 1) % 5])
    }

    mcp! {
        model Shared {
            data { firms: 3 }
            var x[i in firms] >= 0.0 start 1.0;
            def total: sum(firms, |i| x[i]);
            eq f[i in firms]: x[i] * total complements x[i];
        }
    }

    #[test]
    fn a_function_carries_the_lanes_it_is_compiled_with() {
        // 5 products; 3 operations a tangent; 6 lanes.
        let problem = AdProblem::new(Products::new().unwrap()).unwrap();
        assert_eq!(problem.operations().total(), 5);
        assert_eq!(problem.jacobian_operations(), Ok(5 * (1 + 6 * 3)));
    }

    #[test]
    fn rows_carry_what_is_not_constant_and_pay_for_the_chain_rule() {
        let problem = AdProblem::new(Shared::builder().build().unwrap()).unwrap();
        // The sum: two additions, and no tangent. Each row: a product of two reads, 8 lanes, and three
        // products and sums by the definition's variables.
        let (sum, row) = (2, 1 + 8 * 3 + 2 * 3);
        assert_eq!(problem.jacobian_operations(), Ok(sum + 3 * row));
    }
}
