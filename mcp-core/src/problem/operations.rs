//! What `F` and `J` cost in operations, counted row by row.

use super::AdProblem;
use super::record::{RowReads, all_rows, constants, record_rows};
use super::rows::{Kind, RowsIn};
use crate::error::ModelError;
use crate::model::{Family, Give, Model, Point, Reader, Row, Shape};
use crate::problem::derived::definitions;
use crate::scalar::{Counted, Jet, OperationCounts, Real, Tally};

/// Numbers whose operations are counted, with one tangent where the arithmetic has one.
struct Tallied<'a> {
    point: Point<'a>,
    tally: &'a Tally,
}

impl<'a> Give<Counted<'a>> for Tallied<'a> {
    fn var(&self, j: usize) -> Real<Counted<'a>> {
        Real(self.tally.variable(self.point.z[j]))
    }
    fn def(&self, k: usize) -> Real<Counted<'a>> {
        Real(self.tally.variable(self.point.definitions[k]))
    }
    fn param(&self, k: usize) -> Real<Counted<'a>> {
        Real(self.tally.variable(self.point.parameters[k]))
    }
}

impl<'a> Give<Jet<1, Counted<'a>>> for Tallied<'a> {
    fn var(&self, j: usize) -> Real<Jet<1, Counted<'a>>> {
        Real(Jet { v: self.tally.variable(self.point.z[j]), d: [self.tally.variable(1.0)] })
    }
    fn def(&self, k: usize) -> Real<Jet<1, Counted<'a>>> {
        Real(Jet {
            v: self.tally.variable(self.point.definitions[k]),
            d: [self.tally.variable(1.0)],
        })
    }
    fn param(&self, k: usize) -> Real<Jet<1, Counted<'a>>> {
        Real(Jet {
            v: self.tally.variable(self.point.parameters[k]),
            d: [self.tally.variable(0.0)],
        })
    }
}

/// Operations of a row that reads `lanes` numbers: the values once, the tangents of each lane.
fn of_row<'t, M: RowsIn<Counted<'t>> + RowsIn<Jet<1, Counted<'t>>>>(
    model: &M,
    (kind, row): (Kind, Row),
    point: Point<'t>,
    (plain, one_lane): (&'t Tally, &'t Tally),
    lanes: u64,
) -> OperationCounts {
    let give = Tallied { point, tally: plain };
    let _: Real<Counted<'t>> = model.row_in(kind, row, &Reader::other(&give));
    let give = Tallied { point, tally: one_lane };
    let _: Real<Jet<1, Counted<'t>>> = model.row_in(kind, row, &Reader::other(&give));
    let (values, both) = (plain.counts(), one_lane.counts());
    let total = |of: fn(&OperationCounts) -> u64| {
        of(&values) + lanes * of(&both).saturating_sub(of(&values))
    };
    OperationCounts {
        additions: total(|counts| counts.additions),
        multiplications: total(|counts| counts.multiplications),
        divisions: total(|counts| counts.divisions),
        functions: total(|counts| counts.functions),
        selections: total(|counts| counts.selections),
    }
}

impl<M: Model> AdProblem<M> {
    /// Operations of one evaluation of `F` and `J` together, in forward mode row by row: a row or
    /// definition that reads `k` variables and definitions costs its values once and `k` tangents.
    ///
    /// Left out are the products of the chain rule through definitions, and the lanes that only fill
    /// up a chunk of 8 or 16. A model of one function ([`Model::WHOLE`]) is counted by its rows too.
    ///
    /// # Errors
    /// As [`AdProblem::new`].
    pub fn jacobian_operations(&self) -> Result<OperationCounts, ModelError> {
        let shape: &Shape = self.shape();
        let (z, parameters) = (shape.start(), shape.parameter_values());
        let mut def = |k, index, read: &Reader<'_, f64>| self.model().def(k, index, read);
        let values = definitions(shape, &mut def, &constants(z), &constants(parameters));
        let values: Vec<f64> = values.into_iter().map(Real::into_scalar).collect();
        let point = Point { z, definitions: &values, parameters };

        let reads = record_rows(self.model(), shape)?;
        let definition_rows = all_rows(shape.definitions().iter().map(Family::len));
        let equation_rows = all_rows(shape.equations().map(Family::len));
        let kinds = [
            (Kind::Definition, definition_rows, &reads.definitions),
            (Kind::Equation, equation_rows, &reads.rows),
        ];
        let mut sum = OperationCounts::default();
        for (kind, rows, reads) in kinds {
            for (row, RowReads { variables, definitions }) in rows.into_iter().zip(reads) {
                let lanes = (variables.len() + definitions.len()) as u64;
                let tallies = (&Tally::new(), &Tally::new());
                let counts = of_row(self.model(), (kind, row), point, tallies, lanes);
                sum.additions += counts.additions;
                sum.multiplications += counts.multiplications;
                sum.divisions += counts.divisions;
                sum.functions += counts.functions;
                sum.selections += counts.selections;
            }
        }
        Ok(sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Equation, Variable};
    use crate::scalar::Scalar;

    /// `x y + 3 x` and `exp(y)`.
    struct Small(Shape);

    impl Model for Small {
        fn shape(&self) -> &Shape {
            &self.0
        }
        fn row<D: Scalar>(&self, family: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
            let (x, y) = (read.var(0), read.var(1));
            if family == 0 { x * y + 3.0 * x } else { y.exp() }
        }
    }

    #[test]
    fn a_row_costs_its_values_once_and_a_tangent_for_each_number_it_reads() {
        let shape = Shape::builder()
            .variable(Variable::new("x"))
            .variable(Variable::new("y"))
            .equation(Equation::new("f").complements("x"))
            .equation(Equation::new("g").complements("y"))
            .build()
            .unwrap();
        let problem = AdProblem::new(Small(shape)).unwrap();
        let f = problem.operations();
        assert_eq!((f.multiplications, f.additions, f.functions), (2, 1, 1));
        let both = problem.jacobian_operations().unwrap();
        // A tangent of f: x'y + y'x + 3x' is three products and two sums; of exp(y): one product.
        // f has two lanes, and so has the row of exp(y), which reads x without using it.
        assert_eq!((both.multiplications, both.additions), (2 + 2 * 3 + 2, 1 + 2 * 2));
        assert_eq!(both.functions, 1);
    }
}
