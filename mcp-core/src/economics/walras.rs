//! [`check_walras`]: does the market clear whose equation was dropped?

use crate::error::ModelError;
use crate::model::{BoundKind, Model};
use crate::problem::{AdProblem, Problem};
use crate::solver::Solution;
use std::fmt;

/// A dropped equation holds to this part of its terms.
const TOLERANCE: f64 = 1e-8;

/// What [`check_walras`] found: every equation that was dropped because its variable is fixed.
/// `Display` is one line for each.
#[derive(Clone, Debug, PartialEq)]
pub struct WalrasCheck {
    /// The dropped equations.
    pub dropped: Vec<Dropped>,
}

/// An equation that was dropped because its variable, the numeraire, is fixed.
#[derive(Clone, Debug, PartialEq)]
pub struct Dropped {
    /// The fixed variable.
    pub variable: String,
    /// Its equation.
    pub equation: String,
    /// `F_i` at the solution, in the unit of the equation.
    pub f: f64,
    /// `|F_i| / Σ |J_ij z_j|`: the part of its terms by which it does not hold.
    pub relative: f64,
}

/// Why Walras' law does not hold.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoWalras {
    /// No variable with an equation is fixed, so none was dropped.
    #[error(
        "no price is fixed: all prices can move together, so fix one, such as \
         `fix p[labor] = 1.0;` in the model or `model.fix(\"p[labor]\", 1.0)?`"
    )]
    NoNumeraire,
    /// A dropped equation does not hold.
    #[error(
        "the market of the numeraire does not clear: `{}` is {:e}, {:.1e} of its terms; a payment is \
         missing in an income or counted twice",
        .0.equation, .0.f, .0.relative
    )]
    Gap(Dropped),
}

/// Whether the equations that were dropped for fixed variables hold at a solution.
///
/// In an economy where every payment is somebody's receipt the value of all excess supplies is 0 at
/// any prices (Walras' law), so one market clears if all others do: the numeraire's, whose equation
/// is dropped. If it does not, a payment is missing somewhere in the model. The parameters are those of
/// the solve. Cost: one evaluation of `F` and `J`.
///
/// # Errors
/// [`ModelError::Length`] for a solution with another number of variables, and as
/// [`Shape::set_parameter`](crate::Shape::set_parameter) for one of another model.
pub fn check_walras<M: Model>(model: &M, solution: &Solution) -> Result<WalrasCheck, ModelError> {
    let mut problem = AdProblem::new(model)?;
    let (expected, found) = (problem.shape().n(), solution.z.len());
    if expected != found {
        return Err(ModelError::Length { what: "solution".to_owned(), expected, found });
    }
    for family in solution.shape.parameters() {
        let values = &solution.shape.parameter_values()[family.offset()..][..family.len()];
        problem.set_parameter(family.name(), values)?;
    }
    Ok(dropped(&mut problem, solution))
}

fn dropped(problem: &mut dyn Problem, solution: &Solution) -> WalrasCheck {
    let z = &solution.z;
    let (mut f, mut jac) = (vec![0.0; z.len()], vec![0.0; problem.pattern().nnz()]);
    problem.evaluate(z, Some(&mut f), Some(&mut jac));
    let mut terms = vec![0.0; z.len()];
    for (k, i, j) in problem.pattern().entries() {
        terms[i] += (jac[k] * z[j]).abs();
    }
    let shape = &solution.shape;
    let is_dropped = |&i: &usize| {
        shape.bounds().kind(i) == BoundKind::Fixed && shape.row_of_variable(i).is_some()
    };
    let check = |i: usize| {
        let relative = if f[i] == 0.0 { 0.0 } else { f[i].abs() / terms[i] };
        let (variable, equation) = (shape.variable_name(i), shape.equation_name(i));
        Dropped { variable, equation, f: f[i], relative }
    };
    WalrasCheck { dropped: (0..z.len()).filter(is_dropped).map(check).collect() }
}

impl WalrasCheck {
    /// Whether all dropped equations hold, to `1e-8` of their terms.
    ///
    /// # Errors
    /// [`NoWalras::NoNumeraire`] if no equation was dropped, [`NoWalras::Gap`] for the one that holds
    /// worst.
    pub fn verdict(&self) -> Result<(), NoWalras> {
        let worst = self.dropped.iter().max_by(|a, b| a.relative.total_cmp(&b.relative));
        match worst {
            None => Err(NoWalras::NoNumeraire),
            Some(worst) if worst.relative <= TOLERANCE => Ok(()),
            Some(worst) => Err(NoWalras::Gap(worst.clone())),
        }
    }
}

impl fmt::Display for WalrasCheck {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for Dropped { variable, equation, f: value, relative } in &self.dropped {
            writeln!(
                f,
                "{variable} is fixed; {equation}, which was dropped, is {value:.1e}, \
                 {relative:.1e} of its terms"
            )?;
        }
        Ok(())
    }
}

#[cfg(test)]
#[path = "walras_tests.rs"]
mod tests;
