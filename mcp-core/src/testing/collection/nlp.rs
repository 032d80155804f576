//! Karush–Kuhn–Tucker systems `∇f(x) − g'(x)ᵀ λ ⟂ x`, `g(x) >= 0 ⟂ λ >= 0` of nonlinear and linear
//! programs; multipliers start at 0.

use super::super::affine::Affine;
use super::super::kkt::RosenSuzuki;
use super::Instance;
use super::archive::RANDOM;
use crate::error::ModelError;
use crate::scalar::{Real, Scalar};
use crate::{mcp, mcp_fn};

const FREE: f64 = f64::NEG_INFINITY;
const INF: f64 = f64::INFINITY;

/// Data of Colville's problem 1: `c`, `d`, `C`, `A`, `b`.
const LINEAR: [f64; 5] = [-15.0, -27.0, -36.0, -18.0, -12.0];
const CUBIC: [f64; 5] = [4.0, 8.0, 10.0, 6.0, 2.0];
const QUADRATIC: [[f64; 5]; 5] = [
    [30.0, -20.0, -10.0, 32.0, -10.0],
    [-20.0, 39.0, -6.0, -31.0, 32.0],
    [-10.0, -6.0, 10.0, -6.0, -10.0],
    [32.0, -31.0, -6.0, 39.0, -20.0],
    [-10.0, 32.0, -10.0, -20.0, 30.0],
];
const A: [[f64; 5]; 10] = [
    [-16.0, 2.0, 0.0, 1.0, 0.0],
    [0.0, -2.0, 0.0, 0.4, 2.0],
    [-3.5, 0.0, 2.0, 0.0, 0.0],
    [0.0, -2.0, 0.0, -4.0, -1.0],
    [0.0, -9.0, -2.0, 1.0, -2.8],
    [2.0, 0.0, -4.0, 0.0, 0.0],
    [-1.0, -1.0, -1.0, -1.0, -1.0],
    [-1.0, -2.0, -3.0, -2.0, -1.0],
    [1.0, 2.0, 3.0, 4.0, 5.0],
    [1.0, 1.0, 1.0, 1.0, 1.0],
];
const B: [f64; 10] = [-40.0, -2.0, -0.25, -4.0, -4.0, -1.0, -40.0, -60.0, 5.0, 1.0];

mcp! {
    /// `min e·x + Σ d_j x_j³ + x·C x` under `A x >= b`, `x >= 0`.
    model Colville {
        data {
            columns: 5, rows: 10, e[columns]: f64, d[columns]: f64, c[columns, columns]: f64,
            a[rows, columns]: f64, b[rows]: f64,
        }
        var x[j in columns] >= 0.0;
        var lambda[i in rows] >= 0.0;
        eq gradient[j in columns]: e[j] + 3.0 * d[j] * x[j].powi(2) + 2.0 * sum(columns, |k| c[j, k] * x[k])
            - sum(rows, |i| a[i, j] * lambda[i])                            complements x[j];
        eq feasible[i in rows]: sum(columns, |j| a[i, j] * x[j]) - b[i]     complements lambda[i];
    }
}

mcp! {
    /// Its dual as a program: `min −b·x + y·C y + 2 Σ d_j y_j³` under
    /// `2 C y + 3 d y² + e − Aᵀ x >= 0`, `x, y >= 0`.
    model ColvilleDual {
        data {
            columns: 5, rows: 10, e[columns]: f64, d[columns]: f64, c[columns, columns]: f64,
            a[rows, columns]: f64, b[rows]: f64,
        }
        var x[i in rows] >= 0.0;
        var y[j in columns] >= 0.0;
        var lambda[j in columns] >= 0.0;
        eq by_x[i in rows]: -b[i] + sum(columns, |j| a[i, j] * lambda[j])            complements x[i];
        eq by_y[j in columns]: 2.0 * sum(columns, |k| c[j, k] * y[k]) + 6.0 * d[j] * y[j].powi(2)
            - 2.0 * sum(columns, |k| c[j, k] * lambda[k]) - 6.0 * d[j] * y[j] * lambda[j]  complements y[j];
        eq feasible[j in columns]: 2.0 * sum(columns, |k| c[k, j] * y[k]) + 3.0 * d[j] * y[j].powi(2) + e[j]
            - sum(rows, |i| a[i, j] * x[i])                                          complements lambda[j];
    }
}

/// Problem 44 of Hock & Schittkowski: a nonconvex quadratic objective, six linear constraints.
#[mcp_fn(lower = 0.0)]
fn hs44<D: Scalar>([a, b, c, d, l1, l2, l3, l4, l5, l6]: [Real<D>; 10]) -> [Real<D>; 10] {
    [
        1 - c + d - (-l1 - 4 * l2 - 3 * l3),
        -1 + c - d - (-2 * l1 - l2 - 4 * l3),
        -1 - a + b - (-2 * l4 - l5 - l6),
        a - b - (-l4 - 2 * l5 - l6),
        8 - a - 2 * b,
        12 - 4 * a - b,
        12 - 3 * a - 4 * b,
        8 - 2 * c - d,
        8 - c - 2 * d,
        5 - c - d,
    ]
}

/// Problem 100 of Hock & Schittkowski: seven free variables, four constraints.
#[mcp_fn(
    lower = [FREE, FREE, FREE, FREE, FREE, FREE, FREE, 0.0, 0.0, 0.0, 0.0],
    start = [1.0, 2.0, 0.0, 4.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0],
)]
fn hs100<D: Scalar>([a, b, c, d, e, g, h, l1, l2, l3, l4]: [Real<D>; 11]) -> [Real<D>; 11] {
    [
        2 * (a - 10) - (-4 * a * l1 - 7 * l2 - 23 * l3 + (3 * b - 8 * a) * l4),
        10 * (b - 12) - (-12 * b.powi(3) * l1 - 3 * l2 - 2 * b * l3 + (3 * a - 2 * b) * l4),
        4 * c.powi(3) - (-l1 - 20 * c * l2 - 4 * c * l4),
        6 * (d - 11) - (-8 * d * l1 - l2),
        60 * e.powi(5) - (-5 * l1 + l2),
        14 * g - 4 * h - 10 - (-12 * g * l3 - 5 * l4),
        4 * h.powi(3) - 4 * g - 8 - (8 * l3 + 11 * l4),
        127 - 2 * a * a - 3 * b.powi(4) - c - 4 * d * d - 5 * e,
        282 - 7 * a - 3 * b - 10 * c * c - d + e,
        196 - 23 * a - b * b - 6 * g * g + 8 * h,
        -4 * a * a - b * b + 3 * a * b - 2 * c * c - 5 * g + 11 * h,
    ]
}

/// Problem 15 of Hock & Schittkowski: Rosenbrock's function, `x1 <= ½`.
#[mcp_fn(lower = [FREE, FREE, 0.0, 0.0], upper = [0.5, INF, INF, INF], start = [-2.0, 1.0, 0.0, 0.0])]
fn hs15<D: Scalar>([x, y, l1, l2]: [Real<D>; 4]) -> [Real<D>; 4] {
    [
        -400 * x * (y - x * x) - 2 * (1 - x) - (y * l1 + l2),
        200 * (y - x * x) - (x * l1 + 2 * y * l2),
        x * y - 1,
        x + y * y,
    ]
}

/// Problem 13 of Hock & Schittkowski: at the minimum (1, 0) no multiplier exists.
#[mcp_fn(lower = 0.0)]
fn hs13<D: Scalar>([x, y, l]: [Real<D>; 3]) -> [Real<D>; 3] {
    [2 * (x - 2) + 3 * (1 - x).powi(2) * l, 2 * y + l, (1 - x).powi(3) - y]
}

/// `min c·x` under `A x >= b`, `x >= 0` with its dual: `c − Aᵀ y ⟂ x`, `A x − b ⟂ y`.
fn linear_program(n: usize, m: usize) -> Result<Instance, ModelError> {
    let name = format!("lp-{n}x{m}");
    let get = |what| RANDOM.get(&format!("{name}/{what}"));
    let (a, b, c) = (get("a"), get("b"), get("c"));
    let matrix = |i: usize, j: usize| match (i < n, j < n) {
        (true, false) => -a[(j - n) * n + i],
        (false, true) => a[(i - n) * n + j],
        _ => 0.0,
    };
    let q = c.into_iter().chain(b.iter().map(|b| -b)).collect();
    let solution = get("z");
    let source = "random, with a manufactured solution";
    Ok(Instance::new(name, source, Affine::new(0, q, matrix)?).solved_by(solution))
}

/// Linear-quadratic control with Euler steps `Δt = 1/T`: `x' = x/2 + u`, `|u| <= 2`, `x(0) = 1`,
/// cost `½ ∫ (x − sin 6t)² + u²/1000 dt`; states and costates are free.
fn optimal_control(steps: usize) -> Result<Instance, ModelError> {
    let n = 3 * steps;
    let dt = 1.0 / steps as f64;
    let (mut rows, mut q) = (vec![Vec::new(); n], vec![0.0; n]);
    let growth = -(1.0 + dt * 0.5);
    for k in 0..steps {
        let (x, u, p) = (k, steps + k, 2 * steps + k);
        rows[x] = vec![(x, dt), (p, 1.0)];
        q[x] = -dt * (6.0 * k as f64 * dt).sin();
        if k + 1 < steps {
            rows[x].push((p + 1, growth));
        }
        rows[u] = vec![(u, 1e-3 * dt), (p, -dt)];
        rows[p] = vec![(x, 1.0), (u, -dt)];
        if k > 0 {
            rows[p].push((x - 1, growth));
        } else {
            q[p] = -1.0;
        }
    }
    let upper: Vec<f64> =
        (0..n).map(|i| if (steps..2 * steps).contains(&i) { 2.0 } else { INF }).collect();
    let lower: Vec<f64> = upper.iter().map(|u| -u).collect();
    let model = Affine::boxed((&lower, &upper), &vec![0.0; n], q, rows)?;
    Ok(Instance::new("opt-cont-like", "test of this collection", model))
}

fn colville() -> Result<Vec<Instance>, ModelError> {
    let primal = Colville::builder().e(LINEAR).d(CUBIC).c(QUADRATIC).a(A).b(B).build()?;
    let with_multipliers = |x: [f64; 5]| [&x[..], &[0.0; 10]].concat();
    let starts = [[0.0, 0.0, 0.0, 0.0, 1.0], [1.0; 5], [10.0; 5], [0.0; 5]].map(with_multipliers);
    let source = "Colville (1968); Hock & Schittkowski (1981), problem 86; MCPLIB";
    let primal = Instance::new("colvnlp", source, primal).at_starts(&starts);

    let dual = ColvilleDual::builder().e(LINEAR).d(CUBIC).c(QUADRATIC).a(A).b(B).build()?;
    let with_multipliers = |x: [f64; 15]| [&x[..], &[0.0; 5]].concat();
    let mut published = [1e-3; 15];
    published[6] = 60.0;
    let starts = [published, [1.0; 15], [0.0; 15]].map(with_multipliers);
    let source = "Colville (1968); Hock & Schittkowski (1981), problem 117; MCPLIB";
    let dual = Instance::new("colvdual", source, dual).at_starts(&starts);
    Ok([primal, dual].concat())
}

const HS: &str = "Hock & Schittkowski (1981)";

pub(super) fn instances() -> Result<Vec<Instance>, ModelError> {
    let others = vec![
        Instance::new("hs43", HS, RosenSuzuki::new()?)
            .starting_at([0.0; 7])
            .solved_by([0.0, 1.0, 2.0, -1.0, 1.0, 0.0, 2.0]),
        Instance::new("hs44", HS, Hs44::new()?)
            .solved_by([0.0, 3.0, 0.0, 4.0, 0.0, 0.0, 1.25, 0.0, 1.5, 0.0]),
        Instance::new("hs100", HS, Hs100::new()?),
        Instance::new("hs15", HS, Hs15::new()?).solved_by([0.5, 2.0, 700.0, 0.0]),
        Instance::new("hs13-noKKT", HS, Hs13::new()?).unsolvable(),
        linear_program(10, 6)?,
        linear_program(30, 20)?,
        optimal_control(30)?,
    ];
    Ok([colville()?, others].concat())
}
