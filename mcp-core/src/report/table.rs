//! [`IterationTable`]: the iterations of a solve as lines of text, while it runs.

use super::IterationRecord;
use super::format::{clean, scientific};
use crate::solver::{Direction, Iteration, Monitor};
use std::io::{self, Write};
use std::ops::ControlFlow;

/// A [`Monitor`] that writes one line for each iterate, in columns like PATH's, a header first.
///
/// ```text
///  iter   func    jac    residual     natural        step  type  stage         act  worst
///     0      1      1  1.2649e+01  6.0000e+00           -  S     newton          2  profit[3]
///     1      2      2  8.4815e-01  4.1012e-01  1.0000e+00  F     newton          1  price
/// ```
///
/// | column | meaning |
/// | --- | --- |
/// | `iter` | number of the iterate; 0 is the start |
/// | `func`, `jac` | evaluations of `F` alone and of `J` so far |
/// | `residual` | `‖Φ(z)‖₂`, the 2-norm of the Fischer–Burmeister vector |
/// | `natural` | `max |mid(z−l, F, z−u)|`, in the units of the model |
/// | `step` | step length |
/// | `type` | where the step came from: [`Direction::letter`] |
/// | `stage` | the stage of the method: [`Stage`](crate::Stage) |
/// | `act` | variables taken to be at a bound |
/// | `worst` | equation of the largest natural residual |
///
/// A failing writer ends the solve as [`Interrupted`](crate::Status::Interrupted);
/// [`finish`](Self::finish) returns its error.
///
/// ```
/// use mcp_core::{AdProblem, IterationTable, Options, Solver};
/// # use mcp_core::{Equation, Model, Reader, Real, Scalar, Shape, Variable};
/// # struct Root(Shape);
/// # impl Model for Root {
/// #     fn shape(&self) -> &Shape { &self.0 }
/// #     fn row<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
/// #         read.var(0).powi(2) - 2.0
/// #     }
/// # }
/// # let shape = Shape::builder().variable(Variable::new("x").lower(0.0).start(1.0))
/// #     .equation(Equation::new("f").complements("x")).build()?;
/// let mut problem = AdProblem::new(Root(shape))?; // x² − 2 ⟂ x >= 0
/// let mut table = IterationTable::new(Vec::new());
/// Solver::new(Options::default())?.solve_monitored(&mut problem, None, &mut table)?;
/// let text = String::from_utf8(table.finish()?)?;
/// assert!(text.starts_with(" iter   func    jac    residual"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct IterationTable<W> {
    out: W,
    /// Whether the header stands.
    begun: bool,
    error: Option<io::Error>,
}

impl<W: Write> IterationTable<W> {
    /// A table that is written to `out`; `&mut W` is a writer too.
    pub fn new(out: W) -> Self {
        IterationTable { out, begun: false, error: None }
    }

    /// Flushes the writer and gives it back.
    ///
    /// # Errors
    /// The first error of the writer, from whichever line.
    pub fn finish(mut self) -> io::Result<W> {
        if let Some(error) = self.error {
            return Err(error);
        }
        self.out.flush()?;
        Ok(self.out)
    }

    fn line(&mut self, record: &IterationRecord) -> io::Result<()> {
        if !self.begun {
            let [iter, func, jac, residual, natural, step, kind, stage, active, worst] =
                IterationRecord::COLUMNS;
            writeln!(
                self.out,
                "{iter:>5}  {func:>5}  {jac:>5}  {residual:>10}  {natural:>10}  {step:>10}  \
                 {kind:<4}  {stage:<10}  {active:>5}  {worst}"
            )?;
            self.begun = true;
        }
        let step = match record.direction {
            Direction::Start => "-".to_owned(),
            _ => scientific(record.step),
        };
        let line = format!(
            "{:>5}  {:>5}  {:>5}  {:>10}  {:>10}  {step:>10}  {:<4}  {:<10}  {:>5}  {}",
            record.iter,
            record.func,
            record.jac,
            scientific(record.residual),
            scientific(record.natural),
            record.direction.letter(),
            record.stage,
            record.active,
            clean(&record.worst),
        );
        writeln!(self.out, "{}", line.trim_end())
    }
}

impl<W: Write> Monitor for IterationTable<W> {
    fn iteration(&mut self, iteration: &Iteration<'_>) -> ControlFlow<()> {
        if self.error.is_none() {
            self.error = self.line(&IterationRecord::new(iteration)).err();
        }
        if self.error.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{Broken, cubic, linear};
    use super::*;
    use crate::solver::{Method, Options, Solver, Status};

    #[test]
    fn a_solve_is_shown_line_by_line_with_the_worst_equation() {
        let mut table = IterationTable::new(Vec::new());
        let mut solver = Solver::new(Options::new(Method::NewtonFb)).unwrap();
        solver.solve_monitored(&mut cubic("a"), None, &mut table).unwrap();
        let text = String::from_utf8(table.finish().unwrap()).unwrap();
        let mut lines = text.lines();
        assert_eq!(
            lines.next(),
            Some(
                " iter   func    jac    residual     natural        step  type  stage         act  \
                 worst"
            )
        );
        assert_eq!(
            lines.next(),
            Some(
                "    0      1      1  1.3071e+01  7.0000e+00           -  S     newton          0  \
                 f[a]"
            )
        );
        let second = lines.next().unwrap();
        assert!(second.starts_with("    1"), "{second}");
        assert!(second.contains("  1.0000e+00  F     newton"), "{second}");
    }

    #[test]
    fn a_failing_writer_ends_the_solve_and_its_error_is_returned() {
        for lines in 0..2 {
            let mut table = IterationTable::new(Broken { lines });
            let mut solver = Solver::new(Options::default()).unwrap();
            let solution = solver.solve_monitored(&mut cubic("a"), None, &mut table).unwrap();
            assert_eq!(solution.status, Status::Interrupted);
            assert_eq!(table.finish().unwrap_err().to_string(), "disk full");
        }
    }

    #[test]
    fn an_error_while_flushing_is_returned() {
        let table = IterationTable::new(Broken { lines: 0 });
        assert_eq!(table.finish().unwrap_err().to_string(), "disk full");
    }

    #[test]
    fn a_solved_start_writes_one_line() {
        let mut table = IterationTable::new(Vec::new());
        let mut solver = Solver::new(Options::default()).unwrap();
        let mut problem = linear(2);
        let solved = solver.solve(&mut problem).unwrap().z.clone();
        solver.solve_monitored(&mut problem, Some(&solved), &mut table).unwrap();
        let text = String::from_utf8(table.finish().unwrap()).unwrap();
        assert_eq!(text.lines().count(), 2, "{text}");
        assert!(text.lines().last().unwrap().trim_start().starts_with('0'), "{text}");
    }
}
