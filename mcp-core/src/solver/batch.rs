//! Many problems at once, over the threads of the current [`rayon`] pool.
//!
//! Every thread takes the next item that nobody has taken and keeps its own workspace for all of
//! them, so that memory does not grow with the number of items. No solve is split, and what a solve
//! returns does not depend on the solves before it: the answers are those of one solve after another,
//! bit for bit, in the order of the items.

use super::{Options, Solution, Solver};
use crate::error::ModelError;
use crate::model::Model;
use crate::problem::AdProblem;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Solves every model from its own start, with one [`Solver`] a thread. Feature `rayon`.
///
/// ```
/// use mcp_core::{Options, mcp, solve_batch};
///
/// mcp! {
///     model Market {
///         data { demand: f64 }
///         var p >= 0.0;
///         eq excess: p + p * p - demand complements p;
///     }
/// }
/// # fn main() -> Result<(), mcp_core::ModelError> {
/// let market = |demand: f64| Market::builder().demand(demand).build();
/// let markets = [market(2.0)?, market(6.0)?, market(12.0)?];
/// let solutions = solve_batch(&markets, &Options::default());
/// for (solution, price) in solutions.into_iter().zip([1.0, 2.0, 3.0]) {
///     assert!((solution?.z[0] - price).abs() < 1e-9);
/// }
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// One for each model, as [`solve`](crate::solve); a model that is wrong does not stop the others.
pub fn solve_batch<M: Model + Sync>(
    models: &[M],
    options: &Options,
) -> Vec<Result<Solution, ModelError>> {
    batch(
        models,
        || Solver::new(options.clone()),
        |solver, model| {
            let solver = solver.as_mut().map_err(|error| error.clone())?;
            solver.solve(&mut AdProblem::new(model)?).cloned()
        },
    )
}

/// What `work` returns for every item, in their order. `workspace` is called once a thread, before its
/// first item; the results must not depend on what an earlier item left there. Feature `rayon`.
///
/// For problems that differ in their parameters only, let the workspace hold a problem, whose
/// pattern is then found once a thread:
///
/// ```
/// use mcp_core::{AdProblem, ModelError, Options, Solver, batch, mcp};
///
/// mcp! {
///     model Market {
///         data { }
///         param demand = 2.0;
///         var p >= 0.0;
///         eq excess: p + p * p - demand complements p;
///     }
/// }
/// # fn main() -> Result<(), ModelError> {
/// let model = Market::builder().build()?;
/// let prices = batch(
///     &[2.0, 6.0, 12.0],
///     || Ok((Solver::new(Options::default())?, AdProblem::new(&model)?)),
///     |workspace, &demand| {
///         let (solver, problem) = workspace.as_mut().map_err(|error| ModelError::clone(error))?;
///         problem.set_parameter("demand", &[demand])?;
///         Ok(solver.solve(problem)?.z[0])
///     },
/// );
/// let prices: Vec<f64> = prices.into_iter().collect::<Result<_, ModelError>>()?;
/// assert!((prices[2] - 3.0).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
pub fn batch<T: Sync, S, R: Send>(
    items: &[T],
    workspace: impl Fn() -> S + Sync,
    work: impl Fn(&mut S, &T) -> R + Sync,
) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let shares = rayon::broadcast(|_| {
        let (mut own, mut share) = (None, Vec::new());
        loop {
            let k = next.fetch_add(1, Relaxed);
            let Some(item) = items.get(k) else { return share };
            share.push((k, work(own.get_or_insert_with(&workspace), item)));
        }
    });
    let mut results: Vec<(usize, R)> = shares.into_iter().flatten().collect();
    results.sort_unstable_by_key(|(k, _)| *k);
    results.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mcp;
    use crate::solver::{Method, solve};
    use std::thread::{ThreadId, current};

    mcp! {
        /// Solves of many lengths, and some that fail.
        model Market {
            data { from: f64, cost: f64 }
            var x >= -10.0 start from;
            var p >= 0.0 start 1.0;
            eq quantity: x * x - p - 1.0            complements x;
            eq profit: (cost + p).ln() + x - 1.0    complements p;
        }
    }

    fn markets() -> Vec<Market> {
        (0..500)
            .map(|k| f64::from(k % 100))
            .map(|k| Market::builder().from(0.1 * k - 5.0).cost(0.02 * k - 0.2).build().unwrap())
            .collect()
    }

    fn pool(threads: usize) -> rayon::ThreadPool {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap()
    }

    #[test]
    fn a_batch_returns_the_bits_of_one_solve_after_another() {
        let models = markets();
        for method in [Method::Robust, Method::NewtonFb] {
            let options = Options::new(method).with(|o| o.max_iterations = 6);
            let alone: Vec<_> = models.iter().map(|m| solve(m, &options).unwrap()).collect();
            assert!(
                alone.iter().any(Solution::is_solved) && !alone.iter().all(Solution::is_solved)
            );
            for threads in [1, 2, 5] {
                let together = pool(threads).install(|| solve_batch(&models, &options));
                for (solution, alone) in together.into_iter().zip(&alone) {
                    let solution = solution.unwrap();
                    let bits = |z: &[f64]| z.iter().map(|z| z.to_bits()).collect::<Vec<_>>();
                    assert_eq!(bits(&solution.z), bits(&alone.z));
                    assert_eq!((solution.status, solution.stats), (alone.status, alone.stats));
                }
            }
        }
    }

    #[test]
    fn every_thread_has_one_workspace() {
        let threads: Vec<ThreadId> = pool(3).install(|| {
            batch(
                &[(); 10_000],
                || current().id(),
                |owner, ()| {
                    assert_eq!(*owner, current().id());
                    *owner
                },
            )
        });
        assert_eq!(threads.len(), 10_000);
        let made = AtomicUsize::new(0);
        let order = pool(3).install(|| {
            let items: Vec<usize> = (0..1000).collect();
            batch(&items, || made.fetch_add(1, Relaxed), |_, &k| k)
        });
        assert!(made.into_inner() <= 3);
        assert!(order.into_iter().eq(0..1000));
    }

    #[test]
    fn wrong_options_are_told_for_every_model_and_no_model_is_no_answer() {
        let wrong = Options::default().with(|o| o.tol_relative = f64::NAN);
        let told = solve_batch(&markets()[..2], &wrong);
        assert_eq!(told.len(), 2);
        assert!(told.iter().all(|told| matches!(told, Err(ModelError::Option { .. }))));
        assert!(solve_batch::<Market>(&[], &Options::default()).is_empty());
    }
}
