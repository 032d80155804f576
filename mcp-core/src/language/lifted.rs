//! Where lifted definitions start.

use crate::model::Reader;
use crate::problem::{PlainModel, constants, plain_definitions};

/// A start at which lifted definitions hold: each family of `lifted`, given by the entries of the
/// variable family and of the equation family, is moved to the value of its expression, in order.
/// Values that are not finite are left alone.
#[doc(hidden)]
pub fn start_of_lifted(model: &dyn PlainModel, lifted: &[(usize, usize)]) -> Vec<f64> {
    start_beside(model, lifted, &[]).start
}

/// Where a model with lifted definitions starts.
#[doc(hidden)]
#[derive(Debug)]
pub struct LiftedStart {
    /// The start.
    pub(super) start: Vec<f64>,
    /// The values of the expressions, with their variables.
    pub(super) values: Vec<(usize, f64)>,
}

/// The same where the start of the variables `kept`, which increase, stays as it is.
pub(super) fn start_beside(
    model: &dyn PlainModel,
    lifted: &[(usize, usize)],
    kept: &[usize],
) -> LiftedStart {
    let shape = model.plain_shape();
    let mut start = shape.start().to_vec();
    let mut values = Vec::new();
    let parameters = constants(shape.parameter_values());
    for &(variable, _) in lifted {
        let z = constants(&start);
        let definitions = plain_definitions(model, &z, &parameters);
        let read = Reader::lanes(&z, &definitions, &parameters);
        let Some(family) = shape.variables().iter().find(|family| family.entry() == variable)
        else {
            continue;
        };
        for j in family.offset()..family.offset() + family.len() {
            // The row is v − expression.
            let Some(row) = shape.row_of_variable(j).map(|row| shape.row(row)) else { continue };
            let row = model.plain_row(row.family, row.index, &read).into_scalar();
            let expression = start[j] - row;
            if expression.is_finite() {
                values.push((j, expression));
                if kept.binary_search(&j).is_err() {
                    start[j] = expression;
                }
            }
        }
    }
    LiftedStart { start, values }
}
