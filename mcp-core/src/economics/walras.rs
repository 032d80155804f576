//! [`check_walras`]: does the market clear whose equation was dropped?

use crate::error::ModelError;
use crate::linalg::smallest_singular;
use crate::model::{BoundKind, Model};
use crate::problem::{AdProblem, Problem};
use crate::report::State;
use crate::solver::{Solution, Status};
use nalgebra::DMatrix;
use std::fmt;

/// A dropped equation holds to this part of its terms.
const TOLERANCE: f64 = 1e-8;

/// Most variables for which singular values are computed.
const MOST_VARIABLES: usize = 500;

/// A singular value this small, with rows of sum 1 and columns in units of the levels, is 0.
const SINGULAR: f64 = 1e-9;

/// Entries of a null vector that are equal to this part move in proportion.
const PROPORTIONAL: f64 = 1e-5;

/// What [`check_walras`] found: every equation that was dropped because its variable is fixed.
/// `Display` is one line for each.
#[derive(Clone, Debug, PartialEq)]
pub struct WalrasCheck {
    /// The dropped equations.
    pub dropped: Vec<Dropped>,
    /// How the solve ended.
    pub status: Status,
    /// Variables that can move together in proportion, and all equations still hold: without
    /// numeraire, all prices and incomes. Up to 500 variables are searched for them.
    pub movable: Vec<String>,
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
    /// `|F_i| / Σ |J_ij z_j|`: the part of its terms by which it does not hold; infinite where either
    /// is not finite.
    pub relative: f64,
}

/// Why Walras' law does not hold.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoWalras {
    /// Prices can move together.
    #[error(
        "all prices can move together: fix one; {} keep their equations when they grow in proportion",
        .names.join(", ")
    )]
    NoNumeraire {
        /// The variables that can.
        names: Vec<String>,
    },
    /// The point is no solution: nothing follows from equations that do not hold there.
    #[error("the point is no solution, so no market has to clear: {status}")]
    NotSolved {
        /// How the solve ended.
        status: Status,
    },
    /// No equation was dropped, and prices cannot move together.
    #[error("no variable with an equation is fixed, so no equation was dropped")]
    NothingDropped,
    /// A dropped equation does not hold.
    #[error(
        "the market of the numeraire does not clear: `{}` is {:e}, {:.1e} of its terms; a payment is \
         missing in an income or counted twice",
        .0.equation, .0.f, .0.relative
    )]
    Gap(Dropped),
}

/// As [`Display`](fmt::Display): what `main` prints of an error it returns.
impl fmt::Debug for NoWalras {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// Whether the equations that were dropped for fixed variables hold at a solution.
///
/// In an economy where every payment is somebody's receipt the value of all excess supplies is 0 at
/// any prices (Walras' law), so one market clears if all others do: the numeraire's, whose equation
/// is dropped. If it does not, a payment is missing somewhere in the model. Without numeraire the
/// Jacobian is singular: a null vector that is proportional to the levels tells which variables can
/// move together. The parameters are those of the solve. Cost: one evaluation of `F` and `J`, and for
/// at most 500 variables one singular value decomposition.
///
/// # Errors
/// [`ModelError::Length`] for a solution with another number of variables, [`ModelError::OtherModel`]
/// for one of a model with other variables or parameters.
pub fn check_walras<M: Model>(model: &M, solution: &Solution) -> Result<WalrasCheck, ModelError> {
    Ok(dropped(&mut AdProblem::of_solution(model, solution)?, solution))
}

fn dropped(problem: &mut dyn Problem, solution: &Solution) -> WalrasCheck {
    let z = &solution.z;
    let (mut f, mut jac) = (vec![0.0; z.len()], vec![0.0; problem.pattern().nnz()]);
    problem.evaluate(z, Some(&mut f), Some(&mut jac));
    let mut terms = vec![0.0; z.len()];
    problem.pattern().add_sizes(&jac, |j| z[j], &mut terms);
    let shape = &solution.shape;
    let is_dropped = |&i: &usize| {
        shape.bounds().kind(i) == BoundKind::Fixed && shape.row_of_variable(i).is_some()
    };
    let check = |i: usize| {
        let relative = if f[i] == 0.0 {
            0.0
        } else if f[i].is_finite() && terms[i].is_finite() {
            f[i].abs() / terms[i]
        } else {
            f64::INFINITY
        };
        let (variable, equation) = (shape.variable_name(i), shape.equation_name(i));
        Dropped { variable, equation, f: f[i], relative }
    };
    let movable = movable(problem, solution, &jac);
    let dropped = (0..z.len()).filter(is_dropped).map(check).collect();
    WalrasCheck { dropped, status: solution.status, movable }
}

/// Variables between their bounds whose common growth leaves all their equations as they are: the
/// null vector of `J_ij z_j / s_i`, `s_i = Σ_j |J_ij z_j|`, if its entries are equal or 0.
fn movable(problem: &dyn Problem, solution: &Solution, jac: &[f64]) -> Vec<String> {
    let (shape, z) = (&solution.shape, &solution.z);
    let state = |i: usize| State::new(shape.bounds(), i, z[i], solution.f[i]);
    let is_between = |&i: &usize| matches!(state(i), State::Interior | State::Free);
    // What is 0 stays 0 when it grows in proportion.
    let between: Vec<usize> = (0..z.len()).filter(|&i| z[i] != 0.0).filter(is_between).collect();
    let n = between.len();
    if n > MOST_VARIABLES {
        return Vec::new();
    }
    let mut place = vec![None; z.len()];
    for (k, &i) in between.iter().enumerate() {
        place[i] = Some(k);
    }
    let mut scaled = DMatrix::zeros(n, n);
    for (k, i, j) in problem.pattern().entries() {
        if let Some(at) = place[i].zip(place[j]) {
            scaled[at] = jac[k] * z[j];
        }
    }
    for mut row in scaled.row_iter_mut() {
        let sum: f64 = row.iter().map(|entry| entry.abs()).sum();
        if sum > 0.0 {
            row /= sum;
        }
    }
    let Some(null) = null_vector(scaled) else { return Vec::new() };
    let near = |k: usize, to: f64| (null[k] - to).abs() <= PROPORTIONAL;
    if !(0..n).all(|k| near(k, 1.0) || near(k, 0.0)) {
        return Vec::new();
    }
    (0..n).filter(|&k| near(k, 1.0)).map(|k| shape.variable_name(between[k])).collect()
}

/// A vector that a square matrix takes to 0, with 1 as its largest entry, if there is one.
fn null_vector(matrix: DMatrix<f64>) -> Option<Vec<f64>> {
    let (value, null) = smallest_singular(matrix)?;
    let largest = null.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    (value <= SINGULAR).then(|| null.iter().map(|entry| entry / largest).collect())
}

impl WalrasCheck {
    /// Whether all dropped equations hold, to `1e-8` of their terms.
    ///
    /// # Errors
    /// [`NoWalras::NoNumeraire`] if prices can move together, [`NoWalras::NotSolved`],
    /// [`NoWalras::NothingDropped`], [`NoWalras::Gap`] for the dropped equation that holds worst.
    pub fn verdict(&self) -> Result<(), NoWalras> {
        if !self.movable.is_empty() {
            return Err(NoWalras::NoNumeraire { names: self.movable.clone() });
        }
        if self.status != Status::Solved {
            return Err(NoWalras::NotSolved { status: self.status });
        }
        let worst = self.dropped.iter().max_by(|a, b| a.relative.total_cmp(&b.relative));
        match worst {
            None => Err(NoWalras::NothingDropped),
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
        if !self.movable.is_empty() {
            writeln!(f, "these can move together: {}", self.movable.join(", "))?;
        }
        Ok(())
    }
}

#[cfg(test)]
#[path = "walras_tests.rs"]
mod tests;
