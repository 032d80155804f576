//! Where the time of one problem goes: `cargo bench --bench scaling -- phases spring 300`.

use crate::models::{Membrane, Spring};
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
        _ => Err(format!("`{kind}` is neither `membrane` nor `spring`").into()),
    }
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
