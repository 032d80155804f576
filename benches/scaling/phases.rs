//! Where the time of one problem goes: `cargo bench --bench scaling -- phases spring 300`, and what `F + J`
//! costs by `F`: `-- phases derivatives 1000`.

use crate::models::{Film, Membrane, Spring, Squares};
use mcp_core::linalg::{FaerCholesky, FaerSparseLu, LinearSolver};
use mcp_core::{AdProblem, Grid, Model, MultigridCg, Problem, examine};
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

/// Repetitions of short phases; the fastest counts.
const REPETITIONS: usize = 7;

pub(crate) fn print(kind: &str, k: usize) -> Result<(), Box<dyn Error>> {
    match kind {
        "membrane" => of(&Membrane::on(k)?, k),
        "spring" => of(&Spring::on(k)?, k),
        "derivatives" => {
            derivatives("no nonlinear read", &Membrane::on(k)?)?;
            derivatives("one", &Spring::on(k)?)?;
            derivatives("five, cheap", &Squares::on(k)?)?;
            derivatives("five, with roots", &Film::on(k)?)
        }
        _ => Err(format!("`{kind}` is none of `membrane`, `spring`, `derivatives`").into()),
    }
}

/// `F + J` by `F` for rows that read their neighbours on a grid.
fn derivatives<M: Model>(rows: &str, model: &M) -> Result<(), Box<dyn Error>> {
    let (seconds, problem) = timed(|| AdProblem::new(model));
    let mut problem = problem?;
    let z: Vec<f64> = (0..problem.shape().n()).map(|j| 0.3 + 0.01 * (j % 7) as f64).collect();
    let (mut f, mut jac) = (vec![0.0; z.len()], vec![0.0; problem.pattern().nnz()]);
    let residual = fastest(|| problem.evaluate(black_box(&z), Some(&mut f), None));
    let both = fastest(|| problem.evaluate(black_box(&z), Some(&mut f), Some(&mut jac)));
    let each = |seconds: f64| seconds / z.len() as f64 * 1e9;
    println!(
        "{rows:>18}: new {seconds:.3} s, F {:.1} ns a row, F + J {:.1} ns: {:.2} F",
        each(residual),
        each(both),
        both / residual
    );
    Ok(())
}

fn of<M: Model>(model: &M, k: usize) -> Result<(), Box<dyn Error>> {
    let (pattern, problem) = timed(|| AdProblem::new(model));
    let mut problem = problem?;
    let n = problem.shape().n();
    let z = problem.shape().start().to_vec();
    let (mut f, mut jac) = (vec![0.0; n], vec![0.0; problem.pattern().nnz()]);
    let residual = fastest(|| problem.evaluate(black_box(&z), Some(&mut f), None));
    let both = fastest(|| problem.evaluate(black_box(&z), Some(&mut f), Some(&mut jac)));
    let certificate = fastest(|| {
        let _ = black_box(examine(&mut problem, &z));
    });
    println!("n {n}: pattern {pattern:.4} s, certificate {certificate:.4} s");
    println!("  F {residual:.5} s, F + J {both:.5} s: {:.2} F", both / residual);
    let solvers: [Box<dyn LinearSolver>; 3] = [
        Box::new(FaerSparseLu::new()),
        Box::new(FaerCholesky::new()),
        Box::new(MultigridCg::new(Grid::square(k))),
    ];
    for mut linear in solvers {
        let with_diagonal = problem.pattern().with_diagonal();
        let (symbolic, analysed) = timed(|| linear.analyse(with_diagonal.pattern()));
        analysed?;
        let (first, factored) = timed(|| linear.factor(&jac));
        factored?;
        let (again, factored) = timed(|| linear.factor(&jac));
        factored?;
        let (solve, ()) = timed(|| linear.solve(&mut f.clone()));
        println!(
            "  {:<22} symbolic {symbolic:.4} s, factor {first:.4} s, again {again:.4} s, solve {solve:.4} s",
            linear.name()
        );
    }
    Ok(())
}

fn timed<T>(run: impl FnOnce() -> T) -> (f64, T) {
    let began = Instant::now();
    let result = run();
    (began.elapsed().as_secs_f64(), result)
}

fn fastest(mut run: impl FnMut()) -> f64 {
    (0..REPETITIONS).map(|_| timed(&mut run).0).fold(f64::INFINITY, f64::min)
}
