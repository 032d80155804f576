//! Whole solves of small problems, workspace reused: `cargo bench --bench small`.
//!
//! Ids are `problem/method`; each solve starts from the problem's first published start unless said
//! otherwise and must end with an accepted certificate. `many_10000` is 10 000 problems of four firms
//! with other costs each: one after another, and as a batch over all threads.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use mcp_core::{
    AdProblem, Method, ModelError, Options, Problem, Real, Scalar, Solver, mcp, mcp_fn, solve,
    solve_batch, sum,
};
use std::hint::black_box;

/// Kojima & Shindo (1986).
#[mcp_fn(lower = 0.0, start = 1.0)]
fn kojima_shindo<D: Scalar>([x1, x2, x3, x4]: [Real<D>; 4]) -> [Real<D>; 4] {
    [
        3.0 * x1 * x1 + 2.0 * x1 * x2 + 2.0 * x2 * x2 + x3 + 3.0 * x4 - 6.0,
        2.0 * x1 * x1 + x1 + x2 * x2 + 10.0 * x3 + 2.0 * x4 - 2.0,
        3.0 * x1 * x1 + x1 * x2 + 2.0 * x2 * x2 + 2.0 * x3 + 9.0 * x4 - 9.0,
        x1 * x1 + 3.0 * x2 * x2 + 2.0 * x3 + 3.0 * x4 - 3.0,
    ]
}

/// Cournot equilibrium of ten firms, data after Harker's ten-firm example.
#[mcp_fn(lower = 1e-6, start = 10.0)]
fn cournot_10<D: Scalar>(q: [Real<D>; 10]) -> [Real<D>; 10] {
    let c = [5.0, 3.0, 8.0, 5.0, 1.0, 3.0, 7.0, 4.0, 6.0, 3.0];
    let l = [10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0];
    let beta = [1.2, 1.0, 0.9, 0.6, 1.5, 1.0, 0.7, 1.1, 0.95, 0.75];
    let gamma = 1.2;
    let total = sum(q, |q| q);
    let price = (5000.0 / total).pow(1.0 / gamma);
    std::array::from_fn(|i| {
        c[i] + (l[i] * q[i]).pow(1.0 / beta[i]) - price + price * q[i] / (gamma * total)
    })
}

fn bench(
    criterion: &mut Criterion,
    name: &str,
    problem: &mut dyn Problem,
) -> Result<(), ModelError> {
    // Lemke's method is for affine problems.
    for method in Method::ALL.into_iter().filter(|&method| method != Method::Lemke) {
        let options = Options::new(method).with(|o| {
            o.tol = Some(1e-10);
            o.max_iterations = 1000;
        });
        let mut solver = Solver::new(options)?;
        let solution = solver.solve(problem)?;
        assert!(solution.is_solved(), "{name}/{method}: {}", solution.status);
        criterion.bench_function(&format!("{name}/{method}"), |bencher| {
            bencher.iter(|| black_box(solver.solve(problem).map(|s| s.z[0])));
        });
    }
    Ok(())
}

mcp! {
    /// Firms with other costs than their neighbours' face the price `10 − Σ q`.
    model Firms {
        data { firms: usize, cost[firms]: f64 }
        var q[i in firms] >= 0.0;
        def total: sum(firms, |i| q[i]);
        eq profit[i in firms]: cost[i] + q[i] * q[i] + total + q[i] >= 10.0 complements q[i];
    }
}

fn many(criterion: &mut Criterion) {
    const COUNT: usize = 10_000;
    let firms = |k: usize| {
        let cost: Vec<f64> = (0..4).map(|i| ((k * 7 + i * 13) % 101) as f64 / 10.0).collect();
        Firms::builder().firms(4).cost(cost).build().expect("well formed")
    };
    let models: Vec<Firms> = (0..COUNT).map(firms).collect();
    let options = Options::default();
    let mut group = criterion.benchmark_group("many_10000");
    group.throughput(Throughput::Elements(COUNT as u64)).sample_size(10);
    group.bench_function("one_by_one", |bencher| {
        bencher.iter(|| models.iter().filter(|firms| solve(*firms, &options).is_ok()).count());
    });
    group.bench_function("batch", |bencher| {
        bencher.iter(|| solve_batch(&models, &options).iter().filter(|s| s.is_ok()).count());
    });
}

fn small(criterion: &mut Criterion) {
    let run = |criterion: &mut Criterion| -> Result<(), ModelError> {
        bench(criterion, "kojima_shindo", &mut AdProblem::new(KojimaShindo::new()?)?)?;
        bench(criterion, "cournot_10", &mut AdProblem::new(Cournot10::new()?)?)
    };
    run(criterion).expect("the problems are well formed");
}

criterion_group!(benches, small, many);
criterion_main!(benches);
