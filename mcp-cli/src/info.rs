//! `mcp info`: what a model is, in numbers.

use crate::args::Info;
use crate::error::CliError;
use crate::exit::Outcome;
use crate::files;
use mcp_core::{AdProblem, BoundKind, OperationCounts, Problem};
use std::io::Write;

/// Carries out `mcp info`.
pub(crate) fn run(args: &Info, out: &mut impl Write) -> Result<Outcome, CliError> {
    let model = files::model_with_warnings(&args.model)?;
    let problem = AdProblem::new(&model).map_err(CliError::problem(&args.model))?;
    let (shape, pattern) = (Problem::shape(&problem), problem.pattern());
    let n = shape.n();
    let mut line = |label: &str, text: String| writeln!(out, "{label:<18}  {text}");
    line("model", files::name(&args.model))?;
    line("variables", n.to_string())?;
    line("constraints", model.constraints().to_string())?;
    line("definitions", shape.definition_count().to_string())?;
    let kinds = [
        (BoundKind::Free, "free"),
        (BoundKind::Lower, "lower"),
        (BoundKind::Upper, "upper"),
        (BoundKind::Boxed, "both"),
        (BoundKind::Fixed, "fixed"),
    ];
    let kinds = kinds.map(|(kind, word)| {
        format!("{word} {}", (0..n).filter(|&i| shape.bounds().kind(i) == kind).count())
    });
    line("bounds", kinds.join(", "))?;
    let nnz = pattern.nnz();
    let share = if n == 0 { 0.0 } else { 100.0 * nnz as f64 / (n as f64 * n as f64) };
    let per_row = if n == 0 { 0.0 } else { nnz as f64 / n as f64 };
    line("nonzeros of J", format!("{nnz} ({share:.3} %), {per_row:.1} a row"))?;
    line("operations of F", counts(problem.operations()))?;
    let of_j = problem.jacobian_operations().map_err(CliError::problem(&args.model))?;
    line("operations of J", of_j.to_string())?;
    Ok(Outcome::Good)
}

/// All operations, and by kind.
fn counts(operations: OperationCounts) -> String {
    let kinds = [
        (operations.additions, "addition"),
        (operations.multiplications, "multiplication"),
        (operations.divisions, "division"),
        (operations.functions, "function"),
        (operations.selections, "selection"),
    ];
    let kinds: Vec<String> = kinds
        .iter()
        .filter(|kind| kind.0 > 0)
        .map(|(count, kind)| format!("{count} {kind}{}", if *count == 1 { "" } else { "s" }))
        .collect();
    let total = operations.total();
    if kinds.is_empty() { total.to_string() } else { format!("{total}: {}", kinds.join(", ")) }
}
