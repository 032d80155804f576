//! [`solve_sequence`]: from a coarse model to a fine one, each solution the start of the next solve.
//!
//! An obstacle problem on a grid of `k × k` nodes takes a number of Newton steps that grows with `k` from
//! a start far away, because every step moves the rim of the contact by a few nodes. From the solution on
//! a grid half as fine, interpolated, the number does not depend on `k`: nested iteration,
//! [BHM00](crate#references) chapter 3.

use super::{Options, Solution, Solver};
use crate::error::ModelError;
use crate::model::Model;
use crate::problem::{AdProblem, Problem};

/// Solves models from coarse to fine with the same options; `prolong` makes a start of the second from the
/// solution of the first. The last of the solutions is the answer.
///
/// Models are made one after the other, when they are needed. A solve that ends without a solution gives
/// no start: the next model begins at its own. A start is moved into the bounds.
///
/// # Errors
/// As [`solve_from`](crate::solve_from), and the first error of a model or of `prolong`.
///
/// ```
/// use mcp_core::{Grid, Model, Options, mcp, solve_sequence};
/// mcp! {
///     /// A string over a floor: `−u″ = −8 ⟂ u >= −½`, times `h²`.
///     model Rope {
///         data { nodes: usize, h: f64 }
///         var u[i in nodes] >= -0.5;
///         eq force[i in nodes]:
///             2.0 * u[i] - u.at(i - 1).or(0.0) - u.at(i + 1).or(0.0) + 8.0 * h * h
///             complements u[i];
///     }
/// }
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let rope = |k: usize| Rope::builder().nodes(k).h(1.0 / (k as f64 + 1.0)).build();
/// let solutions = solve_sequence(
///     [7, 15, 31].map(rope),
///     |coarse, fine: &Rope| {
///         let [from, to] = [coarse.z.len(), fine.shape().n()].map(|k| Grid::new(1, k));
///         to.interpolate(&coarse.z, from, 0.0)
///     },
///     &Options::default(),
/// )?;
/// assert!(solutions.iter().all(|solution| solution.is_solved()));
/// assert!((solutions[2].z[15] + 0.5).abs() < 1e-12); // the middle lies on the floor
/// # Ok(())
/// # }
/// ```
pub fn solve_sequence<M: Model>(
    models: impl IntoIterator<Item = Result<M, ModelError>>,
    prolong: impl FnMut(&Solution, &M) -> Result<Vec<f64>, ModelError>,
    options: &Options,
) -> Result<Vec<Solution>, ModelError> {
    solve_sequence_with(models, prolong, |_| Solver::new(options.clone()))
}

/// [`solve_sequence`] with a solver of its own for each model, such as one with a
/// [`MultigridCg`](crate::MultigridCg) of its grid.
///
/// # Errors
/// As [`solve_sequence`], and the first error of `solver`.
pub fn solve_sequence_with<M: Model>(
    models: impl IntoIterator<Item = Result<M, ModelError>>,
    mut prolong: impl FnMut(&Solution, &M) -> Result<Vec<f64>, ModelError>,
    mut solver: impl FnMut(&M) -> Result<Solver, ModelError>,
) -> Result<Vec<Solution>, ModelError> {
    let mut solutions: Vec<Solution> = Vec::new();
    for model in models {
        let model = model?;
        let start = match solutions.last().filter(|coarse| coarse.is_solved()) {
            Some(coarse) => Some(prolong(coarse, &model)?),
            None => None,
        };
        let solution = solve_one(solver(&model)?, &mut AdProblem::new(&model)?, start)?;
        drop(model);
        solutions.push(apart(solution));
    }
    Ok(solutions)
}

/// Not generic: compiled here, not with every model.
fn solve_one(
    mut solver: Solver,
    problem: &mut dyn Problem,
    start: Option<Vec<f64>>,
) -> Result<Solution, ModelError> {
    let work = solver.prepare(problem, start.as_deref())?;
    drop(start);
    solver.go(problem, work, None);
    Ok(solver.solution)
}

/// Copies made when a problem and its solver are gone stand where these were: lists of the workspace would
/// keep memory around them from being given back.
fn apart(mut solution: Solution) -> Solution {
    solution.z = solution.z.clone();
    solution.f = solution.f.clone();
    solution
}

#[cfg(test)]
#[path = "sequence_tests.rs"]
mod tests;
