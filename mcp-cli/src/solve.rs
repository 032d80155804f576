//! `mcp solve`: model statement, iterations, report, files.

use crate::args::{Files, Log, Settings, Solve};
use crate::document;
use crate::error::CliError;
use crate::exit::Outcome;
use crate::files;
use crate::history::History;
use crate::output::warn;
use crate::plot::{self, PlotError};
use crate::start::{self, StartError};
use crate::style::Style;
use mcp_cli::nl::NlModel;
use mcp_core::{
    AdProblem, Infeasible, Iteration, IterationTable, Monitor, Problem, Report, Solution, Solver,
    Statement, infeasible,
};
use std::io::Write;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

/// Carries out `mcp solve`.
pub(crate) fn run(args: &Solve, out: &mut impl Write) -> Result<Outcome, CliError> {
    files::are_distinct([args.model.as_path()], args.files.outputs())?;
    let model = files::model_with_warnings(&args.model)?;
    let how = (&args.settings, &args.files, args.log);
    let answer = solve(&model, &args.model, how, out)?;
    answer.write_files(&model, &args.settings, &args.files)?;
    Ok(Outcome::of(answer.report.solution().is_solved()))
}

/// How a solve ended.
pub(crate) struct Answer {
    /// Of the model.
    name: String,
    /// The report, not solved included.
    pub(crate) report: Report,
    /// If it is not solved: a proof that it has no solution, where there is one.
    pub(crate) infeasible: Option<Infeasible>,
    /// Time of the solve.
    pub(crate) seconds: f64,
    /// All iterates, if a picture is wanted.
    history: Option<History>,
}

impl Answer {
    /// What happened, and where if that is known: proof, fault or diagnosis.
    pub(crate) fn reason(&self) -> String {
        let Solution { status, diagnosis, shape, .. } = self.report.solution();
        let found = match (&self.infeasible, self.report.fault(), diagnosis) {
            (Some(proof), _, _) => format!("; {proof}"),
            (None, Some(fault), _) => format!(": {fault}"),
            (None, None, Some(diagnosis)) => format!(": {}", diagnosis.describe(shape)),
            (None, None, None) => String::new(),
        };
        format!("{}{found}", status.meaning())
    }

    /// Writes all files but `.sol`: each is tried, whatever becomes of the others.
    ///
    /// # Errors
    /// The first that cannot be written.
    pub(crate) fn write_files(
        &self,
        model: &NlModel,
        settings: &Settings,
        wanted: &Files,
    ) -> Result<(), CliError> {
        let json = wanted
            .json
            .as_ref()
            .map_or(Ok(()), |path| files::write(path, |out| document::write(self, model, out)));
        let csv = wanted
            .csv
            .as_ref()
            .map_or(Ok(()), |path| files::write(path, |out| self.report.write_csv(out)));
        let plot = wanted.plot.as_ref().map_or(Ok(()), |path| self.draw(path, settings));
        json.and(csv).and(plot)
    }

    /// Draws the iterates; if there is nothing to see, says so and leaves the file alone.
    fn draw(&self, path: &Path, settings: &Settings) -> Result<(), CliError> {
        let moments = self.history.as_ref().map_or(&[][..], History::moments);
        let title = format!("{}: {}", self.name, self.report.solution().status.name());
        match plot::svg(moments, &title, settings.tol.0) {
            Ok(picture) => files::write(path, |out| out.write_all(picture.as_bytes())),
            Err(nothing @ PlotError::Nothing) => {
                warn(files::failed(path)(nothing));
                Ok(())
            }
            Err(error) => Err(files::failed(path)(error)),
        }
    }
}

/// Solves a model read from `path` and prints what `log` says.
pub(crate) fn solve(
    model: &NlModel,
    path: &Path,
    (settings, wanted, log): (&Settings, &Files, Log),
    out: &mut impl Write,
) -> Result<Answer, CliError> {
    let name = files::name(path);
    let mut problem = AdProblem::new(model).map_err(CliError::problem(path))?;
    set_start(&mut problem, wanted.start.as_deref())?;
    if log == Log::Iterations {
        writeln!(out, "{}", Statement::new(&mut problem).named(&name))?;
        out.flush()?;
    }
    let mut solver = Solver::new(settings.options()).map_err(CliError::problem(path))?;
    let table = (log == Log::Iterations).then_some(&mut *out).map(IterationTable::new);
    let mut watch = Watch { table, history: wanted.plot.as_ref().map(|_| History::default()) };
    let began = Instant::now();
    let solution = solver.solve_monitored(&mut problem, None, &mut watch);
    let seconds = began.elapsed().as_secs_f64();
    let solution = solution.map_err(CliError::problem(path))?;
    let Watch { table, history } = watch;
    if let Some(table) = table {
        writeln!(table.finish()?)?;
    }
    let report = Report::new(&mut problem, solution).map_err(CliError::problem(path))?.named(&name);
    let margin = settings.tol.0.unwrap_or(0.0);
    let infeasible = if solution.is_solved() { None } else { infeasible(&problem, margin) };
    let answer = Answer { name, report, infeasible, seconds, history };
    if log != Log::None {
        Style::of_stdout().report(&answer.report.to_string(), solution.is_solved(), out)?;
        if let Some(proof) = &answer.infeasible {
            writeln!(out, "\nno solution, {proof}")?;
        }
    }
    Ok(answer)
}

/// Starts from the levels in a file, moved into the bounds, and auxiliary variables where their
/// equations then hold.
pub(crate) fn set_start(
    problem: &mut AdProblem<&NlModel>,
    file: Option<&Path>,
) -> Result<(), CliError> {
    let Some(path) = file else { return Ok(()) };
    let failed =
        |reason: StartError| CliError::Start { path: path.to_owned(), reason: Box::new(reason) };
    let levels = start::read(path, Problem::shape(problem)).map_err(failed)?;
    let set = problem.set_start(&levels).and_then(|()| {
        let start = problem.model().with_auxiliaries(Problem::shape(problem).start());
        problem.set_start(&start)
    });
    set.map_err(|reason| failed(reason.into()))
}

/// Shows every iterate to whoever wants to see it.
struct Watch<W> {
    table: Option<IterationTable<W>>,
    history: Option<History>,
}

impl<W: Write> Monitor for Watch<W> {
    fn iteration(&mut self, iteration: &Iteration<'_>) -> ControlFlow<()> {
        if let Some(history) = &mut self.history {
            history.iteration(iteration)?;
        }
        self.table.as_mut().map_or(ControlFlow::Continue(()), |table| table.iteration(iteration))
    }
}
