//! Profiles over a collection: the share of problems solved within a cost.

use crate::error::ModelError;
use crate::solver::{Method, Options, Solver};
use crate::testing::collection::Instance;
use crate::testing::judge;

/// The corners of a step function: after `(x, share)`, the share is that much.
pub type Steps = Vec<(f64, f64)>;

/// For each method the share of the problems that it solves within `2ˣ` times the cost of the best of
/// all methods ([DM02](crate#references)). `costs[m][p]` is the cost of method `m` on problem `p`,
/// `None` where it does not solve it; costs are at least 1.
///
/// ```
/// use mcp_core::accuracy::performance_profile;
/// let profiles = performance_profile(&[vec![Some(2.0), Some(8.0)], vec![Some(4.0), None]]);
/// assert_eq!(profiles[0], [(0.0, 0.5), (0.0, 1.0)]); // the best on both
/// assert_eq!(profiles[1], [(1.0, 0.5)]); // twice as much on one
/// ```
pub fn performance_profile(costs: &[Vec<Option<f64>>]) -> Vec<Steps> {
    let best = |p: usize| {
        let known = costs.iter().filter_map(|costs| costs.get(p).copied().flatten());
        known.fold(f64::INFINITY, f64::min)
    };
    let relative = |costs: &Vec<Option<f64>>| {
        let solved = costs.iter().enumerate().filter_map(|(p, cost)| Some((p, (*cost)?)));
        steps(solved.map(|(p, cost)| (cost / best(p)).log2()).collect(), costs.len())
    };
    costs.iter().map(relative).collect()
}

/// For each method the share of the problems that it solves within a cost of `x`: the data profile of
/// [MW09](crate#references), with costs in evaluations instead of simplex gradients.
pub fn data_profile(costs: &[Vec<Option<f64>>]) -> Vec<Steps> {
    let absolute =
        |costs: &Vec<Option<f64>>| steps(costs.iter().copied().flatten().collect(), costs.len());
    costs.iter().map(absolute).collect()
}

/// Evaluations of `F` and of `J` that a method takes on each instance it solves, by the word of
/// [`judge`](crate::testing::judge()). Classical methods get 300 iterations.
///
/// # Errors
/// None in practice: the problems are well formed.
pub fn evaluations(method: Method, instances: &[Instance]) -> Result<Vec<Option<f64>>, ModelError> {
    let options = Options::new(method).with(|o| {
        if Method::CLASSICAL.contains(&method) {
            o.max_iterations = 300;
        }
    });
    let mut solver = Solver::new(options)?;
    let mut cost = |instance: &Instance| {
        let solution = solver.solve(&mut *instance.problem()?)?;
        let is_solved =
            instance.solvable && solution.is_solved() && judge(instance, &solution.z)?.accepts();
        let stats = solution.stats;
        let evaluations = stats.residual_evaluations + stats.jacobian_evaluations;
        Ok(is_solved.then_some(evaluations.max(1) as f64))
    };
    instances.iter().map(&mut cost).collect()
}

fn steps(mut xs: Vec<f64>, problems: usize) -> Steps {
    xs.sort_by(f64::total_cmp);
    let share = |k: usize| (k + 1) as f64 / problems as f64;
    xs.into_iter().enumerate().map(|(k, x)| (x, share(k))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_data_profile_ends_at_the_share_that_is_solved() {
        let profiles = data_profile(&[vec![Some(3.0), None, Some(1.0), None]]);
        assert_eq!(profiles, [vec![(1.0, 0.25), (3.0, 0.5)]]);
    }

    #[test]
    fn a_problem_that_nobody_solves_counts_for_everybody() {
        let profiles = performance_profile(&[vec![None, Some(1.0)], vec![None, Some(4.0)]]);
        assert_eq!(profiles, [vec![(0.0, 0.5)], vec![(2.0, 0.5)]]);
    }
}
