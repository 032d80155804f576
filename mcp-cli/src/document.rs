//! The JSON object of `--json`.

use crate::solve::Answer;
use mcp_cli::nl::NlModel;
use mcp_core::ReportRow;
use mcp_core::report::Number;
use serde::Serialize;
use serde_json::Value;
use std::io::Write;

/// What `--json` writes. A number that is not finite is the string `"inf"`, `"-inf"` or `"NaN"`.
#[derive(Serialize)]
struct Document {
    status: &'static str,
    /// Levels of the file's variables, in its order.
    z: Vec<Number>,
    /// `F` of the equations paired with them.
    f: Vec<Number>,
    natural_residual: Number,
    relative_residual: Number,
    iterations: usize,
    residual_evaluations: usize,
    jacobian_evaluations: usize,
    factorisations: usize,
    seconds: f64,
    variables: Vec<Variable>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    advice: Option<&'static str>,
}

#[derive(Serialize)]
struct Variable {
    name: String,
    lower: Number,
    level: Number,
    upper: Number,
    marginal: Option<Number>,
    state: Value,
    equation: Option<String>,
}

/// Writes the object: `status, z, f, natural_residual, relative_residual, iterations,
/// residual_evaluations, jacobian_evaluations, factorisations, seconds, variables`, and for a solve
/// that failed `reason, advice`. All lists are of the file's variables, in its order.
pub(crate) fn write(
    answer: &Answer,
    model: &NlModel,
    out: &mut impl Write,
) -> Result<(), serde_json::Error> {
    let report = &answer.report;
    let solution = report.solution();
    let (certificate, stats) = (&solution.certificate, &solution.stats);
    let failed = !solution.is_solved();
    let numbers = |list: &[f64]| list.iter().copied().map(Number).collect();
    let document = Document {
        status: solution.status.name(),
        z: numbers(model.file_levels(&solution.z)),
        f: numbers(model.file_levels(&solution.f)),
        natural_residual: Number(certificate.natural_residual),
        relative_residual: Number(certificate.relative_residual),
        iterations: stats.iterations,
        residual_evaluations: stats.residual_evaluations,
        jacobian_evaluations: stats.jacobian_evaluations,
        factorisations: stats.factorisations,
        seconds: answer.seconds,
        variables: report.rows().take(model.variables()).map(variable).collect::<Result<_, _>>()?,
        reason: failed.then(|| answer.reason()),
        advice: failed.then(|| solution.status.advice()),
    };
    serde_json::to_writer_pretty(&mut *out, &document)?;
    writeln!(out).map_err(serde_json::Error::io)
}

fn variable(row: ReportRow) -> Result<Variable, serde_json::Error> {
    Ok(Variable {
        name: row.variable,
        lower: Number(row.lower),
        level: Number(row.level),
        upper: Number(row.upper),
        marginal: row.marginal.map(Number),
        state: serde_json::to_value(row.state)?,
        equation: row.equation,
    })
}
