//! A hard case: a problem, a start, and the right answer or the right failure word.

use crate::common::solve_from;
use mcp_core::{Method, Options, Problem, Solution, Status};

/// Whether a point is a solution.
pub(crate) type IsSolution = Box<dyn Fn(&[f64]) -> bool>;

/// What a solver must answer.
pub(crate) enum Expect {
    /// One of these points, `|z_i − z*_i| <= within · max(1, |z*_i|)` in every coordinate.
    Near { solutions: Vec<Vec<f64>>, within: f64 },
    /// Any point of a set of solutions.
    Member(IsSolution),
    /// No solution, or none that could be shown to be one: any of these statuses.
    Fails(&'static [Status]),
}

/// One problem with one start.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) problem: Box<dyn Problem>,
    pub(crate) start: Vec<f64>,
    pub(crate) expect: Expect,
}

impl Case {
    pub(crate) fn new(
        name: impl Into<String>,
        problem: impl Problem + 'static,
        start: &[f64],
        expect: Expect,
    ) -> Self {
        Case { name: name.into(), problem: Box::new(problem), start: start.to_vec(), expect }
    }

    /// One solution, known to a part in 10⁸.
    pub(crate) fn at(
        name: impl Into<String>,
        problem: impl Problem + 'static,
        start: &[f64],
        solution: &[f64],
    ) -> Self {
        let expect = Expect::Near { solutions: vec![solution.to_vec()], within: 1e-8 };
        Case::new(name, problem, start, expect)
    }

    /// What the method makes of it, with default options.
    pub(crate) fn solve(&mut self, method: Method) -> Solution {
        solve_from(&mut *self.problem, &self.start, &Options::new(method))
    }

    /// Whether the answer is the right one.
    pub(crate) fn is_met_by(&self, solution: &Solution) -> bool {
        match &self.expect {
            Expect::Fails(statuses) => statuses.contains(&solution.status),
            _ => solution.is_solved() && self.holds_at(&solution.z, 0.0),
        }
    }

    /// Whether the answer claims a solution where there is none.
    pub(crate) fn is_false_claim(&self, solution: &Solution) -> bool {
        solution.is_solved() && !self.holds_at(&solution.z, ABSOLUTE)
    }

    fn holds_at(&self, z: &[f64], at_least: f64) -> bool {
        let near = |solution: &Vec<f64>, within: f64| {
            let close = |(z, s): (&f64, &f64)| (z - s).abs() <= within * s.abs().max(1.0);
            z.iter().zip(solution).all(close)
        };
        match &self.expect {
            Expect::Near { solutions, within } => {
                solutions.iter().any(|s| near(s, within.max(at_least)))
            }
            Expect::Member(is_solution) => is_solution(z),
            Expect::Fails(_) => false,
        }
    }

    /// Expectation in one word or two, for tables.
    pub(crate) fn expectation(&self) -> String {
        match &self.expect {
            Expect::Near { within, .. } => format!("solved to {within:.0e}"),
            Expect::Member(_) => "solved".to_owned(),
            Expect::Fails(statuses) => statuses.first().map_or("", |s| s.name()).to_owned(),
        }
    }
}

/// The classical methods end at an absolute residual: their points are a little less accurate.
const ABSOLUTE: f64 = 1e-6;
