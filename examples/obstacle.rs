//! # A membrane over a ball
//!
//! A membrane under the tension 1 N/m is fixed on the sides of the square `(−2, 2)²` [m] and lies
//! on a ball of radius 1 m, whose upper half is `ψ(r) = √(1 − r²)` (continued along its tangent
//! where `r > 0.9`, which touches nothing). Where the membrane is free it is harmonic; where it
//! lies on the ball, the ball presses it up:
//!
//! ```text
//! −Δu >= 0   ⟂   u >= ψ
//! ```
//!
//! On a grid of `n × n` inner nodes at the distance `h = 4/(n + 1)`, five points make `−h² Δu`,
//! which is the force [N] of the ball at a node:
//!
//! ```text
//! 4 u_ij − u_(i−1)j − u_(i+1)j − u_i(j−1) − u_i(j+1) >= 0   ⟂   u_ij >= ψ_ij
//! ```
//!
//! Source: `obstacle.c` of chapter 12 of E. Bueler, `PETSc for Partial Differential Equations`,
//! SIAM 2021, where the height on the sides is that of a solution in closed form on a disk of
//! radius 2:
//!
//! ```text
//! u = ψ(r) for r <= a,   u = −A ln(r/2) for r >= a,   A = a²/√(1 − a²),   a² ln(2/a) = 1 − a²
//! ```
//!
//! The last equation makes value and slope continuous; `a = 0.697965148223374`. Expected: the error
//! is below `0.3 h²`, the membrane touches a disk of radius `a` to a mesh width, and the ball
//! carries `2π A` newtons to `h²`. `tests/gallery/obstacle.rs` finds `a` by bisection and the
//! heights on the grid by relaxation.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::{
    AdProblem, Grid, Model, ModelError, Options, Problem, Solution, Solver, mcp, solve_sequence,
};
use std::error::Error;
use std::f64::consts::PI;

mcp! {
    /// Heights of a membrane on a square grid.
    pub(crate) model Membrane {
        data {
            nodes: usize,
            /// height of the obstacle [m]
            psi[nodes, nodes]: f64,
            /// height on each of the four sides [m]
            side[nodes]: f64,
        }
        /// height [m]
        var u[i in nodes, j in nodes] >= psi[i, j] start psi[i, j].max(0.0);

        eq force[i in nodes, j in nodes]:
            4.0 * u[i, j] >= u.at(i - 1, j).or(side[j]) + u.at(i + 1, j).or(side[j])
                + u.at(i, j - 1).or(side[i]) + u.at(i, j + 1).or(side[i])
            complements u[i, j];
    }
}

/// Radius of the disk where the membrane touches the ball [m].
pub(crate) const RADIUS: f64 = 0.697_965_148_223_374;

/// The obstacle at the distance `r` from the middle [m].
pub(crate) fn psi(r: f64) -> f64 {
    let edge = 0.9_f64;
    let height = (1.0 - r.min(edge).powi(2)).sqrt();
    height - (r - edge).max(0.0) * edge / height
}

/// `A = a²/√(1 − a²)` [m].
fn amplitude() -> f64 {
    RADIUS * RADIUS / (1.0 - RADIUS * RADIUS).sqrt()
}

/// The height in closed form [m].
pub(crate) fn exact(r: f64) -> f64 {
    if r <= RADIUS { psi(r) } else { -amplitude() * (r / 2.0).ln() }
}

/// Coordinate of a node, counted from 0, of `n` inner nodes [m].
pub(crate) fn coordinate(i: usize, n: usize) -> f64 {
    -2.0 + 4.0 * (i as f64 + 1.0) / (n as f64 + 1.0)
}

impl Membrane {
    /// The ball on a grid of `n × n` inner nodes.
    pub(crate) fn over_ball(n: usize) -> Result<Self, ModelError> {
        let at = |k: usize| coordinate(k, n);
        let radius = move |k: usize| at(k / n).hypot(at(k % n));
        Membrane::builder()
            .nodes(n)
            .psi((0..n * n).map(|k| psi(radius(k))).collect::<Vec<_>>())
            .side((0..n).map(|k| exact(at(k).hypot(2.0))).collect::<Vec<_>>())
            .build()
    }
}

/// What the ball carries in closed form [N].
fn carried() -> f64 {
    2.0 * PI * amplitude()
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("variables  nonzeros  iterations  touch  radius [m]  force [N]  error [m]");
    for n in [19, 39, 79] {
        let model = Membrane::over_ball(n)?;
        let mut problem = AdProblem::new(&model)?;
        let solution = Solver::new(Options::default())?.solve(&mut problem)?.clone().solved()?;
        let view = model.view(&solution)?;

        let h = 4.0 / (n as f64 + 1.0);
        let touch = touching(&view).iter().filter(|touches| **touches).count();
        let radius = h * (touch as f64 / PI).sqrt();
        let force: f64 = view.u.marginals().iter().sum();
        let error = error(&view, n);
        let (nonzeros, iterations) = (problem.pattern().nnz(), solution.stats.iterations);
        println!(
            "{:>9}{nonzeros:>10}{iterations:>12}{touch:>7}{radius:>12.4}{force:>11.4}{error:>11.6}",
            n * n
        );
        assert!((radius - RADIUS).abs() < h);
        assert!((force - carried()).abs() < h * h);
        assert!(error < 0.3 * h * h);
        if n == 79 {
            println!("{:>9}{RADIUS:>41.4}{:>11.4}   in closed form\n", "", carried());
            print_picture(&view, n);
        }
    }
    print_nested()
}

/// The same grids once more, each from the solution on the grid before it, interpolated: the number of
/// iterations does not grow with the grid.
fn print_nested() -> Result<(), Box<dyn Error>> {
    let finer = |coarse: &Solution, fine: &Membrane| {
        let [from, to] = [coarse.z.len(), fine.shape().n()].map(|n| Grid::square(n.isqrt()));
        to.interpolate(&coarse.z, from, 0.0)
    };
    let models = [19, 39, 79, 159].map(Membrane::over_ball);
    println!("\ncoarse to fine\nvariables  iterations");
    for solution in solve_sequence(models, finer, &Options::default())? {
        let solution = solution.solved()?;
        println!("{:>9}{:>12}", solution.z.len(), solution.stats.iterations);
        assert!(solution.stats.iterations <= 10);
    }
    Ok(())
}

/// Whether the membrane touches the obstacle, node by node: it is pressed up.
pub(crate) fn touching(view: &MembraneView) -> Vec<bool> {
    view.u.marginals().iter().map(|force| *force > 1e-9).collect()
}

/// Largest distance from the height in closed form [m].
fn error(view: &MembraneView, n: usize) -> f64 {
    let distance =
        |(k, u): (usize, &f64)| (u - exact(coordinate(k / n, n).hypot(coordinate(k % n, n)))).abs();
    view.u.values().iter().enumerate().map(distance).fold(0.0, f64::max)
}

/// Every fourth row and second column: `#` where the membrane touches the ball, else its height.
fn print_picture(view: &MembraneView, n: usize) {
    let touches = touching(view);
    let letter = |k: usize| match view.u.values()[k] {
        _ if touches[k] => '#',
        u if u > 0.5 => '+',
        u if u > 0.4 => '=',
        u if u > 0.3 => '-',
        u if u > 0.2 => ':',
        u if u > 0.1 => '.',
        _ => ' ',
    };
    for i in (7..n - 4).step_by(4) {
        let row: String = (1..n).step_by(2).map(|j| letter(i * n + j)).collect();
        println!("{}", row.trim_end());
    }
}
