//! What a Jacobian costs and how accurate it is, by source.

use super::case::Case;
use super::reference::worse;
use super::source::Source;
use super::timing::{Budget, Timing};
use super::{AccuracyError, DoubleDouble};

/// One source on one problem, at its solution.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivativeRun {
    /// The problem.
    pub case: String,
    /// Variables.
    pub n: usize,
    /// Where the Jacobian comes from.
    pub source: Source,
    /// `max_ij |J_ij − J*_ij| / max_k |J*_ik|` with `J*` in double-double.
    pub error: f64,
    /// One Jacobian.
    pub jacobian: Timing,
    /// One `F`.
    pub residual: Timing,
}

/// Every source that `case` has, at its solution. `J*` costs `⌈n/8⌉` evaluations of all rows in jets
/// over double-double.
///
/// # Errors
/// As [`Case::problem`] and [`Case::solution`].
pub fn derivatives(case: &Case, budget: Budget) -> Result<Vec<DerivativeRun>, AccuracyError> {
    let z = case.solution()?;
    let exact = case.exact_jacobian(&z)?;
    let sources = Source::ALL.into_iter().filter(|&s| s != Source::ByHand || case.has_by_hand());
    sources.map(|source| of_source(case, source, (&z, &exact), budget)).collect()
}

fn of_source(
    case: &Case,
    source: Source,
    (z, exact): (&[f64], &[DoubleDouble]),
    budget: Budget,
) -> Result<DerivativeRun, AccuracyError> {
    let mut problem = case.problem(source)?;
    let (mut f, mut jac) = (vec![0.0; z.len()], vec![0.0; exact.len()]);
    problem.evaluate(z, Some(&mut f), Some(&mut jac));
    let mut largest = vec![0.0_f64; z.len()];
    for (k, i, _) in problem.pattern().entries() {
        largest[i] = largest[i].max(exact[k].to_f64().abs());
    }
    let error = |(k, i, _): (usize, usize, usize)| match largest[i] {
        0.0 => jac[k].abs(),
        largest => (exact[k] - jac[k].into()).to_f64().abs() / largest,
    };
    let error = problem.pattern().entries().map(error).fold(0.0, worse);
    Ok(DerivativeRun {
        case: case.name.clone(),
        n: z.len(),
        source,
        error,
        jacobian: Timing::measure(budget, || problem.evaluate(z, None, Some(&mut jac))),
        residual: Timing::measure(budget, || problem.evaluate(z, Some(&mut f), None)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::problems;
    use std::time::Duration;

    #[test]
    fn exact_sources_are_exact_and_differences_lose_a_half_and_a_third_of_the_digits() {
        let budget = Budget { runs: 3, time: Duration::ZERO };
        let all = derivatives(&problems::walras(10).unwrap(), budget).unwrap();
        for run in all {
            let limits = match run.source {
                Source::Jet | Source::NumDual | Source::ByHand => 0.0..1e-14,
                Source::OneSided => 1e-10..1e-6,
                Source::Central | Source::BestCentral => 1e-14..1e-8,
            };
            assert!(limits.contains(&run.error), "{run:?}");
        }
    }
}
