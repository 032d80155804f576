//! [`sweep`]: one model, many values of a parameter.

use crate::error::ModelError;
use crate::model::{Family, Model, Shape};
use crate::problem::{AdProblem, Derived, Problem};
use crate::report::State;
use crate::solver::{Options, Solution, Solver};
use std::fmt;

use super::SweepTable;

/// A model solved for every value of a parameter.
///
/// [`of`](Self::of) chooses numbers to look at, as text, CSV or picture. `Display` is the table of all
/// reports of the model without index.
#[derive(Clone, Debug)]
pub struct Sweep {
    /// Name of the parameter.
    pub parameter: String,
    /// One for each value, in their order.
    pub points: Vec<SweepPoint>,
}

/// One solve of a sweep.
#[derive(Clone, Debug)]
pub struct SweepPoint {
    /// Value of the parameter, in its unit.
    pub value: f64,
    /// Where the solve ended; look at its status.
    pub solution: Solution,
    /// Definitions and reports there.
    pub derived: Derived,
    /// Whether the solve began at the last solution; otherwise at the start of the model.
    pub is_warm: bool,
    /// Variables whose state is another than at the last solution.
    pub changes: Vec<StateChange>,
}

/// A variable that came to a bound or left one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StateChange {
    /// The variable.
    pub variable: String,
    /// Where it was.
    pub from: State,
    /// Where it is.
    pub to: State,
}

impl fmt::Display for StateChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.variable, self.to)
    }
}

/// Solves a model for every value of a parameter, with default options, each solve starting from the
/// solution before it: [`sweep_with`].
///
/// ```
/// use mcp_core::{mcp, study::sweep};
/// mcp! {
///     /// A mine with room for 3, and buyers who take 10 − p.
///     model Market {
///         data { }
///         param tax = 0.0;
///         var q in 0.0..=3.0;
///         var p >= 0.0 start 1.0;
///         eq profit: 4.0 + tax - p          complements q;
///         eq market: q >= 10.0 - p          complements p;
///         report revenue: tax * q;
///     }
/// }
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let sweep = sweep(&Market::builder().build()?, "tax", &[0.0, 2.0, 4.0, 7.0])?;
/// let revenue = sweep.of(&["revenue"])?;
/// assert!((revenue.columns[0].values[2] - 8.0).abs() < 1e-7);
/// assert_eq!(sweep.points[2].changes[0].to_string(), "q interior");
/// println!("{revenue}");
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// As [`sweep_with`].
pub fn sweep<M: Model>(model: &M, parameter: &str, values: &[f64]) -> Result<Sweep, ModelError> {
    sweep_with(model, parameter, values, &Options::default(), &mut |_| {})
}

/// Solves a model for every value of a parameter and shows every point to `seen`, for a progress bar
/// or a log.
///
/// `parameter` is a parameter, an element such as `tax[iron]`, or a family, all of whose elements take
/// the value. A solve that fails from the last solution is tried again from the start of the model; one
/// that fails from there too is a point whose status says so, and the sweep goes on.
///
/// # Errors
/// [`ModelError::UnknownName`] for the parameter and [`ModelError::ParameterNotFinite`] for a value,
/// before the first solve, and as [`solve`](crate::solve).
pub fn sweep_with<M: Model>(
    model: &M,
    parameter: &str,
    values: &[f64],
    options: &Options,
    seen: &mut dyn FnMut(&SweepPoint),
) -> Result<Sweep, ModelError> {
    run(&mut AdProblem::new(model)?, parameter, values, options, seen)
}

/// A problem whose parameters can be changed; not generic, so that sweeps are compiled once.
trait Parametric: Problem {
    fn fill(&mut self, parameter: &str, value: f64) -> Result<(), ModelError>;
    fn as_problem(&mut self) -> &mut dyn Problem;
}

impl<M: Model> Parametric for AdProblem<M> {
    fn fill(&mut self, parameter: &str, value: f64) -> Result<(), ModelError> {
        self.fill_parameter(parameter, value)
    }
    fn as_problem(&mut self) -> &mut dyn Problem {
        self
    }
}

fn run(
    problem: &mut dyn Parametric,
    parameter: &str,
    values: &[f64],
    options: &Options,
    seen: &mut dyn FnMut(&SweepPoint),
) -> Result<Sweep, ModelError> {
    // The last solve is no time to learn that a value is none; a sweep of none has a parameter too.
    let mut shape = Shape::clone(problem.shape());
    values.iter().chain([&0.0]).try_for_each(|&value| shape.fill_parameter(parameter, value))?;
    let mut solver = Solver::new(options.clone())?;
    let mut points: Vec<SweepPoint> = Vec::with_capacity(values.len());
    let mut last: Option<usize> = None;
    for &value in values {
        problem.fill(parameter, value)?;
        let before = last.map(|k| &points[k].solution);
        let (solution, is_warm) = solve_near(&mut solver, problem.as_problem(), before)?;
        let derived = problem.derived(&solution.z);
        let changes = match before {
            Some(before) if solution.is_solved() => changes(before, &solution),
            _ => Vec::new(),
        };
        if solution.is_solved() {
            last = Some(points.len());
        }
        points.push(SweepPoint { value, solution, derived, is_warm, changes });
        seen(&points[points.len() - 1]);
    }
    Ok(Sweep { parameter: parameter.to_owned(), points })
}

/// A solution, from the last one if that leads to one, and whether it does.
fn solve_near(
    solver: &mut Solver,
    problem: &mut dyn Problem,
    last: Option<&Solution>,
) -> Result<(Solution, bool), ModelError> {
    if let Some(last) = last {
        let warm = solver.solve_from(problem, &last.z)?;
        if warm.is_solved() {
            return Ok((warm.clone(), true));
        }
    }
    Ok((solver.solve(problem)?.clone(), false))
}

fn changes(before: &Solution, after: &Solution) -> Vec<StateChange> {
    let state = |solution: &Solution, i: usize| {
        State::new(solution.shape.bounds(), i, solution.z[i], solution.f[i])
    };
    let change = |i: usize| {
        let (from, to) = (state(before, i), state(after, i));
        (from != to).then(|| StateChange { variable: after.shape.variable_name(i), from, to })
    };
    (0..after.z.len()).filter_map(change).collect()
}

impl Sweep {
    /// The numbers of these names at every point: variables, definitions and reports, such as
    /// `p[iron]`, or all of a family, `p`.
    ///
    /// # Errors
    /// [`ModelError::UnknownName`] with the nearest name.
    pub fn of(&self, names: &[&str]) -> Result<SweepTable, ModelError> {
        SweepTable::new(self, names)
    }

    /// Whether every point is a solution.
    pub fn is_solved(&self) -> bool {
        self.points.iter().all(|point| point.solution.is_solved())
    }
}

impl fmt::Display for Sweep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(first) = self.points.first() else {
            return writeln!(f, "{}: no values", self.parameter);
        };
        let reports = first.solution.shape.reports().iter();
        let names: Vec<&str> =
            reports.filter(|family| family.sets().is_empty()).map(Family::name).collect();
        self.of(&names).map_err(|_| fmt::Error)?.fmt(f)
    }
}

#[cfg(test)]
#[path = "sweep_tests.rs"]
mod tests;
